// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/vertex_places.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

// In the face left of the edge to the neighbour of least index.
Surface_point beside(const Intrinsic_triangulation& t, Vertex v)
{
  const Halfedge first = t.halfedge_from(v);
  Halfedge h = first;
  for (Halfedge k = t.next_around_source(first); k != first; k = t.next_around_source(k))
    if (!t.is_border(k) && t.target(k) < t.target(h)) h = k;
  Surface_point p{t.face(h), {0.3, 0.3, 0.3}};
  p.barycentric[t.corner(h)] = 0.4;
  return p;
}

Vertex nearest_corner(const Intrinsic_triangulation& t, const Surface_point& p)
{
  const auto k = std::max_element(p.barycentric.begin(), p.barycentric.end()) - p.barycentric.begin();
  return t.source(t.halfedges(p.face)[k]);
}

void Taken_vertices::take(Vertex v, double distance)
{
  visit_nearest_first(*m_t, v, [&](Vertex u, double d) {
    if (d >= distance && u != v) return false;
    m_taken[u] = true;
    return true;
  });
}

Taken_vertices near_boundary(const Intrinsic_triangulation& t)
{
  const double distance = 0.03 * std::sqrt(t.area());
  Taken_vertices near(t);
  for (const auto& curve : t.boundary_curves())
    for (Halfedge h : curve) near.take(t.source(h), distance);
  return near;
}

} } } // namespace CGAL::Quartic_differentials::internal
