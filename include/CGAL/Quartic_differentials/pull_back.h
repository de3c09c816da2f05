// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PULL_BACK_H
#define CGAL_QUARTIC_DIFFERENTIALS_PULL_BACK_H

#include <CGAL/Quartic_differentials/refined_surface.h>

#include <array>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A polyline of the flat plane on the faces of the input.
struct Pulled_back_arc
{
  /// where the arc begins, meets edges and vertices of the refined surface, bends, and ends, each once. The piece from
  /// points[k] to points[k + 1] is straight and lies in the closed face points[k].face of the input.
  std::vector<Surface_point> points;
  Face                       last_face;       ///< of the refined surface: its closed triangle holds the end
  Transition                 to_last_chart;   ///< from the chart at the start to that of last_face, along the polyline
};

/// draws a polyline of the flat plane on the input: a straight segment becomes a polyline on the input's faces.
///
/// The chart of `start` is continued analytically along the polyline. All decisions are exact, signs of integers; only
/// the coordinates of the result are rounded. Edges of the refined surface inside a face of the input are met as well:
/// the map to the plane is linear on its triangles only, so the arc bends there.
///
/// A line that meets a vertex or runs along edges passes infinitesimally to the right of them: the vertex is on its
/// left, and the face it is in is the one on the right of the edge. At a singularity it therefore turns by 180 degrees
/// counterclockwise round the vertex. Where the polyline begins at a vertex or bends there, and the line of the next
/// segment only touches the face in which the arc is, the arc turns to the segment the short way round the vertex; only
/// at singularities does this matter.
///
/// A line with the boundary on its right runs along it, and past its end where it is still on the surface.
///
/// To go on from the end of an arc, start in `last_face` at `to_last_chart(polyline.back())`.
///
/// \param start a face of `refined.differential`
/// \param polyline grid points, in units of 2^-grid_exponent, in the chart of `start`; successive ones may coincide. If
///        the first was rounded to a place outside `start`, the arc begins where the straight line to it from the first
///        corner of `start` leads.
/// \pre `defect(refined.differential)` is empty, and `polyline` is not
/// \throws Numerical_error if the ends of a segment have coordinates of 2^60 or more in a chart on its way, or
///         the polyline leaves the surface through its boundary
/// Complexity: linear in the edges crossed, and the edges at vertices passed.
/// Source: METHOD, step 7.
Pulled_back_arc pull_back(const Refined_surface& refined, Face start, const std::vector<Grid_vector>& polyline);

/// the grid point nearest to a place in a chart. \param z in units, as `Quartic_differential::chart()` returns it
/// \throws Numerical_error if a coordinate is 2^60 grid units or more
Grid_vector nearest_grid_point(const Quartic_differential& q, std::complex<double> z);

namespace internal {

/// the barycentric coordinates of a grid point in a triangle on the grid, to a few units in the last place
/// \pre the coordinates are below 2^61
std::array<double, 3> barycentric(const std::array<Grid_vector, 3>& corner, Grid_vector z);

} // namespace internal

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_PULL_BACK_H
