// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The patches of the T-mesh as parts of a mesh: every face knows its patch, every vertex its place in the rectangle.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/quartic_differential.h>
#include <CGAL/Quartic_differentials/patch_mesh.h>

#include <cmath>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: patches_example MESH.off\n";
    return EXIT_FAILURE;
  }
  const QD::Quartic_differential_result result = QD::quartic_differential(mesh);
  const QD::T_mesh& t = *result.t_mesh;
  QD::Mesh cut = QD::patch_mesh(t, *result.refined);   // a CGAL::Surface_mesh
  const auto patch = cut.add_property_map<QD::Face, std::uint32_t>("f:patch").first;   // the one that is there

  std::vector<std::size_t> faces(t.patches.size(), 0);
  for (QD::Face f : cut.faces()) ++faces[patch[f]];
  for (std::size_t p = 0; p < t.patches.size(); ++p)
    std::cout << "patch " << p << ": " << std::ldexp(double(t.patches[p].width), -t.grid_exponent) << " x "
              << std::ldexp(double(t.patches[p].height), -t.grid_exponent) << ", " << faces[p] << " triangles\n";
  return EXIT_SUCCESS;
}
