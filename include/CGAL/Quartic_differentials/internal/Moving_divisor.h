// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_MOVING_DIVISOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_MOVING_DIVISOR_H

#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/divisor.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A divisor on its way over the surface. A vector of displacements has two entries a singularity, in the frame that
/// is transported along its way: so displacements and gradients at different times can be added and compared. Of a corner
/// the first is the way along the boundary, the second 0.
class Moving_divisor
{
public:
  Moving_divisor(const Abel_jacobi_map& map, const Divisor& divisor);

  std::size_t size() const { return m_divisor.size(); }
  const Divisor& divisor() const { return m_divisor; }
  /// length of the way of each singularity so far, surface units
  const std::vector<double>& moved_by() const { return m_moved_by; }

  /// F of the Abel-Jacobi map
  Eigen::VectorXd residual() const { return m_map->residual(m_points, m_orders); }
  /// the derivative of F; no column where a singularity is pinned
  Eigen::MatrixXd jacobian() const;
  /// a vector in the unfolded frames of the singularities' faces in the transported frames; 0 where they are pinned
  Eigen::VectorXd in_transported_frames(const Eigen::VectorXd& in_faces) const;

  void move(const Eigen::VectorXd& step);

private:
  const Abel_jacobi_map* m_map;
  Divisor                m_divisor;
  Lifted_divisor         m_points;
  std::vector<int>       m_orders;
  std::vector<double>    m_moved_by;
};

/// the m for which (pi/2) m is nearest to F, by coordinates
Eigen::VectorXd rounded_to_lattice(const Eigen::VectorXd& f);

/// whether a divisor satisfies the Abel-Jacobi condition where it is: |F - (pi/2) m| on sheet 0 is at most the
/// tolerance, or, if nothing of it may move, at most 1e-15 for every vertex, which is what rounding leaves of F. The
/// empty divisor does wherever it has the right degree.
bool is_legal(const Abel_jacobi_map& map, const Divisor& divisor, double tolerance);

/// the length of the longest of the displacements
double longest_move(const Eigen::VectorXd& step);

struct Newton_limits
{
  double tolerance;      ///< |F - (pi/2) m|, radians
  int    iterations;
  double longest_step;   ///< of any singularity in one step, surface units
};

/// moves a divisor to F = (pi/2) m by Gauss-Newton steps of minimal norm, damped (Levenberg) where the full step does
/// not help, and returns whether the tolerance was reached.
/// \param history |F - (pi/2) m| before the first and after every step
/// \throws Cancelled_error if the visitor asks to stop
bool move_onto_lattice(Moving_divisor& d, const Eigen::VectorXd& m, const Newton_limits& limits,
                       std::vector<double>& history, Visitor& visitor);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_MOVING_DIVISOR_H
