// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Abel's theorem: a divisor of degree 0 is that of a meromorphic function if and only if its Abel-Jacobi image is 0.
// Functions are known on the curve y^2 = x^n - 1, n = 2g + 2. Where a symmetry of the triangulation decides, the image
// is 0 up to rounding; for other functions it tends to 0 under subdivision, and for other divisors it does not.

#include "check.h"

#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <iostream>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

using Complex = std::complex<double>;

const double pi = std::acos(-1.0);

// The distance of the Abel-Jacobi image of a divisor of degree 0 from the lattice, in lattice units. F is affine in the
// divisor, so F(D + E) - F(D) = F(E) - F(0) for every D.
double distance_from_principal(const Abel_jacobi_map& map, const Divisor& e)
{
  CHECK_EQUAL(degree(e), 0);
  const Eigen::VectorXd image = (map.residual(e) - map.constant()) / (pi / 2);
  return (image - image.array().round().matrix()).cwiseAbs().maxCoeff();
}

// The two-sheeted cover of the x-plane, as hyperelliptic() glues it: |x| <= 1 are the front polygons, |x| >= 1 the
// backs, the corner k lies over x = e^(2 pi i k/n).
//   front of sheet s    y = (-1)^s i sqrt(1 - x^n)
//   back of sheet s     y = (-1)^s x^(n/2) sqrt(1 - x^-n)
// The principal roots agree across even sides and are opposite across odd ones.
class Hyperelliptic_curve
{
public:
  Hyperelliptic_curve(int g, int subdivisions)
    : m_g(g), m_n(2 * g + 2), m_subdivisions(subdivisions), m_input(hyperelliptic(g, subdivisions)),
      m_surface(riemann_surface(m_input, m_visitor)),
      m_map(m_surface.delaunay, m_surface.homology.cochains, m_surface.forms)
  {}

  int genus() const { return m_g; }
  double distance_from_principal(const Divisor& e) const { return ::distance_from_principal(m_map, e); }

  Surface_point branch_point(int k) const { return at_vertex(m_surface.delaunay, Vertex(k)); }
  /// x = 0
  Surface_point origin(int sheet) const { return at_vertex(m_surface.delaunay, Vertex(m_n + 2 * sheet)); }
  /// x = infinity
  Surface_point infinity(int sheet) const { return at_vertex(m_surface.delaunay, Vertex(m_n + 2 * sheet + 1)); }
  /// any other point of the curve
  Surface_point point(Complex x, Complex y) const
  {
    const bool front = std::abs(x) < 1;
    const Complex w = front ? x : 1.0 / x;
    const Complex root = (front ? Complex(0, 1) : std::pow(x, m_g + 1)) * std::sqrt(1.0 - std::pow(w, m_n));
    const int sheet = (y / root).real() > 0 ? 0 : 1;
    return m_surface.refinement->from_input(in_polygon(2 * sheet + (front ? 0 : 1), in_regular_polygon(w)));
  }

private:
  // The conformal map of the unit disk to the regular n-gon with sides of length 1 (Schwarz and Christoffel): the
  // integral of (1 - w^n)^(-2/n).
  Complex in_regular_polygon(Complex w) const
  {
    const double a = 2.0 / m_n, radius = 1 / (2 * std::sin(pi / m_n));
    const double at_1 = std::tgamma(a / 2) * std::tgamma(1 - a) / (m_n * std::tgamma(1 - a / 2));
    const Complex step = std::pow(w, m_n);
    Complex sum = 0, term = w;
    for (int k = 0; std::abs(term) > 1e-17; ++k) {
      sum += term / (m_n * k + 1.0);
      term *= step * ((a + k) / (k + 1));
    }
    return sum * radius / at_1;
  }

  // The point z of a polygon with its centre at 0; the corner k is at the angle 2 pi k/n of a front,
  // -2 pi k/n of a back.
  Surface_point in_polygon(int polygon, Complex z) const
  {
    const bool front = polygon % 2 == 0;
    const double turns = (front ? 1 : -1) * std::arg(z) / (2 * pi);
    const int k = static_cast<int>(std::floor((turns - std::floor(turns)) * m_n)) % m_n, from = front ? k : k + 1;
    const double radius = 1 / (2 * std::sin(pi / m_n)), angle = 2 * pi / m_n * (front ? from : -from);
    const auto b = internal::barycentric({0, std::polar(radius, angle), std::polar(radius, angle + 2 * pi / m_n)}, z);
    return in_subdivision(m_n * polygon + k, b);
  }

  // Follows a point into the triangles that subdivided() makes.
  Surface_point in_subdivision(int triangle, std::array<double, 3> b) const
  {
    for (int i = 0; i < m_subdivisions; ++i) {
      const int c = static_cast<int>(std::max_element(b.begin(), b.end()) - b.begin());
      const bool middle = b[c] < 0.5;
      triangle = 4 * triangle + (middle ? 3 : c);
      if (middle) b = {1 - 2 * b[2], 1 - 2 * b[0], 1 - 2 * b[1]};
      else        b = {2 * b[c] - 1, 2 * b[(c + 1) % 3], 2 * b[(c + 2) % 3]};
    }
    return {Face(static_cast<Mesh::size_type>(triangle)), b};
  }

  int                     m_g, m_n, m_subdivisions;
  Visitor                 m_visitor;
  Intrinsic_triangulation m_input;
  Riemann_surface         m_surface;
  Abel_jacobi_map         m_map;
};

// Functions whose divisors the deck transformation and the rotation x -> e^(2 pi i/n) x fix.
void test_symmetric_functions(int g)
{
  const Hyperelliptic_curve c(g, 2);
  const double exact = 1e-7;   // points on vertices are moved by 1e-9
  const auto o = [&](int sheet, int order) { return Singularity{c.origin(sheet), order}; };
  const auto p = [&](int sheet, int order) { return Singularity{c.infinity(sheet), order}; };
  CHECK(c.distance_from_principal({o(0, 1), o(1, 1), p(0, -1), p(1, -1)}) < exact);          // x
  CHECK(c.distance_from_principal({o(0, 2 * g + 2), p(0, -g - 1), p(1, -g - 1)}) < exact);   // y - i
  for (int k = 1; k < 2 * g + 2; ++k) {   // (x - x_0) / (x - x_k)
    CHECK(c.distance_from_principal({{c.branch_point(0), 2}, {c.branch_point(k), -2}}) < exact);
    CHECK(c.distance_from_principal({{c.branch_point(0), 1}, {c.branch_point(k), -1}}) > 0.1);
  }
  Divisor branch_points{p(0, -g - 1), p(1, -g - 1)};   // y
  for (int k = 0; k < 2 * g + 2; ++k) branch_points.push_back({c.branch_point(k), 1});
  CHECK(c.distance_from_principal(branch_points) < exact);
  CHECK(c.distance_from_principal({o(0, 1), p(0, -1)}) > 0.1);
  // y - x^(g+1): the difference of the two infinities is a torsion point of order g + 1, not less
  CHECK(c.distance_from_principal({p(0, g + 1), p(1, -g - 1)}) < exact);
  for (int k = 1; k <= g; ++k) CHECK(c.distance_from_principal({p(0, k), p(1, -k)}) > 0.1);
}

// The zeros of y - a - b x: the roots of x^n - 1 - (a + b x)^2.
std::vector<std::pair<Complex, Complex>> zeros_of_function(int g, Complex a, Complex b)
{
  const int n = 2 * g + 2;
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(n, n);
  companion.bottomLeftCorner(n - 1, n - 1).setIdentity();
  companion.topRightCorner(3, 1) << 1.0 + a * a, 2.0 * a * b, b * b;
  const Eigen::VectorXcd roots = companion.eigenvalues();
  std::vector<std::pair<Complex, Complex>> zeros;
  for (Complex x : roots) zeros.push_back({x, a + b * x});
  return zeros;
}

// The divisor of y - a - b x, with the first so many zeros moved to the other sheet.
Divisor divisor_of_function(const Hyperelliptic_curve& c, Complex a, Complex b, int moved)
{
  const int poles = c.genus() + 1;
  Divisor d{{c.infinity(0), -poles}, {c.infinity(1), -poles}};
  for (const auto& [x, y] : zeros_of_function(c.genus(), a, b)) d.push_back({c.point(x, moved-- > 0 ? -y : y), 1});
  return d;
}

// Values of a and b for which the zeros stay away from the cone points, where piecewise linear forms are less accurate.
const std::vector<std::pair<Complex, Complex>> functions{{{0.3, 1.9}, {0.5, -0.4}}, {{1.5, -0.4}, {0.3, 0.6}},
                                                         {{-1.6, 0.9}, {0.6, 0.3}}};

// The largest distance of the divisors of functions, the least of the others.
struct Distances { double principal = 0, other = 1; };

Distances distances(const Hyperelliptic_curve& c)
{
  Distances d;
  for (const auto& [a, b] : functions) {
    d.principal = std::max(d.principal, c.distance_from_principal(divisor_of_function(c, a, b, 0)));
    for (int moved : {1, 2})
      d.other = std::min(d.other, c.distance_from_principal(divisor_of_function(c, a, b, moved)));
  }
  return d;
}

// In genus 1 the polygons are squares on a flat torus, and piecewise linear forms are exact.
void test_genus_1()
{
  const Distances d = distances(Hyperelliptic_curve(1, 2));
  std::cout << "genus 1: distance " << d.principal << ", of other divisors " << d.other << std::endl;
  CHECK(d.principal < 1e-7);
  CHECK(d.other > 0.05);
}

// The rate of a step depends on where the zeros are in their faces; the mean is at least that of the periods, 1 + 1/g.
void test_convergence(int g)
{
  const int first = 2, last = 6;
  std::vector<double> distance;
  for (int s = first; s <= last; ++s) {
    const Distances d = distances(Hyperelliptic_curve(g, s));
    std::cout << "genus " << g << ", " << s << " times subdivided: distance " << d.principal;
    if (s > first) std::cout << ", order " << std::log2(distance.back() / d.principal);
    std::cout << ", of other divisors " << d.other << std::endl;
    if (s > first) CHECK(std::log2(distance.back() / d.principal) > 1);
    CHECK(d.other > 0.1);
    distance.push_back(d.principal);
  }
  const double order = std::log2(distance.front() / distance.back()) / (last - first);
  std::cout << "genus " << g << ": order " << order << " in the mean" << std::endl;
  CHECK(order > 1 + 1.0 / g);
}

// On the torus of revolution with R = 2, r = 1 the conformal coordinate across the parallels is the integral of
// dv / (2 + cos v), v the angle round the circle: a sixth of its period for v = pi/2, a half for v = pi. So the sum of
// three points at v = pi/2 is that of one at v = pi and two at v = 0. Their `turns` are in sixteenths.
double torus_distance(int n, const std::array<int, 6>& turns)
{
  const int m = n / 2;
  const Intrinsic_triangulation t(torus(2, 1, n, m));
  Visitor visitor;
  const Riemann_surface s = riemann_surface(t, visitor);
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  const std::array<int, 6> quarter{1, 1, 1, 2, 0, 0};
  Divisor d;
  for (int i = 0; i < 6; ++i)
    d.push_back({at_vertex(s.delaunay, Vertex(turns[i] * n / 16 * m + quarter[i] * m / 4)), i < 3 ? 1 : -1});
  return distance_from_principal(map, d);
}

void test_torus()
{
  double before = 0;
  for (int n = 16; n <= 128; n *= 2) {
    const double d = torus_distance(n, {1, 4, 9, 3, 11, 0}), other = torus_distance(n, {1, 4, 9, 3, 10, 0});
    std::cout << "torus of " << n << " by " << n / 2 << ": distance " << d;
    if (before > 0) std::cout << ", order " << std::log2(before / d);
    std::cout << ", of another divisor " << other << std::endl;
    if (before > 0) CHECK(std::log2(before / d) > 1.8);
    CHECK(other > 0.05);
    before = d;
  }
}

} // namespace

int main()
{
  for (int g = 1; g <= 4; ++g) test_symmetric_functions(g);
  test_genus_1();
  for (int g = 2; g <= 4; ++g) test_convergence(g);
  test_torus();
  return Quartic_test::result();
}
