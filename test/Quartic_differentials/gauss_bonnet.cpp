// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Step 6: the flat cone metric has its curvature where it should, and after the outer Newton iteration the holonomy
// of every loop and the transition across every edge is a multiple of 90 degrees.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <cmath>
#include <numeric>

using namespace CGAL::Quartic_differentials;

namespace {

const double pi = std::acos(-1.0);

double worst_curvature_error(const Cone_metric& m)
{
  const std::vector<double> k = curvatures(m.triangulation, corner_angles(m.triangulation, m.lengths));
  double worst = 0;
  for (std::size_t v = 0; v < k.size(); ++v) worst = std::max(worst, std::abs(k[v] + m.order[v] * pi / 2));
  return worst;
}

void test_exact_metric(const Quartic_test::Named_surface& named)
{
  Visitor visitor;
  const Riemann_surface s = riemann_surface(named.surface, visitor);
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  const Divisor initial = curvature_divisor(s.delaunay, s.weights, s.laplacian, 0);
  const Divisor legal = legalize_divisor(map, s.periods, initial, {}, visitor).divisor;
  const Exact_cone_metric m = exact_cone_metric(s.delaunay, s.homology.cochains, legal, {}, visitor);
  std::cout << named.name << ": " << m.first_flow.newton_iterations << " Newton steps, curvature error "
            << m.metric.flow.max_curvature_error << ", " << m.history.size() - 1 << " outer steps, holonomy error "
            << m.max_holonomy_error << ", on edges " << m.max_transition_error << std::endl;
  const int g = named.surface.genus();
  CHECK(m.reached);
  CHECK(m.first_flow.newton_iterations <= 15);
  CHECK(m.history.size() - 1 <= 6);
  CHECK(worst_curvature_error(m.metric) <= 1e-11 + 1e-15 * static_cast<double>(m.metric.order.size()));
  CHECK(m.max_holonomy_error <= 1e-10);
  CHECK(m.max_transition_error <= 1e-10);
  CHECK_EQUAL(std::accumulate(m.metric.order.begin(), m.metric.order.end(), 0), 8 * g - 8);   // Gauss-Bonnet
  CHECK_EQUAL(structural_defect(m.metric.triangulation), "");
  CHECK_EQUAL(intersection_numbers(m.metric.triangulation, m.metric.cochains), symplectic_unit(g));
  const double total = [&] {
    const std::vector<double> k = curvatures(s.delaunay, corner_angles(s.delaunay, s.delaunay.lengths()));
    return std::accumulate(k.begin(), k.end(), 0.0);
  }();
  CHECK_NEAR(total, 2 * pi * (2 - 2 * g), 1e-8);
}

// d(turning numbers) / d(positions) against finite differences of whole flows
void test_holonomy_jacobian()
{
  Visitor visitor;
  const Intrinsic_triangulation input(handle_chain(2, 6));
  const Riemann_surface s = riemann_surface(input, visitor);
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  const Divisor d = legalize_divisor(map, s.periods, curvature_divisor(s.delaunay, s.weights, s.laplacian, 16), {},
                                     visitor).divisor;
  const Cone_metric_options options;
  const Eigen::MatrixXd j = holonomy_jacobian(s.delaunay, s.homology.cochains, d, options, visitor);
  std::mt19937 random(23);
  Eigen::VectorXd direction(j.cols());
  for (double& x : direction) x = Quartic_test::uniform(random, -1, 1);
  const double step = 1e-5 * std::sqrt(input.area());
  const auto turning = [&](double by) {
    Divisor moved = d;
    for (std::size_t i = 0; i < d.size(); ++i)
      moved[i].location = internal::walk(s.delaunay, d[i].location,
                                         by * std::complex<double>(direction[2 * i], direction[2 * i + 1]),
                                         [](const Surface_point&, const Surface_point&) {}).point;
    const Cone_metric m = cone_metric(s.delaunay, s.homology.cochains, moved, nullptr, options, visitor);
    return turning_numbers(m.triangulation, m.cochains, m.angles);
  };
  const Eigen::VectorXd difference = (turning(step) - turning(-step)).unaryExpr([](double x) { return quarter_turn_defect(x); });
  const Eigen::VectorXd expected = j * direction;
  const double error = (difference / (2 * step) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
  std::cout << "holonomy Jacobian against differences: relative error " << error << std::endl;
  CHECK(error < 1e-4);
}

// A factorised Laplacian of the surface spares the first Newton step's: the step is nearly the same, the metric is.
void test_first_step()
{
  Visitor visitor;
  for (const auto& [name, input] : Quartic_test::sample_surfaces()) {
    const Riemann_surface s = riemann_surface(input, visitor);
    const Divisor d = curvature_divisor(s.delaunay, s.weights, s.laplacian, std::max(8 * input.genus() - 8, 0) + 8);
    const auto flow = [&](const Laplacian_solver* factorized) {
      return cone_metric(s.delaunay, s.homology.cochains, d, nullptr, {}, visitor, factorized);
    };
    const Cone_metric own = flow(nullptr), spared = flow(&s.laplacian);
    CHECK(own.flow.reached() && spared.flow.reached());
    CHECK_NEAR(spared.flow.history[1], own.flow.history[1], 0.01 * own.flow.history[1]);
    double worst = 0;
    for (std::size_t v = 0; v < own.u.size(); ++v)
      worst = std::max(worst, std::abs((spared.u[v] - spared.u[0]) - (own.u[v] - own.u[0])));
    CHECK_NEAR(worst, 0, 1e-8);
    std::cout << name << ": curvature error after one step " << own.flow.history[1] << " and " << spared.flow.history[1]
              << ", scales differ by " << worst << std::endl;
  }
}

// Cones at vertices are kept there, frozen; if that takes too many degrees of freedom, they are moved off.
void test_cones_at_vertices()
{
  Visitor visitor;
  const Intrinsic_triangulation input(torus(1, 0.4, 40, 24));
  const Riemann_surface s = riemann_surface(input, visitor);
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  Divisor d = curvature_divisor(s.delaunay, s.weights, s.laplacian, 8);
  d = legalize_divisor(map, s.periods, d, {}, visitor).divisor;
  const auto to_vertex = [&](Singularity& p) { p.location.barycentric = {1 - 2e-6, 1e-6, 1e-6}; };

  Divisor one = d;
  to_vertex(one[0]);
  const Exact_cone_metric m = exact_cone_metric(s.delaunay, s.homology.cochains, one, {}, visitor);
  CHECK(m.reached);
  CHECK(m.metric.cones[0].idx() < input.number_of_vertices());
  CHECK_EQUAL(m.moved_by[0], 0);
  CHECK_EQUAL(m.metric.order[m.metric.cones[0]], one[0].order);
  CHECK(worst_curvature_error(m.metric) <= 1e-10);

  Divisor all = d;
  for (Singularity& p : all) to_vertex(p);
  const Exact_cone_metric off = exact_cone_metric(s.delaunay, s.homology.cochains, all, {}, visitor);
  CHECK(off.reached);
  CHECK(off.metric.cones[0].idx() >= input.number_of_vertices());

  Divisor twice = one;
  twice[1].location = twice[0].location;
  CHECK_THROWS(cone_metric(s.delaunay, s.homology.cochains, twice, nullptr, {}, visitor), Infeasible_divisor_error,
               "same vertex");
}

void test_flat_torus_without_singularities()
{
  Visitor visitor;
  const Intrinsic_triangulation input(torus(1, 0.4, 40, 24));
  const Riemann_surface s = riemann_surface(input, visitor);
  const Exact_cone_metric m = exact_cone_metric(s.delaunay, s.homology.cochains, {}, {}, visitor);
  std::cout << "flat torus: curvature error " << m.metric.flow.max_curvature_error << ", turning " << m.turning.transpose()
            << ", on edges " << m.max_transition_error << std::endl;
  CHECK(m.reached);
  CHECK(m.metric.flow.max_curvature_error < 1e-11);
  CHECK(m.max_transition_error < 1e-10);
}

// Stops as soon as a step begins.
class Stop_at : public Visitor
{
public:
  explicit Stop_at(const std::string& step) : m_step(step) {}
  void step_begins(const std::string& name) override { m_stop = m_stop || name == m_step; }
  bool go_further() override { return !m_stop; }
private:
  std::string m_step;
  bool        m_stop = false;
};

void test_cancellation()
{
  for (const char* step : {"legalization", "cone_metric"}) {
    Stop_at stop(step);
    Quartic_differential_result result;
    CHECK_THROWS(quartic_differential(Intrinsic_triangulation(torus(1, 0.4, 20, 12)), std::nullopt, {}, stop, result),
                 Cancelled_error, "stopped");
    CHECK(result.surface.has_value());   // what was computed is kept
    CHECK_EQUAL(result.legal.has_value(), step == std::string("cone_metric"));
    CHECK(!result.metric.has_value());
  }
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test_exact_metric(s);
  test_holonomy_jacobian();
  test_first_step();
  test_cones_at_vertices();
  test_flat_torus_without_singularities();
  test_cancellation();
  return Quartic_test::result();
}
