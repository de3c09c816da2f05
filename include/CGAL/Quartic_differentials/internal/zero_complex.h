// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_ZERO_COMPLEX_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_ZERO_COMPLEX_H

#include <CGAL/Quartic_differentials/t_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The inequality: the q of these arcs sum to 1 or more.
struct Separating_cut
{
  std::vector<std::size_t> arcs;       ///< sorted
  bool                     is_valid;   ///< every quantization satisfies it
};

/// the paths and loops of the zero complex X of q that must not shrink; none if and only if every component of X has
/// Euler characteristic 1 and at most one singularity, and meets the boundary nowhere, or in a connected part and
/// without a singularity inside the surface.
///
/// They are shortest paths between singularities, one for every two whose regions in X are neighbours, in the same way
/// between components of X on the boundary and from these to singularities inside, and the fundamental loops of a
/// spanning forest once the patches of size 0 x 0 have been collapsed. If there are any without
/// chords, those alone are returned; if some of them are valid inequalities, only these.
/// \pre no q is negative, and opposite sides of every patch have the same sum
/// Complexity: linear in the arcs and in the points on them, times the cuts.
/// Source: METHOD, "Quantization".
std::vector<Separating_cut> separating_cuts(const T_mesh& t, const std::vector<int>& q);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_ZERO_COMPLEX_H
