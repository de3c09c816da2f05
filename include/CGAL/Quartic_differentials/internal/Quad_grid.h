// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_QUAD_GRID_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_QUAD_GRID_H

#include <CGAL/Quartic_differentials/t_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// the sum of q over a side of a patch
std::size_t side_length(const std::vector<T_mesh::Side_piece>& side, const std::vector<int>& q);

/// the number of cycles of a permutation of some indices; `next` of the others is std::size_t(-1)
std::size_t number_of_cycles(const std::vector<std::size_t>& next);

/// Complexity: linear in the arcs
std::size_t number_of_boundary_curves(const T_mesh& t);

/// The points that arcs are divided into: the nodes, then the inner points of one arc after the other.
class Arc_points
{
public:
  Arc_points(const T_mesh& t, const std::vector<int>& q);

  std::size_t size() const { return m_size; }
  /// inner point i (from 1) of an arc, in its direction
  std::size_t operator()(std::size_t arc, std::size_t i) const { return m_first[arc] + i - 1; }
  /// the points on a side, from its first corner to its last
  std::vector<std::size_t> on(const std::vector<T_mesh::Side_piece>& side, const T_mesh& t,
                              const std::vector<int>& q) const;

private:
  std::vector<std::size_t> m_first;   // by arc
  std::size_t              m_size;
};

/// The regular grids of all patches, glued: points and edges of the grids, and which of them become one.
///
/// Points are the `Arc_points`, then the inner points of patches; edges are those on arcs, then those inside patches.
class Quad_grid
{
public:
  /// Corners counterclockwise from (column, row) in the patch; edge k joins corner k to the next one.
  struct Quad
  {
    std::array<std::size_t, 4> point, edge;
    std::size_t                patch;
    std::size_t                column, row;
  };

  /// \pre no q is negative, and opposite sides of every patch have the same sum
  Quad_grid(const T_mesh& t, const std::vector<int>& q);

  const std::vector<Quad>& quads() const { return m_quads; }
  std::size_t number_of_points() const { return m_point_class.size(); }
  /// the first point of those that become one vertex
  std::size_t vertex(std::size_t point) const { return m_point_class[point]; }
  /// inner point i (from 1) of an arc
  std::size_t arc_point(std::size_t arc, std::size_t i) const { return m_arc_points(arc, i); }

  /// whether the quads make up the surface of the T-mesh with its singularities: a sentence, or empty
  std::string defect(const T_mesh& t) const;

  /// an arc for every edge that has twice the same end, and two for every two edges with the same ends: one of them
  /// must be longer for a simple mesh
  std::vector<std::vector<std::size_t>> crowded_arcs() const;

private:
  struct Glue;

  // by halfedge 4 * quad + k: the one on the other side, std::size_t(-1) on the boundary; or empty, with a sentence
  std::vector<std::size_t> opposite_sides(std::string& violation) const;

  std::vector<Quad>        m_quads;
  Arc_points               m_arc_points;
  std::vector<std::size_t> m_point_class;
  std::vector<std::size_t> m_edge_class;
  std::vector<std::size_t> m_edge_arc;      // by edge: the arc as part of which it gets longer
  std::vector<int>         m_outside;       // by edge, at the first of its class: how many of this are on the boundary
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_QUAD_GRID_H
