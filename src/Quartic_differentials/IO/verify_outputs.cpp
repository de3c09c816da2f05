// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/verify_outputs.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/aabb_tree.h>
#include <CGAL/Quartic_differentials/internal/read_obj.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Json    = nlohmann::json;
using Integer = boost::multiprecision::cpp_int;
using Checks  = std::vector<Verification>;
using internal::scientific;

// ---- Reading: everything that comes from a file passes through these functions

// The file is missing or not of the form it should be.
struct Malformed : Error { using Error::Error; };

bool has_file(const std::string& folder, const std::string& name)
{
  std::error_code error;
  return std::filesystem::is_regular_file(folder + "/" + name, error);   // a pipe might never end
}

Json read_json(const std::string& folder, const std::string& name)
{
  if (!has_file(folder, name)) throw Malformed("the file cannot be opened");
  std::ifstream in(folder + "/" + name);
  try { return Json::parse(in); }
  catch (const Json::exception&) { throw Malformed("the file is not JSON, or cut off"); }
}

const Json& member(const Json& object, const char* key)
{
  if (!object.is_object() || !object.contains(key)) throw Malformed(std::string("\"") + key + "\" is missing");
  return object[key];
}

const Json& array(const Json& value, const std::string& what)
{
  if (!value.is_array()) throw Malformed(what + " is not an array");
  return value;
}

const Json& array_of_size(const Json& value, std::size_t size, const std::string& what)
{
  if (array(value, what).size() != size) throw Malformed(what + " does not have " + std::to_string(size) + " entries");
  return value;
}

std::int64_t integer(const Json& value, std::int64_t least, std::int64_t greatest, const std::string& what)
{
  if (!value.is_number_integer()) throw Malformed(what + " is not an integer of 64 bits");
  const bool beyond = value.is_number_unsigned()
                   && value.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (beyond || value.get<std::int64_t>() < least || value.get<std::int64_t>() > greatest)
    throw Malformed(what + " is out of range");
  return value.get<std::int64_t>();
}

std::string string(const Json& value, const std::string& what)
{
  if (!value.is_string()) throw Malformed(what + " is not a string");
  return value.get<std::string>();
}

using Position = std::array<double, 3>;

Position position(const Json& value, const std::string& what)
{
  Position p;
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& x = array_of_size(value, 3, what)[k];
    if (!x.is_number() || !std::isfinite(x.get<double>())) throw Malformed(what + " is not three finite numbers");
    p[k] = x.get<double>();
  }
  return p;
}

const std::int64_t most_items = std::numeric_limits<std::int32_t>::max();
const int          largest_grid_exponent = 62;

// ---- report.json

struct Quads_report
{
  std::int64_t quads = 0, vertices = 0, patches = 0;
  double       least_jacobian = 0;
};

struct Report
{
  std::int64_t                genus = 0, boundary_curves = 0;
  std::vector<std::int64_t>   orders;          // of singularities, sorted
  std::vector<std::int64_t>   corner_orders;   // two less than the quads at a corner of the boundary, sorted
  std::optional<Quads_report> quads;

  bool         is_closed() const { return boundary_curves == 0; }
  std::int64_t euler_characteristic() const { return 2 - 2 * genus - boundary_curves; }
  std::int64_t degree() const { return 8 * genus - 8 + 4 * boundary_curves; }
};

// The formulas, as they are said
std::string euler_text(const Report& report) { return report.is_closed() ? "2-2g" : "2-2g-b"; }
std::string degree_text(const Report& report) { return report.is_closed() ? "8g-8" : "8g-8+4b"; }

std::string curves_text(std::size_t n)
{ return std::to_string(n) + (n == 1 ? " boundary curve" : " boundary curves") + ", as in the report"; }

std::size_t number_of_curves(const Report& report) { return static_cast<std::size_t>(report.boundary_curves); }

Quads_report read_quads_report(const Json& json)
{
  Quads_report quads;
  quads.quads = integer(member(json, "quads"), 0, most_items, "quad_mesh.quads");
  quads.vertices = integer(member(json, "vertices"), 0, most_items, "quad_mesh.vertices");
  quads.patches = integer(member(json, "patches"), 0, most_items, "quad_mesh.patches");
  const Json& least = member(member(json, "scaled_jacobian"), "min");
  if (!least.is_number()) throw Malformed("quad_mesh.scaled_jacobian.min is not a number");
  quads.least_jacobian = least.get<double>();
  return quads;
}

// \return the order
std::int64_t read_corner(const Json& json)
{
  const std::int64_t order = integer(member(json, "order"), -1, most_items, "the order of a corner");
  if (integer(member(json, "quads"), 1, most_items, "the quads of a corner") != order + 2)
    throw Malformed("the number of quads at a corner is not its order + 2");
  return order;
}

Report read_report(const std::string& folder)
{
  const Json json = read_json(folder, "report.json");
  Report report;
  const Json& input = member(json, "input");
  report.genus = integer(member(input, "genus"), 0, most_items, "input.genus");
  if (input.contains("boundary")) report.boundary_curves = integer(input["boundary"], 0, most_items, "input.boundary");
  for (const Json& s : array(member(json, "singularities"), "singularities"))
    report.orders.push_back(integer(member(s, "order"), -3, most_items, "the order of a singularity"));
  if (!report.is_closed() || json.contains("corners"))
    for (const Json& c : array(member(json, "corners"), "corners")) report.corner_orders.push_back(read_corner(c));
  std::sort(report.orders.begin(), report.orders.end());
  std::sort(report.corner_orders.begin(), report.corner_orders.end());
  if (json.contains("quad_mesh")) report.quads = read_quads_report(json["quad_mesh"]);
  return report;
}

// ---- flat_intrinsic.json

struct Point { std::int64_t x, y; };

Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }

// Coordinates are at most 2^60, differences at most 2^61: products and their differences fit.
__int128 cross(Point a, Point b) { return static_cast<__int128>(a.x) * b.y - static_cast<__int128>(a.y) * b.x; }

struct Corner { std::int64_t triangle = -1; int index = -1; };   // also an edge: the one that begins there

struct Flat_triangle
{
  std::array<std::int64_t, 3> vertex;
  std::array<Point, 3>        point;
  std::array<Corner, 3>       opposite;   // on the boundary none

  Point edge(int k) const { return point[(k + 1) % 3] - point[k]; }
  bool  is_border(int k) const { return opposite[k].triangle < 0; }
};

struct Flat
{
  int                        grid_exponent = 0;
  bool                       is_embedded = false;
  std::vector<Flat_triangle> triangles;
};

Corner read_opposite(const Json& glued, std::int64_t last_triangle, bool may_be_none, const std::string& name)
{
  array_of_size(glued, 2, "an opposite of " + name);
  if (may_be_none && glued == Json{-1, -1}) return {};
  return {integer(glued[0], 0, last_triangle, "an opposite triangle of " + name),
          static_cast<int>(integer(glued[1], 0, 2, "an opposite edge of " + name))};
}

Flat read_flat(const std::string& folder, bool is_closed)
{
  const Json json = read_json(folder, "flat_intrinsic.json");
  Flat flat;
  flat.grid_exponent = static_cast<int>(integer(member(json, "grid_exponent"), 0, largest_grid_exponent, "grid_exponent"));
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

// angles less the usual one, without 0, sorted
std::vector<std::int64_t> orders_of(const std::vector<std::int64_t>& angles, std::int64_t usual)
{
  std::vector<std::int64_t> orders;
  for (std::int64_t quarters : angles)
    if (quarters != usual) orders.push_back(quarters - usual);
  std::sort(orders.begin(), orders.end());
  return orders;
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

std::size_t number_of_border_edges(const Flat& flat)
{
  std::size_t n = 0;
  for (const Flat_triangle& f : flat.triangles)
    for (int k = 0; k < 3; ++k) n += f.is_border(k);
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

struct Flat_facts
{
  Integer                   doubled_area;   // in squared grid units
  int                       grid_exponent = 0;
  bool                      is_embedded = false;
  std::vector<std::int64_t> orders, corner_orders;   // sorted, without 0
};

void verify_boundary(const std::string& name, const Flat& flat, const Report& report, Checks& checks)
{
  const std::size_t slanted = slanted_border_edges(flat), curves = boundary_curves(flat).size();
  checks.push_back({curves == number_of_curves(report), name + ": " + curves_text(curves)});
  checks.push_back({slanted == 0, name + ": " + std::to_string(slanted) + " of " + std::to_string(number_of_border_edges(flat))
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
  checks.push_back({degree == report.degree(), name + ", cones: " + std::to_string(facts.orders.size()) + " singularities, "
                                             + corners + "degree " + std::to_string(degree) + " = " + degree_text(report)});
  checks.push_back({facts.orders == report.orders, name + ", cones: orders match the report"});
  if (!report.is_closed() || !report.corner_orders.empty())
    checks.push_back({facts.corner_orders == report.corner_orders, name + ", corners: their angles match the report"});
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

// ---- flat.obj

// The triangles of flat.obj, and its points in space.
struct Flat_obj
{
  Flat                  flat;
  std::vector<Position> points;
};

// a texture coordinate, in units of 2^-exponent
std::int64_t grid_coordinate(double x, int exponent)
{
  const double scaled = std::ldexp(x, exponent);
  if (!(std::abs(scaled) <= std::ldexp(1.0, 60)) || scaled != std::floor(scaled))
    throw Malformed("a texture coordinate is not on the grid of 2^-" + std::to_string(exponent));
  return static_cast<std::int64_t>(scaled);
}

// Glues triangles that share two vertices in opposite directions; returns whether no edge found more than one partner, and
// all found one if the surface is closed.
bool glue(std::vector<Flat_triangle>& triangles, bool is_closed)
{
  std::vector<std::tuple<std::int64_t, std::int64_t, std::int64_t, int>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      edges.emplace_back(triangles[t].vertex[k], triangles[t].vertex[(k + 1) % 3], static_cast<std::int64_t>(t), k);
  std::sort(edges.begin(), edges.end());
  const auto has_ends = [&](auto edge, std::int64_t from, std::int64_t to) {
    return edge != edges.end() && std::get<0>(*edge) == from && std::get<1>(*edge) == to;
  };
  for (auto edge = edges.begin(); edge != edges.end(); ++edge) {
    const auto& [from, to, t, k] = *edge;
    if (has_ends(std::next(edge), from, to)) return false;
    const auto partner = std::lower_bound(edges.begin(), edges.end(), std::make_tuple(to, from, std::int64_t(-1), -1));
    if (has_ends(partner, to, from)) triangles[t].opposite[k] = {std::get<2>(*partner), std::get<3>(*partner)};
    else if (is_closed) return false;
  }
  return true;
}

Flat_obj read_flat_obj(const std::string& folder, int grid_exponent)
{
  const internal::Obj_file file = internal::read_obj(folder + "/flat.obj");
  Flat_obj obj;
  obj.flat.grid_exponent = grid_exponent;
  obj.flat.is_embedded = true;
  for (const Point_3& p : file.points) obj.points.push_back({p.x(), p.y(), p.z()});
  std::vector<Point> texture;
  for (const auto& [u, v] : file.texture)
    texture.push_back({grid_coordinate(u, grid_exponent), grid_coordinate(v, grid_exponent)});
  for (const internal::Obj_file::Element& face : file.faces) {
    if (face.vertices.size() != 3) throw Malformed("a face is not a triangle");
    if (face.texture.size() != 3) throw Malformed("a corner of a face has no texture vertex");
    Flat_triangle& f = obj.flat.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      f.vertex[k] = static_cast<std::int64_t>(face.vertices[k]);
      f.point[k] = texture[face.texture[k]];
    }
  }
  if (obj.flat.triangles.empty()) throw Malformed("there is no triangle");
  return obj;
}

using Kernel        = CGAL::Simple_cartesian<double>;
using Segments      = std::vector<Kernel::Segment_3>;
using Boundary_tree = internal::Segment_tree<Segments::const_iterator>;

Point_3 point_3(const Position& p) { return {p[0], p[1], p[2]}; }

double diagonal(const CGAL::Bbox_3& box)
{ return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()); }

Segments boundary_of(const Mesh& mesh)
{
  Segments segments;
  for (Halfedge h : mesh.halfedges())
    if (mesh.is_border(h)) segments.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  return segments;
}

double total_length(const Segments& segments)
{
  double length = 0;
  for (const Kernel::Segment_3& s : segments) length += std::sqrt(s.squared_length());
  return length;
}

double farthest_from(const Segments& segments, const std::vector<Point_3>& points)
{
  const Boundary_tree tree(segments.begin(), segments.end());
  double farthest = 0;
  for (const Point_3& p : points) farthest = std::max(farthest, std::sqrt(tree.squared_distance(p)));
  return farthest;
}

// The boundary lies on that of the input and covers it.
void verify_boundary_on_input(const Flat_obj& obj, const Mesh& input, double size, Checks& checks)
{
  const Segments expected = boundary_of(input);
  Segments segments;
  std::vector<Point_3> points;
  for (const Flat_triangle& f : obj.flat.triangles)
    for (int k = 0; k < 3; ++k) {
      if (!f.is_border(k)) continue;
      const Point_3 from = point_3(obj.points[f.vertex[k]]), to = point_3(obj.points[f.vertex[(k + 1) % 3]]);
      segments.emplace_back(from, to);
      points.insert(points.end(), {from, CGAL::midpoint(from, to)});
    }
  const bool both = !expected.empty() && !segments.empty();
  const double farthest = both ? farthest_from(expected, points) : 0, length = total_length(expected);
  checks.push_back({both && farthest <= 1e-12 * size, "flat.obj: its boundary lies on the input's, within "
                                                    + scientific(farthest / size) + " of its diagonal"});
  checks.push_back({both && std::abs(total_length(segments) - length) <= 1e-9 * length,
                    "flat.obj: its boundary is as long as the input's"});
}

// The triangles lie on the input and cover it.
void verify_on_input(const Flat_obj& obj, const Mesh& input, Checks& checks)
{
  std::size_t moved = 0;
  const std::size_t n = std::min<std::size_t>(obj.points.size(), input.number_of_vertices());
  for (std::size_t v = 0; v < n; ++v)
    if (input.point(Vertex(static_cast<Mesh::size_type>(v))) != point_3(obj.points[v])) ++moved;
  moved += input.number_of_vertices() - n;
  checks.push_back({moved == 0, "flat.obj: " + std::to_string(moved) + " of " + std::to_string(input.number_of_vertices())
                              + " vertices of the input are missing or have moved (exact)"});

  const internal::Face_tree<Mesh> tree(input.faces().begin(), input.faces().end(), input);
  const double size = diagonal(tree.bbox());
  double farthest = 0, area = 0, input_area = 0;
  const auto look = [&](const Point_3& p) { farthest = std::max(farthest, std::sqrt(tree.squared_distance(p))); };
  for (std::size_t v = n; v < obj.points.size(); ++v) look(point_3(obj.points[v]));
  for (const Flat_triangle& f : obj.flat.triangles) {
    const Point_3 a = point_3(obj.points[f.vertex[0]]), b = point_3(obj.points[f.vertex[1]]),
                  c = point_3(obj.points[f.vertex[2]]);
    look(CGAL::centroid(a, b, c));
    area += std::sqrt(CGAL::squared_area(a, b, c));
  }
  for (Face f : input.faces()) {
    const Halfedge h = input.halfedge(f);
    input_area += std::sqrt(CGAL::squared_area(input.point(input.source(h)), input.point(input.target(h)),
                                               input.point(input.target(input.next(h)))));
  }
  checks.push_back({farthest <= 1e-12 * size, "flat.obj: lies on the input, within " + scientific(farthest / size)
                                            + " of its diagonal"});
  checks.push_back({std::abs(area - input_area) <= 1e-9 * input_area, "flat.obj: covers the input's area up to "
                                                                    + scientific(std::abs(area - input_area) / input_area)});
  if (number_of_border_edges(obj.flat) > 0 || !CGAL::is_closed(input)) verify_boundary_on_input(obj, input, size, checks);
}

void verify_flat_obj(Flat_obj obj, const Flat_facts& flat, const Report& report, const Mesh* input, Checks& checks)
{
  const bool glued = glue(obj.flat.triangles, report.is_closed());
  checks.push_back({glued, report.is_closed() ? "flat.obj: every edge is shared by two triangles, in opposite directions"
                                              : "flat.obj: no edge is shared by more than two triangles, in opposite directions"});
  if (!glued) return;
  const Flat_facts facts = verify_flat("flat.obj", obj.flat, report, checks);
  checks.push_back({facts.doubled_area == flat.doubled_area, "flat.obj: exactly the area of the flat triangulation"});
  if (input != nullptr) verify_on_input(obj, *input, checks);
}

// ---- tmesh.json

struct Node
{
  std::string             kind;
  std::int64_t            order = 0;
  std::optional<Position> position;
  std::int64_t            arms = 0, corners = 0;
  std::int64_t            boundary_begins = 0, boundary_ends = 0;   // of arcs of the boundary

  bool is_on_boundary() const { return boundary_begins > 0; }
};

struct Arc
{
  std::size_t                                from = 0, to = 0;
  std::int64_t                               length = 0;
  std::optional<std::pair<Position, Position>> ends;   // of the polyline
  std::int64_t                               forward_uses = 0, backward_uses = 0;

  bool is_on_boundary() const { return forward_uses == 1 && backward_uses == 0; }
};

struct Side_piece { std::size_t arc; bool forward; };

struct Patch
{
  std::int64_t                           width = 0, height = 0;
  std::array<std::vector<Side_piece>, 4> sides;
};

// the places of a list's items by their "id"
using Ids = std::map<std::int64_t, std::size_t>;

struct Tmesh
{
  int                grid_exponent = 0;
  std::vector<Node>  nodes;
  std::vector<Arc>   arcs;
  std::vector<Patch> patches;
  Ids                patch_ids;
};

const std::int64_t largest_integer = std::numeric_limits<std::int64_t>::max();

Ids read_ids(const Json& items, const std::string& what)
{
  Ids ids;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!ids.insert({integer(member(items[i], "id"), 0, most_items, "the id of " + what), i}).second)
      throw Malformed("the id of " + what + " is not unique");
  return ids;
}

std::size_t look_up(const Ids& ids, const Json& value, const std::string& what)
{
  const auto found = ids.find(integer(value, 0, most_items, what));
  if (found == ids.end()) throw Malformed(what + " does not exist");
  return found->second;
}

// Positions and polylines are there if and only if the surface is embedded.

Node read_node(const Json& json, bool is_embedded)
{
  Node node;
  node.kind = string(member(json, "kind"), "the kind of a node");
  node.order = integer(member(json, "order"), -3, most_items, "the order of a node");
  if (is_embedded) node.position = position(member(json, "position"), "the position of a node");
  return node;
}

Arc read_arc(const Json& json, const Ids& nodes, bool is_embedded)
{
  Arc arc;
  arc.from = look_up(nodes, member(json, "from"), "the beginning of an arc");
  arc.to = look_up(nodes, member(json, "to"), "the end of an arc");
  arc.length = integer(member(json, "length"), -largest_integer, largest_integer, "the length of an arc");
  if (!is_embedded) return arc;
  const Json& polyline = array(member(json, "polyline"), "a polyline");
  if (polyline.size() < 2) throw Malformed("a polyline has no two points");
  for (const Json& p : polyline) position(p, "a point of a polyline");
  arc.ends = {position(polyline.front(), "a polyline"), position(polyline.back(), "a polyline")};
  return arc;
}

Patch read_patch(const Json& json, const Ids& arcs)
{
  Patch patch;
  patch.width = integer(member(json, "width"), -largest_integer, largest_integer, "the width of a patch");
  patch.height = integer(member(json, "height"), -largest_integer, largest_integer, "the height of a patch");
  const Json& sides = array_of_size(member(json, "sides"), 4, "the sides of a patch");
  for (int i = 0; i < 4; ++i) {
    if (array(sides[i], "a side of a patch").empty()) throw Malformed("a side of a patch is empty");
    for (const Json& piece : sides[i]) {
      const Json& forward = member(piece, "forward");
      if (!forward.is_boolean()) throw Malformed("\"forward\" is not true or false");
      patch.sides[i].push_back({look_up(arcs, member(piece, "arc"), "an arc of a patch"), forward.get<bool>()});
    }
  }
  return patch;
}

Tmesh read_tmesh(const std::string& folder, bool is_embedded)
{
  const Json json = read_json(folder, "tmesh.json");
  Tmesh t;
  t.grid_exponent = static_cast<int>(integer(member(json, "grid_exponent"), 0, largest_grid_exponent + 1, "grid_exponent"));
  const std::string surface = string(member(json, "surface"), "surface");
  if (surface != "input" && surface != "flat_intrinsic")
    throw Malformed("\"surface\" is neither \"input\" nor \"flat_intrinsic\"");
  const Json& nodes = array(member(json, "nodes"), "nodes");
  const Json& arcs = array(member(json, "arcs"), "arcs");
  const Ids node_ids = read_ids(nodes, "a node"), arc_ids = read_ids(arcs, "an arc");
  for (const Json& n : nodes) t.nodes.push_back(read_node(n, is_embedded));
  for (const Json& a : arcs) t.arcs.push_back(read_arc(a, node_ids, is_embedded));
  const Json& patches = array(member(json, "patches"), "patches");
  t.patch_ids = read_ids(patches, "a patch");
  for (const Json& p : patches) t.patches.push_back(read_patch(p, arc_ids));
  return t;
}

std::size_t begin_of(const Tmesh& t, Side_piece s) { return s.forward ? t.arcs[s.arc].from : t.arcs[s.arc].to; }
std::size_t end_of(const Tmesh& t, Side_piece s)   { return s.forward ? t.arcs[s.arc].to : t.arcs[s.arc].from; }

bool is_rectangle(const Tmesh& t, const Patch& p)
{
  for (int i = 0; i < 4; ++i) {
    Integer length = 0;
    for (const Side_piece& s : p.sides[i]) length += t.arcs[s.arc].length;
    if (length != (i % 2 == 0 ? p.width : p.height)) return false;
  }
  return p.width > 0 && p.height > 0;
}

bool closes_up(const Tmesh& t, const Patch& p)
{
  std::size_t current = end_of(t, p.sides[3].back());
  for (const auto& side : p.sides)
    for (const Side_piece& s : side) {
      if (begin_of(t, s) != current) return false;
      current = end_of(t, s);
    }
  return true;
}

void count_uses(Tmesh& t)
{
  for (const Patch& p : t.patches)
    for (const auto& side : p.sides) {
      ++t.nodes[begin_of(t, side.front())].corners;
      for (const Side_piece& s : side) ++(s.forward ? t.arcs[s.arc].forward_uses : t.arcs[s.arc].backward_uses);
    }
  for (const Arc& a : t.arcs) {
    ++t.nodes[a.from].arms;
    ++t.nodes[a.to].arms;
    if (!a.is_on_boundary()) continue;
    ++t.nodes[a.from].boundary_begins;
    ++t.nodes[a.to].boundary_ends;
  }
}

bool fits_its_kind(const Node& n)
{
  if (n.kind == "singularity") return n.arms == n.order + 4 && n.corners == n.order + 4;
  if (n.kind == "meeting")     return n.arms == 2 && n.corners == 0;
  if (n.kind == "t_junction")  return n.arms == 3 && n.corners == 2;
  return n.kind == "crossing" && n.arms == 4 && n.corners == 4;
}

// T-junctions are inside or on the boundary.
bool fits_its_kind_with_boundary(const Node& n)
{
  if (n.kind == "corner")     return n.is_on_boundary() && n.arms == n.order + 3 && n.corners == n.order + 2;
  if (n.kind == "boundary")   return n.is_on_boundary() && n.arms == 2 && n.corners == 0;
  if (n.kind == "t_junction") return fits_its_kind(n);
  return !n.is_on_boundary() && fits_its_kind(n);
}

// the number of closed curves that arcs of the boundary form, if one begins where one ends; nothing otherwise
std::optional<std::size_t> number_of_boundary_curves(const Tmesh& t)
{
  for (const Node& n : t.nodes)
    if (n.boundary_begins > 1 || n.boundary_begins != n.boundary_ends) return {};
  std::vector<std::size_t> next(t.nodes.size());
  for (std::size_t n = 0; n < next.size(); ++n) next[n] = n;
  for (const Arc& a : t.arcs)
    if (a.is_on_boundary()) next[a.from] = a.to;
  std::vector<char> seen(next.size(), false);
  std::size_t curves = 0;
  for (std::size_t n = 0; n < next.size(); ++n) {
    if (seen[n] || !t.nodes[n].is_on_boundary()) continue;
    ++curves;
    for (std::size_t m = n; !seen[m]; m = next[m]) seen[m] = true;
  }
  return curves;
}

// the orders of the nodes of a kind, sorted
std::vector<std::int64_t> orders_of(const Tmesh& t, const std::string& kind)
{
  std::vector<std::int64_t> orders;
  for (const Node& n : t.nodes)
    if (n.kind == kind) orders.push_back(n.order);
  std::sort(orders.begin(), orders.end());
  return orders;
}

bool ends_at_its_nodes(const Tmesh& t, const Arc& a, double tolerance)
{
  if (!a.ends) return true;
  const auto near = [&](const Position& p, const Position& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= tolerance;
  };
  return near(a.ends->first, *t.nodes[a.from].position) && near(a.ends->second, *t.nodes[a.to].position);
}

void verify_tmesh(Tmesh t, const Flat_facts& flat, const Report& report, Checks& checks)
{
  count_uses(t);
  const auto all = [](const auto& items, auto holds) { return std::all_of(items.begin(), items.end(), holds); };

  checks.push_back({all(t.patches, [&](const Patch& p) { return is_rectangle(t, p); }),
                    "tmesh: " + std::to_string(t.patches.size()) + " patches are exact rectangles"});
  checks.push_back({all(t.patches, [&](const Patch& p) { return closes_up(t, p); }),
                    "tmesh: the sides of every patch close up"});
  checks.push_back({all(t.arcs, [&](const Arc& a) {
                      return a.forward_uses == 1 && (a.backward_uses == 1 || (a.backward_uses == 0 && !report.is_closed()));
                    }), std::string("tmesh: every arc is used once forward and ")
                        + (report.is_closed() ? "once backward" : "at most once backward")});
  checks.push_back({all(t.arcs, [](const Arc& a) { return a.length > 0; }), "tmesh: every arc has positive length"});

  const std::int64_t chi = static_cast<std::int64_t>(t.nodes.size()) - static_cast<std::int64_t>(t.arcs.size())
                         + static_cast<std::int64_t>(t.patches.size());
  checks.push_back({chi == report.euler_characteristic(), "tmesh: V-E+F = " + std::to_string(chi) + " = " + euler_text(report)});

  Integer area = 0;
  for (const Patch& p : t.patches) area += Integer(p.width) * p.height;
  checks.push_back({(area << (2 * flat.grid_exponent + 1)) == (flat.doubled_area << (2 * t.grid_exponent)),
                    "tmesh: patch areas sum exactly to the flat area"});

  double size = 0;
  for (const Node& n : t.nodes)
    if (n.position)
      for (double x : *n.position) size = std::max(size, std::abs(x));
  checks.push_back({orders_of(t, "singularity") == flat.orders, "tmesh: one node for every singularity"});
  if (!report.is_closed()) {
    const std::optional<std::size_t> curves = number_of_boundary_curves(t);
    checks.push_back({curves.has_value(), "tmesh: the arcs with a patch on one side form closed curves"});
    if (curves) checks.push_back({*curves == number_of_curves(report), "tmesh: " + curves_text(*curves)});
    checks.push_back({orders_of(t, "corner") == flat.corner_orders, "tmesh: one node for every corner"});
  }
  checks.push_back({all(t.nodes, report.is_closed() ? fits_its_kind : fits_its_kind_with_boundary),
                    "tmesh: arms and patch corners fit the kind of every node"});
  checks.push_back({all(t.arcs, [&](const Arc& a) { return ends_at_its_nodes(t, a, 1e-9 * size); }),
                    "tmesh: polylines end at their nodes"});
}

// ---- quads.obj

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
std::map<std::size_t, std::size_t> boundary_of(const Quad_edges& edges)
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
  const internal::Face_tree<Mesh> tree(input->faces().begin(), input->faces().end(), *input);
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
  for (const auto& [v, next] : boundary_of(edges)) points.push_back(point_3(obj.points[v]));
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
  checks.push_back({edges.has_value(), std::string("quads.obj: ")
                    + (report.is_closed() ? "every edge is shared by two quads" : "no edge is shared by more than two quads")
                    + ", in opposite directions, and no two edges have the same ends"});
  if (!edges) return;
  std::vector<std::int64_t> valence(obj.points.size(), 0);
  for (const Quad& quad : obj.quads)
    for (std::size_t v : quad.vertex) ++valence[v];
  const std::map<std::size_t, std::size_t> boundary = boundary_of(*edges);
  const std::string circle = report.is_closed() ? "one circle" : "one circle, or one fan on the boundary";
  checks.push_back({is_connected(obj.quads, *edges), "quads.obj: one component"});
  checks.push_back({std::all_of(edges->begin(), edges->end(), [&](const auto& edge) {
                      const auto& ends = edge.first;
                      const std::size_t n = static_cast<std::size_t>(valence[ends.first]);
                      if (boundary.count(ends.first) == 1 && !is_border(*edges, ends)) return true;   // not where a fan begins
                      return quads_around(*edges, ends) == n;
                    }), "quads.obj: the quads round every vertex form " + circle});
  // V - E + F, where 4 F counts edges inside twice and those of the boundary once
  const std::size_t number_of_edges = (4 * obj.quads.size() + boundary.size()) / 2;
  const std::int64_t chi = static_cast<std::int64_t>(obj.points.size()) - static_cast<std::int64_t>(number_of_edges)
                         + static_cast<std::int64_t>(obj.quads.size());
  checks.push_back({chi == report.euler_characteristic(), "quads.obj: Euler characteristic " + std::to_string(chi) + " = "
                                                        + euler_text(report)});
  std::vector<std::int64_t> inside, on_boundary;
  for (std::size_t v = 0; v < valence.size(); ++v) (boundary.count(v) == 1 ? on_boundary : inside).push_back(valence[v]);
  const std::vector<std::int64_t> orders = orders_of(inside, 4), corner_orders = orders_of(on_boundary, 2);
  checks.push_back({orders == report.orders, "quads.obj: " + std::to_string(orders.size())
                                           + " irregular vertices are exactly the singularities"});
  if (report.is_closed()) return;
  const std::size_t curves = number_of_curves(boundary);
  checks.push_back({curves == number_of_curves(report), "quads.obj: " + curves_text(curves)});
  checks.push_back({corner_orders == report.corner_orders, "quads.obj: " + std::to_string(corner_orders.size())
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

void verify_quads(const Quads_obj& obj, const Report& report, const Ids& patch_ids, const Mesh* input, Checks& checks)
{
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

} // namespace

std::vector<Verification> verify_outputs(const std::string& folder, const Intrinsic_triangulation* input)
{
  Checks checks;
  std::string file;
  try {
    file = "report.json";
    const Report report = read_report(folder);
    file = "flat_intrinsic.json";
    const Flat_facts facts = verify_flat("flat_intrinsic", read_flat(folder, report.is_closed()), report, checks);
    file = "flat.obj";
    const Mesh* mesh = input != nullptr && input->is_embedded() ? &input->mesh() : nullptr;
    if (mesh != nullptr || (facts.is_embedded && has_file(folder, file)))
      verify_flat_obj(read_flat_obj(folder, facts.grid_exponent), facts, report, mesh, checks);
    file = "tmesh.json";
    Ids patch_ids;
    if (report.orders.empty() && report.corner_orders.empty() && !has_file(folder, file)) {
      checks.push_back({true, "tmesh: none, there is no singularity"});
    } else {
      const Tmesh t = read_tmesh(folder, facts.is_embedded);
      patch_ids = t.patch_ids;
      verify_tmesh(t, facts, report, checks);
    }
    file = "quads.obj";
    if (report.quads || has_file(folder, file))
      verify_quads(read_quads(folder), report, patch_ids, mesh, checks);
  }
  catch (const Error& e) { checks.push_back({false, file + ": " + e.what()}); }
  return checks;
}

} } // namespace CGAL::Quartic_differentials
