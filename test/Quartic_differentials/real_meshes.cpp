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

void check_report(const Json& report)
{
  CHECK(report["status"] == "done");
  CHECK(report["abel_jacobi"]["residual"].get<double>() <= 1e-12);
  CHECK(report["abel_jacobi"]["iterations"].get<int>() <= 10);
  for (const Json& z : report["abel_jacobi"]["image"])
    CHECK(std::hypot(z["re"].get<double>(), z["im"].get<double>()) < 1e-11);
  const double vertices = report["input"]["vertices"].get<double>() + static_cast<double>(report["singularities"].size());
  CHECK(report["flow"]["max_curvature_error"].get<double>() <= 1e-11 + 1e-15 * vertices);
  CHECK(report["flow"]["newton_iterations"].get<int>() <= 15);
  CHECK(report["flow"]["holonomy_iterations"].get<int>() <= 6);
  const std::size_t loops = 2 * report["input"]["genus"].get<std::size_t>();
  CHECK_EQUAL(report["holonomy"].size(), loops + report["singularities"].size());
  for (const Json& row : report["holonomy"]) CHECK(std::abs(row["error_degrees"].get<double>()) < 1e-8);
  CHECK(report["max_holonomy_error_radians"].get<double>() <= 1e-10);
  CHECK(report["immersion"]["flips"] == 0);
  const double distortion = report["quality"]["conformal_distortion"]["mean"].get<double>();
  CHECK(distortion >= 1 && distortion < 1.5);
}

void test(const std::string& mesh, const fs::path& folder)
{
  const std::string quartic = Quartic_test::environment("QUARTIC_PROGRAM");
  const fs::path input = fs::path(Quartic_test::environment("QUARTIC_TEST_MESHES")) / (mesh + ".off");
  const fs::path results = folder / mesh;
  CHECK(succeeds("'" + quartic + "' run -q '" + input.string() + "' -o '" + results.string() + "'"));
  std::ifstream in(results / "report.json");
  const Json report = Json::parse(in);
  std::cout << mesh << ": genus " << report["input"]["genus"] << ", " << report["singularities"].size()
            << " singularities, " << report["tmesh"]["patches"] << " patches, holonomy error "
            << report["max_holonomy_error_radians"] << ", " << report["timings"]["total"] << " s" << std::endl;
  check_report(report);
  CHECK(succeeds("'" + quartic + "' verify '" + results.string() + "'"));
  if (const std::string script = Quartic_test::environment("QUARTIC_VERIFY_OUTPUTS"); !script.empty())
    CHECK(succeeds("'" + script + "' '" + input.string() + "' '" + results.string() + "' --intrinsic --no-quads"));
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
  for (const char* mesh : {"spot_5k8", "kitten_18k9", "rockerarm_20k", "lawson_5k", "sculpt_7k3", "amphora_20k",
                           "3holes_7k2", "fertility_112k", "botijo_82k", "bracket_29k", "neptune_30k", "casting_10k"})
    test(mesh, folder);
  fs::remove_all(folder);
  return Quartic_test::result();
}
