// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How much the choice of singularities depends on rounding: every surface is searched several times, each time with the
// vertices moved at random by 1e-13 of the surface's size. Prints a Markdown table: least, median and most.

#include "measure.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/choose_singularities.h>
#include <CGAL/Quartic_differentials/minimize_distortion.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

// One choice, optimised on the surface itself.
struct Choice
{
  double singularities, distortion, area_scale, searching;   // searching: [seconds]
};

// the surface with its vertices moved at random, by at most `part` of its size in every coordinate
Intrinsic_triangulation shaken(const Intrinsic_triangulation& t, double part, std::mt19937& random)
{
  Mesh mesh = t.mesh();
  const double most = part * std::sqrt(t.area());
  std::uniform_real_distribution<double> move(-most, most);
  for (Vertex v : mesh.vertices()) {
    const double x = move(random), y = move(random), z = move(random);
    mesh.point(v) = mesh.point(v) + Vector_3(x, y, z);
  }
  return Intrinsic_triangulation(std::move(mesh));
}

Choice choose(const Intrinsic_triangulation& input, const Quartic_differential_options& options)
{
  Visitor visitor;
  const Riemann_surface s = riemann_surface(input, visitor);
  Chosen_singularities chosen;
  const double searching = cpu_seconds([&] {
    chosen = choose_singularities(s, {}, options.choice, options.legalization, options.distortion, visitor);
  });
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  const Area_distortion distortion(s.delaunay, s.laplacian, vertex_areas(s.delaunay));
  const Optimal_divisor best = minimize_distortion(distortion, map, s.periods, chosen.divisor, options.legalization,
                                                   options.distortion, visitor);
  return {static_cast<double>(chosen.divisor.size()), best.distortion, best.area_scale_after, searching};
}

void print_range(const char* format, const std::vector<Choice>& choices, double Choice::* value)
{
  std::vector<double> x;
  for (const Choice& c : choices) x.push_back(c.*value);
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  for (double y : {*least, median(x), *most}) std::printf(format, y);
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> files;
  int runs = 8;
  CLI::App app{"Measures how much the choice of singularities depends on rounding"};
  app.add_option("meshes", files, "Closed surfaces in space")->required()->check(CLI::ExistingFile);
  app.add_option("-n,--runs", runs, "Choices a surface")->check(CLI::Range(1, 1000))->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  std::printf("| surface | singularities | median | most | E | median | most | area scale | median | most |"
              " search, s | median | most |\n"
              "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const std::string& file : files) {
    std::vector<std::string> notes;
    const Intrinsic_triangulation input = read_surface(file, notes);
    std::mt19937 random(1);
    std::vector<Choice> choices;
    for (int k = 0; k < runs; ++k) choices.push_back(choose(shaken(input, k == 0 ? 0 : 1e-13, random), {}));
    std::printf("| %s |", std::filesystem::path(file).stem().string().c_str());
    print_range(" %g |", choices, &Choice::singularities);
    print_range(" %.4f |", choices, &Choice::distortion);
    print_range(" %.2f |", choices, &Choice::area_scale);
    print_range(" %.2f |", choices, &Choice::searching);
    std::printf("\n");
    std::fflush(stdout);
  }
}
