// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "progress.h"
#include "report.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/internal/counted.h>
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
  bool        json = false, quiet = false, loops = true;
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

void print_loops(std::ostream& out, const Handle_tunnel_loops& loops)
{
  const int n = static_cast<int>(loops.loops.size());
  out << "  loops             ";
  if (loops.classes.certified) out << "a_i are tunnels, b_i are handles, proved by linking numbers\n";
  else if (loops.classes.found) out << "a_i seem tunnels, b_i handles, but " << loops.classes.reason << '\n';
  else out << "handles and tunnels are not told apart: " << loops.classes.reason << '\n';
  for (int k = 0; k < n; ++k)
    out << "    " << loop_name(k, n / 2) << "  length " << loops.loops[k].length << ", " << loops.loops[k].walk.size()
        << " edges" << (loops.loops[k].simple ? "" : ", not simple") << '\n';
}

void info(const Info_options& options)
{
  Progress progress(options.quiet);
  Run_facts facts;
  facts.mesh = options.mesh;
  const Intrinsic_triangulation input = read_surface(options.mesh, facts.notes);
  facts.input = &input;
  const Riemann_surface surface = riemann_surface(input, progress, options.loops ? Homology_choice::handle_tunnel
                                                                                : Homology_choice::any);
  if (options.json) {
    std::cout << surface_report(facts, &surface).dump(1) << '\n';
    return;
  }
  const int curves = input.number_of_boundary_curves();
  std::cout << "  surface           " << (curves == 0 ? "closed" : internal::counted(curves, "boundary curve")) << ", genus "
            << input.genus() << ", " << input.number_of_vertices() << " vertices, " << input.number_of_edges() << " edges, "
            << input.number_of_faces() << " faces, area " << input.area() << '\n';
  for (const std::string& note : facts.notes) std::cout << "  note              " << note << '\n';
  std::cout << "  singularities     orders"
            << (curves == 0 ? " must add up to 8g-8" : ", and numbers of quads at corners less 2, must add up to 8g-8+4b")
            << " = " << required_degree(input) << '\n';
  if (surface.loops) print_loops(std::cout, *surface.loops);
  if (input.genus() > 0 && curves == 0) print_period_matrix(std::cout, surface.periods);
}

} // namespace

void add_info(CLI::App& app)
{
  auto options = std::make_shared<Info_options>();
  CLI::App* command = app.add_subcommand("info", "Tell the genus of a mesh and, if it is closed, the loops of "
                                                 "handles and tunnels and the period matrix");
  command->add_option("MESH", options->mesh, "Mesh (.off, .obj, .ply, .stl, .vtp, .json)")->required();
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->add_flag("!--no-loops", options->loops, "Take any canonical homology basis, not one of short loops");
  command->add_flag("-q,--quiet", options->quiet, "Print no progress");
  command->callback([options] { info(*options); });
}
