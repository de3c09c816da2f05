// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Refinement_cells.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace CGAL {
namespace Quartic_differentials {

namespace {

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

} // namespace

Refinement_cells::Refinement_cells(const Common_refinement& refinement, const Intrinsic_triangulation& c)
{
  const Intrinsic_triangulation& a = refinement.input();
  const std::size_t pieces = 2 * refinement.number_of_crossings();   // of A edges, at most: one more than crossings on each
  m_cells.reserve(c.number_of_faces() + pieces);
  m_corners.reserve(c.number_of_halfedges() + 3 * pieces);
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
}

} } // namespace CGAL::Quartic_differentials
