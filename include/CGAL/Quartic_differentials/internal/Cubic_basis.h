// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CUBIC_BASIS_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CUBIC_BASIS_H

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// knot k of a cubic spline with n spans, 0 <= k < n + 7: 0, 0, 0, 0, 1, .. n-1, n, n, n, n
inline std::size_t knot(std::size_t k, std::size_t n) { return std::min(k < 3 ? 0 : k - 3, n); }

/// The cubic B-splines with the knots 0, 0, 0, 0, 1, 2, .. n-1, n, n, n, n that do not vanish at a parameter.
struct Cubic_basis
{
  std::size_t           first;        ///< the other three follow
  std::array<double, 4> value{1, 0, 0, 0}, derivative;

  /// \pre 0 <= t <= n and n >= 1
  /// Source: Piegl and Tiller 1997, algorithm A2.2 and equation 2.7.
  Cubic_basis(std::size_t n, double t) : first(std::min(static_cast<std::size_t>(t), n - 1))
  {
    for (int degree = 1; degree <= 3; ++degree) {
      std::array<double, 4> higher{}, slope{};
      for (int r = 0; r < degree; ++r) {   // the span of t begins with knot first + 3
        const double left = knot(first + 4 + r - degree, n), right = knot(first + 4 + r, n), share = value[r] / (right - left);
        higher[r] += (right - t) * share;
        higher[r + 1] += (t - left) * share;
        slope[r] -= degree * share;
        slope[r + 1] += degree * share;
      }
      value = higher;
      derivative = slope;
    }
  }
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CUBIC_BASIS_H
