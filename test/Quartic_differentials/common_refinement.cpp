// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The common refinement of a surface with its intrinsic Delaunay triangulation: links, straightness of the flipped
// edges in space, Euler characteristic, areas, and the identity map between the two triangulations.

#include "check.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/Refinement_map.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>

#include <CGAL/boost/graph/IO/OFF.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <random>
#include <sstream>

using namespace CGAL::Quartic_differentials;
using Quartic_test::uniform;
using Complex = std::complex<double>;

namespace {

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Point_3 position(const Common_refinement& r, const Crossing& x)
{
  const Intrinsic_triangulation& a = r.input();
  const Halfedge h = first_halfedge(x.a);
  const Point_3 p = a.mesh().point(a.source(h)), q = a.mesh().point(a.target(h));
  return p + x.position_on_a() * (q - p);
}

// number of places where crossings are not in strict order along their edges
int disorder(const Common_refinement& r)
{
  int n = 0;
  for (Edge e : r.input().edges()) {
    double before = 0;
    for (const Crossing& x : r.crossings(e)) { n += !(x.position_on_c() > before); before = x.position_on_c(); }
    n += !(before < 1);
    before = 0;
    for (Crossing_id id = r.first_crossing(e); !id.is_none(); id = r[id].next) {
      n += !(r[id].position_on_a() > before);
      before = r[id].position_on_a();
    }
    n += !(before < 1);
  }
  return n;
}

// the largest relative difference between the length of a C edge and its way in space over the input's edges
double straightness_error(const Common_refinement& r, const Intrinsic_triangulation& c)
{
  double worst = 0;
  for (Edge e : c.edges()) {
    const Halfedge h = first_halfedge(e);
    Point_3 p = c.mesh().point(c.source(h));
    double length = 0;
    const auto go_to = [&](const Point_3& q) { length += std::sqrt(CGAL::squared_distance(p, q)); p = q; };
    for (const Crossing& x : r.crossings(e)) go_to(position(r, x));
    go_to(c.mesh().point(c.target(h)));
    worst = std::max(worst, std::abs(length / c.length(e) - 1));
  }
  return worst;
}

// The largest distance in space between the point at a random fraction of a C edge, mapped to A, and the point at the
// same fraction of the edge's way over the input, relative to the length of the edge.
double edge_point_error(const Common_refinement& r, const Refinement_map& map, const Intrinsic_triangulation& c)
{
  std::mt19937 random(5);
  double worst = 0;
  for (Halfedge h : c.halfedges()) {
    const double t = uniform(random, 0, 1), along = is_first_of_its_edge(h) ? t : 1 - t;
    Surface_point point{c.face(h)};
    point.barycentric[c.corner(h)] = 1 - t;
    point.barycentric[c.corner(c.next(h))] = t;

    const Edge e = c.edge(h);
    double from = 0, to = 1;
    Point_3 p = c.mesh().point(c.source(first_halfedge(e))), q = c.mesh().point(c.target(first_halfedge(e)));
    for (const Crossing& x : r.crossings(e)) {
      if (x.position_on_c() <= along) { from = x.position_on_c(); p = position(r, x); }
      else                            { to = x.position_on_c(); q = position(r, x); break; }
    }
    const Point_3 expected = p + (along - from) / (to - from) * (q - p);
    const Point_3 mapped = position_on_input(r.input(), map.to_input(point));
    worst = std::max(worst, std::sqrt(CGAL::squared_distance(expected, mapped)) / c.length(h));
  }
  return worst;
}

double area(const std::vector<Complex>& polygon)
{
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += (std::conj(polygon[i]) * polygon[(i + 1) % polygon.size()]).imag();
  return twice / 2;
}

double longest_edge(const Intrinsic_triangulation& t, Face f)
{
  const auto h = t.halfedges(f);
  return std::max({t.length(h[0]), t.length(h[1]), t.length(h[2])});
}

// largest error of the cells' areas summed over a face, relative to the square of the longest edge
template <class Face_of, class Polygon_of>
double area_error(const Refinement_cells& cells, const Intrinsic_triangulation& t,
                  Face_of face_of, Polygon_of polygon_of)
{
  std::vector<double> sum(t.number_of_faces(), 0);
  for (const Refinement_cell& cell : cells.cells()) sum[face_of(cell)] += area(polygon_of(cell));
  double worst = 0;
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    const double expected = four_times_area(t.length(h[0]), t.length(h[1]), t.length(h[2])) / 4;
    worst = std::max(worst, std::abs(sum[f] - expected) / std::pow(longest_edge(t, f), 2));
  }
  return worst;
}

Surface_point random_point(std::mt19937& random, const Intrinsic_triangulation& t)
{
  Surface_point p;
  p.face = Face(static_cast<Mesh::size_type>(random() % t.number_of_faces()));
  double sum = 0;
  for (double& b : p.barycentric) sum += b = -std::log(uniform(random, 1e-9, 1));
  if (random() % 8 == 0) { sum -= p.barycentric[0]; p.barycentric[0] = 0; }   // a point on an edge
  for (double& b : p.barycentric) b /= sum;
  return p;
}

// the distance of two points of the same face; infinite in different faces
double distance_in_face(const Intrinsic_triangulation& t, const Surface_point& p, const Surface_point& q)
{
  if (p.face != q.face) return std::numeric_limits<double>::infinity();
  const auto corner = t.unfolded(p.face);
  Complex z = 0;
  for (int k = 0; k < 3; ++k) z += (p.barycentric[k] - q.barycentric[k]) * corner[k];
  return std::abs(z);
}

struct Round_trips { double c_a_c = 0, a_c_a = 0; };

// the largest errors of n random points, relative to the longest edge of their faces. A point on an edge may come back
// on the other side of it, even in the same face where that is glued to itself: then the distance in space counts.
Round_trips round_trips(const Refinement_map& map, const Intrinsic_triangulation& a,
                        const Intrinsic_triangulation& c, int n)
{
  std::mt19937 random(7);
  Round_trips worst;
  const auto distance_in_space = [&](const Surface_point& x, const Surface_point& y)
  { return std::sqrt(CGAL::squared_distance(position_on_input(a, x), position_on_input(a, y))); };
  for (int i = 0; i < n; ++i) {
    const Surface_point p = random_point(random, c), x = map.to_input(p), p2 = map.from_input(x);
    const double c_a_c = std::min(distance_in_face(c, p, p2), distance_in_space(x, map.to_input(p2)));
    worst.c_a_c = std::max(worst.c_a_c, c_a_c / longest_edge(c, p.face));

    const Surface_point q = random_point(random, a), q2 = map.to_input(map.from_input(q));
    const double a_c_a = std::min(distance_in_face(a, q, q2), distance_in_space(q, q2));
    worst.a_c_a = std::max(worst.a_c_a, a_c_a / longest_edge(a, q.face));
  }
  return worst;
}

// every corner of a cell lies in its two faces, and no cell is the mirror image of a polygon
void check_cells(const Refinement_cells& cells, const Refinement_map& map, const Intrinsic_triangulation& a,
                 const Intrinsic_triangulation& c, std::size_t crossings)
{
  std::size_t sides = 0, astray = 0, mirrored = 0, not_congruent = 0;
  for (const Refinement_cell& cell : cells.cells()) {
    sides += cell.last_corner - cell.first_corner;
    const std::vector<Complex> in_c = map.polygon_in_c(cell), in_a = map.polygon_in_a(cell);
    double size = 0;
    for (Complex z : in_c) size = std::max(size, std::abs(z - in_c[0]));
    for (std::size_t i = 0; i < in_c.size(); ++i)
      not_congruent += std::abs(std::abs(in_c[i] - in_c[0]) - std::abs(in_a[i] - in_a[0]))
                     > 1e-9 * c.length(cells.corners()[cell.first_corner].c);
    mirrored += area(in_c) < -1e-12 * size * size || area(in_a) < -1e-12 * size * size;
    for (std::size_t i = cell.first_corner; i < cell.last_corner; ++i) {
      const Cell_corner& corner = cells.corners()[i];
      astray += c.face(corner.c) != cell.c_face || a.face(corner.a) != cell.a_face;
      if (corner.crossing.is_none()) astray += c.source(corner.c) != a.source(corner.a);
    }
  }
  CHECK_EQUAL(astray, 0u);
  CHECK_EQUAL(mirrored, 0u);
  CHECK_EQUAL(not_congruent, 0u);
  const long euler = static_cast<long>(c.number_of_vertices() + crossings) - static_cast<long>(sides / 2)
                   + static_cast<long>(cells.cells().size());
  CHECK_EQUAL(euler, 2 - 2 * a.genus());
}

// everything that must hold after Euclidean flips; returns a line of figures
std::string check_refinement(const Common_refinement& refinement, const Intrinsic_triangulation& c)
{
  const Refinement_cells cells(refinement, c);
  const Refinement_map map(cells, refinement, c);
  const Intrinsic_triangulation& a = refinement.input();
  CHECK_EQUAL(disorder(refinement), 0);
  const double straightness = straightness_error(refinement, c);
  CHECK(straightness < 1e-9);
  check_cells(cells, map, a, c, refinement.number_of_crossings());
  const double c_area = area_error(cells, c, [](const Refinement_cell& x) { return x.c_face; },
                                   [&](const Refinement_cell& x) { return map.polygon_in_c(x); });
  const double a_area = area_error(cells, a, [](const Refinement_cell& x) { return x.a_face; },
                                   [&](const Refinement_cell& x) { return map.polygon_in_a(x); });
  CHECK(c_area < 1e-10);
  CHECK(a_area < 1e-10);
  const Round_trips error = round_trips(map, a, c, 20000);
  CHECK(error.c_a_c < 1e-9);
  CHECK(error.a_c_a < 1e-9);
  CHECK(edge_point_error(refinement, map, c) < 1e-9);

  std::ostringstream figures;
  figures << refinement.number_of_crossings() << " crossings, " << cells.cells().size() << " cells; straightness "
          << straightness << ", areas " << c_area << ' ' << a_area
          << ", round trips " << error.c_a_c << ' ' << error.a_c_a;
  return figures.str();
}

void check_surface(const std::string& name, const Mesh& mesh)
{
  const Intrinsic_triangulation a(mesh);
  CHECK_EQUAL(structural_defect(a), "");

  auto start = std::chrono::steady_clock::now();
  Intrinsic_triangulation bare = a;
  const std::size_t flips = make_delaunay(bare);
  const double flip_time = seconds_since(start);

  start = std::chrono::steady_clock::now();
  Intrinsic_triangulation c = a;
  Common_refinement refinement(a);
  CHECK_EQUAL(make_delaunay(c, refinement), flips);
  const double refinement_time = seconds_since(start);
  CHECK_EQUAL(refinement.defect(c), "");
  CHECK(flips == 0 || !refinement.defect(a).empty());

  start = std::chrono::steady_clock::now();
  const Refinement_map map(Refinement_cells(refinement, c), refinement, c);
  const double map_time = seconds_since(start);

  const std::string figures = check_refinement(refinement, c);
  std::cout << name << ": " << flips << " flips, " << figures << "; flips alone " << flip_time
            << " s, with refinement " << refinement_time << " s, the map " << map_time << " s" << std::endl;
}

// nothing has been flipped yet: every cell is a face, every point stays where it is
void check_identity(const Mesh& mesh)
{
  const Intrinsic_triangulation a(mesh);
  const Common_refinement refinement(a);
  CHECK_EQUAL(refinement.defect(a), "");
  CHECK_EQUAL(refinement.number_of_crossings(), 0u);
  const Refinement_cells cells(refinement, a);
  CHECK_EQUAL(cells.cells().size(), a.number_of_faces());
  const Round_trips error = round_trips(Refinement_map(cells, refinement, a), a, a, 100);
  CHECK(error.c_a_c < 1e-13);
}

// Ptolemy flips, for scale factors that change much from vertex to vertex
void check_ptolemy(const Mesh& mesh, double amplitude)
{
  const Intrinsic_triangulation a(mesh);
  Intrinsic_triangulation c = a;
  Common_refinement refinement(a);
  make_delaunay(c, refinement);
  std::mt19937 random(3);
  std::vector<double> u(a.number_of_vertices());
  for (double& x : u) x = uniform(random, -amplitude, amplitude);
  const std::size_t flips = make_ideal_delaunay(c, u, refinement);
  CHECK(flips > 0);
  CHECK_EQUAL(refinement.defect(c), "");
  CHECK_EQUAL(disorder(refinement), 0);
}

// whether the quadrilateral round e is strictly convex, so that its other diagonal is a straight edge too
bool is_convex(const Intrinsic_triangulation& t, Edge e)
{
  const std::vector<double> angle = corner_angles(t, t.lengths());
  const Halfedge h = first_halfedge(e), o = t.opposite(h);
  return std::max(angle[h] + angle[t.next(o)], angle[o] + angle[t.next(h)]) < 3.1;
}

// Random flips away from Delaunay: many crossings on an edge, faces glued to themselves, corners at the same vertex.
void check_wild_flips(const Mesh& mesh, int n, bool ptolemy)
{
  const Intrinsic_triangulation a(mesh);
  Intrinsic_triangulation c = a;
  Common_refinement refinement(a);
  const double longest = 20 * std::sqrt(a.area() / a.number_of_faces());
  std::mt19937 random(11);
  int flips = 0, self_glued = 0;
  for (int i = 0; i < n; ++i) {
    const Edge edge(static_cast<Mesh::size_type>(random() % a.number_of_edges()));
    const Halfedge h = first_halfedge(edge), o = c.opposite(h);
    if (c.face(h) == c.face(o) || !(ptolemy || is_convex(c, edge))) continue;
    const double e = c.length(h), jk = c.length(c.next(h)), ki = c.length(c.prev(h)),
                 il = c.length(c.next(o)), lj = c.length(c.prev(o));
    const double f = ptolemy ? (jk * il + ki * lj) / e : euclidean_diagonal(e, jk, ki, il, lj);
    if (f > longest) continue;
    // seen from either side, which must not matter
    const Edge_flip flip = c.flip_of(c.edge(random() % 2 ? h : o), f, ptolemy);
    refinement.before_flip(c, flip);
    c.flip(flip);
    ++flips;
    for (Halfedge x : {h, o}) self_glued += c.opposite(c.next(x)) == c.prev(x);
    CHECK_EQUAL(refinement.defect(c), "");
  }
  CHECK(flips > n / 10);
  std::string figures = std::to_string(refinement.number_of_crossings()) + " crossings";
  if (!ptolemy) figures = check_refinement(refinement, c);
  std::cout << (ptolemy ? "Ptolemy: " : "wild: ") << flips << " flips, " << self_glued << " faces glued to themselves, "
            << figures << std::endl;

  const std::size_t crossings = refinement.number_of_crossings();
  make_ideal_delaunay(c, std::vector<double>(a.number_of_vertices(), 0.0), refinement);
  CHECK_EQUAL(refinement.defect(c), "");
  CHECK(refinement.number_of_crossings() < crossings);
}

Mesh tetrahedron()
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(1, 0, 0)),
               c = mesh.add_vertex(Point_3(0, 1.1, 0)), d = mesh.add_vertex(Point_3(0.2, 0.1, 1));
  mesh.add_face(a, c, b); mesh.add_face(a, b, d); mesh.add_face(b, c, d); mesh.add_face(c, a, d);
  return mesh;
}

} // namespace

int main()
{
  check_identity(Quartic_test::jittered_torus(6, 7, 0.3, 0, 1));
  check_surface("torus 40 x 20", Quartic_test::jittered_torus(40, 20, 0.45, 0, 1));
  check_surface("torus 12 x 90, long cells", Quartic_test::jittered_torus(12, 90, 0.3, 0, 2));
  check_surface("torus 24 x 30, twisted", Quartic_test::jittered_torus(24, 30, 0.2, 4, 3));
  check_surface("sphere", Quartic_test::jittered_sphere(4, 0.5, 1, 4));
  check_surface("long ellipsoid", Quartic_test::jittered_sphere(4, 0.3, 12, 5));
  check_surface("tetrahedron", tetrahedron());

  check_ptolemy(Quartic_test::jittered_torus(24, 30, 0.2, 4, 3), 3);
  check_ptolemy(Quartic_test::jittered_sphere(4, 0.5, 1, 4), 3);
  for (bool ptolemy : {false, true}) {
    check_wild_flips(tetrahedron(), 300, ptolemy);
    check_wild_flips(Quartic_test::jittered_torus(3, 3, 0.1, 0, 6), 300, ptolemy);
  }

  const std::string folder = Quartic_test::environment("QUARTIC_TEST_MESHES");
  if (!folder.empty())
    for (const char* name : {"spot_5k8", "amphora_20k", "buddha_20k", "neptune_30k"}) {
      Mesh mesh;
      CHECK(CGAL::IO::read_OFF(folder + "/" + name + ".off", mesh));
      check_surface(name, mesh);
    }
  return Quartic_test::result();
}
