// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_SAMPLE_BOUNDARIES_H
#define CGAL_QUARTIC_DIFFERENTIALS_SAMPLE_BOUNDARIES_H

#include <CGAL/Quartic_differentials/sample_surfaces.h>

namespace CGAL {
namespace Quartic_differentials {

// More surfaces with boundary; plate() and with_disks_cut_out() of sample_surfaces.h are round. All are deterministic
// and free of removed elements.

/// the square plate of 3 x 2, or the L, 3 x 3 without a square of 1.5 x 1.5
enum class Plate_shape { rectangle, l };

/// a flat plate of squares, cut along their diagonals, with `holes` square holes of side 0.5: genus 0, `holes` + 1
/// boundary curves. `resolution` is the number of squares along a unit of length, to which sides are rounded.
/// \pre `0 <= holes <= 4`, `resolution >= 6`. Complexity: O(resolution^2).
Mesh plate(Plate_shape shape, int holes, int resolution);

/// the mesh without `count` disks as with_disks_cut_out() makes them, about vertices the first of which `seed` chooses.
/// \pre as there
/// \throws Unusable_surface_error as there
/// Complexity: `count` shortest-path trees.
Mesh with_disks_cut_out(const Mesh& mesh, int count, double radius, unsigned seed);

/// the part of the mesh in front of a plane, the one through the middle of the bounding box with this normal: its
/// triangles have all their corners there. The boundary is jagged therefore.
/// \pre `mesh` is a triangle mesh without removed elements
/// \throws Unusable_surface_error if the part is not connected, or there is nothing in front of the plane or behind it
/// Complexity: linear.
Mesh part_in_front(const Mesh& mesh, const Vector_3& normal);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_SAMPLE_BOUNDARIES_H
