// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Step 4: the two routes to the Abel-Jacobi map, by curvature and by the zeros of a holomorphic form, agree in the
// integers.
//
// F by zeros and F by curvature differ by a vector that does not depend on the divisor. In units of pi/2 it is
// 4 q + epsilon: q integers, because both are meant modulo 2 pi, and epsilon the discretisation. Lengths are those of
// the Jacobian, which do not depend on the homology basis: |x|^2 = x^T S^-1 x, S the Dirichlet products of the forms.
// The routes agree in the integers if 4 q is the lattice vector nearest to the difference. Then
// - a divisor that is legal for one route misses the other by epsilon, and its integers s and t are the same;
// - for any other divisor each route finds the other's nearest lattice vector no farther than 2 |epsilon| beyond its
//   own, and the same one where the runner-up is farther than that.
// Where epsilon is shorter than the packing radius, half the shortest lattice vector, 4 q is the only one so near.

#include "check.h"
#include "named_surfaces.h"
#include "period_comparison.h"

#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

const double quarter_turn = std::acos(-1.0) / 2;
const double rounding = 1e-9;   // of lattice lengths

// The lattice Z^2g of the Jacobian with its norm.
class Jacobian_lattice
{
public:
  explicit Jacobian_lattice(const Eigen::MatrixXcd& pi)
    : m_gram(Quartic_test::gram_of_periods(pi).inverse())
  {
    Closest_vector_options options;
    options.count = 2;   // 0 is the nearest
    const Closest_vectors found = closest_vectors(m_gram, Eigen::VectorXd::Zero(m_gram.rows()), options);
    m_shortest = std::sqrt(found.vectors[1].squared_distance);
  }

  double packing_radius() const { return m_shortest / 2; }
  double length(const Eigen::VectorXd& x) const { return std::sqrt(x.dot(m_gram * x)); }

  struct Nearest
  {
    Eigen::VectorXd vector;
    double          distance, gap;   // gap: how much farther the runner-up is
  };
  Nearest nearest(const Eigen::VectorXd& x) const
  {
    const Closest_vectors found = closest_vectors(m_gram, x);
    CHECK(found.optimal);
    const std::vector<std::int64_t>& m = found.vectors.front().coefficients;
    Eigen::VectorXd vector(x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) vector[k] = static_cast<double>(m[k]);
    return {vector, std::sqrt(found.vectors.front().squared_distance), found.gap.value_or(0)};
  }

private:
  Eigen::MatrixXd m_gram;
  double          m_shortest;
};

// The divisor of a holomorphic form, and the same with every zero at its vertex.
std::vector<Holomorphic_zero> at_vertices(const Intrinsic_triangulation& t, std::vector<Holomorphic_zero> zeros)
{
  for (Holomorphic_zero& z : zeros) {
    if (z.vertex != Mesh::null_vertex()) z.location = at_vertex(t, z.vertex);
  }
  return zeros;
}

// A surface with its map by curvature, to which maps by zeros are compared.
struct Jacobian
{
  explicit Jacobian(const Intrinsic_triangulation& t)
    : surface(riemann_surface(t, visitor)), lattice(surface.periods.pi),
      by_curvature(surface.delaunay, surface.homology.cochains, surface.forms)
  {}

  std::vector<Holomorphic_zero> zeros(const Eigen::VectorXd& coefficients) const
  {
    return zeros_of_holomorphic_form(surface.delaunay, surface.forms, coefficients, surface.periods.star);
  }

  Visitor          visitor;
  Riemann_surface  surface;
  Jacobian_lattice lattice;
  Abel_jacobi_map  by_curvature;
};

// The route through one set of zeros.
struct Route_by_zeros
{
  Route_by_zeros(const Jacobian& j, const std::vector<Holomorphic_zero>& z)
    : zeros(z), map(j.surface.delaunay, j.surface.forms, zeros),
      difference((map.constant() - j.by_curvature.constant()) / quarter_turn), nearest(j.lattice.nearest(difference))
  {}

  Eigen::VectorXd error() const { return difference - nearest.vector; }   // epsilon

  std::vector<Holomorphic_zero> zeros;
  Abel_jacobi_map               map;
  Eigen::VectorXd               difference;   // of the two maps, in units of pi/2
  Jacobian_lattice::Nearest     nearest;      // 4 q
};

// |epsilon| in packing radii, and the largest holonomy of a basis loop it stands for
struct Disagreement
{
  double packing_radii = 0, degrees = 0;
};

bool is_multiple_of_4(const Eigen::VectorXd& m) { return (m / 4).array().round().matrix() * 4 == m; }

Disagreement disagreement(const Jacobian& j, const Route_by_zeros& route)
{
  return {j.lattice.length(route.error()) / j.lattice.packing_radius(), 90 * route.error().cwiseAbs().maxCoeff()};
}

// The integers s and t of the paper, with the nearest lattice vectors of the two routes.
void check_same_integers(const Jacobian& j, const Route_by_zeros& route, const Divisor& d,
                         const Eigen::VectorXd& m_curvature, const Eigen::VectorXd& m_zeros)
{
  CHECK(m_zeros == m_curvature + route.nearest.vector);
  const auto image = [&](const Abel_jacobi_map& map, const Eigen::VectorXd& m) {
    return abel_jacobi_image(map, j.surface.periods, route.zeros, map.residual(d), m);
  };
  const Abel_jacobi_image a = image(j.by_curvature, m_curvature), b = image(route.map, m_zeros);
  CHECK(a.s == b.s);
  CHECK(a.t == b.t);
}

// What holds for any divisor; returns whether the nearest lattice vectors had to be the same.
bool check_divisor(const Jacobian& j, const Route_by_zeros& route, const Divisor& d)
{
  const Eigen::VectorXd x = j.by_curvature.residual(d) / quarter_turn, y = route.map.residual(d) / quarter_turn;
  CHECK(j.lattice.length(y - x - route.difference) < rounding);
  const Jacobian_lattice::Nearest by_curvature = j.lattice.nearest(x), by_zeros = j.lattice.nearest(y);
  const double error = j.lattice.length(route.error()) + rounding;
  CHECK(std::abs(by_curvature.distance - by_zeros.distance) <= error);
  CHECK(j.lattice.length(x - (by_zeros.vector - route.nearest.vector)) <= by_curvature.distance + 2 * error);
  CHECK(j.lattice.length(y - (by_curvature.vector + route.nearest.vector)) <= by_zeros.distance + 2 * error);
  if (by_curvature.gap <= 2 * error) return false;
  check_same_integers(j, route, d, by_curvature.vector, by_zeros.vector);
  return true;
}

// A divisor of degree 8g - 8 at random places.
Divisor random_divisor(const Intrinsic_triangulation& t, std::mt19937& random)
{
  Divisor d;
  const auto add = [&](int order) {
    const double x = Quartic_test::uniform(random, 0.1, 0.4), y = Quartic_test::uniform(random, 0.1, 0.4);
    const Face f(static_cast<Mesh::size_type>(random() % t.number_of_faces()));
    d.push_back({{f, {1 - x - y, x, y}}, order, false});
  };
  for (int order : {-3, -2, -1, -1, 1, 2}) add(order);
  while (degree(d) < 8 * t.genus() - 8) add(1 + static_cast<int>(random() % 2 == 0 && degree(d) < 8 * t.genus() - 9));
  return d;
}

// A divisor that is legal for one route, if one is found near a random divisor.
std::optional<Divisor> legal_divisor(const Jacobian& j, const Abel_jacobi_map& map, std::mt19937& random)
{
  try {
    Visitor visitor;
    return legalize_divisor(map, j.surface.periods, random_divisor(j.surface.delaunay, random), {}, visitor).divisor;
  } catch (const Error&) {
    return std::nullopt;   // singularities would run into each other
  }
}

// A divisor that is legal for one route misses the other by epsilon, and has the same integers. Returns how many there
// were.
int check_legal_divisors(const Jacobian& j, const Route_by_zeros& route, std::mt19937& random)
{
  int legal = 0;
  for (const Abel_jacobi_map* map : {&j.by_curvature, &route.map}) {
    const std::optional<Divisor> d = legal_divisor(j, *map, random);
    if (!d) continue;
    ++legal;
    const Jacobian_lattice::Nearest by_curvature = j.lattice.nearest(j.by_curvature.residual(*d) / quarter_turn);
    const Jacobian_lattice::Nearest by_zeros = j.lattice.nearest(route.map.residual(*d) / quarter_turn);
    CHECK((map == &route.map ? by_zeros : by_curvature).distance < rounding);
    CHECK_NEAR((map == &route.map ? by_curvature : by_zeros).distance, j.lattice.length(route.error()), rounding);
    check_same_integers(j, route, *d, by_curvature.vector, by_zeros.vector);
  }
  return legal;
}

// The routes through the zeros of a few forms, compared with that by curvature.
struct Comparison
{
  Disagreement worst;
  double       mean_square = 0;   // of |epsilon| in packing radii
};

Comparison compared(const Jacobian& j, const std::vector<Route_by_zeros>& routes)
{
  Comparison c;
  for (const Route_by_zeros& route : routes) {
    const Disagreement d = disagreement(j, route);
    c.worst.packing_radii = std::max(c.worst.packing_radii, d.packing_radii);
    c.worst.degrees = std::max(c.worst.degrees, d.degrees);
    c.mean_square += d.packing_radii * d.packing_radii / static_cast<double>(routes.size());
  }
  return c;
}

// The same forms with zeros below the vertices and at the vertices. The first form has all coefficients 1, as in the
// pipeline, the others are random.
struct Routes
{
  Routes(const Jacobian& j, int forms, std::mt19937& random)
  {
    Eigen::VectorXd coefficients = Eigen::VectorXd::Ones(j.by_curvature.dimension());
    for (int k = 0; k < forms; ++k) {
      const std::vector<Holomorphic_zero> zeros = j.zeros(coefficients);
      refined.emplace_back(j, zeros);
      at_vertices.emplace_back(j, ::at_vertices(j.surface.delaunay, zeros));
      for (double& c : coefficients) c = Quartic_test::uniform(random, -1, 1);
    }
  }

  std::vector<Route_by_zeros> refined, at_vertices;
};

// What holds for the routes through the zeros of some forms, of one kind.
void check_routes(const std::string& name, const std::string& kind, const Jacobian& j,
                  const std::vector<Route_by_zeros>& routes, std::mt19937& random)
{
  const int divisors = 3;   // for every route
  int same = 0, legal = 0;
  for (const Route_by_zeros& route : routes) {
    CHECK(is_multiple_of_4(route.nearest.vector));
    for (int k = 0; k < divisors; ++k) same += check_divisor(j, route, random_divisor(j.surface.delaunay, random));
    legal += check_legal_divisors(j, route, random);
  }
  CHECK(legal > 0);
  const Disagreement worst = compared(j, routes).worst;
  std::cout << std::left << std::setw(32) << name << std::setw(16) << kind << std::right << std::fixed
            << std::setprecision(4) << std::setw(8) << worst.packing_radii << std::setprecision(2) << std::setw(8)
            << worst.degrees << std::defaultfloat << std::setw(8) << legal << std::setw(6) << same << " of "
            << divisors * routes.size() << std::endl;
}

// \param at_vertices the bound on |epsilon|, in packing radii, for zeros at vertices
void test_integers(const Quartic_test::Named_surface& named, double at_vertices)
{
  if (named.surface.genus() == 0) return;
  const Jacobian j(named.surface);
  std::mt19937 random(5);
  const Routes routes(j, 6, random);
  check_routes(named.name, "below vertices", j, routes.refined, random);
  check_routes(named.name, "at vertices", j, routes.at_vertices, random);
  CHECK(compared(j, routes.refined).worst.packing_radii < 0.5);
  CHECK(compared(j, routes.at_vertices).worst.packing_radii < at_vertices);
}

// A form on a hyperelliptic curve vanishes at the images of its zeros under the involution, and so it does where the
// triangulation is symmetric: the errors of a pair cancel, wherever the zeros are.
void test_symmetric_surface(int g)
{
  const Jacobian j(Intrinsic_triangulation(hyperelliptic(g, 3)));
  std::mt19937 random(g);
  const Routes routes(j, 10, random);
  for (const auto* kind : {&routes.refined, &routes.at_vertices}) CHECK(compared(j, *kind).worst.packing_radii < 1e-6);
}

// The holonomy of the discrete flat metric of a divisor that is legal for a route, off multiples of 90. [degrees]
double real_holonomy(const Jacobian& j, const Abel_jacobi_map& map, const Divisor& start)
{
  Visitor visitor;
  const Divisor d = legalize_divisor(map, j.surface.periods, start, {}, visitor).divisor;
  Cone_metric_options options;
  options.outer_iterations = 0;
  return exact_cone_metric(j.surface.delaunay, j.surface.homology.cochains, d, options, visitor).history.front()
         * 90 / quarter_turn;
}

// By curvature the linear theory's own error is left, by zeros epsilon is added to it.
void test_real_holonomy(const Quartic_test::Named_surface& named)
{
  if (named.surface.genus() < 2) return;
  const Jacobian j(named.surface);
  std::mt19937 random(5);
  const Routes routes(j, 1, random);
  const Divisor start = curvature_divisor(j.surface.delaunay, j.surface.weights, j.surface.laplacian, 0);
  const double by_curvature = real_holonomy(j, j.by_curvature, start);
  CHECK(by_curvature < 2);
  std::cout << std::left << std::setw(32) << named.name << std::right << std::fixed << std::setprecision(2)
            << std::setw(10) << by_curvature;
  for (const Route_by_zeros* route : {&routes.refined.front(), &routes.at_vertices.front()}) {
    const double by_zeros = real_holonomy(j, route->map, start), epsilon = disagreement(j, *route).degrees;
    CHECK_NEAR(by_zeros, epsilon, by_curvature + 0.5);
    std::cout << std::setw(10) << by_zeros << " (" << epsilon << ')';
  }
  std::cout << std::defaultfloat << std::endl;
}

// Zeros at vertices are off by part of an edge, so the order is 1; those below vertices are better everywhere, and of a
// higher order.
void test_convergence()
{
  const std::vector<int> resolutions{6, 12, 24};
  std::vector<double> refined, at_vertices;
  for (int resolution : resolutions) {
    const Jacobian j(Intrinsic_triangulation(handle_chain(2, resolution)));
    std::mt19937 random(5);
    const Routes routes(j, 24, random);
    refined.push_back(std::sqrt(compared(j, routes.refined).mean_square));
    at_vertices.push_back(std::sqrt(compared(j, routes.at_vertices).mean_square));
    std::cout << "chain of genus 2, resolution " << resolution << ", " << j.surface.delaunay.number_of_vertices()
              << " vertices: root mean square of |epsilon| in packing radii " << refined.back() << " below vertices, "
              << at_vertices.back() << " at vertices" << std::endl;
    CHECK(refined.back() < at_vertices.back() / 5);
  }
  const auto order = [&](const std::vector<double>& error) {
    return std::log(error.front() / error.back()) / std::log(1.0 * resolutions.back() / resolutions.front());
  };
  std::cout << "orders " << order(refined) << " below vertices, " << order(at_vertices) << " at vertices" << std::endl;
  CHECK(order(refined) > 1.2);
  CHECK(order(at_vertices) > 0.6);
  for (const auto* error : {&refined, &at_vertices}) CHECK(std::is_sorted(error->rbegin(), error->rend()));
}

} // namespace

int main()
{
  const auto samples = Quartic_test::sample_surfaces();
  const auto meshes = Quartic_test::real_surfaces(
    {"kitten_18k9", "rockerarm_20k", "dancer_50k", "lawson_5k", "sculpt_7k3", "amphora_20k", "3holes_7k2",
     "neptune_30k", "fertility_112k", "botijo_82k", "buddha_20k", "bracket_29k", "casting_10k"});
  std::cout << "surface, zeros, largest |epsilon| in packing radii and degrees, legal divisors, random divisors whose "
               "nearest vectors had to be the same\n";
  for (const auto& s : samples) test_integers(s, 1);
  for (const auto& s : meshes) test_integers(s, 1.5);
  for (int g : {2, 3, 4}) test_symmetric_surface(g);
  std::cout << "surface, real holonomy in degrees by curvature, by zeros below vertices (epsilon), at vertices "
               "(epsilon)\n";
  for (const auto& s : samples) test_real_holonomy(s);
  for (const auto& s : meshes)
    if (s.surface.number_of_faces() < 10000) test_real_holonomy(s);
  test_convergence();
  return Quartic_test::result();
}
