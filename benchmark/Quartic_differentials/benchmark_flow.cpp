// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the discrete Ricci flow (cone metric) with fixed numbers of cones against one factorisation of the Laplacian of
// the metric that it reaches. Prints a Markdown table.

#include "Targets.h"
#include "measure.h"
#include "subject.h"

#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

const double curvature_tolerance = 1e-10;   // radians

struct Flow_case
{
  Subject subject;
  int     cones;    // poles and zeros of order 1 together
  double  target;   // seconds on the machine of the targets; not_given: none
};

std::vector<Flow_case> cases()
{
  return {{torus_of_revolution(400, 100), 24, 0.65}, {chain(4, 29), 48, 1.8}, {finer(chain(4, 29), 1), 48, 17}};
}

// One factorisation, symbolic part included, and one back-substitution, with the cones as vertices.
double floor_seconds(const Cone_metric& m)
{
  const std::vector<double> weights = cotangent_weights(m.triangulation, m.lengths);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m.triangulation.number_of_vertices()));
  b[0] = 1;
  b[b.size() - 1] = -1;
  return cpu_seconds([&] {
    Laplacian_solver fresh;
    fresh.factorize(m.triangulation, weights);
    fresh.solve(b);
  });
}

void measure(const Flow_case& c, int number_of_runs, const Targets& targets)
{
  Visitor visitor;
  const Intrinsic_triangulation input = c.subject.load();
  const Riemann_surface s = riemann_surface(input, visitor);
  const Divisor divisor = curvature_divisor(s.delaunay, s.weights, s.laplacian, c.cones);
  const auto poles = std::count_if(divisor.begin(), divisor.end(), [](const Singularity& p) { return p.order < 0; });

  Cone_metric_options options;
  options.curvature_tolerance = curvature_tolerance;
  Cone_metric m;
  std::vector<double> cpu, wall, in_pipeline, floor;
  for (int i = 0; i < number_of_runs; ++i) {
    wall.push_back(seconds([&] {
      cpu.push_back(cpu_seconds([&] {
        m = cone_metric(s.delaunay, s.homology.cochains, divisor, nullptr, options, visitor);
      }));
    }));
    in_pipeline.push_back(cpu_seconds([&] {
      cone_metric(s.delaunay, s.homology.cochains, divisor, nullptr, options, visitor, &s.laplacian);
    }));
    floor.push_back(floor_seconds(m));
  }
  std::cout << "| " << c.subject.name << " | " << input.number_of_vertices() << " | " << input.genus() << " | " << poles
            << " + " << divisor.size() - poles << " | " << m.flow.newton_iterations << " + " << m.flow.polishing_steps
            << " | " << m.flow.flips << " | " << m.flow.max_curvature_error << " | " << cell(median(cpu)) << " | "
            << cell(median(wall)) << " | " << cell(median(in_pipeline)) << " | " << cell(median(floor)) << " | "
            << cell(median(cpu) / median(floor)) << " | " << cell(peak_mebibytes()) << " |" << std::endl;
  if (m.flow.max_curvature_error > curvature_tolerance) throw Error("the flow did not reach its tolerance");
  if (!std::isnan(c.target))
    targets.add_seconds("cone metric to 1e-10, " + std::to_string(input.number_of_vertices()) + " vertices, genus "
                        + std::to_string(input.genus()) + ", " + std::to_string(divisor.size()) + " cones", c.target,
                        median(cpu));
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Times the discrete Ricci flow to 1e-10, in seconds of the processor: medians of several runs."};
  std::vector<std::string> meshes;
  int number_of_runs = 3, cones = 24;
  std::string target_file;
  app.add_option("MESH", meshes, "Closed meshes; none: generated surfaces of fixed sizes");
  app.add_option("--cones", cones, "Number of cones on a mesh, poles and zeros of order 1 (24)");
  app.add_option("-n,--runs", number_of_runs, "Number of runs, of which the median is printed (3)")
     ->check(CLI::Range(1, 1000));
  app.add_option("--targets", target_file, "File to which rows of targets and what was reached are added");
  CLI11_PARSE(app, argc, argv);

  std::vector<Flow_case> list;
  for (const std::string& path : meshes) list.push_back({from_file(path), cones, not_given});
  if (list.empty()) list = cases();

  const Targets targets(target_file);
  if (targets.wanted()) std::cout << targets.scale() << "\n\n";
  std::cout << "| surface | V | g | poles + zeros | Newton + polishing steps | flips | curvature error | flow, CPU s |"
               " by the clock | as in the pipeline | floor | flow / floor | peak MiB |\n"
               "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|" << std::endl;
  bool all_well = true;
  for (const Flow_case& c : list)
    all_well = in_own_process(c.subject.name, [&] { measure(c, number_of_runs, targets); }) && all_well;
  return all_well ? EXIT_SUCCESS : EXIT_FAILURE;
}
