// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_T_MESH_H
#define CGAL_QUARTIC_DIFFERENTIALS_T_MESH_H

#include <CGAL/Quartic_differentials/Quartic_differential.h>
#include <CGAL/Quartic_differentials/Visitor.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A straight piece of an arc inside one face, or along one of its edges with the face on its left, in the chart of that
/// face. Successive pieces of an arc meet in an edge or in a vertex.
struct Chart_segment
{
  Face        face;
  int         direction;   ///< the piece runs along i^direction
  /// ends in grid units of the T-mesh: exact at nodes and vertices; where the arc crosses an edge, the coordinate across
  /// the direction is exact and the one along it is rounded to the grid, back against the direction. The two charts
  /// there see the same point, and a piece shorter than the grid has both its ends at one point.
  Grid_vector from, to;
};

/// A decomposition of a quartic differential's surface into rectangles, all lengths exact integers in units of
/// 2^-grid_exponent. (METHOD, step 8)
struct T_mesh
{
  /// `corner` is a singularity on the boundary
  enum class Node_kind { singularity, corner, meeting, t_junction, crossing };

  /// A point at which arcs end.
  struct Node
  {
    Node_kind   kind;
    Vertex      vertex;   ///< the vertex of the singularity or corner, otherwise the null vertex
    int         order;    ///< the order there, otherwise 0
    Face        face;     ///< a face that holds the node
    Grid_vector point;    ///< its place in the chart of that face

    /// whether it is a singularity of the differential, inside or on the boundary
    bool is_singularity() const { return kind == Node_kind::singularity || kind == Node_kind::corner; }
  };
  /// A piece of a trace, or of the boundary, between two nodes.
  struct Arc
  {
    std::size_t                from, to;   ///< nodes
    std::int64_t               length;
    std::vector<Chart_segment> path;       ///< from `from` to `to`, without gaps
    bool                       on_boundary = false;   ///< it has the surface on its left only
  };
  /// An arc of a side of a patch, and its direction there.
  struct Side_piece
  {
    std::size_t arc;
    bool        forward;
  };
  /// A rectangle.
  struct Patch
  {
    std::int64_t                           width, height;
    std::array<std::vector<Side_piece>, 4> sides;   ///< counterclockwise; 0 and 2 have length width, 1 and 3 height

    /// the place in [0, width] x [0, height] at a distance from where side k begins
    Grid_vector on_side(int k, std::int64_t distance) const
    {
      switch (k) {
        case 0:  return {distance, 0};
        case 1:  return {width, distance};
        case 2:  return {width - distance, height};
        default: return {0, height - distance};
      }
    }
  };

  int                grid_exponent = 0;   ///< the quartic differential's plus one: coordinates are doubled
  std::vector<Node>  nodes;
  std::vector<Arc>   arcs;
  std::vector<Patch> patches;

  /// V - E + F = 2 - 2g - b
  long euler_characteristic() const
  {
    return static_cast<long>(nodes.size()) - static_cast<long>(arcs.size()) + static_cast<long>(patches.size());
  }
};

/// traces the critical trajectories of a quartic differential and returns the rectangles they cut.
///
/// Every trace runs along a grid axis with unit speed and ends where it meets one that was there before it, or the
/// boundary, which is cut into arcs where traces end and at corners; all decisions are exact integer arithmetic. An annulus
/// without any singularity is cut across from a vertex of its boundary.
///
/// \pre `defect(q)` is empty
/// \throws Infeasible_divisor_error if there is no singularity to start from, and no boundary
/// \throws Numerical_error if a coordinate leaves the range in which 64-bit integers are exact (a trajectory that winds
///         for too long), or an invariant of the result fails
/// \throws Cancelled_error
/// Complexity: O(s log s) for s crossings of traces with edges, plus the pairs of traces in a face.
/// Source: METHOD, step 8; paper, section 4.8.
T_mesh t_mesh(const Quartic_differential& q, Visitor& visitor);

/// checks every invariant of a T-mesh of `q` exactly and returns the first violation as a sentence, or the empty string:
/// arcs run without gaps and with their lengths through the charts from node to node; patches are closed rectangles
/// with opposite sides equal; every arc is used once in each direction, on the boundary once forward; the arms and patch
/// corners at every node are those of its kind, order + 4 at a singularity, order + 3 and order + 2 at a corner;
/// V - E + F = 2 - 2g - b; the areas of the patches sum to that of `q`.
/// Complexity: linear.
std::string defect(const T_mesh& t, const Quartic_differential& q);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_T_MESH_H
