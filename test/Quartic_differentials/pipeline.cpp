// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole pipeline in one call, on surfaces of genus 0 to 6.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/quartic_differential.h>

#include <cmath>
#include <sstream>

using namespace CGAL::Quartic_differentials;

namespace {

// The metric is discretely conformal: the length cross ratio of an edge is that of the Delaunay triangulation as long
// as neither the edge nor the four round it were flipped. Returns the worst relative deviation, and counts the edges.
double worst_cross_ratio(const Riemann_surface& s, const Cone_metric& m, std::size_t& edges)
{
  const auto corners = [](const Intrinsic_triangulation& t, Edge e) {
    const Edge_flip f = t.flip_of(e, 0, false);
    return std::array<Halfedge, 6>{f.ij, f.jk, f.ki, f.ji, f.il, f.lj};
  };
  double worst = 0;
  edges = 0;
  for (Edge e : s.delaunay.edges()) {
    const auto h = corners(s.delaunay, e);
    if (h != corners(m.triangulation, e)) continue;
    bool unflipped = true;   // lengths are unscaled: they change only by flips
    for (Halfedge k : h) unflipped = unflipped && s.delaunay.length(k) == m.triangulation.length(k);
    if (!unflipped) continue;
    ++edges;
    const auto ratio = [&](const Intrinsic_triangulation& t, const std::vector<double>& l) {
      return l[t.edge(h[1])] * l[t.edge(h[4])] / (l[t.edge(h[2])] * l[t.edge(h[5])]);
    };
    worst = std::max(worst, std::abs(ratio(m.triangulation, m.lengths) / ratio(s.delaunay, s.delaunay.lengths()) - 1));
  }
  return worst;
}

void check_result(const std::string& name, const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  const int g = input.genus();
  std::cout << name << ": genus " << g << ", " << r.singularities.size() << " singularities, "
            << (r.t_mesh ? r.t_mesh->patches.size() : 0) << " patches" << std::endl;
  CHECK_EQUAL(degree(r.singularities), 8 * g - 8);
  CHECK_EQUAL(defect(*r.differential), "");
  CHECK_EQUAL(r.immersion.flipped_triangles, 0u);
  if (r.t_mesh) CHECK_EQUAL(defect(*r.t_mesh, r.traced()), "");
  std::size_t edges = 0;
  CHECK(worst_cross_ratio(*r.surface, r.metric->metric, edges) < 1e-13);
  CHECK(2 * edges > input.number_of_edges());
  // the flat area in surface units is the surface's
  const double unit = std::ldexp(r.differential->surface_units_per_unit, -r.differential->grid_exponent);
  CHECK_NEAR(0.5 * static_cast<double>(r.differential->doubled_area()) * unit * unit / input.area(), 1, 1e-12);
  for (const Singularity& s : r.singularities) {
    double sum = 0;
    for (double b : s.location.barycentric) { CHECK(b >= 0); sum += b; }
    CHECK_NEAR(sum, 1, 1e-12);
  }
  CHECK(!r.timings.empty());
}

void test_samples()
{
  for (const auto& [name, surface] : Quartic_test::sample_surfaces()) {
    Visitor visitor;
    Quartic_differential_result r;
    quartic_differential(surface, std::nullopt, {}, visitor, r);
    check_result(name, surface, r);
  }
  // flips by the thousand: a noisy mesh with needle triangles
  for (const auto& [name, surface] : Quartic_test::real_surfaces({"buddha_20k"})) {
    Visitor visitor;
    Quartic_differential_result r;
    quartic_differential(surface, std::nullopt, {}, visitor, r);
    std::size_t edges = 0;
    CHECK(worst_cross_ratio(*r.surface, r.metric->metric, edges) < 1e-12);
    std::cout << name << ": conformal at all " << edges << " of " << surface.number_of_edges()
              << " edges that no flip has touched" << std::endl;
    CHECK_EQUAL(defect(*r.t_mesh, r.traced()), "");
  }
}

// A divisor given by the user: pinned singularities stay, and what is written can be read and run again.
void test_own_singularities()
{
  const Intrinsic_triangulation input(handle_chain(2, 6));
  Visitor visitor;
  Quartic_differential_result first;
  quartic_differential(input, std::nullopt, {}, visitor, first);

  std::stringstream file;
  first.singularities[2].pinned = true;
  write_singularities(file, first.singularities, input);
  const Divisor again = read_singularities(file, input);
  CHECK_EQUAL(again.size(), first.singularities.size());
  CHECK(again[2].pinned && !again[1].pinned);
  Quartic_differential_result second;
  quartic_differential(input, again, {}, visitor, second);
  check_result("its own singularities again", input, second);
  for (std::size_t i = 0; i < again.size(); ++i) {
    const Point_3 p = position_on_input(input, first.singularities[i].location);
    const Point_3 q = position_on_input(input, second.singularities[i].location);
    CHECK(std::sqrt(CGAL::squared_distance(p, q)) < (i == 2 ? 1e-12 : 1e-2) * std::sqrt(input.area()));
  }

  std::stringstream some("0 0 0 -1   # one pole\n\n1 0 0 2 pinned\n");
  Quartic_differential_options repair;
  Quartic_differential_result refused, repaired;
  CHECK_THROWS(quartic_differential(input, read_singularities(some, input), repair, visitor, refused),
               Infeasible_divisor_error, "degree");
  repair.repair_degree = true;
  some.clear();
  some.seekg(0);
  quartic_differential(input, read_singularities(some, input), repair, visitor, repaired);
  check_result("repaired degree", input, repaired);
  CHECK_EQUAL(repaired.singularities.size(), 2u + 7u);

  for (const char* bad : {"1 2 3", "1 2 x 1", "1 2 3 1.5", "1 2 3 1 fixed", "1 2 3 1 pinned twice", "nan 0 0 1"}) {
    std::stringstream in(bad);
    CHECK_THROWS(read_singularities(in, input), Infeasible_divisor_error, "line 1");
  }
}

// The paper's route starts further from exact holonomy, and arrives there too.
void test_route_through_zeros()
{
  for (int g : {1, 3}) {
    const Intrinsic_triangulation input(handle_chain(g, 8));
    Visitor visitor;
    Quartic_differential_options options;
    options.route = Abel_jacobi_route::zeros;
    Quartic_differential_result r;
    quartic_differential(input, std::nullopt, options, visitor, r);
    check_result("through the zeros of a holomorphic form", input, r);
    CHECK(r.metric->max_holonomy_error < 1e-10);
  }
}

// Higher orders: a pole of order 3, zeros of order 3 and 4.
void test_high_orders()
{
  const Intrinsic_triangulation input(handle_chain(1, 8));
  Visitor visitor;
  Quartic_differential_result start;
  quartic_differential(input, std::nullopt, {}, visitor, start);
  Divisor d(start.singularities.begin(), start.singularities.begin() + 6);
  const int orders[6] = {-3, -3, -1, 3, 2, 2};
  for (int i = 0; i < 6; ++i) d[i].order = orders[i];
  Quartic_differential_result r;
  quartic_differential(input, d, {}, visitor, r);
  check_result("orders -3 to 3", input, r);
}

// Counts the times singularities are chosen again.
struct Choice_counter : Visitor
{
  int again = 0;
  void progress(const std::string& message) override { again += message.find("others are chosen") != std::string::npos; }
};

// Singularities that were chosen and come too near each other give way to others, a few times; given ones do not.
void test_chosen_again()
{
  const Intrinsic_triangulation input(handle_chain(2, 6));
  Quartic_differential_options options;
  Choice_counter first, no_choice, in_vain;
  options.cone_metric.least_distance = 0.08;   // of another size than the guard of the choice
  Quartic_differential_result r;
  quartic_differential(input, std::nullopt, options, first, r);
  check_result("chosen again", input, r);
  CHECK(first.again > 0);
  CHECK_EQUAL(collision(input, r.singularities, options.cone_metric.least_distance), "");

  options.cone_metric.least_distance = 0.5;
  Quartic_differential_result refused, refused_again;
  CHECK_THROWS(quartic_differential(input, r.singularities, options, no_choice, refused), Colliding_singularities_error,
               "drives together");
  CHECK_EQUAL(no_choice.again, 0);
  CHECK_THROWS(quartic_differential(input, std::nullopt, options, in_vain, refused_again), Infeasible_divisor_error,
               "drives together");
  CHECK_EQUAL(in_vain.again, 2);
}

void test_flat_torus()
{
  const Intrinsic_triangulation input(torus(1, 0.4, 40, 24));
  Visitor visitor;
  Quartic_differential_result r;
  quartic_differential(input, Divisor(), {}, visitor, r);
  check_result("torus without singularities", input, r);
  CHECK(!r.t_mesh);
}

// Singularities on the user's mesh give what the same ones give on its copy; what was computed before a step fails is
// kept.
void test_singularities_on_mesh()
{
  static_assert(internal::is_face_list_graph<Mesh>::value
                && internal::is_face_list_graph<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>::value
                && !internal::is_face_list_graph<int>::value && !internal::is_face_list_graph<Point_3>::value
                && !internal::is_face_list_graph<Intrinsic_triangulation>::value);
  const Mesh mesh = Quartic_test::jittered_torus(40, 20, 0.3, 0.5, 2);
  const Intrinsic_triangulation copy = intrinsic_triangulation(mesh);
  Mesh_divisor<Mesh> divisor;
  Divisor same;
  for (int i = 0; i < 8; ++i) {
    const Face f(static_cast<Mesh::size_type>(i * mesh.number_of_faces() / 9));
    divisor.push_back({{f, {0.2, 0.3, 0.5}}, i % 2 == 0 ? -1 : 1, i == 0});
    same.push_back({{f, {0.2, 0.3, 0.5}}, i % 2 == 0 ? -1 : 1, i == 0});
  }
  Visitor visitor;
  Quartic_differential_result expected, kept;
  quartic_differential(copy, same, {}, visitor, expected);
  const Quartic_differential_result r = quartic_differential(mesh, {}, parameters::singularities(divisor));
  quartic_differential(mesh, {}, visitor, kept, parameters::singularities(divisor));
  CHECK(kept.legal.has_value());
  CHECK_EQUAL(r.singularities.size(), divisor.size());
  for (std::size_t i = 0; i < r.singularities.size(); ++i) {
    CHECK_EQUAL(r.singularities[i].location.face, expected.singularities[i].location.face);
    CHECK(r.singularities[i].location.barycentric == expected.singularities[i].location.barycentric);
    CHECK_EQUAL(r.metric->moved_by[i] < 1e-9, i == 0);   // pinned
  }
  divisor.pop_back();
  CHECK_THROWS(quartic_differential(mesh, {}, visitor, kept, parameters::singularities(divisor)),
               Infeasible_divisor_error, "degree");
  CHECK(kept.surface && (kept.surface->periods.pi - r.surface->periods.pi).norm() == 0 && !kept.legal);
}

// Any face graph will do, and gives the same up to rounding: its halfedges are numbered otherwise. Points on faces refer
// to the user's mesh.
void test_polyhedron()
{
  const Mesh mesh = Quartic_test::jittered_torus(40, 20, 0.3, 0.5, 2);   // no symmetry, so no ties
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> polyhedron;
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, points, triangles);
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, polyhedron);
  const Quartic_differential_result r = quartic_differential(polyhedron), s = quartic_differential(mesh);
  CHECK_EQUAL(r.t_mesh->patches.size(), s.t_mesh->patches.size());
  CHECK_EQUAL(r.singularities.size(), s.singularities.size());
  const Intrinsic_triangulation from_polyhedron = intrinsic_triangulation(polyhedron), from_mesh(mesh);
  check_result("polyhedron", from_polyhedron, r);
  for (std::size_t i = 0; i < r.singularities.size(); ++i)
    CHECK(CGAL::squared_distance(position_on_input(from_polyhedron, r.singularities[i].location),
                                 position_on_input(from_mesh, s.singularities[i].location)) < 1e-16 * from_mesh.area());

  Mesh two = mesh;
  two += handle_chain(0, 6);
  CHECK_THROWS(intrinsic_triangulation(two), Unusable_surface_error, "not connected");
  CHECK_THROWS(intrinsic_triangulation(Mesh()), Unusable_surface_error, "no triangle");
}

// A square with its four corners is one rectangle of the T-mesh. The triangles at two of the corners are obtuse nowhere,
// but in the middle of one side is a vertex near the boundary.
void test_boundary()
{
  Mesh mesh;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), Point_3(0.5, 0.1, 0)})
    mesh.add_vertex(p);
  for (Mesh::size_type k = 0; k < 4; ++k) mesh.add_face(Vertex(k), Vertex((k + 1) % 4), Vertex(4));
  Mesh_divisor<Mesh> corners;
  for (Mesh::size_type k = 0; k < 4; ++k) {
    const Halfedge h = mesh.halfedge(Vertex(k), Vertex((k + 1) % 4));
    std::array<double, 3> b{0, 0, 0};
    b[h == mesh.halfedge(mesh.face(h)) ? 0 : h == mesh.next(mesh.halfedge(mesh.face(h))) ? 1 : 2] = 1;
    corners.push_back({{mesh.face(h), b}, -1, true, true});
  }
  const Quartic_differential_result r = quartic_differential(mesh, {}, parameters::singularities(corners));
  CHECK_EQUAL(r.split_input->number_of_vertices(), 6u);
  CHECK_EQUAL(defect(*r.t_mesh, r.traced()), "");
  CHECK_EQUAL(r.t_mesh->patches.size(), 1u);
  CHECK_EQUAL(r.t_mesh->patches[0].width, r.t_mesh->patches[0].height);

  Mesh bow_tie;
  for (int k = 0; k < 5; ++k) bow_tie.add_vertex(Point_3(k % 2, k / 2, k == 4 ? 1 : 0));
  bow_tie.add_face(Vertex(0), Vertex(1), Vertex(2));
  bow_tie.add_face(Vertex(0), Vertex(3), Vertex(4));
  CHECK_THROWS(intrinsic_triangulation(bow_tie), Unusable_surface_error, "more than one fan");
}

} // namespace

int main()
{
  test_samples();
  test_boundary();
  test_own_singularities();
  test_route_through_zeros();
  test_high_orders();
  test_chosen_again();
  test_flat_torus();
  test_singularities_on_mesh();
  test_polyhedron();
  return Quartic_test::result();
}
