// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_NAMED_SURFACES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_NAMED_SURFACES_H

// The surfaces on which every step is tested: samples of genus 0 to 6 and, where the folder is known, the real meshes.

#include "check.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <iostream>
#include <string>
#include <vector>

namespace Quartic_test {

using CGAL::Quartic_differentials::Intrinsic_triangulation;

struct Named_surface
{
  std::string             name;
  Intrinsic_triangulation surface;
};

inline std::vector<Named_surface> sample_surfaces()
{
  namespace Q = CGAL::Quartic_differentials;
  std::vector<Named_surface> list;
  const auto add = [&](const std::string& name, const auto& surface) {
    list.push_back({name, Intrinsic_triangulation(surface)});
  };
  add("jittered sphere", jittered_sphere(4, 0.3, 1.5, 1));
  add("jittered torus", jittered_torus(40, 20, 0.3, 0.5, 2));
  for (int g = 0; g <= 6; ++g) add("chain of genus " + std::to_string(g), Q::handle_chain(g, 6));
  add("ring of genus 3", Q::handle_ring(3, 6));
  add("hyperelliptic curve of genus 2", Q::hyperelliptic(2, 3));
  add("hyperelliptic curve of genus 4", Q::hyperelliptic(4, 3));
  return list;
}

/// real meshes by name, as far as QUARTIC_TEST_MESHES knows them; says so if it does not
inline std::vector<Named_surface> real_surfaces(const std::vector<std::string>& names)
{
  std::vector<Named_surface> list;
  const std::string folder = environment("QUARTIC_TEST_MESHES");
  if (folder.empty()) {
    std::cout << "QUARTIC_TEST_MESHES is not set: real meshes are skipped" << std::endl;
    return list;
  }
  for (const std::string& name : names) {
    std::vector<std::string> notes;
    list.push_back({name, CGAL::Quartic_differentials::read_surface(folder + "/" + name + ".off", notes)});
  }
  return list;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_NAMED_SURFACES_H
