// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Laplacian is solved to rounding however the solver came to it: factorised anew, with the order of elimination of
// another triangulation, or near one that was factorised. Its weights, and the angles, are right in needles too.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cmath>
#include <random>

using namespace CGAL::Quartic_differentials;

namespace {

using Weights = std::vector<double>;

// two right-hand sides that sum to zero
Eigen::MatrixXd right_hand_sides(std::size_t n, std::mt19937& random)
{
  Eigen::MatrixXd b(n, 2);
  for (Eigen::Index k = 0; k < b.size(); ++k) b(k) = Quartic_test::uniform(random, -1, 1);
  return b.rowwise() - b.colwise().mean();
}

// max |L x - b|
double residual(const Intrinsic_triangulation& t, const Weights& w, const Eigen::MatrixXd& x, const Eigen::MatrixXd& b)
{
  Eigen::MatrixXd r = -b;
  for (Edge e : t.edges()) {
    const auto i = t.source(t.halfedge(e)).idx(), j = t.target(t.halfedge(e)).idx();
    const Eigen::RowVectorXd flux = w[e] * (x.row(i) - x.row(j));
    r.row(i) += flux;
    r.row(j) -= flux;
  }
  return r.cwiseAbs().maxCoeff();
}

// weights multiplied by random numbers between 1/factor and factor
Weights disturbed(Weights w, double factor, std::mt19937& random)
{
  for (double& x : w) x = (0.1 + std::abs(x)) * std::pow(factor, Quartic_test::uniform(random, -1, 1));
  return w;
}

// The solutions after `factorize()` and `update()` have small residuals, and differ little.
void near_and_far(const Intrinsic_triangulation& t, std::mt19937& random)
{
  const Weights base = disturbed(cotangent_weights(t, t.lengths()), 1, random);
  const Eigen::MatrixXd b = right_hand_sides(t.number_of_vertices(), random);
  Laplacian_solver solver;
  solver.factorize(t, base);
  CHECK_NEAR(residual(t, base, solver.solve(b), b), 0, 1e-10);
  for (double factor : {1.0, 1.001, 1.1, 100.0}) {   // the last is beyond conjugate gradients
    const Weights w = disturbed(base, factor, random);
    solver.update(t, w);
    const Eigen::MatrixXd x = solver.solve(b);
    CHECK_NEAR(residual(t, w, x, b), 0, 1e-8);
    Laplacian_solver fresh;
    fresh.factorize(t, w);
    CHECK_NEAR((fresh.solve(b) - x).norm(), 0, 1e-8 * x.norm());
  }
}

// After `update()` the residual is as small as asked for, and not much smaller.
void as_precise_as_asked_for(const Intrinsic_triangulation& t, std::mt19937& random)
{
  const Weights base = disturbed(cotangent_weights(t, t.lengths()), 1, random), w = disturbed(base, 1.5, random);
  const Eigen::MatrixXd b = right_hand_sides(t.number_of_vertices(), random);
  Laplacian_solver solver;
  solver.factorize(t, base);
  solver.update(t, w);
  CHECK(solver.solve(0 * b).isZero(0));
  for (Eigen::Index column = 0; column < b.cols(); ++column) {
    const Eigen::MatrixXd one = b.col(column);
    double previous = 1;
    for (double relative_residual : {1e-1, 1e-3, 1e-6}) {
      const double reached = residual(t, w, solver.solve(one, relative_residual), one) / one.cwiseAbs().maxCoeff();
      CHECK(reached <= relative_residual + 1e-12);
      CHECK(reached > 1e-2 * relative_residual && reached < previous);
      previous = reached;
    }
  }
}

// Large surfaces are ordered by nested dissection. Rounding grows with the solution, and the equation of the first vertex,
// which is not solved for, collects that of all others.
void nested_dissection(const Intrinsic_triangulation& t, std::mt19937& random)
{
  const Weights w = cotangent_weights(t, t.lengths());
  const Eigen::MatrixXd b = right_hand_sides(t.number_of_vertices(), random);
  Laplacian_solver solver;
  solver.factorize(t, w);
  const Eigen::MatrixXd x = solver.solve(b);
  const double rounding = 1e-14 * x.cwiseAbs().maxCoeff();
  CHECK_NEAR(residual(t, w, x, b), 0, std::sqrt(static_cast<double>(t.number_of_vertices())) * rounding);
}

// Flips and new vertices after the order of elimination was found.
void other_patterns(Intrinsic_triangulation t, std::mt19937& random)
{
  Laplacian_solver first, solver;
  first.factorize(t, cotangent_weights(t, t.lengths()));
  solver.set_order_of(first);
  for (int round = 0; round < 3; ++round) {
    for (int k = 0; k < 5; ++k) t.insert({Face(static_cast<Mesh::size_type>(random() % t.number_of_faces())), {0.2, 0.3, 0.5}});
    make_delaunay(t);
    const Weights w = cotangent_weights(t, t.lengths());
    const Eigen::MatrixXd b = right_hand_sides(t.number_of_vertices(), random);
    round == 1 ? solver.update(t, w) : solver.factorize(t, w);     // of another number of rows: it factorises
    CHECK_NEAR(residual(t, w, solver.solve(b), b), 0, 1e-9);
  }
}

// The order of a triangulation that only has as many vertices is of no use, and does no harm.
void order_of_another_surface(std::mt19937& random)
{
  const Intrinsic_triangulation torus_a(torus(3, 1, 300, 100)), torus_b(torus(3, 1, 100, 300));
  Laplacian_solver a, b;
  a.factorize(torus_a, cotangent_weights(torus_a, torus_a.lengths()));
  b.set_order_of(a);
  const Weights w = cotangent_weights(torus_b, torus_b.lengths());
  for (int k = 0; k < 2; ++k) b.factorize(torus_b, w);
  const Eigen::MatrixXd rhs = right_hand_sides(torus_b.number_of_vertices(), random);
  CHECK_NEAR(residual(torus_b, w, b.solve(rhs), rhs), 0, 1e-9);
}

// A triangle by itself: its angles and weights against 100 digits.
void needle(double a, double b, double c)
{
  using Many_digits = boost::multiprecision::cpp_bin_float_100;
  Glued_triangles glued;
  glued.triangles = {{0, 1, 2}};
  glued.opposite = {{std::array<int, 2>{-1, -1}, {-1, -1}, {-1, -1}}};
  glued.lengths = {{a, b, c}};
  const Intrinsic_triangulation t(glued);
  const auto h = t.halfedges(*t.faces().begin());
  const std::vector<double> angles = corner_angles(t, t.lengths()), weights = cotangent_weights(t, t.lengths());
  const std::array<Many_digits, 3> l{t.length(h[0]), t.length(h[1]), t.length(h[2])};
  const Many_digits s = (l[0] + l[1] + l[2]) / 2, area4 = 4 * sqrt(s * (s - l[0]) * (s - l[1]) * (s - l[2]));
  for (int k = 0; k < 3; ++k) {
    const Many_digits &x = l[(k + 1) % 3], &y = l[(k + 2) % 3], scalar2 = x * x + y * y - l[k] * l[k];
    const double angle = static_cast<double>(atan2(area4, scalar2)), weight = static_cast<double>(scalar2 / (2 * area4));
    CHECK_NEAR(angles[h[(k + 2) % 3]], angle, 2e-15 * angle);
    CHECK_NEAR(weights[t.edge(h[k])], weight, 4e-15 * (0.5 + std::abs(weight)));
  }
}

void needles(std::mt19937& random)
{
  for (int k = 0; k < 3000; ++k) {
    const double tiny = std::pow(10, Quartic_test::uniform(random, -9, 0)), b = Quartic_test::uniform(random, 1, 2);
    needle(tiny, b, b + tiny * Quartic_test::uniform(random, -0.99, 0.99));   // with a short side
    const double a = Quartic_test::uniform(random, 0.5, 2);
    needle(a, b, (a + b) * (1 - 0.1 * tiny));                                 // with an angle near pi
  }
}

void no_right_hand_sides(const Intrinsic_triangulation& t)
{
  Laplacian_solver solver;
  solver.factorize(t, cotangent_weights(t, t.lengths()));
  const Eigen::MatrixXd x = solver.solve(Eigen::MatrixXd(t.number_of_vertices(), 0));
  CHECK(x.rows() == static_cast<Eigen::Index>(t.number_of_vertices()) && x.cols() == 0);
}

void not_positive(const Intrinsic_triangulation& t)
{
  Weights w = cotangent_weights(t, t.lengths());
  for (double& x : w) x = -x;
  Laplacian_solver solver;
  CHECK_THROWS(solver.factorize(t, w), Numerical_error, "could not be factorised");
}

// A solver of another surface, or of none.
void not_factorized(const Intrinsic_triangulation& t)
{
  Laplacian_solver solver;
  const Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(t.number_of_vertices()), 1);
  CHECK_THROWS(solver.solve(b), Numerical_error, "no matrix of ");
  solver.factorize(t, cotangent_weights(t, t.lengths()));
  CHECK_EQUAL(solver.solve(b), b);
  CHECK_THROWS(solver.solve(Eigen::MatrixXd::Zero(b.rows() + 1, 1)), Numerical_error, "was factorised");
}

} // namespace

int main()
{
  std::mt19937 random(8);
  for (const auto& [name, surface] : Quartic_test::sample_surfaces()) {
    Intrinsic_triangulation t = surface;
    make_delaunay(t);
    near_and_far(t, random);
    as_precise_as_asked_for(t, random);
    other_patterns(t, random);
    no_right_hand_sides(t);
    not_positive(t);
    not_factorized(t);
  }
  near_and_far(Intrinsic_triangulation(hyperelliptic(2, 0)), random);         // parallel edges
  near_and_far(Intrinsic_triangulation(torus(3, 1, 500, 201)), random);
  nested_dissection(Intrinsic_triangulation(torus(3, 1, 1000, 301)), random);
  order_of_another_surface(random);
  needles(random);
  return Quartic_test::result();
}
