// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/spoiled_surfaces.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

// uniform in [a, b), the same numbers with every standard library
double uniform(std::mt19937& random, double a, double b) { return a + (b - a) * (random() / 4294967296.0); }

} // namespace

Mesh stretched(Mesh mesh, double factor)
{
  for (Vertex v : mesh.vertices()) mesh.point(v) = Point_3(factor * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  return mesh;
}

Mesh noisy(Mesh mesh, double part, unsigned seed)
{
  std::mt19937 random(seed);
  double mean = 0;
  for (auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    mean += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }
  const double r = part * mean / static_cast<double>(mesh.number_of_edges());
  for (Vertex v : mesh.vertices()) {
    const Point_3 p = mesh.point(v);
    mesh.point(v) = Point_3(p.x() + uniform(random, -r, r), p.y() + uniform(random, -r, r), p.z() + uniform(random, -r, r));
  }
  return mesh;
}

Mesh with_slivers(Mesh mesh, double height, unsigned seed)
{
  std::mt19937 random(seed);
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for (const auto f : faces) {
    if (random() % 5 != 0) continue;
    const auto h = mesh.halfedge(f);
    const Point_3 a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h)), c = mesh.point(mesh.target(mesh.next(h)));
    const Point_3 on_edge = a + uniform(random, 0.2, 0.8) * (b - a);
    const auto in = CGAL::Euler::add_center_vertex(h, mesh);
    mesh.point(mesh.target(in)) = on_edge + height * (c - on_edge);
  }
  return mesh;
}

Mesh with_obtuse_boundary(Mesh mesh, double degrees, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Mesh::Halfedge_index> inside;   // of the boundary edges
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(mesh.opposite(h))) inside.push_back(h);
  for (const auto h : inside) {
    const Point_3 a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h));
    const Point_3 c = mesh.point(mesh.target(mesh.next(h)));
    const auto half = (b - a) / 2, d = c - (a + half);
    const double d2 = d.squared_length(), e2 = half.squared_length(), across = std::sqrt(d2 - (d * half) * (d * half) / e2);
    // on the median, and on the circle of this inscribed angle over ab, whose centre is `below` the edge
    const double below = std::sqrt(e2) / std::tan(CGAL_PI * (1 - uniform(random, 95, degrees) / 180));
    const double part = (std::hypot(below * across, std::sqrt(d2 * e2)) - below * across) / d2;
    const auto in = CGAL::Euler::add_center_vertex(h, mesh);
    mesh.point(mesh.target(in)) = a + half + std::min(part, 0.5) * d;   // c may be obtuse itself
  }
  return mesh;
}

Mesh with_hub(const Mesh& mesh, int n)
{
  Mesh result;
  for (Vertex v : mesh.vertices()) result.add_vertex(mesh.point(v));
  const Mesh::Face_index split(static_cast<Mesh::size_type>(mesh.number_of_faces() / 2));
  std::array<Vertex, 3> corner;
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const std::array<Vertex, 3> v{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    if (f == split) corner = v;
    else result.add_face(v[0], v[1], v[2]);
  }
  const auto p = [&](int k) { return mesh.point(corner[k % 3]); };
  const Point_3 centre = CGAL::centroid(p(0), p(1), p(2));
  std::vector<Vertex> rim;
  for (int i = 0; i < n; ++i) {
    const int side = 3 * i / n;
    const Point_3 outer = p(side) + (3.0 * i / n - side) * (p(side + 1) - p(side));
    rim.push_back(result.add_vertex(centre + 0.5 * (outer - centre)));
  }
  const Vertex hub = result.add_vertex(centre);
  for (int i = 0; i < n; ++i) {
    const Vertex next = rim[(i + 1) % n];
    const int side = 3 * i / n;
    result.add_face(rim[i], next, hub);
    result.add_face(corner[side], next, rim[i]);
    if (i + 1 == n || 3 * (i + 1) / n != side) result.add_face(corner[side], corner[(side + 1) % 3], next);
  }
  return result;
}

} } // namespace CGAL::Quartic_differentials
