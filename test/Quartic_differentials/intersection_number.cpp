// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Intersection numbers of closed curves: along edges, through faces and as polylines, on meshes and on Delta-complexes.

#include "check.h"
#include "exact_charts.h"
#include "own_input.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/intersection_number.h>
#include <CGAL/Quartic_differentials/pull_back.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <queue>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
using Quartic_test::own_input;
using namespace Quartic_test;

namespace {

using Walk = std::vector<Halfedge>;
using Matrix = Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;

std::size_t any(std::mt19937& random, std::size_t n) { return random() % n; }

Halfedge any_halfedge(const Intrinsic_triangulation& t, std::mt19937& random)
{
  return Halfedge(static_cast<Mesh::size_type>(any(random, t.number_of_halfedges())));
}

Walk joined(Walk a, const Walk& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Closed_curve reversed(const Intrinsic_triangulation& t, Closed_curve c)
{
  std::reverse(c.crossings.begin(), c.crossings.end());
  for (Halfedge& h : c.crossings) h = t.opposite(h);
  return c;
}

// A walk of fewest steps, where step h leads from node `from(h)` to `to(h)`.
template <class From, class To>
Walk shortest_walk(const Intrinsic_triangulation& t, std::size_t start, std::size_t end, From from, To to)
{
  std::vector<Walk> steps(std::max(t.number_of_vertices(), t.number_of_faces()));
  for (Halfedge h : t.halfedges()) steps[from(h)].push_back(h);
  std::vector<Halfedge> reached_by(steps.size(), Mesh::null_halfedge());
  std::queue<std::size_t> queue({end});   // backwards, so that every node knows its step to the end
  while (!queue.empty()) {
    const std::size_t n = queue.front();
    queue.pop();
    for (Halfedge h : steps[n]) {
      const Halfedge back = t.opposite(h);
      if (from(back) == end || reached_by[from(back)] != Mesh::null_halfedge()) continue;
      reached_by[from(back)] = back;
      queue.push(from(back));
    }
  }
  Walk walk;
  for (std::size_t n = start; n != end; n = to(walk.back())) walk.push_back(reached_by[n]);
  return walk;
}

// A random walk of n steps from `start`, closed up by a shortest one.
template <class From, class To>
Walk closed_walk(const Intrinsic_triangulation& t, std::size_t start, int n, std::mt19937& random, From from, To to)
{
  std::vector<Walk> steps(std::max(t.number_of_vertices(), t.number_of_faces()));
  for (Halfedge h : t.halfedges()) steps[from(h)].push_back(h);
  Walk walk;
  std::size_t at = start;
  for (int i = 0; i < n; ++i) {
    walk.push_back(steps[at][any(random, steps[at].size())]);
    at = to(walk.back());
  }
  return joined(walk, shortest_walk(t, at, start, from, to));
}

Walk random_edge_walk(const Intrinsic_triangulation& t, Vertex v, int n, std::mt19937& random)
{
  return closed_walk(t, v.idx(), n, random, [&](Halfedge h) { return t.source(h).idx(); },
                     [&](Halfedge h) { return t.target(h).idx(); });
}

Closed_curve random_dual_walk(const Intrinsic_triangulation& t, Face f, int n, std::mt19937& random)
{
  return {closed_walk(t, f.idx(), n, random, [&](Halfedge h) { return t.face(h).idx(); },
                      [&](Halfedge h) { return t.face(t.opposite(h)).idx(); })};
}

// Every other curve runs along edges.
std::vector<Closed_curve> random_curves(const Intrinsic_triangulation& t, int n, std::mt19937& random)
{
  std::vector<Closed_curve> curves;
  for (int k = 0; k < n; ++k) {
    const Halfedge h = any_halfedge(t, random);
    const int steps = 1 + static_cast<int>(any(random, 4 * t.number_of_faces()));
    curves.push_back(k % 2 == 0 ? closed_curve_along_edges(t, random_edge_walk(t, t.source(h), steps, random))
                                : random_dual_walk(t, t.face(h), steps, random));
  }
  return curves;
}

// The loops have the intersection numbers that the basis was made from, and their classes are the rows of the inverse
// of the combination.
void check_basis(const Intrinsic_triangulation& t, const Homology_basis& basis)
{
  const Eigen::Index n = basis.combination.rows();
  Matrix j(n, n), classes(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    classes.row(k) = homology_class(t, basis.cochains, {basis.loops[k]});
    for (Eigen::Index l = 0; l < n; ++l) j(k, l) = intersection_number(t, {basis.loops[k]}, {basis.loops[l]});
  }
  const Matrix u = basis.combination.cast<std::int64_t>();
  CHECK_EQUAL(u * j * u.transpose(), basis.intersection_matrix.cast<std::int64_t>());
  CHECK_EQUAL(u * classes, Matrix::Identity(n, n));
}

// Crossings counted in the dual graph agree with the symplectic form of the classes. Returns the largest number.
std::int64_t check_curves(const Intrinsic_triangulation& t, const Homology_basis& basis,
                          const std::vector<Closed_curve>& curves)
{
  std::int64_t largest = 0;
  for (const Closed_curve& a : curves) {
    const Homology_class x = homology_class(t, basis.cochains, a);
    CHECK_EQUAL(intersection_number(t, a, a), 0);
    const Closed_curve again = closed_curve_along_edges(t, edge_walk(t, a));
    CHECK_EQUAL(homology_class(t, basis.cochains, again), x);
    CHECK_EQUAL(homology_class(t, basis.cochains, reversed(t, a)), -x);
    for (const Closed_curve& b : curves) {
      const std::int64_t ab = intersection_number(t, a, b);
      CHECK_EQUAL(ab, -intersection_number(t, b, a));
      CHECK_EQUAL(ab, intersection_number(x, homology_class(t, basis.cochains, b)));
      CHECK_EQUAL(ab, intersection_number(t, again, b));
      CHECK_EQUAL(ab, -intersection_number(t, reversed(t, a), b));
      largest = std::max(largest, std::abs(ab));
    }
  }
  return largest;
}

// Walks from the same place follow each other; spikes and boundaries of faces and of stars change nothing.
void check_sums(const Intrinsic_triangulation& t, const std::vector<Closed_curve>& others, std::mt19937& random)
{
  const Halfedge start = any_halfedge(t, random);
  const Walk x = random_edge_walk(t, t.source(start), 50, random);
  const Walk y = random_edge_walk(t, t.source(start), 50, random);
  const Closed_curve p = random_dual_walk(t, t.face(start), 50, random);
  const Closed_curve q = random_dual_walk(t, t.face(start), 50, random);
  Closed_curve star;
  Halfedge round = start;
  do star.crossings.push_back(round);
  while ((round = t.next(t.opposite(round))) != start);
  const Walk face{start, t.next(start), t.prev(start)}, spike{start, t.opposite(start)};
  const auto along = [&](const Walk& w) { return closed_curve_along_edges(t, w); };
  for (const Closed_curve& c : others) {
    const auto number = [&](const Closed_curve& a) { return intersection_number(t, a, c); };
    CHECK_EQUAL(number(along(joined(x, y))), number(along(x)) + number(along(y)));
    CHECK_EQUAL(number({joined(p.crossings, q.crossings)}), number(p) + number(q));
    CHECK_EQUAL(number(along(joined(face, x))), number(along(x)));
    CHECK_EQUAL(number(along(joined(spike, x))), number(along(x)));
    CHECK_EQUAL(number({joined(star.crossings, p.crossings)}), number(p));
    CHECK_EQUAL(number({joined(spike, p.crossings)}), number(p));
    CHECK_EQUAL(number(star), 0);
    CHECK_EQUAL(number(along(face)), 0);
    CHECK_EQUAL(number({}), 0);
  }
}

// The point at s of the way along h, in the coordinates of its face: on the edge, or at an end for s = 0 and 1.
std::array<double, 3> along(const Intrinsic_triangulation& t, Halfedge h, double s) { return on_edge(t, h, s).barycentric; }

// A dual walk as a polyline through its edges; every third crossing is pulled into an end of its edge.
std::vector<Face_segment> through_edges(const Intrinsic_triangulation& t, const Closed_curve& c, std::mt19937& random)
{
  const std::size_t n = c.crossings.size();
  std::vector<Face_segment> segments(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Halfedge out = c.crossings[i], in = t.opposite(out);
    const double s = any(random, 3) == 0 ? static_cast<double>(any(random, 2)) : uniform(random, 0.1, 0.9);
    segments[i].face = t.face(out);
    segments[i].target = along(t, out, s);
    segments[(i + 1) % n].source = along(t, in, 1 - s);
  }
  return segments;
}

// A walk along edges as a polyline in the faces on either side, which it changes in the middle of an edge or before it.
std::vector<Face_segment> along_edges(const Intrinsic_triangulation& t, const Walk& walk, std::mt19937& random)
{
  std::vector<Face_segment> segments;
  for (Halfedge h : walk)
    for (int half = 0; half < 2; ++half) {
      const double from = 0.5 * half, to = from + 0.5;
      const Halfedge o = t.opposite(h);
      if (any(random, 2) == 0) segments.push_back({t.face(h), along(t, h, from), along(t, h, to)});
      else                     segments.push_back({t.face(o), along(t, o, 1 - from), along(t, o, 1 - to)});
    }
  return segments;
}

std::vector<Surface_point> sources(const std::vector<Face_segment>& segments)
{
  std::vector<Surface_point> points;
  for (const Face_segment& s : segments) points.push_back({s.face, s.source});
  return points;
}

void check_polylines(const Intrinsic_triangulation& t, const Homology_basis& basis, bool simplicial,
                     std::mt19937& random)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Halfedge start = any_halfedge(t, random);
    const Closed_curve dual = random_dual_walk(t, t.face(start), 200, random);
    const Walk walk = random_edge_walk(t, t.source(start), 200, random);
    const Homology_class x = homology_class(t, basis.cochains, dual);
    const Homology_class y = homology_class(t, basis.cochains, closed_curve_along_edges(t, walk));
    const auto through = through_edges(t, dual, random), along = along_edges(t, walk, random);
    CHECK_EQUAL(homology_class(t, basis.cochains, closed_curve_along_segments(t, through)), x);
    CHECK_EQUAL(homology_class(t, basis.cochains, closed_curve_along_segments(t, along)), y);
    if (!simplicial) continue;
    CHECK_EQUAL(homology_class(t, basis.cochains, closed_curve_along_polyline(t, sources(through))), x);
    CHECK_EQUAL(homology_class(t, basis.cochains, closed_curve_along_polyline(t, sources(along))), y);
  }
}

// Cochains that rode along flips know the classes of curves on the new triangulation.
void check_after_flips(Intrinsic_triangulation t, Homology_basis basis, std::mt19937& random)
{
  make_delaunay(t, basis.cochains);
  check_curves(t, basis, random_curves(t, 4, random));
}

void test(const std::string& name, const Intrinsic_triangulation& t, bool simplicial)
{
  std::mt19937 random(3);
  const Homology_basis basis = homology_basis(t);
  check_basis(t, basis);
  const std::vector<Closed_curve> curves = random_curves(t, 10, random);
  const std::int64_t largest = check_curves(t, basis, curves);
  for (int trial = 0; trial < 10; ++trial) check_sums(t, curves, random);
  check_polylines(t, basis, simplicial, random);
  check_after_flips(t, basis, random);
  std::cout << name << ": intersection numbers of random curves up to " << largest << std::endl;
}

// At the outermost point of the torus the parallel runs along y and the meridian along z, seen from x: the meridian
// crosses the parallel from right to left.
void test_sign()
{
  const int n = 8, m = 6;
  const Intrinsic_triangulation t(torus(2, 1, n, m));
  const auto vertex = [&](int i, int j) { return Vertex((i % n) * m + j % m); };
  Walk parallel, meridian;
  for (int i = 0; i < n; ++i) parallel.push_back(t.mesh().halfedge(vertex(i, 0), vertex(i + 1, 0)));
  for (int j = 0; j < m; ++j) meridian.push_back(t.mesh().halfedge(vertex(0, j), vertex(0, j + 1)));
  const Closed_curve a = closed_curve_along_edges(t, parallel), b = closed_curve_along_edges(t, meridian);
  CHECK_EQUAL(intersection_number(t, a, b), 1);
  CHECK_EQUAL(intersection_number(t, b, a), -1);
  CHECK_THROWS(closed_curve_along_edges(t, {parallel[0]}), Error, "jumps from vertex");
  CHECK_THROWS(edge_walk(t, {{parallel[0]}}), Error, "jumps from face");
}

// A unit square with opposite sides glued: one vertex, three loops east, north and south-west.
Intrinsic_triangulation square_torus()
{
  Glued_triangles square;
  square.triangles = {{0, 0, 0}, {0, 0, 0}};
  square.opposite = {{{{1, 1}, {1, 2}, {1, 0}}}, {{{0, 2}, {0, 0}, {0, 1}}}};
  square.lengths = {{1, 1, std::sqrt(2.0)}, {std::sqrt(2.0), 1, 1}};
  return Intrinsic_triangulation(square);
}

void test_one_vertex()
{
  const Intrinsic_triangulation t = square_torus();
  const Face f(0);
  const auto h = t.halfedges(f);
  for (int k = 0; k < 3; ++k) {
    const Closed_curve a = closed_curve_along_edges(t, {h[k]}), b = closed_curve_along_edges(t, {h[(k + 1) % 3]});
    CHECK_EQUAL(intersection_number(t, a, b), 1);
    const Closed_curve straight = closed_curve_along_segments(t, {{f, along(t, h[k], 0), along(t, h[k], 1)}});
    CHECK_EQUAL(intersection_number(t, straight, b), 1);
  }
  CHECK_EQUAL(homology_class(t, homology_basis(t).cochains, closed_curve_along_edges(t, {h[0], h[1], h[2]})),
              Homology_class::Zero(2));
  const std::array<double, 3> inside{0.25, 0.25, 0.5}, nowhere{};
  const Surface_point corner{Face(1), {1, 0, 0}};
  CHECK_THROWS(closed_curve_along_polyline(t, {{f, inside}, corner}), Error, "two corners there");
  CHECK_THROWS(closed_curve_along_polyline(t, {{f, inside}, {Face(1), inside}}), Error, "does not lie in it");
  CHECK_THROWS(closed_curve_along_polyline(t, {{f, inside}, {f, nowhere}}), Error, "no barycentric coordinate");
  const std::vector<Face_segment> broken{{f, inside, along(t, h[0], 0.5)}, {f, inside, inside}};
  CHECK_THROWS(closed_curve_along_segments(t, broken), Error, "another point");
  CHECK_EQUAL(closed_curve_along_polyline(t, {{f, inside}}).crossings.size(), 0u);
}

// Straight closed lines on a flat torus, drawn by pull_back(): k times u plus l times v.
void test_pulled_back_lines()
{
  std::mt19937 random(6);
  const Grid_vector u{1200, 70}, v{-130, 900};
  const Refined_surface surface = own_input(exact_differential({2, 3, 0, 1}, u, v));
  const Intrinsic_triangulation& t = surface.differential.triangulation;
  struct Line { int k, l; Closed_curve curve; };
  std::vector<Line> lines;
  for (int k = -4; k <= 4; ++k)
    for (int l = -4; l <= 4; ++l) {
      const Grid_vector start{331 + static_cast<int>(any(random, 50)), 270};
      const Grid_vector period{k * u.x + l * v.x, k * u.y + l * v.y};
      const Pulled_back_arc line = pull_back(surface, Face(0), {start, start + period});
      lines.push_back({k, l, closed_curve_along_polyline(t, line.points)});
    }
  for (const Line& a : lines)
    for (const Line& b : lines) CHECK_EQUAL(intersection_number(t, a.curve, b.curve), a.k * b.l - a.l * b.k);
}

} // namespace

int main()
{
  test_sign();
  test_one_vertex();
  test_pulled_back_lines();
  test("torus", Intrinsic_triangulation(torus(2, 1, 12, 8)), true);
  for (int g = 1; g <= 3; ++g)
    test("chain of genus " + std::to_string(g), Intrinsic_triangulation(handle_chain(g, 6)), true);
  for (int g = 1; g <= 2; ++g)
    for (int s = 0; s <= 2; ++s)
      test("polygons of genus " + std::to_string(g) + ", " + std::to_string(s) + " times subdivided",
           Intrinsic_triangulation(hyperelliptic(g, s)), false);
  test("square torus", square_torus(), false);
  return result();
}
