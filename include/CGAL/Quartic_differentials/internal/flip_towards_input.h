// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLIP_TOWARDS_INPUT_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLIP_TOWARDS_INPUT_H

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/Quartic_differential.h>

#include <cstddef>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// flips edges of the flat triangulation C inside their charts, exactly on the grid, as long as that makes fewer edges of
/// A cross it, and returns the number of flips. The flat surface stays the same; edges of A are straightened in it.
///
/// Not flipped: edges on seams; where a triangle would be lower than 2^12 grid units; where an A edge would move, along
/// the edge that is flipped, by more than a tenth of its distance from the next one.
/// \param refinement of A and C, with weights in the flat metric
/// \param flat on C, whose triangulation has its lengths in the plane
/// Complexity: linear in the edges of C and the flips, times the crossings at an edge.
/// Source: METHOD, step 7, "The map on the input surface".
std::size_t flip_towards_input(Common_refinement& refinement, Quartic_differential& flat);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLIP_TOWARDS_INPUT_H
