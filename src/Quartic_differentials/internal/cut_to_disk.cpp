// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/cut_to_disk.h>
#include <CGAL/Quartic_differentials/internal/tree_cotree.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

// the primal tree, the edges in neither tree, and the boundary: what is left of the surface is a disk
std::vector<char> edges_outside_cotree(const Intrinsic_triangulation& t, const std::vector<double>& lengths, Vertex root)
{
  const Tree_cotree trees = tree_cotree(t, lengths, root);
  std::vector<char> cut(t.number_of_edges(), false);
  for (Halfedge h : trees.vertex_parent)
    if (h != Mesh::null_halfedge()) cut[t.edge(h)] = true;
  for (Edge e : trees.generators) cut[e] = true;
  for (Edge e : t.edges())
    if (t.is_border(e)) cut[e] = true;
  return cut;
}

Halfedge cut_halfedge_from(const Intrinsic_triangulation& t, const std::vector<char>& cut, Vertex v)
{
  Halfedge h = t.halfedge_from(v);
  while (!cut[t.edge(h)]) h = t.next_around_source(h);
  return h;
}

std::vector<int> degrees(const Intrinsic_triangulation& t, const std::vector<char>& cut)
{
  std::vector<int> degree(t.number_of_vertices(), 0);
  for (Halfedge h : t.halfedges())
    if (cut[t.edge(h)]) ++degree[t.source(h)];
  return degree;
}

void prune_leaves(const Intrinsic_triangulation& t, const std::vector<char>& is_cone, std::vector<char>& cut)
{
  std::vector<int> degree = degrees(t, cut);
  for (Vertex v : t.vertices())
    for (Vertex leaf = v; degree[leaf] == 1 && !is_cone[leaf]; ) {
      const Halfedge h = cut_halfedge_from(t, cut, leaf);
      cut[t.edge(h)] = false;
      --degree[leaf];
      leaf = t.target(h);
      --degree[leaf];
    }
}

// the cut halfedge that follows h on the boundary of the disk on its left
Halfedge next_on_boundary(const Intrinsic_triangulation& t, const std::vector<char>& cut, Halfedge h)
{
  Halfedge g = t.next(h);
  while (!cut[t.edge(g)]) g = t.next(t.opposite(g));
  return g;
}

// A node always exists. Otherwise every vertex of the pruned graph would have degree 2, it would be a circle or empty,
// and its Euler characteristic not 1 - 2g - b, unless the surface is a sphere or a disk without cones.
std::vector<Halfedge> walk_round(const Intrinsic_triangulation& t, const std::vector<char>& cut,
                                 const std::function<bool(Vertex)>& is_node)
{
  std::vector<Halfedge> walk;
  for (Halfedge h : t.halfedges()) {
    if (t.is_border(h) || !cut[t.edge(h)] || !is_node(t.source(h))) continue;
    Halfedge g = h;
    do {
      walk.push_back(g);
      g = next_on_boundary(t, cut, g);
    } while (g != h);
    break;
  }
  CGAL_postcondition_code(const auto is_open = [&](Halfedge h) { return !t.is_border(h) && cut[t.edge(h)]; });
  CGAL_postcondition(static_cast<std::ptrdiff_t>(walk.size())
                     == std::count_if(t.halfedges().begin(), t.halfedges().end(), is_open));
  return walk;
}

void find_sides(const Intrinsic_triangulation& t, const std::function<bool(Vertex)>& is_node, Cut_disk& disk)
{
  std::vector<std::size_t> side(t.number_of_halfedges());
  for (std::size_t i = 0; i < disk.boundary.size(); ++i) {
    if (is_node(t.source(disk.boundary[i]))) disk.sides.push_back({i, 0, 0});
    ++disk.sides.back().size;
    side[disk.boundary[i]] = disk.sides.size() - 1;
  }
  for (Cut_disk::Side& s : disk.sides) {
    const Halfedge h = disk.boundary[s.first], o = t.opposite(h);
    s.mate = side[t.is_border(o) ? h : o];
  }
}

void number_copies(const Intrinsic_triangulation& t, Cut_disk& disk)
{
  const std::size_t none = std::numeric_limits<std::size_t>::max();
  disk.copy.assign(t.number_of_halfedges(), none);
  const auto number_fan = [&](Halfedge h, std::size_t number) {   // counterclockwise up to the cut, or once round
    while (disk.copy[h] == none) {
      disk.copy[h] = number;
      if (!disk.is_cut[t.edge(t.prev(h))]) h = t.next_around_source(h);
    }
  };
  for (Halfedge h : disk.boundary) number_fan(h, disk.number_of_copies++);
  for (Halfedge h : t.halfedges())
    if (!t.is_border(h) && disk.copy[h] == none) number_fan(h, disk.number_of_copies++);
}

} // namespace

Cut_disk cut_to_disk(const Intrinsic_triangulation& t, const std::vector<double>& lengths,
                     const std::vector<char>& is_cone)
{
  const auto cone = std::find(is_cone.begin(), is_cone.end(), true);
  const Vertex root(cone == is_cone.end() ? 0 : static_cast<Mesh::size_type>(cone - is_cone.begin()));

  Cut_disk disk;
  disk.is_cut = edges_outside_cotree(t, lengths, root);
  prune_leaves(t, is_cone, disk.is_cut);
  const std::vector<int> degree = degrees(t, disk.is_cut);
  const auto is_node = [&](Vertex v) { return is_cone[v] || degree[v] != 2; };
  disk.boundary = walk_round(t, disk.is_cut, is_node);
  find_sides(t, is_node, disk);
  number_copies(t, disk);
  return disk;
}

} } } // namespace CGAL::Quartic_differentials::internal
