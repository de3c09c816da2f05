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

// A flat surface: the curvature of its first vertices, which are cones, is given, and the others are flat. Subdivision
// changes neither that nor the area, and splits every triangle into four.
template <class Surface_at_level>
void check_flat(Surface_at_level at_level, int genus, double area, std::size_t triangles, int cones, double curvature)
{
  for (int level = 0; level < 3; ++level) {
    const Glued_triangles s = at_level(level);
    check_glued(s, genus);
    CHECK_EQUAL(s.triangles.size(), triangles << (2 * level));
    const Intrinsic_triangulation t(s);
    CHECK_NEAR(t.area(), area, 1e-12 * triangles * triangles);
    const std::vector<double> k = curvatures(t, corner_angles(t, t.lengths()));
    for (Vertex v : t.vertices()) CHECK_NEAR(k[v], static_cast<int>(v) < cones ? curvature : 0.0, 1e-12 * triangles);
  }
}

double area_of_regular_polygon(int n) { return n / (4 * std::tan(pi / n)); }

// four regular polygons with 2g+2 cones of angle 4 pi g/(g+1), one with a cone of angle (4g-2) pi, and one of 6 pi
void check_flat_surfaces()
{
  for (int g = 1; g <= 8; ++g) {
    const int n = 2 * g + 2;
    check_flat([g](int level) { return hyperelliptic(g, level); }, g, 4 * area_of_regular_polygon(n), 4 * n, n,
               2 * pi - 4 * pi * g / (g + 1));
    check_flat([g](int level) { return regular_polygon(g, level); }, g, area_of_regular_polygon(4 * g), 4 * g, 1,
               2 * pi - (4 * g - 2) * pi);
  }
  check_flat([](int level) { return l_of_three_squares(level); }, 2, 3, 6, 1, 2 * pi - 6 * pi);
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
  check_flat_surfaces();
  check_subdivided_mesh();
  return Quartic_test::result();
}
