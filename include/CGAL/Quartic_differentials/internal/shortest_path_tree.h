// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SHORTEST_PATH_TREE_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SHORTEST_PATH_TREE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Shortest paths along edges from a vertex to all vertices within a radius.
struct Shortest_path_tree
{
  std::vector<Vertex>   order;      ///< the vertices within the radius, nearest first: the root is the first
  std::vector<double>   distance;   ///< by vertex, infinite beyond the radius
  std::vector<Halfedge> parent;     ///< by vertex: the tree's halfedge that ends there, null at the root and beyond
};

/// Dijkstra's algorithm on halfedges: edges may be parallel.
/// \tparam Graph an `Intrinsic_triangulation`, or a graph with its names for what stands at a vertex
/// \param lengths by edge
/// Complexity: linear, and O(k log k) for k vertices within the radius.
template <class Graph>
Shortest_path_tree shortest_path_tree(const Graph& g, const std::vector<double>& lengths, Vertex root,
                                      double radius = std::numeric_limits<double>::infinity())
{
  Shortest_path_tree tree;
  tree.distance.assign(g.number_of_vertices(), std::numeric_limits<double>::infinity());
  tree.parent.assign(g.number_of_vertices(), Mesh::null_halfedge());
  using Item = std::pair<double, Vertex>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  tree.distance[root] = 0;
  queue.push({0, root});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > tree.distance[v]) continue;
    tree.order.push_back(v);
    const Halfedge first = g.halfedge_from(v);
    Halfedge h = first;
    do {
      const Vertex w = g.target(h);
      const double through = d + lengths[g.edge(h)];
      if (through < tree.distance[w] && through <= radius) {
        tree.distance[w] = through;
        tree.parent[w] = h;
        queue.push({through, w});
      }
      h = g.next_around_source(h);
    } while (h != first);
  }
  return tree;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SHORTEST_PATH_TREE_H
