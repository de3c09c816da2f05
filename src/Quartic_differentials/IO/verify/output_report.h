// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VERIFY_OUTPUT_REPORT_H
#define CGAL_QUARTIC_DIFFERENTIALS_VERIFY_OUTPUT_REPORT_H

#include "output_files.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

struct Quads_report
{
  std::int64_t quads = 0, vertices = 0, patches = 0;
  double       least_jacobian = 0;
};

/// What report.json says of the results.
struct Report
{
  std::int64_t                genus = 0, boundary_curves = 0;
  std::vector<std::int64_t>   orders;          // of singularities, sorted
  std::vector<std::int64_t>   corner_orders;   // two less than the quads at a corner of the boundary, sorted
  std::optional<Quads_report> quads;

  bool         is_closed() const { return boundary_curves == 0; }
  std::int64_t euler_characteristic() const { return 2 - 2 * genus - boundary_curves; }
  std::int64_t degree() const { return 8 * genus - 8 + 4 * boundary_curves; }
};

Report read_report(const std::string& folder);

// The formulas, as they are said
std::string euler_text(const Report& report);
std::string degree_text(const Report& report);
std::string curves_text(std::size_t n);

std::size_t number_of_curves(const Report& report);

} } } // namespace CGAL::Quartic_differentials::verification

#endif // CGAL_QUARTIC_DIFFERENTIALS_VERIFY_OUTPUT_REPORT_H
