// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_READ_SURFACE_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_READ_SURFACE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// reads a closed, connected, oriented triangle surface.
///
/// The format follows from the extension: `.off`, `.obj`, `.ply`, `.stl` (through CGAL), `.vtp` (VTK's XML PolyData in
/// all its encodings, compressed by zlib or not; polygons and strips), or `.json` for triangles glued along their edges
/// (see `read_surface_json()`). What is done to the input, and said in `notes`, is:
/// if the polygons as indexed are not closed, vertices with exactly equal coordinates become one (STL needs this);
/// vertices without a face are dropped, the others keep their order; polygons are triangulated.
/// Nothing else is repaired. A surface that is inside-out is legal, and noted.
/// Not tested: whether the surface intersects itself.
///
/// \throws Unusable_surface_error if the file is missing, unreadable, empty, or not of its format; if an index is out
///         of range, a coordinate not finite, a face flat; if faces coincide, more than two faces share an edge, two
///         neighbours disagree on orientation, a vertex is not manifold, the surface has a boundary or more than one
///         component. The sentence names the place; vertices and faces are counted from 0, as in the file.
/// Complexity: O(n log n).
Intrinsic_triangulation read_surface(const std::string& path, std::vector<std::string>& notes);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_READ_SURFACE_H
