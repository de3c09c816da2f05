// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_RUN_PIPELINE_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_RUN_PIPELINE_H

#include <CGAL/Quartic_differentials/pipeline.h>

#include <optional>

namespace Quartic_test {

/// the results of the pipeline with singularities of its own choice
inline CGAL::Quartic_differentials::Quartic_differential_result
run_pipeline(const CGAL::Quartic_differentials::Intrinsic_triangulation& input,
             const CGAL::Quartic_differentials::Quartic_differential_options& options = {})
{
  CGAL::Quartic_differentials::Visitor visitor;
  CGAL::Quartic_differentials::Quartic_differential_result result;
  quartic_differential(input, std::nullopt, options, visitor, result);
  return result;
}

/// the results of the pipeline with a divisor, in which all corners of the boundary are
inline CGAL::Quartic_differentials::Quartic_differential_result
run_pipeline(const CGAL::Quartic_differentials::Intrinsic_triangulation& input,
             const CGAL::Quartic_differentials::Divisor& divisor,
             CGAL::Quartic_differentials::Quartic_differential_options options = {})
{
  options.corners = CGAL::Quartic_differentials::Divisor();
  CGAL::Quartic_differentials::Visitor visitor;
  CGAL::Quartic_differentials::Quartic_differential_result result;
  quartic_differential(input, divisor, options, visitor, result);
  return result;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_RUN_PIPELINE_H
