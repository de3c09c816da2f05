// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_MEASURE_H
#define CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_MEASURE_H

#include <algorithm>
#include <chrono>
#include <vector>

/// the wall-clock time of `work()`. [seconds]
template <class Work>
double seconds(Work&& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return elapsed.count();
}

/// the middle of the sorted values, the mean of the two middle ones if their number is even.
/// \pre `values` is not empty
inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

#endif // CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_MEASURE_H
