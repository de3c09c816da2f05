// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_FLAT_INTRINSIC_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_FLAT_INTRINSIC_H

#include <CGAL/Quartic_differentials/Quartic_differential.h>

#include <iosfwd>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// writes `flat_intrinsic.json`, the flat triangulation, exactly; \ref json_flat_intrinsic says what its fields are.
/// Complexity: linear.
void write_flat_intrinsic_json(std::ostream& out, const Quartic_differential& q);

/// writes `name`.obj, `name`.mtl and a checkerboard, `name`.png, into `folder`.
///
/// Texture coordinates are the chart coordinates in units; each is a multiple of 2^-grid_exponent, printed so that it
/// reads back to the identical double. A vertex has one texture coordinate for every sector between edges with a
/// transition other than the identity. The faces are drawn straight between their corners in space: those of a
/// `Refined_surface` lie on the input surface; those of the flat triangulation do not where it is not the input's.
/// \throws Unusable_surface_error if `q.triangulation` is not embedded, Error if a file cannot be written
/// Complexity: linear. Source: METHOD, output files.
void write_flat_obj(const std::string& folder, const std::string& name, const Quartic_differential& q);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_FLAT_INTRINSIC_H
