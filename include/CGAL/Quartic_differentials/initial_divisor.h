// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INITIAL_DIVISOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_INITIAL_DIVISOR_H

#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/laplacian.h>

namespace CGAL {
namespace Quartic_differentials {

/// chooses simple poles at maxima and simple zeros at minima of the smoothed Gaussian curvature of a closed surface.
///
/// Without a count, the least number of singularities is taken, of ten from the minimum |8g-8| to 64 more, whose
/// linearised flat metric has a range of scales within 1.1 times the least.
/// \param count number of singularities; the next count of the right parity is taken; 0: automatic
/// \throws Infeasible_divisor_error if the surface has no room for that many
/// Complexity: one factorisation for the smoothing, one back-substitution for every count tried.
/// Source: METHOD, step 5; paper, section 4.5.
Divisor curvature_divisor(const Intrinsic_triangulation& t, const std::vector<double>& weights,
                          const Laplacian_solver& laplacian, int count);

/// adds simple poles at maxima, or simple zeros at minima, of the smoothed curvature until the degree is 8g - 8 + 4b;
/// never near the boundary.
Divisor with_repaired_degree(const Intrinsic_triangulation& t, const std::vector<double>& weights, Divisor divisor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_INITIAL_DIVISOR_H
