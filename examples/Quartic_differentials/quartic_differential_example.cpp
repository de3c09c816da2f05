// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole pipeline on a mesh: every step's result is there to look at. Progress is shown, and if a step fails, what was
// computed before it is kept.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/quartic_differential.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

struct Steps : QD::Visitor
{
  void step_ends(const std::string& name, double seconds) override
  { std::cerr << name << ": " << seconds << " s\n"; }
};

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: quartic_differential_example MESH.off\n";
    return EXIT_FAILURE;
  }
  QD::Quartic_differential_result result;
  Steps steps;
  try {
    QD::quartic_differential(mesh, QD::Quartic_differential_options(), steps, result);
  } catch (const QD::Error& e) {
    std::cerr << e.what() << '\n';
    if (result.surface) std::cerr << "the period matrix was reached:\n" << result.surface->periods.pi << '\n';
    return EXIT_FAILURE;
  }

  std::cout << "genus " << result.surface->delaunay.genus() << ", period matrix\n" << result.surface->periods.pi << '\n';
  for (const QD::Singularity& s : result.singularities)
    std::cout << "valence " << s.order + 4 << " in face " << s.location.face << '\n';
  std::cout << "curvature error " << result.metric->metric.flow.max_curvature_error << ", holonomy error "
            << result.metric->max_holonomy_error << " radians\n"
            << result.differential->triangulation.number_of_faces() << " charts on a grid of 2^-"
            << result.differential->grid_exponent << ", " << result.t_mesh->patches.size() << " rectangles\n";
  return EXIT_SUCCESS;
}
