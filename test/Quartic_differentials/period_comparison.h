// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_PERIOD_COMPARISON_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_PERIOD_COMPARISON_H

// Period matrices up to the choice of the canonical basis, that is modulo Sp(2g, Z).

#include <CGAL/Quartic_differentials/closest_vector.h>
#include <CGAL/Quartic_differentials/homology_basis.h>

#include <Eigen/Dense>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace Quartic_test {

using Complex = std::complex<double>;

/// The Dirichlet products of the harmonic forms dual to the basis, for Pi = X + iY (METHOD, "Ground truth", in the
/// order a, b): [[Y^-1, Y^-1 X], [X Y^-1, Y + X Y^-1 X]].
inline Eigen::MatrixXd gram_of_periods(const Eigen::MatrixXcd& pi)
{
  const Eigen::Index g = pi.rows();
  const Eigen::MatrixXd x = pi.real(), inverse = pi.imag().inverse();
  Eigen::MatrixXd s(2 * g, 2 * g);
  s << inverse, inverse * x, x * inverse, pi.imag() + x * inverse * x;
  return s;
}

/// Pi from its Gram matrix
inline Eigen::MatrixXcd periods_of_gram(const Eigen::MatrixXd& s)
{
  const Eigen::Index g = s.rows() / 2;
  const Eigen::MatrixXcd right = s.topRightCorner(g, g) + Complex(0, 1) * Eigen::MatrixXd::Identity(g, g);
  return s.topLeftCorner(g, g).cast<Complex>().inverse() * right;
}

/// The least max |U S U^T - S_true| over the symplectic changes of basis U for which it is within `tolerance`, infinity
/// if there is none, and the same for the period matrices. By backtracking over short vectors.
class Symplectic_match
{
public:
  Symplectic_match(const Eigen::MatrixXd& s, const Eigen::MatrixXcd& truth, double tolerance)
    : m_s(s), m_truth(gram_of_periods(truth)), m_pi_truth(truth), m_tolerance(tolerance),
      m_j(CGAL::Quartic_differentials::symplectic_unit(static_cast<int>(truth.rows())).cast<double>())
  {
    namespace Q = CGAL::Quartic_differentials;
    Q::Closest_vector_options options;
    options.count = 4000;
    const Eigen::Index n = m_s.rows();
    for (const Q::Lattice_vector& v : Q::closest_vectors(m_s, Eigen::VectorXd::Zero(n), options).vectors) {
      Eigen::VectorXd x(n);
      for (Eigen::Index k = 0; k < n; ++k) x[k] = static_cast<double>(v.coefficients[k]);
      m_short.push_back(x);
    }
    extend();
  }

  double of_gram_matrices() const { return m_gram_distance; }
  double of_period_matrices() const { return m_period_distance; }

private:
  void extend()
  {
    const Eigen::Index k = static_cast<Eigen::Index>(m_rows.size());
    if (k == m_s.rows()) {
      Eigen::MatrixXd u(k, k);
      for (Eigen::Index i = 0; i < k; ++i) u.row(i) = m_rows[i];
      const Eigen::MatrixXd s = u * m_s * u.transpose();
      m_gram_distance = std::min(m_gram_distance, (s - m_truth).cwiseAbs().maxCoeff());
      m_period_distance = std::min(m_period_distance, (periods_of_gram(s) - m_pi_truth).cwiseAbs().maxCoeff());
      return;
    }
    if (m_tries > 200000) return;
    for (const Eigen::VectorXd& v : m_short) {
      if (std::abs(v.dot(m_s * v) - m_truth(k, k)) > m_tolerance) continue;
      ++m_tries;
      bool fits = true;
      for (Eigen::Index i = 0; i < k && fits; ++i)
        fits = std::lround(v.dot(m_j * m_rows[i])) == std::lround(m_j(k, i))
            && std::abs(v.dot(m_s * m_rows[i]) - m_truth(k, i)) <= m_tolerance;
      if (!fits) continue;
      m_rows.push_back(v);
      extend();
      m_rows.pop_back();
    }
  }

  Eigen::MatrixXd              m_s, m_truth;
  Eigen::MatrixXcd             m_pi_truth;
  double                       m_tolerance;
  Eigen::MatrixXd              m_j;
  std::vector<Eigen::VectorXd> m_short, m_rows;
  double                       m_gram_distance = std::numeric_limits<double>::infinity();
  double                       m_period_distance = std::numeric_limits<double>::infinity();
  int                          m_tries = 0;
};

inline double distance_modulo_symplectic(const Eigen::MatrixXcd& pi, const Eigen::MatrixXcd& truth, double tolerance)
{
  return Symplectic_match(gram_of_periods(pi), truth, tolerance).of_period_matrices();
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_PERIOD_COMPARISON_H
