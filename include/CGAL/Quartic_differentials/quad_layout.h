// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_QUAD_LAYOUT_H
#define CGAL_QUARTIC_DIFFERENTIALS_QUAD_LAYOUT_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A quad mesh cut into regular grids that meet side to side, without T-junctions: its base complex.
///
/// Grids, like their sides, run counterclockwise seen from outside: side 0 is the first row, 1 the last column, 2 the
/// last row and 3 the first column. Every side is on the boundary, or that of exactly one interface, whose two sides
/// run against one another.
struct Quad_layout
{
  /// A regular grid of quads.
  struct Patch
  {
    std::array<std::size_t, 2> size;    ///< columns and rows of quads, n_u and n_v
    std::vector<Halfedge>      quads;   ///< n_u n_v, row by row: the halfedge of each that runs along the row
  };
  /// A side of a patch.
  struct Side
  {
    std::size_t patch;
    int         side;
  };
  /// Two sides of patches that are one.
  struct Interface
  {
    Side first, second;
  };

  std::vector<Patch>     patches;
  std::vector<Interface> interfaces;
  std::vector<Side>      boundary;
};

/// the vertices of the quads of a patch, (n_u + 1) (n_v + 1), row by row. Complexity: linear.
std::vector<Vertex> grid_vertices(const Mesh& quads, const Quad_layout::Patch& patch);

/// cuts a quad mesh along the grid lines through its irregular vertices, all the way; this is the coarsest layout whose
/// patches are regular and meet side to side. A mesh without irregular vertices is cut along the two lines through one
/// vertex if it is a torus, and across if it is an annulus. At a regular vertex of the boundary there are two quads.
/// \param quads as `surface_mesh()` returns it, or any other
/// \throws Unusable_surface_error if it has a face that is no quad, or is not connected
/// Complexity: linear.
/// Source: Bommes, Lempfer and Kobbelt 2011 (base complex).
Quad_layout quad_layout(const Mesh& quads);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_QUAD_LAYOUT_H
