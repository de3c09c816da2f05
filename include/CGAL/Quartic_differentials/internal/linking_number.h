// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LINKING_NUMBER_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LINKING_NUMBER_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

using Exact_kernel  = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_point_3 = Exact_kernel::Point_3;
using Exact_point_2 = Exact_kernel::Point_2;

struct Exact_segment { Exact_point_3 source, target; };

/// One of finitely many fixed parallel projections of space to a plane, exact: the plane is seen from the side that
/// the direction of projection points to, in right-handed coordinates.
class Projection
{
public:
  static constexpr int number = 20;
  /// \pre `0 <= k < number`
  explicit Projection(int k);
  Exact_point_2 operator()(const Exact_point_3& p) const;

private:
  int m_a, m_b, m_c;   // the direction, m_c > 0
};

/// A place where the upper of two segments hides a point of the lower one.
struct Crossing
{
  std::size_t lower, upper;
  int         sign;          ///< of the crossing in a diagram of a link: +1 if (upper, lower) turns left
};

/// finds all crossings in which a segment of `upper` passes over one of `lower`, exactly.
/// Nothing is returned if two segments touch in the projection in any other way than that their interiors cross,
/// or if they meet in space.
/// \param ignore pairs (lower, upper) that are not looked at
/// Complexity: O(n log^2 n + boxes of segments that overlap in the projection).
std::optional<std::vector<Crossing>>
crossings_over(const std::vector<Exact_segment>& lower, const std::vector<Exact_segment>& upper,
               const Projection& projection, const std::function<bool(std::size_t, std::size_t)>& ignore);

/// the linking number of two closed polylines, exactly; +1 for the unit circle (cos s, sin s, 0) and the circle
/// through its centre (0, 1 + cos s, -sin s).
/// \throws Numerical_error if they meet (or touch in all the projections)
/// Complexity: as `crossings_over()`.
int linking_number(const std::vector<Point_3>& x, const std::vector<Point_3>& y);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LINKING_NUMBER_H
