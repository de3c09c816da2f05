// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_TARGETS_H
#define CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_TARGETS_H

#include "measure.h"
#include "subject.h"

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// What the package wants to reach, against what was measured: rows of a Markdown table, appended to a file.
///
/// Times are stated for a machine that needs 0.30 s for one Cholesky factorisation, symbolic part included, of the
/// Laplacian of the mesh "fertility" (56k vertices, genus 4); they are scaled by what this machine needs.
class Targets
{
public:
  /// \param file where rows go; empty: nothing is measured and no row is written
  explicit Targets(std::string file) : m_file(std::move(file))
  {
    if (m_file.empty()) return;
    const Subject subject = reference();
    m_name = subject.name;
    m_seconds = factorization_seconds(subject.load());
  }

  /// one line about the factorisation by which times are scaled
  std::string scale() const
  {
    return "One factorisation of the Laplacian of " + m_name + " takes " + fixed(m_seconds, 3)
           + " s of the processor here, 0.300 s on the machine for which the targets are stated.";
  }
  bool wanted() const { return !m_file.empty(); }

  /// `limit`, in seconds on the machine of the targets, against CPU seconds
  void add_seconds(const std::string& what, double limit, double measured) const
  {
    add(what, cell(limit) + " s", limit * m_seconds / 0.30, measured, " s");
  }
  /// `limit` in a unit that does not depend on the machine
  void add_number(const std::string& what, double limit, double measured, const std::string& unit) const
  {
    add(what, cell(limit) + unit, limit, measured, unit);
  }

private:
  static Subject reference()
  {
    const char* folder = std::getenv("QUARTIC_TEST_MESHES");
    const std::string file = folder ? std::string(folder) + "/fertility_112k.off" : "";
    return std::filesystem::exists(file) ? from_file(file) : chain(4, 25);   // of the same size
  }

  static double factorization_seconds(CGAL::Quartic_differentials::Intrinsic_triangulation t)
  {
    namespace QD = CGAL::Quartic_differentials;
    QD::make_delaunay(t);
    const std::vector<double> weights = QD::cotangent_weights(t, t.lengths());
    std::vector<double> times;
    for (int i = 0; i < 5; ++i)
      times.push_back(cpu_seconds([&] { QD::Laplacian_solver().factorize(t, weights); }));
    return median(times);
  }

  void add(const std::string& what, const std::string& stated, double limit, double measured,
           const std::string& unit) const
  {
    if (!wanted()) return;
    std::ofstream out(m_file, std::ios::app);
    out << "| " << what << " | " << stated << " | " << cell(limit) << unit << " | " << cell(measured) << unit << " | ";
    if (std::isnan(measured)) out << "**not measured: the run failed**";
    else out << (measured <= limit ? "met" : "**missed**") << ", " << fixed(measured / limit, 2) << " of it";
    out << " |\n";
  }

  std::string m_file, m_name;
  double      m_seconds = not_given;
};

#endif // CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_TARGETS_H
