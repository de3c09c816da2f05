// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program on real meshes: the accuracy its report claims, its own verification and, where it is there, an
// independent one that shares no code with the project.

#include "check.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

bool succeeds(const std::string& command) { return std::system((command + " >/dev/null").c_str()) == 0; }

void check_report(const Json& report, int newton_steps)
{
  CHECK(report["status"] == "done");
  CHECK(report["abel_jacobi"]["residual"].get<double>() <= 1e-12);
  CHECK(report["abel_jacobi"]["iterations"].get<int>() <= 10);
  for (const Json& z : report["abel_jacobi"]["image"])
    CHECK(std::hypot(z["re"].get<double>(), z["im"].get<double>()) < 1e-11);
  const double vertices = report["input"]["vertices"].get<double>() + static_cast<double>(report["singularities"].size());
  CHECK(report["flow"]["max_curvature_error"].get<double>() <= 1e-11 + 1e-15 * vertices);
  CHECK(report["flow"]["newton_iterations"].get<int>() <= newton_steps);
  CHECK(report["flow"]["holonomy_iterations"].get<int>() <= 6);
  const std::size_t loops = 2 * report["input"]["genus"].get<std::size_t>();
  CHECK_EQUAL(report["holonomy"].size(), loops + report["singularities"].size());
  for (const Json& row : report["holonomy"]) CHECK(std::abs(row["error_degrees"].get<double>()) < 1e-8);
  CHECK(report["max_holonomy_error_radians"].get<double>() <= 1e-10);
  CHECK(report["immersion"]["flips"] == 0);
}

// What the default choice of singularities has to reach.
struct Wanted
{
  const char* mesh;
  std::size_t singularities;       // at most
  double      area_scale;          // at most, 99% / 1% quantile ratio
  double      conformal = 1.06;    // mean ratio of the map's singular values, at most
  int         newton_steps = 15;   // of the flow, at most
  bool        surviving_edges = true;   // enough edges of the input are left for the independent check to compare
  double      scaled_jacobian = 0.5;    // of the worst of 4000 quads, at least
};

const Wanted wanted[] = {{"spot_5k8", 40, 3.6}, {"kitten_18k9", 24, 3.5, 1.04}, {"rockerarm_20k", 20, 3.1}, {"lawson_5k", 24, 3.0},
                         {"sculpt_7k3", 32, 3.3, 1.06, 15, true, 0.45}, {"amphora_20k", 36, 3.6}, {"3holes_7k2", 24, 3.0, 1.06, 15, true, 0.75},
                         {"fertility_112k", 48, 3.4, 1.03}, {"botijo_82k", 72, 4.0}, {"bracket_29k", 60, 4.0},
                         {"neptune_30k", 90, 30, 1.2}, {"casting_10k", 90, 3.5}, {"dancer_50k", 80, 4.0},
                         {"buddha_20k", 100, 15, 1.3, 40, false}};

void check_choice(const Json& report, const Wanted& w)
{
  CHECK(report["singularities"].size() <= w.singularities);
  CHECK(report["quality"]["area_scale_99_to_1_percent"].get<double>() <= w.area_scale);
  CHECK(report["quality"]["conformal_distortion"]["mean"].get<double>() <= w.conformal);
  CHECK(report["quality"]["conformal_distortion"]["share_of_area_above_10"].get<double>() <= 0.002);
  CHECK(report["refinement"]["faces_by_input_face"].get<double>() <= (w.conformal > 1.1 ? 3 : 1.7));
  const Json& d = report["distortion"];
  // the linear theory tracks the flat metric, and the search tracks the mesh
  const double linear = d["distortion"].get<double>(), flat = report["quality"]["area_distortion"].get<double>();
  CHECK(std::abs(flat - linear) < (linear < 0.02 ? 0.06 : 0.5) * linear);
  CHECK(d["after_optimization"]["distortion"].get<double>() < 1.001 * d["before_optimization"]["distortion"].get<double>());
  for (const Json& start : d["starts"]) CHECK(start["distortion"].get<double>() > linear);
}

void check_quads(const Json& quads, double least_jacobian)
{
  CHECK(!quads.contains("shortfall"));
  CHECK(std::abs(quads["quads"].get<double>() - 4000) <= 0.05 * 4000);
  CHECK(quads["scaled_jacobian"]["min"].get<double>() >= least_jacobian);
  CHECK(quads["scaled_jacobian"]["mean"].get<double>() > 0.95);
}

void test(const Wanted& w, const fs::path& folder)
{
  const std::string mesh = w.mesh;
  const std::string quartic = Quartic_test::environment("QUARTIC_PROGRAM");
  const fs::path input = fs::path(Quartic_test::environment("QUARTIC_TEST_MESHES")) / (mesh + ".off");
  const fs::path results = folder / mesh;
  CHECK(succeeds("'" + quartic + "' run -q '" + input.string() + "' -o '" + results.string() + "' --quads 4000"));
  std::ifstream in(results / "report.json");
  const Json report = Json::parse(in);
  std::cout << mesh << ": genus " << report["input"]["genus"] << ", " << report["singularities"].size()
            << " singularities, area scale " << report["quality"]["area_scale_99_to_1_percent"] << ", " << report["tmesh"]["patches"] << " patches, holonomy error "
            << report["max_holonomy_error_radians"] << ", " << report["timings"]["total"] << " s" << std::endl;
  check_report(report, w.newton_steps);
  check_choice(report, w);
  check_quads(report["quad_mesh"], w.scaled_jacobian);
  CHECK(succeeds("'" + quartic + "' verify '" + input.string() + "' '" + results.string() + "'"));
  const std::string script = Quartic_test::environment("QUARTIC_VERIFY_OUTPUTS");
  if (script.empty()) return;
  const std::string check = "'" + script + "' '" + input.string() + "' '" + results.string() + "'";
  CHECK(succeeds(check));
  if (w.surviving_edges) CHECK(succeeds(check + " --intrinsic"));
}

} // namespace

int main()
{
  for (const char* needed : {"QUARTIC_TEST_MESHES", "QUARTIC_PROGRAM"})
    if (Quartic_test::environment(needed).empty()) {
      std::cout << "skipped: the environment variable " << needed << " is not set" << std::endl;
      return Quartic_test::skipped;
    }
  const fs::path folder = fs::temp_directory_path() / ("quartic_meshes_" + std::to_string(std::random_device{}()));
  for (const Wanted& w : wanted) test(w, folder);
  fs::remove_all(folder);
  return Quartic_test::result();
}
