// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_BOUNDARY_POINT_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_BOUNDARY_POINT_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/aabb_tree.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Finds the point of a surface's boundary in space that is nearest to a given one.
class Nearest_boundary_point
{
public:
  /// \pre `t` is embedded
  /// Complexity: linear, and O(n log n) in the boundary edges
  explicit Nearest_boundary_point(const Intrinsic_triangulation& t)
  {
    std::vector<Edge> edges;
    for (Edge e : t.edges())
      if (t.is_border(e)) edges.push_back(e);
    m_tree.insert(edges.begin(), edges.end(), t.mesh());
    m_tree.build();
  }

  /// \pre there is a boundary
  Point_3 operator()(const Point_3& p) const { return m_tree.closest_point(p); }

private:
  Edge_tree<Mesh> m_tree;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_BOUNDARY_POINT_H
