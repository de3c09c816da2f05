// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/flip_towards_input.h>

#include <CGAL/Quartic_differentials/delaunay_flips.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const double least_altitude = 4096;   // grid units
const double largest_move = 0.1;      // of a crossing, relative to its distance from its neighbours

double distance(Grid_vector a, Grid_vector b)
{
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

bool is_high_enough(Grid_vector a, Grid_vector b, Grid_vector c)
{
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  return static_cast<double>(doubled_area(a, b, c)) >= least_altitude * longest;
}

using Complex = std::complex<double>;

Complex to_complex(Grid_vector v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

// Where an A edge that comes in through the C halfedge `from` leaves face(from).
Complex end_of_step(const Common_refinement& r, const Quartic_differential& q, Halfedge from,
                    const Common_refinement::Step& step)
{
  const Intrinsic_triangulation& c = q.triangulation;
  if (step.to.is_none()) return to_complex(q.corner[c.prev(from)]);
  const Complex begin = to_complex(q.corner[step.at]), end = to_complex(q.corner[c.next(step.at)]);
  const double t = r[step.to].position_on_c();
  return begin + (is_first_of_its_edge(step.at) ? t : 1 - t) * (end - begin);
}

// Whether the A edges that cross the edge ij are straight there already, up to a part of the gaps between them: then the
// cells keep their shapes when the edges are straightened by a flip.
bool are_nearly_straight(const Common_refinement& r, const Quartic_differential& q, const Edge_flip& f)
{
  const Complex i = to_complex(q.corner[f.ij]), ij = to_complex(q.corner[f.ji]) - i;
  const std::vector<Crossing>& crossings = r.crossings(f.edge);
  for (std::size_t n = 0; n < crossings.size(); ++n) {
    const Crossing& x = crossings[n];
    const Complex p = (end_of_step(r, q, f.ij, r.step(x, f.ij)) - i) / ij;   // ij is from 0 to 1 now
    const Complex m = (end_of_step(r, q, f.ji, r.step(x, f.ji)) - i) / ij;
    const double straight = (p.real() * m.imag() - m.real() * p.imag()) / (m.imag() - p.imag());
    const double t = x.position_on_c();
    const double before = n == 0 ? 0 : crossings[n - 1].position_on_c();
    const double after = n + 1 == crossings.size() ? 1 : crossings[n + 1].position_on_c();
    if (!(std::abs(straight - t) <= largest_move * std::min(t - before, after - t))) return false;
  }
  return true;
}

// Both faces are in one chart, and stay in it.
void flip_in_chart(Quartic_differential& q, const Edge_flip& f)
{
  const Grid_vector k = q.corner[f.ki], l = q.corner[f.lj];
  q.triangulation.flip(f);   // ij runs from k to l now
  q.corner[f.ij] = k;
  q.corner[f.ji] = l;
}

} // namespace

std::size_t flip_towards_input(Common_refinement& refinement, Quartic_differential& flat)
{
  Intrinsic_triangulation& c = flat.triangulation;
  Edge_queue queue(c.number_of_edges());
  std::size_t flips = 0;
  while (!queue.empty()) {
    const Edge e = queue.pop();
    const Halfedge h = c.halfedge(e);
    const std::size_t crossings = refinement.crossings(e).size();
    if (crossings == 0 || !flat.transition[h].is_identity() || c.face(h) == c.face(c.opposite(h))) continue;
    Edge_flip f = c.flip_of(e, 0, false);
    const Grid_vector i = flat.corner[f.ij], j = flat.corner[f.ji], k = flat.corner[f.ki], l = flat.corner[f.lj];
    if (!is_high_enough(k, l, j) || !is_high_enough(l, k, i)) continue;
    if (!are_nearly_straight(refinement, flat, f) || refinement.crossings_after(f) >= crossings) continue;
    f.new_length = distance(k, l);
    refinement.before_flip(c, f);
    flip_in_chart(flat, f);
    ++flips;
    for (Halfedge side : {f.jk, f.ki, f.il, f.lj}) queue.push(c.edge(side));
  }
  return flips;
}

} } } // namespace CGAL::Quartic_differentials::internal
