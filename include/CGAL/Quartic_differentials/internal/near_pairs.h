// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAR_PAIRS_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAR_PAIRS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/geodesic_disk.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// calls `visit(i, k, way)` for every straight line of length up to `radius` from a point i to a point k of a list (so
/// a pair is seen from both of its points); `way` leads from i to k in the unfolded frame of the face of i.
template <class Visit>
void visit_near_pairs(const Intrinsic_triangulation& t, const std::vector<Surface_point>& points, double radius,
                      Visit visit)
{
  std::vector<std::pair<Face, std::size_t>> by_face;
  for (std::size_t i = 0; i < points.size(); ++i) by_face.emplace_back(points[i].face, i);
  std::sort(by_face.begin(), by_face.end());
  std::vector<bool> holds_points(t.number_of_faces());
  for (const Surface_point& p : points) holds_points[p.face.idx()] = true;
  for (std::size_t i = 0; i < points.size(); ++i)
    explore_geodesic_disk(t, points[i], radius, [&](const Unfolded_face& unfolded, std::complex<double> right,
                                                    std::complex<double> left) {
      const Face f = t.face(unfolded.halfedge);
      if (!holds_points[f.idx()]) return;
      for (auto at = std::lower_bound(by_face.begin(), by_face.end(), std::make_pair(f, std::size_t(0)));
           at != by_face.end() && at->first == f; ++at) {
        if (at->second == i) continue;
        const std::complex<double> way = point_in_frame(unfolded.corners(t), points[at->second].barycentric);
        if (right != left && (cross(right, way) < 0 || cross(way, left) < 0)) continue;   // not in sight
        if (std::abs(way) <= radius) visit(i, at->second, way);
      }
    });
}

/// calls `visit(i, k, from, to, way)` for every way along the boundary, with the surface on the left, of length up to
/// `radius` from a corner i of a divisor to a corner k, with their places. Complexity: quadratic in the corners.
template <class Visit>
void visit_near_corners(const Intrinsic_triangulation& t, const Divisor& divisor, double radius, Visit visit)
{
  std::vector<std::pair<std::size_t, Boundary_place>> corners;
  for (std::size_t i = 0; i < divisor.size(); ++i)
    if (divisor[i].on_boundary) corners.emplace_back(i, boundary_place(t, divisor[i].location));
  for (const auto& [i, from] : corners)
    for (const auto& [k, to] : corners) {
      if (i == k) continue;
      const double way = way_along_boundary(t, from, to, radius);
      if (way <= radius) visit(i, k, from, to, way);
    }
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAR_PAIRS_H
