// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Lattice_basis.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const double lovasz_delta = 0.99;

// the symmetric matrix with this lower triangle, by rows
std::vector<double> symmetric_entries(const Eigen::MatrixXd& gram)
{
  const int n = static_cast<int>(gram.rows());
  std::vector<double> entries(n * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) entries[i * n + j] = entries[j * n + i] = gram(i, j);
  return entries;
}

const int most_long_bits = 126;

// empty if some number does not fit
std::vector<Long_integer> long_integers(const std::vector<Big_integer>& numbers)
{
  std::vector<Long_integer> result;
  for (const Big_integer& n : numbers) {
    if (n != 0 && static_cast<int>(msb(abs(n))) >= most_long_bits) return {};
    result.push_back(static_cast<Long_integer>(n));
  }
  return result;
}

[[noreturn]] void throw_not_positive_definite()
{
  throw Numerical_error("the Gram matrix of a lattice is not positive definite");
}

// the rotation of rows k-1 and k that makes column k-1 of R upper triangular again
void restore_triangle(Eigen::MatrixXd& R, int k)
{
  const double x = R(k - 1, k - 1), y = R(k, k - 1), r = std::hypot(x, y), c = x / r, s = y / r;
  for (int j = k - 1; j < R.cols(); ++j) {
    const double p = R(k - 1, j), q = R(k, j);
    R(k - 1, j) = c * p + s * q;
    R(k, j) = c * q - s * p;
  }
  R(k, k - 1) = 0;
}

} // namespace

Dyadic_numbers::Dyadic_numbers(const std::vector<double>& values)
  : exponent(std::numeric_limits<int>::max())
{
  std::vector<std::pair<std::int64_t, int>> parts;   // 53-bit integer, exponent
  for (double x : values) {
    int e = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
    parts.push_back({mantissa, e - 53});
    if (mantissa != 0) exponent = std::min(exponent, e - 53);
  }
  if (exponent == std::numeric_limits<int>::max()) exponent = 0;
  for (const auto& [mantissa, e] : parts) {
    integer.push_back(mantissa);
    if (mantissa != 0) integer.back() <<= e - exponent;
  }
}

double rounded(const Big_integer& n, int exponent)
{
  if (n == 0) return 0;
  const Big_integer magnitude = n < 0 ? Big_integer(-n) : n;
  const int extra = std::max(0, static_cast<int>(msb(magnitude)) - 62);
  const double x = std::ldexp(static_cast<double>(static_cast<std::int64_t>(magnitude >> extra)), extra + exponent);
  return n < 0 ? -x : x;
}

double rounded(Long_integer n, int exponent)
{
  return std::ldexp(static_cast<double>(n), exponent);
}

double rounded_down(const Big_integer& n, int exponent)
{
  if (n == 0) return 0;
  const int extra = std::max(0, static_cast<int>(msb(n)) - 52);
  return std::ldexp(static_cast<double>(static_cast<std::int64_t>(n >> extra)), extra + exponent);
}

std::int64_t checked_sum(std::int64_t a, std::int64_t b)
{
  std::int64_t c;
  if (__builtin_add_overflow(a, b, &c)) throw Numerical_error("a lattice vector leaves the range of 64-bit integers");
  return c;
}

std::int64_t checked_product(std::int64_t a, std::int64_t b)
{
  std::int64_t c;
  if (__builtin_mul_overflow(a, b, &c)) throw Numerical_error("a lattice vector leaves the range of 64-bit integers");
  return c;
}

Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& gram)
{
  const int n = static_cast<int>(gram.rows());
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(n, n);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < j; ++i) R(i, j) = (gram(i, j) - R.col(i).head(i).dot(R.col(j).head(i))) / R(i, i);
    const double pivot = gram(j, j) - R.col(j).head(j).squaredNorm();
    R(j, j) = std::sqrt(std::max(pivot, std::ldexp(gram(j, j), -52)));
  }
  return R;
}

Lattice_basis::Lattice_basis(const Eigen::MatrixXd& gram)
  : m_w(symmetric_entries(gram)), m_long_w(long_integers(m_w.integer)),
    m_basis(Integer_matrix::Identity(gram.rows(), gram.rows())), m_dual(m_basis),
    m_gram(gram.selfadjointView<Eigen::Lower>())
{
  const int most_passes = 50;   // two or three are usual
  if (!(m_gram.diagonal().array() > 0).all()) throw_not_positive_definite();
  for (int pass = 0; pass < most_passes && reduce_once(); ++pass) update_gram();
}

// U^T W U in exact arithmetic, then rounded
void Lattice_basis::update_gram()
{
  if (fits_long_integers()) update_gram(m_long_w);
  else                      update_gram(m_w.integer);
}

// whether all sums of U^T W U, and of W U, are below 2^most_long_bits, by the largest entry of W and the largest column
// sum of |U|
bool Lattice_basis::fits_long_integers() const
{
  if (m_long_w.empty()) return false;
  const double norm = m_basis.cast<double>().cwiseAbs().colwise().sum().maxCoeff();
  double largest = 0;
  for (Long_integer w : m_long_w) largest = std::max(largest, std::abs(static_cast<double>(w)));
  return largest * norm * norm < std::ldexp(1.0, most_long_bits - 1);   // a factor of 2 for rounding
}

template <class Integer>
void Lattice_basis::update_gram(const std::vector<Integer>& w)
{
  const int n = dimension();
  std::vector<Integer> w_u(n);
  for (int k = 0; k < n; ++k) {
    std::fill(w_u.begin(), w_u.end(), 0);
    for (int j = 0; j < n; ++j) {
      const std::int64_t u = m_basis(j, k);
      if (u == 0) continue;
      for (int i = 0; i < n; ++i) w_u[i] += w[j * n + i] * u;
    }
    for (int l = 0; l <= k; ++l) {
      Integer sum = 0;
      for (int i = 0; i < n; ++i)
        if (m_basis(i, l) != 0) sum += w_u[i] * m_basis(i, l);
      m_gram(k, l) = m_gram(l, k) = rounded(sum, m_w.exponent);
    }
    if (!(m_gram(k, k) > 0)) throw_not_positive_definite();
  }
}

// One LLL reduction of the columns of the Cholesky factor; returns whether the basis changed.
bool Lattice_basis::reduce_once()
{
  const int n = dimension();
  Eigen::MatrixXd R = cholesky_factor(m_gram);
  const double largest_step = 0x1p40;   // what rounding makes of a larger one is left to the next pass
  const std::size_t most_swaps = 1000 * static_cast<std::size_t>(n) * n;
  bool changed = false;
  std::size_t swaps = 0;
  for (int k = 1; k < n;) {
    for (int j = k - 1; j >= 0; --j) {
      if (std::abs(R(j, k)) <= 0.5 * std::abs(R(j, j))) continue;
      const double q = std::round(std::min(std::max(R(j, k) / R(j, j), -largest_step), largest_step));
      R.col(k).head(j + 1) -= q * R.col(j).head(j + 1);
      subtract(k, static_cast<std::int64_t>(q), j);
      changed = true;
    }
    const double before = R(k - 1, k - 1) * R(k - 1, k - 1);
    if (lovasz_delta * before <= R(k - 1, k) * R(k - 1, k) + R(k, k) * R(k, k) || swaps == most_swaps) {
      ++k;
      continue;
    }
    R.col(k - 1).swap(R.col(k));
    restore_triangle(R, k);
    swap(k - 1, k);
    changed = true;
    ++swaps;
    k = std::max(k - 1, 1);
  }
  return changed;
}

// column k of U minus q times column j
void Lattice_basis::subtract(int k, std::int64_t q, int j)
{
  for (int i = 0; i < dimension(); ++i) {
    m_basis(i, k) = checked_sum(m_basis(i, k), checked_product(-q, m_basis(i, j)));
    m_dual(i, j) = checked_sum(m_dual(i, j), checked_product(q, m_dual(i, k)));
  }
}

void Lattice_basis::swap(int j, int k)
{
  m_basis.col(j).swap(m_basis.col(k));
  m_dual.col(j).swap(m_dual.col(k));
}

Big_integer Lattice_basis::squared_norm(const std::vector<Big_integer>& v) const
{
  Big_integer sum = 0;
  for (int i = 0; i < dimension(); ++i) {
    Big_integer row = w(i, i) * v[i];
    for (int j = 0; j < i; ++j) row += 2 * w(i, j) * v[j];
    sum += row * v[i];
  }
  return sum;
}

} } } // namespace CGAL::Quartic_differentials::internal
