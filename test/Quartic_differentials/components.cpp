// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh of several components: refused, or run one by one, each as if it were alone, whatever becomes of the others.

#include "check.h"
#include "lasting_report.h"
#include "run_program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using namespace Quartic_test;
using Json = nlohmann::json;

namespace {

const Program_folder folder;

// Vertices and faces of an OFF file, as lines.
struct Off_file
{
  std::vector<std::string>              points;
  std::vector<std::vector<std::size_t>> triangles;
};

Off_file read_off(const std::string& name)
{
  std::ifstream in(folder / name);
  std::string word;
  Off_file off;
  std::size_t points = 0, triangles = 0;
  in >> word >> points >> triangles >> word;
  for (std::string line; off.points.size() < points && std::getline(in, line); )
    if (!line.empty()) off.points.push_back(line);
  off.triangles.assign(triangles, std::vector<std::size_t>(3));
  for (auto& t : off.triangles) in >> word >> t[0] >> t[1] >> t[2];
  CHECK(in.good());
  return off;
}

// Their vertices and faces in turn, so that every component is scattered over the file.
void write_together(const std::string& name, const std::vector<Off_file>& parts)
{
  std::ostringstream points, triangles;
  std::size_t v = 0, t = 0, longest = 0;
  for (const Off_file& part : parts) longest = std::max({longest, part.points.size(), part.triangles.size()});
  std::vector<std::vector<std::size_t>> index(parts.size());
  for (std::size_t i = 0; i < longest; ++i)
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (i >= parts[k].points.size()) continue;
      points << parts[k].points[i] << '\n';
      index[k].push_back(v++);
    }
  for (std::size_t i = 0; i < longest; ++i)
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (i >= parts[k].triangles.size()) continue;
      triangles << '3';
      for (std::size_t corner : parts[k].triangles[i]) triangles << ' ' << index[k][corner];
      triangles << '\n';
      ++t;
    }
  std::ofstream(folder / name) << "OFF\n" << v << ' ' << t << " 0\n" << points.str() << triangles.str();
}

std::size_t number_of_files(const fs::path& path)
{ return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator())); }

// The folder of a component has what is in the folder of a run of it alone.
void check_same(const std::string& component, const std::string& alone)
{
  for (const fs::directory_entry& file : fs::directory_iterator(folder / alone)) {
    const std::string name = file.path().filename();
    if (name == "report.html") continue;          // holds the report, and the command
    const bool same = name == "report.json"
      ? lasting_report(contents(folder / component / name)) == lasting_report(contents(file.path()))
      : contents(folder / component / name) == contents(file.path());
    if (!same) std::cerr << component << ": " << name << " differs" << std::endl;
    CHECK(same);
  }
  CHECK_EQUAL(number_of_files(folder / component), number_of_files(folder / alone));
}

const std::string options = " -q --quads 200 --pareto --surface-format ply";

void check_each()
{
  CHECK_EQUAL(folder.quartic("sample torus -n 24 -o torus.off").status, 0);
  CHECK_EQUAL(folder.quartic("sample sphere -s 2 -o sphere.off").status, 0);
  const Off_file torus = read_off("torus.off"), sphere = read_off("sphere.off");
  write_together("two.off", {sphere, torus});
  const Outcome refused = folder.quartic("run two.off -o out");
  CHECK_EQUAL(refused.status, 2);
  CHECK(contains(refused.err, "the surface has 2 components: ") && contains(refused.err, "--components each"));
  CHECK(!fs::exists(folder / "out"));
  CHECK_EQUAL(folder.quartic("run two.off -o out --components one").status, 2);

  CHECK_EQUAL(folder.quartic("run two.off -o out --components each" + options).status, 0);
  for (const auto& [number, alone] : {std::pair(0, "torus"), std::pair(1, "sphere")}) {
    CHECK_EQUAL(folder.quartic("run " + std::string(alone) + ".off -o " + alone + options).status, 0);
    check_same("out/component_" + std::to_string(number), alone);
  }
  CHECK_EQUAL(number_of_files(folder / "out"), 3u);
  const Json file = Json::parse(contents(folder / "out" / "components.json"));
  CHECK(file["mesh"] == "two.off" && file["exit_status"] == 0 && file["components"].size() == 2);
  const Json first = {{"folder", "component_0"}, {"vertices", 288}, {"edges", 864}, {"faces", 576}, {"genus", 1},
                      {"boundary", 0}, {"exit_status", 0}};
  CHECK(file["components"][0] == first);
  CHECK(file["components"][1]["genus"] == 0 && file["components"][1]["folder"] == "component_1");

  const Outcome verified = folder.quartic("verify two.off out");
  CHECK_EQUAL(verified.status, 0);
  CHECK(contains(verified.out, "ok    component_1: flat.obj: lies on the input"));
  CHECK_EQUAL(folder.quartic("verify out").status, 0);
  CHECK(contains(folder.quartic("verify torus.off out").err, "torus.off has 1 components, but there are results of 2"));
  write_together("other.off", {sphere, sphere});
  CHECK(contains(folder.quartic("verify other.off out").out, "FAIL  component_0: flat.obj: "));
  fs::remove(folder / "out" / "component_1" / "tmesh.json");
  CHECK_EQUAL(folder.quartic("verify out").status, 2);
  for (const char* broken : {"", "{", "[]", "{\"components\":[{}]}", "{\"components\":[{\"exit_status\":\"0\"}]}"}) {
    std::ofstream(folder / "out" / "components.json") << broken;
    const Outcome o = folder.quartic("verify out");
    CHECK(o.status == 2 && contains(o.err, "is not the list of components"));
  }
}

// One that cannot be used and one whose run fails do not keep the others from running.
void check_failures()
{
  const Off_file torus = read_off("torus.off"), sphere = read_off("sphere.off");
  const Off_file flat{{"7 0 0", "8 0 0", "9 0 0"}, {{0, 1, 2}}};
  write_together("mixed.off", {flat, sphere, torus});
  const Outcome o = folder.quartic("run mixed.off -o mixed --components each --count 8");
  CHECK_EQUAL(o.status, 2);
  CHECK(contains(o.err, "quartic: component_2: face 0 at (7, 0, 0) has no area"));
  CHECK(contains(o.err, "quartic: 1 of 3 components failed"));
  CHECK(contains(o.out, "component_0            288       864       576         1         0  0, done\n"));
  CHECK(contains(o.out, "component_2              3         -         1         -         -  2: face 0"));
  Json file = Json::parse(contents(folder / "mixed" / "components.json"));
  CHECK_EQUAL(file["exit_status"], 2);
  for (int i = 0; i < 2; ++i) CHECK_EQUAL(file["components"][i]["exit_status"], 0);
  const Json last = {{"folder", "component_2"}, {"vertices", 3}, {"faces", 1}, {"exit_status", 2},
                     {"reason", "face 0 at (7, 0, 0) has no area: its corners lie on a line"}};
  CHECK(file["components"][2] == last);
  CHECK(!fs::exists(folder / "mixed" / "component_2"));
  const Outcome verified = folder.quartic("verify mixed.off mixed");
  CHECK_EQUAL(verified.status, 0);
  CHECK(contains(verified.out, "component_2: its run failed, it is not checked"));

  // the largest, in which a face is there twice
  Off_file twice = torus;
  twice.triangles.push_back(torus.triangles[0]);
  write_together("twice.off", {sphere, twice});
  CHECK_EQUAL(folder.quartic("run twice.off -o twice -q --components each").status, 2);
  file = Json::parse(contents(folder / "twice" / "components.json"));
  CHECK(contains(file["components"][0]["reason"], "has the same corners") && file["components"][1]["exit_status"] == 0);

  // 6 singularities are enough on the torus, but not on the sphere, whose report says so; of the run before nothing is
  // left
  std::ofstream(folder / "mixed" / "component_0" / "own.txt") << "not ours";
  const Outcome few = folder.quartic("run two.off -o mixed -q --components each --count 6");
  CHECK_EQUAL(few.status, 2);
  CHECK(few.out.empty() && contains(few.err, "quartic: component_1: ") && contains(few.err, "at least 8"));
  file = Json::parse(contents(folder / "mixed" / "components.json"));
  CHECK(file["components"][0]["exit_status"] == 0 && file["components"][1]["exit_status"] == 2);
  CHECK(file["components"][1]["genus"] == 0 && contains(file["components"][1]["reason"], "at least 8"));
  CHECK(Json::parse(contents(folder / "mixed" / "component_1" / "report.json"))["status"] == "failed");
  CHECK(!fs::exists(folder / "mixed" / "component_1" / "flat.obj"));
  CHECK(fs::exists(folder / "mixed" / "component_0" / "own.txt"));

  // a run of one surface into the folder removes them, and only what is ours
  CHECK_EQUAL(folder.quartic("run torus.off -o mixed -q").status, 0);
  CHECK(!fs::exists(folder / "mixed" / "components.json") && !fs::exists(folder / "mixed" / "component_1"));
  CHECK(fs::exists(folder / "mixed" / "component_0" / "own.txt"));
  CHECK_EQUAL(number_of_files(folder / "mixed" / "component_0"), 1u);

  CHECK_EQUAL(folder.quartic("run two.off -o none --components all").status, 1);
  CHECK_EQUAL(folder.quartic("run two.off -o none --components each --singularities x.txt").status, 1);
  const Outcome corners = folder.quartic("run two.off -o none --components each --corners x.txt");
  CHECK(corners.status == 1 && contains(corners.err, "--corners FILE, which has the corners of one surface"));
  CHECK_EQUAL(folder.quartic("run missing.off -o none --components each").status, 2);
  CHECK(!fs::exists(folder / "none"));
}

} // namespace

int main()
{
  if (environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  check_each();
  check_failures();
  return Quartic_test::result();
}
