// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Divisors of least area distortion: every step stays on the Abel-Jacobi variety and lowers the objective.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/minimize_distortion.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <algorithm>
#include <cmath>

using namespace CGAL::Quartic_differentials;

namespace {

struct Setting
{
  explicit Setting(const Intrinsic_triangulation& input)
    : surface(riemann_surface(input, visitor)), map(surface.delaunay, surface.homology.cochains, surface.forms),
      distortion(surface.delaunay, surface.laplacian, vertex_areas(surface.delaunay)),
      size(std::sqrt(surface.delaunay.area())) {}

  Optimal_divisor optimal(const Divisor& d, const Distortion_options& options = {})
  { return minimize_distortion(distortion, map, surface.periods, d, {}, options, visitor); }
  Divisor from_curvature(int count) const
  { return curvature_divisor(surface.delaunay, surface.weights, surface.laplacian, count); }
  double distance(const Divisor& d, std::size_t i, std::size_t k) const
  { return nearest_singularities(surface.delaunay, {d[i].location, d[k].location}, 0.2 * size).distance / size; }

  Visitor         visitor;
  Riemann_surface surface;
  Abel_jacobi_map map;
  Area_distortion distortion;
  double          size;
};

double abel_jacobi_defect(const Setting& s, const Divisor& d)
{
  const Eigen::VectorXd f = s.map.residual(d) / (std::acos(-1.0) / 2);
  return f.size() == 0 ? 0 : (f - f.array().round().matrix()).cwiseAbs().maxCoeff();
}

bool same(const Divisor& a, const Divisor& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Singularity& p, const Singularity& q) {
    return p.location.face == q.location.face && p.location.barycentric == q.location.barycentric && p.order == q.order;
  });
}

void test_descent(const Quartic_test::Named_surface& named)
{
  Setting s(named.surface);
  const Divisor start = s.from_curvature(0);
  const Optimal_divisor o = s.optimal(start);
  std::cout << named.name << ": " << start.size() << " singularities, distortion " << o.history.front().distortion
            << " -> " << o.distortion << " in " << o.history.size() - 1 << " steps, area scale " << o.area_scale_before
            << " -> " << o.area_scale_after << ", " << s.distortion.solves() << " solves" << std::endl;
  for (std::size_t k = 0; k < o.history.size(); ++k) {
    CHECK(o.history[k].residual <= 1e-11);
    CHECK(o.history[k].objective >= o.history[k].distortion);
    if (k > 0) CHECK(o.history[k].objective < o.history[k - 1].objective);
    CHECK(o.history[k].length <= 0.0501 * s.size);
  }
  CHECK(o.history.back().distortion < o.history.front().distortion);
  CHECK(o.area_scale_after < o.area_scale_before);
  CHECK_NEAR(o.distortion, s.distortion.energy(s.distortion.log_scale(o.legal.divisor)), 1e-12);
  CHECK_NEAR(o.distortion, o.history.back().distortion, 1e-3 * o.distortion);   // but for moves off vertices
  CHECK(abel_jacobi_defect(s, o.legal.divisor) < 1e-11);
  CHECK(o.legal.residual.norm() <= 1e-11);
  CHECK_EQUAL(o.legal.divisor.size(), start.size());
  for (std::size_t i = 0; i < start.size(); ++i) CHECK_EQUAL(o.legal.divisor[i].order, start[i].order);
  CHECK(same(o.legal.divisor, s.optimal(start).legal.divisor));   // deterministic
}

// An optimum is one: nothing is gained from starting there again.
void test_optimum()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 8))};
  const Optimal_divisor o = s.optimal(s.from_curvature(16));
  const Optimal_divisor again = s.optimal(o.legal.divisor);
  CHECK(again.distortion <= o.distortion * (1 + 1e-3));
  CHECK(again.distortion >= o.distortion * 0.9);
}

void test_pinned()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 6))};
  Divisor d = s.from_curvature(16);
  for (std::size_t i : {0, 3, 9}) d[i].pinned = true;
  const Optimal_divisor o = s.optimal(d);
  CHECK(o.distortion < o.history.front().distortion);
  for (std::size_t i : {0, 3, 9}) {
    CHECK(o.legal.moved_by[i] == 0);
    CHECK(o.legal.divisor[i].location.face == d[i].location.face);
    CHECK(o.legal.divisor[i].location.barycentric == d[i].location.barycentric);
  }
  // with less than 2g degrees of freedom the condition cannot be kept: the rank of the Jacobian drops
  for (std::size_t i = 1; i < d.size(); ++i) d[i].pinned = true;
  d[0].pinned = false;
  CHECK_THROWS(s.optimal(d), Infeasible_divisor_error, "control only 2 of the 4");
}

// Singularities that the forces drive together are kept apart by the guard: an opposite pair, which would annihilate,
// and two zeros on a saddle.
void test_kept_apart()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 8))};
  const Optimal_divisor base = s.optimal(s.from_curvature(16));
  Divisor d = base.legal.divisor;
  const auto beside = [&](const Surface_point& p, double distance) {
    return s.map.moved(s.map.lift(p), std::polar(distance * s.size, 0.7)).location;
  };
  // an opposite pair that lowers nothing where it is
  d.push_back({beside(d[2].location, 0.08), -1, false});
  d.push_back({beside(d.back().location, 0.02), +1, false});
  const Optimal_divisor o = s.optimal(d);
  std::cout << "opposite pair: distance " << s.distance(d, 16, 17) << " -> " << s.distance(o.legal.divisor, 16, 17) << '\n';
  CHECK(abel_jacobi_defect(s, o.legal.divisor) < 1e-11);
  for (std::size_t i = 0; i < d.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) CHECK(!(s.distance(o.legal.divisor, i, k) < 0.01));
  Visitor visitor;
  CHECK(exact_cone_metric(s.surface.delaunay, s.surface.homology.cochains, o.legal.divisor, {}, visitor).reached);

  // on top of each other from the start: refused
  d = base.legal.divisor;
  d[1].location = d[0].location;
  CHECK_THROWS(s.optimal(d), Infeasible_divisor_error, "too near each other");
}

// Singularities that reach a vertex leave it again, so that the flat metric has no needles.
void test_vertices()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 6))};
  Divisor d = s.optimal(s.from_curvature(16)).legal.divisor;
  for (std::size_t i = 0; i < 6; ++i) d[i].location.barycentric = {1 - 2e-5, 1e-5, 1e-5};
  Distortion_options none;
  none.iterations = 0;
  const Optimal_divisor o = s.optimal(d, none);
  for (const Singularity& p : o.legal.divisor)
    CHECK(*std::max_element(p.location.barycentric.begin(), p.location.barycentric.end()) <= 0.98);
  CHECK(abel_jacobi_defect(s, o.legal.divisor) < 1e-11);
  Visitor visitor;
  CHECK(exact_cone_metric(s.surface.delaunay, s.surface.homology.cochains, o.legal.divisor, {}, visitor).reached);
}

void test_cancellation()
{
  struct Impatient : Visitor { bool go_further() override { return ++asked < 5; } int asked = 0; } impatient;
  Setting s{Intrinsic_triangulation(handle_chain(2, 6))};
  CHECK_THROWS(minimize_distortion(s.distortion, s.map, s.surface.periods, s.from_curvature(16), {}, {}, impatient),
               Cancelled_error, "stopped");
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test_descent(s);
  for (const auto& s : Quartic_test::real_surfaces({"rockerarm_20k", "sculpt_7k3", "buddha_20k"})) test_descent(s);
  test_optimum();
  test_pinned();
  test_kept_apart();
  test_vertices();
  test_cancellation();
  return Quartic_test::result();
}
