// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of README.md: from a mesh to its singularities and rectangles.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/quartic_differential.h>

#include <iostream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
namespace QD = CGAL::Quartic_differentials;

int main(int, char** argv)
{
  CGAL::Surface_mesh<Point> mesh;                // any model of FaceListGraph: closed, connected, triangles
  if (!CGAL::IO::read_OFF(argv[1], mesh)) return 1;
  const QD::Quartic_differential_result result = QD::quartic_differential(mesh);
  for (const QD::Singularity& s : result.singularities)
    std::cout << "a vertex of valence " << s.order + 4 << " in face " << s.location.face << '\n';
  std::cout << result.t_mesh->patches.size() << " rectangles\n";
}
