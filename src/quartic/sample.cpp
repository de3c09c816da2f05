// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "option_checks.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/IO/surface_json.h>
#include <CGAL/Quartic_differentials/branched_cover.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/counted.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>
#include <CGAL/Quartic_differentials/sample_boundaries.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>
#include <CGAL/Quartic_differentials/spoiled_surfaces.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

struct Sample_options
{
  std::string kind, mesh, file, branch_points, shape = "round";
  int         genus = 2, resolution = 0, subdivisions = -1;   // out of range: the default of the kind
  double      R = 2, r = 1;
  int         holes = 0, disks = 0;
  double      radius = 0.1;
  std::vector<double> plane;
  double      stretch = 1, noise = 0, slivers = 0, obtuse = 0;
  int         hub = 0;
  unsigned    seed = 1;
};

void say(const Sample_options& options, const Intrinsic_triangulation& t)
{
  std::cout << options.file << ": genus " << t.genus() << ", ";
  if (const int b = t.number_of_boundary_curves(); b > 0)
    std::cout << internal::counted(b, "boundary curve") << ", ";
  std::cout << t.number_of_vertices() << " vertices, "
            << t.number_of_faces() << " faces\n";
}

// Surfaces that are known by their edge lengths alone
const std::set<std::string> glued_kinds = {"hyperelliptic", "polygon", "l", "cover"};

double coordinate(const std::string& text)
{
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(x)) throw Error("--branch: \"" + text + "\" is not a number");
  return x;
}

// "x,y;x,y;..." with x alone for a real point, and inf
std::vector<std::complex<double>> parsed_branch_points(const std::string& text)
{
  std::vector<std::complex<double>> points;
  std::istringstream list(text);
  for (std::string point; std::getline(list, point, ';'); ) {
    const std::size_t comma = point.find(',');
    if (point == "inf") points.push_back(std::numeric_limits<double>::infinity());
    else if (comma == std::string::npos) points.push_back(coordinate(point));
    else points.emplace_back(coordinate(point.substr(0, comma)), coordinate(point.substr(comma + 1)));
  }
  return points;
}

Glued_triangles glued(const Sample_options& options)
{
  const auto subdivisions = [&](int otherwise) { return options.subdivisions < 0 ? otherwise : options.subdivisions; };
  if (options.kind == "polygon") return regular_polygon(options.genus, subdivisions(4));
  if (options.kind == "l") return l_of_three_squares(subdivisions(4));
  if (options.kind == "cover") return branched_cover(parsed_branch_points(options.branch_points), subdivisions(2));
  return hyperelliptic(options.genus, subdivisions(3));
}

void write_glued(const Sample_options& options)
{
  const Glued_triangles surface = glued(options);
  internal::write_file(options.file, [&](std::ostream& out) { write_surface_json(out, surface); });
  say(options, Intrinsic_triangulation(surface));
}

int resolution_of_plate(const Sample_options& options)
{ return options.resolution > 0 ? options.resolution : options.shape == "round" ? 20 : 8; }

// about the number of triangles before they are split, measured where it is not known; more than there are for `cover`
double number_of_triangles(const Sample_options& options)
{
  const double g = options.genus, n = options.resolution > 0 ? options.resolution : options.kind == "torus" ? 60 : 8;
  if (options.kind == "torus") return 2 * n * n * options.r / options.R;
  if (options.kind == "chain") return 45 * (g + 1) * n * n;
  if (options.kind == "ring") return (45 * (g + 1) + 2 * g * g) * n * n;
  if (options.kind == "plate") return (options.shape == "round" ? 6 : 13.5) * std::pow(resolution_of_plate(options), 2);
  return 8 * (g + 1) + 20;
}

// \param triangles before they are split
void check_size(const Sample_options& options, double triangles)
{
  const double most = 2e7, n = std::ldexp(triangles, 2 * std::max(options.subdivisions, 0));
  if (n > most)
    throw Error("the surface would have about " + internal::scientific(n) + " triangles, more than "
                + internal::scientific(most) + ": ask for a lower genus, resolution or number of subdivisions");
}

Mesh cut(const Sample_options& options)
{
  std::vector<std::string> notes;
  const Intrinsic_triangulation input = read_surface(options.mesh, notes);
  if (!input.is_embedded())
    throw Unusable_surface_error(options.mesh + " is known by its edge lengths alone, it cannot be cut");
  check_size(options, static_cast<double>(input.number_of_faces()));
  Mesh mesh = input.mesh();
  const std::vector<double>& normal = options.plane;
  if (!normal.empty()) mesh = part_in_front(mesh, Vector_3(normal[0], normal[1], normal[2]));
  return options.disks > 0 ? with_disks_cut_out(mesh, options.disks, options.radius, options.seed) : mesh;
}

Mesh embedded(const Sample_options& options)
{
  const auto resolution = [&](int otherwise) { return options.resolution > 0 ? options.resolution : otherwise; };
  if (options.kind == "sphere") return bumpy_sphere(options.subdivisions < 0 ? 4 : options.subdivisions);
  Mesh mesh;
  if (options.kind == "torus") {
    const int n = resolution(60), m = static_cast<int>(std::lround(n * options.r / options.R));
    mesh = torus(options.R, options.r, n, std::max(m, 3));
  } else if (options.kind == "plate") {
    const int n = resolution_of_plate(options);
    if (options.shape == "round") mesh = plate(options.holes, n);
    else mesh = plate(options.shape == "L" ? Plate_shape::l : Plate_shape::rectangle, options.holes, n);
  } else if (options.kind == "cut") {
    mesh = cut(options);
  } else {
    mesh = options.kind == "chain" ? handle_chain(options.genus, resolution(8)) : handle_ring(options.genus, resolution(8));
  }
  for (int i = 0; i < options.subdivisions; ++i) mesh = subdivided(mesh);
  return mesh;
}

// The surface with whatever is asked for to make it bad.
Mesh spoiled(Mesh mesh, const Sample_options& options)
{
  if (options.noise > 0) mesh = noisy(std::move(mesh), options.noise, options.seed);
  if (options.hub > 0) mesh = with_hub(mesh, options.hub);
  if (options.slivers > 0) mesh = with_slivers(std::move(mesh), options.slivers, options.seed);
  if (options.obtuse > 0) mesh = with_obtuse_boundary(std::move(mesh), options.obtuse, options.seed);
  return options.stretch == 1 ? mesh : stretched(std::move(mesh), options.stretch);
}

void write_embedded(const Sample_options& options)
{
  Mesh mesh = spoiled(embedded(options), options);
  const bool is_delicate = options.slivers > 0 || options.obtuse > 0 || options.kind == "cut";
  const int digits = is_delicate ? 17 : 12;   // thin triangles need them all
  const std::filesystem::path file = options.file, part = file.stem().string() + ".part" + file.extension().string();
  internal::make_file(file.string(), (file.parent_path() / part).string(), [&](const std::string& name) {
    if (!CGAL::IO::write_polygon_mesh(name, mesh, CGAL::parameters::stream_precision(digits).verbose(false)))
      throw Error(options.file + " cannot be written: its name should end in .off, .obj, .ply or .stl, in a folder that exists");
  });
  say(options, Intrinsic_triangulation(std::move(mesh)));
}

void check_usage(const Sample_options& options)
{
  const bool json = std::filesystem::path(options.file).extension() == ".json";
  if (glued_kinds.count(options.kind)) {
    if (options.genus < 1) throw Error("this surface has at least genus 1");
    if (!json) throw Error("this surface is known by its edge lengths only: name a .json file");
    if (options.kind == "cover" && options.branch_points.empty()) throw Error("a cover needs --branch");
    if (options.kind == "cover" && options.subdivisions > 6) throw Error("a cover can be refined up to -s 6");
  } else if (json) {
    throw Error("surfaces in space are written as .off, .obj, .ply or .stl");
  }
  if (options.kind == "torus" && !(options.r < options.R)) throw Error("a torus needs -r smaller than -R");
  if ((options.kind == "cut") == options.mesh.empty())
    throw Error("cut, and only cut, needs a MESH: quartic sample cut MESH ...");
  if (options.kind == "cut" && options.disks == 0 && options.plane.empty()) throw Error("cut needs --disks or --plane");
  if (options.kind == "plate" && options.shape == "round" && resolution_of_plate(options) < 12)
    throw Error("a round plate needs -n 12 or more");
}

void sample(const Sample_options& options)
{
  check_usage(options);
  if (options.kind != "cut") check_size(options, number_of_triangles(options));
  if (glued_kinds.count(options.kind)) write_glued(options);
  else write_embedded(options);
}

} // namespace

void add_sample(CLI::App& app)
{
  auto options = std::make_shared<Sample_options>();
  CLI::App* command = app.add_subcommand("sample", "Make a surface to try things on");
  command->add_option("KIND", options->kind,
    "sphere          a sphere with bumps (genus 0)\n"
    "torus           the torus of revolution (genus 1)\n"
    "chain           a bent plate with holes in a row (any genus)\n"
    "ring            a bent disk with holes on a circle (any genus)\n"
    "hyperelliptic   the curve y^2 = x^(2g+2) - 1, glued from four regular polygons (any genus >= 1)\n"
    "polygon         the curve y^2 = x (x^(2g) - 1): opposite sides of a regular 4g-gon are glued (any genus >= 1)\n"
    "l               the L of three unit squares, opposite sides glued (genus 2)\n"
    "cover           the curve y^2 = (x - e1) (x - e2) ..., a double cover of the sphere; needs --branch\n"
    "plate           a flat plate with boundary, with --shape and --holes (genus 0)\n"
    "cut             a MESH of your own with boundary: without --disks, or what is in front of a --plane")
    ->required()->check(CLI::IsMember({"sphere", "torus", "chain", "ring", "hyperelliptic", "polygon", "l", "cover",
                                       "plate", "cut"}));
  command->add_option("MESH", options->mesh, "Mesh to cut (.off, .obj, .ply, .stl, .vtp)")->check(some_name());
  command->add_option("-o,--output", options->file,
                      "File to write: .off, .obj, .ply, .stl; .json for hyperelliptic, polygon, l, cover")->required();
  command->add_option("-g,--genus", options->genus, "Number of holes of chain, ring, hyperelliptic, polygon (2)")
         ->check(CLI::Range(0, 50));
  command->add_option("-n,--resolution", options->resolution,
                      "Edges across the strip between two holes of chain and ring (8); edges round the axis of torus (60); "
                      "rings of a round plate (20), squares along a unit of the others, whose sides are 2 and 3 (8)")
         ->check(CLI::Range(6, 1000));
  command->add_option("-s,--subdivisions", options->subdivisions,
                      "How often each triangle is split into four (sphere, polygon, l 4, hyperelliptic 3, otherwise 0); "
                      "for cover, how often the size of triangles is halved (2)")
         ->check(CLI::Range(0, 8));
  command->add_option("-R", options->R, "Radius of the torus (2)")->check(positive_number());
  command->add_option("-r", options->r, "Radius of the circle that makes the torus (1)")->check(positive_number());
  command->add_option("--branch", options->branch_points,
                      "Branch points of cover, an even number: \"x,y;x,y;...\", x for a real one, inf for infinity");
  command->add_option("--shape", options->shape,
                      "Shape of plate; the holes of a round one are round, of the others square")
         ->check(CLI::IsMember({"round", "rectangle", "L"}).description(""))->type_name("round|rectangle|L")
         ->capture_default_str();
  command->add_option("--holes", options->holes, "Number of holes of plate (0)")->check(CLI::Range(0, 4));
  command->add_option("--disks", options->disks, "Number of disks that cut leaves out, spread over the mesh")
         ->check(CLI::Range(1, 100));
  command->add_option("--radius", options->radius, "Their radius, as a part of the square root of the area")
         ->check(number_between(1e-6, 1))->capture_default_str();
  command->add_option("--plane", options->plane,
                      "Normal of the plane through the middle of the mesh in front of which cut leaves triangles")
         ->expected(3)->delimiter(',')->check(number_between(-1e6, 1e6))->type_name("X,Y,Z");
  const std::string spoil = "To make it bad";
  command->add_option("--noise", options->noise, "Move every vertex at random by up to this part of the mean edge length")
         ->check(number_between(0, 10))->group(spoil);
  command->add_option("--hub", options->hub, "Put a vertex of this valence into a face")
         ->check(CLI::Range(3, 100000))->group(spoil);
  command->add_option("--slivers", options->slivers,
                      "Split one face in five near an edge, at this part of the altitude")
         ->check(number_between(1e-12, 0.5))->group(spoil);
  command->add_option("--stretch", options->stretch, "Stretch the surface along the x axis by this factor")
         ->check(positive_number())->group(spoil);
  command->add_option("--obtuse-boundary", options->obtuse,
                      "Split the triangles at the boundary so that angles opposite to it are obtuse, up to this many "
                      "degrees")
         ->check(number_between(95, 179.9))->group(spoil);
  command->add_option("--seed", options->seed, "Seed of disks, noise, slivers and obtuse angles (1)");
  command->callback([options] { sample(*options); });
}
