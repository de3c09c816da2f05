// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the pipeline from the file to the T-mesh, and its steps 1 to 3 against what they cannot do without: one
// factorisation of the Laplacian and 2g back-substitutions. Prints a Markdown table, in seconds.

#include "measure.h"
#include "paper_times.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CLI/CLI.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

/// A surface to run on; `load` is timed as the step "read".
struct Subject
{
  std::string                              name;
  std::function<Intrinsic_triangulation()> load;
};

/// What is measured in one run, by the names of the columns; a step that was not reached is not in it.
using Run = std::map<std::string, double>;

const std::vector<std::string> columns = {
  "read", "homology", "refinement", "holomorphic_forms", "period_matrix", "abel_jacobi", "legalization", "cone_metric",
  "holonomy", "immersion", "t_mesh", "file to T-mesh", "steps 1-3", "floor", "steps 1-3 / floor"};

// One factorisation, symbolic part included, and 2g back-substitutions of the Laplacian that steps 1 to 3 used. The
// right-hand sides are dense to the solver, so that any will do.
double floor_seconds(const Riemann_surface& s)
{
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(s.delaunay.number_of_vertices()), s.forms.size());
  b.topRows(1).setOnes();
  b.bottomRows(1).setConstant(-1);
  return seconds([&] {
    Laplacian_solver fresh;
    fresh.factorize(s.delaunay, s.weights);
    fresh.solve(b);
  });
}

Run run_once(const Subject& subject)
{
  Run run;
  Intrinsic_triangulation input;
  run["read"] = seconds([&] { input = subject.load(); });

  Visitor visitor;
  Quartic_differential_result result;
  try {
    const double rest = seconds([&] { quartic_differential(input, std::nullopt, {}, visitor, result); });
    run["file to T-mesh"] = run["read"] + rest;
  } catch (const Error& e) {   // the steps before it are still worth their times
    std::cerr << subject.name << ": " << e.what() << std::endl;
  }
  bool steps_1_to_3 = true;   // "refinement" comes again later, as a part of step 7
  for (const auto& [step, time] : result.timings) {
    steps_1_to_3 = steps_1_to_3 && step != "abel_jacobi";
    run[step] += time;
    if (steps_1_to_3) run["steps 1-3"] += time;
  }
  if (result.surface) {
    run["floor"] = floor_seconds(*result.surface);
    run["steps 1-3 / floor"] = run["steps 1-3"] / run["floor"];
  }
  return run;
}

std::string fixed(double x, int decimals)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, x);
  return text;
}

// A dash for what was not measured.
std::string cell(double x)
{
  if (std::isnan(x)) return "–";
  return fixed(x, x < 10 ? 3 : 1);
}

double median_of(const std::vector<Run>& runs, const std::string& column)
{
  std::vector<double> values;
  for (const Run& run : runs)
    if (const auto value = run.find(column); value != run.end()) values.push_back(value->second);
  return values.empty() ? not_given : median(values);
}

double peak_mebibytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.0;   // Linux counts in KiB
}

void print_row(const std::string& name, const std::string& vertices, const std::string& faces, int genus,
               const std::function<double(const std::string&)>& value, const std::string& memory)
{
  std::cout << "| " << name << " | " << vertices << " | " << faces << " | " << genus;
  for (const std::string& column : columns) std::cout << " | " << cell(value(column));
  std::cout << " | " << memory << " |" << std::endl;
}

void print_header()
{
  std::cout << "| surface | V | F | g";
  for (const std::string& column : columns) std::cout << " | " << column;
  std::cout << " | peak MiB |\n|---" << std::string("|---:");
  for (std::size_t i = 0; i < columns.size() + 3; ++i) std::cout << "|---:";
  std::cout << "|" << std::endl;
}

// The paper's row under ours: its forms and zeros are our steps 1 to 3, its Ricci flow is our cone metric.
void print_paper_row(const Paper_times& paper)
{
  const auto thousands = [](double x) { return fixed(x, 1) + "k"; };
  const double zeros = std::isnan(paper.zeros) ? 0 : paper.zeros;   // genus 1: a holomorphic form has none
  const Run times{{"holomorphic_forms", paper.holomorphic_forms}, {"steps 1-3", paper.holomorphic_forms + zeros},
                  {"legalization", paper.legalization}, {"cone_metric", paper.ricci_flow},
                  {"immersion", paper.immersion}};
  print_row(std::string("*the paper's ") + paper.model + "*", thousands(paper.kilovertices), thousands(paper.kilofaces),
            paper.genus, [&](const std::string& column) { return median_of({times}, column); }, "–");
}

Intrinsic_triangulation finer(Intrinsic_triangulation t, int subdivisions)
{
  if (subdivisions == 0) return t;
  if (!t.is_embedded()) throw Error("only surfaces in space can be subdivided here");
  Mesh mesh = t.mesh();
  for (int i = 0; i < subdivisions; ++i) mesh = subdivided(mesh);
  return Intrinsic_triangulation(std::move(mesh));
}

Subject finer_subject(const Subject& subject, int subdivisions)
{
  return {subject.name + ", subdivided " + std::to_string(subdivisions),
          [load = subject.load, subdivisions] { return finer(load(), subdivisions); }};
}

struct Measured
{
  std::size_t                   faces;
  std::map<std::string, double> medians;   // by column
};

Measured measure(const Subject& subject, int number_of_runs)
{
  const Intrinsic_triangulation t = subject.load();
  std::vector<Run> runs;
  for (int i = 0; i < number_of_runs; ++i) runs.push_back(run_once(subject));
  Measured result{t.number_of_faces(), {}};
  for (const std::string& column : columns) result.medians[column] = median_of(runs, column);
  print_row(subject.name, std::to_string(t.number_of_vertices()), std::to_string(t.number_of_faces()), t.genus(),
            [&](const std::string& column) { return result.medians[column]; }, cell(peak_mebibytes()));
  if (const Paper_times* paper = paper_times_of(subject.name, t.genus())) print_paper_row(*paper);
  return result;
}

// p in time ~ faces^p
void print_exponents(const Measured& coarse, const Measured& fine, int genus)
{
  const double ratio = std::log(static_cast<double>(fine.faces) / static_cast<double>(coarse.faces));
  print_row("*growth exponent*", "–", "–", genus, [&](const std::string& column) {
    return std::log(fine.medians.at(column) / coarse.medians.at(column)) / ratio;
  }, "–");
}

// The surface, then its triangles split into four, once more and so on, with the growth from each to the next.
void measure_growth(const Subject& subject, int number_of_runs, int subdivisions)
{
  Measured coarse = measure(subject, number_of_runs);
  const int genus = subject.load().genus();
  for (int i = 1; i <= subdivisions; ++i) {
    const Measured fine = measure(finer_subject(subject, i), number_of_runs);
    print_exponents(coarse, fine, genus);
    coarse = fine;
  }
}

// In a process of its own, so that the peak memory is that of this surface alone. Returns whether it ended well.
bool measure_apart(const Subject& subject, int number_of_runs, int growth)
{
  const pid_t child = fork();
  if (child == 0) {
    try {
      measure_growth(subject, number_of_runs, growth);
      _exit(EXIT_SUCCESS);
    } catch (const std::exception& e) {
      std::cerr << subject.name << ": " << e.what() << std::endl;
      _exit(EXIT_FAILURE);
    }
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

Subject from_file(const std::string& path)
{
  return {std::filesystem::path(path).stem().string(), [path] {
    std::vector<std::string> notes;
    return read_surface(path, notes);
  }};
}

std::vector<Subject> samples()
{
  return {{"torus(2, 1, 100, 50)", [] { return Intrinsic_triangulation(torus(2, 1, 100, 50)); }},
          {"handle_chain(2, 12)",  [] { return Intrinsic_triangulation(handle_chain(2, 12)); }},
          {"handle_chain(2, 24)",  [] { return Intrinsic_triangulation(handle_chain(2, 24)); }},
          {"handle_chain(2, 48)",  [] { return Intrinsic_triangulation(handle_chain(2, 48)); }},
          {"handle_ring(5, 24)",   [] { return Intrinsic_triangulation(handle_ring(5, 24)); }}};
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Times the pipeline from the file to the T-mesh, in seconds: medians of several runs."};
  std::vector<std::string> meshes;
  int number_of_runs = 3, subdivisions = 0, growth = 0;
  app.add_option("MESH", meshes, "Closed meshes; none: generated surfaces of growing size");
  app.add_option("-n,--runs", number_of_runs, "Number of runs, of which the median is printed (3)")
     ->check(CLI::Range(1, 1000));
  app.add_option("--subdivide", subdivisions, "How often each triangle is split into four first (0)")
     ->check(CLI::Range(0, 8));
  app.add_option("--growth", growth, "How often the triangles are split once more, with the growth of the times (0)")
     ->check(CLI::Range(0, 8));
  CLI11_PARSE(app, argc, argv);

  std::vector<Subject> subjects;
  for (const std::string& path : meshes) subjects.push_back(from_file(path));
  if (subjects.empty()) subjects = samples();

  std::cout << "Factorisation: " << Symmetric_factorization::name();
  for (const char* variable : {"OPENBLAS_NUM_THREADS", "OMP_THREAD_LIMIT"}) {
    const char* value = std::getenv(variable);
    std::cout << "; " << variable << ": " << (value ? value : "not set");
  }
  std::cout << "; median of " << number_of_runs << " runs, in seconds.\n\n";
  print_header();
  bool all_well = true;
  for (Subject& subject : subjects) {
    if (subdivisions > 0) subject = finer_subject(subject, subdivisions);
    all_well = measure_apart(subject, number_of_runs, growth) && all_well;
  }
  return all_well ? EXIT_SUCCESS : EXIT_FAILURE;
}
