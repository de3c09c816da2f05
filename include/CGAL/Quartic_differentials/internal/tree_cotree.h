// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TREE_COTREE_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TREE_COTREE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A spanning tree of the vertices and a disjoint spanning tree of the faces. 2g edges inside the surface and one edge of
/// every boundary curve are in neither.
struct Tree_cotree
{
  std::vector<Halfedge> vertex_parent;   ///< by vertex: the tree's halfedge that ends there, null at the root
  std::vector<Halfedge> face_parent;     ///< by face: the halfedge of the parent face that leads here, null at the root
  std::vector<int>      face_depth;      ///< by face: number of steps to the root of the cotree
  std::vector<Edge>     generators;      ///< the edges in neither tree, by index
};

/// the loop that leaves the face of h through h and comes back through the cotree: the halfedges through which it leaves
/// one face after the other. \pre h and its opposite are in faces
std::vector<Halfedge> dual_loop(const Intrinsic_triangulation& t, const Tree_cotree& trees, Halfedge h);

/// the way from one face to another through the cotree, as the halfedges through which it leaves one after the other
std::vector<Halfedge> dual_path(const Intrinsic_triangulation& t, const Tree_cotree& trees, Face from, Face to);

/// Shortest paths from `root` and the dual spanning tree that is maximal for the length of the loop an edge closes.
/// \param lengths by edge
/// Complexity: O(n log n)
Tree_cotree tree_cotree(const Intrinsic_triangulation& t, const std::vector<double>& lengths, Vertex root);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TREE_COTREE_H
