// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops that people recognise: a_i runs through a tunnel, b_i round a handle, and they cross once.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/discrete_riemann_surface.h>

#include <cmath>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: canonical_homology_basis_example MESH.off\n";
    return EXIT_FAILURE;
  }
  const auto basis = QD::canonical_homology_basis(mesh);
  std::cout << (basis.certified ? "proved: tunnels and handles" : basis.reason) << '\n';

  const std::size_t genus = basis.loops.size() / 2;
  for (std::size_t k = 0; k < basis.loops.size(); ++k) {
    double length = 0;
    for (Mesh::Halfedge_index h : basis.loops[k])
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
    std::cout << (k < genus ? "tunnel a" : "handle b") << k % genus + 1 << ": " << basis.loops[k].size()
              << " edges, length " << length << ", from vertex " << mesh.source(basis.loops[k].front()).idx() << '\n';
  }
  return basis.certified ? EXIT_SUCCESS : EXIT_FAILURE;
}
