// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Singularities chosen on surfaces with boundary: direction fields that follow the boundary, the distortion's
// derivatives for corners that slide, guards, coarsening, and divisors that are legal, of the right degree, and carry a
// flat metric.

#include "check.h"
#include "named_surfaces.h"
#include "plates.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/boundary_corners.h>
#include <CGAL/Quartic_differentials/choose_corners.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/direction_field.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/distortion_descent.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <numeric>
#include <tuple>

using namespace Quartic_test;

namespace {

Visitor visitor;

Riemann_surface riemann_surface_with_boundary(Intrinsic_triangulation input)
{
  Riemann_surface s;
  split_obtuse_at_boundary(input);
  s.homology.cochains = relative_homology_basis(input).cochains;
  s.delaunay = std::move(input);
  make_delaunay(s.delaunay, s.homology.cochains);
  s.weights = cotangent_weights(s.delaunay, s.delaunay.lengths());
  s.laplacian.factorize(s.delaunay, s.weights);
  s.forms = harmonic_1_forms(s.delaunay, s.homology.cochains, s.weights, s.laplacian);
  return s;
}

struct Setting
{
  explicit Setting(const Intrinsic_triangulation& input)
    : surface(riemann_surface_with_boundary(input)), map(surface.delaunay, surface.homology.cochains, surface.forms),
      distortion(surface.delaunay, surface.laplacian, vertex_areas(surface.delaunay)) {}
  Setting(const Setting&) = delete;

  const Intrinsic_triangulation& triangulation() const { return surface.delaunay; }
  double size() const { return std::sqrt(triangulation().area()); }
  double energy(const Divisor& d) const { return distortion.energy(distortion.log_scale(d)); }
  Chosen_singularities chosen(const Divisor& given, const Singularity_choice_options& options = {}) const
  { return choose_singularities(surface, given, options, {}, {}, visitor); }
  Chosen_singularities chosen_with_corners() const
  { return choose_corners_and_singularities(surface, {}, {}, {}, {}, visitor); }
  Optimal_divisor optimal(const Divisor& d) const
  { return minimize_distortion(distortion, map, surface.periods, d, {}, {}, visitor); }

  Riemann_surface surface;
  Abel_jacobi_map map;
  Area_distortion distortion;
};

bool same(const Singularity& a, const Singularity& b)
{
  return a.location.face == b.location.face && a.location.barycentric == b.location.barycentric && a.order == b.order
      && a.on_boundary == b.on_boundary && a.pinned == b.pinned;
}

// Corners with the given numbers of quads at random places of every curve.
Divisor random_corners(const Intrinsic_triangulation& t, const std::vector<int>& quads, std::mt19937& random)
{
  Divisor corners;
  for (const auto& curve : t.boundary_curves()) {
    const double begin = uniform(random, 0, 0.1);
    for (std::size_t i = 0; i < quads.size(); ++i)
      corners.push_back({on_curve(t, curve, begin + 0.9 * static_cast<double>(i) / static_cast<double>(quads.size())),
                         quads[i] - 2, false, true});
  }
  return corners;
}

// ---- direction fields

void test_fields(const std::vector<Surface_with_boundary>& surfaces, std::mt19937& random)
{
  for (const Surface_with_boundary& s : surfaces) {
    const Setting setting(s.surface);
    const Intrinsic_triangulation& t = setting.triangulation();
    for (const std::vector<int>& quads : std::vector<std::vector<int>>{{}, {1, 1, 1, 1}, {3}, {1, 4, 1, 3, 3}}) {
      const Divisor corners = random_corners(t, quads, random);
      const Divisor d = direction_field_divisor(t, setting.surface.weights, 0, corners);
      CHECK_EQUAL(degree(d) + degree(corners), 8 * s.genus - 8 + 4 * s.curves);
      for (const Singularity& p : d) CHECK(std::abs(p.order) == 1 && !p.on_boundary);
      const Divisor again = direction_field_divisor(t, setting.surface.weights, 1, corners);   // there is one solution
      CHECK(again.size() == d.size() && std::equal(again.begin(), again.end(), d.begin(), same));
    }
    std::cout << "field on " << s.name << ": " << direction_field_divisor(t, setting.surface.weights, 0).size()
              << " singularities" << std::endl;
  }
  // known ones: four poles in a disk, none in an annulus, none where all corners are marked
  const auto size = [](const Intrinsic_triangulation& t, const Divisor& corners) {
    return direction_field_divisor(t, cotangent_weights(t, t.lengths()), 0, corners).size();
  };
  for (int n : {12, 60}) {
    const Polygon rim = circle(n, [](int) { return 1; }), hole = circle(n, [](int) { return 0.5; });
    CHECK_EQUAL(size(Intrinsic_triangulation(star_shaped(rim, 8)), {}), 4u);
    CHECK_EQUAL(size(Intrinsic_triangulation(ring_between(hole, rim, 6)), {}), 0u);
  }
  for (const Mesh& mesh : {l_with_hole(), plate_of_squares(3, 2, [](int, int) { return true; }),
                           plate_of_squares(1, 1, [](int, int) { return true; })}) {
    const Intrinsic_triangulation t(mesh);
    CHECK_EQUAL(size(t, boundary_corners(t)), 0u);
  }
}

// ---- derivatives

Divisor moved(const Setting& s, const Divisor& divisor, const Eigen::VectorXd& by)
{
  Divisor result = divisor;
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    const Surface_point& p = divisor[i].location;
    const Lifted_point at = divisor[i].on_boundary ? s.map.lift_on_boundary(p) : s.map.lift(p);
    result[i].location = s.map.moved(at, {by[2 * i], by[2 * i + 1]}).location;
  }
  return result;
}

Eigen::VectorXd random_step(const Divisor& divisor, std::mt19937& random)
{
  Eigen::VectorXd step = Eigen::VectorXd::Zero(2 * divisor.size());
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    step[2 * i] = uniform(random, -1, 1);
    if (!divisor[i].on_boundary) step[2 * i + 1] = uniform(random, -1, 1);
  }
  return step;
}

void test_gradients(const Setting& s, std::mt19937& random)
{
  const std::vector<std::vector<int>> corners(s.triangulation().number_of_boundary_curves(), {1, 3, 4, 1});
  const Divisor d = random_divisor(s.triangulation(), corners, 2, random);
  const Eigen::VectorXd w = s.distortion.potential(s.distortion.log_scale(d));
  const Eigen::VectorXd exact = s.distortion.gradient(d, w), recovered = s.distortion.recovered_gradient(d, w);
  const double h = 1e-6 * s.size();
  for (int n = 0; n < 5; ++n) {
    const Eigen::VectorXd step = random_step(d, random);
    const double difference = (s.energy(moved(s, d, h * step)) - s.energy(moved(s, d, -h * step))) / (2 * h);
    CHECK_NEAR(difference, exact.dot(step), 1e-6 * (exact.norm() + 1e-3));
  }
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (!d[i].on_boundary) continue;
    CHECK(exact[2 * i + 1] == 0 && recovered[2 * i + 1] == 0);
    // continuous where a corner passes a vertex
    const Halfedge at = internal::boundary_place(s.triangulation(), d[i].location).halfedge;
    const Halfedge next = s.triangulation().next_on_boundary(at);
    Divisor one{d[i]};
    one[0].location = on_edge(s.triangulation(), at, 1);
    const Eigen::VectorXd before = s.distortion.recovered_gradient(one, w);
    one[0].location = on_edge(s.triangulation(), next, 0);
    CHECK_NEAR((s.distortion.recovered_gradient(one, w) - before).norm(), 0, 1e-12 * (1 + before.norm()));
  }
  // the recovered gradient is the exact one but for the discretisation
  std::cout << "gradients differ by " << (exact - recovered).norm() / exact.norm() << std::endl;
  CHECK((exact - recovered).norm() < 0.5 * exact.norm());
}

void test_guards(const Setting& s, std::mt19937& random)
{
  const Intrinsic_triangulation& t = s.triangulation();
  const double reach = 0.08 * s.size(), h = 1e-6 * s.size();
  int corners_near = 0, boundary_near = 0;
  for (int n = 0; n < 20; ++n) {
    const auto curves = t.boundary_curves();
    const auto& curve = curves[random() % curves.size()];
    const Surface_point place = on_curve(t, curve, uniform(random, 0, 1));
    const Lifted_point corner = s.map.lift_on_boundary(place);
    const Lifted_point second = s.map.moved(corner, uniform(random, 0.3, 0.7) * reach);
    const Lifted_point beside = s.map.lift(internal::moved_inside(place, 0.1));
    const Lifted_point inner = s.map.moved(beside, uniform(random, 0, 0.3) * reach);
    const Divisor d{{corner.location, 1, false, true}, {second.location, -1, false, true}, {inner.location, 1}};
    const auto near = internal::distance_guard(t, {d[0], d[1]}, reach, 0.1);
    CHECK(near.value > 0);
    CHECK(near.gradient[0] > 0 && near.gradient[2] < 0);   // apart along the boundary
    for (int kind = 0; kind < 2; ++kind) {
      const auto guard = [&](const Divisor& x) {
        return kind == 0 ? internal::distance_guard(t, {x[0], x[1]}, reach, 0.1)
                         : internal::boundary_guard(t, x, reach, 0.1);
      };
      const Eigen::VectorXd step = random_step(d, random);
      const auto there = guard(d);
      const double difference = (guard(moved(s, d, h * step)).value - guard(moved(s, d, -h * step)).value) / (2 * h);
      const double slope = there.gradient.dot(step.head(there.gradient.size()));
      CHECK_NEAR(difference, slope, 1e-3 * (there.gradient.norm() + 1e-6));
      (kind == 0 ? corners_near : boundary_near) += there.value > 0;
    }
  }
  CHECK(corners_near > 10 && boundary_near > 10);
}

// ---- coarsening

// The boundary stays as it is, edge by edge; harmonic forms nearly so.
void test_coarsening(const Surface_with_boundary& surface)
{
  const Setting s(surface.surface);
  const std::size_t on_boundary = [&] {
    std::size_t n = 0;
    for (const auto& curve : s.triangulation().boundary_curves()) n += curve.size();
    return n;
  }();
  const Coarse_surface coarse = coarsened(s.triangulation(), s.surface.homology.cochains,
                                          (s.triangulation().number_of_vertices() + on_boundary) / 2);
  const Intrinsic_triangulation& t = coarse.triangulation;
  CHECK(t.number_of_vertices() < s.triangulation().number_of_vertices());
  CHECK_EQUAL(structural_defect(t), "");
  CHECK_EQUAL(t.genus(), surface.genus);
  CHECK_EQUAL(t.number_of_boundary_curves(), surface.curves);
  std::size_t edges = 0;
  for (const auto& curve : t.boundary_curves())
    for (Halfedge h : curve) {
      const Halfedge fine = s.triangulation().halfedge_from(coarse.fine_vertex[t.source(h)]);
      CHECK(t.length(h) == s.triangulation().length(fine));
      CHECK(coarse.fine_vertex[t.target(h)] == s.triangulation().target(fine));
      ++edges;
    }
  CHECK_EQUAL(edges, on_boundary);
  CHECK_NEAR(std::accumulate(coarse.mass.begin(), coarse.mass.end(), 0.), s.triangulation().area(),
             1e-9 * s.triangulation().area());
  for (Face f : t.faces())   // cochains are closed
    for (int k = 0; k < coarse.cochains.size(); ++k) {
      const auto h = t.halfedges(f);
      CHECK_EQUAL(coarse.cochains(h[0], k) + coarse.cochains(h[1], k) + coarse.cochains(h[2], k), 0);
    }
  const Riemann_surface r = riemann_surface(coarse);
  if (r.forms.size() == 0) return;
  const double difference = (r.forms.dirichlet - s.surface.forms.dirichlet).norm() / s.surface.forms.dirichlet.norm();
  std::cout << "coarse " << surface.name << ": Dirichlet products differ by " << difference << std::endl;
  CHECK(difference < 0.1);
}

// ---- choice

// What holds of every choice; the divisor after it was optimised on the surface.
Divisor check_choice(const std::string& name, const Setting& s, const Divisor& given,
                     const Singularity_choice_options& options = {})
{
  const Intrinsic_triangulation& t = s.triangulation();
  const Chosen_singularities c = s.chosen(given, options);
  CHECK_EQUAL(degree(c.divisor), required_degree(t));
  CHECK(c.divisor.size() >= given.size());
  for (std::size_t i = 0; i < c.divisor.size(); ++i) {
    const Singularity& p = c.divisor[i];
    if (i < given.size()) CHECK(p.order == given[i].order && p.on_boundary == given[i].on_boundary);
    else                  CHECK(!p.on_boundary && (p.order == -1 || p.order == 1 || p.order == 2));
    if (i < given.size() && given[i].pinned) CHECK(same(p, given[i]));
    if (p.on_boundary) CHECK(internal::boundary_place(t, p.location).halfedge != Mesh::null_halfedge());
  }
  const bool here = c.searched_vertices == t.number_of_vertices();
  if (here) CHECK_NEAR(c.distortion, s.energy(c.divisor), 1e-9);
  const Optimal_divisor o = s.optimal(c.divisor);
  CHECK(o.legal.residual.norm() <= 1e-11);
  CHECK_EQUAL(collision(t, o.legal.divisor, Legalization_options().least_distance), "");
  for (std::size_t k = 1; k < o.history.size(); ++k) CHECK(o.history[k].objective < o.history[k - 1].objective);
  CHECK(o.distortion <= o.history.front().distortion * 1.001);
  if (here) CHECK(o.distortion <= c.distortion * 1.001 + 1e-15);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i].pinned) CHECK(same(o.legal.divisor[i], given[i]));
  const Exact_cone_metric m = exact_cone_metric(t, s.surface.homology.cochains, o.legal.divisor, {}, visitor);
  CHECK(m.reached);
  std::cout << name << ": " << given.size() << " corners and " << c.divisor.size() - given.size()
            << " singularities, distortion " << c.distortion << ", optimised " << o.distortion << ", holonomy "
            << m.max_holonomy_error << ", " << c.solves << " solves" << std::endl;
  return o.legal.divisor;
}

void test_plates()
{
  const auto whole = [](int, int) { return true; };
  for (const auto& [name, mesh, corners] : std::vector<std::tuple<std::string, Mesh, std::size_t>>{
         {"two triangles", plate_of_squares(1, 1, whole), 4}, {"rectangle", plate_of_squares(12, 7, whole), 4},
         {"L with a hole", l_with_hole(), 10}}) {
    const Setting s{Intrinsic_triangulation(mesh)};
    const Divisor given = boundary_corners(s.triangulation());
    CHECK_EQUAL(given.size(), corners);
    CHECK_EQUAL(check_choice(name, s, given).size(), corners);   // nothing else is needed
    CHECK(s.energy(given) < 1e-20);
    CHECK_EQUAL(s.chosen(given).solves, 1u);   // nothing is searched
  }
  // a fine one, not parallel to the axes: rounding is not taken for a condition that fails
  Mesh fine = plate_of_squares(210, 140, [](int i, int j) { return i / 30 % 2 == 0 || j / 70 > 0 || j < 30; });
  for (Vertex v : fine.vertices()) {
    const Point_3 p = fine.point(v);
    fine.point(v) = in_space(std::polar(1 / 70., 0.3) * std::complex<double>(p.x(), p.y()));
  }
  const Setting holes{Intrinsic_triangulation(fine)};
  const Divisor all = boundary_corners(holes.triangulation());
  CHECK_EQUAL(all.size(), 16u);
  CHECK_EQUAL(holes.chosen(all).divisor.size(), 16u);
  CHECK_EQUAL(legalize_divisor(holes.map, all, {}, visitor).divisor.size(), 16u);

  // all corners are pinned: what they leave open singularities make good
  const Setting s{Intrinsic_triangulation(plate_with_turned_hole(0.4, 48, 10))};
  const Divisor given = boundary_corners(s.triangulation());
  CHECK_EQUAL(given.size(), 8u);
  CHECK(check_choice("turned hole", s, given).size() >= 10u);
  Singularity_choice_options pairs;
  pairs.start = Singularity_start::pairs;
  CHECK(check_choice("turned hole, by pairs", s, given, pairs).size() >= 10u);
  pairs.count = 8;
  CHECK_THROWS(s.chosen(given, pairs), Infeasible_divisor_error, "at least 10 simple singularities are needed");
}

void test_smooth_boundary()
{
  const Polygon rim = circle(80, [](int) { return 1; }), hole = circle(80, [](int) { return 0.6; });
  const Setting disk{Intrinsic_triangulation(star_shaped(rim, 20))};
  const Setting annulus{Intrinsic_triangulation(ring_between(hole, rim, 8))};
  Singularity_choice_options four;
  four.count = 4;
  const Divisor poles = check_choice("disk", disk, {}, four);
  CHECK_EQUAL(poles.size(), 4u);
  for (const Singularity& p : poles) CHECK_EQUAL(p.order, -1);
  four.count = 3;
  CHECK_THROWS(disk.chosen({}, four), Infeasible_divisor_error,
               "at least 4 simple singularities are needed on a surface of genus 0 with 1 boundary curve");
  check_choice("disk", disk, {});
  Singularity_choice_options coarse_goal;
  coarse_goal.distortion = 0.1;
  CHECK_EQUAL(check_choice("annulus", annulus, {}, coarse_goal).size(), 0u);   // D = 0
  check_choice("annulus", annulus, {});
  // these would have to coincide, but for a pair
  const auto curve = annulus.triangulation().boundary_curves()[0];
  const Divisor opposite{{on_curve(annulus.triangulation(), curve, 0.2), -1, true, true},
                         {on_curve(annulus.triangulation(), curve, 0.6), 1, false, true}};
  CHECK_THROWS(legalize_divisor(annulus.map, opposite, {}, visitor), Infeasible_divisor_error, "force");
  Singularity_choice_options any;
  any.distortion = 100;
  any.start = Singularity_start::pairs;
  CHECK_EQUAL(check_choice("annulus with two corners", annulus, opposite, any).size(), 4u);
}

// Corners that are not pinned go where they distort least.
void test_sliding()
{
  const Setting s{Intrinsic_triangulation(l_with_hole())};
  Divisor corners = boundary_corners(s.triangulation());
  const auto begin = s.map.lift_on_boundary(corners[1].location);
  corners[1].pinned = false;
  corners[1].location = s.map.moved(begin, 0.5).location;   // off its place
  const Divisor best = check_choice("L with a sliding corner", s, corners);
  CHECK_EQUAL(best.size(), corners.size());
  CHECK(s.energy(best) < 0.1 * s.energy(corners));
}

// Found corners stay where they are and ask for singularities, but for those that are nearly legal: they slide a little.
void test_chosen_corners()
{
  for (const double turn : {0., 0.02, 0.4}) {
    const Setting s{Intrinsic_triangulation(plate_with_turned_hole(turn, 48, 10))};
    const Divisor corners = boundary_corners(s.triangulation());
    const Chosen_singularities c = s.chosen_with_corners();
    CHECK_EQUAL(degree(c.divisor), 0);
    const bool slides = !c.divisor[0].pinned;
    std::cout << "hole turned by " << turn << ": " << c.divisor.size() << " singularities, distortion " << c.distortion
              << (slides ? ", corners slide" : ", corners stay") << std::endl;
    CHECK_EQUAL(c.divisor.size() == corners.size(), turn < 0.1);
    CHECK_EQUAL(slides, turn == 0.02);
    for (std::size_t k = 0; k < corners.size(); ++k)
      CHECK(slides ? c.divisor[k].on_boundary && !c.divisor[k].pinned : same(c.divisor[k], corners[k]));
    if (slides) {
      CHECK(c.distortion < s.chosen(corners).distortion);
      CHECK(s.optimal(c.divisor).legal.residual.norm() <= 1e-11);
    }
  }
  const Setting disk{Intrinsic_triangulation(star_shaped(circle(60, [](int) { return 1; }), 10))};
  CHECK(disk.chosen_with_corners().distortion == disk.chosen({}).distortion);
}

void test_noisy_boundary(std::mt19937& random)
{
  Polygon rough = rectangle(1, 0.6, 0, 80);
  for (std::complex<double>& z : rough) z *= 1 + 0.01 * uniform(random, -1, 1);
  const Setting s{Intrinsic_triangulation(star_shaped(rough, 12))};
  const Divisor corners = boundary_corners(s.triangulation());
  CHECK_EQUAL(corners.size(), 4u);
  check_choice("rough rectangle", s, corners);
}

void test_coarse_search()
{
  const Setting s{Intrinsic_triangulation(plate_with_turned_hole(0.4, 64, 24))};
  Divisor corners = boundary_corners(s.triangulation());
  corners[2].pinned = false;
  Singularity_choice_options options;
  options.coarse_vertices = s.triangulation().number_of_vertices() / 3;
  check_choice("turned hole, on a coarsening", s, corners, options);
  options.explored_vertices = options.coarse_vertices / 2;
  check_choice("turned hole, explored on another", s, corners, options);
}

void test_real_surfaces()
{
  int disks = 1;
  for (const Named_surface& mesh : real_surfaces({"sculpt_7k3", "3holes_7k2"})) {
    ++disks;
    const Setting s{Intrinsic_triangulation(with_disks_cut_out(mesh.surface.mesh(), disks, 0.1))};
    const Chosen_singularities c = s.chosen_with_corners();
    const auto is_corner = [](const Singularity& p) { return p.on_boundary; };
    const auto corners = std::count_if(c.divisor.begin(), c.divisor.end(), is_corner);
    std::cout << mesh.name << " without " << disks << " disks: " << corners << " corners and "
              << c.divisor.size() - static_cast<std::size_t>(corners) << " singularities, distortion " << c.distortion
              << std::endl;
    CHECK_EQUAL(degree(c.divisor), required_degree(s.triangulation()));
    const Optimal_divisor o = s.optimal(c.divisor);
    CHECK(o.distortion <= c.distortion * 1.001);
    CHECK(o.legal.residual.norm() <= 1e-11);
    CHECK(exact_cone_metric(s.triangulation(), s.surface.homology.cochains, o.legal.divisor, {}, visitor).reached);
  }
}

void test_refusals()
{
  const Setting s{Intrinsic_triangulation(plate(1, 14))};
  Singularity_choice_options options;
  options.start = Singularity_start::curvature;
  CHECK_THROWS(s.chosen({}, options), Infeasible_divisor_error, "not from the curvature");
  options.start = Singularity_start::field;
  const Divisor inner{{{Face(60), {0.3, 0.3, 0.4}}, 1}};
  CHECK_THROWS(s.chosen(inner, options), Infeasible_divisor_error, "only be completed by pairs");
  const Divisor inner_corner{{{Face(60), {0.3, 0.3, 0.4}}, 1, false, true}};
  CHECK_THROWS(s.chosen(inner_corner), Infeasible_divisor_error, "marked as a corner");
  const Divisor repaired = with_repaired_degree(s.triangulation(), s.surface.weights, inner);
  CHECK_EQUAL(degree(repaired), 0);
  CHECK_EQUAL(collision(s.triangulation(), repaired, 0.02), "");
}

} // namespace

int main()
{
  std::mt19937 random(2026);
  const std::vector<Surface_with_boundary> surfaces = surfaces_with_boundary();
  test_fields(surfaces, random);
  for (int k : {0, 3, 5, 7}) {
    const Setting s(surfaces[k].surface);
    test_gradients(s, random);
    test_guards(s, random);
    test_coarsening(surfaces[k]);
  }
  test_plates();
  test_smooth_boundary();
  test_sliding();
  test_chosen_corners();
  test_noisy_boundary(random);
  test_coarse_search();
  test_refusals();
  for (const Surface_with_boundary& s : surfaces) {
    const Setting setting(s.surface);
    check_choice(s.name, setting, boundary_corners(setting.triangulation()));
  }
  test_real_surfaces();
  return Quartic_test::result();
}
