// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_SINGULARITIES_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_SINGULARITIES_H

#include <CGAL/Quartic_differentials/divisor.h>

#include <iosfwd>

namespace CGAL {
namespace Quartic_differentials {

/// reads a divisor: lines `x y z order [pinned]`, `#` begins a comment; every point is taken to the nearest point of the
/// surface.
/// \throws Infeasible_divisor_error naming the line that cannot be read, or if `surface` is not embedded
/// Complexity: O(n) to build a search tree, O(log n) a line.
Divisor read_singularities(std::istream& in, const Intrinsic_triangulation& surface);

/// writes a divisor but for its corners in the form that `read_singularities` reads, with coordinates that read back to
/// the same doubles.
/// \param divisor on the faces of `surface`
/// \throws Unusable_surface_error if `surface` is not embedded
void write_singularities(std::ostream& out, const Divisor& divisor, const Intrinsic_triangulation& surface);

/// reads corners of the boundary: lines `x y z m [pinned]`, m the number of quads at the corner, `#` begins a comment;
/// every point is taken to the nearest point of the boundary.
/// \throws Infeasible_divisor_error naming the line that cannot be read, that has m < 1 or m = 2, which is no corner,
///         or whose point is farther from the boundary than 0.05 * sqrt(area); or if `surface` is not embedded, or has no
///         boundary
/// Complexity: O(n) to build a search tree of the boundary, O(log n) a line.
Divisor read_corners(std::istream& in, const Intrinsic_triangulation& surface);

/// writes the corners of a divisor in the form that `read_corners` reads, with coordinates that read back to the same
/// doubles.
/// \param divisor on the faces of `surface`
/// \throws Unusable_surface_error if `surface` is not embedded
void write_corners(std::ostream& out, const Divisor& divisor, const Intrinsic_triangulation& surface);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_SINGULARITIES_H
