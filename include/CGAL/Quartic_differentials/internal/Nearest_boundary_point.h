// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_BOUNDARY_POINT_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_BOUNDARY_POINT_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/aabb_tree.h>

#include <algorithm>
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
  explicit Nearest_boundary_point(const Intrinsic_triangulation& t) : m_t(t)
  {
    std::vector<Edge> edges;
    for (Edge e : t.edges())
      if (t.is_border(e)) edges.push_back(e);
    m_tree.insert(edges.begin(), edges.end(), t.mesh());
    m_tree.build();
  }

  /// on the boundary without rounding. \pre there is a boundary
  Surface_point operator()(const Point_3& p) const
  {
    const auto [q, edge] = m_tree.closest_point_and_primitive(p);
    const Halfedge even = m_t.halfedge(edge), h = m_t.is_border(even) ? m_t.opposite(even) : even;
    const Point_3 &from = m_t.mesh().point(m_t.source(h)), &to = m_t.mesh().point(m_t.target(h));
    const double whole = CGAL::squared_distance(from, to), part = (q - from) * (to - from);
    return on_edge(m_t, h, whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0);
  }

private:
  const Intrinsic_triangulation& m_t;
  Edge_tree<Mesh>                m_tree;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_BOUNDARY_POINT_H
