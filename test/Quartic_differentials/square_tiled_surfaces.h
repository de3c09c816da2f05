// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_SQUARE_TILED_SURFACES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_SQUARE_TILED_SURFACES_H

// Surfaces glued from unit squares: flat metrics with exact quarter turn holonomy, known without any computation.
// Every degeneracy occurs: self-glued triangles, loops, parallel edges, cones of order -3, all trajectories closed.

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace Quartic_test {

namespace QD = CGAL::Quartic_differentials;

/// Side k of square s is side 4s + k; sides run counterclockwise and are glued in pairs, reversing their direction. -1 is
/// a side on the boundary.
using Gluing = std::vector<int>;

struct Square_tiled_surface
{
  QD::Intrinsic_triangulation triangulation;   ///< two triangles a square, all lengths exact to rounding
  std::vector<int>            order;           ///< by vertex: number of squares round it, minus 4, on the boundary minus 2
  std::vector<QD::Vertex>     singularities;   ///< the vertices whose order is not 0
};

inline Gluing random_gluing(int squares, std::mt19937& random)
{
  std::vector<int> sides(4 * squares);
  for (int i = 0; i < 4 * squares; ++i) sides[i] = i;
  for (int i = 4 * squares - 1; i > 0; --i) std::swap(sides[i], sides[random() % (i + 1)]);
  Gluing glued(4 * squares);
  for (int i = 0; i < 4 * squares; i += 2) {
    glued[sides[i]] = sides[i + 1];
    glued[sides[i + 1]] = sides[i];
  }
  return glued;
}

/// right sides are glued to left sides and upper to lower ones: every rotation is 0
inline Gluing random_translation_gluing(int squares, std::mt19937& random)
{
  std::vector<int> right(squares), up(squares);
  for (int i = 0; i < squares; ++i) right[i] = up[i] = i;
  for (int i = squares - 1; i > 0; --i) {
    std::swap(right[i], right[random() % (i + 1)]);
    std::swap(up[i], up[random() % (i + 1)]);
  }
  Gluing glued(4 * squares);
  for (int s = 0; s < squares; ++s) {
    glued[4 * s + 1] = 4 * right[s] + 3;
    glued[4 * right[s] + 3] = 4 * s + 1;
    glued[4 * s + 2] = 4 * up[s];
    glued[4 * up[s]] = 4 * s + 2;
  }
  return glued;
}

/// some pairs of sides, or of sides 0 and 2 only, are not glued any more; returns their number
inline std::size_t cut_open(Gluing& glued, double share, bool horizontal_only, std::mt19937& random)
{
  std::size_t pairs = 0;
  for (std::size_t side = 0; side < glued.size(); side += horizontal_only ? 2 : 1) {
    if (glued[side] < 0 || random() >= share * 4294967296.0) continue;
    glued[glued[side]] = -1;
    glued[side] = -1;
    ++pairs;
  }
  return pairs;
}

inline bool is_connected(const Gluing& glued)
{
  std::vector<char> seen(glued.size() / 4, false);
  std::vector<int> stack{0};
  seen[0] = true;
  std::size_t n = 0;
  while (!stack.empty()) {
    const int s = stack.back();
    stack.pop_back();
    ++n;
    for (int k = 0; k < 4; ++k) {
      const int next = glued[4 * s + k] / 4;
      if (glued[4 * s + k] >= 0 && !seen[next]) { seen[next] = true; stack.push_back(next); }
    }
  }
  return n == seen.size();
}

/// every square becomes m x m squares
inline Gluing subdivided(const Gluing& glued, int m)
{
  const int squares = static_cast<int>(glued.size() / 4);
  // the i-th small square along side `side`, counterclockwise
  const auto along = [&](int side, int i) {
    const int s = side / 4, k = side % 4;
    const int x[4] = {i, m - 1, m - 1 - i, 0}, y[4] = {0, i, m - 1, m - 1 - i};
    return (s * m + y[k]) * m + x[k];
  };
  Gluing result(4 * squares * m * m);
  for (int s = 0; s < squares; ++s)
    for (int y = 0; y < m; ++y)
      for (int x = 0; x < m; ++x) {
        const int small = (s * m + y) * m + x;
        result[4 * small + 0] = 4 * (small - m) + 2;
        result[4 * small + 1] = 4 * (small + 1) + 3;
        result[4 * small + 2] = 4 * (small + m) + 0;
        result[4 * small + 3] = 4 * (small - 1) + 1;
      }
  for (int side = 0; side < 4 * squares; ++side)
    for (int i = 0; i < m; ++i)
      result[4 * along(side, i) + side % 4] = glued[side] < 0 ? -1 : 4 * along(glued[side], m - 1 - i) + glued[side] % 4;
  return result;
}

inline Square_tiled_surface square_tiled_surface(const Gluing& glued)
{
  const int squares = static_cast<int>(glued.size() / 4);
  // side k of square s as an edge of a triangle: (0, 1, 2) has sides 0, 1 and the diagonal; (0, 2, 3) the diagonal, 2, 3
  const auto triangle_edge = [](int side) {
    const int s = side / 4, k = side % 4;
    return k < 2 ? std::array<int, 2>{2 * s, k} : std::array<int, 2>{2 * s + 1, k - 1};
  };
  QD::Glued_triangles glue;
  const double diagonal = std::sqrt(2.0);
  glue.triangles.assign(2 * squares, {-1, -1, -1});
  glue.opposite.resize(2 * squares);
  for (int s = 0; s < squares; ++s) {
    glue.lengths.push_back({1, 1, diagonal});
    glue.lengths.push_back({diagonal, 1, 1});
    glue.opposite[2 * s][2] = {2 * s + 1, 0};
    glue.opposite[2 * s + 1][0] = {2 * s, 2};
  }
  for (int side = 0; side < 4 * squares; ++side) {
    const auto [t, e] = triangle_edge(side);
    if (glued[side] < 0) glue.opposite[t][e] = {-1, -1};
    else                 glue.opposite[t][e] = triangle_edge(glued[side]);
  }
  // round every vertex; corner e of triangle t is where its edge e begins, angles are counted in eighths of a turn
  const int angle[2][3] = {{1, 2, 1}, {1, 1, 2}};
  std::vector<int> eighths, eighths_of_regular;
  for (bool on_boundary : {true, false})   // there a fan begins with an edge of the boundary
    for (int t = 0; t < 2 * squares; ++t)
      for (int e = 0; e < 3; ++e) {
        if (glue.triangles[t][e] >= 0 || (on_boundary && glue.opposite[t][e][0] >= 0)) continue;
        eighths.push_back(0);
        eighths_of_regular.push_back(on_boundary ? 4 : 8);
        for (std::array<int, 2> c{t, e}; c[0] >= 0 && glue.triangles[c[0]][c[1]] < 0;
             c = glue.opposite[c[0]][(c[1] + 2) % 3]) {
          glue.triangles[c[0]][c[1]] = static_cast<int>(eighths.size()) - 1;
          eighths.back() += angle[c[0] % 2][c[1]];
        }
      }
  Square_tiled_surface result;
  result.triangulation = QD::Intrinsic_triangulation(glue);
  for (std::size_t v = 0; v < eighths.size(); ++v) {
    result.order.push_back((eighths[v] - eighths_of_regular[v]) / 2);
    if (result.order[v] != 0) result.singularities.push_back(QD::Vertex(static_cast<QD::Mesh::size_type>(v)));
  }
  return result;
}

/// flips random edges whose quadrilateral is convex
inline void flip_randomly(QD::Intrinsic_triangulation& t, int attempts, std::mt19937& random)
{
  for (int i = 0; i < attempts; ++i) {
    const QD::Edge e(static_cast<QD::Mesh::size_type>(random() % t.number_of_edges()));
    const QD::Halfedge h = t.halfedge(e), o = t.opposite(h);
    if (t.face(h) == t.face(o)) continue;
    const double l = t.length(e), a = t.length(t.next(h)), b = t.length(t.prev(h)), c = t.length(t.next(o)),
                 d = t.length(t.prev(o));
    const double kx = (l * l + b * b - a * a) / (2 * l), ky = QD::four_times_area(l, a, b) / (2 * l);
    const double lx = (l * l + c * c - d * d) / (2 * l), ly = QD::four_times_area(l, c, d) / (2 * l);
    const double crossing = kx + (lx - kx) * ky / (ky + ly);
    if (crossing < 0.01 * l || crossing > 0.99 * l || a > 100 || b > 100) continue;
    t.flip(t.flip_of(e, std::hypot(kx - lx, ky + ly), false));
  }
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_SQUARE_TILED_SURFACES_H
