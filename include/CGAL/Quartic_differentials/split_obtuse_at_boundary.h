// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_SPLIT_OBTUSE_AT_BOUNDARY_H
#define CGAL_QUARTIC_DIFFERENTIALS_SPLIT_OBTUSE_AT_BOUNDARY_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/divisor.h>

#include <cstddef>

namespace CGAL {
namespace Quartic_differentials {

/// splits boundary edges until no triangle of the intrinsic Delaunay triangulation is obtuse opposite a boundary edge, and
/// returns the number of vertices added.
///
/// Boundary edges cannot be flipped. An obtuse angle opposite one gives it a negative weight, and the discrete Ricci flow
/// can make it reach a straight angle; it is split at the foot of the triangle's altitude instead, then edges are flipped
/// to Delaunay, and so on. The triangles of `t` are its own: only its boundary edges are split, at the places where the
/// Delaunay triangulation needs it, so that the surface and its other edges stay what they are.
/// \throws Numerical_error if this does not end after as many splits as the triangulation has edges, and 1000
/// Complexity: that of Delaunay flips for every round; the rounds are few (not proved).
/// Source: METHOD, "Surfaces with boundary".
std::size_t split_obtuse_at_boundary(Intrinsic_triangulation& t);

/// the same with a divisor on the faces of `t`, whose singularities stay where they are on the surface
std::size_t split_obtuse_at_boundary(Intrinsic_triangulation& t, Divisor& divisor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_SPLIT_OBTUSE_AT_BOUNDARY_H
