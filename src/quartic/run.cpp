// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "components.h"
#include "option_checks.h"
#include "page.h"
#include "page_model.h"
#include "progress.h"
#include "report.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_flat_surface.h>
#include <CGAL/Quartic_differentials/IO/write_loops.h>
#include <CGAL/Quartic_differentials/IO/write_multipatch.h>
#include <CGAL/Quartic_differentials/IO/write_pareto.h>
#include <CGAL/Quartic_differentials/IO/write_picture.h>
#include <CGAL/Quartic_differentials/IO/write_quads.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/IO/write_t_spline.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/Timed_step.h>
#include <CGAL/Quartic_differentials/patch_mesh.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/split_obtuse_at_boundary.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using CGAL::Quartic_differentials::internal::write_file;
namespace fs = std::filesystem;

namespace {

struct Run_options
{
  std::string                  mesh, folder, singularities, corners = "auto";
  std::string                  command_line;
  bool                         quiet = false, intrinsic = false, html = true, patches_obj = false;
  bool                         each_component = false;
  Quartic_differential_options pipeline;
  Quad_options                 quads;
  std::vector<std::string>     quad_formats{"obj", "vtu"}, surface_formats{"obj"};
};

const char* const output_files[] = {
  "flat.obj", "flat.mtl", "flat.png", "flat.ply", "flat.vtp", "flat.vtu", "flat.glb", "flat_intrinsic.json",
  "flat_intrinsic.obj", "flat_intrinsic.mtl", "flat_intrinsic.png", "tmesh.json", "tmesh.vtp", "tmesh.obj",
  "singularities.txt", "corners.txt", "pareto.csv", "pareto.svg", "loops.obj",
  "quads.obj", "quads.off", "quads.ply", "quads.vtu", "quads.png", "splines.xml", "splines.json", "splines.vtu",
  "tmesh.tsp", "picture_checkerboard.png", "picture_tmesh.png", "picture_quads.png", "picture_wireframe.png",
  "picture_loops.png",
  "report.json", "report.html", "components.json"};

void remove_results(const fs::path& folder)
{
  std::error_code error;
  for (const std::string name : output_files)
    for (const fs::path& file : {folder / name, folder / (name + ".part")}) fs::remove(file, error);
}

// The folders of components, but not links.
std::vector<fs::path> component_folders(const fs::path& folder)
{
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (is_component_folder(entry.path().filename()) && entry.symlink_status().type() == fs::file_type::directory)
      found.push_back(entry.path());
  return found;
}

// Makes the folder and removes what an earlier run left there, whole or not, so that results of two runs never mix.
void prepare_folder(const fs::path& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) throw Error("the output folder " + folder.string() + " cannot be made");
  remove_results(folder);
  for (const fs::path& component : component_folders(folder)) {
    remove_results(component);
    fs::remove(component, error);   // if nothing else is in it
  }
}

// flat.obj is always there, with its texture, for `quartic verify` and for scripts
void write_flat_surface(const std::string& folder, const Refined_surface& refined,
                        const std::vector<std::string>& formats)
{
  write_flat_obj(folder, "flat", refined.differential);
  for (const std::string& format : std::set<std::string>(formats.begin(), formats.end())) {
    if (format == "obj") continue;
    write_file(folder + "/flat." + format, [&](std::ostream& out) {
      if (format == "ply") write_flat_ply(out, refined, "flat.png");
      if (format == "vtp") write_flat_vtp(out, refined);
      if (format == "vtu") write_flat_vtu(out, refined);
      if (format == "glb") write_flat_glb(out, refined);
    });
  }
}

void write_results(const Run_options& options, const Intrinsic_triangulation& input,
                   const Quartic_differential_result& r)
{
  const std::string& folder = options.folder;
  if (r.choice && !r.choice->pareto.empty()) {
    const Chosen_singularities& c = *r.choice;
    write_file(folder + "/pareto.csv", [&](std::ostream& out) { write_pareto_csv(out, c.pareto); });
    write_file(folder + "/pareto.svg", [&](std::ostream& out) {
      write_pareto_svg(out, c.pareto, static_cast<int>(c.divisor.size()), options.pipeline.choice.distortion);
    });
  }
  if (r.surface && r.surface->loops && input.is_embedded())
    write_file(folder + "/loops.obj", [&](std::ostream& out) { write_loops_obj(out, input, *r.surface->loops); });
  if (!r.singularities.empty() && input.is_embedded())
    write_file(folder + "/singularities.txt", [&](std::ostream& out) { write_singularities(out, r.singularities, input); });
  if (r.metric && input.has_boundary() && input.is_embedded())
    write_file(folder + "/corners.txt", [&](std::ostream& out) { write_corners(out, r.singularities, input); });
  if (r.differential && r.immersion.flipped_triangles == 0) {
    write_file(folder + "/flat_intrinsic.json", [&](std::ostream& out) { write_flat_intrinsic_json(out, *r.differential); });
    if (r.refined && r.refined->flipped_triangles == 0) write_flat_surface(folder, *r.refined, options.surface_formats);
    if (options.intrinsic && input.is_embedded()) write_flat_obj(folder, "flat_intrinsic", *r.differential);
  }
  if (r.t_mesh) {
    write_file(folder + "/tmesh.json", [&](std::ostream& out) {
      write_t_mesh_json(out, *r.t_mesh, r.traced(), r.refined ? "input" : "flat_intrinsic");
    });
    if (input.is_embedded())
      write_file(folder + "/tmesh.vtp", [&](std::ostream& out) { write_t_mesh_vtp(out, *r.t_mesh, r.traced()); });
    if (options.patches_obj && r.refined)
      write_file(folder + "/tmesh.obj", [&](std::ostream& out) { write_t_mesh_obj(out, patch_mesh(*r.t_mesh, *r.refined)); });
  }
}

// whether files were asked for by name that there are not without positions in space
bool needs_positions(const Run_options& options)
{
  const auto is_obj = [](const std::string& format) { return format == "obj"; };
  return options.patches_obj || !std::all_of(options.surface_formats.begin(), options.surface_formats.end(), is_obj);
}

// quads.obj is always there, for `quartic verify` and for scripts
void write_quads(const std::string& folder, const Quads& quads, const Quartic_differential_result& r,
                 const std::vector<std::string>& formats)
{
  std::set<std::string> wanted(formats.begin(), formats.end());
  wanted.insert("obj");
  for (const std::string& format : wanted)
    write_file(folder + "/quads." + format, [&](std::ostream& out) {
      if (format == "obj") write_quads_obj(out, quads.mesh);
      if (format == "off") write_quads_off(out, quads.mesh, *r.t_mesh);
      if (format == "ply") write_quads_ply(out, quads.mesh, *r.t_mesh);
      if (format == "vtu") write_quads_vtu(out, quads.mesh, *r.t_mesh);
    });
  write_file(folder + "/quads.png", [&](std::ostream& out) { write_quads_picture(out, quads.mesh, *r.t_mesh); });
  if (!quads.splines) return;
  write_file(folder + "/splines.xml", [&](std::ostream& out) { write_multipatch_xml(out, *quads.splines); });
  write_file(folder + "/splines.json", [&](std::ostream& out) { write_multipatch_json(out, *quads.splines); });
  write_file(folder + "/splines.vtu", [&](std::ostream& out) { write_multipatch_vtu(out, *quads.splines); });
  write_file(folder + "/tmesh.tsp", [&](std::ostream& out) { write_t_spline(out, *r.t_mesh, r.traced()); });
}

std::ifstream opened(const std::string& path, const std::string& what)
{
  std::error_code error;
  std::ifstream in;
  if (fs::is_regular_file(path, error) || fs::is_fifo(path, error)) in.open(path);   // not a folder, nor /dev/zero
  if (!in.is_open()) throw Infeasible_divisor_error("the file of " + what + " " + path + " cannot be read");
  return in;
}

std::optional<Divisor> singularities_of(const Run_options& options, const Intrinsic_triangulation& input)
{
  if (options.singularities.empty()) return std::nullopt;
  std::ifstream in = opened(options.singularities, "singularities");
  return read_singularities(in, input);
}

// none: they are found
std::optional<Divisor> corners_of(const Run_options& options, const Intrinsic_triangulation& input)
{
  if (options.corners == "auto") return std::nullopt;
  if (options.corners == "none") return Divisor();
  std::ifstream in = opened(options.corners, "corners");
  return read_corners(in, input);
}

// \param read takes the notes of what was done to the surface
void run(const Run_options& options, const std::function<Intrinsic_triangulation(std::vector<std::string>&)>& read)
{
  Progress progress(options.quiet);
  Run_facts facts;
  facts.command = options.command_line;
  facts.mesh = options.mesh;
  facts.folder = options.folder;
  internal::Timing_visitor timed(progress, facts.timings);

  Intrinsic_triangulation input;
  std::optional<Divisor> singularities;
  Quartic_differential_options pipeline = options.pipeline;
  {
    const internal::Timed_step step(timed, "read");
    input = read(facts.notes);
    if (input.has_boundary())
      if (const std::size_t added = split_obtuse_at_boundary(input); added > 0)
        facts.notes.push_back(std::to_string(added) + " vertices were added on the boundary, opposite obtuse angles");
    singularities = singularities_of(options, input);
    pipeline.corners = corners_of(options, input);
  }
  facts.input = &input;
  if (options.pipeline.quads && !input.is_embedded())
    throw Unusable_surface_error("quads need positions in space, but the surface is known by its edge lengths alone");
  if (needs_positions(options) && !input.is_embedded())
    throw Unusable_surface_error("--surface-format and --tmesh-obj write positions in space, but the surface is known by "
                                 "its edge lengths alone");
  prepare_folder(options.folder);

  Quartic_differential_result result;
  std::exception_ptr failure;
  try {
    quartic_differential(input, singularities, pipeline, progress, result);
  } catch (const Numerical_error& e) {   // what was computed is still written
    facts.failure = e.what();
    failure = std::current_exception();
  } catch (const Infeasible_divisor_error& e) {
    facts.failure = e.what();
    failure = std::current_exception();
  }
  Json model;
  {
    const internal::Timed_step step(timed, "write");
    write_results(options, input, result);
    if (result.quads) write_quads(options.folder, *result.quads, result, options.quad_formats);
    if (options.html) model = page_model(input, result);
  }
  const Json report = run_report(facts, result);   // knows all times but those of the two files that hold it
  write_file(options.folder + "/report.json", [&](std::ostream& out) { out << report.dump(1) << '\n'; });
  if (options.html)
    write_file(options.folder + "/report.html", [&](std::ostream& out) { write_page(out, facts, model, report); });
  if (!options.quiet) {
    print_summary(std::cout, report);
    std::cout << "  results           " << options.folder << (failure ? " (as far as the run came)\n" : "\n");
  }
  if (failure) std::rethrow_exception(failure);
}

void run(const Run_options& options)
{
  if (!options.each_component) {
    run(options, [&](std::vector<std::string>& notes) { return read_surface(options.mesh, notes); });
    return;
  }
  if (options.corners != "auto" && options.corners != "none")
    throw CLI::ExcludesError("--components each", "--corners FILE, which has the corners of one surface");
  std::vector<Surface_component> components = read_surface_components(options.mesh);
  prepare_folder(options.folder);
  run_components(options.mesh, std::move(components), options.folder, options.quiet,
                 [&](Surface_component& component, const std::string& folder) {
    Run_options alone = options;
    alone.folder = folder;
    run(alone, [&](std::vector<std::string>& notes) {
      notes = component.notes;
      return std::move(*component.surface);
    });
  });
}

} // namespace

void add_run(CLI::App& app, const std::string& command_line)
{
  auto options = std::make_shared<Run_options>();
  options->command_line = command_line;
  CLI::App* command = app.add_subcommand("run", "Compute singularities, flat metric, quartic differential and T-mesh of a mesh");
  command->add_option("MESH", options->mesh, "Triangle or polygon mesh (.off, .obj, .ply, .stl, .vtp), or a surface of "
                                             "glued triangles (.json)")->required()->check(some_name());
  command->add_option("-o,--output", options->folder, "Folder for the results; made if it is not there")
         ->required()->check(some_name());
  CLI::Option* singularities = command->add_option("--singularities", options->singularities,
                      "File with the singularities to start from, lines 'x y z order [pinned]' (order = valence - 4)")
         ->check(some_name());
  const std::map<std::string, bool> components{{"one", false}, {"each", true}};
  command->add_option("--components", options->each_component,
                      "What is done with a mesh of several components: it is refused unless there is 'one', or 'each' "
                      "is run by itself into the folders component_0, component_1, ..., the largest first")
         ->transform(CLI::CheckedTransformer(components, CLI::ignore_case).description(""))
         ->type_name("one|each")->default_str("one")->excludes(singularities);
  command->add_option("--corners", options->corners,
                      "Corners of the boundary: 'auto' finds them where it turns, 'none' makes none, or a file with lines "
                      "'x y z m [pinned]', m the number of quads there; the singularities are then chosen to go with them")
         ->type_name("auto|none|FILE")->check(some_name())->capture_default_str();
  Singularity_choice_options& choice = options->pipeline.choice;
  command->add_option("--distortion", choice.distortion,
                      "Choose as few singularities as this area distortion allows: the mean square of the log of the "
                      "scale of lengths")
         ->check(positive_number())->capture_default_str();
  command->add_option("--count", choice.count,
                      "Choose this number of singularities; the next number of the right parity is taken")
         ->check(CLI::PositiveNumber);
  const std::map<std::string, Singularity_start> starts{
    {"auto", Singularity_start::automatic}, {"curvature", Singularity_start::curvature},
    {"field", Singularity_start::field}, {"pairs", Singularity_start::pairs}};
  command->add_option("--start", choice.start,
                      "Start the choice from extrema of the 'curvature', from the smoothest direction 'field', from the "
                      "least number by adding 'pairs', or the better of the last two")
         ->transform(CLI::CheckedTransformer(starts, CLI::ignore_case).description(""))
         ->type_name("auto|curvature|field|pairs")->default_str("auto");
  command->add_option("--least-order", choice.least_order,
                      "Poles that meet are merged down to this order when singularities are chosen")
         ->check(CLI::Range(-3, -1))->capture_default_str();
  command->add_option("--most-order", choice.most_order,
                      "Zeros that meet are merged up to this order when singularities are chosen")
         ->check(CLI::Range(1, 20))->capture_default_str();
  command->add_option("--min-distance", options->pipeline.distortion.guard_distance,
                      "Singularities nearer than this times the square root of the area repel each other")
         ->check(number_between(0.01, 0.2))->capture_default_str();
  command->add_option("--seed", choice.seed, "Seed of the direction field's eigenvector")->capture_default_str();
  command->add_flag_function("--optimize,!--no-optimize", [options](std::int64_t n) {
    options->pipeline.optimize = n > 0 ? Optimize::always : Optimize::never;
  }, "Move the singularities to where areas are distorted least; the default for chosen ones, not for a "
                            "file's; --no-optimize takes extrema of the curvature, as the paper does");
  command->add_flag("--pareto", choice.pareto,
                    "Also write pareto.csv and pareto.svg: the least distortion found for every number of singularities");
  command->add_flag("--repair-degree", options->pipeline.repair_degree,
                    "Add simple singularities at curvature extrema until the orders of the file add up to 8g-8");
  const std::map<std::string, Lattice_norm> norms{
    {"movement", Lattice_norm::movement}, {"paper", Lattice_norm::paper}, {"invariant", Lattice_norm::invariant}};
  command->add_option("--norm", options->pipeline.legalization.norm,
                      "Norm of the integer program: 'movement' moves the singularities least, 'paper' is Euclidean in "
                      "the periods, 'invariant' is the Jacobian's own, whatever the homology basis")
         ->transform(CLI::CheckedTransformer(norms, CLI::ignore_case).description(""))
         ->type_name("movement|paper|invariant")->default_str("movement");
  const std::map<std::string, Abel_jacobi_route> routes{{"curvature", Abel_jacobi_route::curvature},
                                                        {"zeros", Abel_jacobi_route::zeros}};
  command->add_option("--abel-jacobi", options->pipeline.route,
                      "Compute the Abel-Jacobi map from the 'curvature', consistent with the mesh, or as the paper does "
                      "from the 'zeros' of a holomorphic 1-form")
         ->transform(CLI::CheckedTransformer(routes, CLI::ignore_case).description(""))
         ->type_name("curvature|zeros")->default_str("curvature");
  command->add_option("--precision", options->pipeline.precision,
                      "Compute the flat metric, its holonomy and its layout with this number of binary digits; without it "
                      "doubles are used, and 128 digits where those are not enough")
         ->check(CLI::Range(64, 1024))->type_name("BITS");
  command->add_option("--surface-format", options->surface_formats,
                      "Formats of the surface with its flat coordinates beside flat.obj: names separated by commas, or "
                      "one an option; glb is glTF with the checkerboard in it, for viewers")
         ->check(CLI::IsMember({"obj", "ply", "vtp", "vtu", "glb"}).description(""))->delimiter(',')
         ->allow_extra_args(false)->type_name("obj|ply|vtp|vtu|glb")->capture_default_str();
  CLI::Option* number = command->add_option("--quads", options->quads.quantization.number_of_quads,
                                            "Also make a quad mesh, quads.obj, of about this number of quads")
                               ->check(CLI::Range(1, 10000000))->type_name("N");
  command->add_option("--edge-length", options->quads.quantization.edge_length,
                      "Also make a quad mesh with sides of about this length")
         ->check(positive_number())->type_name("H")->excludes(number);
  command->add_option("--quad-format", options->quad_formats,
                      "Formats of the quad mesh beside quads.obj: names separated by commas, or one an option")
         ->check(CLI::IsMember({"obj", "off", "ply", "vtu"}).description(""))->delimiter(',')->allow_extra_args(false)
         ->type_name("obj|off|ply|vtu")->capture_default_str();
  command->add_flag("!--no-smoothing", options->quads.smooth,
                    "Leave the vertices of the quad mesh where the exact map takes them, on even divisions of the T-mesh");
  CLI::Option* splines = command->add_flag("--splines", options->quads.splines,
    "Also fit bicubic splines to the surface: the quads come in square blocks, patches that meet side to side, and every "
    "quad is a knot span; splines.xml (G+Smo), .json and .vtu, and the T-mesh with knot intervals, tmesh.tsp");
  command->add_option("--patches", options->quads.quantization.number_of_blocks,
                      "About this number of patches; without it, 3 for every rectangle of the T-mesh")
         ->check(CLI::Range(1, 1000000))->type_name("P")->needs(splines);
  command->add_flag_callback("--no-loops", [options] { options->pipeline.homology = Homology_choice::any; },
                             "Take any canonical homology basis, not one of short handle and tunnel loops");
  command->add_flag("--intrinsic", options->intrinsic,
                    "Also write flat_intrinsic.obj: the flat triangulation, drawn straight between its vertices");
  command->add_flag("--tmesh-obj", options->patches_obj,
                    "Also write tmesh.obj: the surface cut along the T-mesh, a group for every rectangle, with texture "
                    "coordinates in it");
  command->add_flag("!--no-html", options->html, "Do not write report.html, the page that shows the results");
  command->add_flag("-q,--quiet", options->quiet, "Print nothing but errors");
  command->callback([options, command] {
    options->pipeline.add_to_given = command->count("--distortion") + command->count("--count") > 0;
    const std::size_t asked_for = command->count("--quads") + command->count("--edge-length")
                                  + command->count("--splines");
    if (command->count("--quad-format") > 0 && asked_for == 0)
      throw CLI::RequiresError("--quad-format", "--quads, --edge-length or --splines");
    if (asked_for > 0) options->pipeline.quads = options->quads;
    run(*options);
  });
}
