// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/quad_mesh.h>

#include "internal/border_sides.h"
#include "internal/grid_lines.h"

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Patch_locator.h>
#include <CGAL/Quartic_differentials/internal/Quad_grid.h>
#include <CGAL/Quartic_differentials/internal/Quad_shape.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Patch_locator;
using internal::Quad_grid;
using Side = std::vector<T_mesh::Side_piece>;

const std::size_t none = static_cast<std::size_t>(-1);

// The places of the grids' points on the refined surface.
class Placement
{
public:
  Placement(const T_mesh& t, const std::vector<int>& q, const Quad_grid& grid, const Quartic_differential& differential)
    : m_t(t), m_q(q), m_grid(grid), m_locator(t, differential), m_place(grid.number_of_points())
  {
    place_nodes(true);
    place_boundary();
    place_nodes(false);
    for (std::size_t p = 0; p < t.patches.size(); ++p) place_sides(p);
    place_inner_points();
  }

  const Surface_point& operator()(std::size_t vertex) const { return *m_place[vertex]; }

private:
  // what comes first stays
  void place(std::size_t point, const Surface_point& p)
  {
    std::optional<Surface_point>& place = m_place[m_grid.vertex(point)];
    if (!place) place = p;
  }

  void place_nodes(bool singular)
  {
    for (std::size_t n = 0; n < m_t.nodes.size(); ++n)
      if (m_t.nodes[n].is_singularity() == singular)
        place(n, m_locator.in_face(m_t.nodes[n].face, m_t.nodes[n].point));
  }

  // first the nodes, then the inner points of the arcs between them, in the faces that have the boundary as an edge
  void place_boundary()
  {
    for (const T_mesh::Arc& arc : m_t.arcs)
      if (arc.on_boundary) place(arc.from, on_arc(arc, 0));
    for (std::size_t a = 0; a < m_t.arcs.size(); ++a)
      if (m_t.arcs[a].on_boundary)
        for (int i = 1; i < m_q[a]; ++i)
          place(m_grid.arc_point(a, i), on_arc(m_t.arcs[a], fraction(m_t.arcs[a].length, i, m_q[a])));
  }

  Surface_point on_arc(const T_mesh::Arc& arc, std::int64_t distance) const
  {
    auto s = arc.path.begin();
    for (; s + 1 != arc.path.end() && distance > internal::along(s->direction, s->to - s->from); ++s)
      distance -= internal::along(s->direction, s->to - s->from);
    return m_locator.in_face(s->face, s->from + rotated({distance, 0}, s->direction));
  }

  // the inner points of an arc, from the patch on its left
  void place_sides(std::size_t p)
  {
    const T_mesh::Patch& patch = m_t.patches[p];
    for (int k = 0; k < 4; ++k) {
      std::int64_t begin = 0;
      for (const T_mesh::Side_piece& piece : patch.sides[k]) {
        const std::int64_t length = m_t.arcs[piece.arc].length;
        if (piece.forward && !m_t.arcs[piece.arc].on_boundary)
          for (int i = 1; i < m_q[piece.arc]; ++i)
            place(m_grid.arc_point(piece.arc, i),
                  m_locator.locate(p, patch.on_side(k, begin + fraction(length, i, m_q[piece.arc]))));
        begin += length;
      }
    }
  }

  static std::int64_t fraction(std::int64_t length, int i, int n)
  { return static_cast<std::int64_t>(static_cast<__int128>(length) * i / n); }

  // by point of a side: its distance from the first corner; where arcs shrink to a point, the middle, or the corner
  std::vector<double> divided(const Side& side) const
  {
    std::vector<double> result{0};
    double begin = 0, zero = 0;   // where the arc begins, and the length of the arcs before it that are 0
    for (const T_mesh::Side_piece& piece : side) {
      const double length = static_cast<double>(m_t.arcs[piece.arc].length);
      const int n = m_q[piece.arc];
      if (n == 0) {
        zero += length;
      } else {
        if (result.size() > 1) result.back() -= zero / 2;
        zero = 0;
        for (int i = 1; i <= n; ++i) result.push_back(begin + length * i / n);
      }
      begin += length;
      if (n == 0 && result.size() > 1) result.back() = begin;
    }
    return result;
  }

  void place_inner_points()
  {
    std::size_t patch = none;
    std::array<std::vector<double>, 4> at;   // bottom and top x, right and left y
    for (const Quad_grid::Quad& quad : m_grid.quads()) {
      const T_mesh::Patch& p = m_t.patches[quad.patch];
      if (quad.patch != patch) {
        patch = quad.patch;
        for (int k = 0; k < 4; ++k) {
          at[k] = divided(p.sides[k]);
          if (k < 2) continue;
          std::reverse(at[k].begin(), at[k].end());
          for (double& x : at[k]) x = static_cast<double>(k == 2 ? p.width : p.height) - x;
        }
      }
      if (quad.column == 0 || quad.row == 0) continue;
      const std::size_t i = quad.column, j = quad.row;
      const double u = double(i) / double(at[0].size() - 1), v = double(j) / double(at[1].size() - 1);
      const Grid_vector z{rounded((1 - v) * at[0][i] + v * at[2][i], p.width),
                          rounded((1 - u) * at[3][j] + u * at[1][j], p.height)};
      place(quad.point[0], m_locator.locate(patch, z));
    }
  }

  static std::int64_t rounded(double x, std::int64_t most)
  { return std::clamp<std::int64_t>(std::llround(x), 0, most); }

  const T_mesh&                             m_t;
  const std::vector<int>&                   m_q;
  const Quad_grid&                          m_grid;
  const Patch_locator                       m_locator;
  std::vector<std::optional<Surface_point>> m_place;   // by vertex
};

} // namespace

Quad_mesh quad_mesh(const T_mesh& t, const std::vector<int>& q, const Refined_surface& refined)
{
  const Quad_grid grid(t, q);
  const Placement place(t, q, grid, refined.differential);
  Quad_mesh result;
  std::vector<std::size_t> index(grid.number_of_points(), none);   // by vertex of the grid
  const auto vertex = [&](std::size_t point) {
    const std::size_t v = grid.vertex(point);
    if (index[v] == none) {
      index[v] = result.points.size();
      result.points.push_back(position_on_input(refined.differential.triangulation, place(v)));
      result.input_points.push_back(refined.to_input(place(v)));
    }
    return index[v];
  };
  for (std::size_t n = 0; n < t.nodes.size(); ++n)
    if (t.nodes[n].is_singularity()) result.singularities.push_back(vertex(n));
  for (const Quad_grid::Quad& quad : grid.quads()) {
    result.quads.push_back({vertex(quad.point[0]), vertex(quad.point[1]), vertex(quad.point[2]),
                            vertex(quad.point[3])});
    result.patch.push_back(quad.patch);
  }
  const std::string violation = defect(result, t);
  if (!violation.empty()) throw Numerical_error("the quad mesh is not valid: " + violation);
  return result;
}

std::string defect(const Quad_mesh& m, const T_mesh& t)
{
  const auto name = [](const char* what, std::size_t i) { return std::string(what) + ' ' + std::to_string(i); };
  if (m.patch.size() != m.quads.size() || m.input_points.size() != m.points.size()) return "the sizes do not fit";
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> previous;   // by corner: from the vertex, and the next
  std::vector<std::size_t> on_boundary(m.points.size(), none);           // the next vertex there
  const std::size_t boundary_curves = internal::number_of_boundary_curves(t);
  long boundary_edges = 0;
  std::vector<std::size_t> valence(m.points.size(), 0);
  for (std::size_t f = 0; f < m.quads.size(); ++f)
    for (int k = 0; k < 4; ++k) {
      const std::size_t v = m.quads[f][k], next = m.quads[f][(k + 1) % 4];
      if (v >= m.points.size() || next >= m.points.size()) return name("quad", f) + " has a vertex that does not exist";
      if (std::count(m.quads[f].begin(), m.quads[f].end(), v) != 1) return name("quad", f) + " has a vertex twice";
      if (!previous.emplace(std::make_pair(v, next), m.quads[f][(k + 3) % 4]).second)
        return "two quads run from " + name("vertex", v) + " to " + name("vertex", next);
      ++valence[v];
    }
  for (const auto& [edge, before] : previous) {
    if (previous.count({edge.second, edge.first}) != 0) continue;
    if (boundary_curves == 0) return "there is one quad only at the edge from " + name("vertex", edge.first);
    if (on_boundary[edge.first] != none) return name("vertex", edge.first) + " is on the boundary twice";
    on_boundary[edge.first] = edge.second;
    ++boundary_edges;
  }
  for (auto first = previous.begin(); first != previous.end();) {   // the edges from one vertex follow one another
    const std::size_t v = first->first.first, begin = on_boundary[v] == none ? first->first.second : on_boundary[v];
    std::size_t quads = 0, w = begin;
    do {
      w = previous.at({v, w});
      ++quads;
    } while (w != begin && previous.count({v, w}) != 0);
    if (quads != valence[v]) return "the quads at " + name("vertex", v) + " are not one circle, or one fan";
    std::advance(first, quads);
  }

  std::vector<std::size_t> expected(m.points.size());
  for (std::size_t v = 0; v < expected.size(); ++v) expected[v] = on_boundary[v] == none ? 4 : 2;
  std::vector<char> is_singular(m.points.size(), false);
  std::size_t s = 0;
  for (const T_mesh::Node& node : t.nodes) {
    if (!node.is_singularity()) continue;
    if (s == m.singularities.size() || m.singularities[s] >= m.points.size()) return "a singularity has no vertex";
    const std::size_t v = m.singularities[s++];
    if (is_singular[v]) return name("vertex", v) + " has two singularities";
    if ((on_boundary[v] != none) != (node.kind == T_mesh::Node_kind::corner))
      return name("vertex", v) + " is a corner inside, or another singularity on the boundary";
    is_singular[v] = true;
    expected[v] += node.order;
  }
  for (std::size_t v = 0; v < valence.size(); ++v)
    if (valence[v] != expected[v]) return name("vertex", v) + " has " + std::to_string(valence[v]) + " quads";
  // every edge is on two quads, or one on the boundary: 2 (V - E + F) = 2 V - 2 F - edges on the boundary
  const long vertices = static_cast<long>(m.points.size()), quads = static_cast<long>(m.quads.size());
  if (2 * (vertices - quads) - boundary_edges != 2 * t.euler_characteristic())
    return "the genus is not that of the T-mesh";
  if (internal::number_of_cycles(on_boundary) != boundary_curves)
    return "there are not as many boundary curves as in the T-mesh";
  return {};
}

std::vector<std::size_t> next_on_boundary(const Quad_mesh& m)
{
  std::vector<std::size_t> result(m.points.size(), none);
  for (const auto& [v, w] : internal::border_sides(m.quads)) result[v] = w;
  return result;
}

std::vector<int> singularity_orders(const Quad_mesh& m, const T_mesh& t)
{
  std::vector<int> order(m.points.size(), 0);
  std::size_t s = 0;
  for (const T_mesh::Node& node : t.nodes)
    if (node.is_singularity()) order[m.singularities[s++]] = node.order;
  return order;
}

Mesh surface_mesh(const Quad_mesh& m, const T_mesh& t)
{
  Mesh mesh;
  auto patch = mesh.add_property_map<Face, std::uint32_t>("f:patch").first;
  auto place = mesh.add_property_map<Vertex, Surface_point>("v:input_point").first;
  auto order = mesh.add_property_map<Vertex, int>("v:singularity_order", 0).first;
  const std::vector<int> orders = singularity_orders(m, t);
  const auto vertex = [](std::size_t v) { return Vertex(static_cast<Mesh::size_type>(v)); };
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    const Vertex added = mesh.add_vertex(m.points[v]);
    place[added] = m.input_points[v];
    order[added] = orders[v];
  }
  for (std::size_t f = 0; f < m.quads.size(); ++f) {
    const auto& [a, b, c, d] = m.quads[f];
    patch[mesh.add_face(vertex(a), vertex(b), vertex(c), vertex(d))] = static_cast<std::uint32_t>(m.patch[f]);
  }
  return mesh;
}

Scaled_jacobian scaled_jacobian(const Quad_mesh& m)
{
  Scaled_jacobian result{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t f = 0; f < m.quads.size(); ++f) {
    const double least = internal::Quad_shape(m.corners(f)).scaled_jacobian();
    result.least = std::min(result.least, least);
    result.mean += least / double(m.quads.size());
  }
  return result;
}

} } // namespace CGAL::Quartic_differentials
