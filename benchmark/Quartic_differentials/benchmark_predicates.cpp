// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the exact Delaunay predicate on quadrilaterals in general position, on cocircular ones, and on those where its
// value is nearest to the margin and its filter has to give up. Prints a Markdown table.

#include "measure.h"

#include <CGAL/Quartic_differentials/delaunay_flips.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <iostream>
#include <random>
#include <vector>

using CGAL::Quartic_differentials::certified_not_delaunay;

namespace {

/// Both diagonals and the sides of a convex quadrilateral i, l, j, k, named as in `certified_not_delaunay()`.
struct Quadrilateral { double e, f, a, b, c, d; };

// Four directions in order round the origin, at distances between `nearest` and 1: cocircular if `nearest` is 1. The
// first diagonal is drawn out by the factor `stretch`.
Quadrilateral random_quadrilateral(std::mt19937_64& random, double nearest, double stretch)
{
  std::uniform_real_distribution<double> angle(0, 2 * 3.14159265358979323846), distance(nearest, 1);
  std::array<double, 4> directions;
  for (double& direction : directions) direction = angle(random);
  std::sort(directions.begin(), directions.end());
  std::array<std::complex<double>, 4> p;
  for (int m = 0; m < 4; ++m) p[m] = std::polar(nearest < 1 ? distance(random) : 1.0, directions[m]);
  const auto& [i, l, j, k] = p;
  return {stretch * std::abs(j - i), std::abs(l - k), std::abs(k - j), std::abs(i - k), std::abs(l - i), std::abs(j - l)};
}

bool flags_first(const Quadrilateral& q)  { return certified_not_delaunay(q.e, q.a, q.b, q.c, q.d); }
bool flags_second(const Quadrilateral& q) { return certified_not_delaunay(q.f, q.d, q.a, q.b, q.c); }

void measure(const char* name, double nearest, double stretch, std::size_t number, int number_of_runs)
{
  std::mt19937_64 random(1);
  std::vector<Quadrilateral> input;
  for (std::size_t i = 0; i < number; ++i) input.push_back(random_quadrilateral(random, nearest, stretch));

  std::vector<double> times;
  std::size_t flagged = 0;
  for (int i = 0; i < number_of_runs; ++i)
    times.push_back(seconds([&] { flagged = std::count_if(input.begin(), input.end(), flags_first); }));
  const std::size_t both = std::count_if(input.begin(), input.end(),
                                         [](const Quadrilateral& q) { return flags_first(q) && flags_second(q); });
  std::cout << "| " << name << " | " << number << " | " << 1e9 * median(times) / number << " | " << flagged << " | "
            << both << " |" << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Times the exact Delaunay predicate: medians of several runs."};
  int number_of_runs = 3;
  std::size_t number = 1000000;
  app.add_option("-n,--runs", number_of_runs, "Number of runs, of which the median is printed (3)")
     ->check(CLI::Range(1, 1000));
  app.add_option("--calls", number, "Number of quadrilaterals (1000000)")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  std::cout << "| quadrilaterals | number | ns a call | first diagonal flagged | both flagged |\n"
               "|---|---:|---:|---:|---:|" << std::endl;
  measure("general position", 0.5, 1, number, number_of_runs);
  measure("cocircular", 1, 1, number, number_of_runs);
  // on cocircular lengths a relative change x of e changes the polynomial by -x times its magnitude: x = 16 eps is the
  // margin
  measure("at the margin", 1, 1 + 0x1p-49, number, number_of_runs);
}
