// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BORDER_SIDES_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BORDER_SIDES_H

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The sides of polygons, from vertex to vertex, that are no side of another one the other way round. O(n log n).
template <class Polygons>
std::vector<std::pair<std::size_t, std::size_t>> border_sides(const Polygons& polygons)
{
  std::vector<std::pair<std::size_t, std::size_t>> sides, border;
  for (const auto& p : polygons)
    for (std::size_t k = 0; k < p.size(); ++k) sides.emplace_back(p[k], p[(k + 1) % p.size()]);
  std::sort(sides.begin(), sides.end());
  for (const auto& [v, w] : sides)
    if (!std::binary_search(sides.begin(), sides.end(), std::make_pair(w, v))) border.emplace_back(v, w);
  return border;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_BORDER_SIDES_H
