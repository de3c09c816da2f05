// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Start from singularities of one's own: four of valence 3 and four of valence 5 on a torus. One is pinned; the others
// are moved as little as possible, until they are those of a quartic differential.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/quartic_differential.h>

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
    std::cerr << "usage: own_singularities_example MESH.off\n";
    return EXIT_FAILURE;
  }
  QD::Mesh_divisor<Mesh> divisor;
  for (int i = 0; i < 8; ++i) {
    const Mesh::Vertex_index v(static_cast<unsigned>((2 * i + i % 2) * mesh.number_of_vertices() / 17));
    divisor.push_back({PMP::locate_vertex<double>(v, mesh), i % 2 == 0 ? -1 : 1});
  }
  divisor[0].pinned = true;

  const QD::Quartic_differential_result result =
    QD::quartic_differential(mesh, QD::Quartic_differential_options(), QD::parameters::singularities(divisor));
  for (std::size_t i = 0; i < divisor.size(); ++i)
    std::cout << "valence " << divisor[i].order + 4 << " moved by " << result.metric->moved_by[i] << '\n';
  std::cout << "off the Abel-Jacobi condition at first by " << result.legal->history.front() << ", at last by "
            << result.legal->history.back() << " radians\n";
  return result.singularities.size() == divisor.size() && result.t_mesh ? EXIT_SUCCESS : EXIT_FAILURE;
}
