// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_T_SPLINE_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_T_SPLINE_H

#include <CGAL/Quartic_differentials/t_mesh.h>

#include <iosfwd>

namespace CGAL {
namespace Quartic_differentials {

/// writes `tmesh.tsp`, the T-mesh as text with what a T-spline needs: vertices with places and valences, edges with
/// knot intervals, faces with their sides. The comment at its head describes the format in full.
///
/// Knot intervals are the exact lengths of the arcs, so those of opposite sides of every face have equal sums
/// (Sederberg et al. 2003, rule 1). Not promised: their rule 2, that opposite T-junctions are joined where they can be.
/// All numbers read back as they were.
/// \pre `defect(t, q)` is empty
/// \throws Unusable_surface_error if `q.triangulation` is not embedded
/// Complexity: linear in the output.
void write_t_spline(std::ostream& out, const T_mesh& t, const Quartic_differential& q);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_T_SPLINE_H
