// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_POINT_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_POINT_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/aabb_tree.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Finds the point of a surface in space that is nearest to a given one.
class Nearest_point
{
public:
  /// \throws Unusable_surface_error if `t` is not embedded
  /// Complexity: O(n log n)
  explicit Nearest_point(const Intrinsic_triangulation& t) : m_t(t)
  {
    require_embedded(t, "the nearest point of a surface");
    m_tree.insert(t.faces().begin(), t.faces().end(), t.mesh());
    m_tree.build();
  }

  Surface_point operator()(const Point_3& p) const { return in_face(m_tree.closest_point_and_primitive(p)); }
  /// \param hint a point of the surface, in space and in its face: the nearer it is, the faster the search
  Surface_point operator()(const Point_3& p, const Point_3& hint, Face hint_face) const
  { return in_face(m_tree.closest_point_and_primitive(p, {hint, hint_face})); }

private:
  using Tree = Face_tree<Mesh>;

  // in barycentric coordinates; a corner, where the face is so small that no product of lengths is left of it
  Surface_point in_face(const Tree::Point_and_primitive_id& found) const
  {
    const auto& [p, face] = found;
    const auto h = m_t.halfedges(face);
    const auto at = [&](int k) { return m_t.mesh().point(m_t.source(h[k % 3])); };
    const auto normal = CGAL::cross_product(at(1) - at(0), at(2) - at(0));
    Surface_point q{face, {}};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double share = CGAL::cross_product(at(k + 1) - p, at(k + 2) - p) * normal;
      sum += q.barycentric[k] = std::max(share, 0.0);
    }
    if (!(sum > 0)) return {face, {1, 0, 0}};
    for (double& b : q.barycentric) b /= sum;
    return q;
  }

  const Intrinsic_triangulation& m_t;
  Tree                           m_tree;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_NEAREST_POINT_H
