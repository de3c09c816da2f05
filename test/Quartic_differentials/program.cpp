// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program as a user meets it: what it writes, what it prints, and its exit status.

#include "check.h"
#include "run_program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

using Quartic_test::Outcome;
using Quartic_test::contains;
using Quartic_test::contents;

const Quartic_test::Program_folder folder;

Outcome quartic(const std::string& arguments) { return folder.quartic(arguments); }

void check_failure(const std::string& arguments, int status, const std::string& message)
{
  const Outcome o = quartic(arguments);
  CHECK_EQUAL(o.status, status);
  if (!contains(o.err, message)) std::cerr << "quartic " << arguments << " said: " << o.err << '\n';
  CHECK(contains(o.err, message));
}

void check_help()
{
  const Outcome help = quartic("--help");
  CHECK_EQUAL(help.status, 0);
  for (const char* command : {"run", "info", "verify", "sample", "Exit status"}) CHECK(contains(help.out, command));
  CHECK_EQUAL(quartic("--version").status, 0);
  CHECK_EQUAL(quartic("run --help").status, 0);
  check_failure("", 1, "subcommand");
  check_failure("rum x.off", 1, "");
  check_failure("run chain.off", 1, "output");
}

void check_sample()
{
  CHECK(contains(quartic("sample chain -g 2 -n 6 -o chain.off").out, "genus 2"));
  CHECK(contains(quartic("sample torus -n 24 -o torus.ply").out, "genus 1"));
  CHECK(contains(quartic("sample hyperelliptic -g 3 -s 1 -o curve.json").out, "genus 3"));
  CHECK(contains(quartic("sample polygon -g 3 -s 1 -o polygon.json").out, "genus 3, 20 vertices, 48 faces"));
  CHECK(contains(quartic("sample l -s 0 -o l.json").out, "genus 2, 1 vertices, 6 faces"));
  CHECK(contains(quartic("sample cover --branch '0;1,1;2,-.5;3;3.5,2;inf' -s 0 -o cover.json").out, "genus 2"));
  for (const char* file : {"polygon.json", "l.json", "cover.json"})
    CHECK_EQUAL(quartic(std::string("info ") + file).status, 0);
  check_failure("sample cover -o cover.json", 1, "needs --branch");
  check_failure("sample cover --branch '0;1;2' -o cover.json", 1, "even number");
  check_failure("sample cover --branch '0;1;2;1' -o cover.json", 1, "the points 1 and 3 are the same");
  check_failure("sample cover --branch '0;1;2;x' -o cover.json", 1, "\"x\" is not a number");
  check_failure("sample cover --branch '0;1' -s 7 -o cover.json", 1, "up to -s 6");
  check_failure("sample hyperelliptic -g 3 -o curve.off", 1, "name a .json file");
  check_failure("sample torus -R 1 -r 2 -o t.off", 1, "-r smaller than -R");
  check_failure("sample ring -o nowhere/t.off", 1, "cannot be written");

  CHECK(contains(quartic("sample plate --holes 2 -o plate.off").out, "genus 0, 3 boundary curves"));
  CHECK(contains(quartic("sample plate --shape rectangle -n 6 -s 1 -o plate.off").out,
                 "genus 0, 1 boundary curve, 925 vertices, 1728 faces"));
  CHECK(contains(quartic("sample plate --shape L --holes 1 -o plate.off").out,
                 "genus 0, 2 boundary curves, 472 vertices"));
  const std::string two_disks = quartic("sample cut chain.off --disks 2 -o cut.off").out;
  CHECK(contains(two_disks, "genus 2, 2 boundary curves"));
  CHECK(quartic("sample cut chain.off --disks 2 --seed 1 -o cut.off").out == two_disks);
  CHECK(quartic("sample cut chain.off --disks 2 --seed 2 -o cut.off").out != two_disks);
  CHECK(quartic("sample cut chain.off --disks 2 --radius 0.05 -o cut.off").out != two_disks);
  CHECK(contains(quartic("sample cut torus.ply --plane 0,0,1 --obtuse-boundary 179 -o half.off").out,
                 "genus 0, 2 boundary curves"));
  check_failure("sample cut -o cut.off", 1, "needs a MESH");
  check_failure("sample torus chain.off -o cut.off", 1, "needs a MESH");
  check_failure("sample cut chain.off -o cut.off", 1, "needs --disks or --plane");
  check_failure("sample cut missing.off --disks 1 -o cut.off", 2, "does not exist");
  check_failure("sample cut curve.json --disks 1 -o cut.off", 2, "cannot be cut");
  check_failure("sample cut chain.off --disks 90 -o cut.off", 2, "take a smaller radius");
  check_failure("sample cut chain.off --plane 0,0 -o cut.off", 1, "--plane");
  check_failure("sample cut chain.off --plane 0,0,0 -o cut.off", 2, "take another normal");
  check_failure("sample cut chain.off --disks 1 -s 8 -o cut.off", 1, "triangles, more than");
  check_failure("sample plate -n 8 -o plate.off", 1, "-n 12 or more");
  check_failure("sample plate --holes 5 -o plate.off", 1, "--holes");
  check_failure("sample pyramid -o t.off", 1, "KIND");
}

void check_info()
{
  for (const auto& [file, genus] : {std::pair("chain.off", 2), std::pair("torus.ply", 1), std::pair("curve.json", 3)}) {
    const Outcome o = quartic(std::string("info --json ") + file);
    CHECK_EQUAL(o.status, 0);
    const nlohmann::json report = nlohmann::json::parse(o.out);
    CHECK(report["input"]["genus"] == genus);
    CHECK_EQUAL(report["homology"]["intersection_matrix"].size(), static_cast<std::size_t>(2 * genus));
    CHECK_EQUAL(report["period_matrix"]["re"].size(), static_cast<std::size_t>(genus));
    const bool in_space = report["input"]["embedded"];
    CHECK_EQUAL(report["homology"]["loops"].size(), static_cast<std::size_t>(2 * genus));
    CHECK(report["homology"]["handles_and_tunnels"]["certified"] == in_space);
    for (const nlohmann::json& loop : report["homology"]["loops"]) {
      CHECK(loop["simple"] == true && loop["vertices"].size() >= 2);
      const bool is_a = loop["name"].get<std::string>()[0] == 'a';
      CHECK_EQUAL(loop.value("kind", ""), !in_space ? "" : is_a ? "tunnel" : "handle");
    }
  }
  CHECK(contains(quartic("info chain.off").out, "proved by linking numbers"));
  CHECK(contains(quartic("info curve.json").out, "edge lengths alone"));
  CHECK(!nlohmann::json::parse(quartic("info chain.off --json --no-loops").out)["homology"].contains("loops"));
  check_failure("info missing.off", 2, "missing.off: the file does not exist");
}

void check_formats()
{
  const auto files = [](const std::string& options) {
    CHECK_EQUAL(quartic("run torus.ply -o formats -q --no-html " + options).status, 0);
    std::string there;   // nothing is left of the run before
    for (const char* file : {"flat.obj", "flat.ply", "flat.vtp", "flat.vtu", "flat.glb", "tmesh.obj"})
      if (fs::exists(folder / "formats" / file)) there += std::string(file) + ' ';
    return there;
  };
  CHECK_EQUAL(files(""), "flat.obj ");
  CHECK_EQUAL(files("--surface-format glb --tmesh-obj"), "flat.obj flat.glb tmesh.obj ");
  CHECK_EQUAL(files("--surface-format ply,vtp --surface-format vtu"), "flat.obj flat.ply flat.vtp flat.vtu ");
  CHECK_EQUAL(contents(folder / "formats" / "flat.ply").substr(0, 3), "ply");
  // what a run writes can be read: vertices on seams, which are there more than once, become one again
  for (const char* file : {"flat.ply", "flat.vtp"}) {
    const Outcome o = quartic(std::string("info -q formats/") + file);
    CHECK(contains(o.out, "genus 1") && contains(o.out, "had the same coordinates"));
  }
  check_failure("run torus.ply -o formats --surface-format stl", 1, "stl not in {obj,ply,vtp,vtu,glb}");
  check_failure("run curve.json -o formats --surface-format glb", 2, "known by its edge lengths alone");
  check_failure("run curve.json -o formats --tmesh-obj", 2, "known by its edge lengths alone");
}

void check_run()
{
  const Outcome o = quartic("run chain.off -o results");
  CHECK_EQUAL(o.status, 0);
  CHECK(contains(o.out, "rectangles"));
  for (const char* file : {"flat.obj", "flat.mtl", "flat.png", "flat_intrinsic.json", "tmesh.json", "tmesh.vtp",
                           "singularities.txt", "loops.obj", "report.json"})
    CHECK(fs::file_size(folder / "results" / file) > 0);
  CHECK_EQUAL(quartic("verify results").status, 0);
  CHECK(contains(quartic("verify chain.off results").out, "lies on the input"));
  check_failure("verify torus.ply results", 2, "failed");
  check_failure("verify chain.off", 2, "no folder");
  CHECK(contains(contents(folder / "results" / "tmesh.json"), "\"surface\":\"input\""));
  CHECK(contains(contents(folder / "results" / "loops.obj"), "g b2 handle"));
  CHECK(!fs::exists(folder / "results" / "flat_intrinsic.obj"));
  CHECK(quartic("run chain.off -o again -q --intrinsic").out.empty());
  CHECK(fs::file_size(folder / "again" / "flat_intrinsic.obj") > 0);
  for (const char* file : {"flat.obj", "flat_intrinsic.json", "tmesh.json", "tmesh.vtp", "singularities.txt", "loops.obj"})
    CHECK(contents(folder / "results" / file) == contents(folder / "again" / file));   // deterministic

  const auto timeless_report = [](const char* run) {
    nlohmann::json report = nlohmann::json::parse(contents(folder / run / "report.json"));
    report.erase("timings");
    report.erase("peak_memory_bytes");
    return report;
  };
  CHECK(timeless_report("results") == timeless_report("again"));

  std::string broken = contents(folder / "results" / "tmesh.json");
  const std::size_t width = broken.find("\"width\":");
  CHECK(width != std::string::npos);
  broken.insert(broken.find_first_of("0123456789", width), "1");
  std::ofstream(folder / "results" / "tmesh.json") << broken;
  CHECK_EQUAL(quartic("verify results").status, 2);
}

nlohmann::json report_of(const char* run) { return nlohmann::json::parse(contents(folder / run / "report.json")); }

void check_quads()
{
  CHECK_EQUAL(quartic("run chain.off -o quads --quads 2500 -q").status, 0);
  const nlohmann::json quads = report_of("quads")["quad_mesh"];
  const double number = quads["quads"];
  CHECK(!quads.contains("shortfall") && std::abs(number - 2500) <= 0.05 * 2500);
  CHECK(quads["scaled_jacobian"]["mean"] > 0.95);
  CHECK(quads["scaled_jacobian"]["min"] >= quads["smoothing"]["before"]["min"]);
  CHECK_EQUAL(quartic("run chain.off -o unsmoothed --quads 2500 -q --no-smoothing").status, 0);
  CHECK(report_of("unsmoothed")["quad_mesh"]["scaled_jacobian"]["mean"] < quads["scaled_jacobian"]["mean"]);
  const std::string obj = contents(folder / "quads" / "quads.obj");
  double faces = 0;
  for (std::size_t i = obj.find("\nf "); i != std::string::npos; i = obj.find("\nf ", i + 1)) ++faces;
  CHECK_EQUAL(faces, number);
  CHECK(contains(quartic("run chain.off -o by_length --edge-length 0.3").out, "quads"));
  CHECK(!fs::exists(folder / "results" / "quads.obj"));
  check_failure("run chain.off -o quads --quads 2500 --edge-length 0.3", 1, "excludes");
  check_failure("run curve.json -o no_quads --quads 500", 2, "edge lengths alone");
  std::ofstream(folder / "none.txt") << "# the flat torus\n";
  check_failure("run torus.ply -o flat_torus --singularities none.txt --quads 500", 2, "no T-mesh that could be cut");
  CHECK(fs::exists(folder / "flat_torus" / "flat.obj"));   // what was computed is written
  std::ofstream(folder / "poles.txt") << "1 0 0 -3\n-1 0 0 -3\n0 1 0 -1\n0 -1 0 -1\n";
  CHECK_EQUAL(quartic("sample sphere -s 3 -o sphere.off").status, 0);
  check_failure("run sphere.off -o poles --singularities poles.txt --quads 500", 2, "order -3");
  CHECK(fs::exists(folder / "poles" / "tmesh.json"));
}

void check_choice()
{
  CHECK_EQUAL(quartic("run chain.off -o counted --count 15 -q").status, 0);
  const nlohmann::json counted = report_of("counted");
  CHECK_EQUAL(counted["singularities"].size(), 16u);   // parity
  for (const nlohmann::json& s : counted["singularities"]) CHECK(s["started_at"].size() == 3 && s["moved_by"] >= 0);
  CHECK(counted["distortion"]["search"]["solves"] > 0);

  CHECK_EQUAL(quartic("run chain.off -o rough --distortion 0.1 -q").status, 0);
  CHECK(report_of("rough")["singularities"].size() < counted["singularities"].size());
  CHECK_EQUAL(quartic("run chain.off -o field --start field -q").status, 0);
  CHECK(report_of("field")["distortion"]["starts"][0]["from"] == "field");

  // the paper's: extrema of the curvature, legalized only
  CHECK_EQUAL(quartic("run chain.off -o paper --no-optimize --count 16 -q").status, 0);
  const nlohmann::json paper = report_of("paper");
  CHECK(!paper["distortion"].contains("after_optimization"));
  CHECK(paper["distortion"]["distortion"] > 2 * counted["distortion"]["distortion"].get<double>());
  // the same singularities, optimised; and left as they are
  CHECK_EQUAL(quartic("run chain.off -o optimised --singularities paper/singularities.txt --optimize -q").status, 0);
  CHECK(report_of("optimised")["distortion"]["distortion"] < paper["distortion"]["distortion"]);
  CHECK_EQUAL(quartic("run chain.off -o same --singularities paper/singularities.txt -q").status, 0);
  const double same = report_of("same")["distortion"]["distortion"].get<double>();
  CHECK_NEAR(same, paper["distortion"]["distortion"].get<double>(), 1e-2 * same);
  // more beside those of a file
  std::ofstream(folder / "one.txt") << "0 0 1 2 pinned\n";
  CHECK_EQUAL(quartic("run chain.off -o more --singularities one.txt --count 15 -q").status, 0);
  const nlohmann::json more = report_of("more");
  CHECK(more["singularities"].size() == 15 && more["singularities"][0]["order"] == 2);
  CHECK(more["singularities"][0]["pinned"] == true && more["singularities"][0]["moved_by"] == 0);

  CHECK_EQUAL(quartic("run chain.off -o curve --pareto -q").status, 0);
  const std::string table = contents(folder / "curve" / "pareto.csv");
  CHECK(contains(table, "count,distortion,area_scale_99_to_1_percent\n8,"));
  CHECK_EQUAL(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')),
              report_of("curve")["distortion"]["pareto"].size() + 1);
  CHECK(contains(contents(folder / "curve" / "pareto.svg"), "</svg>"));
  check_failure("run chain.off -o few --count 6", 2, "at least 8");
  check_failure("run chain.off -o wrong --start middle", 1, "--start");
  check_failure("run chain.off -o wrong --distortion -1", 1, "--distortion");
}

void check_refused_input()
{
  std::ofstream(folder / "fan.off") << "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 1 2 3\n";
  check_failure("run fan.off -o refused", 2, "are oriented against each other");
  CHECK(!fs::exists(folder / "refused"));
  std::ofstream(folder / "pair.txt") << "3 0 0 1\n-3 0 0 -1\n";
  check_failure("run torus.ply -o pair --singularities pair.txt", 2, "genus 1");
  std::ofstream(folder / "degree.txt") << "3 0 0 1\n";
  check_failure("run torus.ply -o degree --singularities degree.txt", 2, "degree");
  std::ofstream(folder / "nonsense.txt") << "one two three\n";
  check_failure("run torus.ply -o nonsense --singularities nonsense.txt", 2, "line 1");
  check_failure("run torus.ply -o missing --singularities missing.txt", 2, "missing.txt");
  std::ofstream(folder / "a_file") << "x";
  check_failure("run torus.ply -o a_file", 1, "a_file");
}

// What no run could do ends at once, not when time or memory is used up.
void check_absurd_options()
{
  const auto check = [](const std::string& arguments, int status, const std::string& message) {
    const Outcome o = quartic(arguments);
    if (o.status != status || !contains(o.err, message)) std::cerr << "quartic " << arguments << " said: " << o.err << '\n';
    CHECK_EQUAL(o.status, status);
    CHECK(contains(o.err, message));
    CHECK(o.cpu_seconds < 5);
  };
  for (const char* option : {"--distortion", "--min-distance", "--edge-length"})
    for (const char* value : {"nan", "inf", "-1", "0", "1e999", "''", "x"})
      check("run torus.ply -o absurd " + std::string(option) + ' ' + value, 1, option);
  for (const char* option : {"--quads", "--precision", "--patches", "--count", "--seed", "--least-order", "--most-order"})
    for (const char* value : {"1000000000000", "-1000000000", "1e9", "nan", "0.5"})
      check("run torus.ply -o absurd --splines " + std::string(option) + ' ' + value, 1, option);
  check("run torus.ply -o absurd --quads 1000000000", 1, "--quads");
  check("run torus.ply -o absurd --patches 0 --splines", 1, "--patches");
  for (const char* option : {"-o ''", "-o absurd --singularities ''"})
    check("run torus.ply " + std::string(option), 1, "a name is missing");
  check("run '' -o absurd", 1, "a name is missing");
  CHECK(!fs::exists(folder / "absurd"));
  for (const char* file : {".", "/dev/zero", "missing.txt"})
    check("run torus.ply -o absurd --singularities " + std::string(file), 2, "cannot be read");
  check("run torus.ply -o absurd --count 2000000000", 2, "no room for 2000000000");
  for (const char* length : {"1e-3", "1e-9", "1e-300"})
    check("run torus.ply -o absurd -q --edge-length " + std::string(length), 2, "quads, more than 1.00e+07");
  check("run torus.ply -o absurd -q --splines --edge-length 1e-300", 2, "quads, more than 1.00e+07");
  for (const char* surface : {"chain -g 50 -n 1000", "ring -g 50 -n 100", "torus -n 1000 -s 8", "torus -n 10 -R 1e300 -s 8",
                              "polygon -g 50 -s 8", "hyperelliptic -g 50 -s 8", "sphere -s 9"})
    check("sample " + std::string(surface) + " -o large.json", 1, "");
  check("sample chain -g 50 -n 1000 -o large.off", 1, "triangles, more than 2.00e+07");
  check("sample polygon -g 50 -s 8 -o large.json", 1, "triangles, more than 2.00e+07");
  check("sample sphere --noise nan -o large.off", 1, "--noise");
  check("sample sphere --stretch inf -o large.off", 1, "--stretch");
  CHECK(!fs::exists(folder / "large.off") && !fs::exists(folder / "large.json"));
}

int main()
{
  if (Quartic_test::environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  check_help();
  check_sample();
  check_info();
  check_run();
  check_formats();
  check_quads();
  check_choice();
  check_refused_input();
  check_absurd_options();
  return Quartic_test::result();
}
