// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BEZIER_NET_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BEZIER_NET_H

#include <CGAL/Quartic_differentials/internal/Cubic_basis.h>
#include <CGAL/Quartic_differentials/multipatch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The polar form of a cubic spline with n spans on span `span`, at three arguments: the control point after inserting
/// them as knots. Run through backwards, arguments too, the spline gives the same numbers bit by bit, also with fused
/// multiplications: weights are 0, 1, 2 or 3, the last beside 0.
/// \param control the 4 control points of the span
/// \pre the arguments are ends of the span
/// Source: Ramshaw, Blossoms are polar forms, 1989.
inline Point_3 polar_form(std::array<Point_3, 4> control, std::size_t span, std::size_t n,
                          const std::array<std::size_t, 3>& arguments)
{
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t j = 0; j < 3 - r; ++j) {
      const double from = knot(span + r + j + 1, n), to = knot(span + j + 4, n), x = arguments[r];
      const double a = to - x, b = x - from, c = to - from;
      const Point_3 &p = control[j], &q = control[j + 1];
      control[j] = Point_3((a * p.x() + b * q.x()) / c, (a * p.y() + b * q.y()) / c, (a * p.z() + b * q.z()) / c);
    }
  return control[0];
}

/// the 3n + 1 Bezier points of a cubic spline with n + 3 control points, one after the other; spans share their ends
inline std::vector<Point_3> bezier_points(const std::vector<Point_3>& control)
{
  const std::size_t n = control.size() - 3;
  std::vector<Point_3> result;
  result.reserve(3 * n + 1);
  for (std::size_t m = 0; m <= 3 * n; ++m) {
    const std::size_t k = m / 3, span = std::min(k, n - 1);
    // the last is the second backwards
    const std::array<std::array<std::size_t, 3>, 3> arguments{{{k, k, k}, {k, k, k + 1}, {k + 1, k + 1, k}}};
    result.push_back(polar_form({control[span], control[span + 1], control[span + 2], control[span + 3]}, span, n,
                                arguments[m % 3]));
  }
  return result;
}

/// the (3 n_u + 1) (3 n_v + 1) Bezier points of a patch, u runs faster: span (i, j) has those from (3i, 3j) to
/// (3i + 3, 3j + 3). Patches that meet have the same points on the common side, bit by bit. Complexity: linear.
inline std::vector<Point_3> bezier_net(const Multipatch::Patch& patch)
{
  const auto [n_u, n_v] = patch.spans;
  std::vector<std::vector<Point_3>> rows;   // by control point in v
  for (std::size_t j = 0; j < n_v + 3; ++j) {
    const auto row = patch.control_points.begin() + j * (n_u + 3);
    rows.push_back(bezier_points({row, row + n_u + 3}));
  }
  const std::size_t width = 3 * n_u + 1;
  std::vector<Point_3> result(width * (3 * n_v + 1));
  for (std::size_t i = 0; i < width; ++i) {
    std::vector<Point_3> column;
    for (const std::vector<Point_3>& row : rows) column.push_back(row[i]);
    const std::vector<Point_3> points = bezier_points(column);
    for (std::size_t j = 0; j < points.size(); ++j) result[j * width + i] = points[j];
  }
  return result;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BEZIER_NET_H
