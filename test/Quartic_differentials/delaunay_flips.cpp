// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Delaunay decision is exact, and never flags both diagonals of a quadrilateral.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>

#include <cmath>
#include <random>

using namespace CGAL::Quartic_differentials;

namespace {

bool not_delaunay_in_rationals(double e, double a, double b, double c, double d)
{
  using Q = CGAL::Exact_rational;
  const Q qe(e), qa(a), qb(b), qc(c), qd(d);
  const Q p = (qa * qa + qb * qb - qe * qe) * qc * qd + (qc * qc + qd * qd - qe * qe) * qa * qb;
  const Q m = (qa * qa + qb * qb + qe * qe) * qc * qd + (qc * qc + qd * qd + qe * qe) * qa * qb;
  const Q value = p + m * Q(16 * 0x1p-53);
  return value < 0;
}

double chord(double from, double to) { return 2 * std::abs(std::sin(0.5 * (to - from))); }

// four points in order round the unit circle: every decision is a matter of rounding
void cocircular(std::mt19937& random)
{
  int flagged = 0;
  for (int n = 0; n < 100000; ++n) {
    double angle[4];
    for (double& x : angle) x = Quartic_test::uniform(random, 0, 6.283185307179586);
    std::sort(angle, angle + 4);
    const double ij = chord(angle[0], angle[2]), kl = chord(angle[1], angle[3]);
    const double il = chord(angle[0], angle[1]), lj = chord(angle[1], angle[2]);
    const double jk = chord(angle[2], angle[3]), ki = chord(angle[3], angle[0]);
    const bool one = certified_not_delaunay(ij, jk, ki, il, lj);
    const double flipped = (jk * il + ki * lj) / ij;   // Ptolemy
    const bool other = certified_not_delaunay(flipped, ki, il, lj, jk);
    CHECK(!(one && other));
    flagged += one + other;
    if (n % 50 == 0) {
      CHECK_EQUAL(one, not_delaunay_in_rationals(ij, jk, ki, il, lj));
      CHECK_EQUAL(certified_not_delaunay(kl, ki, il, lj, jk), not_delaunay_in_rationals(kl, ki, il, lj, jk));
    }
  }
  CHECK(flagged < 1000);
}

void near_cocircular(std::mt19937& random)
{
  int yes = 0, no = 0;
  for (int n = 0; n < 5000; ++n) {
    double length[5];
    for (double& x : length) x = Quartic_test::uniform(random, 0.5, 1);
    // choose e so that the polynomial is zero up to rounding, then perturb by a few units in the last place
    const double a = length[1], b = length[2], c = length[3], d = length[4];
    const double e = std::sqrt(((a * a + b * b) * c * d + (c * c + d * d) * a * b) / (a * b + c * d));
    const double tried = e * (1 + static_cast<int>(random() % 65) * 0x1p-53);
    const bool decided = certified_not_delaunay(tried, a, b, c, d);
    CHECK_EQUAL(decided, not_delaunay_in_rationals(tried, a, b, c, d));
    (decided ? yes : no)++;
  }
  CHECK(yes > 100 && no > 100);
}

void extreme_scales()
{
  for (double s : {1e-90, 1e-60, 1e60, 1e80}) {
    CHECK(certified_not_delaunay(1.9 * s, s, s, s, s));
    CHECK(!certified_not_delaunay(1.2 * s, s, s, s, s));
  }
}

void flips_reach_delaunay()
{
  for (const auto& [name, surface] : Quartic_test::sample_surfaces()) {
    Intrinsic_triangulation t = surface;
    const std::size_t flips = make_delaunay(t);
    std::cout << name << ": " << flips << " flips" << std::endl;
    CHECK_EQUAL(structural_defect(t), "");
    CHECK_NEAR(t.area() / surface.area(), 1, 1e-11);
    CHECK_EQUAL(make_delaunay(t), 0u);
    // curvature is a matter of the surface, not of its triangulation
    const auto before = curvatures(surface, corner_angles(surface, surface.lengths()));
    const auto after = curvatures(t, corner_angles(t, t.lengths()));
    double worst = 0;
    for (std::size_t v = 0; v < before.size(); ++v) worst = std::max(worst, std::abs(before[v] - after[v]));
    CHECK(worst < 1e-9);
  }
}

} // namespace

int main()
{
  std::mt19937 random(7);
  cocircular(random);
  near_cocircular(random);
  extreme_scales();
  flips_reach_delaunay();
  return Quartic_test::result();
}
