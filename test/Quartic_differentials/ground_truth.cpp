// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces whose periods are known: the quadrature against closed forms, the surfaces against their description, and
// computed energies and periods against the truth, with their orders of convergence and their bracket.

#include "check.h"
#include "ground_truth.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

const double pi = std::acos(-1.0);
const Complex i(0, 1);
const double rounding = 1e-12;

double difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) { return (a - b).cwiseAbs().maxCoeff(); }

Eigen::MatrixXcd matrix(Complex a, Complex b, Complex c)
{
  Eigen::MatrixXcd m(2, 2);
  m << a, b, b, c;
  return m;
}

const Eigen::MatrixXcd& bolza()
{
  static const Eigen::MatrixXcd truth =
    matrix(-2.0 + std::sqrt(8.0) * i, 1.0 - std::sqrt(2.0) * i, -2.0 + std::sqrt(8.0) * i) / 3;
  return truth;
}

Eigen::MatrixXcd quadrature(const std::vector<Complex>& points) { return periods_of_chain(chain_periods(points)); }

// Riemann's bilinear relations, for any cycles: P^T K^-1 P = 0, and the hermitian form has K as its imaginary part
void check_bilinear_relations(const Eigen::MatrixXcd& p, const Eigen::MatrixXi& k)
{
  const Eigen::MatrixXcd inverse = k.cast<double>().inverse().cast<Complex>();
  CHECK((p.transpose() * inverse * p).cwiseAbs().maxCoeff() < rounding * p.squaredNorm());
  const Eigen::MatrixXcd form = hermitian_form(p, k);
  CHECK((form.imag() - k.cast<double>()).cwiseAbs().maxCoeff() < rounding);
  CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(form.real()).eigenvalues().minCoeff() > 0);
}

void test_quadrature()
{
  // values to 12 digits, METHOD, "Ground truth"
  CHECK(difference(quadrature(real_branch_points()), matrix(1.632000497637 * i, 0.673157079169 * i, 1.066579416047 * i))
        < 1e-12);
  CHECK(difference(quadrature(complex_branch_points()),
                   matrix({0.285734212028, 0.823726384986}, {-0.176288767298, 0.351083243925},
                          {-0.042738398729, 1.097415478736})) < 1e-12);
  for (int g = 1; g <= 10; ++g) {
    std::vector<Complex> roots;
    for (int k = 0; k < 2 * g + 2; ++k) roots.push_back(std::polar(1.0, 2 * pi * k / (2 * g + 2)));
    CHECK(difference(quadrature(roots), hyperelliptic_periods(g)) < rounding);
    check_bilinear_relations(chain_periods(roots), chain_intersections(2 * g));
    check_bilinear_relations(roots_of_unity_chain(g), chain_intersections(2 * g));
  }
  check_bilinear_relations(chain_periods(eight_branch_points()), chain_intersections(6));

  // similarities of the plane take the chain to the chain
  std::vector<Complex> moved;
  for (const Complex& e : eight_branch_points()) moved.push_back(Complex(0.3, -1.7) * e + Complex(4, 5));
  CHECK(difference(quadrature(moved), quadrature(eight_branch_points())) < rounding);
}

// Periods over cycles that need not be canonical, against a period matrix
void check_known_periods(const Known_gluing& known, const Eigen::MatrixXcd& truth)
{
  check_bilinear_relations(known.periods, known.intersections);
  const Ground_truth_result r = compare_with_truth(known_surface(known, 1));
  const Eigen::MatrixXd to_canonical = r.cycles.cast<double>().inverse();
  const Eigen::MatrixXd canonical = to_canonical * r.truth * to_canonical.transpose();
  CHECK(distance_modulo_symplectic(periods_of_gram(canonical), truth, 1e-6) < rounding);
}

// Curves that are known in two ways, up to the choice of the basis
void test_named_curves()
{
  const Eigen::MatrixXcd at_infinity = quadrature(bolza_branch_points());
  CHECK(distance_modulo_symplectic(at_infinity, bolza(), 1e-6) < rounding);
  std::vector<Complex> finite;   // infinity goes to 0; the chain becomes 1/(e - c), which is simple too
  for (const Complex& e : bolza_branch_points())
    finite.push_back(std::isinf(e.real()) ? Complex(0) : 1.0 / (e - Complex(0.3, 0.2)));
  CHECK(distance_modulo_symplectic(quadrature(finite), bolza(), 1e-6) < rounding);

  check_known_periods(known_regular_polygon(2), bolza());
  check_known_periods(known_l_of_three_squares(), matrix(5.0, -4.0, 5.0) * i / 3);
  CHECK(distance_modulo_symplectic(hyperelliptic_periods(2), matrix(2.0, -1.0, 2.0) * i / std::sqrt(3.0), 1e-6)
        < rounding);   // Lawson's surface of genus 2
}

void check_on_sphere()
{
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(on_sphere(0) == Point_3(0, 0, 1));
  CHECK(on_sphere(1) == Point_3(1, 0, 0));
  CHECK(on_sphere(i) == Point_3(0, 1, 0));
  CHECK(on_sphere(infinity) == Point_3(0, 0, -1));
  CHECK(on_sphere(Complex(1, -infinity)) == Point_3(0, 0, -1));
  for (double size : {1e-300, 1e-8, 0.7, 1e8, 1e300}) {
    const Point_3 p = on_sphere(Complex(3, -4) * size);
    CHECK_NEAR((p - CGAL::ORIGIN).squared_length(), 1, 1e-15);
    CHECK(std::abs(p.x() * 4 + p.y() * 3) <= 1e-15);
  }
}

// Two sheets that the deck transformation exchanges, with the branch vertices as its only fixed points
void check_cover(const std::vector<Complex>& points, int level)
{
  const Mesh sphere = triangulated_sphere(points, level);
  const Intrinsic_triangulation base(sphere);
  CHECK_EQUAL(base.genus(), 0);
  const Glued_triangles cover = branched_cover(points, level);
  const Intrinsic_triangulation t(cover);   // throws unless glued consistently
  const std::size_t n = points.size(), faces = sphere.number_of_faces();
  CHECK_EQUAL(structural_defect(t), "");
  CHECK_EQUAL(t.genus(), static_cast<int>(n) / 2 - 1);
  CHECK_EQUAL(t.number_of_faces(), 2 * faces);
  CHECK_EQUAL(t.number_of_vertices(), 2 * sphere.number_of_vertices() - n);
  CHECK_NEAR(t.area(), 2 * base.area(), 1e-10);
  for (std::size_t k = 0; k < n; ++k)
    CHECK(sphere.point(Vertex(static_cast<Mesh::size_type>(k))) == on_sphere(points[k]));

  const int f = static_cast<int>(faces);
  const auto exchanged = [f](int triangle) { return (triangle + f) % (2 * f); };
  bool symmetric = true, fixed = true;
  for (int k = 0; k < f; ++k)
    for (int e = 0; e < 3; ++e) {
      const auto [u, d] = cover.opposite[k][e];
      symmetric = symmetric && cover.opposite[k + f][e] == Side{exchanged(u), d}
               && cover.lengths[k][e] == cover.lengths[k + f][e];
      fixed = fixed && (cover.triangles[k][e] == cover.triangles[k + f][e])
                         == (static_cast<std::size_t>(cover.triangles[k][e]) < n);
    }
  CHECK(symmetric);
  CHECK(fixed);

  const std::vector<double> below = curvatures(base, corner_angles(base, base.lengths())),
                            above = curvatures(t, corner_angles(t, t.lengths()));
  for (std::size_t v = 0; v < base.number_of_vertices(); ++v)   // the angle doubles at branch vertices
    CHECK_NEAR(above[v], v < n ? 2 * below[v] - 2 * pi : below[v], 1e-10);
}

void test_covers()
{
  check_on_sphere();
  const std::vector<Complex> two{0, std::numeric_limits<double>::infinity()}, near_each_other{0, 0.002, 1, 2};
  for (const auto& points : {two, near_each_other, real_branch_points(), bolza_branch_points(), eight_branch_points()})
    for (int level : {0, 2}) check_cover(points, level);
  CHECK(triangulated_sphere({}, 0).number_of_vertices() > 80);
  for (int level = 0; level < 3; ++level) {   // sizes are halved
    const double ratio = static_cast<double>(triangulated_sphere(eight_branch_points(), level + 1).number_of_vertices())
                       / triangulated_sphere(eight_branch_points(), level).number_of_vertices();
    CHECK(ratio > 2.5 && ratio < 4.5);
  }
  CHECK_THROWS(branched_cover({0, 1, 2}, 0), Error, "even number");
  CHECK_THROWS(branched_cover(std::vector<Complex>{}, 0), Error, "even number");
  CHECK_THROWS(branched_cover({0, 1, 0, 2}, 0), Error, "the points 0 and 2 are the same");
  CHECK_THROWS(branched_cover({0, std::nan("")}, 0), Error, "not a number");
  const Mesh sphere = triangulated_sphere({0, 1}, 0);
  CHECK_THROWS(branched_cover(sphere, {Vertex(3), Vertex(3)}), Error, "same");
  const std::vector<Vertex> four{Vertex(3), Vertex(9), Vertex(20), Vertex(31)};
  CHECK_EQUAL(Intrinsic_triangulation(branched_cover(sphere, four)).genus(), 1);
}

// lower <= S <= upper, to rounding
void check_between(const Eigen::MatrixXd& lower, const Eigen::MatrixXd& s, const Eigen::MatrixXd& upper)
{
  CHECK(Relative_spectrum(lower, s).greatest < 1 + rounding);
  CHECK(Relative_spectrum(upper, s).least > 1 - rounding);
}

void check_result(const Family& family, const Ground_truth_result& r, const Eigen::MatrixXi& intersections)
{
  CHECK(r.cycles_are_exact);
  if (intersections == chain_intersections(2 * r.genus)) {   // the canonical basis of the chain, in the computed one
    const Eigen::MatrixXi m = canonical_from_chain(r.genus) * r.cycles;
    CHECK_EQUAL(m * symplectic_unit(r.genus) * m.transpose(), symplectic_unit(r.genus));
  }
  check_between(r.lower, r.projected, r.upper);
  if (family.flat) check_between(r.lower, r.truth, r.upper);   // the surface is the polyhedral one
  if (family.symmetric) CHECK(r.period_error() < rounding);
}

// All levels but the finest. The last order observed is the expected one; it is approached from above on flat surfaces.
void test_family(const Family& family)
{
  std::vector<Ground_truth_result> results;
  for (int level = family.first_level; level < family.last_level; ++level) {
    const Known_surface known = family.at_level(level);
    results.push_back(compare_with_truth(known));
    check_result(family, results.back(), known.intersections);
  }
  const Ground_truth_result &coarse = results[results.size() - 2], &fine = results.back();
  std::cout << family.name << ": " << fine.faces << " faces, error of S " << fine.error() << ", of Pi "
            << fine.period_error() << std::endl;
  if (fine.genus == 1 && family.flat) {   // a flat torus: harmonic forms are linear
    CHECK(coarse.error() < rounding);
    CHECK(fine.error() < rounding);
    return;
  }
  const double order = observed_order(coarse.error(), fine.error(), coarse.faces, fine.faces);
  CHECK(order > family.expected_order - (family.flat ? 0.06 : 0.4));
  CHECK(order < family.expected_order + 0.25);
  CHECK(fine.period_error() < 2e-3);
  if (!family.symmetric)
    CHECK(observed_order(coarse.period_error(), fine.period_error(), coarse.faces, fine.faces)
          > family.expected_order - 0.2);
}

// Under subdivision a polyhedral surface stays the same, and so does the S that its brackets contain: they are nested.
void test_nested_brackets()
{
  for (const auto& points : {real_branch_points(), eight_branch_points()}) {
    const Known_gluing known = known_cover(points, 0);
    Ground_truth_result coarse = compare_with_truth(known_surface(known, 0));
    for (int subdivisions = 1; subdivisions < 4; ++subdivisions) {
      const Ground_truth_result fine = compare_with_truth(known_surface(known, subdivisions));
      check_between(coarse.lower, fine.upper, coarse.upper);
      check_between(coarse.lower, fine.lower, fine.upper);
      CHECK(fine.bracket_width() < 0.6 * coarse.bracket_width());   // cone angles of 4 pi: of order 1
      coarse = fine;
    }
  }
}

} // namespace

int main()
{
  test_quadrature();
  test_named_curves();
  test_covers();
  for (const Family& family : ground_truth_families()) test_family(family);
  test_nested_brackets();
  return Quartic_test::result();
}
