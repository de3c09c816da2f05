// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/boundary_corners.h>

#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace {

// A vertex of an unrolled curve, for boost.
struct Numbered_place
{
  double      x, y;
  std::size_t vertex;
};

} // namespace

BOOST_GEOMETRY_REGISTER_POINT_2D(Numbered_place, double, boost::geometry::cs::cartesian, x, y)

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;
const double pi = CGAL_PI;
const double sharp = 0.375 * pi;   // a turn beyond that is a corner, nearer to pi/2 than to pi/4
const double seen = 0.31 * pi, unusual = 0.22 * pi;   // from farther away it is at least that, and that much more than usual
const double window = 0.04;        // turns within that count together, times the length of the curve
// of the simplified curve, and how far away a corner must be seen: times a short edge, and bounds times the length
const double deviation = 0.9, least_deviation = 0.004, most_deviation = 0.01;
const double view = 2.5, least_view = 0.025, most_view = 0.08;

// A boundary curve unrolled into the plane, from its sharpest vertex round to it. Vertex i is the source of edge i.
class Unrolled_curve
{
public:
  Unrolled_curve(const Intrinsic_triangulation& t, std::vector<Halfedge> halfedges,
                 const std::vector<double>& curvature)
    : edges(std::move(halfedges)), place{0}, along{0}
  {
    const auto turn_at = [&](Halfedge h) { return curvature[t.source(h)]; };
    std::rotate(edges.begin(), std::max_element(edges.begin(), edges.end(), [&](Halfedge a, Halfedge b) {
      return std::abs(turn_at(a)) < std::abs(turn_at(b));
    }), edges.end());
    double direction = 0;
    for (Halfedge h : edges) {
      turn.push_back(turn_at(h));
      if (h != edges.front()) direction += turn.back();
      place.push_back(place.back() + std::polar(t.length(h), direction));
      along.push_back(along.back() + t.length(h));
    }
    whole_turn = direction + turn.front();
    std::vector<double> lengths;
    for (Halfedge h : edges) lengths.push_back(t.length(h));
    const auto quartile = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 4);
    std::nth_element(lengths.begin(), quartile, lengths.end());
    m_short_edge = *quartile;
  }

  // a number of short edges (the lower quartile), but within bounds that are parts of the length
  double in_short_edges(double number, double least, double most) const
  { return std::clamp(number * m_short_edge, least * length(), most * length()); }

  double length() const { return along.back(); }
  // the point at a length, which may lie before the beginning or after the end
  Complex point(double at) const
  {
    const Complex round = std::polar(1.0, whole_turn);
    if (at < 0) return (point(at + length()) - place.back()) / round;
    if (at > length()) return place.back() + round * point(at - length());
    const std::size_t k = std::upper_bound(along.begin() + 1, along.end() - 1, at) - along.begin();
    return place[k - 1] + (at - along[k - 1]) / (along[k] - along[k - 1]) * (place[k] - place[k - 1]);
  }
  // calls `visit(vertex, length)` for the vertices between two lengths
  template <class Visit>
  void visit_between(double from, double to, Visit visit) const
  {
    for (std::size_t i = 0; i < turn.size(); ++i)
      for (int round : {-1, 0, 1})
        if (const double at = along[i] + round * length(); from < at && at < to) visit(i, at);
  }
  double turning(double from, double to) const
  {
    double sum = 0;
    visit_between(from, to, [&](std::size_t i, double) { sum += turn[i]; });
    return sum;
  }
  std::size_t nearest_vertex(double at) const
  {
    const auto above = std::lower_bound(along.begin(), along.end(), at);
    if (above == along.begin()) return 0;
    const bool is_nearer = above != along.end() && *above - at < at - *(above - 1);
    return static_cast<std::size_t>(above - along.begin() - (is_nearer ? 0 : 1)) % edges.size();
  }

  std::vector<Halfedge> edges;
  std::vector<double>   turn;         // by vertex
  std::vector<Complex>  place;        // by vertex, and once more the first one after a round
  std::vector<double>   along;        // likewise, the length up to there
  double                whole_turn;

private:
  double m_short_edge;
};

// The vertices from i to k that are needed to stay within a distance of the curve (Douglas and Peucker), without k.
void simplify(const std::vector<Complex>& place, std::size_t i, std::size_t k, double allowed,
              std::vector<std::size_t>& kept)
{
  boost::geometry::model::linestring<Numbered_place> line, needed;
  for (std::size_t j = i; j <= k; ++j) line.push_back({place[j].real(), place[j].imag(), j});
  boost::geometry::simplify(line, needed, allowed);
  for (const Numbered_place& p : needed)
    if (p.vertex != k) kept.push_back(p.vertex);
}

// the vertices of the simplified curve, in order; the first vertex is among them
std::vector<std::size_t> simplified(const Unrolled_curve& c)
{
  const double allowed = c.in_short_edges(deviation, least_deviation, most_deviation);
  const std::size_t n = c.edges.size();
  std::size_t opposite = 0;   // farthest from the first one: the curve is, nearly, closed
  for (std::size_t i = 1; i < n; ++i)
    if (std::abs(c.place[i]) > std::abs(c.place[opposite])) opposite = i;
  if (opposite == 0) return {0};
  std::vector<std::size_t> kept;
  simplify(c.place, 0, opposite, allowed, kept);
  simplify(c.place, opposite, n, allowed, kept);
  return kept;
}

struct Turn
{
  double along, angle;   // positive to the left, where the surface is
};

// the angle and whole turns that are nearest to another one
double near(double wanted, double angle) { return angle + 2 * pi * std::round((wanted - angle) / (2 * pi)); }

// The turns of the simplified curve.
std::vector<Turn> turns(const Unrolled_curve& c)
{
  const std::vector<std::size_t> kept = simplified(c);
  const std::size_t n = kept.size();
  std::vector<Complex> side;   // k runs from kept vertex k to the next
  std::vector<double> length;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t end = k + 1 < n ? kept[k + 1] : c.edges.size();
    side.push_back(c.place[end] - c.place[kept[k]]);
    length.push_back(c.along[end] - c.along[kept[k]]);
  }
  std::vector<Turn> result;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = (k + n - 1) % n;
    const Complex next = k == 0 ? side[0] * std::polar(1.0, c.whole_turn) : side[k];
    const double at = c.along[kept[k]];
    const double whole = c.turning(at - 0.5 * length[before], at + 0.5 * length[k]);
    result.push_back({at, near(whole, std::arg(next / side[before]))});
  }
  return result;
}

bool is_sharp(const Turn& t) { return std::abs(t.angle) > sharp; }

// Puts turns of one sign that are near each other, and none of them sharp, together where that makes a sharp one.
void gather_fillets(const Unrolled_curve& c, std::vector<Turn>& turns)
{
  const std::size_t n = turns.size();
  for (;;) {
    Turn best{0, 0};
    std::size_t first = 0, count = 0;
    for (std::size_t k = 0; k < n; ++k) {
      double sum = 0, way = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const Turn& t = turns[(k + j) % n];
        way = t.along - turns[k].along + (k + j >= n ? c.length() : 0);
        if (way > window * c.length() || is_sharp(t) || t.angle * turns[k].angle <= 0) break;
        sum += t.angle;
        if (std::abs(sum) > std::abs(best.angle)) {
          best = {std::fmod(turns[k].along + 0.5 * way, c.length()), sum};
          first = k;
          count = j + 1;
        }
      }
    }
    if (!is_sharp(best)) return;
    for (std::size_t j = 0; j < count; ++j) turns[(first + j) % n].angle = 0;
    turns[first] = best;
  }
}

// Whether a turn is one from farther away too: steps of a jagged boundary are none, nor are bends of a rough circle, which
// turns nearly as much everywhere.
bool is_seen(const Unrolled_curve& c, const Turn& t)
{
  const double distance = c.in_short_edges(view, least_view, most_view);
  const Complex before = c.point(t.along) - c.point(t.along - distance);
  const Complex after = c.point(t.along + distance) - c.point(t.along);
  const double turn = near(t.angle, std::arg(after / before)), usual = c.whole_turn * distance / c.length();
  const int sign = t.angle > 0 ? 1 : -1;
  return sign * turn > seen && sign * (turn - usual) > unusual;
}

// The vertex of a corner: where it turns, or the middle of where it does, if no vertex has most of it.
std::size_t vertex_of(const Unrolled_curve& c, const Turn& t)
{
  const std::size_t vertex = c.nearest_vertex(t.along);
  if (2 * std::abs(c.turn[vertex]) >= std::abs(t.angle)) return vertex;
  double sum = 0, moment = 0;
  const double reach = 0.5 * window * c.length();
  c.visit_between(t.along - reach, t.along + reach, [&](std::size_t i, double at) {
    if (c.turn[i] * t.angle <= 0) return;
    sum += c.turn[i];
    moment += c.turn[i] * (at - t.along);
  });
  const double middle = sum == 0 ? t.along : t.along + moment / sum;
  return c.nearest_vertex(middle - c.length() * std::floor(middle / c.length()));
}

} // namespace

Divisor boundary_corners(const Intrinsic_triangulation& t)
{
  const std::vector<double> curvature = curvatures(t, corner_angles(t, t.lengths()));
  Divisor corners;
  for (const std::vector<Halfedge>& curve : t.boundary_curves()) {
    const Unrolled_curve c(t, curve, curvature);
    std::vector<Turn> found = turns(c);
    gather_fillets(c, found);
    for (const Turn& turn : found) {
      if (!is_sharp(turn) || !is_seen(c, turn)) continue;
      const int quads = std::max(1, 2 - static_cast<int>(std::lround(turn.angle / (pi / 2))));
      corners.push_back({on_edge(t, c.edges[vertex_of(c, turn)], 0), quads - 2, true, true});
    }
  }
  return corners;
}

} } // namespace CGAL::Quartic_differentials
