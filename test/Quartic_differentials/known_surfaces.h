// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_KNOWN_SURFACES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_KNOWN_SURFACES_H

// Triangulated surfaces whose periods are known, with the cycles they are known for as walks along edges.
//   K   2g x 2g  intersection numbers of the cycles
//   P   2g x g   periods of any g independent holomorphic forms over them

#include "hyperelliptic_periods.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/branched_cover.h>
#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/intersection_number.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace Quartic_test {

namespace QD = CGAL::Quartic_differentials;

using Walk = std::vector<QD::Halfedge>;

/// an edge of a triangle, with the triangle on its left
using Side = std::array<int, 2>;

/// a closed walk along edges: forth along some, and back along others between the same vertices
struct Cycle
{
  std::vector<Side> forth, back;
};

struct Known_gluing
{
  QD::Glued_triangles triangles;
  std::vector<Cycle>  cycles;
  Eigen::MatrixXi     intersections;   ///< K
  Eigen::MatrixXcd    periods;         ///< P
};

struct Known_surface
{
  QD::Intrinsic_triangulation surface;
  std::vector<Walk>           cycles;          ///< closed walks along edges
  Eigen::MatrixXi             intersections;   ///< K
  Eigen::MatrixXcd            periods;         ///< P
};

/// the walk along sides of triangles that were `subdivided()` since
inline Walk walk_along(const QD::Intrinsic_triangulation& t, std::vector<Side> sides, int subdivisions)
{
  for (int i = 0; i < subdivisions; ++i) {
    std::vector<Side> halves;
    for (const auto& [f, e] : sides) {
      halves.push_back({4 * f + e, 0});
      halves.push_back({4 * f + (e + 1) % 3, 2});
    }
    sides = std::move(halves);
  }
  Walk walk;
  for (const auto& [f, e] : sides) walk.push_back(t.halfedges(QD::Face(static_cast<QD::Mesh::size_type>(f)))[e]);
  return walk;
}

inline Walk walk_along(const QD::Intrinsic_triangulation& t, const Cycle& cycle, int subdivisions)
{
  Walk walk = walk_along(t, cycle.forth, subdivisions);
  const Walk back = walk_along(t, cycle.back, subdivisions);
  for (auto h = back.rbegin(); h != back.rend(); ++h) walk.push_back(t.opposite(*h));
  return walk;
}

/// the surface with all triangles `subdivided()` as often as asked
inline Known_surface known_surface(const Known_gluing& known, int subdivisions)
{
  QD::Glued_triangles fine = known.triangles;
  for (int i = 0; i < subdivisions; ++i) fine = QD::subdivided(fine);
  Known_surface result{QD::Intrinsic_triangulation(fine), {}, known.intersections, known.periods};
  for (const Cycle& cycle : known.cycles) result.cycles.push_back(walk_along(result.surface, cycle, subdivisions));
  return result;
}

/// the same surface with every triangle split into three at a random point, so that it has no symmetries: edge e of
/// triangle t becomes edge 0 of triangle 3t + e
inline Known_gluing split_at_random(Known_gluing known)
{
  std::mt19937 random(5);
  QD::Glued_triangles split;
  int vertices = 0;
  for (const auto& t : known.triangles.triangles)
    for (int v : t) vertices = std::max(vertices, v + 1);
  for (std::size_t t = 0; t < known.triangles.triangles.size(); ++t, ++vertices) {
    const auto& [a, b, c] = known.triangles.lengths[t];
    const Complex third((a * a + c * c - b * b) / (2 * a), QD::four_times_area(a, b, c) / (2 * a));
    const Complex corner[3] = {0, a, third};
    const double x = uniform(random, 0.2, 0.4), y = uniform(random, 0.2, 0.4);
    const Complex p = (1 - x - y) * corner[0] + x * corner[1] + y * corner[2];
    const int first = 3 * static_cast<int>(t);
    for (int e = 0; e < 3; ++e) {
      const int after = (e + 1) % 3, before = (e + 2) % 3;
      const auto [u, f] = known.triangles.opposite[t][e];
      split.triangles.push_back({known.triangles.triangles[t][e], known.triangles.triangles[t][after], vertices});
      split.opposite.push_back({{{3 * u + f, 0}, {first + after, 2}, {first + before, 1}}});
      split.lengths.push_back({known.triangles.lengths[t][e], std::abs(p - corner[after]), std::abs(p - corner[e])});
    }
  }
  known.triangles = std::move(split);
  for (Cycle& cycle : known.cycles)
    for (std::vector<Side>* sides : {&cycle.forth, &cycle.back})
      for (Side& s : *sides) s = {3 * s[0] + s[1], 0};
  return known;
}

// Surfaces with exact geometry

/// y^2 = x^(2g+2) - 1; gamma_k runs over side k of the front polygon of one sheet, and back in the other
inline Known_gluing known_hyperelliptic(int g)
{
  Known_gluing known{QD::hyperelliptic(g, 0), {}, chain_intersections(2 * g), roots_of_unity_chain(g)};
  const int other_sheet = 2 * (2 * g + 2);   // after the front and the back of the first
  for (int k = 0; k < 2 * g; ++k) known.cycles.push_back({{{k, 1}}, {{other_sheet + k, 1}}});
  return known;
}

/// y^2 = x (x^(2g) - 1); the cycles are sides 0 .. 2g-1 of the polygon. The turn by pi/(2g) is an automorphism, takes a
/// side to the next and multiplies x^j dx/y by exp(i pi (2j+1) / (2g)). The curves d_k from the middle of the opposite
/// side through the centre to that of side k meet once, d_k . d_l = 1 for k < l, and d_k . side_l = delta_kl: so the
/// sides have the inverse transpose of this matrix.
inline Known_gluing known_regular_polygon(int g)
{
  const int n = 2 * g;
  Known_gluing known{QD::regular_polygon(g, 0), {}, {}, Eigen::MatrixXcd(n, g)};
  Eigen::MatrixXd d(n, n);
  for (int k = 0; k < n; ++k) {
    known.cycles.push_back({{{k, 1}}, {}});
    for (int l = 0; l < n; ++l) d(k, l) = (k < l) - (l < k);
    for (int j = 0; j < g; ++j) known.periods(k, j) = std::polar(1.0, std::acos(-1.0) * k * (2 * j + 1) / n);
  }
  known.intersections = d.inverse().transpose().array().round().matrix().cast<int>();
  return known;
}

/// L of three squares: a = (lower side of the upper square, lower side of the right square), b = (left sides of the
/// lower and the upper square, left side of the right square). Reflections in the axes make Pi = iY; dz has the
/// periods (1, 1) and (2i, i); the reflection in the diagonal, which takes (a_1, a_2, b_1, b_2) to (b_2, b_1 - b_2,
/// a_1 + a_2, a_1), makes det Y = 1: together, Y = [5 1; 1 2] / 3.
inline Known_gluing known_l_of_three_squares()
{
  Known_gluing known{QD::l_of_three_squares(0), {}, QD::symplectic_unit(2), Eigen::MatrixXcd(4, 2)};
  known.cycles = {{{{4, 0}}, {}}, {{{2, 0}}, {}}, {{}, {{5, 2}, {1, 2}}}, {{}, {{3, 2}}}};   // left sides run down
  const Complex i(0, 1);
  known.periods << 1, 0, 0, 1, 5.0 / 3 * i, 1.0 / 3 * i, 1.0 / 3 * i, 2.0 / 3 * i;
  return known;
}

// Surfaces that tend to a Riemann surface

/// the torus of revolution with R = 1 and radius r; cycles round the axis and round the circle. In the conformal
/// coordinate u + i w with dw = r dv / (R + r cos v) they have the periods 2 pi and 2 pi i r / sqrt(R^2 - r^2).
inline Known_surface known_torus(double r, int level)
{
  const int n = 16 << level, m = 10 << level;
  Known_surface known{QD::Intrinsic_triangulation(QD::torus(1, r, n, m)), {}, QD::symplectic_unit(1),
                      Eigen::MatrixXcd(2, 1)};
  const auto step = [&](int from, int to) {
    return known.surface.mesh().halfedge(QD::Vertex(from), QD::Vertex(to));
  };
  known.cycles.resize(2);
  for (int i = 0; i < n; ++i) known.cycles[0].push_back(step(i * m, (i + 1) % n * m));
  for (int j = 0; j < m; ++j) known.cycles[1].push_back(step(j, (j + 1) % m));
  known.periods << 1, Complex(0, r / std::sqrt(1 - r * r));
  return known;
}

/// the walk on the sphere between branch vertices k and k+1 that stays nearest to the segment between their
/// coordinates, and meets no other branch vertex: the shortest path if every vertex costs its distance from the
/// segment.
inline Walk walk_near_segment(const QD::Mesh& sphere, const std::vector<Complex>& points, std::size_t k)
{
  const Complex from = points[k], along = points[k + 1] - from;
  const auto distance = [&](QD::Vertex v) {   // on the sphere, to the nearest point in the plane
    const QD::Point_3& p = sphere.point(v);
    const Complex x = Complex(p.x(), p.y()) / std::max(1 + p.z(), 1e-9);
    const double s = std::clamp((std::conj(along) * (x - from)).real() / std::norm(along), 0.0, 1.0);
    return std::sqrt(CGAL::squared_distance(p, QD::on_sphere(from + s * along)));
  };
  const QD::Vertex start(static_cast<QD::Mesh::size_type>(k)), end(static_cast<QD::Mesh::size_type>(k + 1));
  std::vector<double> cost(sphere.number_of_vertices(), std::numeric_limits<double>::infinity());
  std::vector<QD::Halfedge> into(sphere.number_of_vertices());
  std::priority_queue<std::pair<double, QD::Vertex>, std::vector<std::pair<double, QD::Vertex>>, std::greater<>> queue;
  cost[start] = 0;
  queue.push({0, start});
  while (!queue.empty() && queue.top().second != end) {
    const auto [c, v] = queue.top();
    queue.pop();
    if (c > cost[v]) continue;
    for (QD::Halfedge back : sphere.halfedges_around_target(sphere.halfedge(v))) {
      const QD::Vertex w = sphere.source(back);
      if (w.idx() < points.size() && w != end) continue;
      const double next = c + std::sqrt(CGAL::squared_distance(sphere.point(v), sphere.point(w))) + 20 * distance(w);
      if (next >= cost[w]) continue;
      cost[w] = next;
      into[w] = sphere.opposite(back);
      queue.push({next, w});
    }
  }
  Walk walk;
  for (QD::Vertex v = end; v != start; v = sphere.source(walk.back())) walk.push_back(into[v]);
  std::reverse(walk.begin(), walk.end());
  return walk;
}

/// a lift of a walk on the sphere, from one branch vertex to another, to its cover; it begins in the given sheet
inline std::vector<Side> lifted(const QD::Mesh& sphere, const QD::Glued_triangles& cover, const Walk& walk, int sheet)
{
  const int faces = static_cast<int>(sphere.number_of_faces());
  std::vector<Side> sides;
  for (QD::Halfedge h : walk) {
    const int f = static_cast<int>(sphere.face(h));
    const QD::Halfedge h0 = sphere.halfedge(sphere.face(h));
    const int e = h == h0 ? 0 : h == sphere.next(h0) ? 1 : 2;
    if (!sides.empty()) {   // in the sheet where the walk goes on from where it is
      const auto& [last, edge] = sides.back();
      sheet = cover.triangles[f][e] == cover.triangles[last][(edge + 1) % 3] ? 0 : 1;
    }
    sides.push_back({f + faces * sheet, e});
  }
  return sides;
}

/// The curve with the given branch points, the last of which may be infinity, as a branched cover. gamma_k is the
/// lift of a walk near the segment, directed so that gamma_k . gamma_(k+1) = 1.
/// \pre the polygonal chain of the points does not meet itself
inline Known_gluing known_cover(const std::vector<Complex>& points, int level)
{
  const QD::Mesh sphere = QD::triangulated_sphere(points, level);
  std::vector<QD::Vertex> branch;
  for (std::size_t k = 0; k < points.size(); ++k) branch.emplace_back(static_cast<QD::Mesh::size_type>(k));
  const int g = static_cast<int>(points.size()) / 2 - 1;
  Known_gluing known{QD::branched_cover(sphere, branch), {}, chain_intersections(2 * g), chain_periods(points)};
  const QD::Intrinsic_triangulation t(known.triangles);
  const auto curve = [&](const Cycle& c) { return QD::closed_curve_along_edges(t, walk_along(t, c, 0)); };
  for (int k = 0; k < 2 * g; ++k) {
    const Walk walk = walk_near_segment(sphere, points, k);
    Cycle cycle{lifted(sphere, known.triangles, walk, 0), lifted(sphere, known.triangles, walk, 1)};
    if (k > 0 && QD::intersection_number(t, curve(known.cycles.back()), curve(cycle)) < 0)
      std::swap(cycle.forth, cycle.back);
    known.cycles.push_back(cycle);
  }
  return known;
}

/// A surface at every level of refinement, and the theory: with cones of angle theta and triangles of size h, the
/// energy of a harmonic form is O(h^(4 pi / theta)) too large, and O(h^2) if theta <= 2 pi or the triangles are
/// graded.
struct Family
{
  std::string                       name;
  int                               first_level, last_level;
  double                            expected_order;   ///< of S
  bool                              flat;             ///< the polyhedral surface is the Riemann surface, exactly
  bool                              symmetric;        ///< automorphisms of the triangulation determine the periods
  std::function<Known_surface(int)> at_level;
};

inline const std::vector<Complex>& real_branch_points()
{
  static const std::vector<Complex> points{-3, -2, -0.5, 1, 2, 4.5};
  return points;
}

inline const std::vector<Complex>& complex_branch_points()
{
  static const std::vector<Complex> points{0, {1, 1}, {2, -0.5}, 3, {3.5, 2}, {-1, 1}};
  return points;
}

inline const std::vector<Complex>& eight_branch_points()
{
  static const std::vector<Complex> points{{-2, 0.5}, {-1.2, -0.8}, {-0.5, 0.9}, {0.3, -0.4},
                                           {0.9, 1.1}, {1.6, -0.7}, {2.2, 0.6}, {3, -0.2}};
  return points;
}

/// y^2 = x^5 - x; the last branch point is infinity
inline const std::vector<Complex>& bolza_branch_points()
{
  static const std::vector<Complex> points{1, {0, 1}, -1, {0, -1}, 0, std::numeric_limits<double>::infinity()};
  return points;
}

inline std::vector<Family> ground_truth_families()
{
  std::vector<Family> list;
  const auto add_flat = [&](const std::string& name, int last, double order, const Known_gluing& known) {
    list.push_back({name, last - 4, last, order, true, true,
                    [known](int level) { return known_surface(known, level); }});
  };
  const auto add_split = [&](const std::string& name, int last, double order, const Known_gluing& known) {
    add_flat(name + ", split at random", last - 1, order, split_at_random(known));
    list.back().symmetric = false;
  };
  const auto add_cover = [&](const std::string& name, const std::vector<Complex>& points) {
    list.push_back({"cover, " + name, 0, 4, 2, false, false,
                    [points](int level) { return known_surface(known_cover(points, level), 0); }});
  };
  for (int g = 1; g <= 10; ++g)
    add_flat("y^2 = x^" + std::to_string(2 * g + 2) + " - 1", 5, 1 + 1.0 / g, known_hyperelliptic(g));
  for (int g : {2, 3})
    add_split("y^2 = x^" + std::to_string(2 * g + 2) + " - 1", 5, 1 + 1.0 / g, known_hyperelliptic(g));
  for (int g : {2, 3})
    add_flat("regular " + std::to_string(4 * g) + "-gon", 6, 2.0 / (2 * g - 1), known_regular_polygon(g));
  add_split("regular 8-gon", 6, 2.0 / 3, known_regular_polygon(2));
  add_flat("L of three squares", 6, 2.0 / 3, known_l_of_three_squares());
  add_split("L of three squares", 6, 2.0 / 3, known_l_of_three_squares());
  add_cover("6 real points", real_branch_points());
  add_cover("6 complex points", complex_branch_points());
  add_cover("y^2 = x^5 - x", bolza_branch_points());
  add_cover("8 complex points", eight_branch_points());
  list.push_back({"torus of revolution", 0, 4, 2, false, false, [](int level) { return known_torus(0.4, level); }});
  return list;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_KNOWN_SURFACES_H
