// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The area distortion of a divisor: its gradient against finite differences, exact changes against recomputation, and
// the linear theory against the discrete Ricci flow.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/internal/distortion_descent.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <cmath>
#include <random>

using namespace CGAL::Quartic_differentials;

namespace {

const double quarter_turn = std::acos(-1.0) / 2;

struct Setting
{
  explicit Setting(const Intrinsic_triangulation& input)
    : surface(riemann_surface(input, visitor)),
      distortion(surface.delaunay, surface.laplacian, vertex_areas(surface.delaunay)),
      size(std::sqrt(surface.delaunay.area())) {}

  double energy(const Divisor& d) const { return distortion.energy(distortion.log_scale(d)); }

  Visitor         visitor;
  Riemann_surface surface;
  Area_distortion distortion;
  double          size;
};

// Singularities of orders -2 .. 2 anywhere, of degree 8g - 8.
Divisor random_divisor(const Intrinsic_triangulation& t, std::mt19937& random)
{
  Divisor d;
  const auto add = [&](int order) {
    const double a = Quartic_test::uniform(random, 0.1, 0.4), b = Quartic_test::uniform(random, 0.1, 0.4);
    d.push_back({{Face(static_cast<Mesh::size_type>(random() % t.number_of_faces())), {a, b, 1 - a - b}}, order, false});
  };
  for (int order : {-2, -1, 1, 2}) add(order);
  while (degree(d) != 8 * t.genus() - 8) add(degree(d) < 8 * t.genus() - 8 ? 1 : -1);
  return d;
}

Divisor moved(const Intrinsic_triangulation& t, Divisor d, const Eigen::VectorXd& step)
{
  for (std::size_t i = 0; i < d.size(); ++i)
    d[i].location = internal::walk(t, d[i].location, {step[2 * i], step[2 * i + 1]},
                                   [](const Surface_point&, const Surface_point&) {}).point;
  return d;
}

// The derivative along a direction is met to 1e-6 inside the faces, where E is a quadratic polynomial; the recovered
// gradient is only near it.
void test_gradient(const Setting& s, std::mt19937& random)
{
  const Intrinsic_triangulation& t = s.surface.delaunay;
  const Divisor d = random_divisor(t, random);
  const Eigen::VectorXd w = s.distortion.potential(s.distortion.log_scale(d));
  const Eigen::VectorXd g = s.distortion.gradient(d, w), recovered = s.distortion.recovered_gradient(d, w);
  const double h = 1e-5 * s.size;
  Eigen::VectorXd differences(g.size());
  for (Eigen::Index k = 0; k < g.size(); ++k) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(g.size(), k);
    differences[k] = (s.energy(moved(t, d, step)) - s.energy(moved(t, d, -step))) / (2 * h);
  }
  CHECK_NEAR((differences - g).norm() / g.norm(), 0, 1e-6);
  CHECK_NEAR((recovered - g).norm() / g.norm(), 0, 0.5);
  CHECK((recovered - g).norm() > 0);
}

// Adding and moving charges changes E exactly as predicted.
void test_changes(const Setting& s, std::mt19937& random)
{
  const Intrinsic_triangulation& t = s.surface.delaunay;
  Divisor d = random_divisor(t, random);
  const Divisor places = random_divisor(t, random);
  const Eigen::VectorXd u = s.distortion.log_scale(d);
  const double e = s.distortion.energy(u);
  const Charge_changes changes(s.distortion, u, s.distortion.greens_functions(locations(places)));
  for (int trial = 0; trial < 10; ++trial) {
    const std::size_t a = random() % places.size(), b = random() % places.size();
    const int order = 1 + static_cast<int>(random() % 3);
    Divisor more = d;
    more.push_back({places[a].location, -order, false});
    more.push_back({places[b].location, order, false});
    const double change = changes.of_pair(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b), order * quarter_turn);
    CHECK_NEAR(s.energy(more), e + change, 1e-9 * (1 + e));
  }
}

// A divisor of another degree is as good as one with the rest spread over the area.
void test_background(const Setting& s)
{
  const Eigen::VectorXd u = s.distortion.log_scale({});
  CHECK_NEAR(u.dot(s.distortion.mass()), 0, 1e-9 * s.distortion.mass().sum());
  const Eigen::MatrixXd g = s.distortion.greens_functions({{Face(0), {1, 0, 0}}, {Face(7), {0, 1, 0}}});
  CHECK_NEAR(g(s.surface.delaunay.source(s.surface.delaunay.halfedges(Face(7))[1]).idx(), 0),
             g(s.surface.delaunay.source(s.surface.delaunay.halfedges(Face(0))[0]).idx(), 1),
             1e-9 * g.cwiseAbs().maxCoeff());   // symmetric
}

void test_quantiles()
{
  Eigen::VectorXd x(4), weight(4);
  x << 3, 1, 2, 0;
  weight << 1, 1, 1, 97;
  CHECK_EQUAL(weighted_quantile(x, weight, 0.5), 0);
  CHECK_EQUAL(weighted_quantile(x, weight, 0.975), 1);
  CHECK_EQUAL(weighted_quantile(x, weight, 1), 3);
  CHECK_NEAR(area_scale_ratio(x, weight), std::exp(2 * 2), 1e-12);
}

// Near pairs repel each other, along the way between them, whether they have the same sign or not.
void test_guard()
{
  const Setting s{Intrinsic_triangulation(torus(1, 0.4, 60, 36))};
  const Intrinsic_triangulation& t = s.surface.delaunay;
  const double reach = 0.05 * s.size;
  const Divisor one{{{Face(100), {0.3, 0.3, 0.4}}, 1, false}};
  for (double angle : {0.3, 2.0, -1.5})
    for (int order : {1, -1}) {
      Divisor d = one;
      d.push_back({moved(t, one, 0.4 * reach * Eigen::Vector2d(std::cos(angle), std::sin(angle)))[0].location, order, false});
      const auto guard = internal::distance_guard(t, d, reach, 0.1);
      CHECK_NEAR(guard.value, 0.1 * 0.6 * 0.6, 1e-9);
      const double h = 1e-5 * reach;
      for (Eigen::Index k = 0; k < 4; ++k) {
        const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(4, k);
        const double difference = (internal::distance_guard(t, moved(t, d, step), reach, 0.1).value
                                   - internal::distance_guard(t, moved(t, d, -step), reach, 0.1).value) / (2 * h);
        CHECK_NEAR(guard.gradient[k], difference, 1e-5 / reach);
      }
      CHECK(internal::distance_guard(t, d, 0.3 * reach, 0.1).value == 0);
    }
  // on top of each other: driven apart
  const auto together = internal::distance_guard(t, {one[0], one[0]}, reach, 0.1);
  CHECK_NEAR(together.value, 0.1, 1e-12);
  CHECK((together.gradient.head<2>() - together.gradient.tail<2>()).norm() > 0);
}

} // namespace

int main()
{
  std::mt19937 random(5);
  for (const auto& named : Quartic_test::sample_surfaces()) {
    const Setting s(named.surface);
    for (int k = 0; k < 3; ++k) {
      test_gradient(s, random);
      test_changes(s, random);
    }
    test_background(s);
  }
  for (const auto& named : Quartic_test::real_surfaces({"spot_5k8", "buddha_20k"})) {
    const Setting s(named.surface);
    test_gradient(s, random);
    test_changes(s, random);
  }
  test_quantiles();
  test_guard();
  return Quartic_test::result();
}
