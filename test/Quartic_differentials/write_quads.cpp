// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of quad meshes read back bit by bit: OFF and PLY with CGAL's readers, OBJ and VTU number by number.

#include "check.h"
#include "run_pipeline.h"
#include "vtk_xml.h"

#include <CGAL/Quartic_differentials/IO/write_quads.h>
#include <CGAL/Quartic_differentials/quantize.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/IO/io.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

struct Example
{
  T_mesh    t_mesh;
  Quad_mesh quads;
};

// a surface of genus 2, a few points of which are moved to where numbers are awkward to print
Example example()
{
  const Intrinsic_triangulation input(handle_chain(2, 6));
  const Quartic_differential_result r = run_pipeline(input);
  Quantization_options options;
  options.number_of_quads = 300;
  Visitor quiet;
  Example e{*r.t_mesh, quad_mesh(*r.t_mesh, quantize(*r.t_mesh, options, quiet).length, *r.refined)};
  e.quads.points[0] = Point_3(1.0 / 3, -0.0, 1e-300);
  e.quads.points[1] = Point_3(0.1 + 0.2, std::nextafter(1.0, 2.0), -1.7976931348623157e100);
  return e;
}

using Quartic_test::is_identical;

bool is_identical(const Point_3& p, const Point_3& q)
{ return is_identical(p.x(), q.x()) && is_identical(p.y(), q.y()) && is_identical(p.z(), q.z()); }

void check_points(const std::vector<Point_3>& points, const Quad_mesh& m)
{
  CHECK_EQUAL(points.size(), m.points.size());
  for (std::size_t v = 0; v < std::min(points.size(), m.points.size()); ++v)
    CHECK(is_identical(points[v], m.points[v]));
}

void check_read_back(const Mesh& mesh, const Quad_mesh& m)
{
  std::vector<Point_3> points;
  for (Vertex v : mesh.vertices()) points.push_back(mesh.point(v));
  check_points(points, m);
  std::vector<std::array<std::size_t, 4>> quads;
  for (Face f : mesh.faces()) {
    CHECK_EQUAL(mesh.degree(f), 4u);
    std::array<std::size_t, 4> quad;
    std::size_t k = 0;
    for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) quad[k++ % 4] = v;
    quads.push_back(quad);
  }
  CHECK_EQUAL(quads.size(), m.quads.size());
  // a mesh knows the circle of a face, not where it begins
  for (std::size_t f = 0; f < std::min(quads.size(), m.quads.size()); ++f) {
    std::rotate(quads[f].begin(), std::find(quads[f].begin(), quads[f].end(), m.quads[f][0]), quads[f].end());
    CHECK(quads[f] == m.quads[f]);
  }
}

std::vector<int> orders(const Example& e)
{
  std::vector<int> order(e.quads.points.size(), 0);
  std::size_t s = 0;
  for (const T_mesh::Node& node : e.t_mesh.nodes)
    if (node.order != 0) order[e.quads.singularities[s++]] = node.order;
  return order;
}

void obj(const Example& e)
{
  std::stringstream file;
  write_quads_obj(file, e.quads);
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 4>> quads;
  std::vector<std::size_t> patch;
  std::size_t group = 0;
  for (std::string line; std::getline(file, line); ) {
    std::istringstream words(line.substr(1));
    std::array<std::string, 3> x;
    std::array<std::size_t, 4> quad;
    if (line[0] == 'v') {
      words >> x[0] >> x[1] >> x[2];
      points.emplace_back(std::strtod(x[0].c_str(), nullptr), std::strtod(x[1].c_str(), nullptr),
                          std::strtod(x[2].c_str(), nullptr));
    } else if (line[0] == 'f') {
      for (std::size_t& v : quad) {
        words >> v;
        --v;
      }
      quads.push_back(quad);
      patch.push_back(group);
    } else {
      CHECK_EQUAL(line.substr(0, 8), "g patch_");
      group = std::strtoull(line.c_str() + 8, nullptr, 10);
    }
  }
  check_points(points, e.quads);
  CHECK(quads == e.quads.quads);
  CHECK(patch == e.quads.patch);
}

void off(const Example& e)
{
  std::stringstream file;
  write_quads_off(file, e.quads, e.t_mesh);
  Mesh mesh;
  CHECK(CGAL::IO::read_OFF(file, mesh));
  check_read_back(mesh, e.quads);
}

void ply(const Example& e)
{
  std::stringstream file;
  write_quads_ply(file, e.quads, e.t_mesh);
  CHECK(file.str().find("format binary_little_endian") != std::string::npos);
  Mesh mesh;
  std::string comments;
  CGAL::IO::set_binary_mode(file);
  CHECK(CGAL::IO::read_PLY(file, mesh, comments));
  check_read_back(mesh, e.quads);
  const auto [patch, is_new_patch] = mesh.add_property_map<Face, std::uint32_t>("f:patch");   // finds what was read
  const auto [order, is_new_order] = mesh.add_property_map<Vertex, std::int32_t>("v:singularity_order");
  CHECK(!is_new_patch && !is_new_order);
  for (Face f : mesh.faces()) CHECK_EQUAL(patch[f], e.quads.patch[f]);
  const std::vector<int> expected = orders(e);
  for (Vertex v : mesh.vertices()) CHECK_EQUAL(order[v], expected[v]);
}

void vtu(const Example& e)
{
  std::stringstream stream;
  write_quads_vtu(stream, e.quads, e.t_mesh);
  const std::string file = stream.str();
  const std::size_t quads = e.quads.quads.size();
  CHECK(file.find("<Piece NumberOfPoints=\"" + std::to_string(e.quads.points.size()) + "\" NumberOfCells=\""
                  + std::to_string(quads) + "\">") != std::string::npos);
  const std::vector<double> x = data_array(file, "NumberOfComponents=\"3\"");
  std::vector<Point_3> points;
  for (std::size_t i = 0; i + 2 < x.size(); i += 3) points.emplace_back(x[i], x[i + 1], x[i + 2]);
  check_points(points, e.quads);
  std::vector<std::size_t> vertices, offsets;
  for (const auto& quad : e.quads.quads) {
    vertices.insert(vertices.end(), quad.begin(), quad.end());
    offsets.push_back(vertices.size());
  }
  check_data(file, "connectivity", vertices);
  check_data(file, "offsets", offsets);
  check_data(file, "types", std::vector<int>(quads, 9));   // VTK_QUAD
  check_data(file, "patch", e.quads.patch);
  check_data(file, "singularity_order", orders(e));
  const std::vector<double> jacobian = data_array(file, "Name=\"scaled_jacobian\"");
  CHECK_EQUAL(jacobian.size(), quads);
  CHECK(*std::min_element(jacobian.begin(), jacobian.end()) == scaled_jacobian(e.quads).least);
  const std::vector<double> ratio = data_array(file, "Name=\"edge_ratio\"");
  CHECK_EQUAL(ratio.size(), quads);
  for (std::size_t f = 0; f < std::min(quads, ratio.size()); ++f) {
    std::array<double, 4> side;
    for (int k = 0; k < 4; ++k)
      side[k] = std::sqrt(CGAL::squared_distance(e.quads.corners(f)[k], e.quads.corners(f)[(k + 1) % 4]));
    const auto [least, most] = std::minmax_element(side.begin(), side.end());
    CHECK_NEAR(ratio[f], *most / *least, 1e-12 * ratio[f]);
  }
}

} // namespace

int main()
{
  const Example e = example();
  CHECK(e.quads.quads.size() > 200 && e.quads.singularities.size() >= 8);
  obj(e);
  off(e);
  ply(e);
  vtu(e);
  return result();
}
