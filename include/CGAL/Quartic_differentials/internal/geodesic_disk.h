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

/// whether the segment ab has a point whose distance from the origin is at most the root of `squared_radius`
inline bool comes_within(std::complex<double> a, std::complex<double> b, double squared_radius)
{
  const std::complex<double> e = b - a;
  if (a.real() * e.real() + a.imag() * e.imag() >= 0) return std::norm(a) <= squared_radius;
  if (b.real() * e.real() + b.imag() * e.imag() <= 0) return std::norm(b) <= squared_radius;
  return cross(a, b) * cross(a, b) <= squared_radius * std::norm(e);
}

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
    for (int k = 0; k < 3; ++k)
      if (const Complex right = z[k], left = z[(k + 1) % 3]; cross(right, left) > 0) cross_edge(h[k], right, left, right, left);
  }

private:
  using Complex = std::complex<double>;

  // leaves a face through h, whose ends lie at a and b, within the sector right .. left, which is not empty and ends there
  void cross_edge(Halfedge h, Complex a, Complex b, Complex right, Complex left)
  {
    if (!comes_within(a, b, m_squared_radius)) return;
    const Halfedge o = m_t.opposite(h);
    if (m_t.is_border(o)) return;
    const Halfedge n = m_t.next(o), p = m_t.prev(o);   // o runs from b to a
    const double e = m_t.length(o), l = m_t.length(n), r = m_t.length(p);   // apex: at distance l from a, r from b
    const double x = twice_scalar_product(l, e, r) / (2 * e), y = four_times_area(e, l, r) / (2 * e);
    const Complex c = b + (a - b) / std::abs(a - b) * Complex(x, y);
    m_visit(Unfolded_face{o, b, a, c}, right, left);
    const bool before_left = cross(c, left) > 0, after_right = cross(right, c) > 0;
    if (after_right) cross_edge(n, a, c, right, before_left ? c : left);
    if (before_left) cross_edge(p, c, b, after_right ? c : right, left);
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
