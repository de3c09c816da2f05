// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times quantization and quad meshes of surfaces at several numbers of quads. Prints a Markdown table a surface, and
// one of what the smoothed meshes are like.

#include "measure.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>
#include <CGAL/Quartic_differentials/quad_quality.h>
#include <CGAL/Quartic_differentials/quantize.h>
#include <CGAL/Quartic_differentials/smooth_quads.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

struct Smoothed
{
  std::string  mesh;
  std::size_t  target, quads;
  double       lowered;             // least scaled Jacobian where smoothing has only lowered the energy
  Quad_quality quality;
  double       making, measuring;   // [seconds]: quantization, quad mesh and smoothing; quality
};

Smoothed print_row(const std::string& file, const Intrinsic_triangulation& input, const T_mesh& t,
                   const Refined_surface& refined, const Quantization_options& options)
{
  Visitor visitor;
  const Quantization q = quantize(t, options, visitor);
  Quad_mesh m;
  const double building = seconds([&] { m = quad_mesh(t, q.length, refined); });
  const Scaled_jacobian jacobian = scaled_jacobian(m);
  std::printf("| %zu | %zu | %zu | %zu | %zu | %zu | %td | %.2f | %s | %s | %.2f | %.2f | %.2f | %.3f |\n", q.target,
              q.number_of_quads, q.scales, q.solves, q.rounds, q.cuts,
              std::count(q.length.begin(), q.length.end(), 0), q.cost, name(q.method), q.optimal ? "yes" : "no",
              q.seconds, building, jacobian.least, jacobian.mean);
  Smoothed result{std::filesystem::path(file).stem().string(), q.target, m.quads.size(), 0, {}, 0, 0};
  const Smoothing_report smoothing = smooth_quads(input, {}, m);
  result.lowered = smoothing.history[smoothing.lowered].least;
  result.making = q.seconds + building + smoothing.seconds;
  result.measuring = seconds([&] { result.quality = quad_quality(input, m); });
  return result;
}

void print_qualities(const std::vector<Smoothed>& meshes)
{
  std::printf("| mesh | asked | quads | irregular vertices | least Jacobian by the energy | and raised | mean |"
              " angles, degrees | most edge ratio | to the input, max | rms | from the input, max | rms | made, s |"
              " measured, s |\n"
              "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const Smoothed& m : meshes) {
    const Quad_quality& q = m.quality;
    std::size_t irregular = 0;
    for (const auto& [valence, number] : q.irregular_vertices) irregular += number;
    std::printf("| %s | %zu | %zu | %zu | %.3f | %.3f | %.3f | %.1f to %.1f | %.2f | %.2e | %.2e | %.2e | %.2e | %.2f |"
                " %.2f |\n",
                m.mesh.c_str(), m.target, m.quads, irregular, m.lowered, q.scaled_jacobian.least,
                q.scaled_jacobian.mean, q.angle.least, q.angle.most, q.edge_ratio.most, q.to_input.most, q.to_input.rms,
                q.from_input.most, q.from_input.rms, m.making, m.measuring);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> files;
  std::vector<std::size_t> targets{500, 2000, 4000, 20000};
  Quantization_options options;
  CLI::App app{"Times quantization and quad meshes"};
  app.add_option("meshes", files, "Surfaces")->required()->check(CLI::ExistingFile);
  app.add_option("--quads", targets, "Numbers of quads to ask for")->capture_default_str();
  app.add_option("--time-limit", options.time_limit, "Seconds for a quantization")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  std::vector<Smoothed> smoothed;
  for (const std::string& file : files) {
    Visitor visitor;
    Quartic_differential_result result;
    std::vector<std::string> notes;
    const Intrinsic_triangulation input = read_surface(file, notes);
    quartic_differential(input, std::nullopt, {}, visitor, result);
    if (!result.refined) {
      std::cerr << file << ": the surface is not embedded\n";
      continue;
    }
    std::printf("%s: %zu singularities, %zu arcs, %zu patches\n\n", file.c_str(), result.singularities.size(),
                result.t_mesh->arcs.size(), result.t_mesh->patches.size());
    std::printf("| asked | reached | scales | programs | rounds | cuts | zero arcs | cost | method | optimal |"
                " quantization, s | mesh, s | least Jacobian | mean |\n"
                "|--:|--:|--:|--:|--:|--:|--:|--:|---|---|--:|--:|--:|--:|\n");
    for (std::size_t target : targets) {
      options.number_of_quads = target;
      smoothed.push_back(print_row(file, input, *result.t_mesh, *result.refined, options));
    }
    std::printf("\n");
  }
  print_qualities(smoothed);
}
