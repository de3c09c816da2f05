// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_REQUIRE_EMBEDDED_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_REQUIRE_EMBEDDED_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// throws Unusable_surface_error if the vertices of `t` have no positions in space.
/// \param purpose what needs them, the beginning of a sentence
inline void require_embedded(const Intrinsic_triangulation& t, const char* purpose)
{
  if (!t.is_embedded())
    throw Unusable_surface_error(std::string(purpose) + " needs positions in space, but the surface is known by its "
                                 "edge lengths alone");
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_REQUIRE_EMBEDDED_H
