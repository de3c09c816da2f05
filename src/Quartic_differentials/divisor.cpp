// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/divisor.h>

namespace CGAL {
namespace Quartic_differentials {

int degree(const Divisor& d)
{
  int sum = 0;
  for (const Singularity& s : d) sum += s.order;
  return sum;
}

int required_degree(const Intrinsic_triangulation& t)
{ return 8 * t.genus() - 8 + 4 * t.number_of_boundary_curves(); }

std::vector<Surface_point> locations(const Divisor& d)
{
  std::vector<Surface_point> points;
  for (const Singularity& s : d) points.push_back(s.location);
  return points;
}

} } // namespace CGAL::Quartic_differentials
