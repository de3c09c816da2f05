// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The holomorphic 1-forms as a property map: integrated along a canonical basis they give I and the period matrix.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/discrete_riemann_surface.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: holomorphic_1_form_basis_example MESH.off\n";
    return EXIT_FAILURE;
  }
  const auto forms = QD::holomorphic_1_form_basis(mesh);
  const int genus = forms.surface.genus();
  std::cout.precision(4);
  std::cout << "integrals of phi_1 .. phi_" << genus << " along\n";

  double error = 0;   // of the integrals along a_i, which must be 0 or 1
  const auto basis = forms.surface.canonical_homology_basis();
  for (int k = 0; k < 2 * genus; ++k) {
    Eigen::RowVectorXcd sum = Eigen::RowVectorXcd::Zero(genus);
    for (Mesh::Halfedge_index h : basis.loops[k]) sum += get(forms, h);
    std::cout << "  " << (k < genus ? "a" : "b") << k % genus + 1 << "  " << sum << '\n';
    if (k < genus) error = std::max(error, (sum - Eigen::RowVectorXcd::Unit(genus, k)).cwiseAbs().maxCoeff());
  }

  double curl = 0;
  for (Mesh::Face_index f : mesh.faces()) {
    Eigen::RowVectorXcd sum = Eigen::RowVectorXcd::Zero(genus);
    for (Mesh::Halfedge_index h : halfedges_around_face(mesh.halfedge(f), mesh)) sum += get(forms, h);
    if (genus > 0) curl = std::max(curl, sum.cwiseAbs().maxCoeff());
  }
  std::cout << "normalised up to " << error << ", closed up to " << curl << '\n';
  return error < 1e-9 && curl < 1e-12 ? EXIT_SUCCESS : EXIT_FAILURE;
}
