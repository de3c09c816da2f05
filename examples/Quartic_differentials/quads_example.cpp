// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A quad mesh of about 2000 quads, and bicubic splines on its patches, in the one call.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/quartic_differential.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: quads_example MESH.off\n";
    return EXIT_FAILURE;
  }
  QD::Quartic_differential_options options;
  options.quads.emplace();
  options.quads->quantization.number_of_quads = 2000;
  options.quads->splines = true;
  const QD::Quartic_differential_result result = QD::quartic_differential(mesh, options);

  const QD::Quads& quads = *result.quads;
  const QD::Mesh quad_mesh = QD::surface_mesh(quads.mesh, *result.t_mesh);   // a CGAL::Surface_mesh of quads
  std::cout << quad_mesh.number_of_faces() << " quads, angles from " << quads.quality.angle.least << " to "
            << quads.quality.angle.most << " degrees\n"
            << quads.splines->patches.size() << " spline patches, distance to the surface at most "
            << quads.splines_quality->distance.most << " of its diagonal\n";
  return QD::defect(quads.mesh, *result.t_mesh).empty() && QD::defect(*quads.splines).empty() ? EXIT_SUCCESS
                                                                                              : EXIT_FAILURE;
}
