// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_PATCH_LOCATOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_PATCH_LOCATOR_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Finds points of a T-mesh's patches in the faces of the differential's triangulation.
///
/// A piece of a face in a patch is the part of the face, laid into the plane of the patch, that lies in the patch's
/// rectangle: both are convex, and only the sides of the rectangle are arcs.
class Patch_locator
{
public:
  /// \pre `defect(t, q)` is empty
  /// Complexity: that of `patch_pieces()`, and linear in them while they are not too uneven
  Patch_locator(const T_mesh& t, const Quartic_differential& q);

  /// the point (x, y) of a patch, decided exactly. \param z in [0, width] x [0, height]
  Surface_point locate(std::size_t patch, Grid_vector z) const;
  /// a point of a face, in its chart with the T-mesh's grid
  Surface_point in_face(Face f, Grid_vector z) const;

private:
  struct Placed_face
  {
    Face       face;
    Transition from_patch;   // to the chart of the face
  };
  // Rectangular cells, and the pieces that may meet them.
  struct Cells
  {
    std::int64_t                          cell_width = 1, cell_height = 1;
    std::size_t                           columns = 1;
    std::vector<std::vector<Placed_face>> faces;
  };

  std::array<Grid_vector, 3> corners(Face f) const;
  bool face_holds(Face f, Grid_vector z) const;

  const Quartic_differential& m_q;
  std::vector<Cells>          m_cells;   // by patch
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_PATCH_LOCATOR_H
