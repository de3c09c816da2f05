// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_ARBITRARY_PRECISION_H
#define CGAL_QUARTIC_DIFFERENTIALS_ARBITRARY_PRECISION_H

#include <CGAL/Quartic_differentials/Quartic_differential.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/immersion.h>
#include <CGAL/Quartic_differentials/refined_surface.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A flat metric that was computed, and laid out, with a given number of binary digits.
struct Precise_immersion
{
  Quartic_differential differential;
  Immersion_report     immersion;
  Precision_report     precision;
  std::vector<double>  u;       ///< by vertex, rounded
  Eigen::VectorXd      moved;   ///< x, y by singularity, in the frames of their faces of the input
};

/// the error that a computation with this number of binary digits must reach: 2^(-0.78 bits), 1e-30 at 128 bits
double precision_tolerance(int bits);

/// makes the flat metric and its holonomy exact to `precision_tolerance(bits)` and lays it out in MPFR numbers:
/// `precise_cone_metric()`, then `immersion()`.
/// \param metric of which `refined` was made
/// \pre 64 <= bits <= 1024
/// \throws Numerical_error if the tolerance is not reached; see also the two functions
/// Source: METHOD, step 6, "Precision".
Precise_immersion precise_immersion(const Intrinsic_triangulation& input, const Cone_metric& metric,
                                    const Refined_cone_metric& refined, int bits, const Immersion_options& options,
                                    Visitor& visitor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_ARBITRARY_PRECISION_H
