// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of README.md: from a mesh to its singularities and rectangles.

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <iostream>

namespace QD = CGAL::Quartic_differentials;

int main(int, char** argv)
{
  std::vector<std::string> notes;
  const QD::Intrinsic_triangulation surface = QD::read_surface(argv[1], notes);
  QD::Visitor visitor;                          // override it to follow the progress, or to stop
  QD::Quartic_differential_result result;
  QD::quartic_differential(surface, std::nullopt, {}, visitor, result);
  for (const QD::Singularity& s : result.singularities)
    std::cout << "a vertex of valence " << s.order + 4 << " in face " << s.location.face << '\n';
  std::cout << result.t_mesh->patches.size() << " rectangles\n";
}
