// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program on surfaces with boundary: `sample`, `info`, `run` with its choices of corners, and what its files say.

#include "check.h"
#include "run_program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <string>

using namespace Quartic_test;
using Json = nlohmann::json;

namespace {

const Program_folder folder;

Json json_file(const std::string& name) { return Json::parse(contents(folder / name)); }

Outcome succeeds(const std::string& arguments)
{
  const Outcome outcome = folder.quartic(arguments);
  CHECK_EQUAL(outcome.status, 0);
  if (outcome.status != 0) std::cout << arguments << ": " << outcome.err << '\n';
  return outcome;
}

void refused(const std::string& arguments, const std::string& reason)
{
  const Outcome outcome = folder.quartic(arguments);
  CHECK_EQUAL(outcome.status, 2);
  CHECK(contains(outcome.err, reason));
  if (!contains(outcome.err, reason)) std::cout << arguments << ": " << outcome.err << '\n';
}

int degree(const Json& report)
{
  int sum = 0;
  for (const char* list : {"singularities", "corners"})
    for (const Json& s : report[list]) sum += s["order"].get<int>();
  return sum;
}

// How the kinds of nodes of tmesh.json and the counts of the report add up.
void check_t_mesh(const std::string& name, int genus, int curves)
{
  const Json report = json_file(name + "/report.json"), t = json_file(name + "/tmesh.json");
  CHECK_EQUAL(report["input"]["boundary"].get<int>(), curves);
  CHECK_EQUAL(report["input"]["genus"].get<int>(), genus);
  CHECK_EQUAL(degree(report), 8 * genus - 8 + 4 * curves);
  CHECK_EQUAL(static_cast<int>(t["nodes"].size()) - static_cast<int>(t["arcs"].size()) + static_cast<int>(t["patches"].size()),
              2 - 2 * genus - curves);
  std::size_t corners = 0;
  for (const Json& node : t["nodes"]) corners += node["kind"] == "corner";
  CHECK_EQUAL(corners, report["corners"].size());
  CHECK(report["max_holonomy_error_radians"].get<double>() <= 1e-10);
  CHECK(report["immersion"]["rotation_error_radians"].get<double>() <= 1e-10);
}

// A plate with right angles has its corners and no singularities; so says the table of holonomy.
void test_plate()
{
  succeeds("sample plate --shape L --holes 1 -o plate.off");
  CHECK(contains(succeeds("info plate.off").out, "2 boundary curves, genus 0"));
  const Outcome run = succeeds("run plate.off -o plate");
  CHECK(contains(run.out, "2 boundary curves"));
  CHECK(contains(run.out, "5 with 1 quad, 5 with 3 quads"));
  check_t_mesh("plate", 0, 2);
  const Json report = json_file("plate/report.json");
  CHECK(report["singularities"].empty());
  CHECK_EQUAL(report["tmesh"]["corners"].get<int>(), 10);
  CHECK(!report.contains("period_matrix"));
  std::size_t arcs = 0, corners = 0;
  for (const Json& row : report["holonomy"]) {
    const std::string name = row["loop"];
    arcs += name == "arc 1";
    if (!contains(name, "corner ")) continue;
    const std::size_t i = std::stoul(name.substr(7)) - 1;
    CHECK_EQUAL(row["multiple_of_90"].get<int>(), report["corners"][i]["quads"].get<int>());
    ++corners;
  }
  CHECK_EQUAL(arcs, 1u);
  CHECK_EQUAL(corners, 10u);
  // what was found is read back
  succeeds("run plate.off -o again -q --corners plate/corners.txt");
  CHECK_EQUAL(contents(folder / "again/tmesh.json"), contents(folder / "plate/tmesh.json"));
  CHECK_EQUAL(contents(folder / "again/flat.obj"), contents(folder / "plate/flat.obj"));
}

void test_choices_of_corners()
{
  succeeds("sample plate --shape rectangle -n 6 -o rectangle.off");
  succeeds("run rectangle.off -o none -q --corners none --count 4");
  check_t_mesh("none", 0, 1);
  CHECK(json_file("none/report.json")["corners"].empty());
  std::ofstream(folder / "two.txt") << "# two corners\n0 0 0 1 pinned\n3 0 0 1\n";
  succeeds("run rectangle.off -o two -q --corners two.txt");
  check_t_mesh("two", 0, 1);
  const Json corners = json_file("two/report.json")["corners"];
  CHECK_EQUAL(corners.size(), 2u);
  CHECK(corners[0]["pinned"].get<bool>());
  CHECK_EQUAL(corners[0]["moved_by"].get<double>(), 0);
  std::ofstream(folder / "away.txt") << "1.5 1 1 1\n";
  refused("run rectangle.off -o refused -q --corners away.txt", "line 1 of the corners: the point is not on the boundary");
  std::ofstream(folder / "straight.txt") << "0 0 0 2\n";
  refused("run rectangle.off -o refused -q --corners straight.txt", "line 1 of the corners");
  refused("run rectangle.off -o refused -q --corners missing.txt", "the file of corners missing.txt cannot be read");
  refused("run rectangle.off -o refused -q --norm paper", "belong to closed surfaces");
  refused("run rectangle.off -o refused -q --abel-jacobi zeros", "belongs to closed surfaces");
  std::ofstream(folder / "one_pole.txt") << "1.5 1 0 -1\n";
  refused("run rectangle.off -o refused -q --corners auto --singularities one_pole.txt", "8g-8+4b = -4");
}

// Singularities and corners of a run are read back from its files.
void test_handle()
{
  succeeds("sample chain -g 1 -n 6 -o chain.off");
  succeeds("sample cut chain.off --disks 2 -o cut.off");
  succeeds("run cut.off -o cut -q");
  check_t_mesh("cut", 1, 2);
  succeeds("run cut.off -o cut_again -q --singularities cut/singularities.txt --corners cut/corners.txt");
  check_t_mesh("cut_again", 1, 2);
  const Json first = json_file("cut/report.json"), again = json_file("cut_again/report.json");
  CHECK_EQUAL(first["singularities"].size(), again["singularities"].size());
  CHECK_EQUAL(first["corners"].size(), again["corners"].size());
  for (const char* list : {"singularities", "corners"})   // legalization moves them, exact holonomy moves them back
    for (std::size_t i = 0; i < first[list].size(); ++i)
      for (int k = 0; k < 3; ++k)
        CHECK_NEAR(first[list][i]["position"][k].get<double>(), again[list][i]["position"][k].get<double>(), 1e-3);
  succeeds("render cut --view tmesh --size 300");
}

// Three triangles, and one, are surfaces with boundary, but have no vertex where a singularity could start.
void test_small_surfaces()
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  std::ofstream(folder / "three.off") << "OFF\n4 3 0\n" << points << "0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";
  std::ofstream(folder / "one.off") << "OFF\n3 1 0\n" << points << "3 0 1 2\n";
  refused("run three.off -o refused -q", "the surface has no room for");
  refused("run one.off -o refused -q", "the surface has no room for");
}

// Closed surfaces have no corners.
void test_closed()
{
  succeeds("sample torus -n 12 -o torus.off");
  std::ofstream(folder / "corners.txt") << "0 0 0 1\n";
  refused("run torus.off -o refused -q --corners corners.txt", "the surface is closed");
}

} // namespace

int main()
{
  if (environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  test_plate();
  test_choices_of_corners();
  test_handle();
  test_small_surfaces();
  test_closed();
  return Quartic_test::result();
}
