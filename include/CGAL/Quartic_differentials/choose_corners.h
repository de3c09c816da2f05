// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_CHOOSE_CORNERS_H
#define CGAL_QUARTIC_DIFFERENTIALS_CHOOSE_CORNERS_H

#include <CGAL/Quartic_differentials/choose_singularities.h>

namespace CGAL {
namespace Quartic_differentials {

/// chooses the corners of the boundary and the singularities of a surface with boundary.
///
/// Corners are those of `boundary_corners()`. They stay at their vertices, and singularities make good what they leave open
/// to the Abel-Jacobi condition, unless that is impossible, or corners that slide a little, by at most 0.03 * sqrt(area),
/// have a lower price: the distortion, and half of `options.worth` for every singularity. In the result they are pinned,
/// or not.
/// \param given singularities that must be part of it besides
/// \throws Infeasible_divisor_error as `choose_singularities()` does, if both ways fail
/// Complexity: that of `choose_singularities()`, twice where the corners alone are not enough.
/// Source: METHOD, "Surfaces with boundary".
Chosen_singularities choose_corners_and_singularities(const Riemann_surface& surface, const Divisor& given,
                                                      const Singularity_choice_options& options,
                                                      const Legalization_options& legalization,
                                                      const Distortion_options& distortion, Visitor& visitor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_CHOOSE_CORNERS_H
