// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_JACOBIAN_POINT_H
#define CGAL_QUARTIC_DIFFERENTIALS_JACOBIAN_POINT_H

#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <Eigen/Core>

namespace CGAL {
namespace Quartic_differentials {

/// A point s + Pi t of the Jacobian C^g / (Z^g + Pi Z^g).
struct Jacobian_point
{
  Eigen::VectorXd  s, t;    ///< in [-1/2, 1/2]
  Eigen::VectorXcd image;   ///< s + Pi t

  /// the largest coordinate: 0 at the origin, at most 1/2. It depends on the canonical basis, but not whether it is 0.
  double distance_from_origin() const;
};

/// maps a divisor to the Jacobian. By Abel's theorem the image of a divisor of degree 0 is the origin if and only if it
/// is the divisor of a meromorphic function: D and E are linearly equivalent if and only if D - E goes to the origin.
/// Otherwise a divisor of degree 8g - 8 is compared with that of a quartic differential, four times a canonical divisor:
/// it goes to the origin if and only if it is the divisor of one. On a mesh that holds up to the discretisation, O(h^2)
/// on smooth surfaces.
/// \param divisor on the faces of the input of `s`
/// \pre `s` was made from an `Intrinsic_triangulation`, not from a coarsened surface
/// \throws Infeasible_divisor_error if the degree is neither 0 nor 8g - 8
/// Complexity: linear.
/// Source: METHOD, step 4; paper, section 4.4.
Jacobian_point jacobian_point(const Riemann_surface& s, const Divisor& divisor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_JACOBIAN_POINT_H
