// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Quad meshes as a user of the program meets them: files in the formats asked for, their quality, their verification.

#include "check.h"
#include "run_program.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

namespace fs = std::filesystem;

using Quartic_test::Outcome;
using Quartic_test::contains;
using Quartic_test::contents;

namespace {

const Quartic_test::Program_folder folder;

std::set<std::string> formats_in(const char* run)
{
  std::set<std::string> formats;
  for (const fs::directory_entry& file : fs::directory_iterator(folder / run))
    if (file.path().stem() == "quads" && file.path().extension() != ".png") formats.insert(file.path().extension().string().substr(1));
  return formats;
}

void check_formats()
{
  const auto check = [](const std::string& options, const std::set<std::string>& formats) {
    CHECK_EQUAL(folder.quartic("run torus.off -o quads -q --quads 100 " + options).status, 0);
    CHECK(formats_in("quads") == formats);   // nothing is left of the run before
  };
  check("--quad-format off,ply --quad-format vtu", {"obj", "off", "ply", "vtu"});
  check("", {"obj", "vtu"});
  check("--quad-format obj", {"obj"});
  check("--quad-format ply", {"obj", "ply"});
  CHECK(contents(folder / "quads" / "quads.ply").substr(0, 4) == "ply\n");
  // one option takes one word: the next is the mesh
  CHECK_EQUAL(folder.quartic("run --quad-format off torus.off -o quads -q --edge-length 0.2").status, 0);
  CHECK(formats_in("quads") == (std::set<std::string>{"obj", "off"}));
  CHECK_EQUAL(folder.quartic("run torus.off -o quads -q").status, 0);
  CHECK(formats_in("quads").empty());

  const auto check_error = [](const std::string& options, const std::string& message) {
    const Outcome o = folder.quartic("run torus.off -o none " + options);
    CHECK_EQUAL(o.status, 1);
    CHECK(contains(o.err, message));
    CHECK(!fs::exists(folder / "none"));
  };
  check_error("--quads 100 --quad-format stl", "stl not in {obj,off,ply,vtu}");
  check_error("--quads 100 --quad-format ply,stl", "stl not in");
  check_error("--quads 100 --quad-format", "--quad-format");
  check_error("--patches 100", "--patches requires --splines");
  check_error("--quad-format ply", "--quad-format requires --quads, --edge-length or --splines");
}

void check_quality()
{
  const Outcome o = folder.quartic("run torus.off -o measured --quads 400");
  CHECK_EQUAL(o.status, 0);
  CHECK(contains(o.out, " degrees, sides of a quad up to 1 : ") && contains(o.out, "distance to the surface at most "));
  const nlohmann::json q = nlohmann::json::parse(contents(folder / "measured" / "report.json"))["quad_mesh"];
  const auto number = [&](const char* pointer) { return q.at(nlohmann::json::json_pointer(pointer)).get<double>(); };
  CHECK(0 < number("/scaled_jacobian/min") && number("/scaled_jacobian/min") < number("/scaled_jacobian/mean"));
  CHECK(0 < number("/angle_degrees/min") && number("/angle_degrees/min") < 90);
  CHECK(90 < number("/angle_degrees/max") && number("/angle_degrees/max") < 180);
  CHECK(0 < number("/angle_degrees/mean_deviation_from_90") && number("/angle_degrees/mean_deviation_from_90") < 45);
  CHECK(1 < number("/edge_ratio/mean") && number("/edge_ratio/mean") < number("/edge_ratio/max"));
  CHECK(0 < number("/edge_length/min") && number("/edge_length/min") < number("/edge_length/mean"));
  CHECK(number("/edge_length/mean") < number("/edge_length/max"));
  for (const char* way : {"/distance_by_diagonal/quads_to_input", "/distance_by_diagonal/input_vertices_to_quads"}) {
    const double rms = number((std::string(way) + "/rms").c_str()), most = number((std::string(way) + "/max").c_str());
    CHECK(0 < rms && rms < most && most < 0.1);
  }
  CHECK(0 < number("/patches"));
  int degree = 0;
  for (const auto& [valence, n] : q.at("irregular_vertices").items()) degree += (std::stoi(valence) - 4) * n.get<int>();
  CHECK_EQUAL(degree, 0);   // of a torus
}

void check_verification()
{
  const auto verify = [] { return folder.quartic("verify torus.off measured"); };
  const Outcome valid = verify();
  CHECK_EQUAL(valid.status, 0);
  CHECK(contains(valid.out, "ok    quads.obj: vertices lie on the input"));
  const std::string obj = contents(folder / "measured" / "quads.obj");
  std::ofstream(folder / "measured" / "quads.obj") << obj.substr(0, obj.rfind("f "));
  CHECK_EQUAL(verify().status, 2);
  CHECK(contains(folder.quartic("verify measured").out, "FAIL  quads.obj: every edge is shared by two quads"));
  fs::remove(folder / "measured" / "quads.obj");
  CHECK_EQUAL(verify().status, 2);
  CHECK(contains(verify().out, "FAIL  quads.obj: the file cannot be opened"));
}

} // namespace

int main()
{
  if (Quartic_test::environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  CHECK_EQUAL(folder.quartic("sample torus -n 24 -o torus.off").status, 0);
  check_formats();
  check_quality();
  check_verification();
  return Quartic_test::result();
}
