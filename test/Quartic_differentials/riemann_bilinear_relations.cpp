// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps 1 to 3: harmonic forms, zeros, Riemann's bilinear relations, and period matrices against the truth.

#include "check.h"
#include "hyperelliptic_periods.h"
#include "named_surfaces.h"
#include "period_comparison.h"

#include <CGAL/Quartic_differentials/pipeline.h>

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace CGAL::Quartic_differentials;
using Quartic_test::Complex;

namespace {

double least_eigenvalue(const Eigen::MatrixXd& m)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (m + m.transpose())).eigenvalues().minCoeff();
}

Riemann_surface computed(const Intrinsic_triangulation& t)
{
  Visitor visitor;
  return riemann_surface(t, visitor);
}

void test_invariants(const Quartic_test::Named_surface& named)
{
  const int g = named.surface.genus();
  const Riemann_surface s = computed(named.surface);
  std::cout << named.name << ": genus " << g << ", star defect " << s.periods.star_defect << ", divergence "
            << s.forms.residual << std::endl;
  CHECK(s.forms.residual < 1e-11);   // harmonic
  CHECK_EQUAL(intersection_numbers(s.delaunay, s.homology.cochains), symplectic_unit(g));
  if (g == 0) return;

  // the harmonic forms are in the classes of the cochains: omega - eta is exact
  double exact = 0;
  for (Edge e : s.delaunay.edges()) {
    const Halfedge h = s.delaunay.halfedge(e);
    const Eigen::RowVectorXd d = s.forms.row(h) - s.homology.cochains.row(h).cast<double>()
                               - (s.forms.potential.row(s.delaunay.target(h)) - s.forms.potential.row(s.delaunay.source(h)));
    exact = std::max(exact, d.cwiseAbs().maxCoeff());
  }
  CHECK(exact < 1e-12);

  const Eigen::MatrixXcd& pi = s.periods.pi;
  CHECK((pi - pi.transpose()).cwiseAbs().maxCoeff() < 1e-12 * std::max(1.0, pi.cwiseAbs().maxCoeff()));
  CHECK(least_eigenvalue(pi.imag()) > 0);
  const Eigen::MatrixXd& c = s.periods.star;
  CHECK((c * c + Eigen::MatrixXd::Identity(2 * g, 2 * g)).cwiseAbs().maxCoeff() < 1e-10);
  CHECK(least_eigenvalue(s.periods.upper - s.periods.lower) > -1e-12);   // the bracket
  // the projected products lie between them too
  const Eigen::MatrixXd projected = Quartic_test::gram_of_periods(pi);
  CHECK(least_eigenvalue(s.periods.upper - projected) > -1e-10);
  CHECK(least_eigenvalue(projected - s.periods.lower) > -1e-10);

  // normalised holomorphic forms, integrated along the loops: over a_i delta_ij, over b_i Pi_ij
  Eigen::MatrixXcd periods = Eigen::MatrixXcd::Zero(2 * g, g);
  for (Face f : s.delaunay.faces()) {   // integral of phi_j along gamma_l = - Sum of the wedge products with eta_l
    const auto h = s.delaunay.halfedges(f);
    if (s.homology.cochains.row(h[0]).isZero() && s.homology.cochains.row(h[1]).isZero()) continue;
    const Eigen::RowVectorXcd x = normalised_forms(s.forms, s.periods, h[0]), y = normalised_forms(s.forms, s.periods, h[1]);
    const Eigen::VectorXcd p = s.homology.cochains.row(h[0]).transpose().cast<Complex>();
    const Eigen::VectorXcd q = s.homology.cochains.row(h[1]).transpose().cast<Complex>();
    periods += 0.5 * (q * x - p * y);
  }
  CHECK((periods.topRows(g) - Eigen::MatrixXcd::Identity(g, g)).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((periods.bottomRows(g) - pi).cwiseAbs().maxCoeff() < 1e-9 * std::max(1.0, pi.cwiseAbs().maxCoeff()));

  // zeros: total order 2g-2 for any form
  std::mt19937 random(3);
  for (int trial = 0; trial < 3; ++trial) {
    Eigen::VectorXd coefficients(2 * g);
    for (Eigen::Index k = 0; k < 2 * g; ++k) coefficients[k] = trial == 0 ? 1 : Quartic_test::uniform(random, -1, 1);
    int order = 0;
    for (const Holomorphic_zero& z : zeros_of_holomorphic_form(s.delaunay, s.forms, coefficients, s.periods.star))
      order += z.order;
    CHECK_EQUAL(order, 2 * g - 2);
  }
}

// errors at successive refinements, and their mean order
void check_order(const std::string& name, const std::vector<double>& errors, double least_order, double last_at_most)
{
  std::cout << name << ": errors";
  for (double e : errors) std::cout << ' ' << e;
  const double order = std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
  std::cout << ", order " << order << std::endl;
  CHECK(order > least_order);
  CHECK(errors.back() < last_at_most);
}

void test_torus_of_revolution()
{
  const double r = 0.4;
  const Eigen::MatrixXcd truth = Eigen::MatrixXcd::Constant(1, 1, Complex(0, r / std::sqrt(1 - r * r)));
  std::vector<double> errors;
  for (int k : {1, 2, 4, 8})
    errors.push_back(Quartic_test::distance_modulo_symplectic(
      computed(Intrinsic_triangulation(torus(1, r, 16 * k, 10 * k))).periods.pi, truth, 0.3));
  check_order("torus of revolution", errors, 1.8, 2e-3);
}

// The Dirichlet products converge with error O(h^(1+1/g)) (METHOD, "Ground truth"), from above, and their bracket holds
// the truth. The period matrix is exact at once: the triangulation has the curve's automorphisms, which determine it.
void test_hyperelliptic(int g, int levels, double last_at_most)
{
  const Eigen::MatrixXcd truth = Quartic_test::hyperelliptic_periods(g);
  CHECK((truth - truth.transpose()).cwiseAbs().maxCoeff() < 1e-12);
  CHECK(least_eigenvalue(truth.imag()) > 0);
  std::vector<double> errors;
  for (int level = 2; level < 2 + levels; ++level) {
    const Riemann_surface s = computed(Intrinsic_triangulation(hyperelliptic(g, level)));
    CHECK(Quartic_test::distance_modulo_symplectic(s.periods.pi, truth, 0.4) < 1e-12);
    errors.push_back(Quartic_test::Symplectic_match(s.periods.upper, truth, 0.4).of_gram_matrices());
    CHECK(errors.back() <= (s.periods.upper - s.periods.lower).cwiseAbs().maxCoeff());
  }
  check_order("y^2 = x^" + std::to_string(2 * g + 2) + " - 1", errors, 0.95 * (1 + 1.0 / g), last_at_most);
}

// Without the symmetry: random points inserted, so that the period matrix itself has to converge.
void test_hyperelliptic_without_symmetry()
{
  const Eigen::MatrixXcd truth = Quartic_test::hyperelliptic_periods(2);
  std::mt19937 random(5);
  std::vector<double> errors;
  for (int level = 2; level < 6; ++level) {
    Intrinsic_triangulation t(hyperelliptic(2, level));
    const std::size_t faces = t.number_of_faces();
    for (std::size_t n = 0; n < faces / 2; ++n) {
      const double x = Quartic_test::uniform(random, 0.2, 0.4), y = Quartic_test::uniform(random, 0.2, 0.4);
      t.insert({Face(static_cast<Mesh::size_type>(random() % faces)), {1 - x - y, x, y}});
    }
    errors.push_back(Quartic_test::distance_modulo_symplectic(computed(t).periods.pi, truth, 0.4));
  }
  check_order("y^2 = x^6 - 1 without symmetry", errors, 1.0, 1e-3);
}

void test_closed_form_of_genus_2()
{
  // y^2 = x^6 - 1 is Lawson's surface of genus 2
  Eigen::MatrixXcd lawson(2, 2);
  lawson << 2, -1, -1, 2;
  lawson *= Complex(0, 1 / std::sqrt(3.0));
  CHECK(Quartic_test::distance_modulo_symplectic(Quartic_test::hyperelliptic_periods(2), lawson, 1e-6) < 1e-12);
  for (const auto& [name, surface] : Quartic_test::real_surfaces({"lawson_5k"})) {
    const double error = Quartic_test::distance_modulo_symplectic(computed(surface).periods.pi, lawson, 0.1);
    std::cout << name << ": error " << error << std::endl;
    CHECK(error < 1e-3);
  }
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test_invariants(s);
  for (const auto& s : Quartic_test::real_surfaces({"rockerarm_20k", "3holes_7k2", "neptune_30k", "casting_10k"}))
    test_invariants(s);
  test_torus_of_revolution();
  test_closed_form_of_genus_2();
  test_hyperelliptic(2, 4, 1e-3);
  test_hyperelliptic(3, 4, 5e-3);
  test_hyperelliptic_without_symmetry();
  return Quartic_test::result();
}
