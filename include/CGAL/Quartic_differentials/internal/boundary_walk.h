// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BOUNDARY_WALK_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BOUNDARY_WALK_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/geodesic_disk.h>

#include <cmath>
#include <complex>
#include <limits>
#include <optional>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A point on a boundary edge: the halfedge in a face, and the fraction of its length from its source.
struct Boundary_place
{
  Halfedge halfedge;   ///< null if the point is not on the boundary
  double   fraction = 0;
};

/// the boundary edge of the point's face on which it lies: where the opposite coordinate is exactly 0
inline Boundary_place boundary_place(const Intrinsic_triangulation& t, const Surface_point& p)
{
  const auto h = t.halfedges(p.face);
  for (int k = 0; k < 3; ++k)
    if (p.barycentric[(k + 2) % 3] == 0 && t.is_border(t.opposite(h[k]))) return {h[k], p.barycentric[(k + 1) % 3]};
  return {Mesh::null_halfedge(), 0};
}

/// the direction of a boundary edge, with the surface on its left, in the unfolded frame of its face
inline std::complex<double> boundary_direction(const Intrinsic_triangulation& t, Halfedge h)
{
  const auto z = t.unfolded(t.face(h));
  const int k = t.corner(h);
  return (z[(k + 1) % 3] - z[k]) / t.length(h);
}

/// slides a point along the boundary, the surface on its left if the distance is positive; `crossing(before, after)` gets
/// every vertex that is passed in the coordinates of the faces at both boundary edges.
/// \pre p is on the boundary
/// \throws Numerical_error after 100,000 vertices
template <class Crossing>
Surface_point slide(const Intrinsic_triangulation& t, const Surface_point& p, double distance, Crossing crossing)
{
  auto [h, fraction] = boundary_place(t, p);
  double at = fraction * t.length(h) + distance;
  for (int n = 0; n < 100000; ++n) {
    if (at < 0) {
      const Halfedge previous = t.previous_on_boundary(h);
      crossing(on_edge(t, h, 0), on_edge(t, previous, 1));
      h = previous;
      at += t.length(h);
    } else if (at > t.length(h)) {
      const Halfedge next = t.next_on_boundary(h);
      crossing(on_edge(t, h, 1), on_edge(t, next, 0));
      at -= t.length(h);
      h = next;
    } else {
      return on_edge(t, h, at / t.length(h));
    }
  }
  throw Numerical_error("a way along the boundary passes more than 100000 vertices");
}

/// the way from one place on the boundary to another with the surface on the left, or infinity if it is longer than
/// `most` or there is none
inline double way_along_boundary(const Intrinsic_triangulation& t, const Boundary_place& from, const Boundary_place& to,
                                 double most)
{
  if (from.halfedge == to.halfedge && from.fraction <= to.fraction)
    return (to.fraction - from.fraction) * t.length(from.halfedge);
  double way = (1 - from.fraction) * t.length(from.halfedge);
  for (Halfedge h = t.next_on_boundary(from.halfedge); way <= most && h != from.halfedge; h = t.next_on_boundary(h)) {
    if (h == to.halfedge) return way + to.fraction * t.length(h);
    way += t.length(h);
  }
  return std::numeric_limits<double>::infinity();
}

/// the straight way to the nearest point of the boundary, in the unfolded frame of the point's face; none if it is
/// longer than `radius`
inline std::optional<std::complex<double>> way_to_boundary(const Intrinsic_triangulation& t, const Surface_point& p,
                                                           double radius)
{
  std::optional<std::complex<double>> shortest;
  explore_geodesic_disk(t, p, radius, [&](const Unfolded_face& f, std::complex<double>, std::complex<double>) {
    const auto h = t.halfedges(t.face(f.halfedge));
    const auto z = f.corners(t);
    for (int k = 0; k < 3; ++k) {
      if (!t.is_border(t.opposite(h[k]))) continue;
      const std::complex<double> way = nearest_on_segment(z[k], z[(k + 1) % 3]);
      if (std::abs(way) <= (shortest ? std::abs(*shortest) : radius)) shortest = way;
    }
  });
  return shortest;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BOUNDARY_WALK_H
