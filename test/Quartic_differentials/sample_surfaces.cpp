// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The samples are what their documentation says: closed manifolds of the right genus, oriented outward, without
// slivers, or with the boundary that was asked for; subdivision does not change the surface.

#include "check.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/sample_boundaries.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>
#include <CGAL/Quartic_differentials/spoiled_surfaces.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <set>

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

Intrinsic_triangulation checked_with_boundary(const Mesh& mesh, int genus, int curves)
{
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(!mesh.has_garbage());
  const Intrinsic_triangulation t(mesh);
  CHECK_EQUAL(structural_defect(t), "");
  CHECK_EQUAL(t.genus(), genus);
  CHECK_EQUAL(t.number_of_boundary_curves(), curves);
  return t;
}

// the angle opposite to a boundary edge, in degrees
double opposite_angle(const Mesh& mesh, Halfedge inside)
{
  return CGAL::approximate_angle(mesh.point(mesh.source(inside)), mesh.point(mesh.target(mesh.next(inside))),
                                 mesh.point(mesh.target(inside)));
}

void check_plates()
{
  for (int holes = 0; holes <= 4; ++holes)
    for (int resolution : {6, 7, 8, 12}) {
      const Mesh rectangle = plate(Plate_shape::rectangle, holes, resolution);
      const Mesh l = plate(Plate_shape::l, holes, resolution);
      for (const Mesh& mesh : {rectangle, l}) {
        checked_with_boundary(mesh, 0, holes + 1);
        checked_with_boundary(subdivided(mesh), 0, holes + 1);
        for (Halfedge h : mesh.halfedges()) {
          const Vector_3 d = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
          CHECK(!mesh.is_border(h) || d.x() == 0 || d.y() == 0);
        }
      }
      if (resolution % 4 != 0) continue;   // then sides are not rounded
      CHECK_NEAR(CGAL::Polygon_mesh_processing::area(rectangle), 6 - 0.25 * holes, 1e-12);
      CHECK_NEAR(CGAL::Polygon_mesh_processing::area(l), 6.75 - 0.25 * holes, 1e-12);
    }
  for (int holes = 0; holes <= 5; ++holes) checked_with_boundary(plate(holes, 16), 0, holes + 1);
}

void check_cuts()
{
  const Mesh closed = handle_chain(2, 6);
  std::set<std::size_t> different;
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (int disks = 1; disks <= 3; ++disks) {
      const Mesh cut = with_disks_cut_out(closed, disks, 0.08, seed);
      checked_with_boundary(cut, 2, disks);
      CHECK_EQUAL(with_disks_cut_out(closed, disks, 0.08, seed).number_of_faces(), cut.number_of_faces());
      if (disks == 1) different.insert(cut.number_of_faces());
    }
  CHECK(different.size() > 3);
  CHECK_THROWS(with_disks_cut_out(closed, 3, 1, 1), Unusable_surface_error, "take a smaller radius");

  const Mesh half = part_in_front(torus(2, 1, 24, 12), Vector_3(0, 0, 2));
  checked_with_boundary(half, 0, 2);
  for (Vertex v : half.vertices()) CHECK(half.point(v).z() >= 0);
  checked_with_boundary(part_in_front(bumpy_sphere(3), Vector_3(1, 2, 3)), 0, 1);
  Mesh saddle = torus(2, 1, 24, 12);   // with two high ends
  for (Vertex v : saddle.vertices())
    saddle.point(v) = saddle.point(v) + Vector_3(0, 0, std::pow(saddle.point(v).x(), 2));
  CHECK_THROWS(part_in_front(saddle, Vector_3(0, 0, 1)), Unusable_surface_error, "is not connected");
  CHECK_THROWS(part_in_front(closed, Vector_3(0, 0, 0)), Unusable_surface_error, "does not cut the surface");
}

void check_obtuse_boundary()
{
  for (const Mesh& mesh : {plate(2, 14), plate(Plate_shape::l, 1, 8), with_disks_cut_out(handle_chain(1, 6), 2, 0.1)}) {
    const Intrinsic_triangulation before(mesh);
    const Mesh obtuse = with_obtuse_boundary(mesh, 179, 1);
    checked_with_boundary(obtuse, before.genus(), before.number_of_boundary_curves());
    CHECK_NEAR(CGAL::Polygon_mesh_processing::area(obtuse), before.area(), 1e-12 * before.area());
    double least = 180, greatest = 0;
    std::size_t edges = 0;
    for (Halfedge h : obtuse.halfedges()) {
      if (!obtuse.is_border(obtuse.opposite(h))) continue;
      least = std::min(least, opposite_angle(obtuse, h));
      greatest = std::max(greatest, opposite_angle(obtuse, h));
      ++edges;
    }
    CHECK_EQUAL(obtuse.number_of_vertices(), mesh.number_of_vertices() + edges);
    CHECK(least >= 95 && least < 100 && greatest > 174 && greatest <= 179 + 1e-9);
    const Vertex last = obtuse.vertices_end()[-1];
    CHECK(obtuse.point(last) != with_obtuse_boundary(mesh, 179, 2).point(last));
  }
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
  check_plates();
  check_cuts();
  check_obtuse_boundary();
  return Quartic_test::result();
}
