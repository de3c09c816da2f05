// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Polylines of the plane on the input: the arcs of the T-mesh, random lines, loops round vertices, lines through
// vertices and along edges, closed lines on a torus.

#include "check.h"
#include "exact_charts.h"
#include "named_surfaces.h"
#include "own_input.h"

#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/pull_back.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <iostream>
#include <optional>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using Quartic_test::own_input;
using namespace Quartic_test;

namespace {

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

std::complex<double> difference(Grid_vector a, Grid_vector b)
{
  return {static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)};
}

bool same_chart(const Pulled_back_arc& a, const Pulled_back_arc& b)
{
  return a.last_face == b.last_face && a.to_last_chart.rotation == b.to_last_chart.rotation
      && a.to_last_chart.translation == b.to_last_chart.translation;
}

/// a random grid point well inside a face
Grid_vector point_inside(const Quartic_differential& q, Face f, std::mt19937& random)
{
  std::array<double, 3> b;
  for (double& x : b) x = uniform(random, 0.1, 1);
  const double sum = b[0] + b[1] + b[2];
  return nearest_grid_point(q, q.chart({f, {b[0] / sum, b[1] / sum, b[2] / sum}}));
}

Grid_vector random_vector(double length, std::mt19937& random)
{
  const std::complex<double> w = std::polar(length, uniform(random, 0, 2 * CGAL_PI));
  return {std::llround(w.real()), std::llround(w.imag())};
}

/// a sample surface with its differential
struct Surface
{
  Intrinsic_triangulation input;
  Refined_surface         refined;
  T_mesh                  t_mesh;
  double                  size, flat_size;   ///< roots of the areas: in space, and in the plane in grid units

  const Quartic_differential& q() const { return refined.differential; }
  Point_3 position(const Surface_point& p) const { return position_on_input(input, p); }
  Point_3 position(Vertex v) const { return q().triangulation.mesh().point(v); }
  Face random_face(std::mt19937& random) const
  { return Face(static_cast<Mesh::size_type>(random() % q().triangulation.number_of_faces())); }
};

std::optional<Surface> computed(const Intrinsic_triangulation& input)
{
  Visitor quiet;
  Quartic_differential_result result;
  quartic_differential(input, std::nullopt, {}, quiet, result);
  if (!result.refined) return std::nullopt;
  return Surface{input, *result.refined, *result.t_mesh, std::sqrt(input.area()),
                 std::sqrt(static_cast<double>(result.refined->differential.doubled_area()) / 2)};
}

// T-mesh

/// the same surface on the grid of a T-mesh
Refined_surface doubled(Refined_surface refined)
{
  Quartic_differential& q = refined.differential;
  ++q.grid_exponent;
  for (Grid_vector& z : q.corner) z = z + z;
  for (Transition& t : q.transition) t.translation = t.translation + t.translation;
  return refined;
}

/// Every arc is a straight line: it is the same polyline in space, whoever follows it.
double check_arcs(const Surface& s)
{
  std::ostringstream out;
  write_t_mesh_json(out, s.t_mesh, s.q(), "refined");
  const nlohmann::json file = nlohmann::json::parse(out.str());
  const Refined_surface refined = doubled(s.refined);
  double farthest = 0;
  for (std::size_t a = 0; a < s.t_mesh.arcs.size(); ++a) {
    const T_mesh::Arc& arc = s.t_mesh.arcs[a];
    const Chart_segment& first = arc.path.front();
    const Grid_vector end = first.from + rotated({arc.length, 0}, first.direction);
    const Pulled_back_arc line = pull_back(refined, first.face, {first.from, end});
    const nlohmann::json& polyline = file["arcs"][a]["polyline"];
    CHECK_EQUAL(line.points.size(), polyline.size());
    if (line.points.size() != polyline.size()) continue;
    for (std::size_t k = 0; k < polyline.size(); ++k)
      farthest = std::max(farthest, distance(s.position(line.points[k]),
                                             Point_3(polyline[k][0], polyline[k][1], polyline[k][2])));
    if (line.last_face == arc.path.back().face) CHECK(line.to_last_chart(end) == arc.path.back().to);
  }
  CHECK(farthest < 1e-12 * s.size);
  return farthest / s.size;
}

// Random lines

/// a point in the coordinates of another face of the input that holds it, and the weight that is left over
std::pair<std::array<double, 3>, double> seen_in(const Intrinsic_triangulation& input, Face f, const Surface_point& p)
{
  const auto here = input.halfedges(f), there = input.halfedges(p.face);
  std::array<double, 3> result{};
  double left = 1;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c)
      if (input.source(here[k]) == input.source(there[c])) {
        result[k] = p.barycentric[c];
        left -= p.barycentric[c];
      }
  return {result, left};
}

/// the place in the plane of a point of an input face, in the chart of a part of that face, in grid units
std::complex<double> in_plane(const Refined_surface& r, Face part, const std::array<double, 3>& in_input)
{
  std::array<std::complex<double>, 3> corner;
  std::complex<double> z = 0;
  const auto h = r.differential.triangulation.halfedges(part);
  for (int k = 0; k < 3; ++k) corner[k] = {r.input_corner[h[k]][1], r.input_corner[h[k]][2]};
  const std::array<double, 3> b = internal::barycentric(corner, {in_input[1], in_input[2]});
  for (int k = 0; k < 3; ++k) z += b[k] * difference({}, r.differential.corner[h[k]]);
  return z;
}

/// Every piece lies in one face; its length in the plane is measured with the other point map.
double length_in_plane(const Surface& s, const std::vector<Surface_point>& points)
{
  double length = 0, left_over = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const std::array<double, 3>& from = points[k].barycentric;
    const auto [to, outside] = seen_in(s.input, points[k].face, points[k + 1]);
    left_over = std::max(left_over, std::abs(outside));
    Surface_point middle{points[k].face, {}};
    for (int c = 0; c < 3; ++c) middle.barycentric[c] = (from[c] + to[c]) / 2;
    const Face part = s.refined.from_input(middle).face;
    length += std::abs(in_plane(s.refined, part, to) - in_plane(s.refined, part, from));
  }
  CHECK(left_over < 1e-12);
  return length;
}

/// where the line ends in the plane is where its last point on the input is, by the other point map
double error_at_end(const Surface& s, const Pulled_back_arc& line, Grid_vector end)
{
  const auto place = in_plane(s.refined, line.last_face, line.points.back().barycentric);
  return std::abs(place - difference({}, line.to_last_chart(end)));
}

double check_random_lines(const Surface& s, std::mt19937& random)
{
  double worst = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Face f = s.random_face(random);
    const Grid_vector from = point_inside(s.q(), f, random);
    const Grid_vector run = random_vector(uniform(random, 0, 3) * s.flat_size, random), to = from + run;
    const Pulled_back_arc line = pull_back(s.refined, f, {from, to});
    CHECK(line.points.front().face == s.refined.input_face[f]);
    CHECK(line.points.back().face == s.refined.input_face[line.last_face]);
    worst = std::max({worst, error_at_end(s, line, to) / s.flat_size,
                      std::abs(length_in_plane(s, line.points) - std::abs(difference({}, run))) / s.flat_size});

    const Grid_vector end = line.to_last_chart(to);
    const Pulled_back_arc back = pull_back(s.refined, line.last_face, {end, line.to_last_chart(from)});
    CHECK(back.last_face == f && line.to_last_chart.then(back.to_last_chart).is_identity());
    CHECK_EQUAL(back.points.size(), line.points.size());
    if (back.points.size() != line.points.size()) continue;
    for (std::size_t k = 0; k < line.points.size(); ++k)
      worst = std::max(worst, distance(s.position(line.points[k]), s.position(back.points.rbegin()[k])) / s.size);
  }
  CHECK(worst < 1e-9);
  return worst;
}

// Vertices

/// a vector about halfway between the sides of the corner at source(h) in face(h), shorter than the distance of the
/// vertex from the edges round it
Grid_vector towards_the_middle(const Quartic_differential& q, Halfedge h)
{
  const Intrinsic_triangulation& t = q.triangulation;
  double nearest = 1e300;
  Halfedge k = h;
  do {
    const Grid_vector a = q.corner[t.next(k)], b = q.corner[t.prev(k)];
    nearest = std::min(nearest, static_cast<double>(doubled_area(q.corner[k], a, b)) / std::abs(difference(a, b)));
    k = t.next_around_source(k);
  } while (k != h);
  const std::complex<double> right = difference(q.corner[h], q.corner[t.next(h)]);
  const std::complex<double> left = difference(q.corner[h], q.corner[t.prev(h)]);
  const double direction = std::arg(right) + 0.501 * std::arg(left / right);   // not along a diagonal of a square
  const std::complex<double> w = std::polar(nearest / 2, direction);
  return {std::llround(w.real()), std::llround(w.imag())};
}

/// Once round a vertex the chart turns back by its order; straight through it is the way round it on the right; a line
/// that starts there turns to its direction the short way round.
void check_vertices(const Refined_surface& r)
{
  const Quartic_differential& q = r.differential;
  const Intrinsic_triangulation& t = q.triangulation;
  for (Vertex v : t.vertices()) {
    const Halfedge h = t.halfedge_from(v);
    const Grid_vector c = q.corner[h], w = towards_the_middle(q, h);
    std::vector<Grid_vector> loop;
    for (int quarter = 0; quarter <= q.order[v] + 4; ++quarter) loop.push_back(c + rotated(w, quarter));
    const Pulled_back_arc round = pull_back(r, t.face(h), loop);
    CHECK(round.last_face == t.face(h));
    CHECK_EQUAL(round.to_last_chart.rotation, -q.order[v] & 3);
    CHECK(round.to_last_chart(c) == c);
    CHECK(q.order[v] != 0 || round.to_last_chart.is_identity());

    const Pulled_back_arc through = pull_back(r, t.face(h), {c + w, c - w});
    const Pulled_back_arc beside = pull_back(r, t.face(h), {c + w, c + rotated(w, 1), c - w});
    const Pulled_back_arc with_stop = pull_back(r, t.face(h), {c + w, c, c - w});
    CHECK(same_chart(through, beside) && same_chart(through, with_stop));
    CHECK_EQUAL(through.points.size(), 3u);

    for (int turn : {-1, 1}) {
      const Grid_vector to = c + rotated(w, turn);
      CHECK(same_chart(pull_back(r, t.face(h), {c, to}), pull_back(r, t.face(h), {c, c + w, to})));
    }
  }
}

/// Along an edge, and on over its end.
void check_edges(const Surface& s)
{
  const Quartic_differential& q = s.q();
  const Intrinsic_triangulation& t = q.triangulation;
  for (Halfedge h : t.halfedges()) {
    const Grid_vector from = q.corner[h], to = q.corner[t.next(h)], beyond = to + to - from;
    const Pulled_back_arc line = pull_back(s.refined, t.face(h), {from, to});
    CHECK_EQUAL(line.points.size(), 2u);
    CHECK(distance(s.position(line.points.front()), s.position(t.source(h))) < 1e-12 * s.size);
    CHECK(distance(s.position(line.points.back()), s.position(t.target(h))) < 1e-12 * s.size);
    CHECK(line.last_face == t.face(t.opposite(h)));
    CHECK(line.to_last_chart(to) == q.corner[t.opposite(h)]);

    const Pulled_back_arc on = pull_back(s.refined, t.face(h), {from, beyond});
    CHECK(same_chart(on, pull_back(s.refined, t.face(h), {from, to, beyond})));
    CHECK(distance(s.position(on.points[1]), s.position(t.target(h))) < 1e-12 * s.size);
    const Grid_vector stop = line.to_last_chart(to);
    const Pulled_back_arc rest = pull_back(s.refined, line.last_face, {stop, line.to_last_chart(beyond)});
    CHECK(same_chart(on, {{}, rest.last_face, line.to_last_chart.then(rest.to_last_chart)}));
  }
}

/// A point that was rounded to a place beside its face is found there.
void check_rounded_starts(const Surface& s)
{
  const Quartic_differential& q = s.q();
  const Intrinsic_triangulation& t = q.triangulation;
  double worst = 0;
  for (Halfedge h : t.halfedges()) {
    const std::complex<double> edge = difference(q.corner[h], q.corner[t.next(h)]);
    const Grid_vector outwards{std::llround(edge.imag() / std::abs(edge)), -std::llround(edge.real() / std::abs(edge))};
    const Pulled_back_arc at = pull_back(s.refined, t.face(h), {q.corner[h] + outwards});
    CHECK_EQUAL(at.points.size(), 1u);
    CHECK(at.last_face != t.face(h));
    worst = std::max(worst, error_at_end(s, at, q.corner[h] + outwards));
  }
  CHECK(worst < 1e-9 * s.flat_size);
}

// Surfaces glued from parallelograms

/// Lines through lattice points meet vertices all the time; a stop at one of them changes nothing.
void check_stops(const Refined_surface& surface, std::int64_t side, std::mt19937& random)
{
  const Intrinsic_triangulation& t = surface.differential.triangulation;
  for (int trial = 0; trial < 50; ++trial) {
    const auto step = [&] { return side / 2 * (static_cast<std::int64_t>(random() % 9) - 4); };
    const Halfedge h(static_cast<Mesh::size_type>(random() % t.number_of_halfedges()));
    const Grid_vector a = surface.differential.corner[h], v{step(), step()};
    std::vector<Grid_vector> stops{a};
    for (int k = 0; k < 6; ++k) stops.push_back(stops.back() + v);
    CHECK(same_chart(pull_back(surface, t.face(h), stops), pull_back(surface, t.face(h), {a, stops.back()})));
  }
}

void square_tiled_surfaces()
{
  std::mt19937 random(5);
  const std::int64_t side = 1 << 20;
  for (int done = 0; done < 100;) {
    const Gluing glued = random_gluing(1 + static_cast<int>(random() % 12), random);
    if (!is_connected(glued)) continue;
    Quartic_differential q = exact_differential(glued, {side, 0}, {0, side});
    flip_exactly(q, 30, 10 * side, random);
    check_vertices(own_input(q));
    check_stops(own_input(q), side, random);
    ++done;
  }
}

/// Closed lines on a torus end where they began; their charts differ by a period.
void torus()
{
  std::mt19937 random(6);
  const Grid_vector u{1200, 70}, v{-130, 900};
  Quartic_differential q = exact_differential({2, 3, 0, 1}, u, v);
  flip_exactly(q, 20, 10000, random);
  const Refined_surface surface = own_input(q);
  for (int k = -7; k <= 7; ++k)
    for (int l = -7; l <= 7; ++l) {
      const Face f(static_cast<Mesh::size_type>(random() % 2));
      const Grid_vector a = point_inside(q, f, random), period{k * u.x + l * v.x, k * u.y + l * v.y};
      const Pulled_back_arc line = pull_back(surface, f, {a, a + period});
      CHECK(line.last_face == f && line.to_last_chart.rotation == 0);
      CHECK(line.to_last_chart.translation == Grid_vector{} - period);
    }
}

void range()
{
  const std::int64_t far = std::int64_t(1) << 60;
  const Refined_surface surface = own_input(exact_differential({2, 3, 0, 1}, {far / 8, 0}, {0, far / 8}));
  const Face f(0);
  CHECK_THROWS(pull_back(surface, f, {{0, 0}, {far, 0}}), Numerical_error, "range");
  CHECK_THROWS(pull_back(surface, f, {{0, 0}, {far - 1, 1}, {0, 1}, {-far, 1}}), Numerical_error, "range");
  const Grid_vector inside{far / 16, far / 32};
  CHECK(pull_back(surface, f, {inside, {far - 1, 1}, inside}).to_last_chart.is_identity());

  Quartic_differential q = surface.differential;   // the start of the line is too far away in the second chart
  for (Halfedge h : q.triangulation.halfedges(Face(1))) q.corner[h] = q.corner[h] - Grid_vector{far / 2, 0};
  find_transitions(q);
  CHECK_THROWS(pull_back(own_input(q), f, {inside, {far - 1, 1}}), Numerical_error, "range");

  CHECK_THROWS(nearest_grid_point(surface.differential, {0, -std::ldexp(1.0, 40)}), Numerical_error, "range");
  CHECK_THROWS(nearest_grid_point(surface.differential, {std::nan(""), 0}), Numerical_error, "range");
}

} // namespace

int main()
{
  std::mt19937 random(1);
  for (const Named_surface& named : sample_surfaces()) {
    const std::optional<Surface> s = computed(named.surface);
    if (!s) continue;
    const double arcs = check_arcs(*s), lines = check_random_lines(*s, random);
    std::cout << named.name << ": " << s->t_mesh.arcs.size() << " arcs to " << arcs << ", random lines to " << lines
              << std::endl;
    check_vertices(s->refined);
    check_edges(*s);
    check_rounded_starts(*s);
  }
  square_tiled_surfaces();
  torus();
  range();
  return result();
}
