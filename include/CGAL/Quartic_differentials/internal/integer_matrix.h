// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_INTEGER_MATRIX_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_INTEGER_MATRIX_H

#include <Eigen/Core>

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/gmp.hpp>

#include <optional>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Matrices of integers without bounds. (Not cpp_int: Boost 1.74 takes a matrix for a container of bytes to make one
/// from.)
using Integer            = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Big_integer_matrix = Eigen::Matrix<Integer, Eigen::Dynamic, Eigen::Dynamic>;

Big_integer_matrix widened(const Eigen::MatrixXi& m);

/// \throws Numerical_error if an entry leaves the 16-bit range
Eigen::MatrixXi narrowed(const Big_integer_matrix& m);

/// brings m to row echelon form by unimodular row operations (Euclid's algorithm column by column); returns its rank.
int make_echelon(Big_integer_matrix& m);

/// a basis of the lattice that the rows of m span
Big_integer_matrix row_lattice(Big_integer_matrix m);

/// whether the rows are a part of a basis of Z^n: independent, and spanning every integer vector of their span.
bool is_primitive(const Big_integer_matrix& rows);

/// m^-1, or nothing if m is not unimodular
std::optional<Big_integer_matrix> unimodular_inverse(const Big_integer_matrix& m);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_INTEGER_MATRIX_H
