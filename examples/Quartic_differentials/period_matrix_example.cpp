// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The period of a torus of revolution against the truth, i r / sqrt(R^2 - r^2): the error falls by 4 when triangles
// halve. The same surface once more by its edge lengths alone.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/discrete_riemann_surface.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <complex>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

Mesh torus(double R, double r, int n, int m)
{
  Mesh mesh;
  for (int i = 0; i < n * m; ++i) {
    const double u = 2 * CGAL_PI * (i / m) / n, v = 2 * CGAL_PI * (i % m) / m, d = R + r * std::cos(v);
    mesh.add_vertex({d * std::cos(u), d * std::sin(u), r * std::sin(v)});
  }
  const auto vertex = [&](int i, int j) { return Mesh::Vertex_index(i % n * m + j % m); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

int main()
{
  const double R = 2, r = 1;   // a runs through the hole, along the torus; b round its tube
  const std::complex<double> truth(0, r / std::sqrt(R * R - r * r));
  double error = 0, before = 0;
  for (int n : {20, 40, 80, 160}) {
    const Mesh mesh = torus(R, r, n, n / 2);
    const std::complex<double> tau = QD::period_matrix(mesh).pi(0, 0);
    before = error;
    error = std::abs(tau - truth);
    std::cout << mesh.number_of_faces() << " faces: " << tau << ", error " << error << '\n';

    const auto lengths = [&mesh](Mesh::Edge_index e) {
      return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    };
    const auto abstract = QD::period_matrix(
      mesh, QD::parameters::edge_length_map(boost::make_function_property_map<Mesh::Edge_index>(lengths)));
    if (std::abs(abstract.star_defect - QD::period_matrix(mesh).star_defect) > 1e-12) return EXIT_FAILURE;
  }
  std::cout << "truth: " << truth << '\n';
  return before / error > 3.5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
