// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_FLAT_SURFACE_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_FLAT_SURFACE_H

#include <CGAL/Quartic_differentials/refined_surface.h>

#include <iosfwd>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

// The surface of `flat.obj` in other formats. They have one texture coordinate a vertex, so a vertex on a seam is there
// once for every sector between seams. Triangles are those of `flat.obj`, in the same order.

/// writes `flat.ply`, in binary, with the vertices' properties `s`, `t` and `singularity_order` and the faces' property
/// `input_face`.
///
/// MeshLab and Blender take texture coordinates from `s` and `t` of vertices; Blender knows no others, and MeshLab wants
/// them in single precision. So that this suffices, whole units are subtracted in every chart, which no texture that
/// repeats in every unit can tell. Positions read back as they were.
/// \param out opened with `std::ios::binary`
/// \param texture the file of the texture, as `write_checkerboard()` writes it, beside this one
/// \throws Unusable_surface_error if the surface is not embedded
/// Complexity: linear.
void write_flat_ply(std::ostream& out, const Refined_surface& refined, const std::string& texture);

/// writes `flat.vtp`, the XML PolyData of VTK: point data `uv` in the units of `flat.obj`, exact, and
/// `singularity_order`; cell data `input_face`. Numbers read back as they were.
/// \throws Unusable_surface_error if the surface is not embedded
/// Complexity: linear.
void write_flat_vtp(std::ostream& out, const Refined_surface& refined);

/// writes `flat.vtu`, the XML UnstructuredGrid of VTK, with the data of `write_flat_vtp()`.
/// \throws Unusable_surface_error if the surface is not embedded
/// Complexity: linear.
void write_flat_vtu(std::ostream& out, const Refined_surface& refined);

/// writes `flat.glb`: glTF 2.0 in one binary file, with the checkerboard of `write_checkerboard()` in it.
///
/// Axes stay as they are; to programs that read glTF the y axis points up. All numbers are in single precision:
/// positions relative to the middle of the surface, to which the node moves it back (and scales it where it is
/// larger than 1e20 or smaller than 1e-20), and texture coordinates without the whole units of their chart, as in
/// `write_flat_ply()`; v points down, as glTF has it. Edges sharper than 60 degrees have two normals.
/// \param out opened with `std::ios::binary`
/// \throws Unusable_surface_error if the surface is not embedded, Error if the file would be larger than 4 GiB
/// Complexity: O(n log n). Source: Khronos Group, glTF 2.0 Specification (ISO/IEC 12113).
void write_flat_glb(std::ostream& out, const Refined_surface& refined);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_FLAT_SURFACE_H
