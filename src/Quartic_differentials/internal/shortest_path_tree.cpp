// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/shortest_path_tree.h>

#include <functional>
#include <queue>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

Shortest_path_tree shortest_path_tree(const Intrinsic_triangulation& t, const std::vector<double>& lengths, Vertex root,
                                      double radius)
{
  Shortest_path_tree tree;
  tree.distance.assign(t.number_of_vertices(), std::numeric_limits<double>::infinity());
  tree.parent.assign(t.number_of_vertices(), Mesh::null_halfedge());
  using Item = std::pair<double, Vertex>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  tree.distance[root] = 0;
  queue.push({0, root});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > tree.distance[v]) continue;
    tree.order.push_back(v);
    const Halfedge first = t.halfedge_from(v);
    Halfedge h = first;
    do {
      const Vertex w = t.target(h);
      const double through = d + lengths[t.edge(h)];
      if (through < tree.distance[w] && through <= radius) {
        tree.distance[w] = through;
        tree.parent[w] = h;
        queue.push({through, w});
      }
      h = t.next_around_source(h);
    } while (h != first);
  }
  return tree;
}

} } } // namespace CGAL::Quartic_differentials::internal
