// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LATTICE_BASIS_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LATTICE_BASIS_H

#include <Eigen/Core>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

using Big_integer = boost::multiprecision::cpp_int;
__extension__ using Long_integer = __int128;   // __extension__: ISO C++ has none

/// Doubles as integers times a common power of two, exactly.
struct Dyadic_numbers
{
  explicit Dyadic_numbers(const std::vector<double>& values);

  std::vector<Big_integer> integer;    ///< value = integer * 2^exponent
  int                      exponent;
};

/// n * 2^exponent with a relative error below 2^-52
double rounded(const Big_integer& n, int exponent);
double rounded(Long_integer n, int exponent);

/// the largest double that is not above n * 2^exponent, if that is a normal number. \pre n >= 0
double rounded_down(const Big_integer& n, int exponent);

/// sums and products of 64-bit integers. \throws Numerical_error if they leave the range
std::int64_t checked_sum(std::int64_t a, std::int64_t b);
std::int64_t checked_product(std::int64_t a, std::int64_t b);

using Integer_matrix = Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;

/// A basis of Z^n that is short in the norm of a Gram matrix W, which is known exactly.
class Lattice_basis
{
public:
  /// reduces the standard basis (LLL, delta = 0.99). The floating point reduction runs on the Cholesky factor and is
  /// repeated on the exact Gram matrix of its result until it finds nothing more to do: rounding decides how short
  /// the basis is, never whether it is one.
  /// \throws Numerical_error if `gram` is found not to be positive definite, or the basis leaves the 64-bit range
  explicit Lattice_basis(const Eigen::MatrixXd& gram);

  int dimension() const { return static_cast<int>(m_basis.rows()); }
  const Integer_matrix& basis()   const { return m_basis; }     ///< U, by columns
  const Integer_matrix& dual()    const { return m_dual; }      ///< U^-T, by columns
  const Eigen::MatrixXd& gram()   const { return m_gram; }      ///< U^T W U, every entry within 2^-52 of the exact one

  /// v^T W v for a vector of big integers, in units of 2^norm_exponent()
  Big_integer squared_norm(const std::vector<Big_integer>& v) const;
  int norm_exponent() const { return m_w.exponent; }

private:
  const Big_integer& w(int i, int j) const { return m_w.integer[i * dimension() + j]; }
  void update_gram();
  template <class Integer> void update_gram(const std::vector<Integer>& w);
  bool fits_long_integers() const;
  bool reduce_once();
  void subtract(int k, std::int64_t q, int j);
  void swap(int j, int k);

  Dyadic_numbers            m_w;        // by rows, symmetric
  std::vector<Long_integer> m_long_w;   // the same, empty if they do not fit
  Integer_matrix            m_basis, m_dual;
  Eigen::MatrixXd           m_gram;
};

/// the upper triangular R with R^T R = gram; pivots below 2^-52 of the diagonal entry are replaced by that.
Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& gram);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LATTICE_BASIS_H
