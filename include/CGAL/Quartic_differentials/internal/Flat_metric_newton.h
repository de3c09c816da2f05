// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLAT_METRIC_NEWTON_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLAT_METRIC_NEWTON_H

#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/refined_surface.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The linear part of Newton's method for the curvatures K and the turning numbers T together, in doubles.
///
/// With g the potentials of the harmonic forms of the flat metric, moving the cones by delta and the curvatures by dK
/// changes T by J delta + g^T dK. So dK = -(K - target) and J delta = -((T - multiples of pi/2) - g^T (K - target)); the
/// scales follow from dK = L du + (the change of K by delta alone).
/// (METHOD, step 6, "Precision")
class Flat_metric_newton
{
public:
  /// one sparse factorisation and 2g back-substitutions; keeps a reference to `metric`
  Flat_metric_newton(const Refined_cone_metric& metric, std::size_t singularities);

  /// displacements of the cones, two entries (x, y in the frame of its face of the input) a singularity, of least norm
  /// \throws Numerical_error if the cones that may move cannot correct the turning
  Eigen::VectorXd cones(const Eigen::VectorXd& curvature_error, const Eigen::VectorXd& turning_error) const;
  /// changes of the log scales, where the cones are displaced as well
  Eigen::VectorXd scales(const Eigen::VectorXd& curvature_error, const Eigen::VectorXd& displacement) const;
  /// a singularity stays where it is from now on
  void hold(std::size_t singularity) { m_derivative.middleCols(2 * singularity, 2).setZero(); }

private:
  const Refined_cone_metric& m_metric;
  std::vector<double>        m_angles;
  Laplacian_solver           m_laplacian;
  Eigen::MatrixXd            m_potential;    // g, by vertex
  Eigen::MatrixXd            m_derivative;   // J
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLAT_METRIC_NEWTON_H
