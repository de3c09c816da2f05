// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "progress.h"
#include "report.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <CLI/CLI.hpp>

#include <complex>
#include <iostream>
#include <memory>

using namespace CGAL::Quartic_differentials;

namespace {

struct Info_options
{
  std::string mesh;
  bool        json = false, quiet = false;
};

void print_period_matrix(std::ostream& out, const Period_matrix& periods)
{
  out << "  period matrix     discretisation indicator " << periods.star_defect << '\n';
  for (Eigen::Index i = 0; i < periods.pi.rows(); ++i) {
    out << "    ";
    for (Eigen::Index j = 0; j < periods.pi.cols(); ++j) {
      const std::complex<double> z = periods.pi(i, j);
      out << "  " << z.real() << (z.imag() < 0 ? " - " : " + ") << std::abs(z.imag()) << "i";
    }
    out << '\n';
  }
}

void info(const Info_options& options)
{
  Progress progress(options.quiet);
  Run_facts facts;
  facts.mesh = options.mesh;
  const Intrinsic_triangulation input = read_surface(options.mesh, facts.notes);
  facts.input = &input;
  const Riemann_surface surface = riemann_surface(input, progress);
  if (options.json) {
    std::cout << surface_report(facts, &surface).dump(1) << '\n';
    return;
  }
  std::cout << "  surface           closed, genus " << input.genus() << ", " << input.number_of_vertices() << " vertices, "
            << input.number_of_edges() << " edges, " << input.number_of_faces() << " faces, area " << input.area() << '\n';
  for (const std::string& note : facts.notes) std::cout << "  note              " << note << '\n';
  std::cout << "  singularities     orders must add up to 8g-8 = " << 8 * input.genus() - 8 << '\n';
  if (input.genus() > 0) print_period_matrix(std::cout, surface.periods);
}

} // namespace

void add_info(CLI::App& app)
{
  auto options = std::make_shared<Info_options>();
  CLI::App* command = app.add_subcommand("info", "Tell the genus and the period matrix of a mesh");
  command->add_option("MESH", options->mesh, "Closed mesh (.off, .obj, .ply, .stl, .json)")->required();
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->add_flag("-q,--quiet", options->quiet, "Print no progress");
  command->callback([options] { info(*options); });
}
