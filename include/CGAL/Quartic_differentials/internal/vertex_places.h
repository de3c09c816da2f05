// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_VERTEX_PLACES_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_VERTEX_PLACES_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// a point well inside a face next to v, which does not depend on how halfedges are numbered
Surface_point beside(const Intrinsic_triangulation& t, Vertex v);

/// the corner of its face that has the largest barycentric coordinate
Vertex nearest_corner(const Intrinsic_triangulation& t, const Surface_point& p);

/// visits the vertices in the order of their distance from v along edges (Dijkstra's algorithm), as long as
/// `visit(vertex, distance)` returns true.
template <class Visit>
void visit_nearest_first(const Intrinsic_triangulation& t, Vertex v, Visit visit)
{
  using Item = std::pair<double, Vertex>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::map<Vertex, double> distance{{v, 0.}};
  queue.push({0, v});
  while (!queue.empty()) {
    const auto [d, u] = queue.top();
    queue.pop();
    if (d > distance.at(u)) continue;
    if (!visit(u, d)) return;
    const Halfedge first = t.halfedge_from(u);
    Halfedge h = first;
    do {
      const double through = d + t.length(h);
      const auto [known, is_new] = distance.emplace(t.target(h), through);
      if (is_new || through < known->second) {
        known->second = through;
        queue.push({through, t.target(h)});
      }
      h = t.next_around_source(h);
    } while (h != first);
  }
}

/// Vertices that are near to something already.
class Taken_vertices
{
public:
  explicit Taken_vertices(const Intrinsic_triangulation& t) : m_t(&t), m_taken(t.number_of_vertices(), false) {}
  bool operator[](Vertex v) const { return m_taken[v]; }
  /// marks everything within a distance of v along edges
  void take(Vertex v, double distance);

private:
  const Intrinsic_triangulation* m_t;
  std::vector<char>              m_taken;
};

/// the vertices on the boundary, and those too near to it for a singularity: within 0.03 * sqrt(area) along edges
Taken_vertices near_boundary(const Intrinsic_triangulation& t);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_VERTEX_PLACES_H
