// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Abel's theorem: which divisors belong to meromorphic functions, that is, go to the origin of the Jacobian?
// On a torus: zeros p, q and poles r, s if and only if p + q = r + s in its group. Round the axis these are sums of
// angles, 0 + 90 = 180 + 270 degrees for the first divisor below, and 0 + 180 against 90 + 270 for the second.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/discrete_riemann_surface.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh   = CGAL::Surface_mesh<Kernel::Point_3>;
namespace QD = CGAL::Quartic_differentials;

// the vertex nearest to a place, as a zero or a pole
QD::Mesh_singularity<Mesh> at(const Mesh& mesh, const Kernel::Point_3& place, int order)
{
  Mesh::Vertex_index nearest(0);
  for (Mesh::Vertex_index v : mesh.vertices())
    if (CGAL::has_smaller_distance_to_point(place, mesh.point(v), mesh.point(nearest))) nearest = v;
  return {CGAL::Polygon_mesh_processing::locate_vertex<double>(nearest, mesh), order};
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 2 || !CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << "usage: abel_jacobi_map_example TORUS.off\n";
    return EXIT_FAILURE;
  }
  const QD::Discrete_riemann_surface<Mesh> torus(mesh);   // once, for several questions
  const Kernel::Point_3 east(3, 0, 0), north(0, 3, 0), west(-3, 0, 0), south(0, -3, 0);

  const QD::Mesh_divisor<Mesh> yes{at(mesh, east, 1), at(mesh, north, 1), at(mesh, west, -1), at(mesh, south, -1)};
  const QD::Mesh_divisor<Mesh> no{at(mesh, east, 1), at(mesh, west, 1), at(mesh, north, -1), at(mesh, south, -1)};
  const QD::Jacobian_point first = torus.abel_jacobi_map(yes), second = torus.abel_jacobi_map(no);
  std::cout << "zeros east, north, poles west, south: image " << first.image << ", off the origin by "
            << first.distance_from_origin() << '\n'
            << "zeros east, west, poles north, south: image " << second.image << ", off the origin by "
            << second.distance_from_origin() << '\n';
  return first.distance_from_origin() < 1e-2 && second.distance_from_origin() > 0.4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
