// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_CELLS_H
#define CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_CELLS_H

#include <CGAL/Quartic_differentials/Common_refinement.h>

#include <array>
#include <complex>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
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

/// The cells of a common refinement, and the map between A and C that is the identity of the surface.
/// (METHOD, step 7, "Common refinement")
///
/// A value of its own: it does not refer to the triangulations it was made from.
class Refinement_cells
{
public:
  /// cuts every face of `c` along the A edges that cross it.
  /// \pre `c` is the triangulation the flips of `refinement` led to, all of them Euclidean (in each of its two faces a
  ///      cell is the same polygon)
  /// Complexity: O(n log m) for n edges and crossings with at most m in a face.
  Refinement_cells(const Common_refinement& refinement, const Intrinsic_triangulation& c);

  const std::vector<Refinement_cell>& cells()   const { return m_cells; }
  const std::vector<Cell_corner>&     corners() const { return m_corners; }

  /// the positions of a cell's corners in its unfolded C face, see `Intrinsic_triangulation::unfolded`
  std::vector<std::complex<double>> polygon_in_c(const Refinement_cell& cell) const { return polygon(m_c, cell); }
  /// the same in its A face
  std::vector<std::complex<double>> polygon_in_a(const Refinement_cell& cell) const { return polygon(m_a, cell); }

  /// maps a point of C to the same point of A.
  ///
  /// Every point of a closed face is mapped, to nonnegative barycentric coordinates: the cell is the one with the
  /// largest distance from its sides, and the map a similarity through its two farthest corners. A point on the boundary,
  /// which is one with a coordinate that is exactly 0, stays on its boundary edge.
  /// Complexity: linear in the corners in the point's face.
  Surface_point to_input(const Surface_point& p) const;
  /// maps a point of A to the same point of C, the inverse of `to_input` up to rounding.
  Surface_point from_input(const Surface_point& p) const;

private:
  // One of the two triangulations: what is needed to find a point in it.
  struct Layout
  {
    std::vector<std::array<std::complex<double>, 3>> faces;         // unfolded
    std::vector<std::complex<double>>                corners;       // by cell corner, in its unfolded face
    std::vector<std::size_t>                         first_in_face; // into cells_by_face, one more than there are faces
    std::vector<std::size_t>                         cells_by_face;
  };

  // A side of a face: where a boundary edge lies.
  struct Side
  {
    Face face;
    int  number;   // of the corner where it begins
    friend bool operator<(const Side& x, const Side& y)
    { return std::make_pair(x.face, x.number) < std::make_pair(y.face, y.number); }
  };
  using Sides = std::map<Side, Side>;

  static std::optional<Surface_point> mapped_along_boundary(const Surface_point& p, const Sides& other_side);
  template <class Face_of> void sort_into_faces(Layout& layout, Face_of face_of) const;
  std::vector<std::complex<double>> polygon(const Layout& layout, const Refinement_cell& cell) const;
  double depth(const Layout& layout, const Refinement_cell& cell, std::complex<double> z) const;
  const Refinement_cell& cell_at(const Layout& layout, Face f, std::complex<double> z) const;
  std::complex<double> mapped(const Refinement_cell& cell, const Layout& from, const Layout& to,
                              std::complex<double> z) const;

  std::vector<Refinement_cell> m_cells;
  std::vector<Cell_corner>     m_corners;
  Layout                       m_c, m_a;
  Sides                        m_c_side, m_a_side;   // of boundary edges: by the side of the A face, and of the C face
};

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_CELLS_H
