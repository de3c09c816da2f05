// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_PLATES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_PLATES_H

// Flat plates with straight and curved boundary for the tests.

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Quartic_test {

using namespace CGAL::Quartic_differentials;

using Polygon = std::vector<std::complex<double>>;   // counterclockwise

inline Point_3 in_space(std::complex<double> z, double height = 0) { return Point_3(z.real(), z.imag(), height); }

/// squares [i, i+1] x [j, j+1] for which `is_in(i, j)`, of nx x ny, every one cut along a diagonal
inline Mesh plate_of_squares(int nx, int ny, const std::function<bool(int, int)>& is_in)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Vertex> known;
  const auto vertex = [&](int i, int j) {
    const auto [at, is_new] = known.emplace(std::make_pair(i, j), Vertex());
    if (is_new) at->second = mesh.add_vertex(Point_3(i, j, 0));
    return at->second;
  };
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      if (!is_in(i, j)) continue;
      const Vertex a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      if ((i + j) % 2) { mesh.add_face(a, b, c); mesh.add_face(a, c, d); }
      else             { mesh.add_face(a, b, d); mesh.add_face(b, c, d); }
    }
  return mesh;
}

/// an L of 12 x 12 squares without a quarter, with a hole of 2 x 2: five corners with one quad, and five with three
inline Mesh l_with_hole()
{
  return plate_of_squares(12, 12, [](int i, int j) {
    return !(i >= 6 && j >= 6) && !(i >= 2 && i < 4 && j >= 2 && j < 4);
  });
}

/// the strip between two closed polygons of as many corners, cut into `rings` rings
inline Mesh ring_between(const Polygon& inner, const Polygon& outer, int rings)
{
  Mesh mesh;
  const std::size_t n = inner.size();
  for (int r = 0; r <= rings; ++r)
    for (std::size_t k = 0; k < n; ++k) {
      const double t = static_cast<double>(r) / rings;
      mesh.add_vertex(in_space((1 - t) * inner[k] + t * outer[k]));
    }
  const auto vertex = [&](int r, std::size_t k) { return Vertex(static_cast<Mesh::size_type>(r * n + k % n)); };
  for (int r = 0; r < rings; ++r)
    for (std::size_t k = 0; k < n; ++k) {
      mesh.add_face(vertex(r, k), vertex(r + 1, k), vertex(r + 1, k + 1));
      mesh.add_face(vertex(r, k), vertex(r + 1, k + 1), vertex(r, k + 1));
    }
  return mesh;
}

/// the inside of a polygon that can be seen from the origin, in `rings` rings
inline Mesh star_shaped(const Polygon& rim, int rings)
{
  Polygon inner;
  for (std::complex<double> z : rim) inner.push_back(z / static_cast<double>(rings));
  Mesh mesh = ring_between(inner, rim, rings - 1);
  const Vertex centre = mesh.add_vertex(Point_3(0, 0, 0));
  const Mesh::size_type n = static_cast<Mesh::size_type>(rim.size());
  for (Mesh::size_type k = 0; k < n; ++k) mesh.add_face(centre, Vertex(k), Vertex((k + 1) % n));
  return mesh;
}

/// a sector of a disk of radius 1 with the given angle at its tip, vertex 0; it may be more than a full turn
inline Mesh sector(double angle, int rings, int steps)
{
  Mesh mesh;
  mesh.add_vertex(Point_3(0, 0, 0));
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k <= steps; ++k)
      mesh.add_vertex(in_space(std::polar(static_cast<double>(r) / rings, angle * k / steps),
                               1e-3 * k * r / (steps * rings)));
  const auto vertex = [&](int r, int k) { return Vertex(static_cast<Mesh::size_type>(1 + (r - 1) * (steps + 1) + k)); };
  for (int k = 0; k < steps; ++k) {
    mesh.add_face(Vertex(0), vertex(1, k), vertex(1, k + 1));
    for (int r = 1; r < rings; ++r) {
      mesh.add_face(vertex(r, k), vertex(r + 1, k), vertex(r + 1, k + 1));
      mesh.add_face(vertex(r, k), vertex(r + 1, k + 1), vertex(r, k + 1));
    }
  }
  return mesh;
}

/// `n` points on the rim of a rectangle of half width a and half height b, evenly on every side, whose corners are
/// rounded to arcs of the given radius
inline Polygon rectangle(double a, double b, double radius, int n)
{
  Polygon rim;
  const double w = a - radius, h = b - radius, quarter = 0.5 * CGAL_PI;
  const auto line = [&](std::complex<double> from, std::complex<double> to, int steps) {
    for (int k = 0; k < steps; ++k) rim.push_back(from + (to - from) * (static_cast<double>(k) / steps));
  };
  const auto arc = [&](std::complex<double> centre, double from) {
    for (int k = 0; radius > 0 && k < 8; ++k) rim.push_back(centre + std::polar(radius, from + quarter * k / 8));
  };
  line({a, -h}, {a, h}, n / 4);
  arc({w, h}, 0);
  line({w, b}, {-w, b}, n / 4);
  arc({-w, h}, quarter);
  line({-a, h}, {-a, -h}, n / 4);
  arc({-w, -h}, 2 * quarter);
  line({-w, -b}, {w, -b}, n / 4);
  arc({w, -h}, 3 * quarter);
  return rim;
}

/// `n` points at the distance radius(k) from the origin
inline Polygon circle(int n, const std::function<double(int)>& radius)
{
  Polygon rim;
  for (int k = 0; k < n; ++k) rim.push_back(std::polar(radius(k), 2 * CGAL_PI * k / n));
  return rim;
}

/// a square plate of side 2 with a square hole of side 0.8 that is turned against it
inline Mesh plate_with_turned_hole(double turn, int n, int rings)
{
  Polygon hole = rectangle(0.4, 0.4, 0, n);
  for (std::complex<double>& z : hole) z *= std::polar(1.0, turn);
  return ring_between(hole, rectangle(1, 1, 0, n), rings);
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_PLATES_H
