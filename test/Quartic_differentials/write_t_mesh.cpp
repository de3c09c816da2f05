// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// tmesh.json and tmesh.vtp of random surfaces, read back: the pieces of the faces tile the patches and the triangles.

#include "check.h"
#include "exact_charts.h"

#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/internal/patch_pieces.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

/// the same surface with random places in space for its vertices
void embed(Quartic_differential& q, std::mt19937& random)
{
  Mesh mesh = q.triangulation.mesh();
  const auto coordinate = [&] { return random() / 4294967296.0; };
  for (Vertex v : mesh.vertices()) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    mesh.point(v) = Point_3(x, y, z);
  }
  q.triangulation = Intrinsic_triangulation(std::move(mesh));
}

Quartic_differential random_surface(bool generic, std::mt19937& random)
{
  Gluing glued;
  const int squares = 2 + static_cast<int>(random() % 12);
  do glued = generic ? random_half_translation_gluing(squares, random) : random_gluing(squares, random);
  while (!is_connected(glued));
  glued = subdivided(glued, 1 + static_cast<int>(random() % 4));
  const std::int64_t side = 1 + random() % 1000;
  Quartic_differential q = generic ? exact_differential(glued, {3 * side, 7}, {11 - side, 2 * side + 1})
                                   : exact_differential(glued, {side, 0}, {0, side});
  if (q.singularities.empty()) q.singularities.push_back(Vertex(0));
  flip_exactly(q, 60, 20 * side, random);
  embed(q, random);
  return q;
}

T_mesh traced(const Quartic_differential& q)
{
  Visitor quiet;
  return t_mesh(q, quiet);
}

// JSON

Point_3 point(const nlohmann::json& p) { return Point_3(p[0], p[1], p[2]); }

void check_json(const T_mesh& t, const Quartic_differential& q)
{
  std::ostringstream out;
  write_t_mesh_json(out, t, q, "flat_intrinsic");
  const nlohmann::json file = nlohmann::json::parse(out.str());
  CHECK_EQUAL(file["grid_exponent"].get<int>(), q.grid_exponent + 1);
  CHECK_EQUAL(file["surface"].get<std::string>(), "flat_intrinsic");
  CHECK_EQUAL(file["nodes"].size(), t.nodes.size());
  CHECK_EQUAL(file["arcs"].size(), t.arcs.size());
  CHECK_EQUAL(file["patches"].size(), t.patches.size());
  for (std::size_t a = 0; a < t.arcs.size(); ++a) {
    const nlohmann::json& arc = file["arcs"][a];
    CHECK_EQUAL(arc["length"].get<std::int64_t>(), t.arcs[a].length);
    if (!q.triangulation.is_embedded()) {
      CHECK(!arc.contains("polyline"));
      continue;
    }
    const nlohmann::json& line = arc["polyline"];
    CHECK_EQUAL(line.size(), t.arcs[a].path.size() + 1);
    CHECK(point(line.front()) == point(file["nodes"][t.arcs[a].from]["position"]));
    CHECK(point(line.back()) == point(file["nodes"][t.arcs[a].to]["position"]));
  }
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    const nlohmann::json& patch = file["patches"][p];
    for (int side = 0; side < 4; ++side) {
      std::int64_t length = 0;
      for (const nlohmann::json& piece : patch["sides"][side]) length += t.arcs[piece["arc"]].length;
      CHECK_EQUAL(length, patch[side % 2 == 0 ? "width" : "height"].get<std::int64_t>());
    }
  }
}

// VTK

/// the numbers of the data array that begins after `key`
std::vector<double> numbers_after(const std::string& file, const std::string& section, const std::string& key)
{
  const std::size_t begin = file.find('>', file.find(key, file.find('<' + section))) + 1;
  std::istringstream in(file.substr(begin, file.find('<', begin) - begin));
  std::vector<double> result;
  for (double x; in >> x;) result.push_back(x);
  return result;
}

double area(const std::vector<Point_3>& polygon)
{
  auto sum = CGAL::cross_product(polygon[1] - polygon[0], polygon[1] - polygon[0]);
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    sum = sum + CGAL::cross_product(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return std::sqrt(sum.squared_length()) / 2;
}

void check_vtp(const T_mesh& t, const Quartic_differential& q)
{
  std::ostringstream out;
  write_t_mesh_vtp(out, t, q);
  const std::string file = out.str();
  const std::vector<double> xyz = numbers_after(file, "Points>", "<DataArray");
  const std::vector<double> uv = numbers_after(file, "PointData", "Name=\"uv\"");
  const std::vector<double> patch = numbers_after(file, "CellData", "Name=\"patch\"");
  const std::vector<double> arc = numbers_after(file, "CellData", "Name=\"arc\"");
  const std::vector<double> colour = numbers_after(file, "CellData", "Name=\"colour\"");
  const std::vector<double> corner = numbers_after(file, "Polys", "connectivity");
  const std::vector<double> offset = numbers_after(file, "Polys", "offsets");
  const std::size_t lines = numbers_after(file, "Lines", "offsets").size();
  CHECK_EQUAL(lines, t.arcs.size());
  CHECK_EQUAL(xyz.size() / 3, uv.size() / 2);
  CHECK_EQUAL(patch.size(), lines + offset.size());
  CHECK_EQUAL(arc.size(), lines + offset.size());
  CHECK_EQUAL(colour.size(), 3 * (lines + offset.size()));

  double triangles = 0, cells = 0;
  for (Face f : q.triangulation.faces()) {
    std::vector<Point_3> corners;
    for (Halfedge h : q.triangulation.halfedges(f)) corners.push_back(q.triangulation.mesh().point(q.triangulation.source(h)));
    triangles += area(corners);
  }
  const double unit = std::ldexp(1.0, -t.grid_exponent);
  std::vector<double> covered(t.patches.size(), 0);
  std::size_t begin = 0;
  for (std::size_t c = 0; c < offset.size(); ++c) {
    const std::size_t end = static_cast<std::size_t>(offset[c]);
    std::vector<Point_3> in_space, in_patch;
    const T_mesh::Patch& p = t.patches.at(static_cast<std::size_t>(patch[lines + c]));
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = static_cast<std::size_t>(corner[k]);
      in_space.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
      in_patch.emplace_back(uv[2 * i], uv[2 * i + 1], 0);
      CHECK(uv[2 * i] >= 0 && uv[2 * i] <= p.width * unit && uv[2 * i + 1] >= 0 && uv[2 * i + 1] <= p.height * unit);
    }
    cells += area(in_space);
    covered[static_cast<std::size_t>(patch[lines + c])] += area(in_patch);
    begin = end;
  }
  CHECK_NEAR(cells, triangles, 1e-12 * (1 + triangles));
  for (std::size_t p = 0; p < covered.size(); ++p) {
    const double whole = t.patches[p].width * unit * t.patches[p].height * unit;
    CHECK_NEAR(covered[p], whole, 1e-12 * whole);
  }
}

void random_surfaces()
{
  std::mt19937 random(11);
  for (int k = 0; k < 100; ++k) {
    const Quartic_differential q = random_surface(k % 2 == 0, random);
    const T_mesh t = traced(q);
    check_json(t, q);
    check_vtp(t, q);
  }
}

void surface_without_positions()
{
  Quartic_differential q = exact_differential({2, 3, 0, 1}, {12, 0}, {5, 30});
  q.singularities.push_back(Vertex(0));
  check_json(traced(q), q);
}

} // namespace

int main()
{
  random_surfaces();
  surface_without_positions();
  return result();
}
