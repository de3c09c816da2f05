// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever the files of an output folder hold, the verification ends with a list of checks. The input is these files one
// after the other, with the byte 30 (record separator) between them; an empty file is not there. The last is the mesh.

#include "temporary_file.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/IO/verify_outputs.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>

using namespace CGAL::Quartic_differentials;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Quartic_fuzz::Temporary_folder folder;
  static const char* const files[] = {"report.json", "flat_intrinsic.json", "flat.obj", "tmesh.json", "quads.obj", "mesh.off"};
  std::istringstream records(std::string(data, data + size));
  for (const char* name : files) {
    std::string contents;
    std::getline(records, contents, '\36');
    if (contents.empty()) std::filesystem::remove(folder.path() + "/" + name);
    else folder.file(name, contents);
  }
  std::optional<Intrinsic_triangulation> input;
  std::vector<std::string> notes;
  try {
    input = read_surface(folder.path() + "/mesh.off", notes);
  } catch (const Unusable_surface_error&) {
  }
  if (verify_outputs(folder.path(), input ? &*input : nullptr).empty()) std::abort();   // something is always checked
  return 0;
}
