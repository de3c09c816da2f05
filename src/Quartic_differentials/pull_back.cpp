// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/pull_back.h>

#include <CGAL/Quartic_differentials/exceptions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const std::int64_t bound = std::int64_t(1) << 60;   // transitions between charts with corners below 2^61 stay exact

Grid_vector in_exact_range(Grid_vector z)
{
  if (z.x <= -bound || z.x >= bound || z.y <= -bound || z.y >= bound)
    throw Numerical_error("a polyline leaves the range of coordinates in which the grid is exact");
  return z;
}

// Walks straight from face to face. All grid points are in the chart of the face in which the walk is; they are carried
// along from chart to chart.
class Straight_walk
{
public:
  Straight_walk(const Refined_surface& refined, Face start, Grid_vector z)
    : m_refined(refined), m_q(refined.differential), m_face(start), m_from(in_exact_range(z)), m_points(1)
  {
    if (!face_holds(z)) {
      m_from = m_q.corner[m_q.triangulation.halfedge(start)];
      go_to(z);
    }
    m_points = {on_input(barycentric(m_from))};
  }

  // z is in the chart at the start
  void go_to(Grid_vector z)
  {
    m_to = in_exact_range(m_to_chart(in_exact_range(z)));
    if (m_to == m_from) return;
    m_here = m_from;
    while (const std::optional<Halfedge> h = next_edge())
      if (is_on_boundary(*h)) pass_end_of(*h);
      else                    cross(*h);
    m_from = m_to;
    m_points.push_back(on_input(barycentric(m_to)));
  }

  Pulled_back_arc result() && { return {std::move(m_points), m_face, m_to_chart}; }

private:
  Grid_vector source(Halfedge h) const { return m_q.corner[h]; }
  Grid_vector target(Halfedge h) const { return m_q.corner[m_q.triangulation.next(h)]; }

  // positive if z is on the left of the halfedge
  __int128 side(Halfedge h, Grid_vector z) const { return doubled_area(source(h), target(h), z); }
  bool is_beyond(Halfedge h) const { return side(h, m_to) < 0; }

  bool face_holds(Grid_vector z) const
  {
    const auto halfedges = m_q.triangulation.halfedges(m_face);
    return std::all_of(halfedges.begin(), halfedges.end(), [&](Halfedge h) { return side(h, z) >= 0; });
  }

  bool is_on_boundary(Halfedge h) const { return m_q.triangulation.is_border(m_q.triangulation.opposite(h)); }

  // The edge through which the walk has to leave the face, or the boundary edge along which it has to leave it.
  std::optional<Halfedge> next_edge() const
  {
    Halfedge h = exit();
    if (h != Mesh::null_halfedge()) return is_beyond(h) ? std::make_optional(h) : std::nullopt;
    h = edge_with_start();
    const bool ends_on_it = side(h, m_to) == 0 && dot(m_to - m_from, target(h) - m_to) >= 0;
    return is_on_boundary(h) && ends_on_it ? std::nullopt : std::make_optional(h);
  }

  static __int128 dot(Grid_vector a, Grid_vector b)
  { return static_cast<__int128>(a.x) * b.x + static_cast<__int128>(a.y) * b.y; }

  // Past the end of a boundary edge, the line has the boundary on its right, if it is still on the surface: it turns
  // clockwise round that vertex.
  void pass_end_of(Halfedge h)
  {
    if (side_of_line(target(h)) != 0 || dot(m_to - m_from, target(h) - m_from) <= 0)
      throw Numerical_error("a polyline leaves the surface through its boundary");
    m_here = target(h);
    m_points.push_back(on_input(barycentric(*m_here)));
    for (h = m_q.triangulation.next(h); !holds_line(h); h = m_q.triangulation.next(m_q.triangulation.opposite(h))) {
      if (is_on_boundary(h)) throw Numerical_error("a polyline leaves the surface through its boundary");
      enter_through(h);
    }
  }

  // whether the line goes on from source(h), where it is, into face(h) or along h
  bool holds_line(Halfedge h) const
  {
    const Grid_vector line = m_to - m_from, right = target(h) - source(h);
    const __int128 s = side_of_line(target(h));
    return s == 0 ? dot(line, right) > 0
                  : s < 0 && side_of_line(source(m_q.triangulation.prev(h))) > 0;
  }

  // positive if z is on the left of the line
  __int128 side_of_line(Grid_vector z) const { return doubled_area(m_from, m_to, z); }

  // The halfedge through which the line leaves the face: it runs from the right of the line to its left. A corner on
  // the line counts as on its left; a line that only touches a face on its left therefore misses it, and there is none.
  Halfedge exit() const
  {
    for (Halfedge h : m_q.triangulation.halfedges(m_face))
      if (side_of_line(source(h)) < 0 && side_of_line(target(h)) >= 0) return h;
    return Mesh::null_halfedge();
  }

  // The side of a missed face on which the segment starts; if that is at a corner, the side that begins there. The face
  // touches the line along this side, or in the corner, round which a turn clockwise then leads to the line.
  Halfedge edge_with_start() const
  {
    const auto halfedges = m_q.triangulation.halfedges(m_face);
    return *std::find_if(halfedges.begin(), halfedges.end(),
                         [&](Halfedge h) { return side(h, m_from) == 0 && target(h) != m_from; });
  }

  void cross(Halfedge h)
  {
    // a vertex or the start of the segment may be on several edges in a row: it is one point of the arc
    const bool is_new = !m_here || side(h, *m_here) != 0;
    const __int128 right = -side_of_line(source(h)), left = side_of_line(target(h));
    if (is_new) m_here = left == 0 ? std::make_optional(target(h)) : std::nullopt;
    enter_through(h);
    if (is_new) m_points.emplace_back();
    m_points.back() = on_input(m_here ? barycentric(*m_here) : between(m_q.triangulation.opposite(h), left, right));
  }

  void enter_through(Halfedge h)
  {
    const Transition& across = m_q.transition[h];
    m_face = m_q.triangulation.face(m_q.triangulation.opposite(h));
    m_to_chart = m_to_chart.then(across);
    m_from = in_exact_range(across(m_from));
    m_to = in_exact_range(across(m_to));
    if (m_here) m_here = across(*m_here);
  }

  std::array<double, 3> barycentric(Grid_vector z) const
  {
    const auto [h0, h1, h2] = m_q.triangulation.halfedges(m_face);
    return internal::barycentric({source(h0), source(h1), source(h2)}, z);
  }

  // the point that divides a halfedge of the face from its source in the ratio a : b
  std::array<double, 3> between(Halfedge h, __int128 a, __int128 b) const
  {
    const double whole = static_cast<double>(a + b);
    std::array<double, 3> result{};
    result[m_q.triangulation.corner(h)] = static_cast<double>(b) / whole;
    result[m_q.triangulation.corner(m_q.triangulation.next(h))] = static_cast<double>(a) / whole;
    return result;
  }

  Surface_point on_input(const std::array<double, 3>& b) const { return m_refined.to_input({m_face, b}); }

  const Refined_surface&      m_refined;
  const Quartic_differential& m_q;
  Face                        m_face;
  Transition                  m_to_chart;      // from the chart at the start
  Grid_vector                 m_from, m_to;    // the segment
  std::optional<Grid_vector>  m_here;          // the last point of the arc, if it is a vertex or the segment's start
  std::vector<Surface_point>  m_points;
};

} // namespace

Pulled_back_arc pull_back(const Refined_surface& refined, Face start, const std::vector<Grid_vector>& polyline)
{
  CGAL_precondition(!polyline.empty());
  Straight_walk walk(refined, start, polyline.front());
  for (Grid_vector z : polyline) walk.go_to(z);
  return std::move(walk).result();
}

Grid_vector nearest_grid_point(const Quartic_differential& q, std::complex<double> z)
{
  const std::complex<double> w = z * std::ldexp(1.0, q.grid_exponent);
  if (!(std::max(std::abs(w.real()), std::abs(w.imag())) < static_cast<double>(bound)))
    throw Numerical_error("a point is beyond the range of coordinates in which the grid is exact");
  return {std::llround(w.real()), std::llround(w.imag())};
}

namespace internal {

std::array<double, 3> barycentric(const std::array<Grid_vector, 3>& corner, Grid_vector z)
{
  const auto& [a, b, c] = corner;
  const double whole = static_cast<double>(doubled_area(a, b, c));
  return {static_cast<double>(doubled_area(b, c, z)) / whole, static_cast<double>(doubled_area(c, a, z)) / whole,
          static_cast<double>(doubled_area(a, b, z)) / whole};
}

} // namespace internal

} } // namespace CGAL::Quartic_differentials
