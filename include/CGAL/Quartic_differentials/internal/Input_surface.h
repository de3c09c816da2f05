// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_INPUT_SURFACE_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_INPUT_SURFACE_H

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/internal/Nearest_point.h>
#include <CGAL/Quartic_differentials/internal/Quad_shape.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <complex>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A surface in space with continuous normals: those of faces, averaged at vertices and linear between.
class Input_surface
{
public:
  struct Place
  {
    Surface_point at;
    Point_3       point;
    Vector_3      normal;   ///< a unit vector
  };

  /// \throws Unusable_surface_error if `t` is not embedded
  /// Complexity: O(n log n)
  explicit Input_surface(const Intrinsic_triangulation& t)
    : m_nearest(t), m_t(t), m_normal(t.number_of_vertices(), Vector_3(0, 0, 0))
  {
    for (Face f : t.faces()) {
      const auto h = t.halfedges(f);
      const auto at = [&](int k) { return t.mesh().point(t.source(h[k])); };
      const Vector_3 n = CGAL::cross_product(at(1) - at(0), at(2) - at(0));
      for (Halfedge k : h) m_normal[t.source(k)] += n;
    }
    for (Vector_3& n : m_normal) n = unit(n);
  }

  Place place(const Surface_point& at) const
  {
    Vector_3 normal(0, 0, 0);
    const auto h = m_t.halfedges(at.face);
    for (int k = 0; k < 3; ++k) normal += at.barycentric[k] * m_normal[m_t.source(h[k])];
    return {at, position_on_input(m_t, at), unit(normal)};
  }

  /// the nearest point of the surface
  Place nearest(const Point_3& p) const { return place(m_nearest(p)); }
  /// \param near a place: the nearer it is, the faster the search
  Place nearest(const Point_3& p, const Place& near) const { return place(m_nearest(p, near.point, near.at.face)); }
  /// the place at the end of a straight walk; the boundary reflects
  /// \param displacement in the unfolded frame of the face
  Place walked(const Place& from, std::complex<double> displacement) const
  {
    const auto ignore = [](const Surface_point&, const Surface_point&) {};
    return place(moved_inside(walk(m_t, moved_inside(from.at, inward), displacement, ignore).point, 0));
  }

private:
  const Nearest_point            m_nearest;
  const Intrinsic_triangulation& m_t;
  std::vector<Vector_3>          m_normal;   // by vertex
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_INPUT_SURFACE_H
