// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SHORTEST_PATH_TREE_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SHORTEST_PATH_TREE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <limits>
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
/// \param lengths by edge
/// Complexity: linear, and O(k log k) for k vertices within the radius.
Shortest_path_tree shortest_path_tree(const Intrinsic_triangulation& t, const std::vector<double>& lengths, Vertex root,
                                      double radius = std::numeric_limits<double>::infinity());

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SHORTEST_PATH_TREE_H
