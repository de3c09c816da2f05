// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same surface and options give the same files, byte by byte, wherever and however the program is run: in another
// folder, language and priority, with other variables, with any number of threads, and from another format. What depends on
// the machine are the last bits of the linear algebra, on other types of processors (METHOD, "Output files").

#include "check.h"
#include "lasting_report.h"
#include "run_program.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

using namespace Quartic_test;

namespace {

const Program_folder folder;
const std::string    options = " -q --quads 300 --splines --pareto --intrinsic --quad-format off,ply,vtu"
                            " --surface-format ply,vtp,vtu,glb --tmesh-obj";

void check_same(const std::string& run)
{
  std::size_t files = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(folder / "first")) {
    const std::string name = file.path().filename();
    ++files;
    if (name == "report.html") continue;          // holds the report, and the command
    const std::string here = contents(folder / run / name), first = contents(file.path());
    const bool same = name == "report.json" ? lasting_report(here) == lasting_report(first) : here == first;
    if (!same) std::cerr << run << ": " << name << " differs" << std::endl;
    CHECK(same);
  }
  CHECK(files > 20);
  CHECK_EQUAL(static_cast<std::size_t>(std::distance(fs::directory_iterator(folder / run), fs::directory_iterator())), files);
}

void check_run(const std::string& run, const std::string& mesh, const std::string& before)
{
  CHECK_EQUAL(folder.quartic("run " + quoted(mesh) + " -o " + quoted(run) + options, before).status, 0);
  check_same(run);
}

// those that are installed, and write numbers with a comma if there are such
std::vector<std::string> languages()
{
  std::vector<std::string> found;
  if (std::system(("locale -a >" + quoted(folder / "languages.txt")).c_str()) != 0) return found;
  std::ifstream in(folder / "languages.txt");
  for (std::string name; std::getline(in, name); )
    if (name.rfind("C.", 0) == 0 || name.rfind("de_", 0) == 0 || name.rfind("fr_", 0) == 0) found.push_back(name);
  return found;
}

} // namespace

int main()
{
  if (environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  for (const char* file : {"torus.off", "torus.obj"})
    CHECK_EQUAL(folder.quartic("sample torus -n 16 -o " + std::string(file)).status, 0);
  fs::create_directories(folder / "elsewhere");
  CHECK_EQUAL(folder.quartic("run torus.off -o first" + options).status, 0);
  check_run("again", "torus.off", "");
  check_run("another name, from another place", (folder / "elsewhere").string() + "/../torus.off", "");
  check_run("another format", "torus.obj", "");
  check_run("little to rely on", "torus.off", "env -i TMPDIR=/nowhere HOME=/nowhere nice");
  check_run("one thread", "torus.off", "env OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 OMP_THREAD_LIMIT=1");
  check_run("many threads", "torus.off", "env OPENBLAS_NUM_THREADS=4 OMP_NUM_THREADS=4");
  for (const std::string& language : languages()) {
    std::cout << "language " << language << std::endl;
    check_run(language, "torus.off", "LC_ALL=" + language);
  }
  return Quartic_test::result();
}
