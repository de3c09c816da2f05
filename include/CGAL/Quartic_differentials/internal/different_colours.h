// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DIFFERENT_COLOURS_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DIFFERENT_COLOURS_H

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// gives every one of `size` things one of the colours 0 .. colours-1, neighbours different ones, and every colour to
/// about as many things as any other.
///
/// Things are coloured in smallest-last order, so that few of a thing's neighbours have a colour when its turn comes:
/// at most 5 on a sphere, 6 on a torus, and O(sqrt(g)) in genus g. Where these have used up the colours, neighbours
/// share one.
/// \param neighbours pairs of things, of which (i, i) says nothing
/// \pre `colours > 0`
/// Complexity: O(n log n). Source: Matula, Beck 1983.
std::vector<std::size_t> different_colours(std::size_t size, std::size_t colours,
                                           const std::set<std::pair<std::size_t, std::size_t>>& neighbours);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DIFFERENT_COLOURS_H
