// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/zero_complex.h>

#include <CGAL/Quartic_differentials/internal/Quad_grid.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <set>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const std::size_t none = static_cast<std::size_t>(-1);

using Indices = std::vector<std::size_t>;

// by arc: the patches on its right (used backward; none on the boundary) and on its left (forward)
using Patches_at_arcs = std::vector<std::array<std::size_t, 2>>;

Patches_at_arcs patches_at(const T_mesh& t)
{
  Patches_at_arcs result(t.arcs.size(), {none, none});
  for (std::size_t p = 0; p < t.patches.size(); ++p)
    for (const auto& side : t.patches[p].sides)
      for (const T_mesh::Side_piece& piece : side) result[piece.arc][piece.forward] = p;
  return result;
}

// the patches that are reached from one without crossing arcs that are walls
std::vector<char> reached_patches(const T_mesh& t, const Patches_at_arcs& at, std::size_t first,
                                  const std::vector<char>& is_wall)
{
  std::vector<char> reached(t.patches.size(), false);
  Indices stack{first};
  reached[first] = true;
  while (!stack.empty()) {
    const std::size_t p = stack.back();
    stack.pop_back();
    for (const auto& side : t.patches[p].sides)
      for (const T_mesh::Side_piece& piece : side) {
        const std::size_t next = at[piece.arc][!piece.forward];
        if (is_wall[piece.arc] || next == none || reached[next]) continue;
        reached[next] = true;
        stack.push_back(next);
      }
  }
  return reached;
}

// by node
std::vector<char> nodes_on_boundary(const T_mesh& t)
{
  std::vector<char> result(t.nodes.size(), false);
  for (const T_mesh::Arc& arc : t.arcs)
    if (arc.on_boundary) result[arc.from] = result[arc.to] = true;
  return result;
}

// Whether a simple loop of arcs could shrink in some other quantization, or a simple path that has nothing but its ends
// on the boundary: then everything on one side of it does, a disk, or a disk between path and boundary. With the loop or
// path itself it holds at most one singularity, and none inside the surface if it meets the boundary.
bool may_shrink(const T_mesh& t, const Patches_at_arcs& at, const Indices& arcs, bool is_path)
{
  const std::vector<char> on_boundary = nodes_on_boundary(t);
  std::vector<char> is_wall(t.arcs.size(), false), is_on_wall(t.nodes.size(), false);
  for (std::size_t a : arcs) is_wall[a] = is_on_wall[t.arcs[a].from] = is_on_wall[t.arcs[a].to] = true;
  const auto [right, left] = at[arcs.front()];
  for (std::size_t side : {right, left}) {
    if (side == none) continue;
    const std::vector<char> reached = reached_patches(t, at, side, is_wall);
    if (right != none && reached[right] && reached[left]) return false;   // it does not separate
    long chi = std::count(reached.begin(), reached.end(), true), singularities = 0, singularities_inside = 0;
    std::vector<char> is_inside(t.nodes.size(), false);
    for (std::size_t a = 0; a < t.arcs.size(); ++a) {
      if (is_wall[a] || !reached[at[a][1]]) continue;
      --chi;
      is_inside[t.arcs[a].from] = is_inside[t.arcs[a].to] = true;
    }
    bool meets_boundary = false;
    for (std::size_t n = 0; n < t.nodes.size(); ++n) {
      if (is_inside[n] && !is_on_wall[n]) ++chi;
      if (!is_inside[n] && !is_on_wall[n]) continue;
      singularities += t.nodes[n].is_singularity();
      singularities_inside += t.nodes[n].is_singularity() && !on_boundary[n];
      meets_boundary = meets_boundary || on_boundary[n];
    }
    // of the open disk, with the arcs and nodes of the boundary between the ends of the path: one arc more than nodes
    const bool is_disk = chi == (is_path ? 0 : 1);
    if (is_disk && singularities <= 1 && !(meets_boundary && singularities_inside > 0)) return true;
  }
  return false;
}

// X as a graph: its points are the `Arc_points`.
class Zero_complex
{
public:
  Zero_complex(const T_mesh& t, const std::vector<int>& q, bool with_chords)
    : m_t(t), m_q(q), m_patches_at(patches_at(t)), m_points(t, q)
  {
    for (std::size_t a = 0; a < t.arcs.size(); ++a)
      if (q[a] == 0) m_edges.push_back({t.arcs[a].from, t.arcs[a].to, {a}, false, false, t.arcs[a].on_boundary});
    collapse_patches();
    if (with_chords)
      for (const T_mesh::Patch& patch : t.patches) add_chords(patch);
    m_incident.resize(m_points.size());
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
      m_incident[m_edges[e].from].push_back(e);
      m_incident[m_edges[e].to].push_back(e);
    }
  }

  std::vector<Separating_cut> cuts()
  {
    std::vector<Separating_cut> result = paths_between_singularities();
    for (Separating_cut& cut : paths_to_boundary()) result.push_back(std::move(cut));
    for (Separating_cut& cut : loops()) result.push_back(std::move(cut));
    return result;
  }

private:
  struct Graph_edge
  {
    std::size_t from, to;
    Indices     arcs;           // that are 0 where it shrinks
    bool        is_chord;
    bool        is_collapsed;   // with a patch of size 0 x 0, of which it was a free side
    bool        on_boundary;
  };

  // Breadth-first trees: by point, the root, the edge to the parent and the number of edges from the root.
  struct Forest
  {
    Indices root, up, depth;

    explicit Forest(std::size_t points) : root(points, none), up(points, none), depth(points, 0) {}
    bool holds(std::size_t point) const { return root[point] != none; }
    void plant(std::size_t point) { root[point] = point; }
    void plant(std::size_t point, std::size_t of_tree) { root[point] = of_tree; }
  };

  std::size_t other_end(std::size_t edge, std::size_t point) const
  {
    return m_edges[edge].from == point ? m_edges[edge].to : m_edges[edge].from;
  }

  // Patches of size 0 x 0 are collapsed one after the other, each from a side on which there is nothing (more).
  void collapse_patches()
  {
    const Patches_at_arcs& at = m_patches_at;
    Indices edge_of_arc(m_t.arcs.size(), none);
    for (std::size_t e = 0; e < m_edges.size(); ++e) edge_of_arc[m_edges[e].arcs.front()] = e;
    std::vector<char> is_full;   // and not collapsed yet
    const auto holds_full = [&](std::size_t patch) { return patch != none && is_full[patch]; };
    for (const T_mesh::Patch& patch : m_t.patches)
      is_full.push_back(side_length(patch.sides[0], m_q) == 0 && side_length(patch.sides[1], m_q) == 0);
    std::deque<std::size_t> free;   // edges which may be on one full patch only
    for (std::size_t e = 0; e < m_edges.size(); ++e) free.push_back(e);
    while (!free.empty()) {
      const std::size_t e = free.front(), a = m_edges[e].arcs.front();
      free.pop_front();
      if (m_edges[e].is_collapsed || holds_full(at[a][0]) == holds_full(at[a][1])) continue;
      const std::size_t patch = holds_full(at[a][0]) ? at[a][0] : at[a][1];
      is_full[patch] = false;
      m_edges[e].is_collapsed = true;
      for (const auto& side : m_t.patches[patch].sides)
        for (const T_mesh::Side_piece& piece : side) free.push_back(edge_of_arc[piece.arc]);
    }
  }

  // across a patch of width or height 0, between inner points of its long sides
  void add_chords(const T_mesh::Patch& patch)
  {
    for (int k = 0; k < 2; ++k) {
      if (side_length(patch.sides[k], m_q) > 0) continue;
      Indices arcs;
      for (const T_mesh::Side_piece& piece : patch.sides[k]) arcs.push_back(piece.arc);
      const Indices first = m_points.on(patch.sides[1 - k], m_t, m_q), second = m_points.on(patch.sides[3 - k], m_t, m_q);
      const std::size_t last = first.size() - 1;   // sides run round the patch: the other one the other way
      for (std::size_t i = 1; i < last; ++i) m_edges.push_back({first[i], second[last - i], arcs, true, false, false});
    }
  }

  // grows the trees by all edges of X, or by those that are left after the collapse
  void grow(Forest& forest, std::deque<std::size_t> front, bool with_collapsed) const
  {
    while (!front.empty()) {
      const std::size_t point = front.front();
      front.pop_front();
      for (std::size_t e : m_incident[point]) {
        const std::size_t next = other_end(e, point);
        if (forest.holds(next) || (m_edges[e].is_collapsed && !with_collapsed)) continue;
        forest.root[next] = forest.root[point];
        forest.up[next] = e;
        forest.depth[next] = forest.depth[point] + 1;
        front.push_back(next);
      }
    }
  }

  // the arcs of an edge and of the tree paths from its ends to where they meet, or to their roots
  Separating_cut closed_through(std::size_t edge, const Forest& forest) const
  {
    std::set<std::size_t> arcs(m_edges[edge].arcs.begin(), m_edges[edge].arcs.end());
    bool has_chords = m_edges[edge].is_chord;
    std::size_t u = m_edges[edge].from, v = m_edges[edge].to;
    while (u != v && (forest.up[u] != none || forest.up[v] != none)) {
      if (forest.up[u] == none || forest.depth[u] < forest.depth[v]) std::swap(u, v);
      const std::size_t e = forest.up[u];
      arcs.insert(m_edges[e].arcs.begin(), m_edges[e].arcs.end());
      has_chords = has_chords || m_edges[e].is_chord;
      u = other_end(e, u);
    }
    return {Indices(arcs.begin(), arcs.end()), !has_chords};
  }

  std::vector<Separating_cut> paths_between_singularities() const
  {
    Forest regions(m_incident.size());
    std::deque<std::size_t> singularities;
    for (std::size_t n = 0; n < m_t.nodes.size(); ++n) {
      if (!m_t.nodes[n].is_singularity()) continue;
      regions.plant(n);
      singularities.push_back(n);
    }
    grow(regions, std::move(singularities), true);
    return paths_between(regions);
  }

  // The components of X on the boundary, and the singularities inside, must stay apart.
  std::vector<Separating_cut> paths_to_boundary() const
  {
    Forest regions(m_incident.size());
    std::deque<std::size_t> begin;
    for (std::size_t point : points_on_boundary()) {
      if (regions.holds(point)) continue;
      std::deque<std::size_t> component{point};
      for (regions.plant(point); !component.empty(); component.pop_front()) {
        begin.push_back(component.front());
        for (std::size_t e : m_incident[component.front()]) {
          const std::size_t next = other_end(e, component.front());
          if (!m_edges[e].on_boundary || regions.holds(next)) continue;
          regions.plant(next, point);
          component.push_back(next);
        }
      }
    }
    if (begin.empty()) return {};
    for (std::size_t n = 0; n < m_t.nodes.size(); ++n)
      if (m_t.nodes[n].kind == T_mesh::Node_kind::singularity) {
        regions.plant(n);
        begin.push_back(n);
      }
    grow(regions, std::move(begin), true);
    std::vector<Separating_cut> result;
    for (Separating_cut& cut : paths_between(regions)) {
      const bool is_to_singularity = std::any_of(cut.arcs.begin(), cut.arcs.end(), [&](std::size_t a) {
        return m_t.nodes[m_t.arcs[a].from].kind == T_mesh::Node_kind::singularity
            || m_t.nodes[m_t.arcs[a].to].kind == T_mesh::Node_kind::singularity;
      });
      cut.is_valid = cut.is_valid && (is_to_singularity || !may_shrink(m_t, m_patches_at, cut.arcs, true));
      result.push_back(std::move(cut));
    }
    return result;
  }

  // nodes and inner points of arcs
  Indices points_on_boundary() const
  {
    Indices result;
    for (std::size_t a = 0; a < m_t.arcs.size(); ++a) {
      if (!m_t.arcs[a].on_boundary) continue;
      result.push_back(m_t.arcs[a].from);
      for (int i = 1; i < m_q[a]; ++i) result.push_back(m_points(a, i));
    }
    return result;
  }

  // the shortest paths between the trees of two regions, for every two that are neighbours
  std::vector<Separating_cut> paths_between(const Forest& regions) const
  {
    // by pair of neighbouring regions: the edge on the shortest path
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>> shortest;
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
      const std::size_t u = m_edges[e].from, v = m_edges[e].to;
      if (!regions.holds(u) || regions.root[u] == regions.root[v]) continue;
      const std::pair<std::size_t, std::size_t> candidate{regions.depth[u] + regions.depth[v], e};
      const auto it = shortest.try_emplace(std::minmax({regions.root[u], regions.root[v]}), candidate).first;
      it->second = std::min(it->second, candidate);
    }
    std::vector<Separating_cut> result;
    for (const auto& [pair, path] : shortest) result.push_back(closed_through(path.second, regions));
    return result;
  }

  std::vector<Separating_cut> loops() const
  {
    Forest forest(m_incident.size());
    for (std::size_t point = 0; point < m_incident.size(); ++point) {
      if (forest.holds(point) || m_incident[point].empty()) continue;
      forest.plant(point);
      grow(forest, {point}, false);
    }
    std::vector<Separating_cut> result;
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
      if (m_edges[e].is_collapsed || forest.up[m_edges[e].from] == e || forest.up[m_edges[e].to] == e) continue;
      Separating_cut cut = closed_through(e, forest);
      cut.is_valid = cut.is_valid && !may_shrink(m_t, m_patches_at, cut.arcs, false);
      result.push_back(std::move(cut));
    }
    return result;
  }

  const T_mesh&           m_t;
  const std::vector<int>& m_q;
  Patches_at_arcs         m_patches_at;
  Arc_points              m_points;
  std::vector<Graph_edge> m_edges;
  std::vector<Indices>    m_incident;   // by point: edges
};

} // namespace

std::vector<Separating_cut> separating_cuts(const T_mesh& t, const std::vector<int>& q)
{
  std::vector<Separating_cut> cuts = Zero_complex(t, q, false).cuts();
  if (cuts.empty()) cuts = Zero_complex(t, q, true).cuts();
  const auto is_valid = [](const Separating_cut& cut) { return cut.is_valid; };
  if (std::any_of(cuts.begin(), cuts.end(), is_valid))
    cuts.erase(std::remove_if(cuts.begin(), cuts.end(), [&](const auto& cut) { return !is_valid(cut); }), cuts.end());
  return cuts;
}

} } } // namespace CGAL::Quartic_differentials::internal
