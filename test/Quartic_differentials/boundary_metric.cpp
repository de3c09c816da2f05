// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps 4 to 6 on surfaces with boundary: the Abel-Jacobi map with corners that slide along the boundary, legalization and
// its refusals, the flat metric with straight boundary compared with that of the double, and exact holonomy.

#include "check.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>

#include <Eigen/Dense>

using namespace Quartic_test;

namespace {

const double pi = CGAL_PI;
Visitor visitor;

double largest(const Eigen::VectorXd& x) { return x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff(); }

// Corners for the boundary curves: four convex ones on the first, then other lists in turn.
std::vector<std::vector<int>> corners_of(int curves)
{
  const std::vector<std::vector<int>> lists{{1, 1, 1, 1}, {3, 3}, {}, {1, 3, 4}, {1, 1, 3, 3}};
  std::vector<std::vector<int>> corners;
  for (int c = 0; c < curves; ++c) corners.push_back(lists[c % lists.size()]);
  return corners;
}

// ---- splits of the boundary

// Singularities keep their places in space, and corners stay on the boundary.
void check_carried_divisor(const Intrinsic_triangulation& t)
{
  std::mt19937 random(3);
  Divisor divisor;
  for (Face f : t.faces()) {
    const double x = uniform(random, 0.01, 0.49), y = uniform(random, 0.01, 0.49);
    divisor.push_back({{f, {1 - x - y, x, y}}, 1, false, false});
  }
  for (const auto& curve : t.boundary_curves())
    for (Halfedge h : curve) divisor.push_back({on_edge(t, h, uniform(random, 0.01, 0.99)), 1, false, true});
  Intrinsic_triangulation split = t;
  Divisor carried = divisor;
  split_obtuse_at_boundary(split, carried);
  double farthest = 0;
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    const Point_3 before = position_on_input(t, divisor[i].location), after = position_on_input(split, carried[i].location);
    farthest = std::max(farthest, CGAL::squared_distance(before, after));
    if (divisor[i].on_boundary)
      CHECK(internal::boundary_place(split, carried[i].location).halfedge != Mesh::null_halfedge());
  }
  CHECK(std::sqrt(farthest) <= 1e-12);
}

// No angle opposite a boundary edge of the Delaunay triangulation is obtuse; the surface is the one it was, and nothing is
// split twice.
void check_splits(const Surface_with_boundary& s)
{
  const Prepared_surface p(s.surface);
  CHECK_EQUAL(structural_defect(p.input), "");
  CHECK_EQUAL(p.input.number_of_vertices(), s.surface.number_of_vertices() + p.splits);
  CHECK_NEAR(p.input.area(), s.surface.area(), 1e-9 * s.surface.area());
  const std::vector<double> angles = corner_angles(p.delaunay, p.delaunay.lengths());
  double widest = 0;
  for (const auto& curve : p.delaunay.boundary_curves())
    for (Halfedge h : curve) widest = std::max(widest, angles[p.delaunay.prev(h)]);
  CHECK(widest <= pi / 2 + 1e-8);
  Intrinsic_triangulation again = p.input;
  CHECK_EQUAL(split_obtuse_at_boundary(again), 0u);
  const std::vector<double> k = curvatures(p.input, corner_angles(p.input, p.input.lengths()));
  for (std::size_t v = s.surface.number_of_vertices(); v < k.size(); ++v) CHECK_NEAR(k[v], 0, 1e-9);
  if (!p.input.is_embedded()) return;
  check_carried_divisor(s.surface);
  for (Edge e : p.input.edges()) {   // lengths and places agree
    const Halfedge h = p.input.halfedge(e);
    CHECK_NEAR(p.input.length(e), std::sqrt(CGAL::squared_distance(p.input.mesh().point(p.input.source(h)),
                                                                   p.input.mesh().point(p.input.target(h)))), 1e-12);
  }
}

// Three vertices close to a long boundary edge: it is split below each of them, whatever the order in which this is found.
void check_feet()
{
  Mesh mesh;
  const auto vertex = [&](double x, double y) { return mesh.add_vertex(Point_3(x, y, 0)); };
  const Vertex a = vertex(0, 0), b = vertex(10, 0), p = vertex(2, 0.6);
  const Vertex q = vertex(5, 0.5), r = vertex(8, 0.6), top = vertex(5, 6);
  mesh.add_face(a, b, q);
  mesh.add_face(a, q, p);
  mesh.add_face(q, b, r);
  mesh.add_face(a, p, top);
  mesh.add_face(p, q, top);
  mesh.add_face(q, r, top);
  mesh.add_face(r, b, top);
  Intrinsic_triangulation t(mesh);
  const std::size_t added = split_obtuse_at_boundary(t);
  CHECK_EQUAL(added, t.number_of_vertices() - mesh.number_of_vertices());
  std::vector<double> places;
  for (std::size_t v = mesh.number_of_vertices(); v < t.number_of_vertices(); ++v) {
    const Point_3 at = t.mesh().point(Vertex(static_cast<Mesh::size_type>(v)));
    if (at.y() == 0) places.push_back(at.x());
  }
  std::sort(places.begin(), places.end());
  CHECK_EQUAL(places.size(), 3u);
  for (std::size_t k = 0; k < places.size(); ++k) CHECK_NEAR(places[k], 2 + 3 * static_cast<double>(k), 1e-12);
  for (Edge e : t.edges())
    if (t.is_border(e) && t.mesh().point(t.source(t.halfedge(e))).y() + t.mesh().point(t.target(t.halfedge(e))).y() == 0)
      CHECK(std::abs(t.length(e) - 2) < 1e-12 || std::abs(t.length(e) - 3) < 1e-12);
}

// ---- the Abel-Jacobi map

// Moving by small steps changes F as its derivative says, also where corners pass vertices.
void check_derivative(const Prepared_surface& p, const Divisor& divisor, std::mt19937& random)
{
  Lifted_divisor points;
  std::vector<int> orders;
  for (const Singularity& s : divisor) {
    points.push_back(s.on_boundary ? p.map.lift_on_boundary(s.location) : p.map.lift(s.location));
    orders.push_back(s.order);
  }
  const double size = std::sqrt(p.delaunay.area());
  const auto moved = [&](const Lifted_divisor& from, const Eigen::VectorXd& by) {
    Lifted_divisor to;
    for (std::size_t i = 0; i < from.size(); ++i) to.push_back(p.map.moved(from[i], {by[2 * i], by[2 * i + 1]}));
    return to;
  };
  int passed = 0;
  for (int n = 0; n < 20; ++n) {
    const Eigen::VectorXd f = p.map.residual(points, orders);
    const Eigen::MatrixXd j = p.map.jacobian(points, orders);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(2 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      step[2 * i] = uniform(random, -1, 1);
      if (!points[i].on_boundary) step[2 * i + 1] = uniform(random, -1, 1);
      else                        CHECK(j.col(2 * i + 1).isZero());
    }
    const double tiny = 1e-7 * size;   // too short to leave a face or an edge, but for chance
    const Eigen::VectorXd change = p.map.residual(moved(points, tiny * step), orders) - f;
    CHECK(largest(change - tiny * j * step) <= 1e-4 * tiny * (1 + (j * step).norm()));

    // far steps are continuous: the same in one and in two parts, up to rounding
    const Lifted_divisor far = moved(points, 0.03 * size * step);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i].on_boundary) continue;
      passed += far[i].location.face != points[i].location.face;
      const Lifted_point back = p.map.moved(far[i], -0.03 * size * step[2 * i]);
      CHECK_NEAR(largest((p.map.potential(back) - p.map.potential(points[i])).transpose()), 0, 1e-10);
      CHECK(largest((p.map.potential(far[i]) - p.map.potential(points[i])).transpose()) < 0.45);
    }
    points = far;
  }
  CHECK(passed > 0);
}

// A corner that slides once round a boundary curve comes back on a sheet that tells how often the arcs end there.
void check_round_trip(const Prepared_surface& p)
{
  for (const auto& curve : p.delaunay.boundary_curves()) {
    double length = 0;
    Eigen::RowVectorXi crossings = Eigen::RowVectorXi::Zero(p.homology.cochains.size());
    for (Halfedge h : curve) {
      length += p.delaunay.length(h);
      crossings += p.homology.cochains.row(h);
    }
    const Lifted_point start = p.map.lift_on_boundary(on_edge(p.delaunay, curve[0], 0.5));
    const Lifted_point end = p.map.moved(start, length);
    CHECK_NEAR(largest((p.map.potential(end) - p.map.potential(start) - crossings.cast<double>()).transpose()), 0, 1e-9);
  }
}

// ---- legalization and its refusals

void check_legal(const Prepared_surface& p, const Legal_divisor& legal, const Divisor& before)
{
  CHECK(legal.history.back() <= 1e-12);
  CHECK_EQUAL(legal.divisor.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK_EQUAL(legal.divisor[i].order, before[i].order);
    CHECK_EQUAL(legal.divisor[i].on_boundary, before[i].on_boundary);
    if (before[i].on_boundary) p.map.lift_on_boundary(legal.divisor[i].location);   // throws where it left the boundary
  }
  CHECK_EQUAL(collision(p.delaunay, legal.divisor, 0.01), "");
}

void check_refusals(std::mt19937& random)
{
  const Prepared_surface annulus(Intrinsic_triangulation(plate(1, 14)));
  const Intrinsic_triangulation& t = annulus.delaunay;
  const auto curves = t.boundary_curves();
  const auto corner = [&](int curve, double at, int m) {
    return Singularity{on_curve(t, curves[curve], at), m - 2, false, true};
  };
  const auto legalized = [&](const Divisor& d) { return legalize_divisor(annulus.map, d, {}, visitor); };
  CHECK_THROWS(legalized({corner(0, 0.1, 1)}), Infeasible_divisor_error,
               "add up to -1, but on a surface of genus 0 with 2 boundary curves they must add up to 8g-8+4b = 0");
  CHECK_THROWS(legalized({corner(0, 0.1, 0), corner(0, 0.6, 4)}), Infeasible_divisor_error, "order below -1");
  CHECK_THROWS(legalized({corner(0, 0.1, 1), corner(0, 0.6, 3)}), Infeasible_divisor_error,
               "on the same curve of an annulus");
  CHECK_THROWS(legalized({corner(0, 0.1, 1), corner(0, 0.6, 3), corner(0, 0.101, 2)}), Infeasible_divisor_error,
               "order 0");
  Divisor pinned{corner(0, 0.1, 1), corner(1, 0.6, 3)};
  for (Singularity& s : pinned) s.pinned = true;
  CHECK_THROWS(legalized(pinned), Infeasible_divisor_error, "control only 0 of the 1 Abel-Jacobi conditions");
  Singularity inside{{*t.faces().begin(), {0.3, 0.3, 0.4}}, -1, false, true};
  CHECK_THROWS(legalized({inside, corner(0, 0.1, 3)}), Infeasible_divisor_error, "is not on a boundary edge");
  CHECK_THROWS(legalized({corner(0, 0.1, 1), corner(0, 0.1001, 3), corner(1, 0.1, 1), corner(1, 0.5, 3)}),
               Infeasible_divisor_error, "too near each other: singularity 1 (order -1) and singularity 2 (order +1)");
  Legalization_options paper;
  paper.norm = Lattice_norm::paper;
  CHECK_THROWS(legalize_divisor(annulus.map, {corner(0, 0.1, 1), corner(1, 0.3, 3)}, paper, visitor),
               Infeasible_divisor_error, "belong to closed surfaces");

  // legal on an annulus: nothing at all, the two corners on different curves, which come to lie opposite each other, a pole
  // and a zero inside, and a pole inside with a corner
  CHECK(legalized({}).divisor.empty());
  const Divisor across{corner(0, 0.1, 1), corner(1, 0.3, 3)};
  check_legal(annulus, legalized(across), across);
  std::vector<std::vector<int>> none(2);
  const Divisor pair = random_divisor(t, none, 1, random);
  check_legal(annulus, legalized(pair), pair);
  const Divisor mixed = random_divisor(t, {{3}, {}}, 0, random);
  CHECK_EQUAL(mixed.size(), 2u);
  check_legal(annulus, legalized(mixed), mixed);
}

// ---- the flat metric

// The angle at every vertex is the one its order asks for: the boundary is straight but for the corners.
void check_angles(const Cone_metric& m)
{
  std::vector<double> angle(m.triangulation.number_of_vertices(), 0);
  for (Halfedge h : m.triangulation.halfedges())
    if (!m.triangulation.is_border(h)) angle[m.triangulation.source(h)] += m.angles[h];
  double worst = 0;
  for (Vertex v : m.triangulation.vertices())
    worst = std::max(worst, std::abs(angle[v] - (m.triangulation.is_border(v) ? pi : 2 * pi) - m.order[v] * pi / 2));
  CHECK_NEAR(worst, 0, 1e-10);
}

// The flow keeps boundary edges, and takes few steps.
Cone_metric checked_flow(const Prepared_surface& p, const Divisor& divisor)
{
  const Cone_metric m = cone_metric(p.delaunay, p.homology.cochains, divisor, nullptr, {}, visitor);
  CHECK(m.flow.reached());
  CHECK(m.flow.newton_iterations <= 8);
  CHECK_EQUAL(structural_defect(m.triangulation), "");
  check_angles(m);
  for (Edge e : p.delaunay.edges()) {
    if (!p.delaunay.is_border(e)) continue;
    CHECK(m.triangulation.is_border(e));
    CHECK(m.triangulation.length(e) <= p.delaunay.length(e));   // shorter where a corner is
  }
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    CHECK_EQUAL(m.order[m.cones[i]], divisor[i].order);
    CHECK_EQUAL(m.triangulation.is_border(m.cones[i]), divisor[i].on_boundary);
  }
  return m;
}

// Edges of a triangulation of the double from a vertex inside the surface to one inside its mirror image.
int edges_across_mirror(const Intrinsic_triangulation& t, const Intrinsic_triangulation& half)
{
  std::vector<char> mirrored(t.number_of_vertices(), true);
  for (Vertex v : half.vertices()) mirrored[v] = false;
  int crossing = 0;
  for (Edge e : t.edges()) {
    const Vertex a = t.source(t.halfedge(e)), b = t.target(t.halfedge(e));
    if (mirrored[a] != mirrored[b]) crossing += !half.is_border(mirrored[a] ? b : a);
  }
  return crossing;
}

// With singularities at vertices: the scales are those of the double, where every corner has twice the angle, if no edge of
// its triangulation crosses the mirror. Returns whether this is so.
bool check_double(const Prepared_surface& p, std::mt19937& random)
{
  const std::vector<std::vector<int>> corners(p.delaunay.number_of_boundary_curves(), std::vector<int>(random() % 4, 1));
  Divisor divisor = random_divisor(p.delaunay, corners, 1, random);
  for (Singularity& x : divisor) {
    const auto h = p.delaunay.halfedges(x.location.face);
    int k = 0;
    if (x.on_boundary)
      while (!p.delaunay.is_border(p.delaunay.opposite(h[k])) || x.location.barycentric[(k + 2) % 3] != 0) ++k;
    else
      while (k < 2 && p.delaunay.is_border(p.delaunay.source(h[k]))) ++k;
    x.location.barycentric = {0, 0, 0};
    x.location.barycentric[k] = 1;
  }
  const Mirror_double d = mirror_double(p.delaunay, p.homology.cochains);
  Divisor doubled;
  const Mesh::size_type faces = static_cast<Mesh::size_type>(p.delaunay.number_of_faces());
  for (const Singularity& x : divisor) {
    doubled.push_back({x.location, x.on_boundary ? 2 * x.order : x.order});
    const auto& b = x.location.barycentric;
    if (!x.on_boundary) doubled.push_back({{Face(faces + x.location.face.idx()), {b[0], b[2], b[1]}}, x.order});
  }
  CHECK_EQUAL(degree(doubled), 8 * d.surface.genus() - 8);
  const Cone_metric m = checked_flow(p, divisor);
  const Cone_metric of_double = cone_metric(d.surface, d.cochains, doubled, nullptr, {}, visitor);
  CHECK(of_double.flow.reached());
  if (edges_across_mirror(of_double.triangulation, p.delaunay) > 0) return false;
  double shift = 0, worst = 0;   // scales are fixed up to a common factor
  for (Vertex v : p.delaunay.vertices()) shift += of_double.u[v] - m.u[v];
  shift /= static_cast<double>(p.delaunay.number_of_vertices());
  for (Vertex v : p.delaunay.vertices()) {
    worst = std::max(worst, std::abs(of_double.u[v] - m.u[v] - shift));
    worst = std::max(worst, std::abs(of_double.u[v] - of_double.u[d.image[v]]));
  }
  CHECK_NEAR(worst, 0, 1e-9);
  const Eigen::VectorXd turning = turning_numbers(m.triangulation, m.cochains, m.angles);
  const Eigen::VectorXd doubled_turning = turning_numbers(of_double.triangulation, of_double.cochains, of_double.angles);
  for (Eigen::Index k = 0; k < turning.size(); ++k)
    CHECK_NEAR(std::remainder(doubled_turning[k] - 2 * turning[k], 2 * pi), 0, 1e-8);
  std::cout << "  double: scales differ by " << worst << std::endl;
  return true;
}

// ---- exact holonomy

// The turning changes as its derivative says when the cones and corners move.
void check_holonomy_jacobian(const Prepared_surface& p, const Divisor& divisor, std::mt19937& random)
{
  const Integer_cochains& cochains = p.homology.cochains;
  const Eigen::MatrixXd j = holonomy_jacobian(p.delaunay, cochains, divisor, {}, visitor);
  const double tiny = 1e-6 * std::sqrt(p.delaunay.area());
  Eigen::VectorXd step = Eigen::VectorXd::Zero(j.cols());
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    step[2 * i] = uniform(random, -1, 1);
    if (!divisor[i].on_boundary) step[2 * i + 1] = uniform(random, -1, 1);
    else                         CHECK(j.col(2 * i + 1).isZero() && !j.col(2 * i).isZero());
  }
  const auto turning = [&](double sign) {
    Divisor moved = divisor;
    for (std::size_t i = 0; i < divisor.size(); ++i) {
      const Surface_point& place = divisor[i].location;
      const Lifted_point at = divisor[i].on_boundary ? p.map.lift_on_boundary(place) : p.map.lift(place);
      moved[i].location = p.map.moved(at, sign * tiny * std::complex<double>(step[2 * i], step[2 * i + 1])).location;
    }
    const Cone_metric m = cone_metric(p.delaunay, cochains, moved, nullptr, {}, visitor);
    return turning_numbers(m.triangulation, m.cochains, m.angles);
  };
  const Eigen::VectorXd forward = turning(1), backward = turning(-1);
  for (Eigen::Index k = 0; k < j.rows(); ++k)
    CHECK_NEAR(std::remainder(forward[k] - backward[k], 2 * pi) / (2 * tiny), j.row(k).dot(step),
               1e-4 * (1 + (j * step).norm()));
}

void check_exact(const Prepared_surface& p, const Divisor& divisor)
{
  const Exact_cone_metric m = exact_cone_metric(p.delaunay, p.homology.cochains, divisor, {}, visitor);
  CHECK(m.reached);
  CHECK(m.max_holonomy_error <= 1e-10);
  CHECK(m.max_transition_error <= 1e-10);
  CHECK(m.history.size() <= 6);
  for (double x : m.turning) CHECK_NEAR(std::remainder(x, pi / 2), 0, 1e-10);
  check_angles(m.metric);
  std::cout << "  flow " << m.first_flow.newton_iterations << " steps, holonomy " << m.history.front() << " -> "
            << m.history.back()
            << " in " << m.history.size() - 1 << ", edges and boundary " << m.max_transition_error << std::endl;
}

} // namespace

int main()
{
  std::mt19937 random(2026);
  const std::vector<Surface_with_boundary> surfaces = surfaces_with_boundary();
  int compared = 0;
  for (const Surface_with_boundary& s : surfaces) {
    std::cout << s.name << std::endl;
    check_splits(s);
    const Prepared_surface p(s.surface);
    for (int n = 0; n < 6; ++n) compared += check_double(p, random);
    const Divisor divisor = random_divisor(p.delaunay, corners_of(s.curves), 1, random);
    check_derivative(p, divisor, random);
    check_round_trip(p);
    const Legal_divisor legal = legalize_divisor(p.map, divisor, {}, visitor);
    check_legal(p, legal, divisor);
    checked_flow(p, legal.divisor);
    check_exact(p, legal.divisor);
  }
  CHECK(compared >= 12);
  const Prepared_surface p(surfaces[3].surface);
  check_holonomy_jacobian(p, random_divisor(p.delaunay, corners_of(4), 1, random), random);
  for (double degrees : {120.0, 160.0, 179.0})
    for (int k : {0, 2, 9}) {
      const Intrinsic_triangulation rim = with_obtuse_rim(surfaces[k].surface, degrees, random);
      std::cout << surfaces[k].name << ", angles up to " << degrees << " degrees at the boundary" << std::endl;
      check_splits({"", surfaces[k].genus, surfaces[k].curves, rim});
      const Prepared_surface prepared(rim);
      CHECK(prepared.splits > 0);
      const Divisor divisor = random_divisor(prepared.delaunay, corners_of(surfaces[k].curves), 1, random);
      check_exact(prepared, legalize_divisor(prepared.map, divisor, {}, visitor).divisor);
    }
  check_feet();
  check_refusals(random);
  return Quartic_test::result();
}
