// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations with boundary: structure, Gauss-Bonnet, flips, splits of boundary edges, straight lines that are reflected,
// distances; and steps 1 and 2 on them, compared with those on the double.

#include "check.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <Eigen/Dense>

#include <set>

using namespace Quartic_test;

namespace {

using Complex = std::complex<double>;
const double pi = CGAL_PI;

double largest(const Eigen::VectorXd& x) { return x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff(); }

double sum(const std::vector<double>& x)
{
  double result = 0;
  for (double y : x) result += y;
  return result;
}

// Every boundary edge is on one curve, whose halfedges follow each other; every boundary vertex has one fan of faces.
void check_boundary(const Intrinsic_triangulation& t)
{
  std::set<Edge> seen;
  std::size_t faces_at_vertices = 0;
  for (const std::vector<Halfedge>& curve : t.boundary_curves())
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Halfedge h = curve[i], next = curve[(i + 1) % curve.size()];
      CHECK(seen.insert(t.edge(h)).second);
      CHECK(!t.is_border(h) && t.is_border(t.opposite(h)) && t.is_border(t.edge(h)));
      CHECK(t.target(h) == t.source(next) && t.next_on_boundary(h) == next && t.previous_on_boundary(next) == h);
      CHECK(t.is_border(t.source(h)) && t.halfedge_from(t.source(next)) == next);
    }
  for (Edge e : t.edges()) CHECK_EQUAL(t.is_border(e), seen.count(e) > 0);
  for (Vertex v : t.vertices()) {
    std::size_t borders = 0;
    Halfedge h = t.halfedge_from(v);
    do {
      CHECK(t.source(h) == v);
      t.is_border(h) ? ++borders : ++faces_at_vertices;
      h = t.next_around_source(h);
    } while (h != t.halfedge_from(v));
    CHECK_EQUAL(borders, t.is_border(v) ? 1u : 0u);
  }
  CHECK_EQUAL(faces_at_vertices, 3 * t.number_of_faces());
}

void check_structure(const Surface_with_boundary& s)
{
  const Intrinsic_triangulation& t = s.surface;
  CHECK_EQUAL(structural_defect(t), "");
  check_surface(t);
  CHECK_EQUAL(t.number_of_boundary_curves(), s.curves);
  CHECK_EQUAL(t.genus(), s.genus);
  CHECK(t.has_boundary());
  check_boundary(t);
  CHECK_NEAR(sum(curvatures(t, corner_angles(t, t.lengths()))), 2 * pi * (2 - 2 * s.genus - s.curves), 1e-9);

  const Intrinsic_triangulation glued(glued_triangles(t));
  CHECK_EQUAL(glued.number_of_edges(), t.number_of_edges());
  CHECK_EQUAL(glued.number_of_boundary_curves(), s.curves);
  check_boundary(glued);
}

// Flips leave the boundary as it is.
void check_flips(Intrinsic_triangulation t)
{
  const std::vector<double> before = t.lengths();
  const double area = t.area();
  make_delaunay(t);
  CHECK_EQUAL(structural_defect(t), "");
  check_boundary(t);
  CHECK_NEAR(t.area(), area, 1e-10 * area);
  for (Edge e : t.edges())
    if (t.is_border(e)) CHECK_EQUAL(t.length(e), before[e]);
}

bool is_closed(const Intrinsic_triangulation& t, const Integer_cochains& cochains)
{
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    if (!(cochains.row(h[0]) + cochains.row(h[1]) + cochains.row(h[2])).isZero()) return false;
  }
  return true;
}

// A split changes neither the surface nor the turning of paths: the new vertex is a straight boundary vertex.
void check_splits(Intrinsic_triangulation t, std::mt19937& random)
{
  const Relative_homology_basis basis = relative_homology_basis(t);
  Integer_cochains cochains = basis.cochains;
  std::vector<Halfedge> ends;   // where arcs go out
  for (const std::vector<Halfedge>& path : basis.paths)
    if (t.is_border(t.opposite(path.back()))) ends.push_back(path.back());
  const Eigen::VectorXd turning = turning_numbers(t, cochains, corner_angles(t, t.lengths()));
  const std::vector<double> before = curvatures(t, corner_angles(t, t.lengths()));
  const double area = t.area();
  for (std::size_t n = 0; n < 30; ++n) {
    const auto curves = t.boundary_curves();
    const std::vector<Halfedge>& curve = curves[random() % curves.size()];
    const Halfedge h = n < ends.size() ? ends[n] : curve[random() % curve.size()];
    const Vertex from = t.source(h), to = t.target(h);
    const double fraction = uniform(random, 0.2, 0.8), length = t.length(h);
    const auto split = t.split_boundary_edge(h, fraction);
    cochains.after_boundary_split(t, split);
    CHECK(t.source(split.first) == from && t.target(split.first) == split.vertex);
    CHECK(t.source(split.second) == split.vertex && t.target(split.second) == to);
    CHECK(t.source(split.spoke) == split.vertex && t.face(split.spoke) == t.face(split.first));
    CHECK_NEAR(t.length(split.first), fraction * length, 1e-14 * length);
    CHECK_NEAR(t.length(split.second), (1 - fraction) * length, 1e-14 * length);
  }
  CHECK_EQUAL(structural_defect(t), "");
  check_boundary(t);
  CHECK_NEAR(t.area(), area, 1e-10 * area);
  CHECK(is_closed(t, cochains));
  const std::vector<double> after = curvatures(t, corner_angles(t, t.lengths()));
  for (Vertex v : t.vertices()) CHECK_NEAR(after[v], v.idx() < before.size() ? before[v] : 0.0, 1e-9);
  const Eigen::VectorXd change = turning_numbers(t, cochains, corner_angles(t, t.lengths())) - turning;
  for (double x : change) CHECK_NEAR(std::remainder(x, 2 * pi), 0, 1e-9);
}

// Small gluings: a triangle, a disk with one boundary edge that is a loop, and what is not a surface.
void check_small_gluings()
{
  const std::array<int, 2> nothing{-1, -1};
  const Intrinsic_triangulation triangle(Glued_triangles{{{0, 1, 2}}, {{nothing, nothing, nothing}}, {{3, 4, 5}}});
  check_structure({"triangle", 0, 1, triangle});

  Intrinsic_triangulation cone(Glued_triangles{{{0, 0, 1}}, {{nothing, {0, 2}, {0, 1}}}, {{1, 2, 2}}});
  check_structure({"cone", 0, 1, cone});
  const auto split = cone.split_boundary_edge(cone.boundary_curves()[0][0], 0.25);
  CHECK_EQUAL(structural_defect(cone), "");
  CHECK_EQUAL(cone.boundary_curves()[0].size(), 2u);
  CHECK_EQUAL(cone.length(split.second), 0.75);
  check_boundary(cone);

  const auto refused = [&](std::array<std::array<int, 2>, 3> first, std::array<int, 3> second, const std::string& why) {
    CHECK_THROWS(Intrinsic_triangulation(Glued_triangles{{{0, 1, 2}, second}, {first, {nothing, nothing, nothing}},
                                                         {{1, 1, 1}, {1, 1, 1}}}), Unusable_surface_error, why);
  };
  refused({nothing, nothing, nothing}, {0, 3, 4}, "the triangles at vertex 0 form more than one fan");
  refused({nothing, nothing, {-1, 0}}, {3, 4, 5}, "edge 2 of triangle 0 is glued to something that does not exist");
  refused({nothing, nothing, {1, 0}}, {0, 2, 4}, "edge 2 of triangle 0 is not glued to exactly one other edge");
  const Intrinsic_triangulation two(Glued_triangles{{{0, 1, 2}, {3, 4, 5}}, {{nothing, nothing, nothing},
                                    {nothing, nothing, nothing}}, {{1, 1, 1}, {1, 1, 1}}});
  CHECK_THROWS(check_surface(two), Unusable_surface_error, "not connected");
}

// A rectangle, in which straight lines that are reflected are known.
class Billiards
{
public:
  Billiards() : m_t(rectangle()) {}

  void check_walk(std::mt19937& random) const
  {
    const Face f(random() % 2);
    const double a = uniform(random, 0.05, 0.45), b = uniform(random, 0.05, 0.45);
    const Surface_point start{f, {1 - a - b, a, b}};
    const Complex way = std::polar(uniform(random, 0, 20), uniform(random, -pi, pi)), axis = this->axis(f);
    const auto end = internal::walk(m_t, start, way / axis, [](const Surface_point&, const Surface_point&) {});
    const Complex z = place(start) + way;
    CHECK_NEAR(std::abs(place(end.point) - Complex(folded(z.real(), width), folded(z.imag(), height))), 0, 1e-11);
    // the direction of the line at its end
    const Complex last(reversed(z.real(), width) * way.real(), reversed(z.imag(), height) * way.imag());
    CHECK_NEAR(std::abs(way / axis * end.rotation * this->axis(end.point.face) - last), 0, 1e-10);
  }

private:
  static constexpr double width = 2, height = 1;

  static Intrinsic_triangulation rectangle()
  {
    Mesh mesh;
    const Vertex a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(width, 0, 0));
    const Vertex c = mesh.add_vertex(Point_3(width, height, 0)), d = mesh.add_vertex(Point_3(0, height, 0));
    mesh.add_face(a, b, c);
    mesh.add_face(a, c, d);
    return Intrinsic_triangulation(mesh);
  }
  static double folded(double x, double period)
  {
    const double y = std::fmod(std::fmod(x, 2 * period) + 2 * period, 2 * period);
    return y > period ? 2 * period - y : y;
  }
  static double reversed(double x, double period)
  {
    return std::fmod(std::fmod(x, 2 * period) + 2 * period, 2 * period) > period ? -1 : 1;
  }
  Complex corner(Halfedge h) const
  {
    const Point_3& p = m_t.mesh().point(m_t.source(h));
    return {p.x(), p.y()};
  }
  // the direction of the first axis of a face's frame
  Complex axis(Face f) const
  {
    const Halfedge h = m_t.halfedge(f);
    const Complex e = corner(m_t.next(h)) - corner(h);
    return e / std::abs(e);
  }
  Complex place(const Surface_point& p) const
  {
    const auto h = m_t.halfedges(p.face);
    return internal::point_in_frame({corner(h[0]), corner(h[1]), corner(h[2])}, p.barycentric);
  }

  Intrinsic_triangulation m_t;
};

// Sliding all the way round a boundary curve comes back; distances do not jump over holes.
void check_slides_and_distances()
{
  const Intrinsic_triangulation t(plate(1, 14));
  const auto nothing = [](const Surface_point&, const Surface_point&) {};
  for (const std::vector<Halfedge>& curve : t.boundary_curves()) {
    double length = 0;
    for (Halfedge h : curve) length += t.length(h);
    const Surface_point p = on_edge(t, curve[0], 0.3);
    for (double way : {length, -length, 0.37 * length, -0.61 * length}) {
      const Surface_point q = internal::slide(t, p, way, nothing);
      const Surface_point expected = on_curve(t, curve, 0);   // the curve begins at its first edge
      const Surface_point there = internal::slide(t, expected, 0.3 * t.length(curve[0]) + way, nothing);
      CHECK_EQUAL(q.face, there.face);
      CHECK_NEAR(q.barycentric[0], there.barycentric[0], 1e-9);
      CHECK_NEAR(q.barycentric[1], there.barycentric[1], 1e-9);
      if (std::abs(std::abs(way) - length) < 1e-12) CHECK_EQUAL(q.face, p.face);
    }
  }

  // the curve of the hole, with two corners on both sides of a vertex, and a singularity near the boundary
  const auto curves = t.boundary_curves();
  const std::vector<Halfedge>& curve = curves[0].size() < curves[1].size() ? curves[0] : curves[1];
  const double size = std::sqrt(t.area());
  const Divisor corners{{on_edge(t, curve[1], 0.1), 1, false, true}, {on_edge(t, curve[0], 0.9), -1, false, true}};
  const double way = 0.1 * (t.length(curve[0]) + t.length(curve[1]));
  CHECK_NEAR(nearest_singularities(t, corners, 2 * way).distance, way, 1e-12);
  CHECK(collision(t, corners, 1.1 * way / size).find("singularity 1 (order +1) and singularity 2") == 0);
  CHECK_EQUAL(collision(t, corners, 0.9 * way / size), "");

  Surface_point near = on_edge(t, curve[0], 0.5);
  const int apex = (t.corner(curve[0]) + 2) % 3;
  const double height = four_times_area(t.length(curve[0]), t.length(t.next(curve[0])), t.length(t.prev(curve[0])))
                      / (2 * t.length(curve[0])), depth = 0.01 * size;
  for (double& b : near.barycentric) b *= 1 - depth / height;
  near.barycentric[apex] = depth / height;
  CHECK(collision(t, {{near, 1}}, 0.021).find("and the boundary") != std::string::npos);
  CHECK_EQUAL(collision(t, {{near, 1}}, 0.019), "");

  // straight lines between the two sides of the hole do not exist
  const auto beside = [&](double x) {
    Vertex best = *t.vertices().begin();
    for (Vertex v : t.vertices())
      if (CGAL::squared_distance(t.mesh().point(v), Point_3(x, 0.01, 0))
          < CGAL::squared_distance(t.mesh().point(best), Point_3(x, 0.01, 0))) best = v;
    Surface_point p = at_vertex(t, best);
    return internal::moved_inside(p, 0.05);
  };
  CHECK(std::isinf(nearest_singularities(t, {beside(0.6), beside(-0.6)}, 1.6).distance));
  CHECK_NEAR(nearest_singularities(t, {beside(0.6), beside(0.8)}, 1.6).distance, 0.2, 0.1);
}

// ---- steps 1 and 2

// A path leaves one face after the other; loops close up, and an arc comes in through one boundary curve and goes out
// through another.
void check_paths(const Surface_with_boundary& s)
{
  const Intrinsic_triangulation& t = s.surface;
  const Relative_homology_basis basis = relative_homology_basis(t);
  const std::size_t loops = 2 * s.genus, arcs = s.curves - 1;
  CHECK_EQUAL(basis.paths.size(), loops + arcs);
  CHECK_EQUAL(basis.cochains.size(), static_cast<int>(loops + arcs));
  CHECK(is_closed(t, basis.cochains));
  for (std::size_t k = 0; k < basis.paths.size(); ++k) {
    const std::vector<Halfedge>& path = basis.paths[k];
    for (std::size_t i = 0; i + 1 < path.size(); ++i) CHECK(t.face(t.opposite(path[i])) == t.face(path[i + 1]));
    if (k < loops) CHECK(t.face(t.opposite(path.back())) == t.face(path.front()));
    else           CHECK(t.is_border(path.front()) && t.is_border(t.opposite(path.back())));
  }

  // the loops are a basis of the closed surface with the holes filled: unimodular intersection numbers
  Integer_cochains of_loops(t.number_of_edges(), static_cast<int>(loops));
  for (std::size_t k = 0; k < loops; ++k)
    for (Halfedge h : basis.paths[k]) of_loops.add(h, static_cast<int>(k), 1);
  CHECK_EQUAL(std::lround(intersection_numbers(t, of_loops).cast<double>().determinant()), 1);

  // the boundary curves meet no loop, and the arcs once at their ends: an identity matrix beside a column of -1
  const auto curves = t.boundary_curves();
  Eigen::MatrixXi crossings = Eigen::MatrixXi::Zero(basis.cochains.size(), s.curves);
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (Halfedge h : curves[c]) crossings.col(c) += basis.cochains.row(h).transpose();
  CHECK(crossings.topRows(loops).isZero());
  CHECK(crossings.rowwise().sum().isZero());
  CHECK(crossings.cwiseAbs().bottomRows(arcs).rowwise().sum() == Eigen::VectorXi::Constant(arcs, 2));
  if (arcs > 0)
    CHECK_EQUAL(Eigen::FullPivLU<Eigen::MatrixXd>(crossings.cast<double>()).rank(), static_cast<Eigen::Index>(arcs));
}

// A square with two holes whose borders are reached from the rim in many ways of the same length.
Intrinsic_triangulation square_frame()
{
  const int n = 11;
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.add_vertex(Point_3(i, j, 0));
  const auto vertex = [](int i, int j) { return Vertex(static_cast<Mesh::size_type>(j * (n + 1) + i)); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (j >= 4 && j < 7 && ((i >= 2 && i < 5) || (i >= 6 && i < 9))) continue;
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  Mesh packed;   // without the vertices inside the holes
  std::vector<Vertex> copy(mesh.number_of_vertices());
  for (Vertex v : mesh.vertices())
    if (!mesh.is_isolated(v)) copy[v] = packed.add_vertex(mesh.point(v));
  for (Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    packed.add_face(copy[mesh.source(h)], copy[mesh.target(h)], copy[mesh.target(mesh.next(h))]);
  }
  return Intrinsic_triangulation(packed);
}

// The harmonic forms with natural boundary conditions are those of the double in symmetric classes.
void check_forms(const Surface_with_boundary& s)
{
  const Prepared_surface p(s.surface);
  CHECK(is_closed(p.delaunay, p.homology.cochains));
  CHECK(p.forms.residual < 1e-11);
  const Mirror_double d = mirror_double(p.delaunay, p.homology.cochains);
  CHECK_EQUAL(structural_defect(d.surface), "");
  CHECK_EQUAL(d.surface.genus(), 2 * s.genus + s.curves - 1);
  CHECK(!d.surface.has_boundary());
  CHECK(is_closed(d.surface, d.cochains));
  if (p.forms.size() == 0) return;   // a disk

  const std::vector<double> weights = cotangent_weights(d.surface, d.surface.lengths());
  Laplacian_solver laplacian;
  laplacian.factorize(d.surface, weights);
  const Harmonic_1_forms forms = harmonic_1_forms(d.surface, d.cochains, weights, laplacian);
  double difference = 0, gradient = 0;
  for (Face f : p.delaunay.faces()) {
    const auto here = p.delaunay.halfedges(f), there = d.surface.halfedges(f);
    for (int k = 0; k < 3; ++k)
      difference = std::max(difference, largest((p.forms.row(here[k]) - forms.row(there[k])).transpose()));
    gradient = std::max(gradient, (gradients(p.delaunay, p.forms, f) - gradients(d.surface, forms, f)).cwiseAbs().maxCoeff());
  }
  CHECK_NEAR(difference, 0, 1e-10);
  CHECK_NEAR(gradient, 0, 1e-8);
  CHECK((forms.dirichlet - 2 * p.forms.dirichlet).norm() <= 1e-9 * (1 + forms.dirichlet.norm()));
  CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(p.forms.dirichlet).eigenvalues().minCoeff() > 1e-3);

  const auto turning_on = [](const Intrinsic_triangulation& t, const Integer_cochains& cochains) {
    return turning_numbers(t, cochains, corner_angles(t, t.lengths()));
  };
  const Eigen::VectorXd turning = turning_on(p.delaunay, p.homology.cochains);
  const Eigen::VectorXd of_double = turning_on(d.surface, d.cochains);
  for (Eigen::Index k = 0; k < turning.size(); ++k)
    CHECK_NEAR(std::remainder(of_double[k] - 2 * turning[k], 2 * pi), 0, 1e-8);
}

// In the plane: the arc between two sides of a rectangle turns by nothing or by a right angle, and what is asked of all arcs
// holds. A frame that is turned on a part of the boundary shows.
void check_directions()
{
  Mesh mesh;
  const auto vertex = [&](double x, double y) { return mesh.add_vertex(Point_3(x, y, 0)); };
  const Vertex a = vertex(0, 0), b = vertex(3, 0), c = vertex(3, 2), d = vertex(0, 2);
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  const Intrinsic_triangulation rectangle(mesh);
  CHECK_NEAR(max_transition_error(rectangle, corner_angles(rectangle, rectangle.lengths())), 0, 1e-14);
  mesh.point(c) = Point_3(3.2, 2, 0);
  const Intrinsic_triangulation leaning(mesh);
  CHECK_NEAR(max_transition_error(leaning, corner_angles(leaning, leaning.lengths())), std::atan(0.1), 1e-14);
}

// Steps 1 and 2 take any surface; what asks for a closed one says so.
void check_refusals()
{
  const Intrinsic_triangulation t(plate(1, 12));
  Visitor visitor;
  CHECK_THROWS(homology_basis(t), Unusable_surface_error, "has a boundary");
  const Riemann_surface s = riemann_surface(t, visitor);
  CHECK_EQUAL(s.forms.size(), 1);
  CHECK_EQUAL(s.periods.pi.size(), 0);
  for (double radius : {0.26, 0.32, 0.9})
    CHECK_THROWS(with_disks_cut_out(bumpy_sphere(3), 6, radius), Unusable_surface_error, "take a smaller radius");
}

} // namespace

int main()
{
  std::mt19937 random(2026);
  const std::vector<Surface_with_boundary> surfaces = surfaces_with_boundary();
  for (const Surface_with_boundary& s : surfaces) {
    std::cout << s.name << ": " << s.surface.number_of_faces() << " faces" << std::endl;
    check_structure(s);
    check_splits(s.surface, random);
    check_flips(s.surface);
    check_paths(s);
    check_forms(s);
  }
  for (double degrees : {120.0, 179.0}) {
    const Intrinsic_triangulation rim = with_obtuse_rim(surfaces[3].surface, degrees, random);
    check_structure({"plate with obtuse rim", 0, 4, rim});
    check_forms({"plate with obtuse rim", 0, 4, rim});
    check_flips(rim);
  }
  check_flips(Intrinsic_triangulation(with_disks_cut_out(jittered_torus(40, 20, 0.3, 3, 2), 2, 0.1)));
  check_structure({"square frame", 0, 3, square_frame()});
  check_paths({"square frame", 0, 3, square_frame()});
  check_small_gluings();
  const Billiards billiards;
  for (int n = 0; n < 300; ++n) billiards.check_walk(random);
  check_slides_and_distances();
  check_directions();
  check_refusals();
  return Quartic_test::result();
}
