// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_REPORT_H
#define QUARTIC_REPORT_H

#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>
#include <CGAL/Quartic_differentials/quantize.h>
#include <CGAL/Quartic_differentials/smooth_quads.h>

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

using Json = nlohmann::ordered_json;

/// What a run was about, beside its result.
struct Run_facts
{
  std::string                                   mesh;      ///< path of the input
  std::vector<std::string>                      notes;     ///< what reading it had to say
  const CGAL::Quartic_differentials::Intrinsic_triangulation* input = nullptr;
  std::string                                   failure;   ///< why the run did not end, or ""
  std::vector<std::pair<std::string, double>>   timings;   ///< seconds outside of the pipeline
};

/// The quad mesh, if it was asked for.
struct Quads
{
  CGAL::Quartic_differentials::Quantization     quantization;
  CGAL::Quartic_differentials::Quad_mesh        mesh;
  CGAL::Quartic_differentials::Smoothing_report smoothing;   ///< empty if the mesh was not smoothed
};

/// the part of report.json up to the period matrix (`quartic info --json`)
Json surface_report(const Run_facts& facts, const CGAL::Quartic_differentials::Riemann_surface* surface);

/// report.json (METHOD, output files), with what was reached
Json run_report(const Run_facts& facts, const CGAL::Quartic_differentials::Quartic_differential_result& result,
                const std::optional<Quads>& quads);

/// the report for people, at the end of a run
void print_summary(std::ostream& out, const Json& report);

#endif // QUARTIC_REPORT_H
