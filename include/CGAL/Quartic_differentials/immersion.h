// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IMMERSION_H
#define CGAL_QUARTIC_DIFFERENTIALS_IMMERSION_H

#include <CGAL/Quartic_differentials/Quartic_differential.h>
#include <CGAL/Quartic_differentials/internal/cut_to_disk.h>
#include <CGAL/Quartic_differentials/internal/layout.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// The grid of `immersion()`.
struct Immersion_options
{
  /// grid units are 2^-grid_exponent times the largest coordinate, 20 <= grid_exponent <= 50;
  /// 0 takes the first of 44, 46, 48, 50 that keeps the orientation of every triangle
  int grid_exponent = 0;
};

/// What is known of the quality of an immersion.
struct Immersion_report
{
  int         grid_exponent     = 0;
  std::size_t cut_edges         = 0;   ///< of the cut graph, without the boundary
  std::size_t segments          = 0;   ///< of the cut graph, without the boundary
  std::size_t flipped_triangles = 0;   ///< flipped or degenerate after rounding to the grid
  double      rotation_error    = 0;   ///< [radians] farthest that the rotation across a cut edge, or the direction of a
                                       ///< boundary edge, is from k*90 degrees
  double      layout_gap        = 0;   ///< farthest that the layout's copies of a corner are apart; fraction of the size
  Grid_vector closure_residual;        ///< sum of (1 - i^k) d over the segments, and of the vectors along the boundary,
                                       ///< before it was spread over them
  double      largest_move      = 0;   ///< farthest that a corner moved from the layout; fraction of the size
  double      min_altitude      = 0;   ///< smallest altitude of a flat triangle, in grid units; not positive if flipped
};

namespace internal {

/// the surface, cut open along short loops through all singularities
Cut_disk cut_at_cones(const Intrinsic_triangulation& t, const std::vector<double>& flat_lengths,
                      const std::vector<Vertex>& singularities);

/// moves a layout to the grid: what `immersion()` does after it
Quartic_differential immersion_of_layout(const Intrinsic_triangulation& t, const std::vector<double>& flat_lengths,
                                         const Cut_disk& disk, Layout plane, const std::vector<Vertex>& singularities,
                                         const std::vector<int>& order, double surface_area,
                                         const Immersion_options& options, Immersion_report& report);

} // namespace internal

/// lays the flat metric out in the plane and moves it, by no more than the layout's own rounding, to a dyadic grid on
/// which everything is exact: charts change across every edge by a rotation by k*90 degrees and a translation, and
/// round every vertex the changes compose to the rotation of its cone about that vertex.
///
/// Boundary edges become parallel to the axes. The exactness of the transitions and of these directions is guaranteed for
/// every input that is accepted. Not guaranteed: that the smallest
/// triangles keep their orientation when they are moved to the grid; `report.flipped_triangles` counts those that did
/// not, and `require_resolved_triangles()` refuses them.
///
/// \tparam FT the number type of the layout, with sqrt and conversions from and to `double`
/// \param flat_lengths by edge of t: a flat metric with cones at the singularities, holonomy in multiples of 90 degrees, and
///        a straight boundary but for corners of multiples of 90 degrees
/// \param singularities the vertices of the divisor
/// \param order by vertex; the cone angle is (order + 4)*90 degrees, the angle of a corner (order + 2)*90 degrees
/// \param surface_area of the input, to which `surface_units_per_unit` refers
/// \param report is filled even if the function throws
/// \pre t is connected, and the orders are at least -3, vanish outside the singularities and sum to 8g - 8 + 4b
/// \throws Numerical_error if a rotation across the cut is not a multiple of 90 degrees to 1e-6 radians, or the exact
///         cone at a vertex is not the one of its order
/// Complexity: O(n log n). Source: METHOD, step 7; paper, section 4.7.
template <class FT>
Quartic_differential immersion(const Intrinsic_triangulation& t, const std::vector<FT>& flat_lengths,
                               const std::vector<Vertex>& singularities, const std::vector<int>& order,
                               double surface_area, const Immersion_options& options, Immersion_report& report)
{
  std::vector<double> rounded;
  for (const FT& l : flat_lengths) rounded.push_back(static_cast<double>(l));
  const internal::Cut_disk disk = internal::cut_at_cones(t, rounded, singularities);
  return internal::immersion_of_layout(t, rounded, disk, internal::layout(t, flat_lengths, rounded, disk), singularities,
                                       order, surface_area, options, report);
}

/// says how many triangles are flipped or degenerate, or that the smallest altitude is under 100 times the rounding of
/// the layout (its shape is then a matter of rounding), as a clause of a sentence; otherwise returns "".
std::string unresolved_triangles(const Immersion_report& report);

/// \throws Numerical_error with what `unresolved_triangles()` says, and what helps
void require_resolved_triangles(const Immersion_report& report);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IMMERSION_H
