// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The verification of surfaces with boundary accepts outputs that are made by hand, of unit squares, and rejects every
// way of spoiling them that is tried here.

#include "check.h"
#include "verified_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

using Point = std::array<double, 3>;

Point operator+(const Point& p, const Point& q) { return {p[0] + q[0], p[1] + q[1], p[2] + q[2]}; }
Point middle(const Point& p, const Point& q) { return {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}; }

// Squares, each with its corners counterclockwise, that meet side to side.
struct Squares
{
  std::vector<Point>              points;
  std::vector<std::array<int, 4>> squares;

  int vertex(const Point& p)
  {
    const auto [at, is_new] = m_index.try_emplace(p, static_cast<int>(points.size()));
    if (is_new) points.push_back(p);
    return at->second;
  }
  void add(const Point& a, const Point& b, const Point& c, const Point& d)
  { squares.push_back({vertex(a), vertex(b), vertex(c), vertex(d)}); }

private:
  std::map<Point, int> m_index;
};

// the squares of the plane at the crosses of a picture, whose last line is the lowest
Squares planar(const std::vector<std::string>& picture)
{
  Squares s;
  const int rows = static_cast<int>(picture.size());
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < static_cast<int>(picture[0].size()); ++i) {
      const double x = i, y = rows - 1 - j;
      if (picture[j][i] == 'x') s.add({x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0});
    }
  return s;
}

// the surface of unit cubes, without some of its squares: those for which `is_out(lower corner, axis, side)`
template <class Is_out>
Squares surface_of_cubes(const std::vector<std::array<int, 3>>& cubes, Is_out is_out)
{
  Squares s;
  for (const auto& cube : cubes)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        std::array<int, 3> neighbour = cube;
        neighbour[axis] += side == 0 ? -1 : 1;
        if (std::find(cubes.begin(), cubes.end(), neighbour) != cubes.end() || is_out(cube, axis, side)) continue;
        Point a{double(cube[0]), double(cube[1]), double(cube[2])}, u{0, 0, 0}, v{0, 0, 0};
        a[axis] += side;
        u[(axis + (side == 1 ? 1 : 2)) % 3] = 1;
        v[(axis + (side == 1 ? 2 : 1)) % 3] = 1;
        s.add(a, a + u, a + u + v, a + v);
      }
  return s;
}

Squares tube()
{
  return surface_of_cubes({{0, 0, 0}, {0, 0, 1}}, [](const auto&, int axis, int) { return axis == 2; });
}

Squares open_box()
{
  return surface_of_cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, [](const auto&, int axis, int side) {
    return axis == 2 && side == 1;
  });
}

// a ring of eight cubes, without some of the squares on its top
Squares ring_without(const std::vector<std::array<int, 2>>& places)
{
  std::vector<std::array<int, 3>> cubes;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      if (x != 1 || y != 1) cubes.push_back({x, y, 0});
  return surface_of_cubes(cubes, [&](const std::array<int, 3>& cube, int axis, int side) {
    return axis == 2 && side == 1 && std::count(places.begin(), places.end(), std::array<int, 2>{cube[0], cube[1]}) > 0;
  });
}

// Every square in four, row by row. Points keep their index.
Squares refined(const Squares& s)
{
  Squares fine = s;
  fine.squares.clear();
  for (const auto& [a, b, c, d] : s.squares) {
    const Point pa = s.points[a], pb = s.points[b], pc = s.points[c], pd = s.points[d];
    const Point ab = middle(pa, pb), bc = middle(pb, pc), cd = middle(pc, pd), da = middle(pd, pa), m = middle(ab, cd);
    fine.add(pa, ab, m, da);
    fine.add(ab, pb, bc, m);
    fine.add(da, m, cd, pd);
    fine.add(m, bc, pc, cd);
  }
  return fine;
}

using Edge_squares = std::map<std::pair<int, int>, std::array<int, 2>>;   // directed: the square, and which side of it

Edge_squares edges_of(const Squares& s)
{
  Edge_squares edges;
  for (int f = 0; f < static_cast<int>(s.squares.size()); ++f)
    for (int k = 0; k < 4; ++k)
      CHECK((edges.insert({{s.squares[f][k], s.squares[f][(k + 1) % 4]}, {f, k}}).second));
  return edges;
}

const int grid_exponent = 20;

// A point of a unit square's own chart, turned and moved differently for every square.
std::array<std::int64_t, 2> chart_point(int square, int corner)
{
  const std::int64_t unit = std::int64_t(1) << grid_exponent;
  std::int64_t x = corner == 1 || corner == 2 ? unit : 0, y = corner >= 2 ? unit : 0;
  for (int turns = 0; turns < square % 4; ++turns) {
    std::swap(x, y);
    x = -x;
  }
  return {x + 12345 * square, y - 777 * square};
}

// the two triangles of every square: their corners among the square's
const int triangle_corners[2][3] = {{0, 1, 2}, {0, 2, 3}};

json flat_of(const Squares& s)
{
  json flat{{"grid_exponent", grid_exponent}, {"vertices", s.points}};
  const Edge_squares edges = edges_of(s);
  for (int f = 0; f < static_cast<int>(s.squares.size()); ++f)
    for (int half = 0; half < 2; ++half) {
      json triangle, uv, opposite;
      for (int e = 0; e < 3; ++e) {
        const int c = triangle_corners[half][e], next = triangle_corners[half][(e + 1) % 3];
        triangle.push_back(s.squares[f][c]);
        for (std::int64_t x : chart_point(f, c)) uv.push_back(x);
        const auto across = edges.find({s.squares[f][next], s.squares[f][c]});
        if ((next - c) % 2 == 0) opposite.push_back({2 * f + 1 - half, half == 0 ? 0 : 2});   // the diagonal
        else if (across == edges.end()) opposite.push_back({-1, -1});
        else {
          const auto [g, k] = across->second;
          opposite.push_back({2 * g + k / 2, k < 2 ? k : k - 1});
        }
      }
      flat["triangles"].push_back(triangle);
      flat["uv"].push_back(uv);
      flat["opposite"].push_back(opposite);
    }
  return flat;
}

// of squares with sides 2^-scale
Lines flat_obj_of(const Squares& s, int scale)
{
  Lines lines, faces;
  const auto line = [](const char* key, const auto& numbers) {
    std::ostringstream out;
    out.precision(17);
    out << key;
    for (double x : numbers) out << ' ' << x;
    return out.str();
  };
  for (const Point& p : s.points) lines.push_back(line("v", p));
  std::size_t vt = 0;
  for (int f = 0; f < static_cast<int>(s.squares.size()); ++f)
    for (const auto& corners : triangle_corners) {
      std::string face = "f";
      for (int c : corners) {
        const auto [x, y] = chart_point(f, c);
        const double shrink = std::ldexp(1.0, -grid_exponent - scale);
        // the translation must stay on the grid
        lines.push_back(line("vt", std::array<double, 2>{(x - 12345 * f) * shrink, (y + 777 * f) * shrink}));
        face += ' ' + std::to_string(s.squares[f][c] + 1) + '/' + std::to_string(++vt);
      }
      faces.push_back(face);
    }
  lines.insert(lines.end(), faces.begin(), faces.end());
  return lines;
}

// The number of squares round every vertex, and whether it is on the boundary.
struct Valences
{
  std::vector<int>  squares;
  std::vector<char> is_on_boundary;

  explicit Valences(const Squares& s) : squares(s.points.size(), 0), is_on_boundary(s.points.size(), false)
  {
    const Edge_squares edges = edges_of(s);
    for (const auto& square : s.squares)
      for (int v : square) ++squares[v];
    for (const auto& [ends, side] : edges)
      if (edges.count({ends.second, ends.first}) == 0) is_on_boundary[ends.first] = true;
  }
  int order(std::size_t v) const { return squares[v] - (is_on_boundary[v] ? 2 : 4); }
};

json tmesh_of(const Squares& s)
{
  json t{{"grid_exponent", grid_exponent + 1}, {"surface", "input"}, {"nodes", json::array()}, {"arcs", json::array()}};
  const Valences valences(s);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    const int order = valences.order(v);
    const char* kind = valences.is_on_boundary[v] ? (order == 0 ? "t_junction" : "corner")
                                                  : (order == 0 ? "crossing" : "singularity");
    t["nodes"].push_back({{"id", v}, {"kind", kind}, {"order", order}, {"position", s.points[v]}});
  }
  const std::int64_t unit = std::int64_t(2) << grid_exponent;
  std::map<std::pair<int, int>, std::size_t> arcs;
  for (std::size_t f = 0; f < s.squares.size(); ++f) {
    json sides;
    for (int k = 0; k < 4; ++k) {
      const int from = s.squares[f][k], to = s.squares[f][(k + 1) % 4];
      const auto there = arcs.find({to, from});
      if (there != arcs.end()) {
        sides.push_back(json::array({json{{"arc", there->second}, {"forward", false}}}));
        continue;
      }
      const std::size_t id = arcs.size();
      arcs[{from, to}] = id;
      t["arcs"].push_back({{"id", id}, {"from", from}, {"to", to}, {"length", unit},
                           {"polyline", {s.points[from], s.points[to]}}});
      sides.push_back(json::array({json{{"arc", id}, {"forward", true}}}));
    }
    t["patches"].push_back({{"id", f}, {"width", unit}, {"height", unit}, {"sides", sides}});
  }
  return t;
}

Lines quads_of(const Squares& fine)
{
  Lines lines;
  for (const Point& p : fine.points) {
    std::ostringstream out;
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2];
    lines.push_back(out.str());
  }
  for (std::size_t f = 0; f < fine.squares.size(); ++f) {
    if (f % 4 == 0) lines.push_back("g patch_" + std::to_string(f / 4));
    std::string quad = "f";
    for (int v : fine.squares[f]) quad += ' ' + std::to_string(v + 1);
    lines.push_back(quad);
  }
  return lines;
}

json report_of(const Squares& s, const Squares& fine, int genus, int curves)
{
  json report{{"input", {{"genus", genus}, {"boundary", curves}}}, {"singularities", json::array()},
              {"corners", json::array()}};
  const Valences valences(s);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    const int order = valences.order(v);
    if (order == 0) continue;
    if (valences.is_on_boundary[v]) report["corners"].push_back({{"quads", order + 2}, {"order", order}});
    else report["singularities"].push_back({{"order", order}});
  }
  report["quad_mesh"] = {{"quads", fine.squares.size()}, {"vertices", fine.points.size()},
                         {"patches", s.squares.size()}, {"scaled_jacobian", {{"min", 1}}}};
  return report;
}

Intrinsic_triangulation triangulated(const Squares& s)
{
  Mesh mesh;
  for (const auto& [x, y, z] : s.points) mesh.add_vertex(Point_3(x, y, z));
  for (const auto& square : s.squares)
    for (const auto& corners : triangle_corners) {
      const auto vertex = [&](int k) { return Vertex(static_cast<Mesh::size_type>(square[corners[k]])); };
      mesh.add_face(vertex(0), vertex(1), vertex(2));
    }
  return Intrinsic_triangulation(std::move(mesh));
}

// All files of a run on a surface of squares.
struct Files
{
  Output                  output;
  Lines                   flat_obj, quads;
  Intrinsic_triangulation input;

  Files(const Squares& s, int genus, int curves) : input(triangulated(s))
  {
    const Squares fine = refined(s);
    output.flat = flat_of(s);
    output.tmesh = tmesh_of(s);
    output.report = report_of(s, fine, genus, curves);
    flat_obj = flat_obj_of(fine, 1);
    quads = quads_of(fine);
  }

  std::vector<Verification> verified() const
  {
    Output::write("flat.obj", joined(flat_obj));
    Output::write("quads.obj", joined(quads));
    output.verified();
    return verify_outputs(Output::folder(), &input);
  }
};

std::vector<std::pair<std::string, Files>> examples()
{
  const std::vector<std::string> l_with_hole{"xxx..", "xxx..", "xxxxx", "x.xxx", "xxxxx"};
  return {{"rectangle", Files(planar({"xxx", "xxx"}), 0, 1)},
          {"L with a hole", Files(planar(l_with_hole), 0, 2)},
          {"three holes", Files(planar({"xxxxxxx", "x.x.x.x", "xxxxxxx"}), 0, 4)},
          {"tube", Files(tube(), 0, 2)},
          {"open box", Files(open_box(), 0, 1)},
          {"ring without a square", Files(ring_without({{0, 0}}), 1, 1)},
          {"ring without two squares", Files(ring_without({{0, 1}, {2, 1}}), 1, 2)},
          {"ring without neighbouring squares", Files(ring_without({{0, 0}, {1, 0}}), 1, 1)}};
}

void valid_outputs_pass()
{
  for (const auto& [name, files] : examples()) {
    const auto checks = files.verified();
    CHECK(all_hold(checks));
    for (const Verification& c : checks)
      if (!c.ok) std::cerr << name << ": " << c.what << std::endl;
    CHECK(all_hold(verify_outputs(Output::folder())));
  }
}

// Degrees are those of the theorem: corners of a rectangle, of the L, and poles of a box.
void orders_are_known()
{
  const auto orders = [](const json& list) {
    std::map<int, int> count;
    for (const json& entry : list) ++count[entry["order"].get<int>()];
    return count;
  };
  const auto all = examples();
  CHECK((orders(all[0].second.output.report["corners"]) == std::map<int, int>{{-1, 4}}));
  CHECK((orders(all[1].second.output.report["corners"]) == std::map<int, int>{{-1, 5}, {1, 5}}));
  CHECK(all[3].second.output.report["corners"].empty() && all[3].second.output.report["singularities"].empty());
  CHECK((orders(all[4].second.output.report["singularities"]) == std::map<int, int>{{-1, 4}}));
}

// without singularities and corners there may be no T-mesh
void tube_needs_no_tmesh()
{
  const Files files(tube(), 0, 2);
  files.verified();
  std::filesystem::remove(Output::folder() + "/tmesh.json");
  std::filesystem::remove(Output::folder() + "/quads.obj");
  CHECK(fails_with(verify_outputs(Output::folder()), "quads.obj: the file cannot be opened"));
  Output without = files.output;
  without.report.erase("quad_mesh");
  Output::write("report.json", without.report.dump());
  CHECK(all_hold(verify_outputs(Output::folder(), &files.input)));
  const Files plate(planar({"xx"}), 0, 1);
  plate.verified();
  std::filesystem::remove(Output::folder() + "/tmesh.json");
  CHECK(fails_with(verify_outputs(Output::folder()), "tmesh.json: the file cannot be opened"));
}

using Spoil = std::function<void(Files&)>;

// Every file is spoilt; the sentence is that of the check that must notice.
class Spoiler
{
public:
  explicit Spoiler(const Files& valid) : m_valid(valid) { CHECK(all_hold(valid.verified())); }

  void operator()(const std::string& sentence, const Spoil& spoil) const
  {
    Files files = m_valid;
    spoil(files);
    const auto checks = files.verified();
    CHECK(fails_with(checks, sentence));
    if (!fails_with(checks, sentence)) std::cerr << "expected to fail with: " << sentence << std::endl;
  }

private:
  const Files& m_valid;
};

// Cuts an arc in two at a new node in its middle; returns the node. The arc keeps its first half.
json& split_arc(json& t, std::size_t arc, const std::string& kind)
{
  const std::size_t node = t["nodes"].size(), second = t["arcs"].size();
  json& first = t["arcs"][arc];
  const Point from = first["polyline"][0], to = first["polyline"][1], m = middle(from, to);
  const std::int64_t half = first["length"].get<std::int64_t>() / 2;
  json rest = first;
  t["nodes"].push_back({{"id", node}, {"kind", kind}, {"order", 0}, {"position", m}});
  first["to"] = node;
  first["length"] = half;
  first["polyline"] = {from, m};
  rest["id"] = second;
  rest["from"] = node;
  rest["length"] = half;
  rest["polyline"] = {m, to};
  t["arcs"].push_back(rest);
  for (json& patch : t["patches"])
    for (json& side : patch["sides"])
      for (std::size_t i = 0; i < side.size(); ++i)
        if (side[i]["arc"] == arc) {
          const bool forward = side[i]["forward"];
          side.insert(side.begin() + static_cast<std::ptrdiff_t>(forward ? i + 1 : i),
                      json{{"arc", second}, {"forward", forward}});
          ++i;
        }
  return t["nodes"].back();
}

// an arc that `uses` patches use
std::size_t arc_with(const json& t, int uses)
{
  std::vector<int> count(t["arcs"].size(), 0);
  for (const json& patch : t["patches"])
    for (const json& side : patch["sides"])
      for (const json& piece : side) ++count[piece["arc"].get<std::size_t>()];
  return static_cast<std::size_t>(std::find(count.begin(), count.end(), uses) - count.begin());
}

json& node_of_kind(json& t, const std::string& kind)
{
  return *std::find_if(t["nodes"].begin(), t["nodes"].end(), [&](const json& n) { return n["kind"] == kind; });
}

void nodes_on_arcs()
{
  Files files(planar({"xxx", "xxx"}), 0, 1);
  split_arc(files.output.tmesh, arc_with(files.output.tmesh, 1), "boundary");
  split_arc(files.output.tmesh, arc_with(files.output.tmesh, 2), "meeting");
  CHECK(all_hold(files.verified()));
  const Spoiler fails(files);
  fails("kind of every node", [](Files& f) { node_of_kind(f.output.tmesh, "boundary")["kind"] = "meeting"; });
  fails("kind of every node", [](Files& f) { node_of_kind(f.output.tmesh, "meeting")["kind"] = "boundary"; });
  fails("kind of every node", [](Files& f) { node_of_kind(f.output.tmesh, "boundary")["kind"] = "t_junction"; });
}

bool is_border(const json& opposite) { return opposite == json{-1, -1}; }

// the first edge of the boundary, as a triangle and an edge
std::pair<std::size_t, std::size_t> border_edge(const json& flat)
{
  for (std::size_t t = 0; t < flat["opposite"].size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (is_border(flat["opposite"][t][k])) return {t, k};
  throw std::logic_error("there is no boundary");
}

void spoilt_flat_fails(const Files& valid)
{
  const Spoiler fails(valid);
  // an edge inside is cut open, and then only from one side; an edge of the boundary is glued to another, and to itself
  fails("Euler characteristic", [](Files& f) {
    json& opposite = f.output.flat["opposite"];
    for (std::size_t t = 0; t < opposite.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        if (is_border(opposite[t][k])) continue;
        const std::size_t u = opposite[t][k][0], j = opposite[t][k][1];
        opposite[t][k] = opposite[u][j] = {-1, -1};
        return;
      }
  });
  fails("flat_intrinsic: gluing", [](Files& f) {
    json& opposite = f.output.flat["opposite"];
    for (json& glued : opposite[0])
      if (!is_border(glued)) glued = {-1, -1};
  });
  fails("flat_intrinsic: gluing", [](Files& f) {
    const auto [t, k] = border_edge(f.output.flat);
    f.output.flat["opposite"][t][k] = {t, (k + 1) % 3};
  });
  fails("flat_intrinsic: gluing", [](Files& f) {
    const auto [t, k] = border_edge(f.output.flat);
    f.output.flat["opposite"][t][k] = {t, k};
  });
  for (const json& bad : {json{-1, 0}, json{0, -1}, json{-2, -2}, json{-1}, json{-1.0, -1.5}, json{nullptr, -1}})
    fails("flat_intrinsic.json: an opposite", [&](Files& f) {
      const auto [t, k] = border_edge(f.output.flat);
      f.output.flat["opposite"][t][k] = bad;
    });
  // a boundary edge turns by one unit
  fails("boundary edges are not parallel to an axis", [](Files& f) {
    const auto [t, k] = border_edge(f.output.flat);
    json &x = f.output.flat["uv"][t][2 * k], &y = f.output.flat["uv"][t][2 * k + 1];
    x = x.get<std::int64_t>() + 1;
    y = y.get<std::int64_t>() + 1;
  });
  // one square is turned by an angle that is no multiple of 90 degrees
  fails("exact rotation", [](Files& f) {
    json& uv = f.output.flat["uv"];
    for (std::size_t t = 0; t < 2; ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t x = uv[t][2 * k], y = uv[t][2 * k + 1];
        uv[t][2 * k] = 3 * x - 4 * y;
        uv[t][2 * k + 1] = 4 * x + 3 * y;
      }
  });
  fails("one component", [](Files& f) {
    json& flat = f.output.flat;
    const std::size_t n = flat["triangles"].size();
    for (const char* key : {"triangles", "uv", "opposite"})
      for (std::size_t t = 0; t < n; ++t) {
        json copy = flat[key][t];
        if (key == std::string("opposite"))
          for (json& glued : copy)
            if (!is_border(glued)) glued[0] = glued[0].get<std::size_t>() + n;
        flat[key].push_back(copy);
      }
  });
  // two vertices with one name
  fails("flat_intrinsic: the triangles round every vertex form one circle, or one fan", [](Files& f) {
    for (json& triangle : f.output.flat["triangles"])
      for (json& v : triangle)
        if (v == f.output.flat["vertices"].size() - 1) v = 0;
  });
  fails("cannot make a surface", [](Files& f) {
    for (const char* key : {"triangles", "uv", "opposite"}) f.output.flat[key] = json::array();
  });
  // a triangle is missing: an odd number is no defect by itself, but this is another surface
  fails("tmesh: patch areas", [](Files& f) {
    json& flat = f.output.flat;
    for (json& triangle : flat["opposite"])
      for (json& glued : triangle)
        if (glued[0] == flat["triangles"].size() - 1) glued = {-1, -1};
    for (const char* key : {"triangles", "uv", "opposite"}) flat[key].erase(flat[key].size() - 1);
  });
}

void spoilt_report_fails(const Files& valid)
{
  const Spoiler fails(valid);
  for (const char* sentence : {"flat_intrinsic: Euler characteristic", "tmesh: V-E+F",
                               "quads.obj: Euler characteristic", "8g-8+4b"})
    fails(sentence, [](Files& f) { f.output.report["input"]["boundary"] = 17; });
  fails("8g-8+4b", [](Files& f) { f.output.report["input"]["genus"] = 2; });
  for (const int closed : {0, 1}) {
    Files files = valid;
    if (closed == 0) files.output.report["input"]["boundary"] = 0;
    else files.output.report["input"].erase("boundary");
    CHECK(fails_with(files.verified(), "flat_intrinsic.json: "));
  }
  for (const json& bad : {json(-1), json(1.5), json("1"), json(nullptr)})
    fails("report.json: input.boundary", [&](Files& f) { f.output.report["input"]["boundary"] = bad; });
  fails("\"corners\" is missing", [](Files& f) { f.output.report.erase("corners"); });
  fails("corners is not an array", [](Files& f) { f.output.report["corners"] = 4; });
  for (const char* sentence : {"flat_intrinsic, corners: their angles match the report",
                               "flat.obj, corners: their angles match the report",
                               "irregular vertices of the boundary are exactly the corners"}) {
    fails(sentence, [](Files& f) { f.output.report["corners"].erase(0); });
    fails(sentence, [](Files& f) { f.output.report["corners"].push_back({{"order", 0}, {"quads", 2}}); });
    fails(sentence, [](Files& f) { f.output.report["corners"][0] = {{"order", 2}, {"quads", 4}}; });
  }
  fails("not its order + 2", [](Files& f) { f.output.report["corners"][0]["quads"] = 2; });
  fails("the order of a corner is out of range", [](Files& f) {
    f.output.report["corners"][0] = {{"order", -2}, {"quads", 0}};
  });
  fails("\"quads\" is missing", [](Files& f) { f.output.report["corners"][0].erase("quads"); });
  // a corner is no singularity inside
  fails("cones: orders match the report", [](Files& f) {
    f.output.report["singularities"].push_back({{"order", f.output.report["corners"][0]["order"]}});
    f.output.report["corners"].erase(0);
  });
}

// Two curves on a torus, four on a sphere: Euler characteristic and degree are the same.
void curves_are_counted()
{
  const Files valid(ring_without({{0, 1}, {2, 1}}), 1, 2);
  const Spoiler fails(valid);
  for (const std::string file : {"flat_intrinsic", "flat.obj", "tmesh", "quads.obj"})
    fails(file + ": 2 boundary curves, as in the report", [](Files& f) {
      f.output.report["input"] = {{"genus", 0}, {"boundary", 4}};
    });
}

void spoilt_tmesh_fails(const Files& valid)
{
  const Spoiler fails(valid);
  for (const char* sentence : {"at most once backward", "patch areas"})
    fails(sentence, [](Files& f) { f.output.tmesh["patches"].erase(0); });
  // an arc of the boundary that runs the wrong way round
  fails("at most once backward", [](Files& f) {
    json& t = f.output.tmesh;
    const std::size_t arc = arc_with(t, 1);
    std::swap(t["arcs"][arc]["from"], t["arcs"][arc]["to"]);
    for (json& patch : t["patches"])
      for (json& side : patch["sides"])
        for (json& piece : side)
          if (piece["arc"] == arc) piece["forward"] = false;
  });
  // an arc inside is torn into two of the boundary
  for (const char* sentence : {"form closed curves", "tmesh: V-E+F"})
    fails(sentence, [](Files& f) {
      json& t = f.output.tmesh;
      const std::size_t arc = arc_with(t, 2), copy = t["arcs"].size();
      t["arcs"].push_back(t["arcs"][arc]);
      json& torn = t["arcs"].back();
      torn["id"] = copy;
      std::swap(torn["from"], torn["to"]);
      std::swap(torn["polyline"][0], torn["polyline"][1]);
      for (json& patch : t["patches"])
        for (json& side : patch["sides"])
          for (json& piece : side)
            if (piece["arc"] == arc && piece["forward"] == false) piece = {{"arc", copy}, {"forward", true}};
    });
  fails("one node for every corner", [](Files& f) {
    json& order = node_of_kind(f.output.tmesh, "corner")["order"];
    order = order.get<int>() + 1;
  });
  for (const char* sentence : {"one node for every corner", "one node for every singularity"})
    fails(sentence, [](Files& f) { node_of_kind(f.output.tmesh, "corner")["kind"] = "singularity"; });
  for (const char* kind : {"t_junction", "crossing", "meeting", "boundary", "nothing"})
    fails("kind of every node", [&](Files& f) { node_of_kind(f.output.tmesh, "corner")["kind"] = kind; });
  for (const char* kind : {"crossing", "meeting", "boundary", "singularity"})
    fails("kind of every node", [&](Files& f) { node_of_kind(f.output.tmesh, "t_junction")["kind"] = kind; });
  fails("one node for every corner", [](Files& f) { node_of_kind(f.output.tmesh, "t_junction")["kind"] = "corner"; });
  fails("kind of every node", [&](Files& f) { node_of_kind(f.output.tmesh, "crossing")["kind"] = "boundary"; });
  for (const char* kind : {"t_junction", "crossing"})
    fails("kind of every node", [&](Files& f) { node_of_kind(f.output.tmesh, kind)["order"] = 1; });
  // with the right order, but at the wrong place
  fails("kind of every node", [&](Files& f) {
    json &corner = node_of_kind(f.output.tmesh, "corner"), &junction = node_of_kind(f.output.tmesh, "t_junction");
    std::swap(corner["kind"], junction["kind"]);
    std::swap(corner["order"], junction["order"]);
  });
  fails("exact rectangles", [](Files& f) {
    json& length = f.output.tmesh["arcs"][arc_with(f.output.tmesh, 1)]["length"];
    length = length.get<std::int64_t>() + 1;
  });
}

void spoilt_flat_obj_fails(const Files& valid)
{
  const Spoiler fails(valid);
  const auto last = [](const Lines& lines, const std::string& key) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].compare(0, key.size(), key) == 0) found = i;
    return found;
  };
  for (const char* sentence : {"flat.obj: exactly the area", "flat.obj: its boundary is as long as the input's"})
    fails(sentence, [&](Files& f) { f.flat_obj.erase(f.flat_obj.begin() + last(f.flat_obj, "f ")); });
  fails("flat.obj: no edge is shared by more than two", [&](Files& f) { f.flat_obj.push_back(f.flat_obj.back()); });
  fails("flat.obj: no edge is shared by more than two", [&](Files& f) {   // a triangle the other way round
    std::istringstream words(f.flat_obj.back());
    std::string key, a, b, c;
    words >> key >> a >> b >> c;
    f.flat_obj.back() = "f " + b + ' ' + a + ' ' + c;
  });
  fails("boundary edges are not parallel to an axis", [&](Files& f) {
    std::size_t first = 0;   // the first triangle has no edge of the boundary, the second does
    while (f.flat_obj[first].compare(0, 3, "vt ") != 0) ++first;
    f.flat_obj[first + 3] = "vt 0.125 0.25";
  });
  // a vertex of the boundary moves along the surface, away from the input's boundary, and along the boundary, where
  // nothing is wrong
  const std::size_t first_new = valid.input.number_of_vertices();
  for (std::size_t v = first_new; v < valid.flat_obj.size(); ++v) {
    const std::string& line = valid.flat_obj[v];
    if (line.compare(0, 2, "v ") != 0) break;
    const Point_3 p = [&] {
      std::istringstream words(line.substr(2));
      double x = 0, y = 0, z = 0;
      words >> x >> y >> z;
      return Point_3(x, y, z);
    }();
    if (p.y() != 0 || p.z() != 0) continue;   // on the lowest side of the plate
    fails("flat.obj: its boundary lies on the input's", [&](Files& f) {
      std::ostringstream moved;
      moved.precision(17);
      moved << "v " << p.x() << " 1e-9 0";
      f.flat_obj[v] = moved.str();
    });
    fails("quads.obj: its boundary vertices lie on the input's", [&](Files& f) {
      std::ostringstream moved;
      moved.precision(17);
      moved << "v " << p.x() << " 1e-7 0";
      f.quads[v] = moved.str();
    });
    Files along = valid;
    std::ostringstream moved;
    moved << "v " << p.x() + 0.125 << " 0 0";
    along.flat_obj[v] = moved.str();
    CHECK(all_hold(along.verified()));
    break;
  }
  const Files other(planar({"xxxxx", "xxxxx", "xxxxx", "xxxxx", "xxxxx"}), 0, 1);
  valid.verified();
  CHECK(fails_with(verify_outputs(Output::folder(), &other.input), "flat.obj: its boundary"));
  CHECK(fails_with(verify_outputs(Output::folder(), &other.input), "quads.obj: its boundary"));
}

void spoilt_quads_fail(const Files& valid)
{
  const Spoiler fails(valid);
  const auto last_quad = [](Lines& lines) -> std::string& { return lines.back(); };
  const auto without = [&](Files& f) {   // a quad at the boundary is missing; the report knows
    f.quads.pop_back();
    json& quads = f.output.report["quad_mesh"]["quads"];
    quads = quads.get<int>() - 1;
  };
  for (const char* sentence : {"boundary are exactly the corners", "are a regular grid"}) fails(sentence, without);
  fails("no edge is shared by more than two quads", [&](Files& f) { f.quads.push_back(last_quad(f.quads)); });
  fails("no edge is shared by more than two quads", [&](Files& f) {
    std::istringstream words(last_quad(f.quads));
    std::string key, a, b, c, d;
    words >> key >> a >> b >> c >> d;
    last_quad(f.quads) = "f " + d + ' ' + c + ' ' + b + ' ' + a;
  });
  fails("quads.obj: one component", [&](Files& f) {
    const Lines copy = f.quads;
    const std::size_t n = f.output.report["quad_mesh"]["vertices"];
    for (const std::string& line : copy) {
      if (line[0] != 'f') { f.quads.push_back(line); continue; }
      std::istringstream words(line.substr(1));
      std::string quad = "f";
      for (std::size_t v = 0; words >> v; ) quad += ' ' + std::to_string(v + n);
      f.quads.push_back(quad);
    }
  });
  // two vertices of the boundary that have no neighbour in common become one: two fans
  fails("one fan on the boundary", [&](Files& f) {
    for (std::string& line : f.quads) {
      if (line[0] != 'f') continue;
      std::istringstream words(line.substr(1));
      std::string quad = "f";
      for (std::size_t v = 0; words >> v; )
        quad += ' ' + std::to_string(v == valid.input.number_of_vertices() ? 1 : v);   // the last corner of a square
      line = quad;
    }
  });
  // vertices without quads
  fails("quads.obj: 2 irregular vertices", [](Files& f) { f.quads.insert(f.quads.begin(), {"v 0 0 0", "v 0 0 0"}); });
}

void random_bytes_do_no_harm(const Files& valid)
{
  std::mt19937 random(1);
  valid.verified();
  const std::vector<std::pair<std::string, std::string>> texts = {
    {"flat_intrinsic.json", valid.output.flat.dump()}, {"tmesh.json", valid.output.tmesh.dump()},
    {"report.json", valid.output.report.dump()}, {"flat.obj", joined(valid.flat_obj)},
    {"quads.obj", joined(valid.quads)}};
  for (const auto& [name, text] : texts) {
    for (int i = 0; i < 200; ++i) {
      std::string bad = text;
      bad[random() % bad.size()] = "0123456789[]{},:\"-.eE fv/\n"[random() % 26];
      Output::write(name, bad);
      CHECK(!verify_outputs(Output::folder(), &valid.input).empty());
    }
    valid.verified();
  }
}

} // namespace

int main()
{
  valid_outputs_pass();
  orders_are_known();
  tube_needs_no_tmesh();
  nodes_on_arcs();
  const Files plate(planar({"xxxxx", "xxxxx", "xxx..", "xxx.."}), 0, 1);
  spoilt_flat_fails(plate);
  spoilt_report_fails(plate);
  curves_are_counted();
  spoilt_tmesh_fails(plate);
  spoilt_flat_obj_fails(plate);
  spoilt_quads_fail(plate);
  random_bytes_do_no_harm(plate);
  std::filesystem::remove_all(Output::folder());
  return Quartic_test::result();
}
