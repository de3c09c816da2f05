// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Refinement_cells.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;

double cross(Complex a, Complex b) { return a.real() * b.imag() - a.imag() * b.real(); }

// A point on the boundary of a C face.
struct Ring_point
{
  Halfedge    c;          // where it lies; a corner is the source
  Crossing_id crossing;   // none at a corner
};

// A part of an A edge that cuts a face in two: from one ring point to a later one.
struct Chord
{
  std::size_t from, to;
  Halfedge    a;          // directed like the chord

  friend bool operator<(const Chord& x, const Chord& y)   // nested chords: the inner one first
  { return std::make_tuple(x.to - x.from, x.from) < std::make_tuple(y.to - y.from, y.from); }
};

// A side of a cell: starts at a ring point, and has on its left the face of the A halfedge it lies on, if it does.
struct Cell_side
{
  std::size_t from;
  Halfedge    a;   // null on a C edge
};

// One face of C after the other with the A edges in it.
class Cut_face
{
public:
  Cut_face(const Common_refinement& refinement, const Intrinsic_triangulation& triangulation)
    : r(refinement), c(triangulation) {}

  void go_to(Face f)
  {
    sides = c.halfedges(f);
    ring.clear();
    for (int k = 0; k < 3; ++k) {
      const auto n = static_cast<Mesh::size_type>(r.crossings(c.edge(sides[k])).size());
      corner[k] = ring.size();
      ring.push_back({sides[k], Crossing_id()});
      for (Mesh::size_type i = 0; i < n; ++i)
        ring.push_back({sides[k], {c.edge(sides[k]), is_first_of_its_edge(sides[k]) ? i : n - 1 - i}});
    }
  }

  const Ring_point& point(std::size_t i) const { return ring[i]; }

  // cuts off cell after cell along the chords, inner chords first, and calls `cell(sides)` for each.
  template <class Cell> void for_each_cell(Cell cell)
  {
    side.resize(ring.size());
    after.resize(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      side[i] = {i, ring[i].crossing.is_none() ? r.coincident(ring[i].c) : Mesh::null_halfedge()};
      after[i] = i + 1 == ring.size() ? 0 : i + 1;
    }
    find_chords();
    for (const Chord& chord : chords) {
      sides_of_cell.clear();
      for (std::size_t i = chord.from; i != chord.to; i = after[i]) sides_of_cell.push_back(side[i]);
      sides_of_cell.push_back({chord.to, r.input().opposite(chord.a)});
      cell(sides_of_cell);
      side[chord.from].a = chord.a;
      after[chord.from] = chord.to;
    }
    sides_of_cell.clear();
    std::size_t i = 0;
    do { sides_of_cell.push_back(side[i]); i = after[i]; } while (i != 0);
    cell(sides_of_cell);
  }

private:
  int index_of(Halfedge h) const { return h == sides[0] ? 0 : h == sides[1] ? 1 : 2; }

  std::size_t ring_index(Halfedge h, Crossing_id id) const
  {
    const int k = index_of(h);
    if (is_first_of_its_edge(h)) return corner[k] + 1 + id.rank;
    return (k == 2 ? ring.size() : corner[k + 1]) - 1 - id.rank;
  }

  void find_chords()
  {
    chords.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (ring[i].crossing.is_none()) continue;
      const Crossing& x = r[ring[i].crossing];
      const Common_refinement::Step step = r.step(x, ring[i].c);
      const Halfedge first = first_halfedge(x.a), a = step.forward ? first : r.input().opposite(first);
      const bool ends_at_corner = step.to.is_none();
      const std::size_t j = ends_at_corner ? corner[(index_of(ring[i].c) + 2) % 3] : ring_index(step.at, step.to);
      if (i < j) chords.push_back({i, j, a});
      else if (ends_at_corner) chords.push_back({j, i, r.input().opposite(a)});
    }
    std::sort(chords.begin(), chords.end());
  }

  const Common_refinement&       r;
  const Intrinsic_triangulation& c;
  std::array<Halfedge, 3>        sides;
  std::array<std::size_t, 3>     corner;
  std::vector<Ring_point>        ring;
  std::vector<Cell_side>         side, sides_of_cell;   // of what is left of the face, by where it starts; of a cell
  std::vector<std::size_t>       after;                 // the ring point that follows, round what is left
  std::vector<Chord>             chords;
};

// the halfedge of the cell's A face on which the start of `side` lies (whose source it is, at a vertex)
Halfedge a_halfedge(const Intrinsic_triangulation& a, const Cell_side& before, const Cell_side& side,
                    const Cell_side& after, bool is_vertex)
{
  if (side.a != Mesh::null_halfedge()) return side.a;
  if (before.a != Mesh::null_halfedge()) return is_vertex ? a.next(before.a) : before.a;
  return a.prev(after.a);   // both C edges run inside the A face, and leave it through the opposite edge
}

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

Refinement_cells::Refinement_cells(const Common_refinement& refinement, const Intrinsic_triangulation& c)
{
  const Intrinsic_triangulation& a = refinement.input();
  m_c.faces.reserve(c.number_of_faces());
  m_a.faces.reserve(a.number_of_faces());
  for (Face f : c.faces()) m_c.faces.push_back(c.unfolded(f));
  for (Face f : a.faces()) m_a.faces.push_back(a.unfolded(f));

  m_cells.reserve(c.number_of_faces());
  m_corners.reserve(3 * c.number_of_faces());
  Cut_face cut(refinement, c);
  for (Face f : c.faces()) {
    cut.go_to(f);
    cut.for_each_cell([&](const std::vector<Cell_side>& side) {
      const std::size_t n = side.size(), first = m_corners.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Ring_point& point = cut.point(side[i].from);
        const Cell_side &before = side[(i == 0 ? n : i) - 1], &after = side[i + 1 == n ? 0 : i + 1];
        m_corners.push_back({point.c, a_halfedge(a, before, side[i], after, point.crossing.is_none()), point.crossing});
      }
      m_cells.push_back({f, a.face(m_corners[first].a), first, m_corners.size()});
    });
  }
  m_c.corners.reserve(m_corners.size());
  m_a.corners.reserve(m_corners.size());
  for (const Cell_corner& corner : m_corners) {
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
  sort_into_faces(m_c, [](const Refinement_cell& cell) { return cell.c_face; });
  sort_into_faces(m_a, [](const Refinement_cell& cell) { return cell.a_face; });
  for (Halfedge h : c.halfedges()) {
    if (!c.is_border(h)) continue;
    const Halfedge in = c.opposite(h);   // no boundary edge is flipped: it is one of both
    const Side in_c{c.face(in), c.corner(in)}, in_a{a.face(in), a.corner(in)};
    m_c_side[in_a] = in_c;
    m_a_side[in_c] = in_a;
  }
}

std::optional<Surface_point> Refinement_cells::mapped_along_boundary(const Surface_point& p, const Sides& other_side)
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

template <class Face_of> void Refinement_cells::sort_into_faces(Layout& layout, Face_of face_of) const
{
  layout.first_in_face.assign(layout.faces.size() + 1, 0);
  for (const Refinement_cell& cell : m_cells) ++layout.first_in_face[face_of(cell) + 1];
  for (std::size_t f = 0; f < layout.faces.size(); ++f) layout.first_in_face[f + 1] += layout.first_in_face[f];
  layout.cells_by_face.resize(m_cells.size());
  std::vector<std::size_t> next = layout.first_in_face;
  for (std::size_t i = 0; i < m_cells.size(); ++i) layout.cells_by_face[next[face_of(m_cells[i])]++] = i;
}

std::vector<Complex> Refinement_cells::polygon(const Layout& layout, const Refinement_cell& cell) const
{
  return {layout.corners.begin() + cell.first_corner, layout.corners.begin() + cell.last_corner};
}

// the smallest signed distance of z from the lines through the sides of a cell, positive inside
double Refinement_cells::depth(const Layout& layout, const Refinement_cell& cell, Complex z) const
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

const Refinement_cell& Refinement_cells::cell_at(const Layout& layout, Face f, Complex z) const
{
  const Refinement_cell* best = nullptr;
  double best_depth = 0;
  for (std::size_t i = layout.first_in_face[f]; i < layout.first_in_face[f + 1]; ++i) {
    const Refinement_cell& cell = m_cells[layout.cells_by_face[i]];
    const double d = depth(layout, cell, z);
    if (best == nullptr || d > best_depth) { best = &cell; best_depth = d; }
  }
  return *best;
}

// the similarity that takes the two farthest corners of the cell in `from` to the same corners in `to`. The two
// polygons are congruent, and through the farthest corners this is well conditioned for needles too.
Complex Refinement_cells::mapped(const Refinement_cell& cell, const Layout& from, const Layout& to, Complex z) const
{
  std::size_t p = cell.first_corner, q = p;
  for (std::size_t i = cell.first_corner; i < cell.last_corner; ++i)
    for (std::size_t j = i + 1; j < cell.last_corner; ++j)
      if (std::norm(from.corners[j] - from.corners[i]) > std::norm(from.corners[q] - from.corners[p])) { p = i; q = j; }
  const Complex place = (z - from.corners[p]) / (from.corners[q] - from.corners[p]);
  return to.corners[p] + place * (to.corners[q] - to.corners[p]);
}

Surface_point Refinement_cells::to_input(const Surface_point& p) const
{
  if (const auto on_boundary = mapped_along_boundary(p, m_a_side)) return *on_boundary;
  const Complex z = unfold(m_c.faces[p.face], p.barycentric);
  const Refinement_cell& cell = cell_at(m_c, p.face, z);
  return {cell.a_face, barycentric(m_a.faces[cell.a_face], mapped(cell, m_c, m_a, z))};
}

Surface_point Refinement_cells::from_input(const Surface_point& p) const
{
  if (const auto on_boundary = mapped_along_boundary(p, m_c_side)) return *on_boundary;
  const Complex z = unfold(m_a.faces[p.face], p.barycentric);
  const Refinement_cell& cell = cell_at(m_a, p.face, z);
  return {cell.c_face, barycentric(m_c.faces[cell.c_face], mapped(cell, m_a, m_c, z))};
}

} } // namespace CGAL::Quartic_differentials
