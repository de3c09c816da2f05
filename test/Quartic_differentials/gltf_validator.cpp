// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Khronos's glTF Validator finds no error in the flat.glb of a run, and no warning. QUARTIC_GLTF_VALIDATOR names the
// folder of its npm package, `gltf-validator`; it is run by Node.js.

#include "check.h"
#include "run_program.h"

#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Quartic_test::quoted;

namespace {

const Quartic_test::Program_folder folder;

bool is_valid_gltf(const std::string& file)
{
  const std::string script =
    "require(process.argv[1]).validateBytes(fs.readFileSync(process.argv[2])).then(({issues}) => {"
    "  for (const m of issues.messages.slice(0, 5)) console.log(m.code + ': ' + m.message + ' ' + (m.pointer || ''));"
    "  process.exit(issues.numErrors + issues.numWarnings > 0 ? 1 : 0); })";
  const std::string command = "node -e " + quoted(script) + " "
                            + quoted(Quartic_test::environment("QUARTIC_GLTF_VALIDATOR")) + " " + quoted(folder / file);
  return std::system(command.c_str()) == 0;
}

void check_run(const std::string& surface)
{
  std::cout << surface << std::endl;
  const Quartic_test::Outcome run = folder.quartic("run -q --no-html --surface-format glb -o out " + quoted(surface));
  CHECK_EQUAL(run.status, 0);
  CHECK(is_valid_gltf("out/flat.glb"));
}

// more than single precision holds
std::string huge_torus()
{
  auto mesh = CGAL::Quartic_differentials::torus(1.5e40, 5e39, 24, 12);
  const std::string file = folder / "huge.off";
  CHECK(CGAL::IO::write_polygon_mesh(file, mesh));
  return file;
}

// the validator is really asked
void check_spoiled_file()
{
  const std::string file = Quartic_test::contents(folder / "out/flat.glb");
  std::ofstream(folder / "spoiled.glb", std::ios::binary) << file.substr(0, file.size() - 4);
  CHECK(!is_valid_gltf("spoiled.glb"));
}

} // namespace

int main()
{
  for (const char* needed : {"QUARTIC_GLTF_VALIDATOR", "QUARTIC_PROGRAM", "QUARTIC_DATA"})
    if (Quartic_test::environment(needed).empty()) {
      std::cout << "skipped: the environment variable " << needed << " is not set" << std::endl;
      return Quartic_test::skipped;
    }
  for (const char* name : {"sphere.off", "torus.off", "ring3.off"})
    check_run(Quartic_test::environment("QUARTIC_DATA") + "/" + name);
  check_run(huge_torus());
  check_spoiled_file();
  return Quartic_test::result();
}
