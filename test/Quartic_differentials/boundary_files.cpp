// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is made of T-meshes on surfaces with boundary but quads: surfaces cut along them, lines drawn on the input, files.

#include "check.h"
#include "run_pipeline.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/IO/write_t_spline.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/patch_pieces.h>
#include <CGAL/Quartic_differentials/patch_mesh.h>
#include <CGAL/Quartic_differentials/pull_back.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/pending/disjoint_sets.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

using namespace Quartic_test;
using Json = nlohmann::json;

namespace {

// The mesh has the surface's boundary curves, its boundary edges are those of the arcs there, every patch is filled.
void check_patch_mesh(const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  Mesh m = patch_mesh(*r.t_mesh, *r.refined);
  CHECK(CGAL::is_valid_polygon_mesh(m));
  const Intrinsic_triangulation cut(m);
  CHECK_EQUAL(cut.number_of_boundary_curves(), input.number_of_boundary_curves());
  CHECK_EQUAL(cut.genus(), input.genus());
  CHECK_NEAR(cut.area(), input.area(), 1e-9 * input.area());
  const auto arc = m.add_property_map<Edge, std::uint32_t>("e:arc").first;
  const auto place = m.add_property_map<Vertex, Surface_point>("v:input_point").first;
  const auto patch = m.add_property_map<Face, std::uint32_t>("f:patch").first;
  const auto texture = m.add_property_map<Halfedge, CGAL::Simple_cartesian<double>::Point_2>("h:texture").first;
  for (Edge e : m.edges())
    CHECK_EQUAL(m.is_border(e), arc[e] != no_arc && r.t_mesh->arcs[arc[e]].on_boundary);
  for (Vertex v : m.vertices()) {
    if (!m.is_border(v)) continue;
    CHECK(is_on_boundary(input, place[v]));
    CHECK_NEAR(std::sqrt(CGAL::squared_distance(position_on_input(input, place[v]), m.point(v))), 0, 1e-12);
  }
  std::vector<double> filled(r.t_mesh->patches.size(), 0);
  for (Face f : m.faces()) {
    const Halfedge h = m.halfedge(f), n = m.next(h);
    filled[patch[f]] += CGAL::area(texture[h], texture[n], texture[m.next(n)]);
  }
  for (std::size_t p = 0; p < filled.size(); ++p) {
    const double unit = std::ldexp(1.0, -r.t_mesh->grid_exponent);
    const double area = unit * double(r.t_mesh->patches[p].width) * unit * double(r.t_mesh->patches[p].height);
    CHECK_NEAR(filled[p], area, 1e-9 * area);
  }
}

// Both are glued along the same edges; on the boundary nothing is.
void check_intrinsic_file(const Quartic_differential& q)
{
  std::ostringstream out;
  write_flat_intrinsic_json(out, q);
  const Json opposite = Json::parse(out.str())["opposite"];
  std::size_t on_boundary = 0, expected = 0;
  for (std::size_t f = 0; f < opposite.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int g = opposite[f][k][0], e = opposite[f][k][1];
      if (g < 0) {
        CHECK_EQUAL(e, -1);
        ++on_boundary;
        continue;
      }
      CHECK_EQUAL(opposite[g][e][0].get<std::size_t>(), f);
      CHECK_EQUAL(opposite[g][e][1].get<int>(), k);
    }
  for (Edge e : q.triangulation.edges()) expected += q.triangulation.is_border(e);
  CHECK_EQUAL(on_boundary, expected);
}

// Texture vertices are the classes of corners that edges with the identity join.
void check_flat_file(const Quartic_differential& q)
{
  const std::string folder = std::filesystem::temp_directory_path() / "quartic_boundary_files";
  std::filesystem::create_directories(folder);
  write_flat_obj(folder, "flat", q);
  std::ifstream file(folder + "/flat.obj");
  std::vector<std::pair<double, double>> uv;
  std::vector<std::array<std::size_t, 3>> texture;
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line.substr(2));
    if (line.rfind("vt", 0) == 0) {
      auto& z = uv.emplace_back();
      in >> z.first >> z.second;
    }
    if (line.rfind("f ", 0) == 0) {
      auto& corners = texture.emplace_back();
      char slash;
      std::size_t v;
      for (std::size_t& c : corners) in >> v >> slash >> c;
    }
  }
  const Intrinsic_triangulation& t = q.triangulation;
  CHECK_EQUAL(texture.size(), t.number_of_faces());
  boost::disjoint_sets_with_storage<> corners(t.number_of_halfedges());
  for (Halfedge h : t.halfedges())
    if (!t.is_border(t.edge(h)) && q.transition[h].is_identity()) corners.union_set(h.idx(), t.next(t.opposite(h)).idx());
  std::map<std::size_t, std::size_t> vertex_of_class;
  std::set<std::size_t> used;
  for (Face f : t.faces())
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = t.halfedges(f)[k];
      const std::size_t vt = texture[f][k] - 1;
      CHECK_EQUAL(std::ldexp(uv[vt].first, q.grid_exponent), double(q.corner[h].x));
      CHECK_EQUAL(std::ldexp(uv[vt].second, q.grid_exponent), double(q.corner[h].y));
      CHECK_EQUAL(vertex_of_class.try_emplace(corners.find_set(h.idx()), vt).first->second, vt);
      used.insert(vt);
    }
  CHECK_EQUAL(used.size(), uv.size());
  CHECK_EQUAL(vertex_of_class.size(), uv.size());
}

// Every arc is one line from its first node to its last.
void check_t_mesh_files(const Quartic_differential_result& r)
{
  const T_mesh& t = *r.t_mesh;
  const Quartic_differential& q = r.refined->differential;
  std::ostringstream json, obj, tsp, vtp;
  write_t_mesh_json(json, t, q, "input");
  const Json file = Json::parse(json.str());
  std::map<std::string, std::size_t> kinds;
  for (const Json& node : file["nodes"]) ++kinds[node["kind"]];
  std::size_t corners = 0;
  for (const Singularity& s : r.singularities) corners += s.on_boundary;
  CHECK_EQUAL(kinds["corner"], corners);

  write_t_mesh_obj(obj, patch_mesh(t, *r.refined));
  std::vector<Point_3> points;
  std::istringstream in(obj.str());
  std::size_t arc = 0, lines = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      double x, y, z;
      words >> x >> y >> z;
      points.emplace_back(x, y, z);
    }
    if (line.rfind("g arc_", 0) == 0) arc = std::stoul(line.substr(6));
    if (word != "l") continue;
    ++lines;
    std::vector<Point_3> way, expected;
    for (std::size_t v; words >> v;) way.push_back(points[v - 1]);
    for (const Json& p : file["arcs"][arc]["polyline"]) expected.emplace_back(p[0], p[1], p[2]);
    CHECK(way == expected || std::equal(way.begin(), way.end(), expected.rbegin(), expected.rend()));
  }
  CHECK_EQUAL(lines, t.arcs.size());

  write_t_spline(tsp, t, q);
  CHECK(tsp.str().find("This surface has a boundary") != std::string::npos);
  write_t_mesh_vtp(vtp, t, q);
  CHECK(vtp.str().find("NumberOfLines=\"" + std::to_string(t.arcs.size()) + '"') != std::string::npos);
}

// Straight on from a corner, the boundary on the right: as far as the next corner there are the vertices of the boundary,
// and from there on the line is inside the surface, or has left it.
void check_lines_along_boundary(const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  const Quartic_differential& q = r.refined->differential;
  const Intrinsic_triangulation& t = q.triangulation;
  for (Vertex v : q.singularities) {
    if (!t.is_border(v)) continue;
    const Halfedge first = t.halfedge_from(v);
    const Grid_vector begin = q.corner[first], edge = q.corner[t.next(first)] - begin;
    const auto sign = [](std::int64_t x) { return static_cast<std::int64_t>(x > 0) - static_cast<std::int64_t>(x < 0); };
    const Grid_vector direction{sign(edge.x), sign(edge.y)};
    std::int64_t length = 0;
    std::size_t edges = 0;
    Halfedge h = first;
    for (;; h = t.next_on_boundary(h)) {
      const Grid_vector d = q.corner[t.next(h)] - q.corner[h];
      length += std::abs(d.x) + std::abs(d.y);
      ++edges;
      if (q.order[t.target(h)] != 0) break;
    }
    const auto line = [&](std::int64_t n)
    { return pull_back(*r.refined, t.face(first), {begin, {begin.x + n * direction.x, begin.y + n * direction.y}}); };
    const Pulled_back_arc along = line(length);
    CHECK_EQUAL(along.points.size(), edges + 1);
    for (const Surface_point& p : along.points) CHECK(is_on_boundary(input, p));
    CHECK(along.last_face == t.face(h));
    if (q.order[t.target(h)] < 0) {
      CHECK_THROWS(line(length + 1), Numerical_error, "leaves the surface");
    } else {
      const Pulled_back_arc beyond = line(length + 1);
      CHECK_EQUAL(beyond.points.size(), edges + 2);
      CHECK(!is_on_boundary(input, beyond.points.back()));
    }
    if (q.order[v] >= 0) continue;
    const Grid_vector outside{begin.x + direction.y, begin.y - direction.x};   // to the right
    CHECK_THROWS(pull_back(*r.refined, t.face(first), {begin, outside}), Numerical_error, "leaves the surface");
  }
}

// An arc that is a whole boundary curve begins and ends at its corner, which has no other arms if a single quad is there.
void test_loop()
{
  Mesh m;
  const auto order = m.add_property_map<Vertex, int>("v:singularity_order", 0).first;
  const auto arc = m.add_property_map<Edge, std::uint32_t>("e:arc", no_arc).first;
  m.add_property_map<Face, std::uint32_t>("f:patch", 0);
  m.add_property_map<Halfedge, CGAL::Simple_cartesian<double>::Point_2>("h:texture");
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(-1, 0, 0), Point_3(0, -1, 0)})
    m.add_vertex(p);
  for (Mesh::size_type k = 0; k < 4; ++k) m.add_face(Vertex(0), Vertex(1 + k), Vertex(1 + (k + 1) % 4));
  for (Edge e : m.edges())
    if (m.is_border(e)) arc[e] = 0;
  for (Mesh::size_type corner = 1; corner < 5; ++corner) {
    for (Vertex v : m.vertices()) order[v] = v == Vertex(corner) ? -1 : 0;
    std::ostringstream out;
    write_t_mesh_obj(out, m);
    std::istringstream line(out.str().substr(out.str().find("\nl ") + 3));
    std::vector<std::size_t> way(5);
    for (std::size_t& v : way) line >> v;
    CHECK_EQUAL(way.front(), corner + 1);
    CHECK_EQUAL(way.back(), corner + 1);
  }
}

void check(const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  check_patch_mesh(input, r);
  check_intrinsic_file(*r.differential);
  check_intrinsic_file(r.refined->differential);
  check_flat_file(r.refined->differential);
  check_t_mesh_files(r);
  check_lines_along_boundary(input, r);
}

} // namespace

int main()
{
  test_loop();
  const Intrinsic_triangulation sheet = sheet_of_squares(), ring(plate(1, 14));
  check(sheet, run_pipeline(sheet, corners_of_sheet(sheet)));
  check(ring, run_pipeline(ring, Divisor()));
  std::mt19937 random(12);
  int checked = 0;
  for (const Surface_with_boundary& s : surfaces_with_boundary()) {
    const Boundary_case c = random_case(s, random);
    std::cout << c.name << ", " << c.divisor.size() << " singularities" << std::endl;
    try {
      check(c.surface, run_pipeline(c.surface, c.divisor));
      ++checked;
    } catch (const Infeasible_divisor_error& e) {
      std::cout << e.what() << std::endl;
    }
  }
  CHECK(checked > 8);
  return Quartic_test::result();
}
