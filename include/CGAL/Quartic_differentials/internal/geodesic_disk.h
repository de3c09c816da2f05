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

/// the distance of the origin from the segment ab
inline double distance_to_segment(std::complex<double> a, std::complex<double> b)
{
  const std::complex<double> e = b - a;
  const double s = -(std::conj(e) * a).real() / std::norm(e);
  return s <= 0 ? std::abs(a) : s >= 1 ? std::abs(b) : std::abs(a + s * e);
}

/// Follows all straight lines of length up to `radius` that leave a point, unfolding faces along the way.
/// `visit(face, corners, right, left)` gets the positions of the face's corners with the point at the origin; the lines
/// fill the sector counterclockwise from `right` to `left` (everything in the first face, where both are 0).
template <class Visit>
class Geodesic_disk
{
public:
  Geodesic_disk(const Intrinsic_triangulation& t, double radius, Visit& visit)
    : m_t(t), m_radius(radius), m_visit(visit) {}

  void explore(const Surface_point& p)
  {
    auto z = m_t.unfolded(p.face);
    const std::complex<double> origin = p.barycentric[0] * z[0] + p.barycentric[1] * z[1] + p.barycentric[2] * z[2];
    for (auto& c : z) c -= origin;
    m_visit(p.face, z, std::complex<double>(0), std::complex<double>(0));
    const auto h = m_t.halfedges(p.face);
    for (int k = 0; k < 3; ++k) cross_edge(h[k], z[k], z[(k + 1) % 3], z[k], z[(k + 1) % 3]);
  }

private:
  using Complex = std::complex<double>;

  // leaves a face through h, whose ends lie at a and b, within the sector right .. left
  void cross_edge(Halfedge h, Complex a, Complex b, Complex right, Complex left)
  {
    if (cross(right, a) > 0) right = a;
    if (cross(left, b) < 0) left = b;
    if (cross(right, left) <= 0 || distance_to_segment(a, b) > m_radius) return;
    const Halfedge o = m_t.opposite(h), n = m_t.next(o), p = m_t.prev(o);   // o runs from b to a
    const double e = m_t.length(o), l = m_t.length(n), r = m_t.length(p);   // apex: at distance l from a, r from b
    const double x = (e * e + r * r - l * l) / (2 * e), y = four_times_area(e, l, r) / (2 * e);
    const Complex c = b + (a - b) / std::abs(a - b) * Complex(x, y);
    const Face f = m_t.face(o);
    std::array<Complex, 3> corners;
    corners[m_t.corner(o)] = b;
    corners[m_t.corner(n)] = a;
    corners[m_t.corner(p)] = c;
    m_visit(f, corners, right, left);
    cross_edge(n, a, c, right, left);
    cross_edge(p, c, b, right, left);
  }

  const Intrinsic_triangulation& m_t;
  double                         m_radius;
  Visit&                         m_visit;
};

template <class Visit>
void explore_geodesic_disk(const Intrinsic_triangulation& t, const Surface_point& p, double radius, Visit visit)
{
  Geodesic_disk<Visit>(t, radius, visit).explore(p);
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_GEODESIC_DISK_H
