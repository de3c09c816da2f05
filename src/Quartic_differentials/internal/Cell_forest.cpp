// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Cell_forest.h"

#include <CGAL/Quartic_differentials/internal/shortest_path_tree.h>

#include <limits>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const double infinity = std::numeric_limits<double>::infinity();

// Cells follow from the trees. (A vertex whose distance did not change by rounding has kept its parent, not its site.)
void name_cells(const Intrinsic_triangulation& t, Cell_forest& forest)
{
  for (std::size_t i = 0; i < forest.sites.size(); ++i) forest.cell[forest.sites[i]] = static_cast<int>(i);
  forest.vertices = forest.sites;
  std::vector<Vertex> unnamed;
  for (Vertex v : t.vertices()) {
    for (Vertex w = v; forest.cell[w] < 0; w = t.source(forest.parent[w])) unnamed.push_back(w);
    for (; !unnamed.empty(); unnamed.pop_back()) {
      const Vertex w = unnamed.back();
      forest.cell[w] = forest.cell[t.source(forest.parent[w])];
      forest.vertices.push_back(w);
    }
  }
}

Cell_forest empty_forest(std::size_t vertices)
{
  return {{}, {}, std::vector<int>(vertices, -1), std::vector<Halfedge>(vertices, Mesh::null_halfedge()),
          std::vector<double>(vertices, infinity)};
}

} // namespace

Cell_forest cells_within(const Intrinsic_triangulation& t, double radius)
{
  Cell_forest forest = empty_forest(t.number_of_vertices());
  for (Vertex v : t.vertices()) {
    if (forest.distance[v] < infinity) continue;
    forest.sites.push_back(v);
    grow_shortest_paths(t, t.lengths(), v, radius, forest.distance, forest.parent, [](Vertex) {});
  }
  name_cells(t, forest);
  return forest;
}

Cell_forest single_vertices(const Intrinsic_triangulation& t, std::vector<Vertex> vertices)
{
  Cell_forest forest = empty_forest(t.number_of_vertices());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    forest.cell[vertices[i]] = static_cast<int>(i);
    forest.distance[vertices[i]] = 0;
  }
  forest.sites = vertices;
  forest.vertices = std::move(vertices);
  return forest;
}

} } } // namespace CGAL::Quartic_differentials::internal
