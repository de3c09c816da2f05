// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_SURFACE_JSON_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_SURFACE_JSON_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <iosfwd>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// reads triangles glued along their edges, a surface that is known by its edge lengths alone (\ref json_surface):
/// `{"triangles":[[v,v,v],...], "opposite":[[[t,e],[t,e],[t,e]],...], "lengths":[[l,l,l],...]}`
/// where edge e of a triangle joins its corners e and e+1, and is glued to nothing where [t,e] is [-1,-1].
/// \throws Unusable_surface_error if the text is not of this form; whether the gluing is consistent is checked by the
///         constructor of `Intrinsic_triangulation`
Glued_triangles read_surface_json(const std::string& text);

/// writes the form that `read_surface_json()` reads; lengths read back to the identical doubles.
void write_surface_json(std::ostream& out, const Glued_triangles& surface);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_SURFACE_JSON_H
