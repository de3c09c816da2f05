// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Quads and splines on surfaces with boundary: counts and valences, and the boundary of the quads on that of the surface.

#include "check.h"
#include "run_pipeline.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/IO/write_multipatch.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/quads.h>

#include <CGAL/boost/graph/helpers.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <limits>
#include <sstream>

using namespace Quartic_test;

namespace {

const std::size_t none = static_cast<std::size_t>(-1);

Visitor quiet;

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

double distance_to_boundary(const Intrinsic_triangulation& t, const Point_3& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (Edge e : t.edges()) {
    if (!t.is_border(e)) continue;
    const Halfedge h = t.halfedge(e);
    const CGAL::Simple_cartesian<double>::Segment_3 segment(t.mesh().point(t.source(h)), t.mesh().point(t.target(h)));
    least = std::min(least, CGAL::squared_distance(p, segment));
  }
  return std::sqrt(least);
}

// Genus, boundary curves and valences, counted in the mesh.
void check_counts(const Intrinsic_triangulation& input, const T_mesh& t, const Quad_mesh& m)
{
  CHECK_EQUAL(defect(m, t), "");
  const Mesh mesh = surface_mesh(m, t);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  const long vertices = static_cast<long>(mesh.number_of_vertices()), edges = static_cast<long>(mesh.number_of_edges());
  const long faces = static_cast<long>(mesh.number_of_faces());
  CHECK_EQUAL(vertices - edges + faces, 2l - 2 * input.genus() - input.number_of_boundary_curves());
  std::vector<int> irregular(m.points.size(), 0);
  std::vector<char> is_corner(m.points.size(), false);
  std::size_t s = 0;
  for (const T_mesh::Node& node : t.nodes) {
    if (!node.is_singularity()) continue;
    irregular[m.singularities[s]] = node.order;
    is_corner[m.singularities[s++]] = node.kind == T_mesh::Node_kind::corner;
  }
  for (Vertex v : mesh.vertices()) {
    CHECK_EQUAL(static_cast<int>(mesh.degree(v)), irregular[v] + (mesh.is_border(v) ? 3 : 4));
    if (is_corner[v]) CHECK(mesh.is_border(v));
  }
}

// The quads' boundary runs once round every curve of the surface's, through its corners.
void check_boundary(const Intrinsic_triangulation& input, const Quartic_differential_result& r, const Quad_mesh& m)
{
  std::vector<double> begin(input.number_of_edges(), 0), whole(input.number_of_edges(), 0);
  for (const std::vector<Halfedge>& curve : input.boundary_curves()) {
    double length = 0;
    for (Halfedge h : curve) {
      begin[input.edge(h)] = length;
      length += input.length(h);
    }
    for (Halfedge h : curve) whole[input.edge(h)] = length;
  }
  const double size = std::sqrt(input.area());
  const std::vector<std::size_t> next = next_on_boundary(m);
  std::vector<double> run(input.number_of_edges(), 0);   // by the edge with which a curve begins
  for (std::size_t v = 0; v < next.size(); ++v) {
    CHECK_NEAR(distance(m.points[v], position_on_input(input, m.input_points[v])), 0, 1e-12 * size);
    if (next[v] == none) continue;
    CHECK(is_on_boundary(input, m.input_points[v]));
    CHECK_NEAR(distance_to_boundary(input, m.points[v]), 0, 1e-12 * size);
    const internal::Boundary_place a = internal::boundary_place(input, m.input_points[v]),
                                   b = internal::boundary_place(input, m.input_points[next[v]]);
    CHECK(a.halfedge != Mesh::null_halfedge() && b.halfedge != Mesh::null_halfedge());
    const Edge from = input.edge(a.halfedge), to = input.edge(b.halfedge);
    CHECK_EQUAL(whole[from], whole[to]);
    const double way = begin[to] + b.fraction * input.length(to) - begin[from] - a.fraction * input.length(from);
    run[from] += way > 0 ? way : way + whole[from];
  }
  for (const std::vector<Halfedge>& curve : input.boundary_curves()) {
    double sum = 0;
    for (Halfedge h : curve) sum += run[input.edge(h)];
    CHECK_NEAR(sum, whole[input.edge(curve.front())], 1e-9 * size);
  }
  const Intrinsic_triangulation& refined = r.refined->differential.triangulation;
  std::size_t s = 0;
  for (const T_mesh::Node& node : r.t_mesh->nodes) {
    if (!node.is_singularity()) continue;
    const Point_3& p = m.points[m.singularities[s++]];
    if (node.kind == T_mesh::Node_kind::corner) CHECK_NEAR(distance(p, refined.mesh().point(node.vertex)), 0, 1e-12 * size);
  }
}

std::size_t number_of_lines(const std::string& text)
{ return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')); }

// The sides on the boundary are fitted to it, and the files name them.
void check_splines(const Intrinsic_triangulation& input, const Quads& q, double& farthest)
{
  const Multipatch& m = *q.splines;
  CHECK_EQUAL(defect(m), "");
  CHECK(!m.boundary.empty());
  CHECK_EQUAL(2 * m.interfaces.size() + m.boundary.size(), 4 * m.patches.size());
  std::size_t spans = 0, edges = 0;
  for (std::size_t v : next_on_boundary(q.mesh)) edges += v != none;
  for (const Multipatch::Side& s : m.boundary) {
    const Multipatch::Patch& patch = m.patches[s.patch];
    const double n_u = double(patch.spans[0]), n_v = double(patch.spans[1]);
    const std::size_t n = patch.spans[s.side % 2];
    spans += n;
    for (std::size_t i = 0; i <= 8 * n; ++i) {
      const double x = double(i) / 8;
      const double u[] = {x, n_u, x, 0}, v[] = {0, x, n_v, x};
      farthest = std::max(farthest, distance_to_boundary(input, evaluate(patch, u[s.side], v[s.side]).point));
    }
  }
  CHECK_EQUAL(spans, edges);
  Multipatch open = m, twice = m, beyond = m;
  open.boundary.pop_back();
  twice.boundary.push_back(m.boundary[0]);
  beyond.boundary[0].side = 4;
  CHECK(defect(open).find("is on 0 interfaces") != std::string::npos);
  CHECK(defect(twice).find("is on 2 interfaces") != std::string::npos);
  CHECK(defect(beyond).find("does not exist") != std::string::npos);

  std::ostringstream xml, json;
  write_multipatch_xml(xml, m);
  const std::string text = xml.str(), begin = "<boundary>\n", end = "  </boundary>";
  const std::size_t from = text.find(begin), to = text.find(end);
  CHECK(from != std::string::npos && to != std::string::npos);
  CHECK_EQUAL(number_of_lines(text.substr(from + begin.size(), to - from - begin.size())), m.boundary.size());
  write_multipatch_json(json, m);
  const nlohmann::json boundary = nlohmann::json::parse(json.str())["boundary"];
  CHECK_EQUAL(boundary.size(), m.boundary.size());
  for (std::size_t i = 0; i < m.boundary.size(); ++i) {
    CHECK_EQUAL(boundary[i]["patch"].get<std::size_t>(), m.boundary[i].patch);
    CHECK_EQUAL(boundary[i]["side"].get<int>(), m.boundary[i].side);
  }
}

void check_quality(const T_mesh& t, const Quads& q)
{
  std::map<std::size_t, std::size_t> inside, corners;
  for (const T_mesh::Node& node : t.nodes) {
    if (node.order == 0) continue;
    if (node.kind == T_mesh::Node_kind::corner) ++corners[node.order + 2];
    else                                        ++inside[node.order + 4];
  }
  CHECK(q.quality.irregular_vertices == inside);
  CHECK(q.quality.corners == corners);
  const Mesh mesh = surface_mesh(q.mesh, t);
  double length = 0;
  for (Edge e : mesh.edges()) length += distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  CHECK_NEAR(q.quality.edge_length.mean * double(mesh.number_of_edges()), length, 1e-9 * length);
  for (std::size_t k = 1; k < q.smoothing.history.size(); ++k)
    CHECK(q.smoothing.history[k].least >= q.smoothing.history[k - 1].least);
}

// Of the quads that are not alone at a corner: such a one has the surface's own angle there, which may be 180 degrees.
double least_scaled_jacobian(const T_mesh& t, Quad_mesh m)
{
  std::vector<char> is_sharp(m.points.size(), false);
  std::size_t s = 0;
  for (const T_mesh::Node& node : t.nodes) {
    if (!node.is_singularity()) continue;
    is_sharp[m.singularities[s++]] = node.kind == T_mesh::Node_kind::corner && node.order == -1;
  }
  const auto has_sharp_corner = [&](const std::array<std::size_t, 4>& quad)
  { return std::any_of(quad.begin(), quad.end(), [&](std::size_t v) { return is_sharp[v]; }); };
  m.quads.erase(std::remove_if(m.quads.begin(), m.quads.end(), has_sharp_corner), m.quads.end());
  return scaled_jacobian(m).least;
}

Quads check(const Intrinsic_triangulation& input, const Quartic_differential_result& r, const Quad_options& options,
            double& farthest)
{
  Quad_options rough = options;
  rough.smooth = rough.splines = false;
  const Quads raw = quads(input, *r.t_mesh, *r.refined, rough, quiet);
  const Quads q = quads(input, *r.t_mesh, *r.refined, options, quiet);
  for (const Quads* result : {&raw, &q}) {
    CHECK_EQUAL(quantization_defect(*r.t_mesh, result->quantization.length), "");
    CHECK_EQUAL(result->mesh.quads.size(), result->quantization.number_of_quads);
    check_counts(input, *r.t_mesh, result->mesh);
    check_boundary(input, r, result->mesh);
    check_quality(*r.t_mesh, *result);
  }
  farthest = 0;
  if (q.splines) check_splines(input, q, farthest);
  std::cout << q.mesh.quads.size() << " quads, scaled Jacobian " << raw.quality.scaled_jacobian.least << ", smoothed "
            << q.quality.scaled_jacobian.least << ", away from sharp corners "
            << least_scaled_jacobian(*r.t_mesh, q.mesh);
  if (q.splines)
    std::cout << ", " << q.splines->patches.size() << " splines, their boundary off by "
              << farthest / q.quality.edge_length.mean << " edges";
  std::cout << std::endl;
  return q;
}

Quads check(const Intrinsic_triangulation& input, const Quartic_differential_result& r, const Quad_options& options)
{
  double farthest;
  return check(input, r, options, farthest);
}

// Without any one of its quads, or with a singularity elsewhere, a mesh is refused.
void check_damage(const T_mesh& t, const Quad_mesh& m)
{
  for (std::size_t f = 0; f < m.quads.size(); ++f) {
    Quad_mesh damaged = m;
    damaged.quads.erase(damaged.quads.begin() + static_cast<std::ptrdiff_t>(f));
    damaged.patch.pop_back();
    CHECK(!defect(damaged, t).empty());
  }
  const std::vector<std::size_t> next = next_on_boundary(m);
  const std::size_t inside = static_cast<std::size_t>(std::find(next.begin(), next.end(), none) - next.begin());
  for (std::size_t s = 0; s < m.singularities.size(); ++s)
    for (std::size_t w : {next[m.singularities[s]], inside}) {
      Quad_mesh damaged = m;
      damaged.singularities[s] = w;
      CHECK(!defect(damaged, t).empty());
    }
}

// Surfaces of unit squares come back square by square; their splines have straight sides.
void test_squares()
{
  const Intrinsic_triangulation sheet = sheet_of_squares(), l(l_with_hole());
  for (const auto& [input, divisor, squares] : {std::make_tuple(&sheet, corners_of_sheet(sheet), 24u),
                                                std::make_tuple(&l, corners_of_l(l), 104u)}) {
    const Quartic_differential_result r = run_pipeline(*input, divisor);
    Quad_options options;
    options.quantization.edge_length = 1;
    options.splines = true;
    double farthest;
    check(*input, r, options, farthest);
    CHECK_NEAR(farthest, 0, 1e-9);
    options.splines = false;
    const Quads units = check(*input, r, options);
    CHECK_EQUAL(units.mesh.quads.size(), squares);
    for (const Point_3& p : units.mesh.points)
      CHECK_NEAR(distance(p, Point_3(std::round(p.x()), std::round(p.y()), 0)), 0, 1e-9);
    CHECK_NEAR(units.quality.scaled_jacobian.least, 1, 1e-9);
    CHECK_NEAR(units.quality.edge_length.mean, 1, 1e-9);
    check_damage(*r.t_mesh, units.mesh);
  }
}

void test_annulus()
{
  const Intrinsic_triangulation ring(plate(1, 14));
  const Quartic_differential_result r = run_pipeline(ring, Divisor());
  Quad_options options;
  options.quantization.number_of_quads = 400;
  options.splines = true;
  options.quantization.number_of_blocks = 4;
  const Quads q = check(ring, r, options);
  CHECK_EQUAL(q.splines->patches.size(), 1u);
  CHECK_EQUAL(q.splines->interfaces.size(), 1u);
  CHECK(q.quality.scaled_jacobian.least > 0);
}

// A disk with four corners; its splines follow the circle, from which the quads' edges are off by 1/40 of their length.
void test_disk()
{
  const Intrinsic_triangulation disk(plate(0, 14));
  const std::vector<Halfedge> circle = disk.boundary_curves().front();
  std::vector<std::pair<Vertex, int>> corners;
  for (std::size_t k = 0; k < 4; ++k) corners.emplace_back(disk.source(circle[k * circle.size() / 4]), 1);
  Quad_options options;
  options.quantization.number_of_quads = 64;
  options.splines = true;
  options.quantization.number_of_blocks = 1;
  double farthest;
  const Quads q = check(disk, run_pipeline(disk, corners_at(disk, corners)), options, farthest);
  CHECK_EQUAL(q.splines->patches.size(), 1u);
  CHECK(farthest < 0.01 * q.quality.edge_length.mean);
}

void test_random_divisors(int cases)
{
  std::mt19937 random(2028);
  const std::vector<Surface_with_boundary> surfaces = surfaces_with_boundary();
  int checked = 0, positive = 0;
  for (int n = 0; n < cases; ++n) {
    const Boundary_case c = random_case(surfaces[n % surfaces.size()], random);
    std::cout << n << ", " << c.name << ", " << c.divisor.size() << " singularities: " << std::flush;
    try {
      const Quartic_differential_result r = run_pipeline(c.surface, c.divisor);
      Quad_options options;
      const std::size_t targets[] = {2000, 60, 500};
      options.quantization.number_of_quads = targets[n % 3];
      options.splines = n % 3 == 2;
      positive += least_scaled_jacobian(*r.t_mesh, check(c.surface, r, options).mesh) > 0;
      ++checked;
    } catch (const Infeasible_divisor_error& e) {
      std::cout << e.what() << std::endl;
    } catch (const Numerical_error& e) {
      std::cout << e.what() << std::endl;
    }
  }
  std::cout << positive << " of " << checked << " meshes have no corner turned over away from sharp corners" << std::endl;
  CHECK(checked >= cases * 3 / 4);
  CHECK(positive >= checked * 3 / 4);
}

} // namespace

int main()
{
  test_squares();
  test_annulus();
  test_disk();
  test_random_divisors(22);
  return Quartic_test::result();
}
