// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DISTANCE_SUM_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DISTANCE_SUM_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Surface_distance.h>
#include <CGAL/Quartic_differentials/internal/diagonal.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Collects distances at samples of a surface.
class Distance_sum
{
public:
  /// \param weight the area for which the sample stands
  void add(double squared_distance, double weight)
  {
    m_most = std::max(m_most, squared_distance);
    m_sum += weight * squared_distance;
    m_area += weight;
  }

  /// in units of the diagonal of the bounding box
  Surface_distance by_diagonal(const Mesh& input) const
  {
    const double unit = diagonal(input.points());
    return {std::sqrt(m_most) / unit, std::sqrt(m_sum / m_area) / unit};
  }

private:
  double m_most = 0, m_sum = 0, m_area = 0;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DISTANCE_SUM_H
