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

/// Dijkstra's algorithm on halfedges, which may be parallel: takes the vertices within a radius of a root that are nearer
/// to it than to all roots before; `visit` gets them, nearest first.
/// \tparam Graph an `Intrinsic_triangulation`, or a graph with its names for what stands at a vertex
/// \param lengths by edge
/// \param distance by vertex: from the nearest root so far, infinite if it is beyond the radius of all
/// \param parent by vertex: the halfedge through which its nearest root is reached
/// Complexity: O(k log k) for k vertices that are taken.
template <class Graph, class Visit>
void grow_shortest_paths(const Graph& g, const std::vector<double>& lengths, Vertex root, double radius,
                         std::vector<double>& distance, std::vector<Halfedge>& parent, Visit visit)
{
  using Item = std::pair<double, Vertex>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  distance[root] = 0;
  queue.push({0, root});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    visit(v);
    const Halfedge first = g.halfedge_from(v);
    Halfedge h = first;
    do {
      const Vertex w = g.target(h);
      const double through = d + lengths[g.edge(h)];
      if (through < distance[w] && through <= radius) {
        distance[w] = through;
        parent[w] = h;
        queue.push({through, w});
      }
      h = g.next_around_source(h);
    } while (h != first);
  }
}

/// the tree from one root. Complexity: linear, and O(k log k) for k vertices within the radius.
template <class Graph>
Shortest_path_tree shortest_path_tree(const Graph& g, const std::vector<double>& lengths, Vertex root,
                                      double radius = std::numeric_limits<double>::infinity())
{
  Shortest_path_tree tree;
  tree.distance.assign(g.number_of_vertices(), std::numeric_limits<double>::infinity());
  tree.parent.assign(g.number_of_vertices(), Mesh::null_halfedge());
  grow_shortest_paths(g, lengths, root, radius, tree.distance, tree.parent, [&](Vertex v) { tree.order.push_back(v); });
  return tree;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SHORTEST_PATH_TREE_H
