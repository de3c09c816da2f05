// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_DIRECTION_FIELD_H
#define CGAL_QUARTIC_DIFFERENTIALS_DIRECTION_FIELD_H

#include <CGAL/Quartic_differentials/divisor.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation; "rescaled": angles round a vertex times 2 pi / (their sum)
//   phi(h)    direction of h at its source, counterclockwise, rescaled
//   beta(h)   rescaled corner angle at the source of h in its face
//   z_v       fourth power of the directions at v: turning them by a turns z_v by 4 a
//   rho(h)    4 (phi(opposite h) - phi(h)): parallel transport along h turns z by rho
//   C         the energy sum_e w_e |z_target - e^(i rho) z_source|^2 (connection Laplacian)
//   M         diagonal of vertex areas
//   On a boundary vertex where m quads meet (m = 2 but for corners) angles are rescaled to the sum m pi / 2.
//   dl(h)     the angle in [-pi, pi] from the transported z_source to z_target; dl(opposite h) = -dl(h)

/// computes the singularities of the smoothest 4-direction field, as a divisor of simple zeros and poles.
///
/// The field z is the eigenvector of C z = lambda M z for the least eigenvalue, and its order in a face is
/// -(sum of dl + 4 (sum of beta - pi)) / 2 pi. Where z vanishes at a vertex it counts as 1, so that the orders are
/// integers and sum up to 8g - 8 for every z whatsoever. A face of higher order gets as many simple singularities at
/// different places.
///
/// On a surface with boundary the field follows it, z = 1 there, and has least energy under that condition; corners
/// count at the nearest vertices. The orders and those of the corners sum up to 8g - 8 + 4b.
///
/// Where the least eigenvalue is multiple (surfaces with symmetries), the field and its singularities depend on `seed`.
/// \param weights cotangent weights of the edges
/// \param seed of the eigenvector iteration's start
/// \param corners of the boundary; they are not part of the result
/// \pre `t` is an intrinsic Delaunay triangulation
/// \post the degree is 8g - 8 + 4b, less that of the corners
/// \throws Numerical_error if the triangulation is numerically degenerate
/// Complexity: one factorisation of a matrix of twice the size of the Laplacian, at most 60 back-substitutions.
/// Source: Knoeppel, Crane, Pinkall and Schroeder, "Globally optimal direction fields", 2013.
Divisor direction_field_divisor(const Intrinsic_triangulation& t, const std::vector<double>& weights, unsigned seed,
                                const Divisor& corners = {});

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_DIRECTION_FIELD_H
