// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DIAGONAL_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DIAGONAL_H

#include <CGAL/Bbox_3.h>

#include <cmath>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// the length of the diagonal of the bounding box of points. \pre there is a point
template <class Points>
double diagonal(const Points& points)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_DIAGONAL_H
