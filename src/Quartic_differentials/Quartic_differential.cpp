// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Quartic_differential.h>
#include <CGAL/Quartic_differentials/divisor.h>

#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

std::string vertex_name(Vertex v) { return "vertex " + std::to_string(v.idx()); }

__int128 cross(Grid_vector a, Grid_vector b)
{
  return static_cast<__int128>(a.x) * b.y - static_cast<__int128>(a.y) * b.x;
}

std::string defect_of_sizes(const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  if (q.corner.size() != t.number_of_halfedges() || q.transition.size() != t.number_of_halfedges())
    return "corners and transitions do not match the halfedges in number";
  if (q.order.size() != t.number_of_vertices()) return "orders do not match the vertices in number";
  const std::int64_t bound = std::int64_t(1) << 61;
  for (Grid_vector z : q.corner)
    if (z.x <= -bound || z.x >= bound || z.y <= -bound || z.y >= bound) return "a coordinate is beyond 2^61";
  return {};
}

std::string defect_of_triangles(const Quartic_differential& q)
{
  for (Face f : q.triangulation.faces()) {
    const auto [h0, h1, h2] = q.triangulation.halfedges(f);
    if (doubled_area(q.corner[h0], q.corner[h1], q.corner[h2]) <= 0)
      return "triangle " + std::to_string(f.idx()) + " is not positively oriented";
  }
  return {};
}

std::string defect_of_transitions(const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  for (Halfedge h : t.halfedges()) {
    const Transition& across = q.transition[h];
    const Halfedge o = t.opposite(h);
    if (t.is_border(h)) continue;
    if (t.is_border(o)) {
      const Grid_vector along = q.corner[t.next(h)] - q.corner[h];
      if (along.x != 0 && along.y != 0)
        return "the boundary edge at halfedge " + std::to_string(h.idx()) + " is not parallel to an axis";
      continue;
    }
    if (across.rotation < 0 || across.rotation > 3)
      return "the rotation across halfedge " + std::to_string(h.idx()) + " is not 0, 1, 2 or 3";
    if (across(q.corner[h]) != q.corner[t.next(o)] || across(q.corner[t.next(h)]) != q.corner[o])
      return "the charts at halfedge " + std::to_string(h.idx()) + " do not differ by its transition";
  }
  return {};
}

// The number of directions 1, i, -1, -i in the corner at source(h), the side along h included. Frames at a vertex differ
// by multiples of 90 degrees, so the corners round it hold one direction for every 90 degrees.
int axes_in_corner(const Quartic_differential& q, Halfedge h)
{
  const Intrinsic_triangulation& t = q.triangulation;
  const Grid_vector right = q.corner[t.next(h)] - q.corner[h], left = q.corner[t.prev(h)] - q.corner[h];
  int n = 0;
  for (int k = 0; k < 4; ++k) {
    const Grid_vector axis = rotated({1, 0}, k);
    if (cross(right, axis) >= 0 && cross(axis, left) > 0) ++n;
  }
  return n;
}

// The angle between two boundary edges, which are parallel to axes. (the last one is not held by a corner)
std::string defect_of_boundary_vertex(const Quartic_differential& q, Vertex v)
{
  const Intrinsic_triangulation& t = q.triangulation;
  int quarters = 0;
  for (Halfedge h = t.halfedge_from(v); !t.is_border(h); h = t.next_around_source(h)) quarters += axes_in_corner(q, h);
  if (quarters == q.order[v] + 2) return {};
  return "the angle at " + vertex_name(v) + " of the boundary is " + std::to_string(quarters) + "*90 degrees, its order "
       + std::to_string(q.order[v]);
}

std::string defect_of_vertex(const Quartic_differential& q, Vertex v)
{
  const Intrinsic_triangulation& t = q.triangulation;
  if (t.is_border(v)) return defect_of_boundary_vertex(q, v);
  const Halfedge first = t.halfedge_from(v);
  Halfedge h = first;
  Transition round;
  int quarters = 0;
  do {
    quarters += axes_in_corner(q, h);
    round = round.then(q.transition[t.prev(h)]);
    h = t.next_around_source(h);
  } while (h != first);
  if (round.rotation != (-q.order[v] & 3) || round(q.corner[first]) != q.corner[first])
    return "the transitions round " + vertex_name(v) + " do not compose to the rotation of its order";
  if (quarters != q.order[v] + 4)
    return "the angle at " + vertex_name(v) + " is " + std::to_string(quarters) + "*90 degrees, its order "
         + std::to_string(q.order[v]);
  return {};
}

std::string defect_of_divisor(const Quartic_differential& q)
{
  std::vector<char> listed(q.order.size(), false);
  int degree = 0;
  for (Vertex v : q.singularities) {
    if (v.idx() >= q.order.size()) return "a singularity is at no vertex";
    if (listed[v]) return vertex_name(v) + " is listed twice as a singularity";
    listed[v] = true;
    degree += q.order[v];
  }
  for (Vertex v : q.triangulation.vertices())
    if (q.order[v] != 0 && !listed[v]) return vertex_name(v) + " has an order but is not listed as a singularity";
  if (const int right_degree = required_degree(q.triangulation); degree != right_degree)
    return "the degree is " + std::to_string(degree) + " instead of 8g - 8"
         + (q.triangulation.has_boundary() ? " + 4b" : "") + " = " + std::to_string(right_degree);
  return {};
}

} // namespace

std::complex<double> Quartic_differential::chart(const Surface_point& p) const
{
  const auto h = triangulation.halfedges(p.face);
  std::complex<double> z = 0;
  for (int k = 0; k < 3; ++k)
    z += p.barycentric[k] * std::complex<double>(static_cast<double>(corner[h[k]].x), static_cast<double>(corner[h[k]].y));
  return z * std::ldexp(1.0, -grid_exponent);
}

__int128 Quartic_differential::doubled_area() const
{
  __int128 sum = 0;
  for (Face f : triangulation.faces()) {
    const auto [h0, h1, h2] = triangulation.halfedges(f);
    sum += Quartic_differentials::doubled_area(corner[h0], corner[h1], corner[h2]);
  }
  return sum;
}

std::string defect(const Quartic_differential& q)
{
  for (const auto check : {defect_of_sizes, defect_of_triangles, defect_of_transitions, defect_of_divisor}) {
    const std::string violation = check(q);
    if (!violation.empty()) return violation;
  }
  for (Vertex v : q.triangulation.vertices()) {
    const std::string violation = defect_of_vertex(q, v);
    if (!violation.empty()) return violation;
  }
  return {};
}

} } // namespace CGAL::Quartic_differentials
