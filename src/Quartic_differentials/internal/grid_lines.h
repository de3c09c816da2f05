// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_GRID_LINES_H
#define CGAL_QUARTIC_DIFFERENTIALS_GRID_LINES_H

// Axis-parallel lines in the charts of a quartic differential, exactly.
//
// Notation (METHOD, step 8)
//   d      a direction, the unit vector i^d
//   level  the line's distance to the left of the origin, i^d x z
//   clock  tau: whoever runs along the line is at z at the time <i^d, z> + tau

#include <CGAL/Quartic_differentials/Quartic_differential.h>

#include <cstdint>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// <i^d, v>
inline std::int64_t along(int d, Grid_vector v)
{
  switch (d & 3) {
    case 0:  return v.x;
    case 1:  return v.y;
    case 2:  return -v.x;
    default: return -v.y;
  }
}

/// i^d x v, positive if v points to the left of i^d
inline std::int64_t across(int d, Grid_vector v) { return along(d + 1, v); }

/// A line that is run along with unit speed.
struct Ray
{
  int          direction;
  std::int64_t level, clock;

  std::int64_t time(Grid_vector z) const { return along(direction, z) + clock; }
  Grid_vector  at(std::int64_t time) const { return rotated({time - clock, level}, direction); }
  /// positive if z is on the left, 0 if it is on the line
  std::int64_t side(Grid_vector z) const { return across(direction, z) - level; }

  Ray reversed() const { return {direction ^ 2, -level, -clock}; }
  Ray seen_through(const Transition& t) const
  {
    const int d = (direction + t.rotation) & 3;
    return {d, level + across(d, t.translation), clock - along(d, t.translation)};
  }
};

/// the ray in direction d that is at z at the given time
inline Ray ray_through(Grid_vector z, int d, std::int64_t time) { return {d, across(d, z), time - along(d, z)}; }

/// \pre the directions are perpendicular
inline Grid_vector crossing_point(const Ray& a, const Ray& b)
{
  const bool left = ((b.direction - a.direction) & 3) == 1;
  return rotated({left ? -b.level : b.level, a.level}, a.direction);
}

/// The charts with doubled coordinates, in which a T-mesh lives.
class Doubled_charts
{
public:
  explicit Doubled_charts(const Quartic_differential& q) : m_q(q) {}

  const Intrinsic_triangulation& triangulation() const { return m_q.triangulation; }

  Grid_vector corner(Halfedge h) const { return m_q.corner[h] + m_q.corner[h]; }
  Transition transition(Halfedge h) const
  {
    const Transition& t = m_q.transition[h];
    return {t.rotation, t.translation + t.translation};
  }

  /// whether i^d points from source(h) into face(h), or along h
  bool corner_holds(Halfedge h, int d) const
  {
    const Grid_vector p = corner(h), right = corner(triangulation().next(h)) - p,
                      left = corner(triangulation().prev(h)) - p;
    const std::int64_t s = across(d, right);
    return s == 0 ? along(d, right) > 0 : s < 0 && across(d, left) > 0;
  }

  /// whether z is in the closed triangle
  bool face_holds(Face f, Grid_vector z) const
  {
    const auto [h0, h1, h2] = triangulation().halfedges(f);
    const Grid_vector a = corner(h0), b = corner(h1), c = corner(h2);
    return doubled_area(a, b, z) >= 0 && doubled_area(b, c, z) >= 0 && doubled_area(c, a, z) >= 0;
  }

private:
  const Quartic_differential& m_q;
};

} // namespace internal
} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_GRID_LINES_H
