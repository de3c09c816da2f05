// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CUT_TO_DISK_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CUT_TO_DISK_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A surface cut open along a graph into a disk. The graph holds all boundary edges of the surface.
///
/// Nodes of the graph are the cones and its vertices of degree other than 2; a segment is a path between nodes.
/// Every segment is seen twice from the disk, as two sides of its boundary polygon that are mates of each other; on the
/// boundary of the surface it is seen once.
struct Cut_disk
{
  struct Side
  {
    std::size_t first;   ///< boundary[first], ..., boundary[first + size - 1] are its halfedges
    std::size_t size;
    std::size_t mate;    ///< the side that holds the opposite halfedges, in reverse order; itself on the boundary
  };

  std::vector<char>        is_cut;     ///< by edge; boundary edges are
  std::vector<Halfedge>    boundary;   ///< once round the disk, counterclockwise, from a node
  std::vector<Side>        sides;      ///< in the order of `boundary`
  /// by halfedge h in a face: the vertex of the disk at the corner of face(h) at source(h).
  /// Number i < boundary.size() lies on the boundary, at the source of boundary[i]; the others are interior.
  std::vector<std::size_t> copy;
  std::size_t              number_of_copies = 0;

  /// whether side s is on the boundary of the surface
  bool is_border(std::size_t s) const { return sides[s].mate == s; }
  /// the side that follows s
  std::size_t next_side(std::size_t s) const { return s + 1 == sides.size() ? 0 : s + 1; }
};

/// cuts a surface along short loops through all cones: the shortest path tree from the first cone and the 2g generators
/// of `tree_cotree()`, without leaves that are not cones; and along the boundary.
///
/// \pre `is_cone` (by vertex) holds somewhere, or the genus is positive, or there are two boundary curves
/// Complexity: O(n log n). Source: METHOD, step 7.
Cut_disk cut_to_disk(const Intrinsic_triangulation& t, const std::vector<double>& lengths,
                     const std::vector<char>& is_cone);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CUT_TO_DISK_H
