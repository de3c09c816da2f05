// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_MINIMIZE_DISTORTION_H
#define CGAL_QUARTIC_DIFFERENTIALS_MINIMIZE_DISTORTION_H

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/period_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// Steps and limits of `minimize_distortion()`.
struct Distortion_options
{
  int    iterations      = 100;
  double enough          = 1e-4;    ///< ends when five iterations lower the objective by less than this part of it
  double longest_step    = 0.05;    ///< of any singularity in one step, times sqrt(area)
  double guard_distance  = 0.023;   ///< nearer singularities repel each other, times sqrt(area)
  double guard_strength  = 0.1;     ///< the guard adds this times (1 - distance / guard_distance)^2 for every pair
  double boundary_distance = 0.05;  ///< singularities nearer to the boundary are driven away likewise, times sqrt(area)
  double tolerance       = 1e-11;   ///< |F - (pi/2) m| after every step, radians
  int    memory          = 20;      ///< number of steps from which the curvature of E is estimated
};

/// The state after an accepted step.
struct Distortion_step
{
  double distortion;   ///< E
  double objective;    ///< E and the guard: decreases in every step
  double residual;     ///< |F - (pi/2) m|, radians
  double length;       ///< the longest way of a singularity in this step, surface units; 0 at the start
};

/// A legal divisor of locally least area distortion.
struct Optimal_divisor
{
  Legal_divisor                legal;     ///< its `history` is that of legalizing the start, `moved_by` from the start
  std::vector<Distortion_step> history;   ///< of the legalized start, and after every step
  double                       distortion;   ///< E of the result
  double                       area_scale_before, area_scale_after;   ///< 99% / 1% quantile ratio of e^2u, linearised
};

/// legalizes a divisor and moves it, on the Abel-Jacobi variety, to a local minimum of the area distortion E.
///
/// A projected quasi-Newton method (L-BFGS): gradients and directions are projected on the kernel of the derivative
/// of F, every step walks along the surface and is followed by Gauss-Newton steps back to F = (pi/2) m; what is
/// accepted lowers the objective (Armijo) and satisfies the Abel-Jacobi condition to `tolerance`. One solve gives the
/// gradient for all singularities. Orders and number stay; pinned singularities stay where they are, and corners on the
/// boundary. At last the ones that reached a vertex in the interior move a few hundredths of an edge away from it.
/// Not promised: a global minimum. E has kinks where singularities cross edges; when they stop the line search, the
/// result is as good as the mesh resolves.
/// \param distortion of `map.triangulation()`
/// \param periods not used on a surface with boundary, where the norm must be that of the least movement
/// \throws everything that `legalize_divisor()` throws
/// Complexity: two back-substitutions a step, one more for every step that is refused.
/// Source: METHOD, "Choosing the singularities".
Optimal_divisor minimize_distortion(const Area_distortion& distortion, const Abel_jacobi_map& map,
                                    const Period_matrix& periods, const Divisor& divisor,
                                    const Legalization_options& legalization, const Distortion_options& options,
                                    Visitor& visitor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_MINIMIZE_DISTORTION_H
