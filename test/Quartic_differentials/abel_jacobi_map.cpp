// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Step 4: the Abel-Jacobi map is continuous along paths, its Jacobian is its derivative, and the paper's route through
// the zeros of a holomorphic form finds the same integers.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <Eigen/Dense>

#include <cmath>

using namespace CGAL::Quartic_differentials;

namespace {

const double quarter_turn = std::acos(-1.0) / 2;

struct Random_divisor
{
  Lifted_divisor   points;
  std::vector<int> orders;
};

Random_divisor random_divisor(const Abel_jacobi_map& map, std::mt19937& random)
{
  Random_divisor d;
  const int n = 8 * map.triangulation().genus() - 8 + 8;
  for (int i = 0; i < n + 4; ++i) {
    const Face f(static_cast<Mesh::size_type>(random() % map.triangulation().number_of_faces()));
    const double x = Quartic_test::uniform(random, 0.1, 0.4), y = Quartic_test::uniform(random, 0.1, 0.4);
    d.points.push_back(map.lift({f, {1 - x - y, x, y}}));
    d.orders.push_back(i % 3 == 0 ? -1 : i % 3 == 1 ? 1 : 2);
  }
  return d;
}

// distance of a vector from (pi/2) times the integers
double lattice_distance(const Eigen::VectorXd& f)
{
  return (f - quarter_turn * (f / quarter_turn).array().round().matrix()).cwiseAbs().maxCoeff();
}

void test_derivative(const Abel_jacobi_map& map, std::mt19937& random)
{
  const Random_divisor d = random_divisor(map, random);
  const Eigen::MatrixXd j = map.jacobian(d.points, d.orders);
  Eigen::VectorXd direction(j.cols());
  for (double& x : direction) x = Quartic_test::uniform(random, -1, 1);
  const double step = 1e-4 * std::sqrt(map.triangulation().area() / map.triangulation().number_of_faces());
  const auto moved = [&](double s) {
    Lifted_divisor points = d.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = map.moved(points[i], s * std::complex<double>(direction[2 * i], direction[2 * i + 1]));
    return map.residual(points, d.orders);
  };
  const Eigen::VectorXd differences = (moved(step) - moved(-step)) / (2 * step);
  CHECK((differences - j * direction).cwiseAbs().maxCoeff() < 1e-6 * std::max(1.0, (j * direction).cwiseAbs().maxCoeff()));
}

// Along a straight way the potential changes by no more than its gradient allows: it never jumps, and where the way ends
// it differs from the value on sheet 0 by integers.
void test_paths(const Abel_jacobi_map& map, std::mt19937& random)
{
  const double size = std::sqrt(map.triangulation().area());
  double longest = 0;
  for (Face g : map.triangulation().faces())
    longest = std::max(longest, gradients(map.triangulation(), map.forms(), g).cwiseAbs().maxCoeff());
  for (int trial = 0; trial < 10; ++trial) {
    const Face f(static_cast<Mesh::size_type>(random() % map.triangulation().number_of_faces()));
    const Lifted_point start = map.lift({f, {0.3, 0.3, 0.4}});
    const std::complex<double> way = std::polar(0.7 * size, Quartic_test::uniform(random, -3, 3));
    const Lifted_point end = map.moved(start, way);
    // potentials on different sheets differ by integers
    const Eigen::RowVectorXd on_sheet_0 = map.potential(map.lift(end.location));
    const Eigen::RowVectorXd difference = map.potential(end) - on_sheet_0;
    CHECK((difference - difference.array().round().matrix()).cwiseAbs().maxCoeff() < 1e-9);
    // the change along the way is bounded by the gradients met: no jump by an integer
    const double change = (map.potential(end) - map.potential(start)).cwiseAbs().maxCoeff();
    CHECK(change <= longest * std::abs(way) + 1e-9);
  }
}

// zeros refined below the vertices, against the curvature form: the same lattice point, up to discretisation
void test_both_routes(const std::string& name, const Riemann_surface& s, const Abel_jacobi_map& map, std::mt19937& random)
{
  const Random_divisor d = random_divisor(map, random);
  const Abel_jacobi_map by_zeros(s.delaunay, s.forms, s.zeros);
  CHECK((map.jacobian(d.points, d.orders) - by_zeros.jacobian(d.points, d.orders)).isZero());
  const Eigen::VectorXd difference = map.residual(d.points, d.orders) - by_zeros.residual(d.points, d.orders);
  const double turns = 2 * std::acos(-1.0);
  const Eigen::VectorXd remainder = difference - turns * (difference / turns).array().round().matrix();
  std::cout << name << ": the two routes differ by " << remainder.cwiseAbs().maxCoeff() * 90 / quarter_turn
            << " degrees modulo 360" << std::endl;
  CHECK(remainder.cwiseAbs().maxCoeff() < 0.3);   // radians: far from the next integer, which is 2 pi away
}

void test(const Quartic_test::Named_surface& named)
{
  const int g = named.surface.genus();
  if (g == 0) return;
  Visitor visitor;
  const Riemann_surface s = riemann_surface(named.surface, visitor);
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  std::mt19937 random(11);
  test_derivative(map, random);
  test_paths(map, random);
  test_both_routes(named.name, s, map, random);
}

// The turning numbers of a flat torus are multiples of 2 pi, and its potentials know no curvature.
void test_flat_torus()
{
  Glued_triangles square;
  square.triangles = {{0, 0, 0}, {0, 0, 0}};
  square.opposite = {{{{1, 1}, {1, 2}, {1, 0}}}, {{{0, 2}, {0, 0}, {0, 1}}}};
  square.lengths = {{1, 1, std::sqrt(2.0)}, {std::sqrt(2.0), 1, 1}};
  const Intrinsic_triangulation t(subdivided(square));
  CHECK_EQUAL(t.genus(), 1);
  Visitor visitor;
  const Riemann_surface s = riemann_surface(t, visitor);
  CHECK(s.periods.pi(0, 0).imag() > 0.99999);
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  CHECK(lattice_distance(map.constant()) < 1e-12);
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test(s);
  for (const auto& s : Quartic_test::real_surfaces({"kitten_18k9", "sculpt_7k3", "3holes_7k2"})) test(s);
  test_flat_torus();
  return Quartic_test::result();
}
