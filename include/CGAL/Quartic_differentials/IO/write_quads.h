// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_QUADS_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_QUADS_H

#include <CGAL/Quartic_differentials/quad_mesh.h>

#include <iosfwd>

namespace CGAL {
namespace Quartic_differentials {

// In all formats numbers read back as they were, and vertices and quads have the same indices.

/// writes `quads.obj`: every patch of the T-mesh is a group `patch_k`, its quads row by row.
/// Complexity: linear.
void write_quads_obj(std::ostream& out, const Quad_mesh& m);

/// writes `quads.off`, without patches.
/// \pre `defect(m, t)` is empty
/// Complexity: linear.
void write_quads_off(std::ostream& out, const Quad_mesh& m, const T_mesh& t);

/// writes `quads.ply`, in binary, with the faces' property `patch` and the vertices' property `singularity_order`.
/// \param out opened with `std::ios::binary`
/// \pre `defect(m, t)` is empty
/// Complexity: linear.
void write_quads_ply(std::ostream& out, const Quad_mesh& m, const T_mesh& t);

/// writes `quads.vtu` for ParaView: cell data `patch`, `scaled_jacobian` and `edge_ratio`, as in `quad_quality()`;
/// point data `singularity_order`.
/// \pre `defect(m, t)` is empty
/// Complexity: linear. Source: VTK file formats, unstructured grids in XML.
void write_quads_vtu(std::ostream& out, const Quad_mesh& m, const T_mesh& t);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_QUADS_H
