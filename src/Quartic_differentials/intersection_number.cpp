// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/intersection_number.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <algorithm>
#include <string>
#include <unordered_map>

namespace CGAL {
namespace Quartic_differentials {

namespace {

// The open simplex of a face that holds a point: the vertex source(at), the edge of `at`, or the face of `at`.
struct Place
{
  int      dimension;
  Halfedge at;
};

Place place(const Intrinsic_triangulation& t, Face f, const std::array<double, 3>& barycentric)
{
  const auto h = t.halfedges(f);
  const auto zeros = std::count(barycentric.begin(), barycentric.end(), 0.0);
  if (zeros == 3)
    throw Error("a point in face " + std::to_string(f.idx()) + " has no barycentric coordinate other than 0");
  if (zeros == 0) return {2, h[0]};
  int k = 0;
  if (zeros == 1) {
    while (barycentric[k] != 0) ++k;
    return {1, h[(k + 1) % 3]};   // opposite to the corner k
  }
  while (barycentric[k] == 0) ++k;
  return {0, h[k]};
}

// Goes round source(from) clockwise, from the face of `from` to that of `to`: the vertex is on the right.
void turn_clockwise(const Intrinsic_triangulation& t, Halfedge from, Halfedge to, Closed_curve& curve)
{
  if (t.source(from) != t.source(to))
    throw Error("a curve jumps from vertex " + std::to_string(t.source(from).idx()) + " to vertex "
                + std::to_string(t.source(to).idx()));
  for (Halfedge h = from; h != to; h = t.next(t.opposite(h))) curve.crossings.push_back(h);
}

// Goes on from a place to the same place in a neighbouring face, with a vertex on the right.
void pass(const Intrinsic_triangulation& t, const Place& from, const Place& to, Closed_curve& curve)
{
  if (from.dimension == 0 && to.dimension == 0) return turn_clockwise(t, from.at, to.at, curve);
  if (from.dimension == to.dimension && from.at == to.at) return;
  if (from.dimension != 1 || to.dimension != 1 || to.at != t.opposite(from.at))
    throw Error("a curve jumps from face " + std::to_string(t.face(from.at).idx()) + " to another point in face "
                + std::to_string(t.face(to.at).idx()));
  curve.crossings.push_back(from.at);
}

// The place as the face f sees it.
Place seen_from(const Intrinsic_triangulation& t, Face f, const Place& p)
{
  if (t.face(p.at) == f) return p;
  if (p.dimension == 1 && t.face(t.opposite(p.at)) == f) return {1, t.opposite(p.at)};
  if (p.dimension == 0) {
    const auto h = t.halfedges(f);
    const auto at_vertex = [&](Halfedge k) { return t.source(k) == t.source(p.at); };
    const auto corners = std::count_if(h.begin(), h.end(), at_vertex);
    if (corners > 1)
      throw Error("a curve reaches vertex " + std::to_string(t.source(p.at).idx()) + " in face "
                  + std::to_string(f.idx()) + ", which has two corners there");
    if (corners == 1) return {0, *std::find_if(h.begin(), h.end(), at_vertex)};
  }
  throw Error("a curve leaves the closed face " + std::to_string(f.idx()) + " for a point in face "
              + std::to_string(t.face(p.at).idx()) + " that does not lie in it");
}

// eta_a by edge, on its halfedge(e)
std::unordered_map<std::size_t, std::int64_t> cochain(const Closed_curve& a)
{
  std::unordered_map<std::size_t, std::int64_t> eta;
  for (Halfedge h : a.crossings) eta[h.idx() / 2] += h.idx() % 2 == 0 ? 1 : -1;
  return eta;
}

} // namespace

Closed_curve closed_curve_along_edges(const Intrinsic_triangulation& t, const std::vector<Halfedge>& walk)
{
  Closed_curve curve;
  for (std::size_t i = 0; i < walk.size(); ++i) turn_clockwise(t, t.next(walk[i]), walk[(i + 1) % walk.size()], curve);
  return curve;
}

Closed_curve closed_curve_along_segments(const Intrinsic_triangulation& t, const std::vector<Face_segment>& segments)
{
  Closed_curve curve;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Face_segment &s = segments[i], &next = segments[(i + 1) % segments.size()];
    pass(t, place(t, s.face, s.target), place(t, next.face, next.source), curve);
  }
  return curve;
}

Closed_curve closed_curve_along_polyline(const Intrinsic_triangulation& t, const std::vector<Surface_point>& points)
{
  Closed_curve curve;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Surface_point& next = points[(i + 1) % points.size()];
    const Place there = place(t, next.face, next.barycentric);
    pass(t, seen_from(t, points[i].face, there), there, curve);
  }
  return curve;
}

std::vector<Halfedge> edge_walk(const Intrinsic_triangulation& t, const Closed_curve& curve)
{
  std::vector<Halfedge> walk;
  const auto& crossings = curve.crossings;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Halfedge in = t.opposite(crossings[i]), out = crossings[(i + 1) % crossings.size()];
    if (t.face(in) != t.face(out))
      throw Error("a curve jumps from face " + std::to_string(t.face(in).idx()) + " to face "
                  + std::to_string(t.face(out).idx()));
    // from the left end of `in`, its source, to the left end of `out`, its target; a left turn stays where it is
    if (out == in) walk.push_back(in);
    if (out == t.next(in)) walk.push_back(t.opposite(t.prev(in)));
  }
  return walk;
}

std::int64_t intersection_number(const Intrinsic_triangulation& t, const Closed_curve& a, const Closed_curve& b)
{
  const auto eta = cochain(a);
  std::int64_t sum = 0;
  for (Halfedge h : edge_walk(t, b)) {
    const auto found = eta.find(h.idx() / 2);
    if (found != eta.end()) sum += h.idx() % 2 == 0 ? found->second : -found->second;
  }
  return sum;
}

Homology_class homology_class(const Intrinsic_triangulation& t, const Integer_cochains& canonical,
                              const Closed_curve& curve)
{
  Homology_class values = Homology_class::Zero(canonical.size());
  for (Halfedge h : edge_walk(t, curve)) values += canonical.row(h).transpose().cast<std::int64_t>();
  return coefficients_of_class(values);
}

std::int64_t intersection_number(const Homology_class& x, const Homology_class& y)
{
  const Eigen::Index g = x.size() / 2;
  return x.head(g).dot(y.tail(g)) - x.tail(g).dot(y.head(g));
}

} } // namespace CGAL::Quartic_differentials
