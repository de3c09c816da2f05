// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program built with CHOLMOD and the one built with Eigen's factorisation report the same integers, and the same
// reals up to 1e-9.

#include "check.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

Json report_of(const std::string& program, const fs::path& mesh, const fs::path& folder, const std::string& options)
{
  CHECK(std::system(("'" + program + "' run -q '" + mesh.string() + "' -o '" + folder.string() + "' " + options).c_str())
        == 0);
  std::ifstream in(folder / "report.json");
  Json report = Json::parse(in);
  // what is a matter of rounding, of the machine or of time
  for (const char* key : {"timings", "peak_memory_bytes", "versions"}) report.erase(key);
  for (const char* key : {"min_altitude", "rotation_error_radians", "largest_move"}) report["immersion"].erase(key);
  return report;
}

void compare(const Json& a, const Json& b, const std::string& where)
{
  if (a.is_number_float() && b.is_number_float()) {
    const double x = a.get<double>(), y = b.get<double>(), difference = std::abs(x - y);
    if (!(difference <= 1e-9 * std::max(1.0, std::abs(x)))) std::cerr << where << ": " << x << " and " << y << std::endl;
    CHECK(difference <= 1e-9 * std::max(1.0, std::abs(x)));
    return;
  }
  if (a.is_structured() && b.is_structured() && a.size() == b.size()) {
    for (auto i = a.items().begin(), k = b.items().begin(); i != a.items().end(); ++i, ++k) {
      CHECK_EQUAL(i.key(), k.key());
      compare(i.value(), k.value(), where + "/" + i.key());
    }
    return;
  }
  if (a != b) std::cerr << where << ": " << a << " and " << b << std::endl;
  CHECK(a == b);
}

} // namespace

int main()
{
  const std::string one = Quartic_test::environment("QUARTIC_PROGRAM"),
                    other = Quartic_test::environment("QUARTIC_PROGRAM_WITH_EIGEN");
  if (one.empty() || other.empty()) {
    std::cout << "skipped: QUARTIC_PROGRAM and QUARTIC_PROGRAM_WITH_EIGEN do not name two programs" << std::endl;
    return Quartic_test::skipped;
  }
  const fs::path folder = fs::temp_directory_path() / ("quartic_solvers_" + std::to_string(std::random_device{}()));
  std::vector<fs::path> meshes;
  for (const fs::path& path : fs::directory_iterator(Quartic_test::environment("QUARTIC_DATA")))
    if (path.extension() != ".md") meshes.push_back(path);
  if (const std::string real = Quartic_test::environment("QUARTIC_TEST_MESHES"); !real.empty())
    for (const char* name : {"rockerarm_20k.off", "3holes_7k2.off", "casting_10k.off"}) meshes.push_back(fs::path(real) / name);
  for (const fs::path& mesh : meshes) {
    std::cout << mesh.filename() << std::endl;
    compare(report_of(one, mesh, folder / "one", "--no-optimize"), report_of(other, mesh, folder / "other", "--no-optimize"),
            mesh.filename().string());
    // which local minimum the search for singularities ends in is a matter of rounding, how good it is must not be
    for (const std::string& program : {one, other})
      CHECK(report_of(program, mesh, folder / "chosen", "")["distortion"]["distortion"].get<double>() <= 0.012);
  }
  fs::remove_all(folder);
  return Quartic_test::result();
}
