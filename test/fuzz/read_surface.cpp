// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever the bytes of a file, reading it ends with a sound surface or with a refusal. The first byte names the format.

#include "temporary_file.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>

using namespace CGAL::Quartic_differentials;

void require_sound(const Intrinsic_triangulation& t)
{
  const std::string defect = structural_defect(t);
  if (defect.empty()) return;
  std::cerr << defect << std::endl;
  std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Quartic_fuzz::Temporary_folder folder;
  static const char* const formats[] = {"off", "obj", "ply", "stl", "json", "vtp"};
  if (size == 0) return 0;
  const std::string contents(data + 1, data + size);
  const std::string path = folder.file(std::string("surface.") + formats[data[0] % 6], contents);
  std::vector<std::string> notes;
  try {
    require_sound(read_surface(path, notes));
  } catch (const Unusable_surface_error&) {
  }
  try {
    for (const Surface_component& c : read_surface_components(path))
      if (c.surface) require_sound(*c.surface);
  } catch (const Unusable_surface_error&) {
  }
  return 0;
}
