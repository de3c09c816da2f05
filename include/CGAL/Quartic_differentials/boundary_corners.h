// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_BOUNDARY_CORNERS_H
#define CGAL_QUARTIC_DIFFERENTIALS_BOUNDARY_CORNERS_H

#include <CGAL/Quartic_differentials/divisor.h>

namespace CGAL {
namespace Quartic_differentials {

/// finds the corners of the boundary: the places where it turns by more than 67.5 degrees at once, as pinned
/// singularities at vertices, where m = max(1, round(angle / 90 degrees)) quads meet.
///
/// Every boundary curve, of length L, is unrolled into the plane and simplified (Douglas and Peucker) to within 0.9 of a
/// short edge, but at least L / 250 and at most L / 100, which takes away most of what is noisy or jagged. Turns are those
/// of the simplified curve, if they are still there from farther away. Smaller turns of one sign within L / 25 count
/// together, at the vertex in their middle: a short fillet is a corner, a circle has none.
///
/// Only lengths and angles matter: on triangulations with the same boundary edges and interior angles the corners are
/// the same. Not promised: what a person would choose; a file of corners can say it. Complexity: linear for the angles,
/// O(n^2) in the worst case for a boundary curve of n edges, O(n log n) mostly. Source: METHOD, "Surfaces with
/// boundary".
Divisor boundary_corners(const Intrinsic_triangulation& t);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_BOUNDARY_CORNERS_H
