// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_MULTIPATCH_H
#define CGAL_QUARTIC_DIFFERENTIALS_MULTIPATCH_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Surface_distance.h>
#include <CGAL/Quartic_differentials/quad_layout.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A surface of tensor-product B-spline patches of degree 3 that meet side to side, without T-junctions.
///
/// Patches, like their sides, run counterclockwise seen from outside: side 0 is v = 0, 1 is u = n_u, 2 is v = n_v and 3
/// is u = 0, where n_u and n_v are the numbers of spans. The knots are 0, 0, 0, 0, 1, 2, .. n-1, n, n, n, n in either
/// direction. Every side is on the boundary, or that of exactly one interface, whose two sides run against one another
/// along the same control points, bit by bit.
struct Multipatch
{
  /// A bicubic tensor product B-spline.
  struct Patch
  {
    std::array<std::size_t, 2> spans;            ///< n_u and n_v, at least 1
    std::vector<Point_3>       control_points;   ///< (n_u + 3) (n_v + 3), u runs faster
    std::vector<std::size_t>   quads;            ///< n_u n_v, u runs faster: the face of the quad mesh on each span
  };
  using Side = Quad_layout::Side;
  using Interface = Quad_layout::Interface;

  std::vector<Patch>     patches;
  std::vector<Interface> interfaces;
  std::vector<Side>      boundary;
};

/// fits splines to a surface, over the patches of the layout of a quad mesh: every quad is one span in u and in v.
///
/// Corners of patches are vertices of the quad mesh. Sides, once for both patches, then the insides are fitted by least
/// squares to 5 x 5 points on every quad, evenly divided and then moved to the nearest point of the surface; on the
/// boundary, to those that divide the way along the surface's boundary evenly.
///
/// \param input the surface
/// \param quads a quad mesh near the surface, as `surface_mesh()` returns it, or any other
/// \throws Unusable_surface_error if `input` is not embedded, or `quads` has a face that is no quad, or a boundary
///         where `input` has none
/// Complexity: O(n log n) for n faces of the input, and O(m log n) for m quads, if those are small against the surface's
///             features.
/// Source: METHOD, "Splines"; least squares by tensor products, Piegl and Tiller 1997, section 9.4.
Multipatch multipatch(const Intrinsic_triangulation& input, const Mesh& quads);

/// checks and returns the first violation as a sentence, or the empty string: the numbers of control points are those of
/// the spans; every side is on one interface or on the boundary; the sides of an interface have the same control
/// points, bit by bit.
/// Complexity: linear.
std::string defect(const Multipatch& m);

/// the control points on a side, along it
std::vector<Point_3> control_points(const Multipatch::Patch& patch, int side);

/// A point of a spline patch, and the derivatives there.
struct Spline_point
{
  Point_3  point;
  Vector_3 along_u, along_v;   ///< the derivatives
};

/// the point at parameters 0 <= u <= n_u, 0 <= v <= n_v. Complexity: constant.
Spline_point evaluate(const Multipatch::Patch& patch, double u, double v);

/// How near splines are to a surface, and how far from folding over, at 4 x 4 points of every span between those that
/// were fitted.
struct Multipatch_quality
{
  Surface_distance distance;                ///< from the splines to the surface
  double           least_sine, mean_sine;   ///< of the angle from u to v, seen along the normal of the surface
};

/// \throws Unusable_surface_error if `input` is not embedded
/// Complexity: as `multipatch()`.
Multipatch_quality multipatch_quality(const Intrinsic_triangulation& input, const Multipatch& m);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_MULTIPATCH_H
