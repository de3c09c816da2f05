// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_RELATIVE_HOMOLOGY_BASIS_H
#define CGAL_QUARTIC_DIFFERENTIALS_RELATIVE_HOMOLOGY_BASIS_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A basis of H_1(M, dM) of a surface M with boundary: 2g loops, then b-1 arcs from the first boundary curve to each of
/// the others.
struct Relative_homology_basis
{
  /// walks in the dual graph: the halfedges through which a path leaves one face after the other. An arc begins with the
  /// border halfedge through which it comes in, and ends with the halfedge in a face through which it goes out.
  std::vector<std::vector<Halfedge>> paths;
  /// crossings with the paths
  Integer_cochains                   cochains;
};

/// computes a basis of H_1(M, dM), deterministically: the conditions under which a flat metric with straight boundary has
/// a cross field that follows the boundary. Loops round boundary curves are not among them, nor need they be: they follow
/// the boundary.
///
/// As in `homology_basis()`, by a shortest-path tree of the vertices and a maximal spanning tree of the faces, where the
/// vertex tree holds all edges of every boundary curve but one.
/// \pre the surface is connected and has a boundary
/// Complexity: O(n log n + (g + b) n).
/// Source: METHOD, "Surfaces with boundary".
Relative_homology_basis relative_homology_basis(const Intrinsic_triangulation& t);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_RELATIVE_HOMOLOGY_BASIS_H
