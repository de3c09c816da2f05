// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the pipeline from the file to the T-mesh, and quads and splines from it; its steps 1 to 3 against what they
// cannot do without: one factorisation of the Laplacian and 2g back-substitutions. Prints Markdown tables.

#include "Targets.h"
#include "measure.h"
#include "paper_times.h"
#include "subject.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/multipatch.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

/// What is measured in one run, by the names of the columns; a step that was not reached is not in it.
using Run = std::map<std::string, double>;

const std::vector<std::string> steps = {
  "read", "homology", "refinement", "holomorphic_forms", "period_matrix", "abel_jacobi", "legalization", "cone_metric",
  "holonomy", "immersion", "t_mesh"};
const std::vector<std::string> after_t_mesh = {"quads", "splines"};
const std::vector<std::string> sums = {"file to T-mesh", "by the clock", "steps 1-3", "floor"};
const std::vector<std::string> others = {"steps 1-3 / floor", "steps 2-3 / floor", "cone_metric / floor", "peak MiB",
                                         "bytes per face"};

std::vector<std::string> joined(std::initializer_list<std::vector<std::string>> lists)
{
  std::vector<std::string> result;
  for (const auto& list : lists) result.insert(result.end(), list.begin(), list.end());
  return result;
}

const std::vector<std::string> columns = joined({steps, sums, after_t_mesh, others});

/// Keeps the processor's time of every step, in the order they end. Steps are not nested.
class Stage_clock : public Visitor
{
public:
  void step_begins(const std::string&) override { m_begin = cpu_clock(); }
  void step_ends(const std::string& name, double) override { m_times.emplace_back(name, cpu_clock() - m_begin); }
  const std::vector<std::pair<std::string, double>>& times() const { return m_times; }

private:
  double m_begin = 0;
  std::vector<std::pair<std::string, double>> m_times;
};

// One factorisation, symbolic part included, and 2g back-substitutions of the Laplacian that steps 1 to 3 used. The
// right-hand sides are dense to the solver, so that any will do.
double floor_seconds(const Riemann_surface& s)
{
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(s.delaunay.number_of_vertices()), s.forms.size());
  b.topRows(1).setOnes();
  b.bottomRows(1).setConstant(-1);
  return cpu_seconds([&] {
    Laplacian_solver fresh;
    fresh.factorize(s.delaunay, s.weights);
    fresh.solve(b);
  });
}

// About `number` quads in square blocks, made ready and measured, and splines on them.
void time_quads(const Intrinsic_triangulation& input, const Quartic_differential_result& result, std::size_t number,
                Run& run)
{
  Quad_options options;
  options.quantization.number_of_quads = number;
  options.splines = true;
  Visitor visitor;
  std::optional<Quads> q;
  const double both = cpu_seconds([&] { q = quads(input, *result.t_mesh, *result.refined, options, visitor); });
  run["splines"] = cpu_seconds([&] {
    multipatch_quality(input, multipatch(input, surface_mesh(q->mesh, *result.t_mesh)));
  });
  run["quads"] = both - run["splines"];
}

Run run_once(const Subject& subject, std::size_t number_of_quads)
{
  Run run;
  Intrinsic_triangulation input;
  Stage_clock clock;
  Quartic_differential_result result;
  double cpu = 0;
  const double wall = seconds([&] {
    cpu = cpu_seconds([&] {
      run["read"] = cpu_seconds([&] { input = subject.load(); });
      try {
        quartic_differential(input, std::nullopt, {}, clock, result);
      } catch (const Error& e) {   // the steps before it are still worth their times
        std::cerr << subject.name << ": " << e.what() << std::endl;
      }
    });
  });
  run["peak MiB"] = peak_mebibytes();
  run["bytes per face"] = run["peak MiB"] * 1024 * 1024 / static_cast<double>(input.number_of_faces());
  bool steps_1_to_3 = true;   // "refinement" comes again later, as a part of step 7
  for (const auto& [step, time] : clock.times()) {
    steps_1_to_3 = steps_1_to_3 && step != "abel_jacobi";
    run[step] += time;
    if (steps_1_to_3) run["steps 1-3"] += time;
  }
  if (result.t_mesh) {
    run["file to T-mesh"] = cpu;
    run["by the clock"] = wall;
  }
  if (result.surface) {
    run["floor"] = floor_seconds(*result.surface);
    run["steps 1-3 / floor"] = run["steps 1-3"] / run["floor"];
    run["steps 2-3 / floor"] = (run["holomorphic_forms"] + run["period_matrix"]) / run["floor"];
    if (const auto flow = run.find("cone_metric"); flow != run.end())
      run["cone_metric / floor"] = flow->second / run["floor"];
  }
  if (number_of_quads > 0 && result.t_mesh && result.refined) time_quads(input, result, number_of_quads, run);
  return run;
}

double median_of(const std::vector<Run>& runs, const std::string& column)
{
  std::vector<double> values;
  for (const Run& run : runs)
    if (const auto value = run.find(column); value != run.end()) values.push_back(value->second);
  return values.empty() ? not_given : median(values);
}

struct Measured
{
  std::string                   name;
  std::size_t                   vertices, faces;
  int                           genus;
  std::map<std::string, double> medians;   // by column
};

Measured measured(const Subject& subject, int number_of_runs, std::size_t number_of_quads)
{
  Measured result{subject.name, 0, 0, 0, {}};
  std::optional<Stored_subject> stored;
  {
    const Intrinsic_triangulation t = subject.load();
    result.vertices = t.number_of_vertices();
    result.faces = t.number_of_faces();
    result.genus = t.genus();
    if (!subject.is_file && t.is_embedded()) stored.emplace(subject.name, t.mesh());
  }
  std::vector<Run> runs;
  for (int i = 0; i < number_of_runs; ++i)
    runs.push_back(run_once(stored ? stored->subject() : subject, number_of_quads));
  for (const std::string& column : columns) result.medians[column] = median_of(runs, column);
  return result;
}

// ---- One row a surface

void print_row(const std::string& name, const std::string& vertices, const std::string& faces, int genus,
               const std::function<double(const std::string&)>& value)
{
  std::cout << "| " << name << " | " << vertices << " | " << faces << " | " << genus;
  for (const std::string& column : columns) std::cout << " | " << cell(value(column));
  std::cout << " |" << std::endl;
}

void print_header()
{
  std::cout << "| surface | V | F | g";
  for (const std::string& column : columns) std::cout << " | " << column;
  std::cout << " |\n|---";
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
            paper.genus, [&](const std::string& column) { return median_of({times}, column); });
}

void print(const Measured& m)
{
  print_row(m.name, std::to_string(m.vertices), std::to_string(m.faces), m.genus,
            [&](const std::string& column) { return m.medians.at(column); });
  if (const Paper_times* paper = paper_times_of(m.name, m.genus)) print_paper_row(*paper);
}

// ---- One column a size

// p in time ~ faces^p: the slope of the regression line of the logarithms, over what takes 10 ms at least.
double growth_exponent(const std::vector<Measured>& family, const std::string& column)
{
  const double least = 0.01;
  std::vector<std::pair<double, double>> points;
  for (const Measured& m : family)
    if (m.medians.at(column) >= least)
      points.emplace_back(std::log(static_cast<double>(m.faces)), std::log(m.medians.at(column)));
  if (points.size() < 2) return not_given;
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (const auto& [x, y] : points) {
    mean_x += x / static_cast<double>(points.size());
    mean_y += y / static_cast<double>(points.size());
  }
  for (const auto& [x, y] : points) {
    xx += (x - mean_x) * (x - mean_x);
    xy += (x - mean_x) * (y - mean_y);
  }
  return xy / xx;
}

bool is_a_time(const std::string& column) { return std::find(others.begin(), others.end(), column) == others.end(); }

void print_growth(const std::vector<Measured>& family)
{
  std::cout << "\n| " << family.front().name << " to " << family.back().name;
  for (const Measured& m : family) std::cout << " | " << m.faces << " F";
  std::cout << " | growth exponent | share of the last |\n|---";
  for (std::size_t i = 0; i < family.size() + 2; ++i) std::cout << "|---:";
  std::cout << "|\n";
  for (const std::string& column : columns) {
    std::cout << "| " << column;
    for (const Measured& m : family) std::cout << " | " << cell(m.medians.at(column));
    const bool is_step = std::find(steps.begin(), steps.end(), column) != steps.end();
    const std::map<std::string, double>& last = family.back().medians;
    std::cout << " | " << (is_a_time(column) ? cell(growth_exponent(family, column)) : "–") << " | "
              << (is_step ? fixed(100 * last.at(column) / last.at("file to T-mesh"), 1) + " %" : "–") << " |\n";
  }
  std::cout << std::endl;
}

// For gnuplot: a line a size, a column a time.
void write_data(const std::vector<Measured>& family, const std::string& file)
{
  std::ofstream out(file);
  out << "faces";
  for (const std::string& column : columns) out << " \"" << column << '"';
  out << '\n';
  for (const Measured& m : family) {
    out << m.faces;
    for (const std::string& column : columns) out << ' ' << m.medians.at(column);
    out << '\n';
  }
}

// ---- Targets

void add_targets(const Measured& m, const Targets& targets)
{
  const auto value = [&](const std::string& column) { return m.medians.at(column); };
  const std::string at = ", " + m.name + ", " + std::to_string(m.faces) + " triangles";
  if (m.faces > 100000 && m.faces < 125000) targets.add_seconds("file to T-mesh" + at, 15, value("file to T-mesh"));
  if (m.faces > 900000 && m.faces < 1200000) {
    targets.add_seconds("file to T-mesh" + at, 180, value("file to T-mesh"));
    targets.add_number("memory, file to T-mesh" + at, 6, value("peak MiB") / 1024, " GiB");
  }
  if (m.faces > 50000) {
    targets.add_number("forms and periods, steps 2-3 / floor" + at, 1.5, value("steps 2-3 / floor"), "");
    targets.add_number("the same with homology, steps 1-3 / floor" + at, 1.5, value("steps 1-3 / floor"), "");
  }
}

void add_growth_targets(const std::vector<Measured>& family, const Targets& targets)
{
  for (const std::string& column : joined({steps, after_t_mesh}))
    if (const double p = growth_exponent(family, column); !std::isnan(p))
      targets.add_number("growth exponent of " + column, 1.3, p, "");
}

// ---- What is run

std::vector<Subject> samples()
{
  return {torus_of_revolution(100, 50), chain(2, 12), chain(2, 24), chain(2, 48), chain(4, 25),
          {"handle_ring(5, 24)", [] { return Intrinsic_triangulation(handle_ring(5, 24)); }}};
}

// From 6k to 1M triangles.
std::vector<Subject> chains()
{
  std::vector<Subject> result;
  for (int resolution : {6, 11, 22, 43, 76}) result.push_back(chain(4, resolution));
  return result;
}

struct Settings
{
  int         number_of_runs = 3;
  std::size_t number_of_quads = 4000;
  std::string data;
};

void measure_family(const std::vector<Subject>& subjects, const Settings& settings, const Targets& targets)
{
  std::vector<Measured> family;
  for (const Subject& subject : subjects) {
    family.push_back(measured(subject, settings.number_of_runs, settings.number_of_quads));
    add_targets(family.back(), targets);
    std::cerr << subject.name << ": " << cell(family.back().medians.at("file to T-mesh")) << " s" << std::endl;
  }
  print_growth(family);
  add_growth_targets(family, targets);
  if (!settings.data.empty()) write_data(family, settings.data);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Times the pipeline from the file to the T-mesh, in seconds of the processor: medians of several runs."};
  std::vector<std::string> meshes;
  int subdivisions = 0, growth = 0;
  bool scaling = false;
  Settings settings;
  std::string target_file;
  app.add_option("MESH", meshes, "Closed meshes; none: generated surfaces");
  app.add_option("-n,--runs", settings.number_of_runs, "Number of runs, of which the median is printed (3)")
     ->check(CLI::Range(1, 1000));
  app.add_option("--quads", settings.number_of_quads, "Number of quads to ask for, with splines (4000); 0: none");
  app.add_option("--subdivide", subdivisions, "How often each triangle is split into four first (0)")
     ->check(CLI::Range(0, 8));
  app.add_option("--growth", growth, "How often the triangles are split once more, with the growth of the times (0)")
     ->check(CLI::Range(0, 8));
  app.add_flag("--scaling", scaling, "The growth of the times on generated surfaces of 6k to 1M triangles");
  app.add_option("--data", settings.data, "File for the numbers of --scaling or --growth");
  app.add_option("--targets", target_file, "File to which rows of targets and what was reached are added");
  CLI11_PARSE(app, argc, argv);

  std::vector<Subject> subjects;
  for (const std::string& path : meshes) subjects.push_back(from_file(path));
  if (subjects.empty()) subjects = samples();
  if (subdivisions > 0)
    for (Subject& subject : subjects) subject = finer(subject, subdivisions);

  std::vector<std::vector<Subject>> families;
  if (scaling) families.push_back(chains());
  else if (growth > 0)
    for (const Subject& subject : subjects) {
      families.push_back({subject});
      for (int i = 1; i <= growth; ++i) families.back().push_back(finer(subject, i));
    }

  const Targets targets(target_file);
  std::cout << "Factorisation: " << Symmetric_factorization::name() << "; median of " << settings.number_of_runs
            << " runs, in seconds of the processor.\n" << std::endl;
  if (targets.wanted()) std::cout << targets.scale() << '\n' << std::endl;
  bool all_well = true;
  for (const std::vector<Subject>& family : families)
    all_well = in_own_process(family.front().name, [&] { measure_family(family, settings, targets); }) && all_well;
  if (families.empty()) {
    print_header();
    for (const Subject& subject : subjects)
      all_well = in_own_process(subject.name, [&] {
        const Measured m = measured(subject, settings.number_of_runs, settings.number_of_quads);
        print(m);
        add_targets(m, targets);
      }) && all_well;
  }
  return all_well ? EXIT_SUCCESS : EXIT_FAILURE;
}
