// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_HYPERELLIPTIC_PERIODS_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_HYPERELLIPTIC_PERIODS_H

// Periods of hyperelliptic curves y^2 = (x - e_0) (x - e_1) ..., independently of any triangulation.
//   gamma_k  the cycle over the segment e_(k-1) e_k of a simple chain: forth in one sheet, back in the other, directed
//            so that gamma_k . gamma_(k+1) = 1; other intersection numbers are 0. k = 1 .. 2g; rows below are k - 1.
//   P        2g x g, row k: the integrals of x^j dx/y, j = 0 .. g-1, over gamma_k

#include <Eigen/Dense>

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace Quartic_test {

using Complex = std::complex<double>;

/// the intersection numbers of a chain of n cycles
inline Eigen::MatrixXi chain_intersections(int n)
{
  Eigen::MatrixXi k = Eigen::MatrixXi::Zero(n, n);
  for (int i = 0; i + 1 < n; ++i) {
    k(i, i + 1) = 1;
    k(i + 1, i) = -1;
  }
  return k;
}

/// a canonical basis in terms of the chain: a_i = gamma_(2i-1), b_i = Sum_(k>=i) gamma_(2k)
inline Eigen::MatrixXi canonical_from_chain(int g)
{
  Eigen::MatrixXi u = Eigen::MatrixXi::Zero(2 * g, 2 * g);
  for (int i = 0; i < g; ++i) {
    u(i, 2 * i) = 1;
    for (int k = i; k < g; ++k) u(g + i, 2 * k + 1) = 1;
  }
  return u;
}

/// Pi in that basis
inline Eigen::MatrixXcd periods_of_chain(const Eigen::MatrixXcd& p)
{
  const Eigen::MatrixXcd canonical = canonical_from_chain(static_cast<int>(p.cols())).cast<Complex>() * p;
  return canonical.bottomRows(p.cols()) * canonical.topRows(p.cols()).inverse();
}

/// P of y^2 = x^(2g+2) - 1 in closed form, for the chain of the 2g+2 roots of unity counterclockwise, and other
/// multiples of the same forms. The automorphism (x, y) -> (zeta x, y), zeta = exp(2 pi i / (2g+2)), takes gamma_k to
/// gamma_(k+1) and multiplies x^j dx/y by zeta^(j+1).
inline Eigen::MatrixXcd roots_of_unity_chain(int g)
{
  Eigen::MatrixXcd p(2 * g, g);
  for (int k = 0; k < 2 * g; ++k)
    for (int j = 0; j < g; ++j) p(k, j) = std::polar(1.0, 2 * std::acos(-1.0) * k * (j + 1) / (2 * g + 2));
  return p;
}

/// the period matrix of y^2 = x^(2g+2) - 1, in closed form
inline Eigen::MatrixXcd hyperelliptic_periods(int g) { return periods_of_chain(roots_of_unity_chain(g)); }

/// P by Gauss-Chebyshev quadrature, to rounding.
///
/// On the segment x = m + d t, -1 <= t <= 1, between neighbours, y = i d sqrt(1-t^2) R(t), where R is an analytic
/// root of the product over the other points: the integrals have Chebyshev's weight, and the number of nodes is
/// doubled until they do not change any more. At e_k the root is continued from a segment to the next clockwise,
/// which makes gamma_k . gamma_(k+1) = 1: in the local parameter sqrt(x - e_k) both cycles are straight lines.
class Chain_quadrature
{
public:
  /// \param points 2g+2 points whose polygonal chain does not meet itself, the last may be (complex) infinity
  explicit Chain_quadrature(std::vector<Complex> points) : m_e(std::move(points))
  {
    m_genus = static_cast<int>(m_e.size()) / 2 - 1;
    if (std::isinf(std::abs(m_e.back()))) m_e.pop_back();   // its factor is missing in y^2
  }

  Eigen::MatrixXcd periods() const
  {
    Eigen::MatrixXcd p(2 * m_genus, m_genus);
    double sign = 1;
    for (int k = 0; k < 2 * m_genus; ++k) {
      if (k > 0) sign *= continued(k);
      p.row(k) = sign * converged_row(k);
    }
    return p;
  }

private:
  Complex middle(int k) const { return 0.5 * (m_e[k] + m_e[k + 1]); }
  Complex half(int k) const { return 0.5 * (m_e[k + 1] - m_e[k]); }

  // R(t): every factor's principal root relative to its value in the middle is continuous along the segment
  Complex root(int k, double t) const
  {
    Complex r = 1;
    for (int l = 0; l < static_cast<int>(m_e.size()); ++l) {
      if (l == k || l == k + 1) continue;
      const Complex from_middle = middle(k) - m_e[l];
      r *= std::sqrt(from_middle) * std::sqrt(1.0 + half(k) * t / from_middle);
    }
    return r;
  }

  // +1 or -1: the root on segment k that continues the one of segment k-1 clockwise round e_k. Near e_k
  // y = F(x) sqrt(x - e_k), and F(e_k) is the same from both sides.
  double continued(int k) const
  {
    const double turn = 2 * std::acos(-1.0);
    const double before = std::arg(-half(k - 1));
    double after = std::arg(half(k));
    while (after >= before) after -= turn;
    const Complex f_before = half(k - 1) * root(k - 1, 1) / std::polar(std::sqrt(std::abs(half(k - 1))), before / 2);
    const Complex f_after = half(k) * root(k, -1) / std::polar(std::sqrt(std::abs(half(k))), after / 2);
    return (f_before / f_after).real() > 0 ? 1 : -1;
  }

  Eigen::RowVectorXcd row(int k, int nodes) const
  {
    const double pi = std::acos(-1.0);
    Eigen::RowVectorXcd sum = Eigen::RowVectorXcd::Zero(m_genus);
    for (int n = 0; n < nodes; ++n) {
      const double t = std::cos(pi * (n + 0.5) / nodes);
      Complex term = 2 * pi / nodes / (Complex(0, 1) * root(k, t));   // forth and back: twice the integral
      for (int j = 0; j < m_genus; ++j, term *= middle(k) + half(k) * t) sum[j] += term;
    }
    return sum;
  }

  Eigen::RowVectorXcd converged_row(int k) const
  {
    Eigen::RowVectorXcd previous = row(k, 32);
    for (int nodes = 64; nodes <= 65536; nodes *= 2) {
      const Eigen::RowVectorXcd next = row(k, nodes);
      if ((next - previous).cwiseAbs().maxCoeff() < 1e-14 * next.cwiseAbs().maxCoeff()) return next;
      previous = next;
    }
    return previous;
  }

  std::vector<Complex> m_e;
  int                  m_genus;
};

inline Eigen::MatrixXcd chain_periods(const std::vector<Complex>& points) { return Chain_quadrature(points).periods(); }

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_HYPERELLIPTIC_PERIODS_H
