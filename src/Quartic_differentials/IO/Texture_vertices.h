// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEXTURE_VERTICES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEXTURE_VERTICES_H

#include <CGAL/Quartic_differentials/Quartic_differential.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// The vertices of a surface, once for every sector between edges with a transition other than the identity, or of the
/// boundary.
struct Texture_vertices
{
  std::vector<std::size_t> of_corner;   ///< by halfedge in a face: that of its source
  std::vector<Grid_vector> points;      ///< in the chart
  std::vector<Vertex>      vertices;    ///< of the surface

  /// those of the corners of a face
  std::array<std::size_t, 3> triangle(const Intrinsic_triangulation& t, Face f) const
  {
    const auto h = t.halfedges(f);
    return {of_corner[h[0]], of_corner[h[1]], of_corner[h[2]]};
  }
};

/// finds them. Complexity: linear.
Texture_vertices texture_vertices(const Quartic_differential& q);

/// subtracts whole units in every chart, that is in faces connected by identities, so that 0 is near the middle.
/// Complexity: linear.
void subtract_whole_units(Texture_vertices& texture, const Quartic_differential& q);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEXTURE_VERTICES_H
