// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are known by their edge lengths alone: every step works on them, and what needs positions in space says
// so.

#include "check.h"
#include "glued_triangles.h"
#include "run_pipeline.h"
#include "run_program.h"
#include "square_tiled_surfaces.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/Quartic_differentials/IO/surface_json.h>
#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_loops.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/handle_tunnel_basis.h>
#include <CGAL/Quartic_differentials/handle_tunnel_loops.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using Quartic_test::glued_triangles;

namespace {

const double pi = std::acos(-1.0);

// ---- a surface in space, and the same without positions

// The same edges and halfedges, with the positions of the vertices.
Intrinsic_triangulation placed_in_space(const Intrinsic_triangulation& lengths, const Mesh& positions)
{
  Mesh mesh = lengths.mesh();
  for (Vertex v : mesh.vertices()) mesh.point(v) = positions.point(v);
  return Intrinsic_triangulation(mesh);
}

bool same_divisor(const Divisor& a, const Divisor& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Singularity& s, const Singularity& t) {
    return s.location.face == t.location.face && s.location.barycentric == t.location.barycentric && s.order == t.order;
  });
}

bool same_differential(const Quartic_differential& a, const Quartic_differential& b)
{
  const auto same_transition = [](const Transition& s, const Transition& t) {
    return s.rotation == t.rotation && s.translation == t.translation;
  };
  return a.grid_exponent == b.grid_exponent && a.corner == b.corner && a.order == b.order
      && a.singularities == b.singularities && a.surface_units_per_unit == b.surface_units_per_unit
      && std::equal(a.transition.begin(), a.transition.end(), b.transition.begin(), b.transition.end(),
                    same_transition);
}

// Arc lengths and the sides of rectangles, sorted: what does not depend on the order in which they are found.
using Lengths = std::pair<std::multiset<std::int64_t>, std::multiset<std::pair<std::int64_t, std::int64_t>>>;

Lengths lengths_of(const T_mesh& t)
{
  Lengths result;
  for (const T_mesh::Arc& a : t.arcs) result.first.insert(a.length);
  for (const T_mesh::Patch& p : t.patches) result.second.insert(std::minmax(p.width, p.height));
  return result;
}

void test_without_positions(const std::string& name, const Mesh& mesh)
{
  const Intrinsic_triangulation original(mesh), lengths(glued_triangles(original));
  const Intrinsic_triangulation in_space = placed_in_space(lengths, mesh);
  CHECK(in_space.is_embedded() && !lengths.is_embedded());
  CHECK(in_space.lengths() == lengths.lengths());
  Quartic_differential_options options;
  options.homology = Homology_choice::any;   // handles and tunnels are known in space only
  const Quartic_differential_result a = Quartic_test::run_pipeline(in_space, options),
                                    b = Quartic_test::run_pipeline(lengths, options);
  std::cout << name << ": " << b.singularities.size() << " singularities, " << b.t_mesh->patches.size() << " patches"
            << std::endl;

  // no position is used up to the flat metric's charts: the same bits
  CHECK(a.surface->forms.by_edge == b.surface->forms.by_edge);
  CHECK(a.surface->periods.pi == b.surface->periods.pi);
  CHECK(same_divisor(*a.initial, *b.initial));
  CHECK(same_divisor(a.legal->divisor, b.legal->divisor));
  CHECK(a.legal->residual == b.legal->residual);
  CHECK(a.image->s == b.image->s && a.image->t == b.image->t);
  CHECK(same_divisor(a.singularities, b.singularities));
  CHECK(a.metric->metric.u == b.metric->metric.u);
  CHECK(a.metric->turning == b.metric->turning);
  CHECK(same_differential(*a.differential, *b.differential));

  // then the T-mesh is traced on the subdivided surface in space, otherwise on the flat triangulation
  CHECK(a.refined && !b.refined);
  CHECK_EQUAL(defect(*b.t_mesh, b.traced()), "");
  CHECK(lengths_of(*a.t_mesh) == lengths_of(*b.t_mesh));

  // another numbering of the edges: the same up to rounding
  Visitor visitor;
  const Riemann_surface s = riemann_surface(original, visitor);
  CHECK_NEAR(s.periods.star_defect, b.surface->periods.star_defect, 1e-12);
}

// ---- Delta-complexes

// A regular polygon with 4g sides, opposite sides glued: genus g, one vertex, triangles round a corner.
Glued_triangles one_vertex_polygon(int g)
{
  const int n = 4 * g, triangles = n - 2;
  const auto chord = [n](int k) { return k == 1 || k == n - 1 ? 1 : std::sin(k * pi / n) / std::sin(pi / n); };
  // side k joins the corners k and k + 1
  const auto side = [n, triangles](int k) {
    return k == 0     ? std::array<int, 2>{0, 0}
         : k == n - 1 ? std::array<int, 2>{triangles - 1, 2}
                      : std::array<int, 2>{k - 1, 1};
  };
  Glued_triangles s;
  for (int i = 0; i < triangles; ++i) {
    s.triangles.push_back({0, 0, 0});
    s.lengths.push_back({chord(i + 1), 1, chord(i + 2)});
    s.opposite.push_back({{{i - 1, 2}, side((i + 1 + n / 2) % n), {i + 1, 0}}});
  }
  s.opposite.front()[0] = side(n / 2);
  s.opposite.back()[2] = side(n / 2 - 1);
  return s;
}

// edges that no straight edges of a surface in space could be: loops and parallel edges
std::size_t loops_and_parallel_edges(const Intrinsic_triangulation& t)
{
  std::set<std::pair<Vertex, Vertex>> seen;
  std::size_t n = 0;
  for (Edge e : t.edges()) {
    const Vertex v = t.source(t.halfedge(e)), w = t.target(t.halfedge(e));
    n += v == w || !seen.insert(std::minmax(v, w)).second;
  }
  return n;
}

// The whole pipeline, from the lengths to the T-mesh.
Quartic_differential_result run_checked(const std::string& name, const Intrinsic_triangulation& t,
                                        const std::optional<Divisor>& divisor)
{
  Visitor visitor;
  Quartic_differential_result r;
  Quartic_differential_options options;
  options.homology = Homology_choice::any;   // handles and tunnels are known in space only
  quartic_differential(t, divisor, options, visitor, r);
  std::cout << name << ": genus " << t.genus() << ", " << t.number_of_vertices() << " vertices, "
            << t.number_of_faces() << " faces, " << loops_and_parallel_edges(t) << " of " << t.number_of_edges()
            << " edges loops or parallel, " << r.singularities.size() << " singularities, "
            << (r.t_mesh ? r.t_mesh->patches.size() : 0) << " patches" << std::endl;
  CHECK(!t.is_embedded() && !r.refined);
  CHECK_EQUAL(degree(r.singularities), 8 * t.genus() - 8);
  CHECK(r.legal->residual.norm() <= 1e-11);
  CHECK(std::max(r.metric->max_holonomy_error, r.metric->max_transition_error) <= 1e-10);
  CHECK_EQUAL(defect(*r.differential), "");
  CHECK_EQUAL(r.t_mesh.has_value(), !r.singularities.empty());
  if (r.t_mesh) CHECK_EQUAL(defect(*r.t_mesh, *r.differential), "");
  return r;
}

// Simple zeros and poles in random faces, not too near each other.
Divisor random_divisor(const Intrinsic_triangulation& t, int pairs, std::mt19937& random)
{
  const double apart = 0.03 * std::sqrt(t.area());
  Divisor d;
  const auto add = [&](int order) {
    const double x = Quartic_test::uniform(random, 0.1, 0.4), y = Quartic_test::uniform(random, 0.1, 0.4);
    const Face f(static_cast<Mesh::size_type>(random() % t.number_of_faces()));
    d.push_back({{f, {1 - x - y, x, y}}, order, false});
    if (nearest_singularities(t, locations(d), apart).distance < apart) d.pop_back();
  };
  const auto missing = [&] { return 8 * t.genus() - 8 - degree(d); };
  for (int i = 0; i < pairs; ++i) for (int order : {-1, 1}) add(order);
  while (missing() != 0) add(missing() > 0 ? 1 : -1);
  return d;
}

// A metric that is flat with quarter turn holonomy already: the divisor of its cones, all at vertices, is legal as it
// is.
// \param order by vertex
void check_own_cones(const std::string& name, const Intrinsic_triangulation& t, const std::vector<Vertex>& cones,
                     const std::vector<int>& order)
{
  Divisor divisor;
  for (Vertex v : cones) divisor.push_back({at_vertex(t, v), order[v.idx()], false});
  const Quartic_differential_result r = run_checked(name, t, divisor);
  CHECK(r.metric->metric.cones == cones);
  for (double u : r.metric->metric.u) CHECK(std::abs(u) < 1e-12);
  for (double moved : r.metric->moved_by) CHECK(moved == 0);
}

Intrinsic_triangulation equilateral(Glued_triangles s)
{
  for (auto& l : s.lengths) l = {1, 1, 1};
  return Intrinsic_triangulation(s);
}

void test_one_vertex(int g, std::mt19937& random)
{
  const Intrinsic_triangulation t(one_vertex_polygon(g));
  CHECK_EQUAL(t.number_of_vertices(), 1u);
  CHECK_EQUAL(t.genus(), g);
  CHECK_EQUAL(loops_and_parallel_edges(t), t.number_of_edges());
  check_own_cones("one vertex, its own cone", t, g == 1 ? std::vector<Vertex>() : std::vector<Vertex>{Vertex(0)},
                  {8 * g - 8});
  run_checked("one vertex, random singularities", t, random_divisor(t, 3, random));
  const Intrinsic_triangulation e = equilateral(one_vertex_polygon(g));
  run_checked("one vertex, equilateral triangles", e, random_divisor(e, 3, random));
  // singularities are chosen at vertices
  CHECK_THROWS(Quartic_test::run_pipeline(t), Infeasible_divisor_error, "subdivide");
  run_checked("one vertex, subdivided", Intrinsic_triangulation(subdivided(one_vertex_polygon(g))), std::nullopt);
}

void test_square_tiled_surfaces(std::mt19937& random)
{
  std::set<int> genera;
  for (int i = 0; i < 40; ++i) {
    Quartic_test::Gluing glued;
    do glued = Quartic_test::random_gluing(2 + i % 7, random);
    while (!Quartic_test::is_connected(glued));
    const Quartic_test::Square_tiled_surface s = Quartic_test::square_tiled_surface(glued);
    check_own_cones("squares", s.triangulation, s.singularities, s.order);
    genera.insert(s.triangulation.genus());
  }
  CHECK(genera.size() >= 4);
}

// Every vertex has negative curvature: the triangles of the polygons of hyperelliptic() are made lower, with angles of
// 80 degrees at the centre. The centres are numbered after the corners.
void test_negative_curvature(std::mt19937& random)
{
  Glued_triangles s = hyperelliptic(2, 0);
  const double spoke = 0.5 / std::sin(40 * pi / 180);
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (int e = 0; e < 3; ++e) {
      const bool is_spoke = std::max(s.triangles[t][e], s.triangles[t][(e + 1) % 3]) >= 6;
      s.lengths[t][e] = is_spoke ? spoke : 1;
    }
  const Intrinsic_triangulation t(s);
  for (double k : curvatures(t, corner_angles(t, t.lengths()))) CHECK(k < 0);
  run_checked("negative curvature", t, random_divisor(t, 2, random));
  run_checked("negative curvature, subdivided", Intrinsic_triangulation(subdivided(s)), std::nullopt);
}

// The lengths of a surface in space, every one changed by up to a tenth.
void test_perturbed_lengths(std::mt19937& random)
{
  const Intrinsic_triangulation chain(handle_chain(2, 6));
  Intrinsic_triangulation t(glued_triangles(chain));
  std::vector<double> lengths = t.lengths();
  for (double& l : lengths) l *= Quartic_test::uniform(random, 0.9, 1.1);
  t.set_lengths(lengths);
  const Intrinsic_triangulation perturbed(glued_triangles(t));   // checks the triangle inequalities
  run_checked("perturbed lengths", perturbed, std::nullopt);
}

void test_file_form()
{
  for (const Glued_triangles& s : {one_vertex_polygon(2), hyperelliptic(3, 0)}) {
    std::stringstream file;
    write_surface_json(file, s);
    const Glued_triangles again = read_surface_json(file.str());
    CHECK(again.triangles == s.triangles);
    CHECK(again.opposite == s.opposite);
    CHECK(again.lengths == s.lengths);
  }
}

// ---- what needs positions says so

void test_refusals()
{
  const std::string reason = "the surface is known by its edge lengths alone";
  const Intrinsic_triangulation t(hyperelliptic(2, 0));
  const Quartic_differential_result r = Quartic_test::run_pipeline(t);
  std::stringstream out, in("0 0 0 1\n");
  CHECK_THROWS(position_on_input(t, r.singularities[0].location), Unusable_surface_error, reason);
  CHECK_THROWS(write_singularities(out, r.singularities, t), Unusable_surface_error, reason);
  CHECK_THROWS(read_singularities(in, t), Infeasible_divisor_error, reason);
  CHECK_THROWS(write_flat_obj("nowhere", "flat", *r.differential), Unusable_surface_error, reason);
  CHECK_THROWS(write_t_mesh_vtp(out, *r.t_mesh, *r.differential), Unusable_surface_error, reason);
  CHECK_THROWS(refined_surface(t, *r.refined_metric, r.metric->metric.u, *r.differential), Unusable_surface_error,
               reason);
  CHECK_THROWS(linking_matrices(t, r.surface->homology.loops), Unusable_surface_error, reason);

  const Homology_basis basis = homology_basis(t);
  const Handle_tunnel_basis classes = handle_tunnel_basis(t, basis);
  CHECK(!classes.found && !classes.certified);
  CHECK(classes.basis.combination == basis.combination);
  CHECK(classes.reason.find(reason) != std::string::npos);
  const Handle_tunnel_loops loops = handle_tunnel_loops(t, classes);
  CHECK_EQUAL(loops.loops.size(), 4u);
  CHECK_THROWS(write_loops_obj(out, t, loops), Unusable_surface_error, reason);
}

void test_program()
{
  using Quartic_test::contains;
  if (Quartic_test::environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "the environment variable QUARTIC_PROGRAM does not name the program: it is not tested" << std::endl;
    return;
  }
  const Quartic_test::Program_folder folder;
  CHECK_EQUAL(folder.quartic("sample hyperelliptic -g 2 -s 1 -o surface.json").status, 0);
  const Quartic_test::Outcome run = folder.quartic("run surface.json -o results --intrinsic");
  CHECK_EQUAL(run.status, 0);
  CHECK(contains(run.out, "rectangles"));
  CHECK(contains(run.out, "no positions in space"));
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "results"))
    files.insert(entry.path().filename().string());
  CHECK(files == std::set<std::string>({"flat_intrinsic.json", "tmesh.json", "report.json", "report.html"}));
  for (const char* arguments : {"verify results", "verify surface.json results"}) {
    const Quartic_test::Outcome verify = folder.quartic(arguments);
    CHECK_EQUAL(verify.status, 0);
    CHECK(contains(verify.out, "patches are exact rectangles"));
  }
  const auto report = nlohmann::json::parse(Quartic_test::contents(folder / "results/report.json"));
  CHECK(report["input"]["embedded"] == false);
  CHECK(report["singularities"].size() >= 8);
  for (const auto& s : report["singularities"]) {
    CHECK(!s.contains("position"));
    CHECK(s.contains("face") && s["face"] < 96);
    CHECK(s.contains("barycentric") && s["barycentric"].size() == 3);
  }
  CHECK_EQUAL(folder.quartic("info surface.json").status, 0);

  std::ofstream(folder / "singularities.txt") << "0 0 0 8\n";
  const Quartic_test::Outcome placed = folder.quartic("run surface.json -o placed --singularities singularities.txt");
  CHECK_EQUAL(placed.status, 2);
  CHECK(contains(placed.err, "edge lengths alone"));

  std::ofstream octagon(folder / "octagon.json");
  write_surface_json(octagon, one_vertex_polygon(2));
  octagon.close();
  CHECK_EQUAL(folder.quartic("info octagon.json").status, 0);
  const Quartic_test::Outcome coarse = folder.quartic("run octagon.json -o coarse");
  CHECK_EQUAL(coarse.status, 2);
  CHECK(contains(coarse.err, "subdivide"));
}

} // namespace

int main()
{
  test_without_positions("sphere", bumpy_sphere(3));
  test_without_positions("torus", Quartic_test::jittered_torus(24, 12, 0.3, 0.5, 2));
  test_without_positions("chain of genus 2", handle_chain(2, 6));
  test_without_positions("ring of genus 3", handle_ring(3, 6));
  std::mt19937 random(3);
  for (int g : {1, 2, 3}) test_one_vertex(g, random);
  for (int g : {1, 2})
    run_checked("hyperelliptic curve", Intrinsic_triangulation(hyperelliptic(g, 0)), std::nullopt);
  run_checked("hyperelliptic curve, subdivided", Intrinsic_triangulation(hyperelliptic(4, 1)), std::nullopt);
  test_square_tiled_surfaces(random);
  test_negative_curvature(random);
  test_perturbed_lengths(random);
  test_file_form();
  test_refusals();
  test_program();
  return Quartic_test::result();
}
