// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_EXACT_CHARTS_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_EXACT_CHARTS_H

// Quartic differentials whose charts are written down, not computed: surfaces glued from parallelograms.

#include "square_tiled_surfaces.h"

#include <CGAL/Quartic_differentials/Quartic_differential.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace Quartic_test {

/// horizontal sides are glued to horizontal ones, vertical to vertical: every rotation is 0 or 2
inline Gluing random_half_translation_gluing(int squares, std::mt19937& random)
{
  Gluing glued(4 * squares);
  for (int parity = 0; parity < 2; ++parity) {
    std::vector<int> sides;
    for (int side = parity; side < 4 * squares; side += 2) sides.push_back(side);
    for (std::size_t i = sides.size() - 1; i > 0; --i) std::swap(sides[i], sides[random() % (i + 1)]);
    for (std::size_t i = 0; i < sides.size(); i += 2) {
      glued[sides[i]] = sides[i + 1];
      glued[sides[i + 1]] = sides[i];
    }
  }
  return glued;
}

/// the transition across every edge, from the corners on its two sides
inline void find_transitions(QD::Quartic_differential& q)
{
  const QD::Intrinsic_triangulation& t = q.triangulation;
  q.transition.assign(t.number_of_halfedges(), {});
  for (QD::Halfedge h : t.halfedges()) {
    const QD::Halfedge o = t.opposite(h);
    if (t.is_border(t.edge(h))) continue;
    const QD::Grid_vector here = q.corner[t.next(h)] - q.corner[h], there = q.corner[o] - q.corner[t.next(o)];
    int k = 0;
    while (k < 3 && QD::rotated(here, k) != there) ++k;
    q.transition[h] = {k, q.corner[t.next(o)] - QD::rotated(q.corner[h], k)};
  }
}

/// every square becomes a parallelogram with sides u and v.
/// \pre v is u turned by 90 degrees, or the gluing is a half-translation gluing
inline QD::Quartic_differential exact_differential(const Gluing& glued, QD::Grid_vector u, QD::Grid_vector v)
{
  const Square_tiled_surface s = square_tiled_surface(glued);
  QD::Quartic_differential q;
  q.triangulation = s.triangulation;
  q.order = s.order;
  q.singularities = s.singularities;
  q.grid_exponent = 20;
  q.surface_units_per_unit = 1;
  q.corner.resize(q.triangulation.number_of_halfedges());
  for (QD::Face f : q.triangulation.faces()) {
    const auto h = q.triangulation.halfedges(f);
    q.corner[h[0]] = {0, 0};
    q.corner[h[1]] = f.idx() % 2 == 0 ? u : u + v;
    q.corner[h[2]] = f.idx() % 2 == 0 ? u + v : v;
  }
  find_transitions(q);
  return q;
}

/// flips random edges whose quadrilateral is strictly convex, unless the new edge is longer than `longest` in x or y
inline void flip_exactly(QD::Quartic_differential& q, int attempts, std::int64_t longest, std::mt19937& random)
{
  QD::Intrinsic_triangulation& t = q.triangulation;
  for (int i = 0; i < attempts; ++i) {
    const QD::Edge e(static_cast<QD::Mesh::size_type>(random() % t.number_of_edges()));
    if (t.is_border(e) || t.face(t.halfedge(e)) == t.face(t.opposite(t.halfedge(e)))) continue;
    QD::Edge_flip flip = t.flip_of(e, 0, false);
    // in the chart of face(ij)
    const QD::Grid_vector zi = q.corner[flip.ij], zj = q.corner[flip.jk], zk = q.corner[flip.ki],
                          zl = q.transition[flip.ji](q.corner[flip.lj]);
    if (QD::doubled_area(zk, zl, zj) <= 0 || QD::doubled_area(zl, zk, zi) <= 0) continue;
    if (std::abs(zl.x - zk.x) > longest || std::abs(zl.y - zk.y) > longest) continue;
    flip.new_length = std::ldexp(std::hypot(double(zl.x - zk.x), double(zl.y - zk.y)), -q.grid_exponent);
    t.flip(flip);
    q.corner[flip.ij] = zk; q.corner[flip.lj] = zl; q.corner[flip.jk] = zj;
    q.corner[flip.ji] = zl; q.corner[flip.ki] = zk; q.corner[flip.il] = zi;
    find_transitions(q);
  }
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_EXACT_CHARTS_H
