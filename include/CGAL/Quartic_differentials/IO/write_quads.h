// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_QUADS_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_QUADS_H

#include <CGAL/Quartic_differentials/quad_mesh.h>

#include <iosfwd>

namespace CGAL {
namespace Quartic_differentials {

/// writes `quads.obj`: every patch of the T-mesh is a group `patch_k`. Numbers read back as they were.
/// Complexity: linear.
void write_quads_obj(std::ostream& out, const Quad_mesh& m);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_QUADS_H
