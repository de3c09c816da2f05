// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLAT_METRIC_ERRORS_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLAT_METRIC_ERRORS_H

#include <CGAL/Quartic_differentials/internal/face_frames.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The angles of a metric, and how far it is from flat with the given cones and with exact holonomy. [radians]
template <class FT>
struct Flat_metric_errors
{
  std::vector<FT> angles;      ///< by halfedge
  std::vector<FT> curvature;   ///< by vertex: K - target
  std::vector<FT> turning;     ///< by basis loop: T minus the nearest multiple of pi/2
};

/// \param order by vertex; \param lengths by edge
template <class FT>
Flat_metric_errors<FT> flat_metric_errors(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                          const std::vector<int>& order, const std::vector<FT>& lengths)
{
  const FT pi = half_turn<FT>();
  Flat_metric_errors<FT> e;
  e.angles = corner_angles(t, lengths);
  e.curvature = curvatures(t, e.angles);
  for (Vertex v : t.vertices())
    if (order[v] != 0) e.curvature[v] += order[v] * pi / 2;
  e.turning = turning_numbers(t, cochains, e.angles);
  for (FT& x : e.turning) x = quarter_turn_defect(x, pi);
  return e;
}

/// the largest absolute value, 0 if there is none
template <class FT>
FT largest(const std::vector<FT>& x)
{
  using std::abs;
  FT result(0);
  for (const FT& y : x) result = (std::max)(result, FT(abs(y)));
  return result;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FLAT_METRIC_ERRORS_H
