// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The samples are what their documentation says: closed manifolds of the right genus, oriented outward, without
// slivers, and subdivision does not change the surface.

#include "check.h"

#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>

using namespace CGAL::Quartic_differentials;

const double pi = 3.14159265358979323846;

double smallest_angle_in_degrees(const Intrinsic_triangulation& t)
{
  const std::vector<double> angles = corner_angles(t, t.lengths());
  return *std::min_element(angles.begin(), angles.end()) * 180 / pi;
}

void check_embedded(Mesh mesh, int genus)
{
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_closed(mesh));
  CHECK(!mesh.has_garbage());
  CHECK(CGAL::Polygon_mesh_processing::volume(mesh) > 0);
  const Intrinsic_triangulation t(std::move(mesh));
  CHECK_EQUAL(structural_defect(t), "");
  CHECK_EQUAL(t.genus(), genus);
  CHECK(smallest_angle_in_degrees(t) > 20);
}

void check_glued(const Glued_triangles& s, int genus)
{
  const Intrinsic_triangulation t(s);   // throws unless glued consistently
  CHECK_EQUAL(structural_defect(t), "");
  CHECK_EQUAL(t.genus(), genus);
}

// y^2 = x^(2g+2) - 1: 2g+2 cones of angle 4 pi g/(g+1), flat elsewhere, area of four regular polygons
void check_hyperelliptic(int g)
{
  const int n = 2 * g + 2;
  double area = 0;
  for (int level = 0; level < 3; ++level) {
    const Glued_triangles s = hyperelliptic(g, level);
    check_glued(s, g);
    CHECK_EQUAL(s.triangles.size(), static_cast<std::size_t>(4 * n) << (2 * level));
    const Intrinsic_triangulation t(s);
    CHECK_NEAR(t.area(), n / std::tan(pi / n), 1e-12 * n * n);
    if (level > 0) CHECK_NEAR(t.area(), area, 1e-12 * n * n);
    area = t.area();
    const std::vector<double> k = curvatures(t, corner_angles(t, t.lengths()));
    for (Vertex v : t.vertices())
      CHECK_NEAR(k[v], static_cast<int>(v) < n ? 2 * pi - 4 * pi * g / (g + 1) : 0.0, 1e-12);
  }
}

void check_subdivided_mesh()
{
  const Mesh coarse = torus(3, 1, 8, 5), fine = subdivided(coarse);
  CHECK_EQUAL(fine.number_of_vertices(), coarse.number_of_vertices() + coarse.number_of_edges());
  CHECK_EQUAL(fine.number_of_faces(), 4 * coarse.number_of_faces());
  for (Vertex v : coarse.vertices()) CHECK(fine.point(v) == coarse.point(v));
  CHECK_NEAR(CGAL::Polygon_mesh_processing::area(fine), CGAL::Polygon_mesh_processing::area(coarse), 1e-12);
  CHECK_NEAR(CGAL::Polygon_mesh_processing::volume(fine), CGAL::Polygon_mesh_processing::volume(coarse), 1e-12);
  check_embedded(subdivided(torus(3, 1, 24, 12)), 1);
}

int main()
{
  for (int level = 0; level < 5; ++level) check_embedded(bumpy_sphere(level), 0);
  check_embedded(torus(2, 1, 40, 20), 1);
  for (int g = 0; g <= 8; ++g)
    for (int resolution : {6, 7, 10}) {
      check_embedded(handle_chain(g, resolution), g);
      check_embedded(handle_ring(g, resolution), g);
    }
  for (int g = 1; g <= 8; ++g) check_hyperelliptic(g);
  check_subdivided_mesh();
  return Quartic_test::result();
}
