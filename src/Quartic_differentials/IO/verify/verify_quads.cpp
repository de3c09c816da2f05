// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "on_input.h"
#include "verify_quads.h"

#include <CGAL/Quartic_differentials/internal/read_obj.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

namespace {

using internal::scientific;

struct Quad
{
  std::array<std::size_t, 4> vertex;
  std::int64_t               patch;

  std::size_t next(int k) const { return vertex[(k + 1) % 4]; }
};

struct Quads_obj
{
  std::vector<Position> points;
  std::vector<Quad>     quads;
};

Quads_obj read_quads(const std::string& folder)
{
  const internal::Quads_obj file = internal::read_quads_obj(folder + "/quads.obj");
  Quads_obj obj;
  for (const Point_3& p : file.points) obj.points.push_back({p.x(), p.y(), p.z()});
  for (std::size_t f = 0; f < file.quads.size(); ++f)
    obj.quads.push_back({file.quads[f], static_cast<std::int64_t>(file.patch[f])});
  return obj;
}

// Its edges, by their ends in the direction in which the quad runs: the quad, and the vertex before.
struct Quad_edge { std::size_t quad, before; };
using Quad_edges = std::map<std::pair<std::size_t, std::size_t>, Quad_edge>;

// nothing if two quads run along an edge in the same direction, or on a closed surface one of them on one side only
std::optional<Quad_edges> quad_edges(const std::vector<Quad>& quads, bool is_closed)
{
  Quad_edges edges;
  for (std::size_t f = 0; f < quads.size(); ++f)
    for (int k = 0; k < 4; ++k)
      if (!edges.insert({{quads[f].vertex[k], quads[f].next(k)}, {f, quads[f].vertex[(k + 3) % 4]}}).second) return {};
  for (const auto& [ends, edge] : edges)
    if (is_closed && edges.count({ends.second, ends.first}) == 0) return {};
  return edges;
}

bool is_connected(const std::vector<Quad>& quads, const Quad_edges& edges)
{
  std::vector<char> seen(quads.size(), false);
  std::vector<std::size_t> stack{0};
  seen[0] = true;
  while (!stack.empty()) {
    const Quad& quad = quads[stack.back()];
    stack.pop_back();
    for (int k = 0; k < 4; ++k) {
      const auto across = edges.find({quad.next(k), quad.vertex[k]});
      if (across == edges.end()) continue;
      const std::size_t neighbour = across->second.quad;
      if (!seen[neighbour]) stack.push_back(neighbour);
      seen[neighbour] = true;
    }
  }
  return std::find(seen.begin(), seen.end(), false) == seen.end();
}

// the number of quads on the circle round the beginning of an edge, or up to the boundary
std::size_t quads_around(const Quad_edges& edges, const std::pair<std::size_t, std::size_t>& edge)
{
  std::size_t n = 0, to = edge.second;
  do {
    const auto quad = edges.find({edge.first, to});
    if (quad == edges.end()) return n;
    to = quad->second.before;
    ++n;
  } while (to != edge.second);
  return n;
}

bool is_border(const Quad_edges& edges, const std::pair<std::size_t, std::size_t>& edge)
{ return edges.count({edge.second, edge.first}) == 0; }

// the beginnings of boundary edges, each with the end, which is the next; one of them at a vertex with several
std::map<std::size_t, std::size_t> next_on_boundary(const Quad_edges& edges)
{
  std::map<std::size_t, std::size_t> next;
  for (const auto& [ends, edge] : edges)
    if (is_border(edges, ends)) next.insert(ends);
  return next;
}

// the curves that these make up
std::size_t number_of_curves(std::map<std::size_t, std::size_t> next)
{
  std::size_t n = 0;
  while (!next.empty()) {
    ++n;
    for (auto at = next.begin(); at != next.end(); ) {
      const std::size_t to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return n;
}

// The quads of a patch are listed row by row, from left to right: do they fit in rows of this width?
bool is_grid(const std::vector<Quad>& patch, std::size_t width)
{
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const auto& [a, b, c, d] = patch[i].vertex;
    if ((i + 1) % width != 0 && (patch[i + 1].vertex[0] != b || patch[i + 1].vertex[3] != c)) return false;
    if (i + width < patch.size() && (patch[i + width].vertex[0] != d || patch[i + width].vertex[1] != c)) return false;
  }
  return true;
}

bool is_grid(const std::vector<Quad>& patch)
{
  for (std::size_t width = 1; width <= patch.size(); ++width)
    if (patch.size() % width == 0 && is_grid(patch, width)) return true;
  return false;
}

// The least sine of its angles, seen along the cross product of its diagonals; 0 where that or a side vanishes.
double scaled_jacobian(const Quads_obj& obj, const Quad& quad)
{
  const auto point = [&](int k) { return point_3(obj.points[quad.vertex[k % 4]]); };
  const Vector_3 normal = CGAL::cross_product(point(2) - point(0), point(3) - point(1));
  double least = 1;
  for (int k = 0; k < 4; ++k) {
    const Vector_3 right = point(k + 1) - point(k), left = point(k + 3) - point(k);
    const double volume = CGAL::scalar_product(CGAL::cross_product(right, left), normal);
    const double size = std::sqrt(right.squared_length()) * std::sqrt(left.squared_length())
                      * std::sqrt(normal.squared_length());
    least = std::min(least, size > 0 ? volume / size : 0);
  }
  return least;
}

void verify_quad_shapes(const Quads_obj& obj, const Quads_report& report, const Mesh* input, Checks& checks)
{
  double least = 1;
  for (const Quad& quad : obj.quads) least = std::min(least, scaled_jacobian(obj, quad));
  checks.push_back({std::abs(least - report.least_jacobian) <= 1e-12,
                    "quads.obj: the least scaled Jacobian is that of the report, up to "
                    + scientific(std::abs(least - report.least_jacobian))});
  if (input == nullptr) return;
  const Surface_tree tree(input->faces().begin(), input->faces().end(), *input);
  const double size = diagonal(tree.bbox());
  double farthest = 0;
  for (const Position& p : obj.points) farthest = std::max(farthest, std::sqrt(tree.squared_distance(point_3(p))));
  checks.push_back({farthest <= 1e-9 * size, "quads.obj: vertices lie on the input, within "
                                           + scientific(farthest / size) + " of its diagonal"});
}

void verify_quad_boundary(const Quads_obj& obj, const Quad_edges& edges, const Mesh& input, Checks& checks)
{
  const Segments expected = boundary_of(input);
  std::vector<Point_3> points;
  for (const auto& [v, next] : next_on_boundary(edges)) points.push_back(point_3(obj.points[v]));
  CGAL::Bbox_3 box;
  for (Vertex v : input.vertices()) box += input.point(v).bbox();
  const bool both = !expected.empty() && !points.empty();
  const double farthest = both ? farthest_from(expected, points) / diagonal(box) : 0;
  checks.push_back({both && farthest <= 1e-9, "quads.obj: its boundary vertices lie on the input's boundary, within "
                                            + scientific(farthest) + " of its diagonal"});
}

void verify_quad_surface(const Quads_obj& obj, const Report& report, const Mesh* input, Checks& checks)
{
  const std::optional<Quad_edges> edges = quad_edges(obj.quads, report.is_closed());
  const std::string shared = report.is_closed() ? "every edge is shared by two quads"
                                                : "no edge is shared by more than two quads";
  checks.push_back({edges.has_value(), "quads.obj: " + shared + ", in opposite directions, and no two edges have the "
                                       "same ends"});
  if (!edges) return;
  std::vector<std::int64_t> valence(obj.points.size(), 0);
  for (const Quad& quad : obj.quads)
    for (std::size_t v : quad.vertex) ++valence[v];
  const std::map<std::size_t, std::size_t> boundary = next_on_boundary(*edges);
  const std::string circle = report.is_closed() ? "one circle" : "one circle, or one fan on the boundary";
  checks.push_back({is_connected(obj.quads, *edges), "quads.obj: one component"});
  checks.push_back({std::all_of(edges->begin(), edges->end(), [&](const auto& edge) {
                      const auto& ends = edge.first;
                      const std::size_t n = static_cast<std::size_t>(valence[ends.first]);
                      const bool in_fan = boundary.count(ends.first) == 1 && !is_border(*edges, ends);
                      return in_fan || quads_around(*edges, ends) == n;   // round the vertex, from the fan's beginning
                    }), "quads.obj: the quads round every vertex form " + circle});
  // V - E + F, where 4 F counts edges inside twice and those of the boundary once
  const std::size_t number_of_edges = (4 * obj.quads.size() + boundary.size()) / 2;
  const std::int64_t chi = static_cast<std::int64_t>(obj.points.size()) - static_cast<std::int64_t>(number_of_edges)
                         + static_cast<std::int64_t>(obj.quads.size());
  checks.push_back({chi == report.euler_characteristic(),
                    "quads.obj: Euler characteristic " + std::to_string(chi) + " = " + euler_text(report)});
  std::vector<std::int64_t> inside, on_boundary;
  for (std::size_t v = 0; v < valence.size(); ++v)
    (boundary.count(v) == 1 ? on_boundary : inside).push_back(valence[v]);
  const std::vector<std::int64_t> orders = orders_of(inside, 4), corner_orders = orders_of(on_boundary, 2);
  checks.push_back({orders == report.orders, "quads.obj: " + std::to_string(orders.size())
                                           + " irregular vertices are exactly the singularities"});
  if (report.is_closed()) return;
  const std::size_t curves = number_of_curves(boundary);
  checks.push_back({curves == number_of_curves(report), "quads.obj: " + curves_text(curves)});
  checks.push_back({corner_orders == report.corner_orders,
                    "quads.obj: " + std::to_string(corner_orders.size())
                    + " irregular vertices of the boundary are exactly the corners"});
  if (input != nullptr) verify_quad_boundary(obj, *edges, *input, checks);
}

void verify_quad_patches(const Quads_obj& obj, const Quads_report& report, const Ids& patch_ids, Checks& checks)
{
  std::map<std::int64_t, std::vector<Quad>> patches;
  for (const Quad& quad : obj.quads) patches[quad.patch].push_back(quad);
  const auto all = [&](auto holds) { return std::all_of(patches.begin(), patches.end(), holds); };
  checks.push_back({all([&](const auto& patch) { return patch_ids.count(patch.first) == 1; }),
                    "quads.obj: groups are patches of the T-mesh"});
  checks.push_back({static_cast<std::int64_t>(patches.size()) == report.patches,
                    "quads.obj: " + std::to_string(patches.size()) + " patches have quads, as many as in the report"});
  checks.push_back({all([](const auto& patch) { return is_grid(patch.second); }),
                    "quads.obj: the quads of every patch are a regular grid"});
}

} // namespace

void verify_quads(const std::string& folder, const Report& report, const Ids& patch_ids, const Mesh* input,
                  Checks& checks)
{
  const Quads_obj obj = read_quads(folder);
  checks.push_back({report.quads.has_value(), "quads.obj: the report says that there are quads"});
  if (!report.quads) return;
  checks.push_back({static_cast<std::int64_t>(obj.quads.size()) == report.quads->quads
                    && static_cast<std::int64_t>(obj.points.size()) == report.quads->vertices,
                    "quads.obj: " + std::to_string(obj.quads.size()) + " quads, " + std::to_string(obj.points.size())
                    + " vertices, as in the report"});
  checks.push_back({std::all_of(obj.quads.begin(), obj.quads.end(), [](const Quad& quad) {
                      std::array<std::size_t, 4> v = quad.vertex;
                      std::sort(v.begin(), v.end());
                      return std::adjacent_find(v.begin(), v.end()) == v.end();
                    }), "quads.obj: no quad has a vertex twice"});
  verify_quad_surface(obj, report, input, checks);
  verify_quad_patches(obj, *report.quads, patch_ids, checks);
  verify_quad_shapes(obj, *report.quads, input, checks);
}

} } } // namespace CGAL::Quartic_differentials::verification
