// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The closest vector problem on 10,000 random integer lattices, where everything is compared in integers: with every
// point of a box (up to dimension 6), with a search of another kind, and where fplll is there (QUARTIC_TEST_FPLLL) with
// its closest_vector. Also planted solutions up to dimension 100, exact ties, lower bounds, golden files.

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
  for (int n : {2, 4, 8, 12, 16, 20, 24, 48, 100}) {
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
  CHECK(capped.nodes <= 200);   // the search, and those for the bound
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

// A lattice and a target, in integers: the columns of `basis`, and the point basis * target / 64. The solver is asked
// in the basis `basis * change`, in which the target is inverse(change) * target / 64: an exact problem in doubles.
struct Integer_problem
{
  using Matrix = Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<std::int64_t, Eigen::Dynamic, 1>;

  static constexpr std::int64_t unit = 64;
  Matrix basis, change, inverse;
  Vector target;

  MatrixXd gram() const { const Matrix b = basis * change; return (b.transpose() * b).cast<double>(); }
  VectorXd x() const { return (inverse * target).cast<double>() / unit; }
  // 64^2 times the squared distance of the target from basis * m
  std::int64_t squared_distance(const Vector& m) const { return (basis * (target - unit * m)).squaredNorm(); }
  // the coordinates in `basis` of a vector that the solver found
  Vector in_basis(const Lattice_vector& v) const
  { return change * Eigen::Map<const Vector>(v.coefficients.data(), v.coefficients.size()); }
};

using Long_matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// the triangular factor of a basis by Gram and Schmidt, twice
Long_matrix triangular_factor(const Integer_problem::Matrix& basis)
{
  Long_matrix q = basis.cast<long double>(), r = Long_matrix::Zero(q.cols(), q.cols());
  for (Eigen::Index j = 0; j < q.cols(); ++j) {
    for (int repeat = 0; repeat < 2; ++repeat)
      for (Eigen::Index i = 0; i < j; ++i) {
        const long double product = q.col(i).dot(q.col(j));
        r(i, j) += product;
        q.col(j) -= product * q.col(i);
      }
    r(j, j) = q.col(j).norm();
    q.col(j) /= r(j, j);
  }
  return r;
}

// Columns of very different lengths, of small and of larger entries; every other one in a basis that hides it; every
// fourth target in the middle between lattice points, where ties are frequent.
Integer_problem random_problem(std::mt19937& random, int n)
{
  const auto integer = [&](int most) { return static_cast<std::int64_t>(random() % (2 * most + 1)) - most; };
  Integer_problem p{Integer_problem::Matrix(n, n), Integer_problem::Matrix::Identity(n, n),
                    Integer_problem::Matrix::Identity(n, n), Integer_problem::Vector(n)};
  const int most = random() % 2 ? 9 : 2, stretches = random() % 3;
  do {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) p.basis(i, j) = integer(most) * (std::int64_t(1) << (stretches * j / n));
  } while (!(triangular_factor(p.basis).diagonal().minCoeff() > 0.5L));   // not singular, and quick to search
  const int granularity = random() % 4 == 0 ? Integer_problem::unit / 2 : 1;
  for (int i = 0; i < n; ++i) p.target[i] = granularity * integer(4 * Integer_problem::unit / granularity);
  if (random() % 2) {
    const auto [u, inverse] = random_unimodular(random, n, 4 * n);
    p.change = u.cast<std::int64_t>();
    p.inverse = inverse.cast<std::int64_t>();
  }
  return p;
}

// How many lattice vectors are nearer than a given distance, and exactly as near.
struct Near_vectors
{
  std::size_t nearer = 0, as_near = 0;

  void add(std::int64_t squared_distance, std::int64_t given)
  {
    if (squared_distance < given) ++nearer;
    if (squared_distance == given) ++as_near;
  }
};

// Fincke and Pohst: all integers in the interval that the entries fixed so far leave for the next, from its low end up.
// The intervals are in long double and slightly too wide, what they contain is decided in integers.
class Interval_search
{
public:
  Interval_search(const Integer_problem& p, std::int64_t squared_distance)
    : m_problem(p), m_r(triangular_factor(p.basis)), m_m(p.target.size()), m_given(squared_distance)
  { choose(p.target.size() - 1, static_cast<long double>(squared_distance) * (1 + 1e-9L) + 1e-3L); }

  Near_vectors result;

private:
  void choose(Eigen::Index i, long double rest)
  {
    if (i < 0) return result.add(m_problem.squared_distance(m_m), m_given);
    const long double unit = Integer_problem::unit;
    long double middle = m_problem.target[i];
    for (Eigen::Index j = i + 1; j < m_m.size(); ++j)
      middle += m_r(i, j) / m_r(i, i) * static_cast<long double>(m_problem.target[j] - Integer_problem::unit * m_m[j]);
    const long double reach = std::sqrt(rest) / m_r(i, i);
    const auto last = static_cast<std::int64_t>(std::floor((middle + reach) / unit));
    for (m_m[i] = static_cast<std::int64_t>(std::ceil((middle - reach) / unit)); m_m[i] <= last; ++m_m[i]) {
      const long double z = m_r(i, i) * (middle - unit * m_m[i]);
      choose(i - 1, std::max(0.0L, rest - z * z));
    }
  }

  const Integer_problem&  m_problem;
  Long_matrix             m_r;
  Integer_problem::Vector m_m;
  std::int64_t            m_given;
};

// Every point of the box |m_i - x_i| <= d sqrt((W^-1)_ii), which contains the ellipsoid of the points within d.
Near_vectors in_box(const Integer_problem& p, std::int64_t squared_distance)
{
  using Integers = Integer_problem::Vector;
  const MatrixXd b = p.basis.cast<double>();
  const VectorXd x = p.target.cast<double>() / Integer_problem::unit;
  const double distance = std::sqrt(static_cast<double>(squared_distance)) / Integer_problem::unit;
  const VectorXd reach = distance * (1 + 1e-9) * b.inverse().rowwise().norm();   // W^-1 = B^-1 B^-T
  const Integers low = (x - reach).array().ceil().matrix().cast<std::int64_t>();
  const Integers high = (x + reach).array().floor().matrix().cast<std::int64_t>();
  Near_vectors result;
  if ((low.array() > high.array()).any()) return result;
  Integers m = low, difference = p.basis * (p.target - Integer_problem::unit * low);
  for (;;) {
    result.add(difference.squaredNorm(), squared_distance);
    Eigen::Index i = 0;
    for (; i < m.size() && m[i] == high[i]; ++i) {
      difference += Integer_problem::unit * (high[i] - low[i]) * p.basis.col(i);
      m[i] = low[i];
    }
    if (i == m.size()) return result;
    difference -= Integer_problem::unit * p.basis.col(i);
    ++m[i];
  }
}

#ifdef QUARTIC_TEST_FPLLL
// The least squared distance by fplll, which wants a reduced basis and answers in that. (CVPM_PROVED of version 5.4.4
// returns farther vectors.) It never ends if a coordinate of the target is exactly half an integer on the way, so the
// target is moved a little: everything is stretched by 2^20, and the target moved by less than 2 n^(1/2). This changes
// distances d by less than 2^-19 n^(1/2), and d^2 by less than 1, which is the least difference that there can be.
std::int64_t least_by_fplll(const Integer_problem& p, std::mt19937& random)
{
  const std::int64_t stretch = 1 << 20;
  const Eigen::Index n = p.target.size();
  const Integer_problem::Matrix b = Integer_problem::unit * p.basis * p.change;
  const Integer_problem::Vector t = p.basis * p.target;
  fplll::ZZ_mat<mpz_t> basis(n, n);   // by rows
  std::vector<fplll::Z_NR<mpz_t>> target(n), solution;
  for (Eigen::Index i = 0; i < n; ++i) {
    target[i] = static_cast<long>(stretch * t[i] + static_cast<std::int64_t>(random() % 5) - 2);
    for (Eigen::Index j = 0; j < n; ++j) basis(i, j) = static_cast<long>(stretch * b(j, i));
  }
  fplll::lll_reduction(basis);
  CHECK_EQUAL(fplll::closest_vector(basis, target, solution, fplll::CVPM_FAST), 0);
  Integer_problem::Vector difference = t;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) difference[j] -= solution[i].get_si() * (basis(i, j).get_si() / stretch);
  return difference.squaredNorm();
}
#endif

void check_random_lattices()
{
  std::mt19937 random(8);
#ifdef QUARTIC_TEST_FPLLL
  std::mt19937 perturbation(9);
#endif
  std::size_t lattices = 0, ties = 0;
  for (int n = 2; n <= 24; ++n) {
    const int number = n <= 6 ? 800 : n < 20 ? 300 : 420;
    const auto start = std::chrono::steady_clock::now();
    for (int repeat = 0; repeat < number; ++repeat) {
      const Integer_problem p = random_problem(random, n);
      const Closest_vectors found = closest_vectors(p.gram(), p.x());
      ++lattices;
      CHECK(found.optimal && found.vectors.size() == 1);
      const std::int64_t least = p.squared_distance(p.in_basis(found.vectors[0]));
      const double squared_distance = std::ldexp(static_cast<double>(least), -12);   // by 64^2, exact
      CHECK_EQUAL(found.vectors[0].squared_distance, squared_distance);
      CHECK_EQUAL(found.lower_bound, squared_distance);

      const Near_vectors near = Interval_search(p, least).result;
      CHECK_EQUAL(near.nearer, 0u);
      CHECK(near.as_near >= 1);
      CHECK_EQUAL(found.tie, near.as_near > 1);
      ties += found.tie;
      if (n <= 6) {
        const Near_vectors all = in_box(p, least);
        CHECK_EQUAL(all.nearer, 0u);
        CHECK_EQUAL(all.as_near, near.as_near);
      }
#ifdef QUARTIC_TEST_FPLLL
      CHECK_EQUAL(least_by_fplll(p, perturbation), least);
#endif
    }
    if (n % 4 == 0)
      std::cout << "random lattices of dimension " << n << ": "
                << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / number << " s each"
                << std::endl;
  }
  CHECK_EQUAL(lattices, 10000u);
  CHECK(ties > 500);
  std::cout << lattices << " random lattices, " << ties << " ties" << std::endl;
}

// What a capped search promises: bound <= optimum <= distance, and a bound that never falls if the cap rises.
void check_lower_bounds()
{
  std::mt19937 random(9);
  for (int n : {24, 40, 48, 56, 64}) {
    const std::size_t most_nodes = n <= 40 ? 1000000 : 100000;   // the optimum is reached up to dimension 40
    const MatrixXd w = random_gram(random, n);
    const VectorXd x = random_vector(random, n, 3);
    double last = 0, first = 0;
    bool optimal = false;
    std::vector<double> distances;
    for (std::size_t cap : {1, 10, 100, 1000, 10000, 100000, 1000000}) {
      if (cap > most_nodes) break;
      const Closest_vectors found = closest_vectors(w, x, {1, infinity, cap});
      const double distance = found.vectors[0].squared_distance;
      CHECK(found.lower_bound >= last && found.lower_bound <= distance);   // fails if it is not a number
      for (double d : distances) CHECK(found.lower_bound <= d);
      optimal = found.optimal;
      if (found.optimal) {
        CHECK(found.lower_bound >= std::nextafter(distance, 0.0));   // the same number, rounded down
      } else {
        CHECK(found.nodes <= 2 * std::max<std::size_t>(cap, n));
      }
      distances.push_back(distance);
      last = found.lower_bound;
      if (distances.size() == 1) first = last;
      std::cout << "dimension " << n << ", " << cap << " nodes" << (found.optimal ? ", optimal" : "") << ": distance "
                << std::sqrt(distance) << ", at least " << std::sqrt(last) << std::endl;
    }
    CHECK(last > first);
    CHECK(std::sqrt(last) > 0.5 * std::sqrt(distances.back()));
    if (n <= 40) CHECK(optimal);
  }

  // several vectors wanted; and a target on the lattice, for which the bound can only be 0
  const MatrixXd w = random_gram(random, 48);
  const Closest_vectors several = closest_vectors(w, random_vector(random, 48, 3), {16, 2.0, 1000});
  CHECK(!several.optimal && several.lower_bound > 0);
  CHECK(several.lower_bound <= several.vectors[0].squared_distance);
  const Closest_vectors on_lattice = closest_vectors(w, VectorXd::Constant(48, 3), {16, infinity, 1000});
  CHECK_EQUAL(on_lattice.lower_bound, 0);
  CHECK_EQUAL(on_lattice.vectors[0].squared_distance, 0);
}

void check_contract()
{
  const MatrixXd w = (MatrixXd(2, 2) << 2, 1, 1, 2).finished();
  const VectorXd x = (VectorXd(2) << 0.25, 0.5).finished();
  const Closest_vector_options two{2};
  const Closest_vectors right = Certified_closest_vectors()(w, x, two);
  const auto answer = [&](const auto& spoil) {
    Closest_vectors wrong = right;
    spoil(wrong);
    check_closest_vectors(wrong, w, x, two);
    return true;
  };
  CHECK(answer([](Closest_vectors&) {}));
  CHECK(answer([](Closest_vectors& a) { a.vectors.pop_back(); a.lower_bound = 0; }));
  CHECK_THROWS(answer([](Closest_vectors& a) { a.vectors.clear(); }), Error, "no vector");
  CHECK_THROWS(answer([](Closest_vectors& a) { a.vectors.push_back({{9, 9}, 999}); }), Error,
               "3 vectors where at most 2");
  CHECK_THROWS(answer([](Closest_vectors& a) { a.vectors[1].coefficients.pop_back(); }), Error,
               "1 coefficients in dimension 2");
  CHECK_THROWS(answer([](Closest_vectors& a) { a.vectors[1] = a.vectors[0]; }), Error, "same vector twice");
  CHECK_THROWS(answer([](Closest_vectors& a) { std::swap(a.vectors[0], a.vectors[1]); }), Error,
               "order of their distances");
  CHECK_THROWS(answer([](Closest_vectors& a) { a.vectors[0].coefficients[0] += 1; }), Error, "not its vector's");
  CHECK_THROWS(answer([](Closest_vectors& a) { a.vectors[0].squared_distance = std::nan(""); }), Error, "order");
  CHECK_THROWS(answer([](Closest_vectors& a) { a.lower_bound = 10; }), Error, "contradicts");
  CHECK_THROWS(answer([](Closest_vectors& a) { a.lower_bound = std::nan(""); }), Error, "contradicts");
}

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
  check_random_lattices();
  check_lower_bounds();
  check_contract();
  return Quartic_test::result();
}
