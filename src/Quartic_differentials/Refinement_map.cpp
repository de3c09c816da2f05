// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Refinement_map.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;

double cross(Complex a, Complex b) { return a.real() * b.imag() - a.imag() * b.real(); }

Complex on_segment(Complex source, Complex target, double t) { return source + t * (target - source); }

// the position in face(h) of `t`, unfolded, of a point at fraction `along` of the edge's first halfedge
Complex on_halfedge(const Intrinsic_triangulation& t, const std::array<Complex, 3>& unfolded, Halfedge h, double along)
{
  const int k = t.corner(h);
  const Complex source = unfolded[k], target = unfolded[(k + 1) % 3];
  return is_first_of_its_edge(h) ? on_segment(source, target, along) : on_segment(target, source, along);
}

Complex unfold(const std::array<Complex, 3>& corner, const std::array<double, 3>& b)
{
  return b[0] * corner[0] + b[1] * corner[1] + b[2] * corner[2];
}

// barycentric coordinates, clamped to the closed triangle
std::array<double, 3> barycentric(const std::array<Complex, 3>& corner, Complex z)
{
  std::array<double, 3> b;
  for (int k = 0; k < 3; ++k)
    b[k] = std::max(0.0, cross(corner[(k + 1) % 3] - z, corner[(k + 2) % 3] - z));
  const double sum = b[0] + b[1] + b[2];
  for (double& x : b) x /= sum;
  return b;
}

} // namespace

Refinement_map::Refinement_map(const Refinement_cells& cells, const Common_refinement& refinement,
                               const Intrinsic_triangulation& c)
  : m_cells(cells.cells())
{
  const Intrinsic_triangulation& a = refinement.input();
  m_c.faces.reserve(c.number_of_faces());
  m_a.faces.reserve(a.number_of_faces());
  for (Face f : c.faces()) m_c.faces.push_back(c.unfolded(f));
  for (Face f : a.faces()) m_a.faces.push_back(a.unfolded(f));
  m_c.corners.reserve(cells.corners().size());
  m_a.corners.reserve(cells.corners().size());
  for (const Cell_corner& corner : cells.corners()) {
    const auto &in_c = m_c.faces[c.face(corner.c)], &in_a = m_a.faces[a.face(corner.a)];
    if (corner.crossing.is_none()) {
      m_c.corners.push_back(in_c[c.corner(corner.c)]);
      m_a.corners.push_back(in_a[a.corner(corner.a)]);
    }
    else {
      const Crossing& x = refinement[corner.crossing];
      m_c.corners.push_back(on_halfedge(c, in_c, corner.c, x.position_on_c()));
      m_a.corners.push_back(on_halfedge(a, in_a, corner.a, x.position_on_a()));
    }
  }
  m_c.cells_in = {c.number_of_faces(), m_cells.size(), [&](std::size_t i) { return m_cells[i].c_face; }};
  m_a.cells_in = {a.number_of_faces(), m_cells.size(), [&](std::size_t i) { return m_cells[i].a_face; }};
  for (Halfedge h : c.halfedges()) {
    if (!c.is_border(h)) continue;
    const Halfedge in = c.opposite(h);   // no boundary edge is flipped: it is one of both
    const Side in_c{c.face(in), c.corner(in)}, in_a{a.face(in), a.corner(in)};
    m_c_side[in_a] = in_c;
    m_a_side[in_c] = in_a;
  }
}

std::optional<Surface_point> Refinement_map::mapped_along_boundary(const Surface_point& p, const Sides& other_side)
{
  for (int k = 0; k < 3; ++k) {
    if (p.barycentric[(k + 2) % 3] != 0) continue;
    const auto it = other_side.find({p.face, k});
    if (it == other_side.end()) continue;
    Surface_point q{it->second.face, {0, 0, 0}};
    for (int end : {0, 1}) q.barycentric[(it->second.number + end) % 3] = p.barycentric[(k + end) % 3];
    return q;
  }
  return std::nullopt;
}

std::vector<Complex> Refinement_map::polygon(const Layout& layout, const Refinement_cell& cell) const
{
  return {layout.corners.begin() + cell.first_corner, layout.corners.begin() + cell.last_corner};
}

// the smallest signed distance of z from the lines through the sides of a cell, positive inside
double Refinement_map::depth(const Layout& layout, const Refinement_cell& cell, Complex z) const
{
  double depth = std::numeric_limits<double>::infinity();
  Complex p = layout.corners[cell.last_corner - 1];
  for (std::size_t i = cell.first_corner; i < cell.last_corner; ++i) {
    const Complex q = layout.corners[i];
    if (q != p) depth = std::min(depth, cross(q - p, z - p) / std::abs(q - p));
    p = q;
  }
  return depth;
}

const Refinement_cell& Refinement_map::cell_at(const Layout& layout, Face f, Complex z) const
{
  const Refinement_cell* best = nullptr;
  double best_depth = 0;
  for (std::size_t i : layout.cells_in[f]) {
    const Refinement_cell& cell = m_cells[i];
    const double d = depth(layout, cell, z);
    if (best == nullptr || d > best_depth) { best = &cell; best_depth = d; }
  }
  return *best;
}

// the similarity that takes the two farthest corners of the cell in `from` to the same corners in `to`. The two
// polygons are congruent, and through the farthest corners this is well conditioned for needles too.
Complex Refinement_map::mapped(const Refinement_cell& cell, const Layout& from, const Layout& to, Complex z) const
{
  std::size_t p = cell.first_corner, q = p;
  for (std::size_t i = cell.first_corner; i < cell.last_corner; ++i)
    for (std::size_t j = i + 1; j < cell.last_corner; ++j)
      if (std::norm(from.corners[j] - from.corners[i]) > std::norm(from.corners[q] - from.corners[p])) { p = i; q = j; }
  const Complex place = (z - from.corners[p]) / (from.corners[q] - from.corners[p]);
  return to.corners[p] + place * (to.corners[q] - to.corners[p]);
}

Surface_point Refinement_map::to_input(const Surface_point& p) const
{
  if (const auto on_boundary = mapped_along_boundary(p, m_a_side)) return *on_boundary;
  const Complex z = unfold(m_c.faces[p.face], p.barycentric);
  const Refinement_cell& cell = cell_at(m_c, p.face, z);
  return {cell.a_face, barycentric(m_a.faces[cell.a_face], mapped(cell, m_c, m_a, z))};
}

Surface_point Refinement_map::from_input(const Surface_point& p) const
{
  if (const auto on_boundary = mapped_along_boundary(p, m_c_side)) return *on_boundary;
  const Complex z = unfold(m_a.faces[p.face], p.barycentric);
  const Refinement_cell& cell = cell_at(m_a, p.face, z);
  return {cell.c_face, barycentric(m_c.faces[cell.c_face], mapped(cell, m_a, m_c, z))};
}

} } // namespace CGAL::Quartic_differentials
