// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever happens to a run, no file is there by halves: it is killed at random moments, and its folder holds links,
// leftovers and what is in the way. Nothing is ever written outside that folder.

#include "check.h"
#include "run_program.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>

#include <sys/stat.h>

namespace fs = std::filesystem;

using namespace Quartic_test;

namespace {

const Program_folder folder;
const std::string    everything = " -q --quads 300 --splines --quad-format obj,off,ply,vtu --pareto --intrinsic"
                               " --surface-format ply,vtp,vtu,glb --tmesh-obj";

using Files = std::map<std::string, std::string>;   // contents by name

Files files_in(const fs::path& path)
{
  Files files;
  for (const fs::directory_entry& file : fs::directory_iterator(path))
    if (file.is_regular_file()) files[file.path().filename()] = contents(file.path());
  return files;
}

bool is_report(const std::string& name) { return name == "report.json" || name == "report.html"; }   // they hold times

// What is there under its final name has the contents that it has after a whole run.
void check_no_halves(const Files& whole)
{
  if (!fs::exists(folder / "killed")) return;
  for (const auto& [name, text] : files_in(folder / "killed")) {
    if (fs::path(name).extension() == ".part") continue;
    CHECK_EQUAL(whole.count(name), 1u);
    if (is_report(name)) CHECK(text.size() > whole.at(name).size() / 2 && text.back() == '\n');
    else CHECK(text == whole.at(name));
  }
}

double seconds_since(std::chrono::steady_clock::time_point begin)
{ return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); }

void check_killed_runs()
{
  auto begin = std::chrono::steady_clock::now();
  CHECK_EQUAL(folder.quartic("run torus.off -o whole" + everything).status, 0);
  double seconds = seconds_since(begin);   // of the last run that came to its end: the machine may have other work
  const Files whole = files_in(folder / "whole");
  CHECK(whole.size() > 20);
  std::mt19937 random(4);
  int killed = 0, some_files = 0;
  const int attempts = 24;
  for (int i = 0; i < attempts; ++i) {
    const double moment = seconds * (0.3 + 0.7 * (random() / 4294967296.0));   // files are written in the second half
    begin = std::chrono::steady_clock::now();
    const Outcome k = folder.quartic("run torus.off -o killed" + everything, "timeout -s KILL " + std::to_string(moment));
    if (k.status != 0) ++killed;
    else seconds = seconds_since(begin);
    check_no_halves(whole);
    if (fs::exists(folder / "killed") && files_in(folder / "killed").size() > 3) ++some_files;
  }
  std::cout << killed << " of " << attempts << " runs were killed, " << some_files << " left more than three files" << std::endl;
  CHECK(killed >= 6);
  CHECK_EQUAL(folder.quartic("run torus.off -o killed -q").status, 0);   // nothing is left of the runs before
  for (const auto& [name, text] : files_in(folder / "killed"))
    CHECK(fs::path(name).extension() != ".part" && name.rfind("quads", 0) != 0);
}

void check_links_and_obstacles()
{
  fs::create_directories(folder / "elsewhere");
  const std::string before = "not to be touched";
  for (const char* name : {"flat.obj", "flat.obj.part", "report.json", "report.json.part", "tmesh.json"}) {
    std::ofstream(folder / "elsewhere" / name) << before;
    fs::create_directories(folder / "linked");
    fs::create_symlink(fs::path("../elsewhere") / name, folder / "linked" / name);
  }
  std::ofstream(folder / "linked" / "mine.txt") << before;
  CHECK_EQUAL(folder.quartic("run torus.off -o linked -q").status, 0);
  for (const auto& [name, text] : files_in(folder / "elsewhere")) CHECK_EQUAL(text, before);
  CHECK_EQUAL(contents(folder / "linked" / "mine.txt"), before);
  CHECK_EQUAL(folder.quartic("verify torus.off linked").status, 0);
  for (const char* name : {"report.json", "flat.obj"}) {   // pipes, into which nobody writes
    fs::remove(folder / "linked" / name);
    CHECK_EQUAL(mkfifo((folder / "linked" / name).c_str(), 0600), 0);
    const Outcome o = folder.quartic("verify torus.off linked", "timeout 60");
    CHECK_EQUAL(o.status, 2);
    CHECK(contains(o.out, std::string("FAIL  ") + name + ": the file cannot be opened"));
    CHECK_EQUAL(folder.quartic("run torus.off -o linked -q").status, 0);
  }

  fs::create_directories(folder / "blocked" / "tmesh.json" / "full");   // a folder in the place of a file
  const Outcome o = folder.quartic("run torus.off -o blocked -q");
  CHECK_EQUAL(o.status, 1);
  CHECK(contains(o.err, "tmesh.json"));
  for (const auto& [name, text] : files_in(folder / "blocked")) CHECK(fs::path(name).extension() != ".part");
}

// Names stay names: nothing of them is run by a shell, ends a string in a file, or leads to another folder.
void check_names()
{
  const std::string name = "'a' \"b\" $(touch evil) `touch evil` \\ %s\n../<", results = "results\n" + name;
  fs::create_directories(folder / name);
  fs::copy_file(folder / "torus.off", folder / name / "script><b>.off");   // the path ends a script on a careless page
  const std::string mesh = name + "/script><b>.off";
  fs::create_directories(fs::path(folder / results).parent_path());
  const std::set<std::string> before = folder.names();
  CHECK_EQUAL(folder.quartic("run " + quoted(mesh) + " -o " + quoted(results) + " -q --quads 50").status, 0);
  CHECK_EQUAL(folder.quartic("verify " + quoted(mesh) + ' ' + quoted(results)).status, 0);
  CHECK(folder.names() == before);
  CHECK(nlohmann::json::parse(contents(folder / results / "report.json"))["input"]["mesh"] == mesh);
  CHECK(!contains(contents(folder / results / "report.html"), "/script><b>"));
}

} // namespace

int main()
{
  if (environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  CHECK_EQUAL(folder.quartic("sample torus -n 12 -o torus.off").status, 0);
  check_killed_runs();
  check_links_and_obstacles();
  check_names();
  return Quartic_test::result();
}
