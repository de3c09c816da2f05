// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Alexander duality: which loops bound inside and which outside is decided by linking numbers, which are integers.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/handle_tunnel_loops.h>
#include <CGAL/Quartic_differentials/internal/linking_number.h>
#include <CGAL/Quartic_differentials/intersection_number.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
using CGAL::Quartic_differentials::internal::linking_number;
using Polyline = std::vector<Point_3>;

namespace {

const double two_pi = 6.283185307179586;

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// ---- linking numbers of curves

Polyline curve(int n, const std::function<Point_3(double)>& f)
{
  Polyline p;
  for (int i = 0; i < n; ++i) p.push_back(f(two_pi * i / n));
  return p;
}

// a curve with random Fourier coefficients
Polyline random_curve(std::mt19937& random, int n)
{
  std::vector<double> c(18);
  for (double& x : c) x = Quartic_test::uniform(random, -1, 1);
  return curve(n, [&](double s) {
    double p[3] = {};
    for (int k = 0; k < 3; ++k)
      for (int f = 0; f < 3; ++f)
        p[k] += c[6 * k + 2 * f] * std::cos((f + 1) * s) + c[6 * k + 2 * f + 1] * std::sin((f + 1) * s);
    return Point_3(p[0], p[1], p[2]);
  });
}

// the Gauss integral of two closed polylines: the solid angles of the quadrangles of directions, over 4 pi
double gauss_integral(const Polyline& x, const Polyline& y)
{
  const auto vector = [](const Point_3& p, const Point_3& q) {
    return Eigen::Vector3d(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
  };
  const auto solid_angle = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double u = a.norm(), v = b.norm(), w = c.norm();
    return 2 * std::atan2(a.dot(b.cross(c)), u * v * w + a.dot(b) * w + b.dot(c) * u + c.dot(a) * v);
  };
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < y.size(); ++k) {
      const Point_3 &p = x[i], &q = x[(i + 1) % x.size()], &r = y[k], &s = y[(k + 1) % y.size()];
      const Eigen::Vector3d a = vector(p, r), b = vector(q, r), c = vector(q, s), d = vector(p, s);
      sum += solid_angle(a, b, c) + solid_angle(a, c, d);
    }
  return sum / (2 * two_pi);
}

void test_linking_numbers()
{
  const auto circle = [](double s) { return Point_3(std::cos(s), std::sin(s), 0); };
  const Polyline x = curve(60, circle);
  const Polyline y = curve(50, [](double s) { return Point_3(0, 1 + std::cos(s), -std::sin(s)); });
  CHECK_EQUAL(linking_number(x, y), 1);
  CHECK_EQUAL(linking_number(y, x), 1);
  CHECK_EQUAL(linking_number(Polyline(x.rbegin(), x.rend()), y), -1);
  CHECK_NEAR(gauss_integral(x, y), 1, 1e-9);
  const Polyline far = curve(50, [](double s) { return Point_3(0, 5 + std::cos(s), -std::sin(s)); });
  CHECK_EQUAL(linking_number(x, far), 0);
  // a square through the lattice points: every coordinate projection is degenerate
  const Polyline square = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}}, through = {{0, 0, -1}, {2, 0, -1},
    {2, 0, 1}, {0, 0, 1}};
  CHECK_EQUAL(std::abs(linking_number(square, through)), 1);
  for (int winding = 2; winding < 6; ++winding) {   // torus link
    const Polyline coil = curve(200, [&](double s) {
      const double r = 1 + 0.3 * std::cos(winding * s);
      return Point_3(r * std::cos(s), r * std::sin(s), 0.3 * std::sin(winding * s));
    });
    CHECK_EQUAL(std::abs(linking_number(x, coil)), winding);
  }
  // the Whitehead link has linking number 0
  const Polyline whitehead = curve(200, [](double s) {
    return Point_3(0.6 * std::cos(s), 2 * std::sin(s), 0.6 * std::sin(2 * s));
  });
  CHECK_EQUAL(linking_number(curve(60, [](double s) { return Point_3(std::cos(s), 0, std::sin(s)); }), whitehead), 0);
  CHECK_THROWS(linking_number(square, square), Numerical_error, "meet");

  std::mt19937 random(7);
  int linked = 0;
  for (int k = 0; k < 40; ++k) {
    const Polyline p = random_curve(random, 80), q = random_curve(random, 90);
    const int lk = linking_number(p, q);
    CHECK_NEAR(gauss_integral(p, q), lk, 1e-6);
    CHECK_EQUAL(linking_number(q, p), lk);
    linked += lk != 0;
  }
  CHECK(linked > 5);
}

// ---- surfaces

// a tube of radius r round a closed curve, framed by a fixed direction that is nowhere tangent to the curve
Mesh tube(int n, int m, double r, const std::function<Eigen::Vector3d(double)>& centre, bool outward = true)
{
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    const double s = two_pi * i / n;
    const Eigen::Vector3d tangent = (centre(s + 1e-4) - centre(s - 1e-4)).normalized();
    const Eigen::Vector3d up(0.3, 0.2, 1), normal = (up - up.dot(tangent) * tangent).normalized();
    const Eigen::Vector3d binormal = tangent.cross(normal);
    for (int k = 0; k < m; ++k) {
      const double a = two_pi * k / m;
      const Eigen::Vector3d p = centre(s) + r * (std::cos(a) * normal + std::sin(a) * binormal);
      mesh.add_vertex(Point_3(p.x(), p.y(), p.z()));
    }
  }
  const auto vertex = [&](int i, int k) { return Vertex(static_cast<Mesh::size_type>(i % n * m + k % m)); };
  const auto add = [&](Vertex a, Vertex b, Vertex c) { outward ? mesh.add_face(a, b, c) : mesh.add_face(a, c, b); };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k) {
      add(vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1));
      add(vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k));
    }
  return mesh;
}

// the integrals of the cochains along vertices, which are joined by edges
Eigen::RowVectorXi integrals(const Intrinsic_triangulation& t, const Integer_cochains& eta,
                             const std::vector<Vertex>& walk)
{
  Eigen::RowVectorXi sum = Eigen::RowVectorXi::Zero(eta.size());
  for (std::size_t i = 0; i < walk.size(); ++i)
    sum += eta.row(t.mesh().halfedge(walk[i], walk[(i + 1) % walk.size()]));
  return sum;
}

// loops for people: closed, simple, in the classes of a canonical basis of handles and tunnels
void test_loops(const Intrinsic_triangulation& t, const Handle_tunnel_basis& classes, bool all_simple)
{
  const auto start = std::chrono::steady_clock::now();
  const Handle_tunnel_loops result = handle_tunnel_loops(t, classes);
  std::cout << "  loops: " << seconds_since(start) << " s, lengths";
  const int g = t.genus();
  CHECK_EQUAL(static_cast<int>(result.loops.size()), 2 * g);
  CHECK_EQUAL(result.classes.basis.intersection_matrix, symplectic_unit(g));
  CHECK_EQUAL(intersection_numbers(t, result.classes.basis.cochains), symplectic_unit(g));
  std::vector<Closed_curve> curves;
  for (int i = 0; i < 2 * g; ++i) {
    const Edge_loop& loop = result.loops[i];
    curves.push_back(closed_curve_along_edges(t, loop.walk));   // throws if it is not closed
    const Homology_class x = homology_class(t, classes.basis.cochains, curves.back());
    CHECK_EQUAL(homology_class(t, result.classes.basis.cochains, curves.back()), Homology_class::Unit(2 * g, i));
    if (classes.found) CHECK(x.segment(i < g ? g : 0, g).isZero());   // still a tunnel, still a handle
    double length = 0;
    std::vector<Vertex> vertices;
    for (Halfedge h : loop.walk) {
      length += t.length(h);
      vertices.push_back(t.source(h));
    }
    CHECK_NEAR(loop.length, length, 1e-12 * length);
    std::sort(vertices.begin(), vertices.end());
    CHECK_EQUAL(loop.simple, std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end());
    CHECK_EQUAL(loop.simple, all_simple || i >= g);
    std::cout << (i == g ? " | " : " ") << length;
  }
  for (int i = 0; i < 2 * g; ++i)
    for (int k = 0; k < 2 * g; ++k)
      CHECK_EQUAL(intersection_number(t, curves[i], curves[k]), symplectic_unit(g)(i, k));
  std::cout << std::endl;
}

Handle_tunnel_basis test(const std::string& name, const Intrinsic_triangulation& t, bool all_simple = true)
{
  auto start = std::chrono::steady_clock::now();
  const Homology_basis plain = homology_basis(t);
  const double plain_seconds = seconds_since(start);
  start = std::chrono::steady_clock::now();
  const Handle_tunnel_basis result = handle_tunnel_basis(t, plain);
  std::cout << name << ": " << t.number_of_faces() << " faces, genus " << t.genus() << ", " << plain_seconds << " s + "
            << seconds_since(start) << " s " << result.reason << std::endl;
  CHECK_EQUAL(result.certified, result.reason.empty());
  const int g = t.genus();
  CHECK_EQUAL(intersection_numbers(t, result.basis.cochains), symplectic_unit(g));
  CHECK_EQUAL(result.basis.intersection_matrix, symplectic_unit(g));
  test_loops(t, result, all_simple);
  CHECK(result.found || !result.certified);
  if (!result.found) {
    CHECK_EQUAL(result.basis.combination, plain.combination);
    return result;
  }
  const Linking_matrices v = linking_matrices(t, plain.loops);
  Integer_cochains of_loops(t.number_of_edges(), 2 * g);
  for (int k = 0; k < 2 * g; ++k)
    for (Halfedge h : plain.loops[k]) of_loops.add(h, k, 1);
  CHECK_EQUAL(v.plus - v.minus, -intersection_numbers(t, of_loops, plain.loops));
  CHECK_EQUAL(v.plus.transpose(), v.minus);
  const Eigen::MatrixXi tunnels = result.basis.combination.topRows(g), handles = result.basis.combination.bottomRows(g);
  const bool outward = (handles * v.plus).isZero();
  CHECK((tunnels * (outward ? v.minus : v.plus)).isZero());
  CHECK((handles * (outward ? v.plus : v.minus)).isZero());
  return result;
}

// the classes of the circle across a tube and of a curve along it: +-b, and +-a + something b
void test_tube(const std::string& name, const Mesh& mesh, int n, int m)
{
  const Intrinsic_triangulation t(mesh);
  const Handle_tunnel_basis result = test(name, t);
  CHECK(result.certified);
  std::vector<Vertex> across, along;
  for (int k = 0; k < m; ++k) across.emplace_back(static_cast<Mesh::size_type>(k));
  for (int i = 0; i < n; ++i) along.emplace_back(static_cast<Mesh::size_type>(i * m));
  // a class x a + y b integrates the cochains of a and b to -y and x (or their negatives)
  const Eigen::RowVectorXi meridian = integrals(t, result.basis.cochains, across);
  CHECK_EQUAL(meridian(1), 0);
  CHECK_EQUAL(std::abs(meridian(0)), 1);
  CHECK_EQUAL(std::abs(integrals(t, result.basis.cochains, along)(1)), 1);
}

void test_tubes()
{
  const auto circle = [](double s) { return Eigen::Vector3d(2 * std::cos(s), 2 * std::sin(s), 0); };
  const auto trefoil = [](double s) {
    return Eigen::Vector3d(std::sin(s) + 2 * std::sin(2 * s), std::cos(s) - 2 * std::cos(2 * s), -std::sin(3 * s));
  };
  test_tube("torus", tube(40, 20, 1, circle), 40, 20);
  test_tube("thin torus", tube(60, 8, 0.1, circle), 60, 8);
  test_tube("torus inside out", tube(40, 20, 1, circle, false), 40, 20);
  test_tube("trefoil", tube(300, 12, 0.3, trefoil), 300, 12);
  test_tube("trefoil inside out", tube(300, 12, 0.3, trefoil, false), 300, 12);
  CHECK(test("fine trefoil", Intrinsic_triangulation(tube(1000, 30, 0.3, trefoil))).certified);
  // too many ways to spiral round it: a loop is put together from pieces
  CHECK(test("thin trefoil", Intrinsic_triangulation(tube(1000, 6, 0.03, trefoil)), false).certified);

  const Handle_tunnel_basis fat = test("fat trefoil", Intrinsic_triangulation(tube(300, 12, 1.1, trefoil)));
  CHECK(!fat.certified);
  CHECK(fat.reason.find("meets itself") != std::string::npos);
  Mesh pulled = torus(2, 1, 40, 20);
  pulled.point(Vertex(0)) = Point_3(-4, 0.01, 0.02);
  CHECK(!test("torus with a spike through it", Intrinsic_triangulation(pulled)).certified);
}

// On a torus of revolution, many times finer than the cells in which loops are looked for at first, the shortest loops
// along edges are known: the inner equator, and every circle across.
void test_shortest_loops()
{
  const int n = 240, m = 120;
  const Intrinsic_triangulation t(torus(2, 1, n, m));
  const Handle_tunnel_loops result = handle_tunnel_loops(t, handle_tunnel_basis(t, homology_basis(t)));
  const auto circle = [](int k) { return 2 * k * std::sin(0.5 * two_pi / k); };
  CHECK_NEAR(result.loops[0].length, circle(n), 1e-12 * circle(n));
  CHECK_NEAR(result.loops[1].length, circle(m), 1e-12 * circle(m));
}

} // namespace

int main()
{
  test_linking_numbers();
  test_shortest_loops();
  test_tubes();
  for (const auto& s : Quartic_test::sample_surfaces()) CHECK_EQUAL(test(s.name, s.surface).certified,
                                                                    s.surface.is_embedded());
  for (const auto& [R, r] : {std::pair(2., 1.), std::pair(1.01, 1.), std::pair(5., 0.1)})
    CHECK(test("torus of revolution", Intrinsic_triangulation(torus(R, r, 40, 20))).certified);
  for (const auto& s : Quartic_test::real_surfaces({"kitten_18k9", "rockerarm_20k", "lawson_5k", "sculpt_7k3",
         "amphora_20k", "3holes_7k2", "fertility_112k", "botijo_82k", "bracket_29k", "casting_10k", "dancer_50k"}))
    CHECK(test(s.name, s.surface).certified);
  for (const auto& s : Quartic_test::real_surfaces({"neptune_30k", "buddha_20k"})) {   // scans that meet themselves
    const Handle_tunnel_basis result = test(s.name, s.surface);
    CHECK(result.found && !result.certified);
  }
  return Quartic_test::result();
}
