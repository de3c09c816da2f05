// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_CELL_FOREST_H
#define CGAL_QUARTIC_DIFFERENTIALS_CELL_FOREST_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Vertices of a surface, gathered in cells, each with a tree of paths along edges from one of them, the cell's site.
struct Cell_forest
{
  std::vector<Vertex>   sites;      ///< by cell
  std::vector<Vertex>   vertices;   ///< those that are in a cell, parents before children
  std::vector<int>      cell;       ///< by vertex: -1 if it is in none
  std::vector<Halfedge> parent;     ///< by vertex: the tree's halfedge that ends there, null at a site and outside of cells
  std::vector<double>   distance;   ///< by vertex: the length of the path from its site
};

/// gathers all vertices round sites no two of which are nearer to each other than the radius: a vertex belongs to the
/// site that is nearest along edges, and is within the radius of it. With the radius 0, every vertex is a site.
/// Deterministic: whichever vertex comes first and is near no site yet becomes one.
/// Complexity: O(n log n) where balls that touch a ball of the same radius are few, whatever the radius.
Cell_forest cells_within(const Intrinsic_triangulation& t, double radius);

/// these vertices alone, each a cell
Cell_forest single_vertices(const Intrinsic_triangulation& t, std::vector<Vertex> vertices);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_CELL_FOREST_H
