// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The closest vector problem against exhaustive search, planted solutions, exact ties and golden files; where fplll is
// there (QUARTIC_TEST_FPLLL), against its closest_vector too.

#include "check.h"

#include <CGAL/Quartic_differentials/closest_vector.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#ifdef QUARTIC_TEST_FPLLL
#include <fplll.h>
#endif

using namespace CGAL::Quartic_differentials;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

double uniform(std::mt19937& random, double a, double b) { return a + (b - a) * (random() / 4294967296.0); }

MatrixXd random_matrix(std::mt19937& random, int n)
{
  MatrixXd b(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) b(i, j) = uniform(random, -1, 1);
  return b;
}

VectorXd random_vector(std::mt19937& random, int n, double size)
{
  VectorXd x(n);
  for (int i = 0; i < n; ++i) x[i] = uniform(random, -size, size);
  return x;
}

MatrixXd random_gram(std::mt19937& random, int n)
{
  const MatrixXd b = random_matrix(random, n);
  MatrixXd gram = b.transpose() * b + 0.02 * MatrixXd::Identity(n, n);
  return 0.5 * (gram + gram.transpose().eval());
}

// a product of `steps` elementary integer matrices, and its inverse
std::pair<MatrixXd, MatrixXd> random_unimodular(std::mt19937& random, int n, int steps)
{
  MatrixXd u = MatrixXd::Identity(n, n), inverse = u;
  for (int s = 0; s < steps; ++s) {
    const int i = random() % n, j = random() % n;
    if (i == j) continue;
    const double q = random() % 2 ? 1 : -1;
    u.col(i) += q * u.col(j);
    inverse.row(j) -= q * inverse.row(i);
  }
  return {u, inverse};
}

VectorXd vector(const Lattice_vector& v)
{
  VectorXd m(v.coefficients.size());
  for (int i = 0; i < m.size(); ++i) m[i] = static_cast<double>(v.coefficients[i]);
  return m;
}

double squared_distance(const MatrixXd& w, const VectorXd& x, const VectorXd& m) { return (x - m).dot(w * (x - m)); }

// all integer vectors within `radius` of x, by their squared distances: every point of the box round the ellipsoid
std::vector<double> exhaustive(const MatrixXd& w, const VectorXd& x, double radius)
{
  const int n = static_cast<int>(x.size());
  const VectorXd reach = radius * w.inverse().diagonal().cwiseSqrt();
  VectorXd low(n), high(n);
  for (int i = 0; i < n; ++i) { low[i] = std::ceil(x[i] - reach[i]); high[i] = std::floor(x[i] + reach[i]); }
  std::vector<double> result;
  if ((low.array() > high.array()).any()) return result;
  VectorXd m = low;
  for (;;) {
    const double d = squared_distance(w, x, m);
    if (d <= radius * radius) result.push_back(d);
    int i = 0;
    while (i < n && m[i] == high[i]) { m[i] = low[i]; ++i; }
    if (i == n) break;
    ++m[i];
  }
  std::sort(result.begin(), result.end());
  return result;
}

void check_against_exhaustive_search()
{
  std::mt19937 random(1);
  for (int n = 1; n <= 6; ++n)
    for (int repeat = 0; repeat < 30; ++repeat) {
      const MatrixXd w = random_gram(random, n);
      const VectorXd x = random_vector(random, n, 5);
      const std::size_t count = 1 + random() % 8;
      const Closest_vectors found = closest_vectors(w, x, {count, infinity, 10000000});
      CHECK(found.optimal);
      CHECK_EQUAL(found.vectors.size(), count);
      const double last = found.vectors.back().squared_distance;
      const std::vector<double> expected = exhaustive(w, x, std::sqrt(last) * (1 + 1e-9));
      CHECK_EQUAL(expected.size(), count);
      for (std::size_t i = 0; i < std::min(count, expected.size()); ++i) {
        const Lattice_vector& v = found.vectors[i];
        CHECK_NEAR(v.squared_distance, expected[i], 1e-11 * (1 + last));
        CHECK_NEAR(v.squared_distance, squared_distance(w, x, vector(v)), 1e-11 * (1 + last));
      }

      const Closest_vectors two = closest_vectors(w, x, {2});
      const Closest_vectors one = closest_vectors(w, x);
      CHECK(one.vectors.size() == 1 && one.vectors[0].coefficients == found.vectors[0].coefficients);
      CHECK(one.gap.has_value() && two.gap.has_value());
      const double least = two.vectors[0].squared_distance, next = two.vectors[1].squared_distance;
      CHECK_NEAR(*one.gap, std::sqrt(next) - std::sqrt(least), 1e-12);
      CHECK_EQUAL(*one.gap, *two.gap);

      const Closest_vectors within = closest_vectors(w, x, {16, 2.0, 10000000});
      const std::size_t in_radius = exhaustive(w, x, 2 * std::sqrt(one.vectors[0].squared_distance)).size();
      CHECK_EQUAL(within.vectors.size(), std::min<std::size_t>(in_radius, 16));
    }
}

// targets so near to a lattice vector that it must be the closest, in bases that hide this
void check_near_lattice_targets()
{
  std::mt19937 random(2);
  for (int n : {2, 4, 8, 12, 16, 20, 24}) {
    double slowest = 0;
    std::size_t nodes = 0;
    for (int repeat = 0; repeat < 5; ++repeat) {
      const MatrixXd w0 = random_gram(random, n);
      const auto [u, inverse] = random_unimodular(random, n, 6 * n);
      const MatrixXd w = u.transpose() * w0 * u;
      VectorXd planted(n);
      for (int i = 0; i < n; ++i) planted[i] = static_cast<int>(random() % 41) - 20;
      const VectorXd m = inverse * planted, x = inverse * (planted + random_vector(random, n, 1e-3));
      const auto start = std::chrono::steady_clock::now();
      const Closest_vectors found = closest_vectors(w, x);
      slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      nodes = std::max(nodes, found.nodes);
      CHECK(found.optimal);
      CHECK(!found.tie);
      CHECK(vector(found.vectors[0]) == m);
    }
    std::cout << "near-lattice targets, dimension " << n << ": at most " << slowest << " s, "
              << nodes << " nodes" << std::endl;
  }
}

void check_random_targets()
{
  std::mt19937 random(3);
  for (int n : {8, 16, 24}) {
    const MatrixXd w = random_gram(random, n);
    const VectorXd x = random_vector(random, n, 3);
    const auto start = std::chrono::steady_clock::now();
    const Closest_vectors found = closest_vectors(w, x);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    CHECK(found.optimal);
    const Closest_vectors sixteen = closest_vectors(w, x, {16, 2.0, 1000000});
    CHECK(sixteen.optimal);
    CHECK(sixteen.vectors[0].coefficients == found.vectors[0].coefficients);
    for (std::size_t i = 1; i < sixteen.vectors.size(); ++i)
      CHECK(sixteen.vectors[i - 1].squared_distance <= sixteen.vectors[i].squared_distance);
    std::cout << "random target, dimension " << n << ": " << seconds << " s, " << found.nodes << " nodes" << std::endl;
  }
}

// the same exact problem in a good and in a very bad basis: the results must agree to the last bit
void check_ill_conditioned()
{
  std::mt19937 random(4);
  for (int n = 2; n <= 10; ++n)
    for (int repeat = 0; repeat < 10; ++repeat) {
      MatrixXd b(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) b(i, j) = (i == j ? 8 : 0) + static_cast<int>(random() % 7) - 3;
      const MatrixXd w0 = b.transpose() * b;
      const auto [u, inverse] = random_unimodular(random, n, 9 * n);
      const MatrixXd w = u.transpose() * w0 * u;
      VectorXd x0(n);
      for (int i = 0; i < n; ++i) x0[i] = (static_cast<int>(random() % 2048) - 1024) / 128.0;
      const VectorXd x = inverse * x0;
      const double largest_exact = 0x1p52;
      if (w.cwiseAbs().maxCoeff() > largest_exact || x.cwiseAbs().maxCoeff() > 0x1p44) continue;
      const Closest_vectors good = closest_vectors(w0, x0, {4}), bad = closest_vectors(w, x, {4});
      CHECK(good.optimal && bad.optimal);
      CHECK_EQUAL(good.tie, bad.tie);
      CHECK_EQUAL(*good.gap, *bad.gap);
      for (int i = 0; i < 4; ++i) CHECK_EQUAL(good.vectors[i].squared_distance, bad.vectors[i].squared_distance);
      if (!good.tie) CHECK(vector(bad.vectors[0]) == inverse * vector(good.vectors[0]));
    }

  // (2^26 x + y)^2 + x^2: with condition number 2^104, floating point cannot tell that it is positive definite
  MatrixXd w(2, 2);
  w << 0x1p52 + 1, 0x1p26, 0x1p26, 1;
  VectorXd x(2);
  x << 0.25, 0.125;
  const Closest_vectors found = closest_vectors(w, x);
  CHECK(found.optimal);
  CHECK(found.vectors[0].coefficients == (std::vector<std::int64_t>{0, 16777216}));
  CHECK_EQUAL(found.vectors[0].squared_distance, 0.25 * 0.25 + 0.125 * 0.125);
}

void check_ties()
{
  const Closest_vectors hole = closest_vectors(MatrixXd::Identity(2, 2), VectorXd::Constant(2, 0.5), {4});
  CHECK(hole.optimal && hole.tie);
  CHECK_EQUAL(*hole.gap, 0);
  const std::vector<std::vector<std::int64_t>> square = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  for (std::size_t i = 0; i < 4; ++i) CHECK(hole.vectors[i].coefficients == square[i]);

  const Closest_vectors one = closest_vectors(MatrixXd::Identity(2, 2), VectorXd::Constant(2, 0.5));
  CHECK(one.optimal && one.tie && one.vectors.size() == 1);
  CHECK(one.vectors[0].coefficients == square[0]);

  // one unit in the last place decides
  VectorXd x = VectorXd::Constant(2, 0.5);
  x[1] = std::nextafter(0.5, 1.0);
  const Closest_vectors near = closest_vectors(MatrixXd::Identity(2, 2), x, {2});
  CHECK(near.optimal && near.tie);
  CHECK(near.vectors[0].coefficients == square[1] && near.vectors[1].coefficients == square[3]);

  // hexagonal lattice: the hole (2/3, 1/3) is not a double, what is nearest to its rounding is decided exactly
  MatrixXd a2(2, 2);
  a2 << 2, -1, -1, 2;
  x << 2.0 / 3, 1.0 / 3;
  const Closest_vectors hexagonal = closest_vectors(a2, x, {3});
  CHECK(hexagonal.optimal);
  CHECK(hexagonal.gap.has_value() && *hexagonal.gap < 1e-15);
  CHECK_NEAR(hexagonal.vectors[2].squared_distance, 2.0 / 3, 1e-15);

  const Closest_vectors on_lattice = closest_vectors(a2, VectorXd::Constant(2, -7), {16, 2.0, 1000});
  CHECK(on_lattice.optimal && !on_lattice.tie && on_lattice.vectors.size() == 1);
  CHECK_EQUAL(on_lattice.vectors[0].squared_distance, 0);
  CHECK_NEAR(*on_lattice.gap, std::sqrt(2.0), 1e-15);

  const int n = 10;    // 1024 vertices of a cube
  const VectorXd middle = VectorXd::Constant(n, 0.5);
  const Closest_vectors cube = closest_vectors(MatrixXd::Identity(n, n), middle, {2000, 1.0, 100000});
  CHECK(cube.optimal && cube.tie);
  CHECK_EQUAL(cube.vectors.size(), 1024u);
  for (std::size_t i = 1; i < cube.vectors.size(); ++i)
    CHECK(cube.vectors[i - 1].coefficients < cube.vectors[i].coefficients);
}

void check_limits()
{
  const Closest_vectors nothing = closest_vectors(MatrixXd(0, 0), VectorXd(0));
  CHECK(nothing.optimal && nothing.vectors.size() == 1 && nothing.vectors[0].coefficients.empty());
  CHECK_EQUAL(nothing.vectors[0].squared_distance, 0);

  std::mt19937 random(6);
  const int n = 40;
  const MatrixXd w = random_gram(random, n);
  const VectorXd x = random_vector(random, n, 3);
  const Closest_vectors capped = closest_vectors(w, x, {1, infinity, 100});
  CHECK(!capped.optimal);
  CHECK(!capped.gap.has_value());
  CHECK(capped.nodes <= 101);
  CHECK_EQUAL(capped.vectors.size(), 1u);
  CHECK_NEAR(capped.vectors[0].squared_distance, squared_distance(w, x, vector(capped.vectors[0])), 1e-10);

  MatrixXd indefinite(2, 2);
  indefinite << 1, 2, 2, 1;
  CHECK_THROWS(closest_vectors(indefinite, VectorXd::Zero(2)), Numerical_error, "not positive definite");
  CHECK_THROWS(closest_vectors(MatrixXd::Ones(2, 2), VectorXd::Zero(2)), Numerical_error, "not positive definite");
  CHECK_THROWS(closest_vectors(MatrixXd::Identity(2, 2), VectorXd::Constant(2, 1e300)), Numerical_error, "64-bit");
}

// problems of known solution; the file describes its form
void check_golden_file()
{
  const std::string source = __FILE__;
  std::ifstream file(source.substr(0, source.find_last_of('/') + 1) + "data/closest_vectors.txt");
  std::stringstream in;
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && line[0] != '#') in << line << '\n';
  int problems = 0;
  std::size_t n, count;
  while (in >> n >> count) {
    ++problems;
    MatrixXd w(n, n);
    VectorXd x(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) in >> w(i, j);
    for (std::size_t i = 0; i < n; ++i) in >> x[i];
    std::size_t solutions;
    in >> solutions;
    const Closest_vectors found = closest_vectors(w, x, {solutions});
    CHECK(found.optimal);
    CHECK_EQUAL(found.vectors.size(), solutions);
    std::vector<double> distances;
    for (const Lattice_vector& v : found.vectors) {
      double distance;
      std::vector<std::int64_t> m(n);
      in >> distance;
      for (std::int64_t& c : m) in >> c;
      distances.push_back(distance);
      CHECK_NEAR(v.squared_distance, distance, 4e-16 * distance);
      CHECK(v.coefficients == m);
    }
    CHECK_EQUAL(found.tie, distances.size() > 1 && distances[0] == distances[1]);
    CHECK(closest_vectors(w, x, {count}).vectors.size() == count);
  }
  CHECK_EQUAL(problems, 10);
}

#ifdef QUARTIC_TEST_FPLLL
// distances, not vectors: fplll answers in its reduced basis
void check_against_fplll()
{
  std::mt19937 random(8);
  for (int n : {4, 8, 12, 16, 24, 32})
    for (int repeat = 0; repeat < 10; ++repeat) {
      MatrixXd b(n, n);         // a basis by columns
      VectorXd t(n);
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) b(i, j) = static_cast<int>(random() % 1001) - 500;
        t[i] = static_cast<int>(random() % 4001) - 2000;
      }
      fplll::ZZ_mat<mpz_t> basis(n, n);
      std::vector<fplll::Z_NR<mpz_t>> target(n), solution;
      for (int i = 0; i < n; ++i) {
        target[i] = static_cast<long>(t[i]);
        for (int j = 0; j < n; ++j) basis(i, j) = static_cast<long>(b(j, i));
      }
      fplll::lll_reduction(basis);
      CHECK_EQUAL(fplll::closest_vector(basis, target, solution, fplll::CVPM_FAST), 0);
      VectorXd nearest = VectorXd::Zero(n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) nearest[j] += solution[i].get_si() * basis(i, j).get_si();

      const VectorXd x = b.partialPivLu().solve(t);
      const Closest_vectors found = closest_vectors(b.transpose() * b, x, {1, infinity, 100000000});
      CHECK(found.optimal);
      CHECK_EQUAL((t - b * vector(found.vectors[0])).squaredNorm(), (t - nearest).squaredNorm());
    }
}
#endif

} // namespace

int main()
{
  check_against_exhaustive_search();
  check_near_lattice_targets();
  check_random_targets();
  check_ill_conditioned();
  check_ties();
  check_limits();
  check_golden_file();
#ifdef QUARTIC_TEST_FPLLL
  check_against_fplll();
#endif
  return Quartic_test::result();
}
