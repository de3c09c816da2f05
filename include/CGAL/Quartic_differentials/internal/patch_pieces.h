// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_PATCH_PIECES_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_PATCH_PIECES_H

#include <CGAL/Quartic_differentials/t_mesh.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// An exact point of a closed face, in the chart with the T-mesh's grid: a corner, a rational point of an edge, or a grid
/// point of the interior.
struct Chart_point
{
  enum class Place { corner, edge, interior };

  Place        place;
  Halfedge     halfedge;                   ///< the corner is source(halfedge); the edge is that of halfedge
  std::int64_t numerator, denominator;     ///< edge: the fraction of the way from source(halfedge) to its target
  Face         face;
  Grid_vector  z;                          ///< interior: in the chart of face
};

/// The part of a face that lies in one patch, or one of several: a convex polygon.
struct Patch_piece
{
  Face                     face;
  std::size_t              patch;
  Transition               to_patch;   ///< from the chart of the face (T-mesh's grid) to [0, width] x [0, height]
  std::vector<Chart_point> corner;     ///< counterclockwise
};

/// cuts every face along the arcs. Which patch a piece belongs to, and where in it, is known exactly from an arc on its
/// boundary; faces without arcs take it from a neighbour. The pieces of a face follow one another.
/// \pre `defect(t, q)` is empty
/// \throws Numerical_error if two arcs place a piece differently
/// Complexity: linear in the faces, O(k log k) in a face with k arcs.
std::vector<Patch_piece> patch_pieces(const T_mesh& t, const Quartic_differential& q);

/// the point of the closed face with these coordinates. \pre the face holds z
Chart_point chart_point(const Quartic_differential& q, Face f, Grid_vector z);

/// where a segment's line, run along in its direction, leaves the segment's face
Chart_point exit_of(const Quartic_differential& q, const Chart_segment& s);

/// the numerator counted from the source of halfedge(edge), so that both faces compute the same numbers from it.
/// \pre the point is on an edge
std::int64_t numerator_along_edge(const Quartic_differential& q, const Chart_point& p);

/// the point in space, on the straight triangle between the vertices' positions; the same from all faces
Point_3 position(const Quartic_differential& q, const Chart_point& p);

} // namespace internal
} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_PATCH_PIECES_H
