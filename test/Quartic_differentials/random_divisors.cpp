// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Random divisors of all orders on surfaces of genus 0 to 6: the run ends with a flawless T-mesh, or with a reason.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/quartic_differential.h>

using namespace CGAL::Quartic_differentials;

namespace {

// Singularities in random faces, of orders -3 to 4, with the last ones chosen so that the degree is 8g - 8.
Divisor random_divisor(const Intrinsic_triangulation& t, std::mt19937& random)
{
  Divisor divisor;
  const auto add = [&](int order) {
    const double x = Quartic_test::uniform(random, 0.05, 0.45), y = Quartic_test::uniform(random, 0.05, 0.45);
    divisor.push_back({{Face(static_cast<Mesh::size_type>(random() % t.number_of_faces())), {1 - x - y, x, y}}, order, false});
  };
  const std::size_t count = 4 + random() % 12;
  while (divisor.size() < count)
    if (const int order = static_cast<int>(random() % 8) - 3; order != 0) add(random() % 3 == 0 ? order : order < 0 ? -1 : 1);
  const int wanted = 8 * t.genus() - 8;
  while (degree(divisor) != wanted) {
    const int missing = wanted - degree(divisor);
    add(missing > 0 ? std::min(missing, 1 + static_cast<int>(random() % 2)) : std::max(missing, -1 - static_cast<int>(random() % 2)));
  }
  return divisor;
}

} // namespace

int main()
{
  std::mt19937 random(2026);
  std::vector<Quartic_test::Named_surface> surfaces = Quartic_test::sample_surfaces();
  int done = 0, infeasible = 0, numerical = 0;
  for (int n = 0; n < 120; ++n) {
    const auto& [name, surface] = surfaces[n % surfaces.size()];
    const Divisor divisor = random_divisor(surface, random);
    Visitor visitor;
    Quartic_differential_result r;
    try {
      quartic_differential(surface, divisor, {}, visitor, r);
    } catch (const Infeasible_divisor_error& e) {
      std::cout << n << ", " << name << ": " << e.what() << std::endl;
      ++infeasible;
      continue;
    } catch (const Numerical_error& e) {
      std::cout << n << ", " << name << ": " << e.what() << std::endl;
      ++numerical;
      continue;
    }
    ++done;
    CHECK_EQUAL(defect(*r.differential), "");
    CHECK_EQUAL(defect(*r.t_mesh, r.traced()), "");
    CHECK(r.metric->max_holonomy_error <= 1e-10);
    CHECK(r.metric->max_transition_error <= 1e-10);
    CHECK(r.legal->history.back() <= 1e-12);
  }
  std::cout << done << " done, " << infeasible << " refused, " << numerical << " not reached" << std::endl;
  CHECK_EQUAL(done + infeasible + numerical, 120);
  CHECK(done >= 90);
  return Quartic_test::result();
}
