// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACES_H

// Small closed surfaces with poor triangles, the same on every run.

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace Quartic_test {

using CGAL::Quartic_differentials::Mesh;
using CGAL::Quartic_differentials::Point_3;
using CGAL::Quartic_differentials::Vertex;

/// uniform in [a, b), the same numbers with every standard library
inline double uniform(std::mt19937& random, double a, double b)
{
  return a + (b - a) * (random() / 4294967296.0);
}

/// A torus of revolution from an m x n grid. `jitter` moves the vertices along the surface, by at most that part of a
/// grid cell; `twist` shears the grid by that many cells over each step, so that triangles get long; every cell is cut
/// along a random diagonal.
inline Mesh jittered_torus(int m, int n, double jitter, double twist, unsigned seed)
{
  const double two_pi = 6.283185307179586;
  std::mt19937 random(seed);
  Mesh mesh;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = two_pi * (i + uniform(random, -jitter, jitter)) / m;
      const double v = two_pi * (j + i * twist + uniform(random, -jitter, jitter)) / n;
      const double r = 1 + 0.4 * std::cos(v);
      mesh.add_vertex(Point_3(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)));
    }
  // after m steps the shear has moved by m * twist cells, which must be whole
  const int shift = static_cast<int>(std::lround(m * twist));
  const auto vertex = [&](int i, int j) {
    if (i == m) { i = 0; j += shift; }
    return Vertex(static_cast<Mesh::size_type>(i * n + ((j % n) + n) % n));
  };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const Vertex a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      if (random() % 2) { mesh.add_face(a, b, c); mesh.add_face(a, c, d); }
      else              { mesh.add_face(a, b, d); mesh.add_face(b, c, d); }
    }
  return mesh;
}

/// An octahedron subdivided `levels` times, jittered, on the ellipsoid with axes 1, 1, `stretch`.
inline Mesh jittered_sphere(int levels, double jitter, double stretch, unsigned seed)
{
  using Direction = std::array<double, 3>;
  std::vector<Direction> points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < 4; ++k) {
    triangles.push_back({k, (k + 1) % 4, 4});
    triangles.push_back({(k + 1) % 4, k, 5});
  }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto midpoint = [&](int a, int b) {
      const auto [it, is_new] = middle.insert({std::minmax(a, b), static_cast<int>(points.size())});
      if (is_new) {
        const Direction p = points[a], q = points[b];
        points.push_back({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
      }
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
    for (Direction& p : points) {
      const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      for (double& x : p) x /= r;
    }
  }
  std::mt19937 random(seed);
  Mesh mesh;
  for (Direction p : points) {
    for (double& x : p) x += uniform(random, -jitter, jitter) * std::ldexp(1.0, -levels);
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    mesh.add_vertex(Point_3(p[0] / r, p[1] / r, stretch * p[2] / r));
  }
  for (const auto& [a, b, c] : triangles) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  return mesh;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACES_H
