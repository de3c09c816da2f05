// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_CELLS_H
#define CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_CELLS_H

#include <CGAL/Quartic_differentials/Common_refinement.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A corner of a cell: a crossing, or a vertex of both triangulations. It is named by halfedges and not by vertices,
/// because a face may have the same vertex at two corners.
struct Cell_corner
{
  Halfedge    c;         ///< the halfedge of the cell's C face on which it lies; a vertex is its source
  Halfedge    a;         ///< the same for the cell's A face
  Crossing_id crossing;  ///< none at a vertex
};

/// A cell of the common refinement of two triangulations A and C: a convex polygon that lies in one face of each.
struct Refinement_cell
{
  Face        c_face, a_face;
  std::size_t first_corner, last_corner;   ///< its corners, counterclockwise: `Refinement_cells::corners()` from the
                                           ///< first up to, but without, the last
};

/// The cells of a common refinement. (METHOD, step 7, "Common refinement")
///
/// A value of its own: it does not refer to the triangulations it was made from.
class Refinement_cells
{
public:
  /// cuts every face of `c` along the A edges that cross it, one face after the other.
  /// \pre `c` is the triangulation the flips of `refinement` led to
  /// Complexity: O(n log m) for n edges and crossings with at most m in a face.
  Refinement_cells(const Common_refinement& refinement, const Intrinsic_triangulation& c);

  const std::vector<Refinement_cell>& cells()   const { return m_cells; }
  const std::vector<Cell_corner>&     corners() const { return m_corners; }

private:
  std::vector<Refinement_cell> m_cells;
  std::vector<Cell_corner>     m_corners;
};

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_CELLS_H
