// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_DIVISOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_DIVISOR_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A zero (order > 0) or pole (order < 0) of a quartic differential: a vertex of valence order + 4 of a quad mesh,
/// a cone of angle (order + 4) * pi/2 of the flat metric. order >= -3.
///
/// On a surface with boundary also a corner of the boundary: m = order + 2 quads meet there, the interior angle is
/// m * pi/2. order >= -1; without corners the boundary is straight.
struct Singularity
{
  Surface_point location;
  int           order  = 0;
  bool          pinned = false;   ///< may not be moved
  bool          on_boundary = false;   ///< a corner: on a boundary edge of the face of `location`, see `on_edge()`
};

/// A divisor: sum of orders times points. Its degree must be 8g - 8 + 4b (Gauss-Bonnet), b the number of boundary curves.
using Divisor = std::vector<Singularity>;

int degree(const Divisor& d);
/// the degree of every divisor on a surface: 8g - 8 + 4b. Complexity: linear.
int required_degree(const Intrinsic_triangulation& t);
std::vector<Surface_point> locations(const Divisor& d);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_DIVISOR_H
