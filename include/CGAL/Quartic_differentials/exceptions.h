// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_EXCEPTIONS_H
#define CGAL_QUARTIC_DIFFERENTIALS_EXCEPTIONS_H

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// Base of everything this package throws on account of its input; `what()` is one sentence for a person.
struct Error : std::runtime_error { using std::runtime_error::runtime_error; };

/// The surface cannot be used: the sentence names the reason and the place.
struct Unusable_surface_error : Error { using Error::Error; };

/// The divisor is refused for a mathematical reason (degree, rank of its Jacobian, colliding singularities, ...).
struct Infeasible_divisor_error : Error { using Error::Error; };

/// Singularities come too near each other, or the boundary, when the holonomy is made exact.
struct Colliding_singularities_error : Infeasible_divisor_error { using Infeasible_divisor_error::Infeasible_divisor_error; };

/// A step did not reach its tolerance; what was computed before it is still valid.
struct Numerical_error : Error { using Error::Error; };

/// The visitor asked to stop.
struct Cancelled_error : Error { using Error::Error; };

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_EXCEPTIONS_H
