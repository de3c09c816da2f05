// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "progress.h"
#include "report.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/Timed_step.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

using namespace CGAL::Quartic_differentials;
using CGAL::Quartic_differentials::internal::write_file;
namespace fs = std::filesystem;

namespace {

struct Run_options
{
  std::string                  mesh, folder, singularities;
  bool                         quiet = false;
  Quartic_differential_options pipeline;
};

const char* const output_files[] = {"flat_intrinsic.json", "flat_intrinsic.obj", "flat_intrinsic.mtl",
                                    "flat_intrinsic.png", "tmesh.json", "tmesh.vtp", "singularities.txt", "report.json"};

// Makes the folder and removes what an earlier run left there, so that results of two runs never mix.
void prepare_folder(const fs::path& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) throw Error("the output folder " + folder.string() + " cannot be made");
  for (const char* name : output_files) fs::remove(folder / name, error);
}

void write_results(const std::string& folder, const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  if (!r.singularities.empty() && input.is_embedded())
    write_file(folder + "/singularities.txt", [&](std::ostream& out) { write_singularities(out, r.singularities, input); });
  if (r.differential && r.immersion.flipped_triangles == 0) {
    write_file(folder + "/flat_intrinsic.json", [&](std::ostream& out) { write_flat_intrinsic_json(out, *r.differential); });
    if (input.is_embedded()) write_flat_intrinsic_obj(folder, *r.differential);
  }
  if (r.t_mesh) {
    write_file(folder + "/tmesh.json", [&](std::ostream& out) { write_t_mesh_json(out, *r.t_mesh, *r.differential); });
    if (input.is_embedded())
      write_file(folder + "/tmesh.vtp", [&](std::ostream& out) { write_t_mesh_vtp(out, *r.t_mesh, *r.differential); });
  }
}

std::optional<Divisor> divisor_from_file(const std::string& path, const Intrinsic_triangulation& input)
{
  if (path.empty()) return std::nullopt;
  std::ifstream in(path);
  if (!in) throw Infeasible_divisor_error("the file of singularities " + path + " cannot be read");
  return read_singularities(in, input);
}

void run(const Run_options& options)
{
  Progress progress(options.quiet);
  Run_facts facts;
  facts.mesh = options.mesh;
  internal::Timing_visitor timed(progress, facts.timings);

  Intrinsic_triangulation input;
  std::optional<Divisor> singularities;
  {
    const internal::Timed_step step(timed, "read");
    input = read_surface(options.mesh, facts.notes);
    singularities = divisor_from_file(options.singularities, input);
  }
  facts.input = &input;
  prepare_folder(options.folder);

  Quartic_differential_result result;
  std::exception_ptr failure;
  try {
    quartic_differential(input, singularities, options.pipeline, progress, result);
  } catch (const Numerical_error& e) {   // what was computed is still written
    facts.failure = e.what();
    failure = std::current_exception();
  } catch (const Infeasible_divisor_error& e) {
    facts.failure = e.what();
    failure = std::current_exception();
  }
  {
    const internal::Timed_step step(timed, "write");
    write_results(options.folder, input, result);
  }
  const Json report = run_report(facts, result);
  write_file(options.folder + "/report.json", [&](std::ostream& out) { out << report.dump(1) << '\n'; });
  if (!options.quiet) {
    print_summary(std::cout, report);
    std::cout << "  results           " << options.folder << (failure ? " (as far as the run came)\n" : "\n");
  }
  if (failure) std::rethrow_exception(failure);
}

} // namespace

void add_run(CLI::App& app)
{
  auto options = std::make_shared<Run_options>();
  CLI::App* command = app.add_subcommand("run", "Compute singularities, flat metric, quartic differential and T-mesh of a mesh");
  command->add_option("MESH", options->mesh, "Closed triangle or polygon mesh (.off, .obj, .ply, .stl), or a surface of "
                                             "glued triangles (.json)")->required();
  command->add_option("-o,--output", options->folder, "Folder for the results; made if it is not there")->required();
  command->add_option("--singularities", options->singularities,
                      "File with the singularities to start from, lines 'x y z order [pinned]' (order = valence - 4)");
  command->add_option("--count", options->pipeline.count,
                      "Number of singularities when no file is given; the next number of the right parity is taken")
         ->check(CLI::NonNegativeNumber);
  command->add_flag("--repair-degree", options->pipeline.repair_degree,
                    "Add simple singularities at curvature extrema until the orders of the file add up to 8g-8");
  const std::map<std::string, Lattice_norm> norms{{"movement", Lattice_norm::movement}, {"paper", Lattice_norm::paper}};
  command->add_option("--norm", options->pipeline.legalization.norm,
                      "Norm of the integer program: 'movement' moves the singularities least, 'paper' is Euclidean")
         ->transform(CLI::CheckedTransformer(norms, CLI::ignore_case).description(""))
         ->type_name("movement|paper")->default_str("movement");
  const std::map<std::string, Abel_jacobi_route> routes{{"curvature", Abel_jacobi_route::curvature},
                                                        {"zeros", Abel_jacobi_route::zeros}};
  command->add_option("--abel-jacobi", options->pipeline.route,
                      "Compute the Abel-Jacobi map from the 'curvature', consistent with the mesh, or as the paper does "
                      "from the 'zeros' of a holomorphic 1-form")
         ->transform(CLI::CheckedTransformer(routes, CLI::ignore_case).description(""))
         ->type_name("curvature|zeros")->default_str("curvature");
  command->add_flag("-q,--quiet", options->quiet, "Print nothing but errors");
  command->callback([options] { run(*options); });
}
