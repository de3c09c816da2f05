// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/boundary_corners.h>
#include <CGAL/Quartic_differentials/choose_corners.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double farthest = 0.03;   // that a corner may slide while it could stay, times sqrt(area)

double price(const Chosen_singularities& c, const Singularity_choice_options& options)
{ return c.distortion + 0.5 * options.worth * static_cast<double>(c.divisor.size()); }

// Whether the first corners of two divisors are near each other along the boundary.
bool are_near(const Intrinsic_triangulation& t, const Divisor& a, const Divisor& b, std::size_t corners)
{
  const double most = farthest * std::sqrt(t.area());
  for (std::size_t k = 0; k < corners; ++k) {
    const auto x = internal::boundary_place(t, a[k].location), y = internal::boundary_place(t, b[k].location);
    const double way = std::min(internal::way_along_boundary(t, x, y, most), internal::way_along_boundary(t, y, x, most));
    if (way > most) return false;
  }
  return true;
}

} // namespace

Chosen_singularities choose_corners_and_singularities(const Riemann_surface& surface, const Divisor& given,
                                                      const Singularity_choice_options& options,
                                                      const Legalization_options& legalization,
                                                      const Distortion_options& distortion, Visitor& visitor)
{
  Divisor with_corners = boundary_corners(surface.delaunay);
  const std::size_t corners = with_corners.size();
  with_corners.insert(with_corners.end(), given.begin(), given.end());
  const auto chosen = [&] {
    return choose_singularities(surface, with_corners, options, legalization, distortion, visitor);
  };

  std::optional<Chosen_singularities> pinned;
  try {
    pinned = chosen();
  } catch (const Infeasible_divisor_error&) {
    if (corners == 0) throw;   // otherwise they may have to slide
  }
  if (pinned && (corners == 0 || pinned->divisor.size() == with_corners.size())) return *pinned;
  for (std::size_t k = 0; k < corners; ++k) with_corners[k].pinned = false;
  try {
    Chosen_singularities sliding = chosen();
    const bool is_better = pinned && price(sliding, options) < price(*pinned, options);
    if (!pinned || (is_better && are_near(surface.delaunay, sliding.divisor, with_corners, corners))) return sliding;
  } catch (const Infeasible_divisor_error&) {
    if (!pinned) throw;
  }
  return *pinned;
}

} } // namespace CGAL::Quartic_differentials
