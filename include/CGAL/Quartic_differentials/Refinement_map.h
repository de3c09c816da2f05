// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_MAP_H
#define CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_MAP_H

#include <CGAL/Quartic_differentials/Refinement_cells.h>
#include <CGAL/Quartic_differentials/internal/Grouped.h>

#include <array>
#include <complex>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// The map between two triangulations A and C of a surface that is the identity of the surface.
/// (METHOD, step 7, "Common refinement")
///
/// A value of its own: it does not refer to the triangulations it was made from.
class Refinement_map
{
public:
  /// \pre `cells` are those of `refinement` and `c`, the triangulation its flips led to, all of them Euclidean (in each of
  ///      its two faces a cell is the same polygon)
  /// Complexity: linear.
  Refinement_map(const Refinement_cells& cells, const Common_refinement& refinement, const Intrinsic_triangulation& c);

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
    std::vector<std::array<std::complex<double>, 3>> faces;      // unfolded
    std::vector<std::complex<double>>                corners;    // by cell corner, in its unfolded face
    internal::Grouped<std::size_t>                   cells_in;   // by face: the numbers of its cells
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
  std::vector<std::complex<double>> polygon(const Layout& layout, const Refinement_cell& cell) const;
  double depth(const Layout& layout, const Refinement_cell& cell, std::complex<double> z) const;
  const Refinement_cell& cell_at(const Layout& layout, Face f, std::complex<double> z) const;
  std::complex<double> mapped(const Refinement_cell& cell, const Layout& from, const Layout& to,
                              std::complex<double> z) const;

  std::vector<Refinement_cell> m_cells;
  Layout                       m_c, m_a;
  Sides                        m_c_side, m_a_side;   // of boundary edges: by the side of the A face, and of the C face
};

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_REFINEMENT_MAP_H
