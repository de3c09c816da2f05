// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/internal/Flat_metric_newton.h>

#include <Eigen/Dense>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

Flat_metric_newton::Flat_metric_newton(const Refined_cone_metric& metric, std::size_t singularities)
  : m_metric(metric), m_angles(corner_angles(metric.triangulation, metric.lengths))
{
  const Intrinsic_triangulation& t = metric.triangulation;
  const std::vector<double> weights = cotangent_weights(t, metric.lengths);
  m_laplacian.factorize(t, weights);
  const Harmonic_1_forms omega = harmonic_1_forms(t, metric.cochains, weights, m_laplacian);
  m_potential = omega.potential;
  m_derivative = turning_derivative(t, m_angles, metric.derivatives, singularities, omega);
}

Eigen::VectorXd Flat_metric_newton::cones(const Eigen::VectorXd& curvature_error,
                                          const Eigen::VectorXd& turning_error) const
{
  if (m_derivative.size() == 0) return Eigen::VectorXd::Zero(m_derivative.cols());
  const Eigen::FullPivLU<Eigen::MatrixXd> normal(m_derivative * m_derivative.transpose());
  if (!normal.isInvertible())
    throw Numerical_error("the singularities that may move cannot make the holonomy exact to the wanted precision");
  return -m_derivative.transpose() * normal.solve(turning_error - m_potential.transpose() * curvature_error);
}

Eigen::VectorXd Flat_metric_newton::scales(const Eigen::VectorXd& curvature_error,
                                           const Eigen::VectorXd& displacement) const
{
  const Eigen::VectorXd change = curvature_change(m_metric.triangulation, m_angles, m_metric.derivatives, displacement);
  const Eigen::ArrayXd error = curvature_error + change;
  // the errors add up to zero (Gauss-Bonnet) but for rounding, which is spread evenly
  return -m_laplacian.solve((error - error.mean()).matrix()).col(0);
}

} } } // namespace CGAL::Quartic_differentials::internal
