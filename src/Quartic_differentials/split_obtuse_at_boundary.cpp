// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/split_obtuse_at_boundary.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double barely = 1e-9;   // radians, in effect: right angles made by a split are not obtuse

// A part of a boundary edge of the input: its halfedge in a face, and where the part lies on it, as fractions.
struct Part
{
  Halfedge whole;
  double   begin = 0, end = 1;
};

// Where the foot of the altitude on the boundary edge h of its triangle lies, as a fraction of its length.
double foot_fraction(const Intrinsic_triangulation& t, Halfedge h)
{
  const double whole = t.length(h), back = t.length(t.prev(h)), across = t.length(t.next(h));
  return (whole * whole + back * back - across * across) / (2 * whole * whole);
}

bool is_obtuse_opposite(const Intrinsic_triangulation& t, Halfedge h)
{
  const double whole = t.length(h), back = t.length(t.prev(h)), across = t.length(t.next(h));
  return back * back + across * across - whole * whole < -2 * barely * back * across;
}

// The intrinsic Delaunay triangulation of a surface, with its boundary edges as parts of those of the surface.
class Delaunay_with_parts
{
public:
  explicit Delaunay_with_parts(const Intrinsic_triangulation& t) : m_t(t), m_part(t.number_of_edges())
  {
    for (const auto& curve : t.boundary_curves())
      for (Halfedge h : curve) m_part[t.edge(h)].whole = h;
    make_delaunay(m_t);
  }

  // Splits every boundary edge that is opposite an obtuse angle, and makes the triangulation Delaunay again; calls
  // `visit(part, fraction)` for each. Returns whether there were any.
  template <class Visit>
  bool split(Visit visit)
  {
    std::vector<Halfedge> obtuse;
    for (const auto& curve : m_t.boundary_curves())
      for (Halfedge h : curve)
        if (is_obtuse_opposite(m_t, h)) obtuse.push_back(h);
    for (Halfedge h : obtuse) split(h, visit);
    make_delaunay(m_t);
    return !obtuse.empty();
  }

private:
  template <class Visit>
  void split(Halfedge h, Visit visit)
  {
    const double fraction = foot_fraction(m_t, h);
    const Part part = m_part[m_t.edge(h)];
    const double at = part.begin + fraction * (part.end - part.begin);
    visit(part.whole, at);
    const auto s = m_t.split_boundary_edge(h, fraction);
    m_part.resize(m_t.number_of_edges());
    m_part[m_t.edge(s.first)] = {part.whole, part.begin, at};
    m_part[m_t.edge(s.second)] = {part.whole, at, part.end};
  }

  Intrinsic_triangulation m_t;
  std::vector<Part>       m_part;   // by edge, of boundary edges
};

// Where a point of a face is after the split of its boundary edge v0 v1 at p = (1 - s) v0 + s v1.
// \param k the corner at v0, before the split
Surface_point after_split(const Intrinsic_triangulation& t, const Surface_point& at, int k, double s,
                          const Intrinsic_triangulation::Boundary_split& split)
{
  const double b0 = at.barycentric[k], b1 = at.barycentric[(k + 1) % 3], b2 = at.barycentric[(k + 2) % 3];
  const bool is_first = b1 * (1 - s) <= b0 * s;
  const Halfedge h = is_first ? split.first : split.second;
  const std::array<double, 3> b = is_first ? std::array<double, 3>{b0 - b1 * (1 - s) / s, b1 / s, b2}
                                           : std::array<double, 3>{b0 / (1 - s), b1 - b0 * s / (1 - s), b2};
  Surface_point result{t.face(h), {}};
  for (int i = 0; i < 3; ++i) result.barycentric[(t.corner(h) + i) % 3] = std::max(0.0, b[i]);
  return result;
}

// Splits a boundary edge at the given fractions of its length.
void split_at(Intrinsic_triangulation& t, Halfedge h, std::vector<double> fractions, Divisor& divisor)
{
  std::sort(fractions.begin(), fractions.end());
  const Point_3 from = t.mesh().point(t.source(h)), to = t.mesh().point(t.target(h));
  double begin = 0;
  for (double at : fractions) {
    const double fraction = (at - begin) / (1 - begin);
    const Face f = t.face(h);
    const int corner = t.corner(h);
    const auto s = t.split_boundary_edge(h, fraction);
    for (Singularity& p : divisor)
      if (p.location.face == f) p.location = after_split(t, p.location, corner, fraction, s);
    if (t.is_embedded()) t.set_point(s.vertex, from + at * (to - from));
    h = s.second;
    begin = at;
  }
}

} // namespace

std::size_t split_obtuse_at_boundary(Intrinsic_triangulation& t)
{
  Divisor none;
  return split_obtuse_at_boundary(t, none);
}

std::size_t split_obtuse_at_boundary(Intrinsic_triangulation& t, Divisor& divisor)
{
  const std::size_t most = t.number_of_edges() + 1000;
  Delaunay_with_parts delaunay(t);
  std::map<Halfedge, std::vector<double>> fractions;
  std::size_t added = 0;
  while (delaunay.split([&](Halfedge whole, double at) { fractions[whole].push_back(at); ++added; }))
    if (added > most)
      throw Numerical_error("the boundary still has obtuse triangles after " + std::to_string(added) + " splits: the surface "
                            "has needles there");
  for (auto& [h, at] : fractions) split_at(t, h, at, divisor);
  return added;
}

} } // namespace CGAL::Quartic_differentials
