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
  Indices result(4 * m_quads.size());
  for (std::size_t e = 0; e < sides.size(); ++e) {
    if (m_edge_class[e] != e) continue;
    if (sides[e][0] != 2) {
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

  // the quads round every vertex, in one circle
  std::vector<int> valence(m_point_class.size(), 0);
  std::vector<char> seen(opposite.size(), false);
  long vertices = 0;
  for (std::size_t first = 0; first < opposite.size(); ++first) {
    if (seen[first]) continue;
    const std::size_t v = vertex(m_quads[first / 4].point[first % 4]);
    if (valence[v] != 0) return "parts of the surface that are not neighbours meet in a point";
    for (std::size_t h = first; !seen[h]; h = opposite[h - h % 4 + (h + 3) % 4]) {
      seen[h] = true;
      ++valence[v];
    }
    ++vertices;
  }

  std::vector<int> expected(m_point_class.size(), 4);
  std::vector<char> is_singular(m_point_class.size(), false);
  for (std::size_t n = 0; n < t.nodes.size(); ++n) {
    if (!t.nodes[n].is_singularity()) continue;
    if (is_singular[vertex(n)]) return "the singularity of node " + std::to_string(n) + " is at another one";
    is_singular[vertex(n)] = true;
    expected[vertex(n)] = t.nodes[n].order + 4;
  }
  for (std::size_t v = 0; v < valence.size(); ++v)
    if (vertex(v) == v && valence[v] != expected[v])
      return "a vertex has " + std::to_string(valence[v]) + " quads, not " + std::to_string(expected[v]);

  // every edge is on two quads: V - E + F = V - F
  if (vertices - static_cast<long>(m_quads.size()) != t.euler_characteristic())
    return "the genus is not that of the T-mesh";
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
