// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/smooth_quads.h>

#include <CGAL/Quartic_differentials/internal/Boundary_ways.h>
#include <CGAL/Quartic_differentials/internal/Input_surface.h>
#include <CGAL/Quartic_differentials/internal/Quad_shape.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Input_surface;
using internal::length;
using internal::unit;
using Place = Input_surface::Place;

const double infinity = std::numeric_limits<double>::infinity();

// How good quads are.
struct Quality
{
  double least = infinity;   // scaled Jacobian
  double sum = 0;            // over corners, what is to become small: E in METHOD, "Smoothing"
};

// the square of the ratio (a - b)^2 : (a^2 + b^2), with a weight: it keeps edges from shrinking to points
double unevenness(double a, double b)
{
  const double weight = 0.25, ratio = (a - b) * (a - b) / (a * a + b * b);
  return weight * ratio * ratio;
}

const int directions = 8;               // of the pattern search
const int walks = 16;                   // of every length, in the search that raises the worst quads
const double smallest_gain = 1e-3;      // of E at a move, as a share: smaller moves cost time and gain nothing
const double penalty = 100;             // on the fourth power of what a quad lacks of the guard
const double shortest_walk = 1. / 16;   // mean edges
const double golden_angle = (3 - std::sqrt(5.)) * CGAL_PI;   // its multiples nowhere meet
const double turned_over = -0.5;        // cosine: a normal is against the surface where the surface's own ones agree;
                                        // round a thin tube they cancel, and say nothing

const std::size_t none = static_cast<std::size_t>(-1);

class Smoother
{
public:
  Smoother(const Intrinsic_triangulation& input, const Input_surface& surface, Quad_mesh& m)
    : m_surface(surface), m_boundary(input), m_mesh(m), m_next(next_on_boundary(m)),
      m_previous(m.points.size(), none), m_is_fixed(m.points.size(), false), m_first(m.points.size() + 1, 0),
      m_corner(4 * m.quads.size()), m_step(m.points.size(), infinity), m_is_active(m.points.size(), true)
  {
    for (const auto& quad : m.quads)
      for (std::size_t v : quad) ++m_first[v + 1];
    for (std::size_t v = 0; v < m.points.size(); ++v) m_first[v + 1] += m_first[v];
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t f = 0; f < m.quads.size(); ++f)
      for (int k = 0; k < 4; ++k) m_corner[next[m.quads[f][k]]++] = {f, k};
    m_place.reserve(m.points.size());
    for (const Surface_point& p : m.input_points) m_place.push_back(surface.place(p));
    for (std::size_t v = 0; v < m.points.size(); ++v)
      if (is_on_boundary(v)) m_previous[m_next[v]] = v;
    for (std::size_t v : m.singularities) m_is_fixed[v] = is_on_boundary(v);
  }

  Smoothing_sweep measure(std::size_t moves) const
  {
    Smoothing_sweep result{infinity, 0, moves};
    for (std::size_t f = 0; f < m_mesh.quads.size(); ++f) {
      const Quality q = quality(f, m_mesh.quads[f][0], m_place[m_mesh.quads[f][0]]);
      result.least = std::min(result.least, q.least);
      result.mean += q.least / double(m_mesh.quads.size());
    }
    return result;
  }

  // from now on what quads lack of the guard weighs more than all else
  void raise_worst()
  {
    m_raises_worst = true;
    std::fill(m_is_active.begin(), m_is_active.end(), true);
  }

  // returns the number of moves; `least` is that of the mesh
  std::size_t sweep(double guard, double least)
  {
    m_guard = std::max(guard, least);
    m_least = least;
    m_first_angle += golden_angle;
    std::size_t moves = 0;
    std::vector<char> active(m_place.size(), false);
    active.swap(m_is_active);
    for (std::size_t v = 0; v < m_place.size(); ++v)
      if ((active[v] || m_is_active[v]) && improve(v)) {
        ++moves;
        for (std::size_t c = m_first[v]; c < m_first[v + 1]; ++c)
          for (std::size_t w : m_mesh.quads[m_corner[c].first]) m_is_active[w] = true;
      }
    return moves;
  }

  void store() const
  {
    for (std::size_t v = 0; v < m_place.size(); ++v) {
      m_mesh.points[v] = m_place[v].point;
      m_mesh.input_points[v] = m_place[v].at;
    }
  }

private:
  bool is_on_boundary(std::size_t v) const { return m_next[v] != none; }

  // of a quad, when vertex v is at a place; it does not depend on which vertex that is, not even in rounding, so that
  // comparisons hold for the mesh as it will be
  Quality quality(std::size_t f, std::size_t v, const Place& place) const
  {
    std::array<Point_3, 4> p;
    Vector_3 outward(0, 0, 0);
    for (int k = 0; k < 4; ++k) {
      const std::size_t w = m_mesh.quads[f][k];
      const Place& at = w == v ? place : m_place[w];
      p[k] = at.point;
      outward += at.normal;
    }
    const internal::Quad_shape shape(p);
    const double sign = CGAL::scalar_product(shape.normal, outward / 4) < turned_over ? -1 : 1;
    Quality result;
    for (int k = 0; k < 4; ++k) {
      const double sine = sign * shape.sine[k];
      result.least = std::min(result.least, sine);
      result.sum += (1 - sine) * (1 - sine) + unevenness(shape.side[(k + 3) % 4], shape.side[k]);
    }
    return result;
  }

  // of the quads around v
  Quality around(std::size_t v, const Place& place) const
  {
    Quality result;
    for (std::size_t c = m_first[v]; c < m_first[v + 1]; ++c) {
      const Quality q = quality(m_corner[c].first, v, place);
      result.least = std::min(result.least, q.least);
      result.sum += q.sum;
      if (m_raises_worst && q.least < m_guard)
        result.sum += penalty * CGAL::square(CGAL::square(m_guard - q.least));
    }
    return result;
  }

  const Point_3& at_corner(std::size_t c, int ahead) const
  { return m_place[m_mesh.quads[m_corner[c].first][(m_corner[c].second + ahead) % 4]].point; }

  double mean_edge(std::size_t v) const
  {
    double sum = 0;
    for (std::size_t c = m_first[v]; c < m_first[v + 1]; ++c) sum += length(at_corner(c, 1) - m_place[v].point);
    return sum / double(m_first[v + 1] - m_first[v]);
  }

  bool is_better(const Quality& a, const Quality& b) const
  {
    return a.sum < (1 - smallest_gain) * b.sum && a.least >= (m_raises_worst ? m_least : std::min(b.least, m_guard));
  }

  // where v is after a step in its tangent plane, unless that leads through a thin part to its other side; most steps
  // are refused before the nearest point is looked for
  std::optional<Place> moved(std::size_t v, const Vector_3& step, const Quality& now) const
  {
    Place place = m_place[v];
    place.point = place.point + step;
    if (!is_better(around(v, place), now)) return std::nullopt;
    const Place nearest = m_surface.nearest(place.point, m_place[v]);
    if (CGAL::scalar_product(nearest.normal, m_place[v].normal) <= 0) return std::nullopt;
    return nearest;
  }

  // the same on the boundary, unless that leads past a neighbour
  std::optional<Place> slid(std::size_t v, const Vector_3& step) const
  {
    const Surface_point &at = m_place[v].at, &next = m_place[m_next[v]].at, &previous = m_place[m_previous[v]].at;
    const double distance = CGAL::scalar_product(step, m_boundary.direction(at));
    if (distance >= m_boundary.length(at, next) || -distance >= m_boundary.length(previous, at)) return std::nullopt;
    return m_surface.place(m_boundary.slid(at, distance));
  }

  // moves v if that is better
  bool try_place(std::size_t v, const Place& place, Quality& now)
  {
    const Quality then = around(v, place);
    if (!is_better(then, now)) return false;
    m_place[v] = place;
    now = then;
    return true;
  }

  bool try_step(std::size_t v, const Vector_3& step, Quality& now)
  {
    const std::optional<Place> place = is_on_boundary(v) ? slid(v, step) : moved(v, step, now);
    return place && try_place(v, *place, now);
  }

  // goes all the way, half of it, or a quarter
  bool try_target(std::size_t v, const Vector_3& to, Quality& now)
  {
    const Vector_3 n = m_place[v].normal;
    Vector_3 step = to - CGAL::scalar_product(to, n) * n;
    for (int k = 0; k < 3; ++k, step = step / 2)
      if (try_step(v, step, now)) return true;
    return false;
  }

  // moves v at most once
  bool improve(std::size_t v)
  {
    if (m_is_fixed[v]) return false;
    Quality now = around(v, m_place[v]);
    Vector_3 completion(0, 0, 0), middle(0, 0, 0);
    const double quads = double(m_first[v + 1] - m_first[v]);
    for (std::size_t c = m_first[v]; c < m_first[v + 1]; ++c) {
      const Vector_3 next = at_corner(c, 1) - m_place[v].point, across = at_corner(c, 2) - m_place[v].point,
                   previous = at_corner(c, 3) - m_place[v].point;
      completion += (next + previous - across) / quads;
      middle += next / quads;
    }
    return try_target(v, completion, now) || try_target(v, middle, now)
           || (m_raises_worst && now.least < m_guard && !is_on_boundary(v) ? search_far(v, now) : search(v, now));
  }

  // of the search, unit vectors
  boost::container::static_vector<Vector_3, directions> directions_at(std::size_t v) const
  {
    if (is_on_boundary(v)) {
      const Vector_3 along = m_boundary.direction(m_place[v].at);
      return {along, -along};
    }
    const Vector_3 n = m_place[v].normal;
    const Vector_3 x = unit(std::abs(n.x()) < 0.6 ? Vector_3(0, n.z(), -n.y()) : Vector_3(-n.z(), 0, n.x()));
    const Vector_3 y = CGAL::cross_product(n, x);
    boost::container::static_vector<Vector_3, directions> result;
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * CGAL_PI * k / directions;
      result.push_back(std::cos(angle) * x + std::sin(angle) * y);
    }
    return result;
  }

  // tries all directions; the step grows and shrinks with success
  bool search(std::size_t v, Quality& now)
  {
    const double most = mean_edge(v) / 4;
    m_step[v] = std::min(m_step[v], most);
    for (const Vector_3& direction : directions_at(v))
      if (try_step(v, m_step[v] * direction, now)) {
        m_step[v] *= 1.5;
        return true;
      }
    m_step[v] = std::max(m_step[v] / 2, most / 16);
    return false;
  }

  // walks along the surface, far at first: from facet to facet the worst quads change abruptly, and a tangent plane says
  // nothing of the next facet but one; in other directions at the next sweep
  bool search_far(std::size_t v, Quality& now)
  {
    const double edge = mean_edge(v);
    for (double step = edge; step >= shortest_walk * edge; step /= 2)
      for (int k = 0; k < walks; ++k)
        if (try_place(v, m_surface.walked(m_place[v], std::polar(step, m_first_angle + 2 * CGAL_PI * k / walks)), now))
          return true;
    m_is_active[v] = true;
    return false;
  }

  const Input_surface&          m_surface;
  const internal::Boundary_ways m_boundary;
  Quad_mesh&               m_mesh;
  std::vector<std::size_t> m_next, m_previous;           // by vertex: its neighbours along the boundary
  std::vector<char>        m_is_fixed;                   // by vertex
  std::vector<std::size_t> m_first;                      // by vertex: its first corner
  std::vector<std::pair<std::size_t, int>> m_corner;     // quad, and which of its corners; by vertex
  std::vector<Place>       m_place;                      // by vertex
  std::vector<double>      m_step;                       // by vertex: of the pattern search
  std::vector<char>        m_is_active;                  // by vertex: something around it has moved
  double                   m_guard = 0, m_least = 0;     // scaled Jacobians: what quads are to reach, and the mesh has
  double                   m_first_angle = 0;            // of the walks
  bool                     m_raises_worst = false;
};

} // namespace

Smoothing_report smooth_quads(const Intrinsic_triangulation& input, const Smoothing_options& options, Quad_mesh& m)
{
  const auto begin = std::chrono::steady_clock::now();
  internal::require_embedded(input, "smoothing");
  const Input_surface surface(input);
  Smoother smoother(input, surface, m);
  Smoothing_report report;
  report.history.push_back(smoother.measure(0));
  // until some sweeps in a row gain nothing
  const auto sweep = [&](int patience) {
    for (int in_vain = 0; in_vain < patience && report.history.size() <= options.sweeps; ) {
      const Smoothing_sweep before = report.history.back();
      const std::size_t moves = smoother.sweep(options.guard, before.least);
      const Smoothing_sweep after = smoother.measure(moves);
      report.history.push_back(after);
      const double gain = std::max(after.least - before.least, after.mean - before.mean);
      in_vain = gain < options.least_gain ? in_vain + 1 : 0;
    }
  };
  sweep(1);
  report.lowered = report.history.size() - 1;
  if (report.history.back().least < options.guard) {
    smoother.raise_worst();
    sweep(3);
  }
  smoother.store();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

} } // namespace CGAL::Quartic_differentials
