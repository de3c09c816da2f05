// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CHECKERBOARD_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CHECKERBOARD_H

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// how many squares lie side by side in one unit of the charts so that about 2500 cover a surface: an even number, so
/// that the pattern repeats in every unit
inline int checkerboard_squares_per_unit(double flat_area)
{
  const double n = std::sqrt(2500 / flat_area);
  return 2 * static_cast<int>(std::clamp(std::round(n / 2), 4.0, 128.0));
}

/// the colour of the unit square that holds the point (x, y) on a checkerboard, dark where both coordinates are 0
inline bool is_light_square(double x, double y)
{
  const double sum = std::floor(x) + std::floor(y);
  return sum != 2 * std::floor(sum / 2);   // odd; much faster than fmod
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CHECKERBOARD_H
