// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_EDGE_WALKS_H
#define CGAL_QUARTIC_DIFFERENTIALS_EDGE_WALKS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

// Walks along the edges of an `Intrinsic_triangulation`, or of a graph with its names.

using Walk = std::vector<Halfedge>;

template <class Graph>
Walk reversed(const Graph& g, const Walk& walk)
{
  Walk result;
  for (auto h = walk.rbegin(); h != walk.rend(); ++h) result.push_back(g.opposite(*h));
  return result;
}

/// the way to v in a tree. \param parent by vertex: the tree's halfedge that ends there, null at the root
template <class Graph>
Walk path_from_root(const Graph& g, const std::vector<Halfedge>& parent, Vertex v)
{
  Walk path;
  for (Halfedge h = parent[v]; h != Mesh::null_halfedge(); h = parent[g.source(h)]) path.push_back(h);
  std::reverse(path.begin(), path.end());
  return path;
}

/// removes every halfedge that is followed by its opposite, round the closed walk.
template <class Graph>
Walk without_spurs(const Graph& g, const Walk& walk)
{
  Walk result;
  for (Halfedge h : walk)
    if (!result.empty() && result.back() == g.opposite(h)) result.pop_back();
    else result.push_back(h);
  std::size_t ends = 0;
  while (2 * ends + 1 < result.size() && result[ends] == g.opposite(result[result.size() - 1 - ends])) ++ends;
  return Walk(result.begin() + ends, result.end() - ends);
}

/// the loop that h closes in a tree. Without spurs it is simple: two paths in a tree that part do not meet again.
template <class Graph>
Walk loop_in_tree(const Graph& g, const std::vector<Halfedge>& parent, Halfedge h)
{
  Walk loop = path_from_root(g, parent, g.source(h));
  loop.push_back(h);
  const Walk back = reversed(g, path_from_root(g, parent, g.target(h)));
  loop.insert(loop.end(), back.begin(), back.end());
  return without_spurs(g, loop);
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_EDGE_WALKS_H
