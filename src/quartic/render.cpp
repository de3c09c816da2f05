// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Quartic_differentials/IO/write_picture.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
namespace fs = std::filesystem;

namespace {

struct Render_options
{
  std::string         folder, target, view = "all";
  std::vector<double> direction, up;
  Picture_options     picture;
};

const std::map<std::string, Picture> views{{"checkerboard", Picture::checkerboard}, {"tmesh", Picture::t_mesh},
                                           {"quads", Picture::quads}, {"wireframe", Picture::wireframe},
                                           {"loops", Picture::loops}};

// Those of all views for which the folder has files; it is said of the others what they lack.
std::vector<Picture> possible_pictures(const std::string& folder)
{
  std::vector<Picture> possible;
  for (const auto& [name, picture] : views) {
    const std::vector<std::string> missing = missing_files(folder, picture);
    if (missing.empty()) possible.push_back(picture);
    else std::cout << "no picture of the view " << name << ": " << folder << " has no " << missing.front() << '\n';
  }
  if (possible.empty()) throw Unusable_surface_error(folder + " holds no results that could be drawn");
  return possible;
}

std::optional<Vector_3> vector(const std::vector<double>& coordinates, const char* option)
{
  if (coordinates.empty()) return std::nullopt;
  const Vector_3 v(coordinates[0], coordinates[1], coordinates[2]);
  const double n = v.squared_length();
  if (!(n > 0) || !std::isfinite(n)) throw Error(std::string(option) + " is no direction");
  return v;
}

void render(const Render_options& options)
{
  if (!fs::is_directory(options.folder)) throw Unusable_surface_error("there is no folder " + options.folder);
  Picture_options picture = options.picture;
  picture.direction = vector(options.direction, "--direction");
  picture.up = vector(options.up, "--up");
  const std::string target = options.target.empty() ? options.folder : options.target;
  std::error_code error;
  fs::create_directories(target, error);
  if (!fs::is_directory(target)) throw Error("the output folder " + target + " cannot be made");
  const std::vector<Picture> pictures =
    options.view == "all" ? possible_pictures(options.folder) : std::vector<Picture>{views.at(options.view)};
  write_pictures(options.folder, pictures, target, picture);
  for (Picture p : pictures) std::cout << target << '/' << picture_name(p) << '\n';
}

} // namespace

void add_render(CLI::App& app)
{
  auto options = std::make_shared<Render_options>();
  CLI::App* command = app.add_subcommand("render", "Draw the results in a folder as pictures, picture_VIEW.png");
  command->add_option("DIR", options->folder, "Output folder of a run")->required();
  command->add_option("-o,--output", options->target, "Folder for the pictures, made if it is not there (DIR)");
  command->add_option("--view", options->view,
                      "What to draw: 'checkerboard', the charts; 'tmesh', the rectangles; 'quads', the quad mesh; "
                      "'wireframe', the refined triangles; 'loops', tunnel loops amber and handle loops teal; 'all', "
                      "those for which there are results")
         ->check(CLI::IsMember({"checkerboard", "tmesh", "quads", "wireframe", "loops", "all"}))->capture_default_str();
  command->add_option("--size", options->picture.size, "Pixels of the longer side")
         ->check(CLI::Range(16, 10000))->capture_default_str();
  command->add_option("--direction", options->direction,
                      "From the surface to the eye, x,y,z; without it along the axis in which the surface is thinnest, "
                      "turned by 25 degrees")->delimiter(',')->expected(3)->type_name("X,Y,Z");
  command->add_option("--up", options->up, "What is upward in the picture, x,y,z; without it y, or z in a view along y")
         ->delimiter(',')->expected(3)->type_name("X,Y,Z");
  command->add_flag("--both-sides", options->picture.both_sides, "Show the surface from behind as well, on the right");
  command->callback([options] { render(*options); });
}
