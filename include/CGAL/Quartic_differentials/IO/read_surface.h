// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_READ_SURFACE_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_READ_SURFACE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// reads a connected, oriented triangle surface, closed or with boundary.
///
/// The format follows from the extension: `.off`, `.obj`, `.ply`, `.stl` (through CGAL), `.vtp` (VTK's XML PolyData in
/// all its encodings, compressed by zlib or not; polygons and strips), or `.json` for triangles glued along their edges
/// (see `read_surface_json()`). What is done to the input, and said in `notes`, is:
/// if the polygons as indexed are not closed, vertices with exactly equal coordinates become one (STL needs this);
/// vertices without a face are dropped, the others keep their order; polygons are triangulated.
/// Nothing else is repaired. A closed surface that is inside-out is legal, and noted.
/// Not tested: whether the surface intersects itself.
///
/// \throws Unusable_surface_error if the file is missing, unreadable, empty, or not of its format; if an index is out
///         of range, a coordinate not finite, a face flat; if faces coincide, more than two faces share an edge, two
///         neighbours disagree on orientation, a vertex is not manifold, the surface has more than one component. The
///         sentence names the place; vertices and faces are counted from 0, as in the file.
/// Complexity: O(n log n).
Intrinsic_triangulation read_surface(const std::string& path, std::vector<std::string>& notes);

/// One of the components of a surface, or why it cannot be used.
struct Surface_component
{
  std::optional<Intrinsic_triangulation> surface;               ///< nothing if it cannot be used
  std::string                            refusal;               ///< the sentence why not, or ""
  std::vector<std::string>               notes;                 ///< what was done to it
  std::size_t                            vertices = 0, faces = 0;   ///< their numbers in the file
};

/// reads the components of a surface, those with more faces first, otherwise in the order of their first faces.
///
/// Each is what `read_surface()` makes of a file that has it alone: its vertices and faces keep their order, and one
/// that cannot be used does not keep the others from being read. What has a vertex in common is one component; if that
/// has a boundary, so is what has points with exactly equal coordinates (STL needs this). The sentences count vertices
/// and faces within the component.
///
/// \throws Unusable_surface_error if the file is missing, unreadable, empty, or not of its format, or an index is out
///         of range
/// Complexity: O(n log n).
std::vector<Surface_component> read_surface_components(const std::string& path);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_READ_SURFACE_H
