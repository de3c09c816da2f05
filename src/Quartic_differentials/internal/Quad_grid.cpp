// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/Quad_grid.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const std::size_t none = static_cast<std::size_t>(-1);

using Indices = std::vector<std::size_t>;

// Sets of indices that are united step by step; the class of an index is the least one in its set.
class Classes
{
public:
  explicit Classes(std::size_t size) : m_sets(size), m_size(size) {}

  void unite(std::size_t a, std::size_t b) { m_sets.union_set(a, b); }

  Indices by_index()
  {
    Indices result(m_size), least(m_size, none);
    for (std::size_t i = 0; i < m_size; ++i) {
      std::size_t& first = least[m_sets.find_set(i)];
      if (first == none) first = i;
      result[i] = first;
    }
    return result;
  }

private:
  boost::disjoint_sets_with_storage<> m_sets;
  std::size_t                         m_size;
};

} // namespace

std::size_t side_length(const std::vector<T_mesh::Side_piece>& side, const std::vector<int>& q)
{
  std::size_t sum = 0;
  for (const T_mesh::Side_piece& piece : side) sum += q[piece.arc];
  return sum;
}

Arc_points::Arc_points(const T_mesh& t, const std::vector<int>& q) : m_size(t.nodes.size())
{
  for (int length : q) {
    m_first.push_back(m_size);
    m_size += std::max(length - 1, 0);
  }
}

Indices Arc_points::on(const std::vector<T_mesh::Side_piece>& side, const T_mesh& t, const std::vector<int>& q) const
{
  const auto end = [&](const T_mesh::Side_piece& s, bool last)
  { return s.forward == last ? t.arcs[s.arc].to : t.arcs[s.arc].from; };
  Indices result{end(side.front(), false)};
  for (const T_mesh::Side_piece& piece : side) {
    const std::size_t n = q[piece.arc];
    for (std::size_t i = 1; i < n; ++i) result.push_back((*this)(piece.arc, piece.forward ? i : n - i));
    if (n > 0) result.push_back(end(piece, true));   // otherwise it is the same point
  }
  return result;
}

std::size_t number_of_cycles(const Indices& next)
{
  std::size_t cycles = 0;
  std::vector<char> seen(next.size(), false);
  for (std::size_t first = 0; first < next.size(); ++first) {
    if (seen[first] || next[first] == none) continue;
    ++cycles;
    for (std::size_t i = first; !seen[i]; i = next[i]) seen[i] = true;
  }
  return cycles;
}

std::size_t number_of_boundary_curves(const T_mesh& t)
{
  Indices next(t.nodes.size(), none);
  for (const T_mesh::Arc& arc : t.arcs)
    if (arc.on_boundary) next[arc.from] = arc.to;
  return number_of_cycles(next);
}

// Makes the grids of the patches one after the other.
struct Quad_grid::Glue
{
  Glue(Quad_grid& grid, const T_mesh& t, const std::vector<int>& q)
    : grid(grid), t(t), q(q), points(number_of_points()), edges(number_of_edges())
  {
    for (std::size_t a = 0; a < q.size(); ++a)
      if (q[a] == 0) points.unite(t.arcs[a].from, t.arcs[a].to);
    for (std::size_t p = 0; p < t.patches.size(); ++p) add_patch(p);
    grid.m_point_class = points.by_index();
    grid.m_edge_class = edges.by_index();
    grid.m_outside.assign(grid.m_edge_class.size(), 0);
    for (std::size_t a = 0; a < q.size(); ++a)
      for (int i = 0; i < q[a] && t.arcs[a].on_boundary; ++i) ++grid.m_outside[grid.m_edge_class[arc_edges[a] + i]];
  }

  std::size_t number_of_points()
  {
    std::size_t n = next_point = grid.m_arc_points.size();
    for (const T_mesh::Patch& patch : t.patches)
      n += inner(side_length(patch.sides[0], q)) * inner(side_length(patch.sides[1], q));
    return n;
  }

  std::size_t number_of_edges()
  {
    for (std::size_t a = 0; a < q.size(); ++a) {
      arc_edges.push_back(grid.m_edge_arc.size());
      grid.m_edge_arc.insert(grid.m_edge_arc.end(), q[a], a);
    }
    std::size_t n = grid.m_edge_arc.size();
    for (const T_mesh::Patch& patch : t.patches) {
      const std::size_t width = side_length(patch.sides[0], q), height = side_length(patch.sides[1], q);
      n += width * inner(height) + inner(width) * height;
    }
    return n;
  }

  static std::size_t inner(std::size_t length) { return length > 0 ? length - 1 : 0; }

  Indices edges_on(const std::vector<T_mesh::Side_piece>& side) const
  {
    Indices result;
    for (const T_mesh::Side_piece& piece : side)
      for (int i = 0; i < q[piece.arc]; ++i)
        result.push_back(arc_edges[piece.arc] + (piece.forward ? i : q[piece.arc] - 1 - i));
    return result;
  }

  void add_patch(std::size_t p)
  {
    std::array<Indices, 4> point, edge;   // bottom, right, top, left: from left to right, and upwards
    for (int k = 0; k < 4; ++k) {
      point[k] = grid.m_arc_points.on(t.patches[p].sides[k], t, q);
      edge[k] = edges_on(t.patches[p].sides[k]);
      if (k < 2) continue;
      std::reverse(point[k].begin(), point[k].end());
      std::reverse(edge[k].begin(), edge[k].end());
    }
    const std::size_t width = edge[0].size(), height = edge[1].size();
    if (width == 0) unite(point[1], point[3], edge[1], edge[3]);
    if (height == 0) unite(point[0], point[2], edge[0], edge[2]);
    if (width > 0 && height > 0) add_quads(p, point, edge);
  }

  void unite(const Indices& point, const Indices& other_point, const Indices& edge, const Indices& other_edge)
  {
    for (std::size_t i = 0; i < point.size(); ++i) points.unite(point[i], other_point[i]);
    for (std::size_t i = 0; i < edge.size(); ++i) edges.unite(edge[i], other_edge[i]);
  }

  // row by row; what is below a row is known
  void add_quads(std::size_t p, const std::array<Indices, 4>& point, const std::array<Indices, 4>& edge)
  {
    const std::size_t width = edge[0].size(), height = edge[1].size();
    Indices low_points = point[0], low_edges = edge[0];
    for (std::size_t row = 0; row < height; ++row) {
      const bool last = row + 1 == height;
      Indices high_points = point[2], high_edges = edge[2], upward{edge[3][row]};
      if (!last) {
        high_points = {point[3][row + 1]};
        for (std::size_t i = 1; i < width; ++i) high_points.push_back(next_point++);
        high_points.push_back(point[1][row + 1]);
        for (std::size_t i = 0; i < width; ++i) high_edges[i] = new_edge(grid.m_edge_arc[edge[0][i]]);
      }
      for (std::size_t i = 1; i < width; ++i) upward.push_back(new_edge(grid.m_edge_arc[edge[3][row]]));
      upward.push_back(edge[1][row]);
      for (std::size_t i = 0; i < width; ++i)
        grid.m_quads.push_back({{low_points[i], low_points[i + 1], high_points[i + 1], high_points[i]},
                                {low_edges[i], upward[i + 1], high_edges[i], upward[i]}, p, i, row});
      low_points.swap(high_points);
      low_edges.swap(high_edges);
    }
  }

  std::size_t new_edge(std::size_t arc)
  {
    grid.m_edge_arc.push_back(arc);
    return grid.m_edge_arc.size() - 1;
  }

  Quad_grid&              grid;
  const T_mesh&           t;
  const std::vector<int>& q;
  Indices                 arc_edges;    // by arc: its first edge
  std::size_t             next_point;   // inside patches
  Classes                 points, edges;
};

Quad_grid::Quad_grid(const T_mesh& t, const std::vector<int>& q) : m_arc_points(t, q)
{
  Glue(*this, t, q);
}

Indices Quad_grid::opposite_sides(std::string& violation) const
{
  std::vector<std::array<std::size_t, 3>> sides(m_edge_class.size(), {0, none, none});   // by edge: how many, and which
  for (std::size_t h = 0; h < 4 * m_quads.size(); ++h) {
    auto& s = sides[m_edge_class[m_quads[h / 4].edge[h % 4]]];
    if (++s[0] <= 2) s[s[0]] = h;
  }
  Indices result(4 * m_quads.size(), none);
  for (std::size_t e = 0; e < sides.size(); ++e) {
    if (m_edge_class[e] != e) continue;
    if (sides[e][0] == 1 && m_outside[e] == 1) continue;
    if (sides[e][0] != 2 || m_outside[e] != 0) {
      violation = "an edge on arc " + std::to_string(m_edge_arc[e]) + " is met by " + std::to_string(sides[e][0])
                + " quads";
      return {};
    }
    result[sides[e][1]] = sides[e][2];
    result[sides[e][2]] = sides[e][1];
  }
  return result;
}

std::string Quad_grid::defect(const T_mesh& t) const
{
  std::string violation;
  const Indices opposite = opposite_sides(violation);
  if (!violation.empty()) return violation;

  // the quads round every vertex, in one circle or in a fan, which begins with an edge of the boundary
  std::vector<int> valence(m_point_class.size(), 0);
  std::vector<char> seen(opposite.size(), false);
  Indices on_boundary(m_point_class.size(), none);   // by vertex: the next one along the boundary
  long vertices = 0, boundary_edges = 0;
  const auto walk_round = [&](std::size_t first) {
    const std::size_t v = vertex(m_quads[first / 4].point[first % 4]);
    if (valence[v] != 0) return false;
    for (std::size_t h = first; h != none && !seen[h]; h = opposite[h - h % 4 + (h + 3) % 4]) {
      seen[h] = true;
      ++valence[v];
    }
    ++vertices;
    return true;
  };
  for (std::size_t h = 0; h < opposite.size(); ++h) {
    if (opposite[h] != none) continue;
    if (!walk_round(h)) return "parts of the surface that are not neighbours meet in a point";
    const Quad& quad = m_quads[h / 4];
    on_boundary[vertex(quad.point[h % 4])] = vertex(quad.point[(h + 1) % 4]);
    ++boundary_edges;
  }
  for (std::size_t h = 0; h < opposite.size(); ++h)
    if (!seen[h] && !walk_round(h)) return "parts of the surface that are not neighbours meet in a point";

  std::vector<int> expected(m_point_class.size());
  for (std::size_t v = 0; v < expected.size(); ++v) expected[v] = on_boundary[v] == none ? 4 : 2;
  std::vector<char> is_singular(m_point_class.size(), false);
  for (std::size_t n = 0; n < t.nodes.size(); ++n) {
    if (!t.nodes[n].is_singularity()) continue;
    const std::string singularity = "the singularity of node " + std::to_string(n);
    if (is_singular[vertex(n)]) return singularity + " is at another one";
    if ((on_boundary[vertex(n)] != none) != (t.nodes[n].kind == T_mesh::Node_kind::corner))
      return singularity + " is inside and not on the boundary, or the other way round";
    is_singular[vertex(n)] = true;
    expected[vertex(n)] += t.nodes[n].order;
  }
  for (std::size_t v = 0; v < valence.size(); ++v)
    if (vertex(v) == v && valence[v] != expected[v])
      return "a vertex has " + std::to_string(valence[v]) + " quads, not " + std::to_string(expected[v]);

  // every edge is on two quads, or one on the boundary: 2 (V - E + F) = 2 V - 2 F - edges on the boundary
  if (2 * (vertices - static_cast<long>(m_quads.size())) - boundary_edges != 2 * t.euler_characteristic())
    return "the genus is not that of the T-mesh";
  if (number_of_cycles(on_boundary) != number_of_boundary_curves(t))
    return "there are not as many boundary curves as in the T-mesh";
  return {};
}

std::vector<Indices> Quad_grid::crowded_arcs() const
{
  struct Edge_ends { std::size_t low, high, arc; };
  std::vector<Edge_ends> ends;
  std::vector<char> seen(m_edge_class.size(), false);
  for (const Quad& quad : m_quads)
    for (int k = 0; k < 4; ++k) {
      if (seen[m_edge_class[quad.edge[k]]]) continue;
      seen[m_edge_class[quad.edge[k]]] = true;
      const auto [low, high] = std::minmax(m_point_class[quad.point[k]], m_point_class[quad.point[(k + 1) % 4]]);
      ends.push_back({low, high, m_edge_arc[quad.edge[k]]});
    }
  std::sort(ends.begin(), ends.end(), [](const Edge_ends& a, const Edge_ends& b)
            { return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high); });
  std::vector<Indices> result;
  for (std::size_t e = 0; e < ends.size(); ++e) {
    if (ends[e].low == ends[e].high) result.push_back({ends[e].arc});
    else if (e > 0 && ends[e].low == ends[e - 1].low && ends[e].high == ends[e - 1].high)
      result.push_back({ends[e - 1].arc, ends[e].arc});
  }
  return result;
}

} } } // namespace CGAL::Quartic_differentials::internal
