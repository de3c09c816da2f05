// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_FACES_THAT_MAY_MEET_H
#define CGAL_QUARTIC_DIFFERENTIALS_FACES_THAT_MAY_MEET_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// the faces of a surface in space, in increasing order, that are not proved to meet every other face in a common edge or
/// vertex only, or not at all. All predicates are exact. None are left of most surfaces that do not meet themselves.
/// A proof is a plane that separates two faces: that of one of them, or one through an edge and parallel to an axis of
/// coordinates. Pairs of faces whose boxes are apart need none.
/// \pre the surface is embedded, as `is_embedded()` says
/// Complexity: O(n log n) where the boxes of few faces overlap.
std::vector<Face> faces_that_may_meet(const Intrinsic_triangulation& t);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_FACES_THAT_MAY_MEET_H
