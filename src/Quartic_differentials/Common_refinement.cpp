// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

// the weights of the source and of the target of the C halfedge h, on which x lies
std::pair<double, double> weights_along(const Crossing& x, Halfedge h)
{
  return is_first_of_its_edge(h) ? std::make_pair(x.p[0], x.p[1]) : std::make_pair(x.p[1], x.p[0]);
}

// the same flip, with the edge seen from its first halfedge
Edge_flip from_first_halfedge(const Edge_flip& f)
{
  if (is_first_of_its_edge(f.ij)) return f;
  return {f.edge, f.ji, f.il, f.lj, f.ij, f.jk, f.ki, f.old_length, f.new_length, f.ptolemy};
}

// One end of an arc of an A edge in the quadrilateral i, l, j, k: a crossing on its boundary, or the corner i or j.
// It is corner * (v_i or v_j) + k * v_k + l * v_l in homogeneous coordinates.
struct Arc_end
{
  Crossing_id           crossing;   // none: the corner itself
  std::size_t           place;      // counts from k to l along the boundary
  double                corner, k, l;
  std::array<double, 2> sigma;
};

// The weights q of a flip: q_i v_i + q_j v_j = q_k v_k + q_l v_l. Euclidean: areas, Ptolemy: their light cone analogue.
// They are kept from vanishing in degenerate quadrilaterals, so that all coordinates stay positive.
struct Flip_weights
{
  double i, j, k, l;

  Flip_weights(const Intrinsic_triangulation& t, const Edge_flip& flip)
  {
    const double a = t.length(flip.jk), b = t.length(flip.ki), c = t.length(flip.il), d = t.length(flip.lj);
    const double e = flip.old_length, f = flip.new_length;
    const auto weight = [&](double x, double y, double z)
    { return flip.ptolemy ? x * y * z : four_times_area(x, y, z); };
    i = weight(a, d, f);
    j = weight(b, c, f);
    k = weight(c, d, e);
    l = weight(a, b, e);
    const double least = 1e-14 * std::max({i, j, k, l});
    for (double* q : {&i, &j, &k, &l}) *q = std::max(*q, least);
  }
};

} // namespace

// An arc of an A edge inside the quadrilateral that has to cross the new diagonal kl, which has i on its left and j
// on its right before the flip.
struct Common_refinement::Arc
{
  Edge    a;
  Arc_end left, right;
  bool    left_to_right;   // direction of the A edge

  friend bool operator<(const Arc& x, const Arc& y)
  { return std::tie(x.left.place, x.right.place) < std::tie(y.left.place, y.right.place); }
};

// The two faces (ij, jk, ki), (ji, il, lj) of the edge about to be flipped, with the A arcs in them. The boundary is
// seen as two paths from k to l: on the left k, i, l along the halfedges ki, il, on the right k, j, l against jk, lj.
class Common_refinement::Quadrilateral
{
public:
  Quadrilateral(const Common_refinement& refinement, const Edge_flip& flip)
    : r(refinement), ij(flip.ij), ji(flip.ji), edge(flip.edge),
      sides{{{flip.ki, true, true}, {flip.il, true, false}, {flip.jk, false, true}, {flip.lj, false, false}}}
  {}

  // the A arcs that cross the new diagonal, sorted from k to l
  std::vector<Arc> arcs_across_new_diagonal() const
  {
    std::vector<Arc> arcs;
    for (const Crossing& x : r.crossings(edge)) add_arc_through_old_diagonal(x, arcs);
    for (const Side& side : sides)
      for (Mesh::size_type n = 0; n < crossings(side).size(); ++n)
        add_arc_inside_face(side, {r.m_a.edge(side.h), n}, arcs);
    add_old_diagonal(arcs);
    std::sort(arcs.begin(), arcs.end());
    return arcs;
  }

  // the A halfedge from k to l if there is one, otherwise null
  Halfedge coincident_with_new_diagonal() const
  {
    for (const Crossing& x : r.crossings(edge)) {
      const Step to_k = r.step(x, ij), to_l = r.step(x, ji);
      if (to_k.to.is_none() && to_l.to.is_none()) return directed(x.a, to_l.forward);
    }
    return Mesh::null_halfedge();
  }

private:
  struct Side
  {
    Halfedge h;
    bool     left;   // between k, i, l
    bool     at_k;   // rather than at l
  };

  const std::vector<Crossing>& crossings(const Side& s) const { return r.crossings(r.m_a.edge(s.h)); }

  Halfedge directed(Edge a, bool forward) const
  { return forward ? first_halfedge(a) : r.m_a.opposite(first_halfedge(a)); }

  // the side that is the boundary halfedge h
  const Side& side(Halfedge h) const
  { return *std::find_if(sides.begin(), sides.end(), [h](const Side& s) { return s.h == h; }); }

  // number of crossings on a path from k to its corner
  std::size_t crossings_before_corner(bool left) const { return crossings(sides[left ? 0 : 2]).size(); }

  Arc_end end_at_crossing(const Side& s, Crossing_id id) const
  {
    const Crossing& x = r[id];
    auto [first, second] = weights_along(x, s.h);
    if (!s.left) std::swap(first, second);           // from k to l, against the right halfedges
    const bool counted_along = is_first_of_its_edge(s.h) == s.left;
    const std::size_t rank = counted_along ? id.rank : crossings(s).size() - 1 - id.rank;
    if (s.at_k) return {id, rank, second, first, 0, x.sigma};
    return {id, crossings_before_corner(s.left) + 1 + rank, first, 0, second, x.sigma};
  }

  // an A edge ends at i (left) or j; `forward`: it arrives there
  Arc_end end_at_corner(bool left, bool forward) const
  {
    const std::array<double, 2> sigma = forward ? std::array<double, 2>{0, 1} : std::array<double, 2>{1, 0};
    return {Crossing_id(), crossings_before_corner(left), 1, 0, 0, sigma};
  }

  void add_arc_through_old_diagonal(const Crossing& x, std::vector<Arc>& arcs) const
  {
    const Step u = r.step(x, ij), w = r.step(x, ji);
    if (u.to.is_none() || w.to.is_none()) return;    // from k or l: stays on one side of the new diagonal
    const Side& su = side(u.at);
    const Side& sw = side(w.at);
    if (su.left == sw.left) return;                  // round i or j
    const Arc_end eu = end_at_crossing(su, u.to), ew = end_at_crossing(sw, w.to);
    if (su.left) arcs.push_back({x.a, eu, ew, w.forward});
    else         arcs.push_back({x.a, ew, eu, u.forward});
  }

  // arcs that do not meet the old diagonal: round k or l from the left to the right, or to the corner i or j
  void add_arc_inside_face(const Side& s, Crossing_id id, std::vector<Arc>& arcs) const
  {
    const Crossing& x = r[id];
    const Step step = r.step(x, s.h);
    if (step.to.is_none()) {
      const Arc_end here = end_at_crossing(s, id), there = end_at_corner(!s.left, step.forward);
      if (s.left) arcs.push_back({x.a, here, there, step.forward});
      else        arcs.push_back({x.a, there, here, !step.forward});
    }
    else if (s.left && step.at != ij && step.at != ji)
      arcs.push_back({x.a, end_at_crossing(s, id), end_at_crossing(side(step.at), step.to), step.forward});
  }

  void add_old_diagonal(std::vector<Arc>& arcs) const
  {
    const Halfedge a = r.coincident(ij);
    if (a == Mesh::null_halfedge()) return;
    const bool forward = is_first_of_its_edge(a);
    arcs.push_back({r.m_a.edge(a), end_at_corner(true, !forward), end_at_corner(false, forward), forward});
  }

  const Common_refinement& r;
  Halfedge                 ij, ji;
  Edge                     edge;
  std::array<Side, 4>      sides;   // ki, il, jk, lj
};

Common_refinement::Common_refinement(Intrinsic_triangulation a)
  : m_a(std::move(a)), m_crossings(m_a.number_of_edges()), m_first(m_a.number_of_edges())
{
  m_coincident.reserve(m_a.number_of_edges());
  for (Edge e : m_a.edges()) m_coincident.push_back(first_halfedge(e));
}

std::size_t Common_refinement::number_of_crossings() const
{
  std::size_t sum = 0;
  for (const auto& list : m_crossings) sum += list.size();
  return sum;
}

Halfedge Common_refinement::coincident(Halfedge c) const
{
  const Halfedge a = m_coincident[m_a.edge(c)];
  return a == Mesh::null_halfedge() || is_first_of_its_edge(c) ? a : m_a.opposite(a);
}

Common_refinement::Step Common_refinement::step(const Crossing& x, Halfedge c) const
{
  const bool forward = x.ahead == c;
  const Crossing_id to = forward ? x.next : x.prev;
  if (to.is_none()) return {to, Mesh::null_halfedge(), forward};
  const Halfedge ahead = (*this)[to].ahead;
  return {to, forward ? m_a.opposite(ahead) : ahead, forward};
}

// makes `to` follow `from` on the A edge; either may be none, an end of the edge
void Common_refinement::link(Edge a, Crossing_id from, Crossing_id to)
{
  if (from.is_none()) m_first[a] = to;
  else at(from).next = to;
  if (!to.is_none()) at(to).prev = from;
}

std::size_t Common_refinement::crossings_after(const Edge_flip& flip) const
{
  return Quadrilateral(*this, from_first_halfedge(flip)).arcs_across_new_diagonal().size();
}

// P = p0 v + p1 w = sigma0 m + sigma1 n, and v = exp(-u_v) (exp(u_v) v) (METHOD, step 7, "The map on the input surface")
void Common_refinement::rescale(const Intrinsic_triangulation& c, const std::vector<double>& u)
{
  for (Edge e : c.edges()) {
    const Halfedge h = first_halfedge(e);
    const double u_v = u[c.source(h)], u_w = u[c.target(h)];
    for (Crossing& x : m_crossings[e]) {
      const Halfedge a = first_halfedge(x.a);
      const double u_m = u[m_a.source(a)], u_n = u[m_a.target(a)];
      const double scale = 1 / (x.p[0] + x.p[1] * std::exp(u_v - u_w));   // times exp(u_v)
      x.p = {x.p[0] * scale, x.p[1] * std::exp(u_v - u_w) * scale};
      x.sigma = {x.sigma[0] * std::exp(u_v - u_m) * scale, x.sigma[1] * std::exp(u_v - u_n) * scale};
    }
  }
}

void Common_refinement::before_flip(const Intrinsic_triangulation& c, const Edge_flip& given)
{
  const Edge_flip flip = from_first_halfedge(given);
  const Quadrilateral quadrilateral(*this, flip);
  const std::vector<Arc> arcs = quadrilateral.arcs_across_new_diagonal();
  const Flip_weights q(c, flip);
  m_coincident[flip.edge] = quadrilateral.coincident_with_new_diagonal();

  std::vector<Crossing>& crossings = m_crossings[flip.edge];
  for (const Crossing& x : crossings) link(x.a, x.prev, x.next);   // without the old diagonal
  crossings.resize(arcs.size());
  for (std::size_t n = 0; n < arcs.size(); ++n) {
    const Arc& arc = arcs[n];
    const Arc_end &P = arc.left, &Q = arc.right;
    // q_i/P_i P + q_j/Q_j Q has no v_i and v_j left after q_i v_i + q_j v_j = q_k v_k + q_l v_l:
    // sums, products and quotients of positive numbers only
    const double s = q.i / P.corner, t = q.j / Q.corner;
    const double k = q.k + s * P.k + t * Q.k, l = q.l + s * P.l + t * Q.l;
    const double scale = 1 / (k + l);

    Crossing& x = crossings[n];
    x.a = arc.a;
    x.ahead = arc.left_to_right ? flip.ij : flip.ji;   // after the flip ij runs from k to l, with j on its left
    x.p = {k * scale, l * scale};
    for (int end : {0, 1}) x.sigma[end] = (s * P.sigma[end] + t * Q.sigma[end]) * scale;

    const Crossing_id id{flip.edge, static_cast<Mesh::size_type>(n)};
    link(x.a, arc.left_to_right ? P.crossing : Q.crossing, id);
    link(x.a, id, arc.left_to_right ? Q.crossing : P.crossing);
  }
}

namespace {

std::string numbered(const char* what, std::size_t n) { return what + std::to_string(n); }

// the first violation on a C edge that is also an edge of A
std::string coincidence_defect(const Common_refinement& r, const Intrinsic_triangulation& c, Edge e)
{
  const Intrinsic_triangulation& input = r.input();
  const Halfedge h = first_halfedge(e), a = r.coincident(h);
  if (a == Mesh::null_halfedge()) return {};
  if (!r.crossings(e).empty()) return numbered("current edge ", e) + " is an input edge, and others cross it";
  if (!r.first_crossing(input.edge(a)).is_none())
    return numbered("input edge ", input.edge(a)) + " is a current edge, and crosses others";
  if (input.source(a) != c.source(h) || input.target(a) != c.target(h))
    return numbered("current edge ", e) + " lies on an input edge with other ends";
  return {};
}

// the first violation where the input edge goes on from a crossing into the face of the C halfedge h
std::string step_defect(const Common_refinement& r, const Intrinsic_triangulation& c, Crossing_id id, Halfedge h)
{
  const Intrinsic_triangulation& input = r.input();
  const Crossing& x = r[id];
  const Common_refinement::Step step = r.step(x, h);
  if (step.to.is_none()) {
    const Halfedge a = first_halfedge(x.a);
    const Vertex end = step.forward ? input.target(a) : input.source(a);
    return c.target(c.next(h)) == end ? "" : "ends at a wrong vertex";
  }
  const Crossing& y = r[step.to];
  if (y.a != x.a) return "goes on along another input edge";
  if ((step.forward ? y.prev : y.next) != id) return "is not linked back";
  if (c.face(step.at) != c.face(h) || step.at == h) return "is linked across a face";
  return {};
}

} // namespace

namespace {

// Whether the arcs of A edges in a face of C do not cross: once round its boundary they open and close like parentheses.
class Arcs_in_face
{
public:
  Arcs_in_face(const Common_refinement& r, const Intrinsic_triangulation& c, Face f)
    : m_r(r), m_c(c), m_halfedge(c.halfedges(f)) {}

  bool are_disjoint()
  {
    bool disjoint = true;
    for (int k = 0; k < 3 && disjoint; ++k) disjoint = pass_corner(k) && pass_side(k);
    return disjoint && m_open.empty();
  }

private:
  // The end of an open arc that is still to come: a crossing on a side, or a corner. Arcs from a corner wait under its
  // name. Sides are told from each other by number: in a face that is glued to itself two are one edge.
  struct End
  {
    Crossing_id crossing;   // none: the corner
    int         corner;     // or side
    friend bool operator==(const End& x, const End& y) { return x.crossing == y.crossing && x.corner == y.corner; }
  };

  // arcs between corner k and the side opposite to it
  std::size_t arcs_at_corner(int k) const
  {
    const Halfedge h = m_halfedge[(k + 1) % 3];
    const auto& crossings = m_r.crossings(m_c.edge(h));
    return std::count_if(crossings.begin(), crossings.end(),
                         [&](const Crossing& x) { return m_r.step(x, h).to.is_none(); });
  }

  bool close(const End& end)
  {
    if (m_open.empty() || !(m_open.back() == end)) return false;
    m_open.pop_back();
    return true;
  }

  // the side opposite to corner 2 comes before it, those opposite to corners 0 and 1 after them
  bool pass_corner(int k)
  {
    for (std::size_t n = arcs_at_corner(k); n > 0; --n) {
      if (k < 2) m_open.push_back({Crossing_id(), k});
      else if (!close({Crossing_id(), k})) return false;
    }
    return true;
  }

  bool pass_side(int k)
  {
    const Halfedge h = m_halfedge[k];
    const Edge e = m_c.edge(h);
    const std::size_t count = m_r.crossings(e).size();
    for (std::size_t n = 0; n < count; ++n) {
      const Crossing_id here{e, static_cast<Mesh::size_type>(is_first_of_its_edge(h) ? n : count - 1 - n)};
      const Common_refinement::Step step = m_r.step(m_r[here], h);
      const int corner = (k + 2) % 3;
      const bool opens = step.to.is_none() ? corner == 2 : m_c.corner(step.at) > k;
      if (opens) m_open.push_back(step.to.is_none() ? End{Crossing_id(), corner} : End{step.to, m_c.corner(step.at)});
      else if (!close(step.to.is_none() ? End{Crossing_id(), corner} : End{here, k})) return false;
    }
    return true;
  }

  const Common_refinement&       m_r;
  const Intrinsic_triangulation& m_c;
  std::array<Halfedge, 3>        m_halfedge;
  std::vector<End>               m_open;
};

} // namespace

std::string Common_refinement::defect(const Intrinsic_triangulation& c) const
{
  for (Edge e : c.edges()) {
    const std::string defect = coincidence_defect(*this, c, e);
    if (!defect.empty()) return defect;
    for (Mesh::size_type n = 0; n < m_crossings[e].size(); ++n) {
      const Halfedge ahead = m_crossings[e][n].ahead;
      if (c.edge(ahead) != e) return numbered("a crossing of current edge ", e) + " goes ahead through another edge";
      for (Halfedge h : {ahead, c.opposite(ahead)}) {
        const std::string defect = step_defect(*this, c, {e, n}, h);
        if (!defect.empty()) return numbered("crossing ", n) + numbered(" of current edge ", e) + " " + defect;
      }
    }
  }

  for (Face f : c.faces())
    if (!Arcs_in_face(*this, c, f).are_disjoint()) return numbered("input edges cross each other in current face ", f);

  std::size_t accounted_for = 0, reached = 0;
  for (Halfedge a : m_coincident) accounted_for += a != Mesh::null_halfedge();
  for (Edge a : m_a.edges()) {
    accounted_for += !m_first[a].is_none();
    for (Crossing_id id = m_first[a]; !id.is_none(); id = (*this)[id].next) ++reached;
  }
  if (accounted_for != m_a.number_of_edges()) return "an input edge neither crosses nor is a current edge";
  if (reached != number_of_crossings()) return "a crossing is not on the way along its input edge";
  return {};
}

Point_3 position_on_input(const Intrinsic_triangulation& t, const Surface_point& p)
{
  internal::require_embedded(t, "the place of a point in space");
  const auto h = t.halfedges(p.face);
  double x = 0, y = 0, z = 0;
  for (int k = 0; k < 3; ++k) {
    const Point_3& v = t.mesh().point(t.source(h[k]));
    x += p.barycentric[k] * v.x();
    y += p.barycentric[k] * v.y();
    z += p.barycentric[k] * v.z();
  }
  return {x, y, z};
}

} } // namespace CGAL::Quartic_differentials
