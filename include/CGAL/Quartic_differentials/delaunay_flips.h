// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_DELAUNAY_FLIPS_H
#define CGAL_QUARTIC_DIFFERENTIALS_DELAUNAY_FLIPS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// whether an edge e = ij with faces (e, a, b), (e, c, d) is *certified* not to be Delaunay: the sign of
///   (a^2 + b^2 - e^2) cd + (c^2 + d^2 - e^2) ab + 16 eps * (the same with every sign +)
/// is negative, decided exactly for the given doubles (static filter, intervals, exact numbers).
/// The margin, eps = 2^-53, covers the rounding of the lengths, so that never both diagonals of a quadrilateral are
/// flagged and flipping cannot cycle. The same polynomial decides the ideal (Penner) condition. (METHOD, step 6)
bool certified_not_delaunay(double e, double a, double b, double c, double d);

namespace internal {

inline double norm(double x, double y) { return std::hypot(x, y); }

template <class FT>
FT norm(const FT& x, const FT& y)
{
  using std::sqrt;
  return sqrt(FT(x * x + y * y));
}

} // namespace internal

/// the length of the other diagonal of two triangles (e, a, b) and (e, c, d) unfolded into the plane
/// (a = jk, b = ki, c = il, d = lj, e = ij). Complexity: constant.
template <class FT>
FT euclidean_diagonal(const FT& e, const FT& a, const FT& b, const FT& c, const FT& d)
{
  const FT kx = twice_scalar_product(a, e, b) / (2 * e), ky = four_times_area(e, a, b) / (2 * e);
  const FT lx = twice_scalar_product(d, e, c) / (2 * e), ly = four_times_area(e, c, d) / (2 * e);
  return internal::norm(FT(kx - lx), FT(ky + ly));
}

/// the same by Ptolemy's rule
template <class FT>
FT ptolemy_diagonal(const FT& e, const FT& a, const FT& b, const FT& c, const FT& d)
{
  return (a * c + b * d) / e;
}

/// flips edges until none is certified non-Delaunay, by Euclidean unfolding, and returns the number of flips. Boundary
/// edges are never flipped.
/// Each rider's `before_flip(t, flip)` is called before the connectivity changes.
/// \throws Numerical_error after 100 flips per edge
template <class... Riders>
std::size_t make_delaunay(Intrinsic_triangulation& t, Riders&... riders);

/// flips edges until none is certified non-Delaunay in the metric with lengths exp((u_i + u_j)/2) l_ij, by Ptolemy's
/// rule on the unscaled lengths, and returns the number of flips.
template <class... Riders>
std::size_t make_ideal_delaunay(Intrinsic_triangulation& t, const std::vector<double>& u, Riders&... riders);

namespace internal {

// Edges waiting to be tested, first in first out, each at most once.
class Edge_queue
{
public:
  explicit Edge_queue(std::size_t n) : m_waiting(n, true)
  {
    m_edges.reserve(n);
    for (std::size_t e = 0; e < n; ++e) m_edges.push_back(Edge(static_cast<Mesh::size_type>(e)));
  }
  bool empty() const { return m_next == m_edges.size(); }
  Edge pop()
  {
    const Edge e = m_edges[m_next++];
    m_waiting[e] = false;
    if (m_next > m_waiting.size()) {     // forget what was popped: the memory stays linear
      m_edges.erase(m_edges.begin(), m_edges.begin() + m_next);
      m_next = 0;
    }
    return e;
  }
  void push(Edge e)
  {
    if (m_waiting[e]) return;
    m_waiting[e] = true;
    m_edges.push_back(e);
  }
private:
  std::vector<Edge> m_edges;
  std::vector<char> m_waiting;
  std::size_t       m_next = 0;
};

// The other diagonal of the two faces at h, by a rule for lengths.
template <class Rule>
double other_diagonal(const Intrinsic_triangulation& t, Halfedge h, Rule rule)
{
  const Halfedge o = t.opposite(h);
  return rule(t.length(h), t.length(t.next(h)), t.length(t.prev(h)), t.length(t.next(o)), t.length(t.prev(o)));
}

// The one flip loop. `scaled(e)` is the length by which edge e is judged, `diagonal(h)` the unscaled new length of that of h.
template <class Scaled, class Diagonal, class... Riders>
std::size_t flip_to_delaunay(Intrinsic_triangulation& t, bool ptolemy, Scaled scaled, Diagonal diagonal,
                             Riders&... riders)
{
  Edge_queue queue(t.number_of_edges());
  const std::size_t most = 100 * t.number_of_edges() + 1000;
  std::size_t flips = 0;
  while (!queue.empty()) {
    const Edge e = queue.pop();
    const Halfedge h = t.halfedge(e), o = t.opposite(h);
    if (t.is_border(h) || t.is_border(o)) continue;   // what is on the boundary stays there
    if (t.face(h) == t.face(o)) continue;   // both sides are one face: the edge cannot be flipped, and is Delaunay
    const Edge a = t.edge(t.next(h)), b = t.edge(t.prev(h)), c = t.edge(t.next(o)), d = t.edge(t.prev(o));
    if (!certified_not_delaunay(scaled(e), scaled(a), scaled(b), scaled(c), scaled(d))) continue;
    const Edge_flip flip = t.flip_of(e, diagonal(h), ptolemy);
    (riders.before_flip(t, flip), ...);
    t.flip(flip);
    if (++flips > most) throw Numerical_error("Delaunay flips do not end after 100 flips per edge");
    queue.push(a); queue.push(b); queue.push(c); queue.push(d);
  }
  return flips;
}

} // namespace internal

template <class... Riders>
std::size_t make_delaunay(Intrinsic_triangulation& t, Riders&... riders)
{
  return internal::flip_to_delaunay(t, false, [&](Edge e) { return t.length(e); },
                                    [&](Halfedge h) { return internal::other_diagonal(t, h, euclidean_diagonal<double>); },
                                    riders...);
}

template <class... Riders>
std::size_t make_ideal_delaunay(Intrinsic_triangulation& t, const std::vector<double>& u, Riders&... riders)
{
  std::vector<double> half_scale(u.size());
  for (std::size_t v = 0; v < u.size(); ++v) half_scale[v] = std::exp(0.5 * u[v]);
  const auto scaled = [&](Edge e) {
    const Halfedge h = t.halfedge(e);
    return t.length(e) * half_scale[t.source(h)] * half_scale[t.target(h)];
  };
  return internal::flip_to_delaunay(t, true, scaled,
                                    [&](Halfedge h) { return internal::other_diagonal(t, h, ptolemy_diagonal<double>); },
                                    riders...);
}

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_DELAUNAY_FLIPS_H
