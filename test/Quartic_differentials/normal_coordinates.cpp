// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The common refinement against a second representation that knows nothing of crossings: normal coordinates and
// roundabouts, a few integers per edge of the flipped triangulation with a flip rule in closed form (Gillespie, Sharp
// and Crane, "Integer coordinates for intrinsic geometry processing", ACM Transactions on Graphics 40(6), 2021).
// Both ride along on random flip sequences; after every flip the numbers of crossings, at the end of every sequence the
// ways of all input edges over the flipped triangulation must be the same.

#include "check.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

// Notation
//   A, C   the input triangulation and the flipped one, as in Common_refinement.h
//   n(e)   normal coordinate of a C edge: the number of A edges that cross it, or -n if it lies on n parallel A edges.
//          On a triangulated surface only n = -1 and n > 0 occur: a C edge that nothing crosses lies in a face of A.
//   arc    a piece of an A edge in a triangle of C. It goes round a corner, from a side to the next one, or it comes
//          from a corner, through the opposite side. Arcs do not meet, so arcs come from at most one of the corners.

int positive(int n) { return std::max(n, 0); }

// The number of arcs that come from a corner of a triangle, from n on the side `opposite` to the corner and on the two
// sides that meet there.
int arcs_from_corner(int opposite, int side, int other_side)
{
  return positive(positive(opposite) - positive(side) - positive(other_side));
}

// the number of arcs that go round the corner
int arcs_round_corner(int opposite, int side, int other_side)
{
  const int twice = positive(positive(side) + positive(other_side) - positive(opposite));
  return (twice - arcs_from_corner(side, other_side, opposite) - arcs_from_corner(other_side, opposite, side)) / 2;
}

enum class Way { round_source, to_corner, round_target };

// where the x-th arc that crosses a side of a triangle, counted from the source of the side, goes on from there
Way way_of_arc(int x, int side, int next, int prev)
{
  if (x < arcs_round_corner(next, side, prev)) return Way::round_source;
  return x >= side - arcs_round_corner(prev, side, next) ? Way::round_target : Way::to_corner;
}

// n(kl) after the flip of ij, in the quadrilateral of the triangles (ij, jk, ki) and (ji, il, lj).
//
// Everything that comes from i or j or goes round k or l crosses kl, and so do A edges on ij. Of the arcs through ij,
// let c_i, c_j go round i, j and e_k go to k above ij, and d_i, d_j, e_l the same below. In order from i to j those are
// c_i, e_k, c_j above and d_i, e_l, d_j below, so
//   max(c_i - d_i - e_l, 0) + max(d_i - c_i - e_k, 0) = (|c_i - d_i| + |c_j - d_j| - e_k - e_l)/2 + (arcs from k to l)
// pass from one side of kl to the other. If there are arcs from k to l, nothing crosses kl, and without the last term
// the sum is minus their number.
int flipped_coordinate(int ij, int jk, int ki, int il, int lj)
{
  const int round_k_and_l = arcs_round_corner(ij, jk, ki) + arcs_round_corner(ij, il, lj);
  const int from_k_and_l = arcs_from_corner(ij, jk, ki) + arcs_from_corner(ij, il, lj);
  const int from_i = arcs_from_corner(jk, ki, ij) + arcs_from_corner(lj, ij, il);
  const int from_j = arcs_from_corner(ki, ij, jk) + arcs_from_corner(il, lj, ij);
  const int difference_at_i = arcs_round_corner(jk, ki, ij) - arcs_round_corner(lj, ij, il);
  const int difference_at_j = arcs_round_corner(ki, ij, jk) - arcs_round_corner(il, lj, ij);
  return round_k_and_l + from_i + from_j + positive(-ij)
       + (std::abs(difference_at_i) + std::abs(difference_at_j) - from_k_and_l) / 2;
}

// The normal coordinates of A on C, and its roundabouts: for every C halfedge the first A halfedge from the same vertex
// counterclockwise from it, or on it. They say which A edge is which.
class Normal_coordinates
{
public:
  explicit Normal_coordinates(const Intrinsic_triangulation& a)
    : m_a(a), m_n(a.number_of_edges(), -1), m_roundabout(a.halfedges().begin(), a.halfedges().end())
  {}

  int& operator[](Edge c)           { return m_n[c]; }
  int  operator[](Edge c) const     { return m_n[c]; }
  int  operator[](Halfedge c) const { return m_n[m_a.edge(c)]; }
  Halfedge roundabout(Halfedge c) const { return m_roundabout[c]; }

  void before_flip(const Edge_flip& f)
  {
    const Normal_coordinates& n = *this;
    m_n[f.edge] = flipped_coordinate(n[f.ij], n[f.jk], n[f.ki], n[f.il], n[f.lj]);
    // afterwards ij and ji run from k to l and back, in the triangles (ij, lj, jk) and (ji, ki, il)
    m_roundabout[f.ij] = from_corner(f.ki, arcs_from_corner(n[f.il], n[f.ij], n[f.ki]));
    m_roundabout[f.ji] = from_corner(f.lj, arcs_from_corner(n[f.jk], n[f.ij], n[f.lj]));
  }

  // A halfedges from the corner of face(h) at source(h)
  int number_from_corner(const Intrinsic_triangulation& c, Halfedge h) const
  { return arcs_from_corner((*this)[c.next(h)], (*this)[h], (*this)[c.prev(h)]); }

  // the m-th A halfedge after the C halfedge h, counterclockwise, which does not count itself if it is one
  Halfedge from_corner(Halfedge h, int m) const
  {
    Halfedge a = m_roundabout[h];
    for (int i = 0; i < m + positive(-(*this)[h]); ++i) a = m_a.next_around_source(a);
    return a;
  }

  struct Trace
  {
    std::vector<Crossing_id> crossings;
    Halfedge                 end;      // the A halfedge back along the way, according to where it ends; null if nowhere
    Vertex                   target;
  };

  // follows the m-th A halfedge from the corner of face(h) at source(h), by integers only
  Trace trace(const Intrinsic_triangulation& c, Halfedge h, int m) const
  {
    const Normal_coordinates& n = *this;
    Halfedge side = c.next(h);       // the way leaves a face through it, as the x-th from its source
    int x = arcs_round_corner(n[c.prev(h)], n[h], n[side]) + m;
    Trace result;
    for (int steps = total(); steps >= 0; --steps) {   // no way can be longer, but one by wrong integers may not end
      result.crossings.push_back(crossing(side, x));
      const Halfedge entry = c.opposite(side), next = c.next(entry), prev = c.prev(entry);
      const int x_on_entry = n[entry] - 1 - x;
      switch (way_of_arc(x_on_entry, n[entry], n[next], n[prev])) {
        case Way::round_source: side = prev; x = n[prev] - 1 - x_on_entry; break;
        case Way::round_target: side = next; break;    // as far from target(entry) as before
        case Way::to_corner:
          result.end = from_corner(prev, x_on_entry - arcs_round_corner(n[next], n[entry], n[prev]));
          result.target = c.source(prev);
          return result;
      }
    }
    return result;
  }

private:
  Crossing_id crossing(Halfedge h, int x) const
  {
    const int rank = is_first_of_its_edge(h) ? x : (*this)[h] - 1 - x;
    return {m_a.edge(h), static_cast<Mesh::size_type>(rank)};
  }

  int total() const
  {
    int sum = 0;
    for (int n : m_n) sum += positive(n);
    return sum;
  }

  Intrinsic_triangulation m_a;
  std::vector<int>        m_n;            // by C edge
  std::vector<Halfedge>   m_roundabout;   // by C halfedge
};

// the normal coordinate according to the crossings
int carried_coordinate(const Common_refinement& r, Edge c)
{
  if (r.coincident(first_halfedge(c)) != Mesh::null_halfedge()) return -1;
  return static_cast<int>(r.crossings(c).size());
}

// the crossings that the refinement links along an A halfedge
std::vector<Crossing_id> carried_way(const Common_refinement& r, Halfedge a)
{
  std::vector<Crossing_id> way;
  for (Crossing_id id = r.first_crossing(r.input().edge(a)); !id.is_none(); id = r[id].next) way.push_back(id);
  if (!is_first_of_its_edge(a)) std::reverse(way.begin(), way.end());
  return way;
}

bool same_way(const Common_refinement& r, Halfedge a, const Normal_coordinates::Trace& trace)
{
  return trace.crossings == carried_way(r, a) && trace.end == r.input().opposite(a)
      && trace.target == r.input().target(a);
}

// The number of A halfedges that do not go the same way over C in both representations. Every A halfedge must lie on a
// C halfedge or come from a corner of C exactly once.
int different_ways(const Common_refinement& r, const Normal_coordinates& n, const Intrinsic_triangulation& c)
{
  std::vector<int> times_the_same(r.input().number_of_halfedges(), 0);
  for (Halfedge h : c.halfedges()) {
    if (n[h] < 0 && r.coincident(h) == n.roundabout(h) && carried_way(r, n.roundabout(h)).empty())
      ++times_the_same[n.roundabout(h)];
    for (int m = 0; m < n.number_from_corner(c, h); ++m) {
      const Halfedge a = n.from_corner(h, m);
      times_the_same[a] += same_way(r, a, n.trace(c, h, m));
    }
  }
  return static_cast<int>(times_the_same.size() - std::count(times_the_same.begin(), times_the_same.end(), 1));
}

struct Figures
{
  int sequences = 0, flips = 0, onto_input = 0, self_glued = 0, broken = 0, noticed = 0, largest = 0;
  std::size_t crossings = 0;
};

// Both representations, riding along on the same flips.
class Both
{
public:
  Both(const Intrinsic_triangulation& a, Figures& figures) : m_refinement(a), m_normal(a), m_figures(figures) {}

  void before_flip(const Intrinsic_triangulation& c, const Edge_flip& flip)
  {
    m_refinement.before_flip(c, flip);
    m_normal.before_flip(flip);
    const int n = m_normal[flip.edge];
    CHECK_EQUAL(n, carried_coordinate(m_refinement, flip.edge));
    ++m_figures.flips;
    m_figures.onto_input += n < 0;
    m_figures.self_glued += flip.il == c.opposite(flip.ki) || flip.lj == c.opposite(flip.jk);
    m_figures.largest = std::max(m_figures.largest, n);
  }

  void check_all(const Intrinsic_triangulation& c) const
  {
    const std::string defect = m_refinement.defect(c);
    CHECK_EQUAL(defect, "");
    if (!defect.empty()) return;   // ways may not end
    int different = 0;
    for (Edge e : c.edges()) different += m_normal[e] == 0 || m_normal[e] != carried_coordinate(m_refinement, e);
    CHECK_EQUAL(different, 0);
    CHECK_EQUAL(different_ways(m_refinement, m_normal, c), 0);
    m_figures.crossings += m_refinement.number_of_crossings();
  }

  // one crossing more than there is has to be noticed by the ways alone
  void check_that_errors_are_noticed(const Intrinsic_triangulation& c, Edge e) const
  {
    Normal_coordinates broken = m_normal;
    ++broken[e];
    ++m_figures.broken;
    m_figures.noticed += different_ways(m_refinement, broken, c) > 0;
  }

  int coordinate_after(const Edge_flip& f) const
  { return flipped_coordinate(m_normal[f.ij], m_normal[f.jk], m_normal[f.ki], m_normal[f.il], m_normal[f.lj]); }

private:
  Common_refinement  m_refinement;
  Normal_coordinates m_normal;
  Figures&           m_figures;
};

// the same flip, with the edge seen from its other side
Edge_flip from_other_side(const Edge_flip& f)
{
  return {f.edge, f.ji, f.il, f.lj, f.ij, f.jk, f.ki, f.old_length, f.new_length, f.ptolemy};
}

// Whether the diagonals of the quadrilateral of the triangles (e, jk, ki) and (e, il, lj) meet well inside e = ij, so
// that the other one is a straight edge too.
bool is_convex(double e, double jk, double ki, double il, double lj)
{
  const double x_k = (e * e + ki * ki - jk * jk) / (2 * e), y_k = four_times_area(e, jk, ki) / (2 * e);
  const double x_l = (e * e + il * il - lj * lj) / (2 * e), y_l = four_times_area(e, il, lj) / (2 * e);
  const double x = (x_k * y_l + x_l * y_k) / (y_k + y_l);
  return x > 0.02 * e && x < 0.98 * e;
}

// The flips go for a walk over the surface, now and then to somewhere else, so that they get into each other's way.
Edge next_edge(const Intrinsic_triangulation& c, Edge last, std::mt19937& random)
{
  const auto choice = random() % 64;
  if (choice == 0) return Edge(static_cast<Mesh::size_type>(random() % c.number_of_edges()));
  const Halfedge h = choice % 2 ? first_halfedge(last) : c.opposite(first_halfedge(last));
  return c.edge(choice / 2 % 2 ? c.next(h) : c.prev(h));
}

// Flips the edge if it can be flipped and will not be crossed too often.
bool try_flip(Intrinsic_triangulation& c, Both& both, Edge edge, bool ptolemy, bool other_side)
{
  const int most_crossings = 500;
  const Halfedge h = first_halfedge(edge), o = c.opposite(h);
  if (c.face(h) == c.face(o)) return false;
  const double e = c.length(h), jk = c.length(c.next(h)), ki = c.length(c.prev(h)),
               il = c.length(c.next(o)), lj = c.length(c.prev(o));
  if (!ptolemy && !is_convex(e, jk, ki, il, lj)) return false;
  const double length = ptolemy ? ptolemy_diagonal(e, jk, ki, il, lj) : euclidean_diagonal(e, jk, ki, il, lj);
  Edge_flip flip = c.flip_of(edge, length, ptolemy);
  if (other_side) flip = from_other_side(flip);
  if (both.coordinate_after(flip) > most_crossings) return false;
  both.before_flip(c, flip);
  c.flip(flip);
  return true;
}

// Random flips away from A, and the way back towards it.
void check_sequence(const Intrinsic_triangulation& a, bool ptolemy, std::mt19937& random, Figures& figures)
{
  Intrinsic_triangulation c = a;
  Both both(a, figures);
  const auto random_edge = [&] { return Edge(static_cast<Mesh::size_type>(random() % a.number_of_edges())); };
  const int failures_before = Quartic_test::failures();
  Edge edge = random_edge();
  int left = 30 + static_cast<int>(random() % 171);
  for (int attempts = 20 * left; left > 0 && attempts > 0; --attempts) {
    edge = next_edge(c, edge, random);
    left -= try_flip(c, both, edge, ptolemy, random() % 2 != 0);
    if (Quartic_test::failures() > failures_before) return;   // what is wrong would only grow
  }
  CHECK_EQUAL(left, 0);
  both.check_all(c);
  both.check_that_errors_are_noticed(c, random_edge());
  both.check_that_errors_are_noticed(c, edge);

  if (ptolemy) make_ideal_delaunay(c, std::vector<double>(a.number_of_vertices(), 0.0), both);
  else         make_delaunay(c, both);
  both.check_all(c);
  ++figures.sequences;
}

// two triangles, all corners at one vertex
Intrinsic_triangulation one_vertex_torus()
{
  Glued_triangles s;
  s.triangles = {{0, 0, 0}, {0, 0, 0}};
  s.opposite = {{{{1, 0}, {1, 1}, {1, 2}}}, {{{0, 0}, {0, 1}, {0, 2}}}};
  s.lengths = {{1, 1.1, 1.3}, {1, 1.1, 1.3}};
  return Intrinsic_triangulation(s);
}

void check_sequences(int n)
{
  const std::vector<Intrinsic_triangulation> surfaces = {
    Intrinsic_triangulation(Quartic_test::jittered_sphere(0, 0.3, 1, 1)),
    Intrinsic_triangulation(Quartic_test::jittered_sphere(1, 0.3, 1, 2)),
    one_vertex_torus(),
    Intrinsic_triangulation(Quartic_test::jittered_torus(3, 3, 0.2, 0, 3)),
    Intrinsic_triangulation(Quartic_test::jittered_torus(6, 4, 0.2, 0, 4)),
    Intrinsic_triangulation(hyperelliptic(2, 0)), Intrinsic_triangulation(handle_chain(2, 6)),
    Intrinsic_triangulation(hyperelliptic(3, 0)), Intrinsic_triangulation(handle_chain(3, 6))};
  std::mt19937 random(1);
  Figures figures;
  for (int i = 0; i < n; ++i)
    check_sequence(surfaces[i / 2 % surfaces.size()], i % 2 != 0, random, figures);

  CHECK_EQUAL(figures.noticed, figures.broken);
  CHECK(figures.onto_input > figures.flips / 20 && figures.self_glued > figures.flips / 50 && figures.largest > 400);
  std::cout << figures.sequences << " sequences, " << figures.flips << " flips (" << figures.onto_input
            << " onto an input edge, " << figures.self_glued << " that glue a face to itself), "
            << figures.crossings << " crossings compared in order, largest coordinate " << figures.largest << ", "
            << figures.noticed << " of " << figures.broken << " errors noticed" << std::endl;
}

// whether three normal coordinates can be those of a triangle
bool is_possible(int a, int b, int c)
{
  return arcs_from_corner(a, b, c) + arcs_from_corner(b, c, a) + arcs_from_corner(c, a, b) > 0
      || (positive(a) + positive(b) + positive(c)) % 2 == 0;
}

// n(kl), with the arcs through ij followed one by one
int flipped_coordinate_by_counting(int ij, int jk, int ki, int il, int lj)
{
  int across = 0, along = 0;
  for (int x = 0; x < ij; ++x) {
    const Way above = way_of_arc(x, ij, jk, ki);
    const Way below = way_of_arc(ij - 1 - x, ij, il, lj);
    if (above == Way::to_corner || below == Way::to_corner) along += above == below;
    else across += above == below;    // ji runs the other way: the same corner of ji is the other end of ij
  }
  across += arcs_round_corner(ij, jk, ki) + arcs_round_corner(ij, il, lj);
  across += arcs_from_corner(jk, ki, ij) + arcs_from_corner(ki, ij, jk);
  across += arcs_from_corner(il, lj, ij) + arcs_from_corner(lj, ij, il);
  if (ij < 0) across -= ij;
  return along > 0 ? -along : across;
}

// calls f for all n-tuples of integers from `least` to `most`
template <std::size_t n, class F>
void for_all_tuples(int least, int most, F f)
{
  std::array<int, n> x;
  x.fill(least);
  for (std::size_t i = 0; i < n;) {
    f(x);
    for (i = 0; i < n && x[i] == most; ++i) x[i] = least;
    if (i < n) ++x[i];
  }
}

// The flip rule alone: it counts, flips back, and five flips in a pentagon restore it.
void check_flip_rule()
{
  int wrong_count = 0, wrong_back = 0, wrong_pentagon = 0;
  for_all_tuples<5>(-2, 6, [&](const std::array<int, 5>& x) {
    const auto [ij, jk, ki, il, lj] = x;
    if (!is_possible(ij, jk, ki) || !is_possible(ij, il, lj)) return;
    const int kl = flipped_coordinate(ij, jk, ki, il, lj);
    wrong_count += kl != flipped_coordinate_by_counting(ij, jk, ki, il, lj);
    wrong_back += ij != flipped_coordinate(kl, lj, jk, ki, il);
  });
  for_all_tuples<7>(-1, 4, [&](const std::array<int, 7>& x) {
    std::array<int, 5> side{x[0], x[1], x[2], x[3], x[4]};   // from corner i to corner i + 1
    int d = x[5], e = x[6];                                  // from corner 0 to corners 2 and 3
    if (!is_possible(side[0], side[1], d) || !is_possible(d, side[2], e) || !is_possible(e, side[3], side[4])) return;
    for (int i = 0; i < 5; ++i) {
      // corner 3, from which both diagonals come after the flip of d, becomes corner 0
      const int flipped = flipped_coordinate(d, side[2], e, side[0], side[1]);
      d = e;
      e = flipped;
      std::rotate(side.begin(), side.begin() + 3, side.end());
    }
    wrong_pentagon += d != x[5] || e != x[6];
  });
  CHECK_EQUAL(wrong_count, 0);
  CHECK_EQUAL(wrong_back, 0);
  CHECK_EQUAL(wrong_pentagon, 0);
}

} // namespace

int main()
{
  check_flip_rule();
  check_sequences(1000);
  return Quartic_test::result();
}
