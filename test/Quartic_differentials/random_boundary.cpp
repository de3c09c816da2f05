// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Random divisors with corners on surfaces with boundary, genus 0 to 3 with 1 to 5 curves, some with obtuse triangles at the
// boundary: the flat metric has straight axis-parallel boundary and exact holonomy, or there is a reason why not.

#include "check.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/cone_metric.h>

using namespace Quartic_test;

int main()
{
  std::mt19937 random(2026);
  const std::vector<Surface_with_boundary> surfaces = surfaces_with_boundary();
  const int cases = 36;
  Outcomes outcomes;
  Visitor visitor;
  for (int n = 0; n < cases; ++n) {
    const Surface_with_boundary& s = surfaces[n % surfaces.size()];
    const bool obtuse = n % 3 == 2;
    const Prepared_surface p(obtuse ? with_obtuse_rim(s.surface, 179, random) : s.surface);
    const std::vector<std::vector<int>> corners = random_corners(s.curves, random);
    const Divisor divisor = random_divisor(p.delaunay, corners, static_cast<int>(random() % 4), random);
    std::cout << n << ", " << s.name << (obtuse ? ", obtuse rim, " : ", ") << divisor.size() << " singularities: "
              << std::flush;
    outcomes.add([&] {
      const Legal_divisor legal = legalize_divisor(p.map, divisor, {}, visitor);
      CHECK(legal.history.back() <= 1e-12);
      const Exact_cone_metric m = exact_cone_metric(p.delaunay, p.homology.cochains, legal.divisor, {}, visitor);
      std::cout << "curvature " << m.metric.flow.max_curvature_error << ", holonomy " << m.max_holonomy_error << ", edges "
                << m.max_transition_error << std::endl;
      if (!m.reached) return false;
      CHECK(m.max_holonomy_error <= 1e-10);
      CHECK(m.max_transition_error <= 1e-10);
      CHECK(m.metric.flow.max_curvature_error <= m.metric.flow.tolerance);
      return true;
    });
  }
  std::cout << outcomes << std::endl;
  CHECK(outcomes.reached >= 30);
  return Quartic_test::result();
}
