// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/shortest_path_tree.h>
#include <CGAL/Quartic_differentials/internal/tree_cotree.h>

#include <queue>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

// Shortest paths, where the way along a boundary curve takes nothing. The tree holds all edges of every boundary curve but
// one: the vertex that was reached first leads to the others, which are as far from the root.
Shortest_path_tree tree_along_boundary(const Intrinsic_triangulation& t, std::vector<double> lengths, Vertex root)
{
  for (Edge e : t.edges())
    if (t.is_border(e)) lengths[e] = 0;
  Shortest_path_tree tree = shortest_path_tree(t, lengths, root);
  std::vector<char> along(t.number_of_vertices(), false);
  for (Vertex v : tree.order) {
    if (!t.is_border(v) || along[v]) continue;
    along[v] = true;
    for (Halfedge h = t.halfedge_from(v); t.target(h) != v; h = t.next_on_boundary(h)) {
      tree.parent[t.target(h)] = h;
      along[t.target(h)] = true;
    }
  }
  return tree;
}

} // namespace

std::vector<Halfedge> dual_path(const Intrinsic_triangulation& t, const Tree_cotree& trees, Face from, Face to)
{
  std::vector<Halfedge> there, back;
  while (from != to) {
    if (trees.face_depth[from] >= trees.face_depth[to]) {
      there.push_back(t.opposite(trees.face_parent[from]));
      from = t.face(trees.face_parent[from]);
    } else {
      back.push_back(trees.face_parent[to]);
      to = t.face(trees.face_parent[to]);
    }
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  return there;
}

std::vector<Halfedge> dual_loop(const Intrinsic_triangulation& t, const Tree_cotree& trees, Halfedge h)
{
  std::vector<Halfedge> loop = dual_path(t, trees, t.face(t.opposite(h)), t.face(h));
  loop.insert(loop.begin(), h);
  return loop;
}

Tree_cotree tree_cotree(const Intrinsic_triangulation& t, const std::vector<double>& lengths, Vertex root)
{
  Tree_cotree result;
  Shortest_path_tree tree = tree_along_boundary(t, lengths, root);
  result.vertex_parent = std::move(tree.parent);
  std::vector<char> in_tree(t.number_of_edges(), false), in_cotree(t.number_of_edges(), false);
  for (Halfedge h : result.vertex_parent)
    if (h != Mesh::null_halfedge()) in_tree[t.edge(h)] = true;

  // Prim's algorithm on the faces, longest loop first, ties by halfedge index
  const auto loop_length = [&](Halfedge h) {
    return tree.distance[t.source(h)] + tree.distance[t.target(h)] + lengths[t.edge(h)];
  };
  using Item = std::pair<double, std::size_t>;
  std::priority_queue<Item> queue;
  const auto push_sides = [&](Face f) {
    for (Halfedge h : t.halfedges(f))
      if (!in_tree[t.edge(h)] && !t.is_border(t.opposite(h)) && result.face_depth[t.face(t.opposite(h))] < 0)
        queue.push({loop_length(h), h.idx()});
  };
  const Face first = *t.faces().begin();
  result.face_parent.assign(t.number_of_faces(), Mesh::null_halfedge());
  result.face_depth.assign(t.number_of_faces(), -1);
  result.face_depth[first] = 0;
  push_sides(first);
  while (!queue.empty()) {
    const Halfedge h(static_cast<Mesh::size_type>(queue.top().second));
    queue.pop();
    const Face f = t.face(t.opposite(h));
    if (result.face_depth[f] >= 0) continue;
    result.face_depth[f] = result.face_depth[t.face(h)] + 1;
    result.face_parent[f] = h;
    in_cotree[t.edge(h)] = true;
    push_sides(f);
  }
  for (Edge e : t.edges())
    if (!in_tree[e] && !in_cotree[e]) result.generators.push_back(e);
  return result;
}

} } } // namespace CGAL::Quartic_differentials::internal
