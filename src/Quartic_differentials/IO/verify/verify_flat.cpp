// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify_flat.h"

#include <algorithm>
#include <numeric>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

namespace {

bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }

// Coordinates are at most 2^60, differences at most 2^61: products and their differences fit.
__int128 cross(Point a, Point b) { return static_cast<__int128>(a.x) * b.y - static_cast<__int128>(a.y) * b.x; }

Corner read_opposite(const Json& glued, std::int64_t last_triangle, bool may_be_none, const std::string& name)
{
  array_of_size(glued, 2, "an opposite of " + name);
  if (may_be_none && glued == Json{-1, -1}) return {};
  return {integer(glued[0], 0, last_triangle, "an opposite triangle of " + name),
          static_cast<int>(integer(glued[1], 0, 2, "an opposite edge of " + name))};
}

bool is_gluing(const Flat& flat)
{
  for (std::size_t t = 0; t < flat.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Flat_triangle& here = flat.triangles[t];
      if (here.is_border(k)) continue;
      const auto [u, j] = here.opposite[k];
      const Flat_triangle& there = flat.triangles[u];
      const bool is_itself = static_cast<std::size_t>(u) == t && j == k;
      const bool is_mutual = static_cast<std::size_t>(there.opposite[j].triangle) == t && there.opposite[j].index == k;
      if (is_itself || !is_mutual) return false;
      if (here.vertex[k] != there.vertex[(j + 1) % 3] || here.vertex[(k + 1) % 3] != there.vertex[j]) return false;
    }
  return true;
}

bool is_connected(const Flat& flat)
{
  std::vector<char> seen(flat.triangles.size(), false);
  std::vector<std::int64_t> stack{0};
  seen[0] = true;
  while (!stack.empty()) {
    const Flat_triangle& f = flat.triangles[stack.back()];
    stack.pop_back();
    for (const Corner& o : f.opposite)
      if (o.triangle >= 0 && !seen[o.triangle]) {
        seen[o.triangle] = true;
        stack.push_back(o.triangle);
      }
  }
  return std::find(seen.begin(), seen.end(), false) == seen.end();
}

std::int64_t number_of_vertices(const Flat& flat)
{
  std::vector<std::int64_t> used;
  for (const Flat_triangle& f : flat.triangles) used.insert(used.end(), f.vertex.begin(), f.vertex.end());
  std::sort(used.begin(), used.end());
  return std::unique(used.begin(), used.end()) - used.begin();
}

// How many of the directions 1, i, -1, -i lie in a corner, its right side included: one for every 90 degrees of a cone.
int axes_in_corner(const Flat_triangle& f, int k)
{
  const Point right = f.edge(k), left = f.point[(k + 2) % 3] - f.point[k];
  int n = 0;
  for (const Point axis : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}})
    if (cross(right, axis) >= 0 && cross(axis, left) > 0) ++n;
  return n;
}

// The edge after one of the boundary. \pre is_gluing(flat)
Corner next_on_boundary(const Flat& flat, Corner edge)
{
  Corner c{edge.triangle, (edge.index + 1) % 3};
  while (!flat.triangles[c.triangle].is_border(c.index)) {
    const Corner across = flat.triangles[c.triangle].opposite[c.index];
    c = {across.triangle, (across.index + 1) % 3};
  }
  return c;
}

// the edges of the boundary, curve by curve. \pre is_gluing(flat)
std::vector<std::vector<Corner>> boundary_curves(const Flat& flat)
{
  std::vector<std::array<char, 3>> seen(flat.triangles.size(), {false, false, false});
  std::vector<std::vector<Corner>> curves;
  for (std::size_t t = 0; t < flat.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (!flat.triangles[t].is_border(k) || seen[t][k]) continue;
      curves.emplace_back();
      for (Corner c{static_cast<std::int64_t>(t), k}; !seen[c.triangle][c.index]; c = next_on_boundary(flat, c)) {
        seen[c.triangle][c.index] = true;
        curves.back().push_back(c);
      }
    }
  return curves;
}

// Angles round the vertices, in units of 90 degrees: exactly, if transitions and the boundary are.
struct Cone_angles
{
  std::vector<std::int64_t> inside, on_boundary;

  std::int64_t number_of_vertices() const { return static_cast<std::int64_t>(inside.size() + on_boundary.size()); }
};

// of every fan of corners that begins with a boundary edge, then of every circle. \pre is_gluing(flat)
Cone_angles cone_angles(const Flat& flat)
{
  std::vector<std::array<char, 3>> seen(flat.triangles.size(), {false, false, false});
  const auto round = [&](Corner c) {
    std::int64_t quarters = 0;
    while (c.triangle >= 0 && !seen[c.triangle][c.index]) {
      seen[c.triangle][c.index] = true;
      quarters += axes_in_corner(flat.triangles[c.triangle], c.index);
      c = flat.triangles[c.triangle].opposite[(c.index + 2) % 3];
    }
    return quarters;
  };
  Cone_angles angles;
  for (const auto& curve : boundary_curves(flat))
    for (Corner c : curve) angles.on_boundary.push_back(round(c));
  for (std::size_t t = 0; t < flat.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!seen[t][k]) angles.inside.push_back(round({static_cast<std::int64_t>(t), k}));
  return angles;
}

// the number of halfedges, two for every edge
std::size_t inexact_transitions(const Flat& flat)
{
  std::size_t n = 0;
  for (const Flat_triangle& f : flat.triangles)
    for (int k = 0; k < 3; ++k) {
      if (f.is_border(k)) continue;
      const Point d = f.edge(k);
      const Point e = Point{0, 0} - flat.triangles[f.opposite[k].triangle].edge(f.opposite[k].index);
      if (!(e == d || e == Point{-d.y, d.x} || e == Point{-d.x, -d.y} || e == Point{d.y, -d.x})) ++n;
    }
  return n;
}

// boundary edges that are not exactly horizontal or vertical
std::size_t slanted_border_edges(const Flat& flat)
{
  std::size_t n = 0;
  for (const Flat_triangle& f : flat.triangles)
    for (int k = 0; k < 3; ++k) n += f.is_border(k) && f.edge(k).x != 0 && f.edge(k).y != 0;
  return n;
}

void verify_boundary(const std::string& name, const Flat& flat, const Report& report, Checks& checks)
{
  const std::size_t slanted = slanted_border_edges(flat), curves = boundary_curves(flat).size();
  checks.push_back({curves == number_of_curves(report), name + ": " + curves_text(curves)});
  checks.push_back({slanted == 0, name + ": " + std::to_string(slanted) + " of "
                                + std::to_string(number_of_border_edges(flat))
                                + " boundary edges are not parallel to an axis (exact)"});
}

void verify_cones(const std::string& name, const Flat& flat, const Report& report, Flat_facts& facts, Checks& checks)
{
  const Cone_angles angles = cone_angles(flat);
  checks.push_back({angles.number_of_vertices() == number_of_vertices(flat),
                    name + ": the triangles round every vertex form one circle"
                    + (report.is_closed() ? "" : ", or one fan on the boundary")});
  facts.orders = orders_of(angles.inside, 4);
  facts.corner_orders = orders_of(angles.on_boundary, 2);
  const std::int64_t degree = std::accumulate(facts.orders.begin(), facts.orders.end(), std::int64_t(0))
                            + std::accumulate(facts.corner_orders.begin(), facts.corner_orders.end(), std::int64_t(0));
  const std::string corners = report.is_closed() ? "" : std::to_string(facts.corner_orders.size()) + " corners, ";
  checks.push_back({degree == report.degree(),
                    name + ", cones: " + std::to_string(facts.orders.size()) + " singularities, " + corners + "degree "
                    + std::to_string(degree) + " = " + degree_text(report)});
  checks.push_back({facts.orders == report.orders, name + ", cones: orders match the report"});
  if (!report.is_closed() || !report.corner_orders.empty())
    checks.push_back({facts.corner_orders == report.corner_orders, name + ", corners: their angles match the report"});
}

} // namespace

Flat read_flat(const std::string& folder, bool is_closed)
{
  const Json json = read_json(folder, "flat_intrinsic.json");
  Flat flat;
  const Json& exponent = member(json, "grid_exponent");
  flat.grid_exponent = static_cast<int>(integer(exponent, 0, largest_grid_exponent, "grid_exponent"));
  const Json& vertices = array(member(json, "vertices"), "vertices");
  const Json& triangles = array(member(json, "triangles"), "triangles");
  const std::size_t n = triangles.size();
  const Json& uv = array_of_size(member(json, "uv"), n, "uv");
  const Json& opposite = array_of_size(member(json, "opposite"), n, "opposite");
  if (n == 0 || (is_closed && n % 2 != 0) || n > static_cast<std::size_t>(most_items / 6))
    throw Malformed(std::to_string(n) + " triangles cannot make a " + (is_closed ? "closed surface" : "surface"));
  for (const Json& v : vertices) position(v, "the position of a vertex");
  flat.is_embedded = !vertices.empty();

  const std::int64_t largest = std::int64_t(1) << 60;
  const std::int64_t last_vertex = static_cast<std::int64_t>(vertices.empty() ? 3 * n : vertices.size()) - 1;
  const std::int64_t last_triangle = static_cast<std::int64_t>(n) - 1;
  flat.triangles.resize(n);
  for (std::size_t t = 0; t < n; ++t) {
    const std::string name = "triangle " + std::to_string(t);
    Flat_triangle& f = flat.triangles[t];
    array_of_size(triangles[t], 3, name);
    array_of_size(uv[t], 6, "uv of " + name);
    array_of_size(opposite[t], 3, "opposite of " + name);
    for (int k = 0; k < 3; ++k) {
      f.vertex[k] = integer(triangles[t][k], 0, last_vertex, "a vertex of " + name);
      f.point[k].x = integer(uv[t][2 * k], -largest, largest, "a coordinate of " + name);
      f.point[k].y = integer(uv[t][2 * k + 1], -largest, largest, "a coordinate of " + name);
      f.opposite[k] = read_opposite(opposite[t][k], last_triangle, !is_closed, name);
    }
  }
  return flat;
}

std::size_t number_of_border_edges(const Flat& flat)
{
  std::size_t n = 0;
  for (const Flat_triangle& f : flat.triangles)
    for (int k = 0; k < 3; ++k) n += f.is_border(k);
  return n;
}

std::vector<std::int64_t> orders_of(const std::vector<std::int64_t>& angles, std::int64_t usual)
{
  std::vector<std::int64_t> orders;
  for (std::int64_t quarters : angles)
    if (quarters != usual) orders.push_back(quarters - usual);
  std::sort(orders.begin(), orders.end());
  return orders;
}

Flat_facts verify_flat(const std::string& name, const Flat& flat, const Report& report, Checks& checks)
{
  const std::size_t n = flat.triangles.size();
  Flat_facts facts;
  facts.grid_exponent = flat.grid_exponent;
  facts.is_embedded = flat.is_embedded;
  std::size_t flips = 0;
  for (const Flat_triangle& f : flat.triangles) {
    const __int128 area = cross(f.edge(0), f.point[2] - f.point[0]);
    facts.doubled_area += Integer(area);
    if (area <= 0) ++flips;
  }
  const bool glued = is_gluing(flat);
  checks.push_back({glued, name + ": gluing is an orientation-reversing involution that respects the vertices"});
  checks.push_back({is_connected(flat), name + ": one component"});
  // V - E + F, where 3 F counts edges inside twice and those of the boundary once
  const std::size_t edges = (3 * n + number_of_border_edges(flat)) / 2;
  const std::int64_t chi = number_of_vertices(flat) - static_cast<std::int64_t>(edges) + static_cast<std::int64_t>(n);
  checks.push_back({chi == report.euler_characteristic(), name + ": Euler characteristic " + std::to_string(chi) + " = "
                                                        + euler_text(report)});
  checks.push_back({flips == 0, name + ": " + std::to_string(flips) + " of " + std::to_string(n)
                              + " triangles flipped or degenerate (exact)"});
  const std::size_t inexact = inexact_transitions(flat);
  checks.push_back({inexact == 0, name + ": " + std::to_string(inexact / 2)
                                + " edges are not an exact rotation by k*90 deg"});
  if (!glued) return facts;
  if (!report.is_closed()) verify_boundary(name, flat, report, checks);
  verify_cones(name, flat, report, facts, checks);
  return facts;
}

} } } // namespace CGAL::Quartic_differentials::verification
