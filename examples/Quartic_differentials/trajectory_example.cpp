// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Trace a trajectory: start at a point of a mesh, walk straight through the flat charts, and get the curve on the mesh.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/quartic_differential.h>
#include <CGAL/Quartic_differentials/pull_back.h>

#include <cmath>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: trajectory_example MESH.off\n";
    return EXIT_FAILURE;
  }
  const QD::Quartic_differential_result result = QD::quartic_differential(mesh);
  const QD::Refined_surface& refined = *result.refined;
  const QD::Intrinsic_triangulation input = QD::intrinsic_triangulation(mesh);

  // from the middle of the first face, as far as the surface is large, along the grid and across it
  const QD::Surface_point start = refined.from_input({QD::Face(0), {1. / 3, 1. / 3, 1. / 3}});
  const std::complex<double> z = refined.differential.chart(start);
  const double length = std::sqrt(input.area()) / refined.differential.surface_units_per_unit;
  for (const std::complex<double> direction : {std::complex<double>(1, 0), std::complex<double>(0, 1)}) {
    const QD::Pulled_back_arc arc =
      QD::pull_back(refined, start.face, {QD::nearest_grid_point(refined.differential, z),
                                          QD::nearest_grid_point(refined.differential, z + length * direction)});
    double on_surface = 0;
    for (std::size_t k = 1; k < arc.points.size(); ++k)
      on_surface += std::sqrt(CGAL::squared_distance(QD::position_on_input(input, arc.points[k - 1]),
                                                     QD::position_on_input(input, arc.points[k])));
    std::cout << "a trajectory over " << arc.points.size() - 1 << " pieces of faces, " << on_surface
              << " long, turned by " << 90 * arc.to_last_chart.rotation << " degrees from chart to chart\n";
  }
  return EXIT_SUCCESS;
}
