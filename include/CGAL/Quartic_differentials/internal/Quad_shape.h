// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_QUAD_SHAPE_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_QUAD_SHAPE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// at least the smallest normal number, so that one can divide by it
inline double length(const Vector_3& v)
{ return std::max(std::sqrt(v.squared_length()), std::numeric_limits<double>::min()); }

inline Vector_3 unit(const Vector_3& v) { return v / length(v); }

/// Sides and angles of a quad in space.
struct Quad_shape
{
  std::array<double, 4> side;     ///< from corner k to the next one
  Vector_3              normal;   ///< that of the diagonals, a unit vector
  std::array<double, 4> sine;     ///< of the angle at corner k, seen along the normal

  explicit Quad_shape(const std::array<Point_3, 4>& p) : normal(unit(CGAL::cross_product(p[2] - p[0], p[3] - p[1])))
  {
    std::array<Vector_3, 4> direction;
    for (int k = 0; k < 4; ++k) {
      const Vector_3 d = p[(k + 1) % 4] - p[k];
      side[k] = length(d);
      direction[k] = d / side[k];
    }
    for (int k = 0; k < 4; ++k)
      sine[k] = CGAL::scalar_product(CGAL::cross_product(direction[(k + 3) % 4], direction[k]), normal);
  }

  double scaled_jacobian() const { return *std::min_element(sine.begin(), sine.end()); }
  double edge_ratio() const
  { return *std::max_element(side.begin(), side.end()) / *std::min_element(side.begin(), side.end()); }
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_QUAD_SHAPE_H
