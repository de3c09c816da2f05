// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_REPORT_H
#define QUARTIC_REPORT_H

#include <CGAL/Quartic_differentials/pipeline.h>

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

using Json = nlohmann::ordered_json;

/// What a run was about, beside its result.
struct Run_facts
{
  std::string                                   command;   ///< the command line, quoted for a shell
  std::string                                   mesh;      ///< path of the input
  std::string                                   folder;    ///< path of the output
  std::vector<std::string>                      notes;     ///< what reading it had to say
  const CGAL::Quartic_differentials::Intrinsic_triangulation* input = nullptr;
  std::string                                   failure;   ///< why the run did not end, or ""
  std::vector<std::pair<std::string, double>>   timings;   ///< seconds outside of the pipeline
};

/// the part of report.json up to the period matrix (`quartic info --json`)
Json surface_report(const Run_facts& facts, const CGAL::Quartic_differentials::Riemann_surface* surface);

/// report.json (report.schema.json), with what was reached
Json run_report(const Run_facts& facts, const CGAL::Quartic_differentials::Quartic_differential_result& result);

/// the report for people, at the end of a run
void print_summary(std::ostream& out, const Json& report);

#endif // QUARTIC_REPORT_H
