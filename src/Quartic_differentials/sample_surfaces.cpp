// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double pi = CGAL_PI;

Glued_triangles subdivided(Glued_triangles s, int subdivisions)
{
  for (int i = 0; i < subdivisions; ++i) s = CGAL::Quartic_differentials::subdivided(s);
  return s;
}

} // namespace

Mesh bumpy_sphere(int subdivisions)
{
  CGAL_precondition(subdivisions >= 0);
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point_3(CGAL::ORIGIN), 1.0);
  for (int i = 0; i < subdivisions; ++i) mesh = subdivided(mesh);
  for (Vertex v : mesh.vertices()) {
    const auto n = (mesh.point(v) - CGAL::ORIGIN) / std::sqrt((mesh.point(v) - CGAL::ORIGIN).squared_length());
    const double radius = 1 + 0.12 * std::sin(2 * n.x() + 1) * std::cos(3 * n.y()) + 0.15 * n.z() * n.z() * n.x();
    mesh.point(v) = CGAL::ORIGIN + radius * n;
  }
  return mesh;
}

Mesh torus(double R, double r, int n, int m)
{
  CGAL_precondition(0 < r && r < R && n >= 3 && m >= 3);
  Mesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m, x = R + r * std::cos(v);
      mesh.add_vertex(Point_3(x * std::cos(u), x * std::sin(u), r * std::sin(v)));
    }
  const auto vertex = [&](int i, int j) { return Vertex((i % n) * m + j % m); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

Glued_triangles hyperelliptic(int g, int subdivisions)
{
  CGAL_precondition(g >= 1 && subdivisions >= 0);
  const int n = 2 * g + 2;
  const double radius = 1 / (2 * std::sin(pi / n));
  // polygon 2*sheet + (0 for front, 1 for back) has the triangles n*polygon + k on its side k;
  // the corners are the vertices 0..n-1, the centres n..n+3. Backs are seen from outside, so they run backwards.
  Glued_triangles s;
  for (int sheet = 0; sheet < 2; ++sheet) {
    const int front = n * (2 * sheet), back = n * (2 * sheet + 1);
    const int other_front = n * (2 * (1 - sheet)), other_back = n * (2 * (1 - sheet) + 1);
    for (int k = 0; k < n; ++k) {
      const int next = (k + 1) % n, previous = (k + n - 1) % n;
      s.triangles.push_back({n + 2 * sheet, k, next});
      s.opposite.push_back({{{front + previous, 2}, {(k % 2 == 0 ? back : other_back) + k, 1}, {front + next, 0}}});
      s.lengths.push_back({radius, 1, radius});
    }
    for (int k = 0; k < n; ++k) {
      const int next = (k + 1) % n, previous = (k + n - 1) % n;
      s.triangles.push_back({n + 2 * sheet + 1, next, k});
      s.opposite.push_back({{{back + next, 2}, {(k % 2 == 0 ? front : other_front) + k, 1}, {back + previous, 0}}});
      s.lengths.push_back({radius, 1, radius});
    }
  }
  return subdivided(std::move(s), subdivisions);
}

Glued_triangles regular_polygon(int g, int subdivisions)
{
  CGAL_precondition(g >= 1 && subdivisions >= 0);
  const int n = 4 * g;
  const double radius = 1 / (2 * std::sin(pi / n));
  Glued_triangles s;
  for (int k = 0; k < n; ++k) {
    s.triangles.push_back({1, 0, 0});   // the centre, and the corners, which are all one point
    s.opposite.push_back({{{(k + n - 1) % n, 2}, {(k + n / 2) % n, 1}, {(k + 1) % n, 0}}});
    s.lengths.push_back({radius, 1, radius});
  }
  return subdivided(std::move(s), subdivisions);
}

Glued_triangles l_of_three_squares(int subdivisions)
{
  CGAL_precondition(subdivisions >= 0);
  const int beside[3] = {1, 0, 2}, above[3] = {2, 1, 0};   // to the left as to the right, and below as above
  const double diagonal = std::sqrt(2.0);
  Glued_triangles s;
  for (int k = 0; k < 3; ++k) {
    s.opposite.push_back({{{2 * above[k] + 1, 1}, {2 * beside[k] + 1, 2}, {2 * k + 1, 0}}});
    s.opposite.push_back({{{2 * k, 2}, {2 * above[k], 0}, {2 * beside[k], 1}}});
    s.lengths.push_back({1, 1, diagonal});
    s.lengths.push_back({diagonal, 1, 1});
  }
  s.triangles.assign(6, {0, 0, 0});
  return subdivided(std::move(s), subdivisions);
}

Glued_triangles subdivided(const Glued_triangles& s)
{
  const int n = static_cast<int>(s.triangles.size());
  int vertices = 0;
  for (const auto& t : s.triangles)
    for (int v : t) vertices = std::max(vertices, v + 1);

  std::vector<std::array<int, 3>> middle(n);   // the vertex in the middle of each edge
  for (int t = 0; t < n; ++t)
    for (int e = 0; e < 3; ++e) {
      const auto [u, f] = s.opposite[t][e];
      const bool first = u < 0 || u > t || (u == t && f > e);
      middle[t][e] = first ? vertices++ : middle[u][f];
    }

  Glued_triangles fine;
  for (int t = 0; t < n; ++t) {
    const auto& v = s.triangles[t];
    const auto& l = s.lengths[t];
    const auto& m = middle[t];
    // the first half of edge e meets the second half of the edge (u, f) it is glued to, and conversely
    const auto across_first_half = [&](int e) -> std::array<int, 2> {
      const auto [u, f] = s.opposite[t][e];
      if (u < 0) return {-1, -1};
      return {4 * u + (f + 1) % 3, 2};
    };
    const auto across_second_half = [&](int e) -> std::array<int, 2> {
      const auto [u, f] = s.opposite[t][e];
      if (u < 0) return {-1, -1};
      return {4 * u + f, 0};
    };
    for (int c = 0; c < 3; ++c) {
      const int after = (c + 1) % 3, before = (c + 2) % 3;
      fine.triangles.push_back({v[c], m[c], m[before]});
      fine.opposite.push_back({across_first_half(c), {4 * t + 3, before}, across_second_half(before)});
      fine.lengths.push_back({l[c] / 2, l[after] / 2, l[before] / 2});
    }
    fine.triangles.push_back({m[0], m[1], m[2]});
    fine.opposite.push_back({{{4 * t + 1, 1}, {4 * t + 2, 1}, {4 * t, 1}}});
    fine.lengths.push_back({l[2] / 2, l[0] / 2, l[1] / 2});
  }
  return fine;
}

Mesh subdivided(const Mesh& mesh)
{
  Mesh fine;
  fine.reserve(mesh.number_of_vertices() + mesh.number_of_edges(), 2 * mesh.number_of_edges()
               + 3 * mesh.number_of_faces(), 4 * mesh.number_of_faces());
  for (Vertex v : mesh.vertices()) fine.add_vertex(mesh.point(v));
  for (Edge e : mesh.edges()) fine.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const auto middle = [&](Halfedge h) {
    return Vertex(static_cast<Mesh::size_type>(mesh.number_of_vertices() + mesh.edge(h).idx()));
  };
  for (Face f : mesh.faces()) {
    const Halfedge h0 = mesh.halfedge(f), h1 = mesh.next(h0), h2 = mesh.next(h1);
    for (Halfedge h : {h0, h1, h2}) fine.add_face(mesh.source(h), middle(h), middle(mesh.prev(h)));
    fine.add_face(middle(h0), middle(h1), middle(h2));
  }
  return fine;
}

} } // namespace CGAL::Quartic_differentials
