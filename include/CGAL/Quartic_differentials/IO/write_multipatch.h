// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_MULTIPATCH_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_MULTIPATCH_H

#include <CGAL/Quartic_differentials/multipatch.h>

#include <iosfwd>

namespace CGAL {
namespace Quartic_differentials {

/// writes `splines.xml` for G+Smo (METHOD, output files): every patch a `Geometry` of type `TensorBSpline2`, then a
/// `MultiPatch` with the interfaces and the sides on the boundary. Numbers read back as they were.
/// Complexity: linear in the output.
void write_multipatch_xml(std::ostream& out, const Multipatch& m);

/// writes `splines.json` (\ref json_splines): the same as plain lists, and the quads of every patch. Numbers read
/// back as they were.
/// Complexity: linear in the output.
void write_multipatch_json(std::ostream& out, const Multipatch& m);

/// writes `splines.vtu`, the XML UnstructuredGrid of VTK, for ParaView: every span of every patch is a bicubic
/// `VTK_BEZIER_QUADRILATERAL`.
///
/// Cell data: `patch` and `quad`, the span's number in the quad mesh. Points are shared within patches, not between
/// them, but are the same there bit by bit. The cells are those of the splines up to rounding, by Bezier extraction.
/// Complexity: linear in the output.
void write_multipatch_vtu(std::ostream& out, const Multipatch& m);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_MULTIPATCH_H
