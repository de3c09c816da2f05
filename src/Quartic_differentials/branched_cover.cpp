// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/branched_cover.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double pi = CGAL_PI;

const double grading = 3;              // ring i of n has the radius R (i/n)^grading
const double least_distance = 1e-3;    // of two given points

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

std::vector<Point_3> places_on_sphere(const std::vector<std::complex<double>>& points)
{
  std::vector<Point_3> places;
  for (const std::complex<double>& x : points) {
    if (std::isnan(x.real()) || std::isnan(x.imag()))
      throw Error("point " + std::to_string(places.size()) + " is not a number");
    places.push_back(on_sphere(x));
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
      if (distance(places[k], places.back()) < least_distance)
        throw Error("the points " + std::to_string(k) + " and " + std::to_string(places.size() - 1) +
                    " are the same, or too near each other on the sphere");
  }
  return places;
}

// The radius of the rings round place k: those of two places do not meet.
double radius_of_rings(const std::vector<Point_3>& places, std::size_t k)
{
  double nearest = 1.5;
  for (std::size_t l = 0; l < places.size(); ++l)
    if (l != k) nearest = std::min(nearest, distance(places[k], places[l]));
  return 0.4 * nearest;
}

// Rings round p, 2i+2 points on ring i: triangles are nearly isotropic, and half a turn about p takes the points to
// themselves.
void add_rings(std::vector<Point_3>& points, const Point_3& p, double radius, double h)
{
  const Vector_3 up = p - CGAL::ORIGIN;
  const Vector_3 axis = std::abs(up.x()) < 0.6 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0);
  const Vector_3 u = unit(CGAL::cross_product(up, axis)), v = CGAL::cross_product(up, u);
  const int n = std::max(3, static_cast<int>(std::ceil(grading * radius / h)));
  for (int i = 1; i <= n; ++i) {
    const double r = radius * std::pow(i / static_cast<double>(n), grading);
    for (int j = 0; j < 2 * i + 2; ++j) {
      const double angle = 2 * pi * j / (2 * i + 2);
      points.push_back(CGAL::ORIGIN
                       + unit(std::cos(r) * up + std::sin(r) * (std::cos(angle) * u + std::sin(angle) * v)));
    }
  }
}

// Evenly spread points on a spiral, outside the rings.
void add_spiral(std::vector<Point_3>& points, const std::vector<Point_3>& places, const std::vector<double>& radii,
                double h)
{
  const int n = static_cast<int>(std::ceil(8 * pi / (std::sqrt(3.0) * h * h)));   // 2n equilateral triangles of side h
  const double golden_angle = pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1) / static_cast<double>(n), r = std::sqrt(1 - z * z);
    const Point_3 p(r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z);
    bool outside = true;
    for (std::size_t k = 0; k < places.size() && outside; ++k)
      outside = distance(p, places[k]) > radii[k] + 0.6 * std::min(h, 2 * radii[k]);
    if (outside) points.push_back(p);
  }
}

// The convex hull with vertex k at points[k].
Mesh convex_hull(const std::vector<Point_3>& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> input;
  std::map<Kernel::Point_3, Vertex> vertex;
  Mesh mesh;
  for (const Point_3& p : points) {
    input.emplace_back(p.x(), p.y(), p.z());
    vertex[input.back()] = mesh.add_vertex(p);
  }
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  if (hull.number_of_vertices() != points.size())
    throw Error("the points are too near each other: rounding hides one of them inside the convex hull");
  for (const auto f : hull.faces()) {
    const auto h = hull.halfedge(f);
    mesh.add_face(vertex.at(hull.point(hull.source(h))), vertex.at(hull.point(hull.target(h))),
                  vertex.at(hull.point(hull.target(hull.next(h)))));
  }
  return mesh;
}

void check_branch_vertices(std::vector<Vertex> vertices)
{
  if (vertices.size() < 2 || vertices.size() % 2 != 0)
    throw Error("a two-sheeted cover has an even number of branch points, at least two, but " +
                std::to_string(vertices.size()) + (vertices.size() == 1 ? " was given" : " were given"));
  std::sort(vertices.begin(), vertices.end());
  if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end())
    throw Error("two branch points are the same");
}

// By edge, whether the sheets change places across it: a set of edges with exactly the branch vertices as its boundary
// modulo 2. In a spanning tree it is unique: the edges that cut off an odd number of them.
std::vector<char> sheet_changes(const Mesh& sphere, const std::vector<Vertex>& branch_vertices)
{
  std::vector<char> odd(sphere.number_of_vertices(), false), seen(odd), change(sphere.number_of_edges(), false);
  for (Vertex v : branch_vertices) odd[v] = true;
  std::vector<Halfedge> tree;   // breadth first, away from the root
  std::vector<Vertex> order{branch_vertices.front()};
  seen[order.front()] = true;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (Halfedge into : sphere.halfedges_around_target(sphere.halfedge(order[i]))) {
      const Halfedge h = sphere.opposite(into);
      if (seen[sphere.target(h)]) continue;
      seen[sphere.target(h)] = true;
      order.push_back(sphere.target(h));
      tree.push_back(h);
    }
  for (auto h = tree.rbegin(); h != tree.rend(); ++h) {
    if (!odd[sphere.target(*h)]) continue;
    change[sphere.edge(*h)] = true;
    odd[sphere.source(*h)] = !odd[sphere.source(*h)];
  }
  return change;
}

int corner(const Mesh& mesh, Halfedge h)   // of its face, at its source
{
  const Halfedge h0 = mesh.halfedge(mesh.face(h));
  return h == h0 ? 0 : h == mesh.next(h0) ? 1 : 2;
}

// Triangles, gluing and lengths; triangle f + (number of faces) * sheet lies over the face f.
void glue_sheets(Glued_triangles& cover, const Mesh& sphere, const std::vector<char>& change)
{
  const int faces = static_cast<int>(sphere.number_of_faces());
  cover.opposite.resize(2 * faces);
  cover.lengths.resize(2 * faces);
  for (Halfedge h : sphere.halfedges()) {
    const Halfedge o = sphere.opposite(h);
    const int f = static_cast<int>(sphere.face(h)), e = corner(sphere, h);
    for (int sheet = 0; sheet < 2; ++sheet) {
      const int other_sheet = change[sphere.edge(h)] ? 1 - sheet : sheet;
      const int across = static_cast<int>(sphere.face(o)) + faces * other_sheet;
      cover.opposite[f + faces * sheet][e] = {across, corner(sphere, o)};
      cover.lengths[f + faces * sheet][e] = distance(sphere.point(sphere.source(h)), sphere.point(sphere.target(h)));
    }
  }
}

// Round every vertex, from sheet 0: at a branch vertex the walk ends in the other sheet, and both lifts are the same.
void number_vertices(Glued_triangles& cover, const Mesh& sphere, const std::vector<char>& change)
{
  const int faces = static_cast<int>(sphere.number_of_faces());
  int vertices = static_cast<int>(sphere.number_of_vertices());
  cover.triangles.resize(2 * faces);
  for (Vertex v : sphere.vertices()) {
    const Halfedge start = sphere.opposite(sphere.halfedge(v));
    std::vector<std::array<int, 3>> corners;   // {face, sheet, corner} of the lift
    int sheet = 0;
    Halfedge h = start;
    do {
      corners.push_back({static_cast<int>(sphere.face(h)), sheet, corner(sphere, h)});
      if (change[sphere.edge(sphere.prev(h))]) sheet = 1 - sheet;
      h = sphere.opposite(sphere.prev(h));
    } while (h != start);
    const int second = sheet == 1 ? static_cast<int>(v) : vertices++;
    for (const auto& [f, s, c] : corners) {
      cover.triangles[f + faces * s][c] = static_cast<int>(v);
      cover.triangles[f + faces * (1 - s)][c] = second;
    }
  }
}

} // namespace

Point_3 on_sphere(const std::complex<double>& x)
{
  if (std::isinf(x.real()) || std::isinf(x.imag())) return Point_3(0, 0, -1);
  const double scale = std::max(1.0, std::abs(x));   // so that no square overflows
  const std::complex<double> y = x / scale;
  const double one = 1 / scale, norm = one * one + std::norm(y);
  return Point_3(2 * y.real() * one / norm, 2 * y.imag() * one / norm, (one * one - std::norm(y)) / norm);
}

Mesh triangulated_sphere(const std::vector<std::complex<double>>& points, int level)
{
  CGAL_precondition(0 <= level && level <= 6);
  const double h = std::ldexp(0.4, -level);
  const std::vector<Point_3> places = places_on_sphere(points);
  std::vector<Point_3> vertices = places;
  std::vector<double> radii;
  for (std::size_t k = 0; k < places.size(); ++k) {
    radii.push_back(radius_of_rings(places, k));
    add_rings(vertices, places[k], radii[k], h);
  }
  add_spiral(vertices, places, radii, h);
  return convex_hull(vertices);
}

Glued_triangles branched_cover(const Mesh& sphere, const std::vector<Vertex>& branch_vertices)
{
  check_branch_vertices(branch_vertices);
  const std::vector<char> change = sheet_changes(sphere, branch_vertices);
  Glued_triangles cover;
  glue_sheets(cover, sphere, change);
  number_vertices(cover, sphere, change);
  return cover;
}

Glued_triangles branched_cover(const std::vector<std::complex<double>>& branch_points, int level)
{
  std::vector<Vertex> vertices;
  for (std::size_t k = 0; k < branch_points.size(); ++k) vertices.emplace_back(static_cast<Mesh::size_type>(k));
  check_branch_vertices(vertices);
  return branched_cover(triangulated_sphere(branch_points, level), vertices);
}

} } // namespace CGAL::Quartic_differentials
