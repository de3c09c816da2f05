// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Quad meshes: surfaces of squares must come back square by square; surfaces from the whole pipeline become closed
// meshes of their genus on the input; coarse ones are simple; damage is found.

#include "check.h"
#include "exact_charts.h"
#include "own_input.h"
#include "run_pipeline.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>
#include <CGAL/Quartic_differentials/quantize.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

Visitor quiet;

/// what holds for every result
Mesh check_quad_mesh(const Quad_mesh& m, const T_mesh& t, const std::vector<int>& q)
{
  CHECK_EQUAL(defect(m, t), "");
  std::vector<std::size_t> quads(t.patches.size(), 0);
  for (std::size_t p : m.patch) ++quads[p];
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    std::size_t sides[4] = {0, 0, 0, 0};
    for (int k = 0; k < 4; ++k)
      for (const T_mesh::Side_piece& s : t.patches[p].sides[k]) sides[k] += q[s.arc];
    CHECK_EQUAL(quads[p], sides[0] * sides[1]);
  }
  Mesh mesh = surface_mesh(m, t);
  CHECK(mesh.is_valid());
  CHECK(CGAL::is_closed(mesh) && CGAL::is_quad_mesh(mesh));
  CHECK_EQUAL(mesh.number_of_faces(), m.quads.size());
  CHECK_EQUAL(mesh.number_of_vertices(), m.points.size());
  const auto order = mesh.add_property_map<Vertex, int>("v:singularity_order").first;   // the one that is there
  std::multiset<int> orders, expected;
  for (Vertex v : mesh.vertices()) {
    CHECK_EQUAL(static_cast<int>(mesh.degree(v)), order[v] + 4);
    if (order[v] != 0) orders.insert(order[v]);
  }
  for (const T_mesh::Node& node : t.nodes)
    if (node.order != 0) expected.insert(node.order);
  CHECK(orders == expected);
  const auto patch = mesh.add_property_map<Face, std::uint32_t>("f:patch").first;
  for (Face f : mesh.faces()) CHECK_EQUAL(patch[f], m.patch[f]);
  return mesh;
}

/// a surface with random places in space for its vertices, as its own refinement
Refined_surface embedded(Quartic_differential q, std::mt19937& random)
{
  Mesh mesh = q.triangulation.mesh();
  for (Vertex v : mesh.vertices()) {
    const double x = uniform(random, 0, 1), y = uniform(random, 0, 1), z = uniform(random, 0, 1);
    mesh.point(v) = Point_3(x, y, z);
  }
  q.triangulation = Intrinsic_triangulation(std::move(mesh));
  return own_input(q);
}

/// a surface of squares without poles of order -3, each cut into subdivision^2
Gluing squares(int most, int subdivision, std::mt19937& random)
{
  for (;;) {
    const Gluing glued = random_gluing(1 + static_cast<int>(random() % most), random);
    if (!is_connected(glued)) continue;
    const std::vector<int> order = square_tiled_surface(glued).order;
    if (*std::min_element(order.begin(), order.end()) > -3) return subdivided(glued, subdivision);
  }
}

Quartic_differential marked_differential(const Gluing& glued, std::int64_t side)
{
  Quartic_differential q = exact_differential(glued, {side, 0}, {0, side});
  if (q.singularities.empty()) q.singularities.push_back(Vertex(0));
  return q;
}

Quantization quantized(const T_mesh& t, const Quartic_differential& q, double side)
{
  Quantization_options options;
  options.edge_length = std::ldexp(side, -q.grid_exponent);
  return quantize(t, options, quiet);
}

using Square = std::array<std::size_t, 4>;

/// beginning with the least vertex
Square normal_form(Square s)
{
  std::rotate(s.begin(), std::min_element(s.begin(), s.end()), s.end());
  return s;
}

// The quads of a surface of squares are the squares, with their corners in place: on any triangulation of it.
void squares_come_back()
{
  std::mt19937 random(1);
  for (int done = 0; done < 40; ++done) {
    const std::int64_t side = 1 + random() % 50;
    Quartic_differential q = marked_differential(squares(8, 4, random), side);
    std::multiset<Square> expected;
    for (std::size_t s = 0; s < q.triangulation.number_of_faces() / 2; ++s) {
      const auto lower = q.triangulation.halfedges(Face(static_cast<Mesh::size_type>(2 * s)));
      const auto upper = q.triangulation.halfedges(Face(static_cast<Mesh::size_type>(2 * s + 1)));
      expected.insert(normal_form({q.triangulation.source(lower[0]), q.triangulation.source(lower[1]),
                                   q.triangulation.source(lower[2]), q.triangulation.source(upper[2])}));
    }
    if (done % 2 == 1) flip_exactly(q, 200, 20 * side, random);
    const Refined_surface surface = embedded(std::move(q), random);
    const Intrinsic_triangulation& triangulation = surface.differential.triangulation;
    const T_mesh t = t_mesh(surface.differential, quiet);
    const std::vector<int> lengths = quantized(t, surface.differential, double(side)).length;
    const Quad_mesh m = quad_mesh(t, lengths, surface);
    check_quad_mesh(m, t, lengths);
    std::vector<std::size_t> at;   // by vertex: the vertex of the triangulation on which it is
    for (std::size_t v = 0; v < m.points.size(); ++v) {
      const Surface_point& p = m.input_points[v];
      const auto largest = std::max_element(p.barycentric.begin(), p.barycentric.end());
      CHECK_NEAR(*largest, 1, 1e-15);
      at.push_back(triangulation.source(triangulation.halfedges(p.face)[largest - p.barycentric.begin()]));
      CHECK(m.points[v] == triangulation.mesh().point(Vertex(static_cast<Mesh::size_type>(at.back()))));
    }
    CHECK_EQUAL(std::set<std::size_t>(at.begin(), at.end()).size(), triangulation.number_of_vertices());
    std::multiset<Square> found;
    for (const Square& quad : m.quads) found.insert(normal_form({at[quad[0]], at[quad[1]], at[quad[2]], at[quad[3]]}));
    CHECK(found == expected);
  }
}

// As few quads as there can be: simple polygons all the same.
void coarse_quads()
{
  std::mt19937 random(2);
  std::size_t zeros = 0;
  for (int done = 0; done < 80; ++done) {
    const Refined_surface surface = embedded(marked_differential(squares(16, 1, random), 64), random);
    const T_mesh t = t_mesh(surface.differential, quiet);
    const std::vector<int> q = quantized(t, surface.differential, 64 / uniform(random, 0.1, 1.5)).length;
    check_quad_mesh(quad_mesh(t, q, surface), t, q);
    zeros += std::count(q.begin(), q.end(), 0);
  }
  CHECK(zeros > 100);
}

void check_sample(const std::string& name, Mesh input)
{
  const double area = CGAL::Polygon_mesh_processing::area(input);
  const Intrinsic_triangulation surface(std::move(input));
  const Quartic_differential_result r = run_pipeline(surface);
  CHECK(r.t_mesh.has_value() && r.refined.has_value());
  if (!r.t_mesh || !r.refined) return;
  const T_mesh& t = *r.t_mesh;
  for (std::size_t target : {1, 200, 2000, 20000}) {
    Quantization_options options;
    options.number_of_quads = target;
    const std::vector<int> q = quantize(t, options, quiet).length;
    const Quad_mesh m = quad_mesh(t, q, *r.refined);
    const Mesh mesh = check_quad_mesh(m, t, q);
    double furthest = 0;
    for (std::size_t v = 0; v < m.points.size(); ++v)
      furthest = std::max(furthest, CGAL::squared_distance(m.points[v], position_on_input(surface, m.input_points[v])));
    CHECK(std::sqrt(furthest) < 1e-12);
    const Scaled_jacobian jacobian = scaled_jacobian(m);
    CHECK(jacobian.least <= jacobian.mean && jacobian.mean <= 1);
    if (target < 20000) continue;
    // fine quads follow the surface, and most are nearly square, since the map is conformal
    double quads = 0;
    for (Face f : mesh.faces()) {
      const auto& [a, b, c, d] = m.quads[f];
      quads += std::sqrt(CGAL::squared_area(m.points[a], m.points[b], m.points[c]))
             + std::sqrt(CGAL::squared_area(m.points[a], m.points[c], m.points[d]));
    }
    CHECK_NEAR(quads / area, 1, 0.01);
    CHECK(jacobian.mean > 0.9);
    std::cout << name << ": " << m.quads.size() << " quads, scaled Jacobian at least " << jacobian.least << ", mean "
              << jacobian.mean << ", area " << quads / area << " of the input's\n";
  }
}

// Every kind of damage is found.
void damaged_quad_meshes()
{
  std::mt19937 random(3);
  const Refined_surface surface = embedded(marked_differential({4, 7, 6, 5, 0, 3, 2, 1}, 64), random);   // a pillow
  const T_mesh t = t_mesh(surface.differential, quiet);
  const Quad_mesh good = quad_mesh(t, quantized(t, surface.differential, 16).length, surface);
  CHECK_EQUAL(defect(good, t), "");
  const std::vector<std::pair<std::string, std::function<void(Quad_mesh&)>>> damages = {
    {"sizes", [](Quad_mesh& m) { m.patch.pop_back(); }},
    {"sizes", [](Quad_mesh& m) { m.input_points.pop_back(); }},
    {"does not exist", [](Quad_mesh& m) { m.quads[0][1] = m.points.size(); }},
    {"a vertex twice", [](Quad_mesh& m) { m.quads[0][2] = m.quads[0][0]; }},
    {"two quads run", [](Quad_mesh& m) { m.quads.push_back(m.quads[0]); m.patch.push_back(0); }},
    {"two quads run", [](Quad_mesh& m) { std::swap(m.quads[0][0], m.quads[0][2]); }},
    {"one quad only", [](Quad_mesh& m) { m.quads.pop_back(); m.patch.pop_back(); }},
    {"no vertex", [](Quad_mesh& m) { m.singularities.pop_back(); }},
    {"two singularities", [](Quad_mesh& m) { m.singularities[0] = m.singularities[1]; }},
    {"quads", [](Quad_mesh& m) { m.singularities[0] = m.quads[5][0] == m.singularities[0] ? m.quads[5][1]
                                                                                         : m.quads[5][0]; }},
    {"quads", [](Quad_mesh& m) { m.points.push_back(m.points[0]); m.input_points.push_back(m.input_points[0]); }},
  };
  for (const auto& [part, damage] : damages) {
    Quad_mesh bad = good;
    damage(bad);
    const std::string violation = defect(bad, t);
    if (violation.find(part) == std::string::npos) std::cerr << "expected \"" << part << "\": " << violation << '\n';
    CHECK(violation.find(part) != std::string::npos);
  }
  // a second surface that touches the first in one vertex, or not at all
  Quad_mesh two = good;
  const std::size_t n = good.points.size();
  two.points.insert(two.points.end(), good.points.begin(), good.points.end());
  two.input_points.insert(two.input_points.end(), good.input_points.begin(), good.input_points.end());
  for (std::array<std::size_t, 4> quad : good.quads) {
    for (std::size_t& v : quad) v += n;
    two.quads.push_back(quad);
    two.patch.push_back(0);
  }
  CHECK(!defect(two, t).empty());
  for (auto& quad : two.quads)
    for (std::size_t& v : quad)
      if (v == n) v = 0;
  CHECK(defect(two, t).find("not one circle") != std::string::npos);
}

void scaled_jacobians()
{
  const auto of = [](Point_3 a, Point_3 b, Point_3 c, Point_3 d) {
    Quad_mesh m;
    m.points = {a, b, c, d};
    m.quads = {{0, 1, 2, 3}};
    const Scaled_jacobian result = scaled_jacobian(m);
    CHECK_EQUAL(result.least, result.mean);
    return result.least;
  };
  const double sine = std::sqrt(0.75);
  CHECK_NEAR(of({0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}), 1, 1e-15);
  CHECK_NEAR(of({0, 0, 1}, {0, 1, 1}, {sine, 1.5, 1}, {sine, 0.5, 1}), sine, 1e-15);    // a rhombus
  CHECK_NEAR(of({0, 0, 0}, {1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}), -0.8, 1e-15);        // an arrow
  CHECK_NEAR(of({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0, 1e-15);
  CHECK_NEAR(of({0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}), std::sqrt(2.0 / 3), 1e-15);   // folded
}

} // namespace

int main()
{
  squares_come_back();
  coarse_quads();
  damaged_quad_meshes();
  scaled_jacobians();
  check_sample("sphere", bumpy_sphere(3));
  check_sample("torus", jittered_torus(40, 20, 0.3, 0.5, 2));
  check_sample("genus 2", handle_chain(2, 8));
  check_sample("genus 3", handle_ring(3, 8));
  return result();
}
