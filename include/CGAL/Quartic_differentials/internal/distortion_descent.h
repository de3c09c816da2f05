// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DISTORTION_DESCENT_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DISTORTION_DESCENT_H

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/internal/Moving_divisor.h>
#include <CGAL/Quartic_differentials/minimize_distortion.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Where a descent ended.
struct Descent
{
  Moving_divisor               divisor;
  Eigen::VectorXd              u;         ///< of the divisor
  std::vector<Distortion_step> history;   ///< of the start, and after every step

  double distortion() const { return history.back().distortion; }
};

/// moves a divisor to a local minimum of the area distortion plus the guard, see `minimize_distortion()`.
/// \param lattice_vector m: the divisor stays on F = (pi/2) m, where it must be already; none: it moves freely
Descent descend(const Area_distortion& distortion, const Moving_divisor& start,
                const std::optional<Eigen::VectorXd>& lattice_vector, const Distortion_options& options,
                Visitor& visitor);

/// The penalty on singularities that are nearer to each other, or to the boundary, than a distance, and its derivative
/// by the positions (in the unfolded frames of their faces; of corners along the boundary, and 0).
struct Distance_guard
{
  double          value;
  Eigen::VectorXd gradient;

  Distance_guard& operator+=(const Distance_guard& other)
  {
    value += other.value;
    gradient += other.gradient;
    return *this;
  }
};
/// of pairs of singularities.
/// \param distance in surface units
Distance_guard distance_guard(const Intrinsic_triangulation& t, const Divisor& divisor, double distance, double strength);
/// of singularities in the interior and the boundary
Distance_guard boundary_guard(const Intrinsic_triangulation& t, const Divisor& divisor, double distance,
                              double strength);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DISTORTION_DESCENT_H
