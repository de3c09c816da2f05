// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BOUNDARY_WAYS_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BOUNDARY_WAYS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/Quad_shape.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Ways along the boundary curves of a surface. All points are on the boundary without rounding, see `boundary_place()`.
class Boundary_ways
{
public:
  /// Complexity: linear
  explicit Boundary_ways(const Intrinsic_triangulation& t)
    : m_t(t), m_begin(t.number_of_edges(), 0), m_whole(t.number_of_edges(), 0)
  {
    for (const std::vector<Halfedge>& curve : t.boundary_curves()) {
      double whole = 0;
      for (Halfedge h : curve) {
        m_begin[t.edge(h)] = whole;
        whole += t.length(h);
      }
      for (Halfedge h : curve) m_whole[t.edge(h)] = whole;
    }
  }

  /// the length of the way from one point of a curve on to another, the surface on the left
  double length(const Surface_point& from, const Surface_point& to) const
  {
    const double way = position(to) - position(from);
    return way > 0 ? way : way + m_whole[m_t.edge(boundary_place(m_t, from).halfedge)];
  }

  /// the point a way farther on, or back if it is negative. Complexity: linear in the edges on the way
  Surface_point slid(const Surface_point& p, double way) const
  { return slide(m_t, p, way, [](const Surface_point&, const Surface_point&) {}); }

  /// the direction in which the curve runs, a unit vector. \pre the surface is embedded
  Vector_3 direction(const Surface_point& p) const
  {
    const Halfedge h = boundary_place(m_t, p).halfedge;
    return unit(m_t.mesh().point(m_t.target(h)) - m_t.mesh().point(m_t.source(h)));
  }

private:
  double position(const Surface_point& p) const
  {
    const Boundary_place place = boundary_place(m_t, p);
    return m_begin[m_t.edge(place.halfedge)] + place.fraction * m_t.length(place.halfedge);
  }

  const Intrinsic_triangulation& m_t;
  std::vector<double>            m_begin, m_whole;   // by edge: where it begins on its curve, and the curve's length
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BOUNDARY_WAYS_H
