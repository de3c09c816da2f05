// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a surface meets itself: the quick proofs that faces are apart, against CGAL's own test of all faces.

#include "check.h"

#include "internal/faces_that_may_meet.h"

#include <CGAL/Quartic_differentials/handle_tunnel_basis.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>
#include <CGAL/Quartic_differentials/spoiled_surfaces.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// the faces of all pairs that meet elsewhere than in common corners and edges
std::vector<Face> faces_that_meet(const Mesh& mesh)
{
  Exact_mesh exact;
  for (Vertex v : mesh.vertices()) exact.add_vertex({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for (Face f : mesh.faces()) {
    const auto v = mesh.vertices_around_face(mesh.halfedge(f));
    exact.add_face(std::vector<Vertex>(v.begin(), v.end()));
  }
  std::vector<std::pair<Face, Face>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(exact, std::back_inserter(pairs));
  std::vector<Face> faces;
  for (const auto& [f, g] : pairs) faces.insert(faces.end(), {f, g});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// None that meets another is overlooked, and few are left to a slower test, at most a share of all besides four times
// those that do meet. Says whether the surface meets itself.
bool test(const std::string& name, const Mesh& mesh, double share = 0)
{
  const Intrinsic_triangulation t(mesh);
  const std::vector<Face> meet = faces_that_meet(mesh), may_meet = internal::faces_that_may_meet(t);
  CHECK(std::includes(may_meet.begin(), may_meet.end(), meet.begin(), meet.end()));
  CHECK(may_meet.size() <= 4 * meet.size() + share * t.number_of_faces());
  const Handle_tunnel_basis basis = handle_tunnel_basis(t, homology_basis(t));
  CHECK_EQUAL(basis.certified, meet.empty());
  std::cout << name << ": of " << t.number_of_faces() << " faces " << meet.size() << " meet others, " << may_meet.size()
            << " may" << std::endl;
  return !meet.empty();
}

Mesh with_point(Mesh mesh, std::size_t v, const Point_3& p)
{
  mesh.point(Vertex(static_cast<Mesh::size_type>(v))) = p;
  return mesh;
}

} // namespace

int main()
{
  CHECK(!test("torus", torus(2, 1, 40, 20)));
  CHECK(!test("handle chain", handle_chain(3, 8)));
  for (double part : {0.1, 0.3, 0.5, 1.0}) test("noisy ring", noisy(handle_ring(3, 8), part, 7));
  CHECK(test("very noisy torus", noisy(torus(2, 1, 40, 20), 2, 3)));
  CHECK(!test("slivers", with_slivers(torus(2, 1, 30, 15), 1e-4, 5)));
  CHECK(!test("hub", with_hub(torus(2, 1, 30, 15), 60)));
  CHECK(!test("stretched", stretched(torus(2, 1, 30, 15), 1e6), 0.03));

  // flat parts, whose triangles lie in one plane: a frame of four prisms
  Mesh frame = torus(2, 1, 4, 4);
  for (int i = 0; i < 3; ++i) frame = subdivided(frame);
  CHECK(!test("frame", frame, 0.08));
  // a vertex drawn across the plane: triangles overlap in it
  const std::size_t last = frame.number_of_vertices() - 1;
  const Halfedge h = frame.halfedge(Vertex(static_cast<Mesh::size_type>(last)));
  const Point_3 p = frame.point(frame.target(h)), q = frame.point(frame.source(h));
  CHECK(test("frame with a fold", with_point(frame, last, p + 2.5 * (q - p)), 0.08));

  // touching, exactly: at a vertex, in an edge, in a face
  const Mesh fine = torus(2, 1, 24, 12);
  const auto at = [&](std::size_t v) { return fine.point(Vertex(static_cast<Mesh::size_type>(v))); };
  const std::size_t opposite = 12 * 12;
  CHECK(test("torus that touches a vertex", with_point(fine, 0, at(opposite))));
  CHECK(test("torus that touches an edge", with_point(fine, 0, CGAL::midpoint(at(opposite), at(opposite + 1)))));
  CHECK(test("torus pierced", with_point(fine, 0, Point_3(-4, 0.01, 0.02))));
  return Quartic_test::result();
}
