// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_GEODESIC_DISK_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_GEODESIC_DISK_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <array>
#include <complex>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

inline double cross(std::complex<double> a, std::complex<double> b) { return (std::conj(a) * b).imag(); }

/// the point of the segment ab that is nearest to the origin
inline std::complex<double> nearest_on_segment(std::complex<double> a, std::complex<double> b)
{
  const std::complex<double> e = b - a;
  const double s = -(a.real() * e.real() + a.imag() * e.imag()) / std::norm(e);
  return s <= 0 ? a : s >= 1 ? b : a + s * e;
}

/// the square of the distance of the origin from the segment ab
inline double squared_distance_to_segment(std::complex<double> a, std::complex<double> b)
{ return std::norm(nearest_on_segment(a, b)); }

/// A face unfolded into the plane: where source, target and the vertex opposite one of its halfedges lie.
struct Unfolded_face
{
  Halfedge             halfedge;
  std::complex<double> source, target, apex;

  /// in the order of `Surface_point`
  std::array<std::complex<double>, 3> corners(const Intrinsic_triangulation& t) const
  {
    const int k = t.corner(halfedge);
    std::array<std::complex<double>, 3> z;
    z[k] = source;
    z[(k + 1) % 3] = target;
    z[(k + 2) % 3] = apex;
    return z;
  }
};

/// Follows all straight lines of length up to `radius` that leave a point, unfolding faces along the way; they end at the
/// boundary.
/// `visit(unfolded_face, right, left)` gets the positions of the face's corners with the point at the origin; the lines
/// fill the sector counterclockwise from `right` to `left` (everything in the first face, where both are 0).
template <class Visit>
class Geodesic_disk
{
public:
  Geodesic_disk(const Intrinsic_triangulation& t, double radius, Visit& visit)
    : m_t(t), m_squared_radius(radius * radius), m_visit(visit) {}

  void explore(const Surface_point& p)
  {
    auto z = m_t.unfolded(p.face);
    const std::complex<double> origin = p.barycentric[0] * z[0] + p.barycentric[1] * z[1] + p.barycentric[2] * z[2];
    for (auto& c : z) c -= origin;
    const auto h = m_t.halfedges(p.face);
    m_visit(Unfolded_face{h[0], z[0], z[1], z[2]}, Complex(0), Complex(0));
    for (int k = 0; k < 3; ++k) cross_edge(h[k], z[k], z[(k + 1) % 3], z[k], z[(k + 1) % 3]);
  }

private:
  using Complex = std::complex<double>;

  // leaves a face through h, whose ends lie at a and b, within the sector right .. left
  void cross_edge(Halfedge h, Complex a, Complex b, Complex right, Complex left)
  {
    if (cross(right, a) > 0) right = a;
    if (cross(left, b) < 0) left = b;
    if (cross(right, left) <= 0 || squared_distance_to_segment(a, b) > m_squared_radius) return;
    const Halfedge o = m_t.opposite(h);
    if (m_t.is_border(o)) return;
    const Halfedge n = m_t.next(o), p = m_t.prev(o);   // o runs from b to a
    const double e = m_t.length(o), l = m_t.length(n), r = m_t.length(p);   // apex: at distance l from a, r from b
    const double x = twice_scalar_product(l, e, r) / (2 * e), y = four_times_area(e, l, r) / (2 * e);
    const Complex c = b + (a - b) / std::abs(a - b) * Complex(x, y);
    m_visit(Unfolded_face{o, b, a, c}, right, left);
    cross_edge(n, a, c, right, left);
    cross_edge(p, c, b, right, left);
  }

  const Intrinsic_triangulation& m_t;
  double                         m_squared_radius;
  Visit&                         m_visit;
};

template <class Visit>
void explore_geodesic_disk(const Intrinsic_triangulation& t, const Surface_point& p, double radius, Visit visit)
{
  Geodesic_disk<Visit>(t, radius, visit).explore(p);
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_GEODESIC_DISK_H
