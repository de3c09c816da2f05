// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/Patch_locator.h>

#include "grid_lines.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/patch_pieces.h>
#include <CGAL/Quartic_differentials/pull_back.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

Patch_locator::Patch_locator(const T_mesh& t, const Quartic_differential& q) : m_q(q), m_cells(t.patches.size())
{
  const std::vector<Patch_piece> pieces = patch_pieces(t, q);
  std::vector<std::size_t> number(t.patches.size(), 0);
  for (const Patch_piece& piece : pieces) ++number[piece.patch];
  for (std::size_t p = 0; p < t.patches.size(); ++p) {   // as many cells as pieces, and as square as they can be
    const double width = static_cast<double>(t.patches[p].width), height = static_cast<double>(t.patches[p].height);
    const double side = std::sqrt(width * height / static_cast<double>(number[p]));
    Cells& cells = m_cells[p];
    cells.columns = 1 + static_cast<std::size_t>(width / std::max(side, width / double(number[p])));
    const std::size_t rows = 1 + static_cast<std::size_t>(height / std::max(side, height / double(number[p])));
    cells.cell_width = t.patches[p].width / static_cast<std::int64_t>(cells.columns) + 1;
    cells.cell_height = t.patches[p].height / static_cast<std::int64_t>(rows) + 1;
    cells.faces.resize(cells.columns * rows);
  }
  for (const Patch_piece& piece : pieces) {
    const std::int64_t width = t.patches[piece.patch].width, height = t.patches[piece.patch].height;
    std::int64_t left = width, right = 0, low = height, high = 0;
    for (Grid_vector corner : corners(piece.face)) {
      const Grid_vector z = piece.to_patch(corner);
      left = std::min(left, z.x);
      right = std::max(right, z.x);
      low = std::min(low, z.y);
      high = std::max(high, z.y);
    }
    Cells& cells = m_cells[piece.patch];
    const Placed_face placed{piece.face, piece.to_patch.inverse()};
    for (std::int64_t y = std::max<std::int64_t>(low, 0) / cells.cell_height;
         y <= std::min(high, height) / cells.cell_height; ++y)
      for (std::int64_t x = std::max<std::int64_t>(left, 0) / cells.cell_width;
           x <= std::min(right, width) / cells.cell_width; ++x)
        cells.faces[y * cells.columns + x].push_back(placed);
  }
}

std::array<Grid_vector, 3> Patch_locator::corners(Face f) const
{
  const Doubled_charts charts(m_q);
  const auto [h0, h1, h2] = m_q.triangulation.halfedges(f);
  return {charts.corner(h0), charts.corner(h1), charts.corner(h2)};
}

bool Patch_locator::face_holds(Face f, Grid_vector z) const { return Doubled_charts(m_q).face_holds(f, z); }

Surface_point Patch_locator::in_face(Face f, Grid_vector z) const { return {f, barycentric(corners(f), z)}; }

Surface_point Patch_locator::locate(std::size_t patch, Grid_vector z) const
{
  const Cells& cells = m_cells[patch];
  for (const Placed_face& placed : cells.faces[z.y / cells.cell_height * cells.columns + z.x / cells.cell_width])
    if (face_holds(placed.face, placed.from_patch(z))) return in_face(placed.face, placed.from_patch(z));
  throw Numerical_error("a point of patch " + std::to_string(patch) + " lies in no face");
}

} } } // namespace CGAL::Quartic_differentials::internal
