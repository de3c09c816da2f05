// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/integer_matrix.h>

#include <limits>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

Big_integer_matrix widened(const Eigen::MatrixXi& m) { return m.unaryExpr([](int x) { return Integer(x); }); }

Eigen::MatrixXi narrowed(const Big_integer_matrix& m)
{
  return m.unaryExpr([](const Integer& x) {
    if (abs(x) > std::numeric_limits<short>::max())
      throw Numerical_error("a homology class has a coefficient beyond 16 bits");
    return static_cast<int>(x);
  });
}

int make_echelon(Big_integer_matrix& m)
{
  int rank = 0;
  for (int column = 0; column < m.cols() && rank < m.rows(); ++column)
    for (;;) {
      int least = -1, nonzero = 0;
      for (int i = rank; i < m.rows(); ++i)
        if (m(i, column) != 0) {
          ++nonzero;
          if (least < 0 || abs(m(i, column)) < abs(m(least, column))) least = i;
        }
      if (nonzero == 0) break;
      m.row(rank).swap(m.row(least));
      if (nonzero == 1) { ++rank; break; }
      for (int i = rank + 1; i < m.rows(); ++i) {
        const Integer q = m(i, column) / m(rank, column);
        if (q != 0) m.row(i) -= q * m.row(rank);
      }
    }
  return rank;
}

Big_integer_matrix row_lattice(Big_integer_matrix m)
{
  const int rank = make_echelon(m);
  return m.topRows(rank);
}

bool is_primitive(const Big_integer_matrix& rows)
{
  Big_integer_matrix columns = rows.transpose();
  if (make_echelon(columns) != rows.rows()) return false;
  for (int k = 0; k < rows.rows(); ++k)
    if (abs(columns(k, k)) != 1) return false;
  return true;
}

std::optional<Big_integer_matrix> unimodular_inverse(const Big_integer_matrix& m)
{
  const int n = static_cast<int>(m.rows());
  Big_integer_matrix both(n, 2 * n);
  both << m, Big_integer_matrix::Identity(n, n);
  make_echelon(both);
  for (int k = n - 1; k >= 0; --k) {
    if (abs(both(k, k)) != 1) return std::nullopt;
    if (both(k, k) < 0) both.row(k) *= Integer(-1);
    for (int i = 0; i < k; ++i) {
      const Integer q = both(i, k);
      if (q != 0) both.row(i) -= q * both.row(k);
    }
  }
  return Big_integer_matrix(both.rightCols(n));
}

} } } // namespace CGAL::Quartic_differentials::internal
