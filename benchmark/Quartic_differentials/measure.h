// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_MEASURE_H
#define CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_MEASURE_H

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
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

/// the processor's time spent by this process so far, in all its threads and for it in the system. [seconds]
inline double cpu_clock() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// the processor's time for `work()`, which other processes hardly change. [seconds]
template <class Work>
double cpu_seconds(Work&& work)
{
  const double begin = cpu_clock();
  work();
  return cpu_clock() - begin;
}

/// the middle of the sorted values, the mean of the two middle ones if their number is even.
/// \pre `values` is not empty
inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

/// What was not measured.
constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

inline std::string fixed(double x, int decimals)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, x);
  return text;
}

/// a number for a table; a dash for what was not measured.
inline std::string cell(double x)
{
  if (std::isnan(x)) return "–";
  return fixed(x, x < 10 ? 3 : x < 1000 ? 1 : 0);
}

/// the most memory that this process has held so far. [MiB]
inline double peak_mebibytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;   // Linux counts in KiB
}

/// does `work()` in a process of its own, so that the peak memory is that of the work alone, and says whether it ended
/// well. An exception becomes a line on stderr.
template <class Work>
bool in_own_process(const std::string& name, Work&& work)
{
  malloc_trim(0);   // what was freed here would count as the child's
  const pid_t child = fork();
  if (child == 0) {
    try {
      work();
      std::cout.flush();
      _exit(EXIT_SUCCESS);
    } catch (const std::exception& e) {
      std::cerr << name << ": " << e.what() << std::endl;
      _exit(EXIT_FAILURE);
    }
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

#endif // CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_MEASURE_H
