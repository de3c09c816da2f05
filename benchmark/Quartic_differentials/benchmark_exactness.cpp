// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What exactness costs: the exact decisions of a run, and Newton's method for an exact holonomy, as shares of the time
// from the file to the T-mesh. Prints a Markdown table a surface.

#include "measure.h"
#include "subject.h"

#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/handle_tunnel_basis.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

/// What the Delaunay predicate is asked in a run: how often, and a sample of the questions.
struct Predicate_calls
{
  using Arguments = std::array<double, 5>;   // e, a, b, c, d
  static constexpr std::size_t every = 61;   // one question in so many is kept

  std::size_t            number = 0;
  std::vector<Arguments> sample;
} calls;

// What the predicate would be without certainty: the same polynomial in doubles.
bool rounded_not_delaunay(double e, double a, double b, double c, double d)
{
  return (a * a + b * b - e * e) * (c * d) + (c * c + d * d - e * e) * (a * b) < 0;
}

} // namespace

// The linker sends the library's calls of certified_not_delaunay() here (--wrap), and ours of "real" to it.
extern "C" {
bool __real__ZN4CGAL21Quartic_differentials22certified_not_delaunayEddddd(double, double, double, double, double);
bool __wrap__ZN4CGAL21Quartic_differentials22certified_not_delaunayEddddd(double e, double a, double b, double c,
                                                                           double d)
{
  if (calls.number++ % Predicate_calls::every == 0) calls.sample.push_back({e, a, b, c, d});
  return __real__ZN4CGAL21Quartic_differentials22certified_not_delaunayEddddd(e, a, b, c, d);
}
}

namespace {

struct Answers
{
  double      seconds;
  std::size_t not_delaunay;
};

// The sampled questions once more, with the time scaled up to all of them.
template <class Predicate>
Answers answers(const Predicate_calls& c, Predicate predicate)
{
  Answers result{0, 0};
  const double sampled = cpu_seconds([&] {
    for (const auto& [e, a, b, c, d] : c.sample) result.not_delaunay += predicate(e, a, b, c, d);
  });
  result.seconds = sampled * static_cast<double>(c.number) / static_cast<double>(c.sample.size());
  return result;
}

struct Step_clock : Visitor
{
  double begin = 0, holonomy = 0, t_mesh = 0;
  void step_begins(const std::string&) override { begin = cpu_clock(); }
  void step_ends(const std::string& name, double) override
  {
    if (name == "holonomy") holonomy = cpu_clock() - begin;
    if (name == "t_mesh") t_mesh = cpu_clock() - begin;
  }
};

void print_row(const std::string& what, double time, double whole)
{
  std::cout << "| " << what << " | " << cell(time) << " | " << fixed(100 * time / whole, 2) << " % |\n";
}

// From the layout in floating point numbers to exact seams, with every orientation and transition checked.
double snapping_seconds(const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  const Refined_cone_metric& m = *r.refined_metric;
  const Cone_metric& cones = r.metric->metric;
  const internal::Cut_disk disk = internal::cut_at_cones(m.triangulation, m.lengths, cones.cones);
  internal::Layout layout = internal::layout(m.triangulation, m.lengths, m.lengths, disk);
  return cpu_seconds([&] {
    Immersion_report report;
    internal::immersion_of_layout(m.triangulation, m.lengths, disk, std::move(layout), cones.cones, cones.order,
                                  input.area(), {}, report);
  });
}

void measure(const Subject& subject)
{
  Intrinsic_triangulation input;
  Quartic_differential_result r;
  Step_clock clock;
  calls = {};
  const double whole = cpu_seconds([&] {
    input = subject.load();
    quartic_differential(input, std::nullopt, {}, clock, r);
  });
  const Predicate_calls made = std::move(calls);
  const Answers certain = answers(made, __real__ZN4CGAL21Quartic_differentials22certified_not_delaunayEddddd);
  const Answers rounded = answers(made, rounded_not_delaunay);

  std::cout << "\n| " << subject.name << ", " << input.number_of_faces() << " triangles | CPU s | share |\n"
               "|---|---:|---:|\n";
  print_row("Delaunay predicates, " + std::to_string(made.number) + " calls", certain.seconds, whole);
  print_row("beyond the same in doubles, which would flag " + std::to_string(rounded.not_delaunay) + " of "
            + std::to_string(made.sample.size()) + " edges instead of " + std::to_string(certain.not_delaunay),
            certain.seconds - rounded.seconds, whole);
  if (input.is_embedded() && input.genus() > 0) {
    const Homology_basis basis = homology_basis(input);
    print_row("handles and tunnels: linking numbers, self-intersections",
              cpu_seconds([&] { handle_tunnel_basis(input, basis); }), whole);
  }
  print_row("exact holonomy: Newton's method on the cones' positions", clock.holonomy, whole);
  print_row("layout to grid: exact seams, all orientations checked", snapping_seconds(input, r), whole);
  print_row("refined surface: all orientations, seams and cones checked",
            cpu_seconds([&] { if (!defect(r.traced()).empty()) throw Error("the differential is not valid"); }), whole);
  print_row("T-mesh in integers", clock.t_mesh, whole);
  print_row("file to T-mesh", whole, whole);
  std::cout << std::flush;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"What exactness costs, as shares of the time from the file to the T-mesh."};
  std::vector<std::string> meshes;
  app.add_option("MESH", meshes, "Closed meshes; none: generated surfaces");
  CLI11_PARSE(app, argc, argv);

  std::vector<Subject> subjects;
  for (const std::string& path : meshes) subjects.push_back(from_file(path));
  if (subjects.empty()) subjects = {torus_of_revolution(400, 100), chain(4, 25)};
  bool all_well = true;
  for (const Subject& subject : subjects)
    all_well = in_own_process(subject.name, [&] { measure(subject); }) && all_well;
  return all_well ? EXIT_SUCCESS : EXIT_FAILURE;
}
