// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_QUARTIC_DIFFERENTIAL_H
#define CGAL_QUARTIC_DIFFERENTIALS_QUARTIC_DIFFERENTIAL_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A Gaussian integer: a point or vector of the dyadic grid.
struct Grid_vector
{
  std::int64_t x = 0, y = 0;

  friend Grid_vector operator+(Grid_vector a, Grid_vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Grid_vector operator-(Grid_vector a, Grid_vector b) { return {a.x - b.x, a.y - b.y}; }
  friend bool operator==(Grid_vector a, Grid_vector b) { return a.x == b.x && a.y == b.y; }
  friend bool operator!=(Grid_vector a, Grid_vector b) { return !(a == b); }
};

/// i^k v
inline Grid_vector rotated(Grid_vector v, int k)
{
  switch (k & 3) {
    case 0:  return v;
    case 1:  return {-v.y, v.x};
    case 2:  return {-v.x, -v.y};
    default: return {v.y, -v.x};
  }
}

/// twice the signed area of the triangle a, b, c, exactly. \pre coordinates are below 2^61
inline __int128 doubled_area(Grid_vector a, Grid_vector b, Grid_vector c)
{
  return static_cast<__int128>(b.x - a.x) * (c.y - a.y) - static_cast<__int128>(b.y - a.y) * (c.x - a.x);
}

/// The change of charts z -> i^rotation z + translation.
struct Transition
{
  int         rotation = 0;   ///< in {0, 1, 2, 3}
  Grid_vector translation;

  Grid_vector operator()(Grid_vector z) const { return rotated(z, rotation) + translation; }
  bool is_identity() const { return rotation == 0 && translation == Grid_vector{}; }
  Transition inverse() const { return {(4 - rotation) & 3, rotated(Grid_vector{} - translation, -rotation)}; }
  /// first *this, then `after`
  Transition then(const Transition& after) const
  { return {(rotation + after.rotation) & 3, after(translation)}; }
};

/// A meromorphic quartic differential (dz)^4 on a flat triangulated surface: every face is a chart, with its corners
/// on a dyadic grid, and charts change across every edge by exactly a rotation by k*90 degrees and a translation. Boundary
/// edges are parallel to an axis. (METHOD, step 7; paper, section 4.7)
struct Quartic_differential
{
  Intrinsic_triangulation  triangulation;     ///< the flat triangulation: the input's vertices, then the inserted cones
  std::vector<Grid_vector> corner;            ///< by halfedge h: source(h) in the chart of face(h), in units of 2^-grid_exponent
  std::vector<Transition>  transition;        ///< by halfedge h: from the chart of face(h) to the chart of face(opposite(h))
                                              ///< (both of no meaning at border halfedges, the transition at boundary edges)
  std::vector<int>         order;             ///< by vertex: order of the zero, minus that of the pole, 0 where regular;
                                              ///< m - 2 at a corner of the boundary of angle m*90 degrees
  std::vector<Vertex>      singularities;     ///< vertices that belong to the divisor
  int                      grid_exponent = 0; ///< grid units are 2^-grid_exponent
  double                   surface_units_per_unit = 0;  ///< scale: flat area times its square is the input's area

  /// the local coordinate z with (dz)^4 the differential: the chart of the point's face, in units (not grid units)
  std::complex<double> chart(const Surface_point& p) const;
  /// the order at a vertex
  int order_at(Vertex v) const { return order[v]; }
  /// twice the flat area in squared grid units, exactly
  __int128 doubled_area() const;
};

/// checks every invariant of a quartic differential in exact arithmetic and returns the first violation as a sentence,
/// or the empty string: every triangle is positively oriented; the two charts at every edge differ exactly by its
/// transition; once counterclockwise round a vertex the transitions compose to the rotation by -order*90 degrees about
/// it, and the triangles fill an angle of exactly (order + 4)*90 degrees; boundary edges are parallel to an axis, and the
/// angle at a vertex between them is exactly (order + 2)*90 degrees; the singularities hold all orders that are not 0, and
/// their degree is 8g - 8 + 4b.
/// Complexity: linear.
std::string defect(const Quartic_differential& q);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_QUARTIC_DIFFERENTIAL_H
