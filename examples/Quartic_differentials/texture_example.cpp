// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Texture a mesh: its own faces, slightly subdivided, in the plane. Across every edge the two copies differ by exactly a
// rotation by a multiple of 90 degrees and a translation. Writes PREFIX.obj with a checkerboard, for any viewer.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/quartic_differential.h>

#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 3 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: texture_example MESH.off FOLDER\n";
    return EXIT_FAILURE;
  }
  const QD::Quartic_differential_result result = QD::quartic_differential(mesh);
  const QD::Quartic_differential& q = result.refined->differential;
  const QD::Mesh& surface = q.triangulation.mesh();   // a CGAL::Surface_mesh, with the mesh's vertices first

  std::size_t seams = 0;
  for (QD::Halfedge h : surface.halfedges()) {
    const QD::Halfedge o = surface.opposite(h);
    const QD::Transition& t = q.transition[h];
    if (t(q.corner[h]) != q.corner[surface.next(o)]) return EXIT_FAILURE;   // exact: grid points are integers
    if (!t.is_identity()) ++seams;
  }
  std::cout << surface.number_of_vertices() << " vertices, " << seams / 2 << " edges on seams\n";
  QD::write_flat_obj(argv[2], "textured", q);
  return EXIT_SUCCESS;
}
