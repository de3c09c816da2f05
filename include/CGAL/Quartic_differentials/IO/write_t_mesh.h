// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_T_MESH_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_T_MESH_H

#include <CGAL/Quartic_differentials/t_mesh.h>

#include <iosfwd>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// writes `tmesh.json` (\ref json_tmesh): nodes, arcs and patches, lengths in integers, places in space as points and
/// polylines on the triangles of `q`.
///
/// \param surface what the polylines lie on: `input` if `q` is on a refinement of the input, otherwise `flat_intrinsic`
/// Every polyline begins and ends at the very doubles of its nodes' positions. All numbers read back as they were.
/// If `q.triangulation` is not embedded there are no positions and no polylines.
/// \pre `defect(t, q)` is empty
/// Complexity: linear in the output.
void write_t_mesh_json(std::ostream& out, const T_mesh& t, const Quartic_differential& q, const std::string& surface);

/// writes `tmesh.vtp`, the XML PolyData of VTK, for ParaView: the triangles of `q` cut
/// along the arcs as polygons, the arcs as lines.
///
/// Cell data: `patch` (-1 on lines), `arc` (-1 on polygons), `colour`. Point data: `uv`, the place in the patch from
/// (0, 0) to (width, height), in the units of `flat.obj`; points are shared within patches, not between them.
/// \pre `defect(t, q)` is empty
/// \throws Unusable_surface_error if `q.triangulation` is not embedded
/// Complexity: O(n log n) in the output.
void write_t_mesh_vtp(std::ostream& out, const T_mesh& t, const Quartic_differential& q);

/// writes `tmesh.obj`: the triangles of every patch as a group `patch_k`, with texture coordinates in the patch, from
/// (0, 0) to (width, height) in the units of `flat.obj`; then every arc as a group `arc_k` with one polyline, from one
/// end to the other.
///
/// There is one `v` for every point of the surface; texture vertices are shared within patches, not between them.
/// Numbers read back as they were.
/// \param patches the result of `patch_mesh()`
/// Complexity: O(n log n).
void write_t_mesh_obj(std::ostream& out, Mesh patches);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_T_MESH_H
