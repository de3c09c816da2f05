// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PATCH_MESH_H
#define CGAL_QUARTIC_DIFFERENTIALS_PATCH_MESH_H

#include <CGAL/Quartic_differentials/refined_surface.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <cstdint>

namespace CGAL {
namespace Quartic_differentials {

/// the number in `e:arc` of an edge inside a patch
constexpr std::uint32_t no_arc = static_cast<std::uint32_t>(-1);

/// the refined surface cut along the arcs of a T-mesh, as a triangle mesh for applications, closed if the surface is:
/// every face lies in one patch and in one face of the input, the faces of a patch fill a rectangle, and every arc is a
/// path of edges.
///
/// The vertices of `refined.differential.triangulation` come first, with their indices; then those where arcs cross
/// edges or end inside faces, which are identified exactly. Parts of faces are cut into triangles none of which has its
/// corners on one line in the plane, with the least altitude there as large as possible. Not promised: that triangles
/// are not degenerate once they are rounded, where exact points are nearer to each other than doubles can tell.
///
/// The property maps are
/// - `f:patch`, `std::uint32_t`: the patch of the T-mesh;
/// - `f:input_face`, `Face`: the index of the face of the input in which it lies;
/// - `h:texture`, `Point_2` of `Simple_cartesian<double>`: target(h) in the patch of face(h), the rectangle
///   [0, width] x [0, height], in units; the same from all faces of the patch, and exact on its sides;
/// - `e:arc`, `std::uint32_t`: the arc of the T-mesh on which the edge lies, `no_arc` inside patches;
/// - `v:input_point`, `Surface_point`: where it is on the input;
/// - `v:singularity_order`, `int`: order of the zero, minus that of the pole, 0 where regular.
///
/// Numbers have 32 bits, as indices of `Surface_mesh`: the format PLY has no longer ones, and CGAL 6.0 writes unreadable
/// files of them.
///
/// \pre `defect(t, refined.differential)` is empty, and the refined surface has no loops or parallel edges, as
///      `refined_surface()` makes it
/// \throws Numerical_error if the pieces do not fit together
/// Complexity: that of finding the pieces, plus the cube of the number of corners of every piece.
/// Source: METHOD, step 8; for the triangles, Klincsek 1980.
Mesh patch_mesh(const T_mesh& t, const Refined_surface& refined);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_PATCH_MESH_H
