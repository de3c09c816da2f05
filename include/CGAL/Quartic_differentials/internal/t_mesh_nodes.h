// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_T_MESH_NODES_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_T_MESH_NODES_H

#include <CGAL/Quartic_differentials/internal/patch_pieces.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// what the output files call a kind of node
inline const char* name(T_mesh::Node_kind kind)
{
  switch (kind) {
    case T_mesh::Node_kind::singularity: return "singularity";
    case T_mesh::Node_kind::corner:      return "corner";
    case T_mesh::Node_kind::meeting:     return "meeting";
    case T_mesh::Node_kind::t_junction:  return "t_junction";
    default:                             return "crossing";
  }
}

/// the node's place in space. \pre `q.triangulation` is embedded
inline Point_3 position(const Quartic_differential& q, const T_mesh::Node& node)
{
  return position(q, chart_point(q, node.face, node.point));
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_T_MESH_NODES_H
