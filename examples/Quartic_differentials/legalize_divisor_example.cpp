// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Four valence 3 and four valence 5 vertices anywhere on a torus are no quad mesh's. How little must they move?

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/discrete_riemann_surface.h>

#include <cmath>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace QD  = CGAL::Quartic_differentials;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: legalize_divisor_example TORUS.off\n";
    return EXIT_FAILURE;
  }
  QD::Mesh_divisor<Mesh> divisor;
  for (int i = 0; i < 8; ++i) {
    const Mesh::Vertex_index v(static_cast<unsigned>((2 * i + i % 2) * mesh.number_of_vertices() / 17));
    divisor.push_back({PMP::locate_vertex<double>(v, mesh), i % 2 == 0 ? -1 : 1});
  }
  divisor[0].pinned = true;

  const QD::Discrete_riemann_surface<Mesh> surface(mesh);
  QD::Legalization_options options;
  options.norm = QD::Lattice_norm::movement;
  const QD::Mesh_divisor<Mesh> legal = surface.legalize_divisor(divisor, options);

  std::cout << "off the Abel-Jacobi condition: " << surface.abel_jacobi_map(divisor).distance_from_origin()
            << " -> " << surface.abel_jacobi_map(legal).distance_from_origin() << '\n';
  for (std::size_t i = 0; i < legal.size(); ++i) {
    const Kernel::Point_3 p = PMP::construct_point(divisor[i].location, mesh),
                          q = PMP::construct_point(legal[i].location, mesh);
    std::cout << "valence " << legal[i].order + 4 << " at " << q << ", moved by "
              << std::sqrt(CGAL::squared_distance(p, q)) << (legal[i].pinned ? " (pinned)" : "") << '\n';
  }
  return surface.abel_jacobi_map(legal).distance_from_origin() < 1e-7 ? EXIT_SUCCESS : EXIT_FAILURE;
}
