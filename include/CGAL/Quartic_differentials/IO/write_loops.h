// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_LOOPS_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_LOOPS_H

#include <CGAL/Quartic_differentials/handle_tunnel_loops.h>

#include <iosfwd>

namespace CGAL {
namespace Quartic_differentials {

/// writes `loops.obj`: every loop a closed polyline, a group named by `loop_name()` and `loop_kind()`.
/// \pre `t` is the surface on which the loops were found
/// \throws Unusable_surface_error if `t` is not embedded
/// Complexity: linear in the output.
void write_loops_obj(std::ostream& out, const Intrinsic_triangulation& t, const Handle_tunnel_loops& loops);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_LOOPS_H
