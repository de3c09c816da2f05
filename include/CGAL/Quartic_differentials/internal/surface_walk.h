// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SURFACE_WALK_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SURFACE_WALK_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/geodesic_disk.h>

#include <algorithm>
#include <array>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// the barycentric coordinates of z with respect to the corners of a triangle
inline std::array<double, 3> barycentric(const std::array<std::complex<double>, 3>& corner, std::complex<double> z)
{
  const double d = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double b1 = cross(z - corner[0], corner[2] - corner[0]) / d;
  const double b2 = cross(corner[1] - corner[0], z - corner[0]) / d;
  return {1 - b1 - b2, b1, b2};
}

inline std::complex<double> point_in_frame(const std::array<std::complex<double>, 3>& corner,
                                           const std::array<double, 3>& b)
{
  return b[0] * corner[0] + b[1] * corner[1] + b[2] * corner[2];
}

/// the point with no barycentric coordinate below `least`, up to their normalisation
inline Surface_point moved_inside(Surface_point p, double least)
{
  double sum = 0;
  for (double& b : p.barycentric) sum += (b = std::max(b, least));
  for (double& b : p.barycentric) b /= sum;
  return p;
}

/// the least barycentric coordinate of a point from which a walk starts: from a vertex, the way into the next face would be
/// undetermined
constexpr double inward = 1e-9;

/// Where a straight walk ended.
struct Walk_end
{
  Surface_point        point;
  std::complex<double> rotation;   ///< from the unfolded frame of the first face to that of the last, along the walk, with
                                   ///< the turns of the walk where it was reflected
};

/// walks straight from p across the faces; `crossing(before, after)` gets the point where an edge is crossed in the
/// coordinates of both faces. The boundary reflects.
/// \param displacement in the unfolded frame of p's face
/// \throws Numerical_error after 100,000 crossings
template <class Crossing>
Walk_end walk(const Intrinsic_triangulation& t, const Surface_point& p, std::complex<double> displacement,
              Crossing crossing)
{
  Face f = p.face;
  auto corner = t.unfolded(f);
  std::complex<double> z = point_in_frame(corner, p.barycentric), d = displacement, rotation = 1;
  Halfedge came = Mesh::null_halfedge();
  for (int n = 0; n < 100000; ++n) {
    const auto h = t.halfedges(f);
    double exit = 1;
    int side = -1;
    for (int k = 0; k < 3; ++k) {
      if (h[k] == came) continue;
      const std::complex<double> e = corner[(k + 1) % 3] - corner[k];
      const double speed = cross(e, d);
      if (speed >= 0) continue;
      const double s = std::max(-cross(e, z - corner[k]) / speed, 0.0);
      if (s < exit) { exit = s; side = k; }
    }
    if (side < 0) return {{f, barycentric(corner, z + d)}, rotation};

    z += exit * d;
    d *= 1 - exit;
    if (t.is_border(t.opposite(h[side]))) {
      const std::complex<double> e = corner[(side + 1) % 3] - corner[side], reflected = e * std::conj(d / e);
      rotation *= reflected / d;
      d = reflected;
      came = h[side];
      continue;
    }
    const Surface_point before{f, barycentric(corner, z)};
    const std::complex<double> a = corner[side], b = corner[(side + 1) % 3];
    came = t.opposite(h[side]);
    f = t.face(came);
    corner = t.unfolded(f);
    const int k = t.corner(came);
    const std::complex<double> turn = (corner[(k + 1) % 3] - corner[k]) / (a - b);   // b is source(came)
    z = corner[k] + (z - b) * turn;
    d *= turn / std::abs(turn);
    rotation *= turn / std::abs(turn);
    crossing(before, Surface_point{f, barycentric(corner, z)});
  }
  throw Numerical_error("a straight line on the surface crosses more than 100000 edges");
}

/// One corner of the faces round a vertex.
struct Star_corner
{
  Halfedge halfedge;                 ///< from the vertex
  double   begin_angle, end_angle;   ///< counterclockwise from the first halfedge, radians
  double   frame_angle;              ///< direction of `halfedge` in the unfolded frame of its face
};

/// the corners round v, counterclockwise from `t.halfedge_from(v)`: all round it, or the fan of a boundary vertex
inline std::vector<Star_corner> star(const Intrinsic_triangulation& t, Vertex v)
{
  std::vector<Star_corner> corners;
  double angle = 0;
  const Halfedge first = t.halfedge_from(v);
  Halfedge h = first;
  do {
    const auto z = t.unfolded(t.face(h));
    const int k = t.corner(h);
    const std::complex<double> out = z[(k + 1) % 3] - z[k], in = z[(k + 2) % 3] - z[k];
    const double wedge = std::arg(in / out);
    corners.push_back({h, angle, angle + wedge, std::arg(out)});
    angle += wedge;
    h = t.next_around_source(h);
  } while (h != first && !t.is_border(h));
  return corners;
}

/// the point at the given direction (angle in the star) and distance from the centre of a star
inline Surface_point walk_from_vertex(const Intrinsic_triangulation& t, const std::vector<Star_corner>& star,
                                      double angle, double distance)
{
  auto c = star.begin();
  while (c + 1 != star.end() && c->end_angle < angle) ++c;
  const Face f = t.face(c->halfedge);
  const int k = t.corner(c->halfedge);
  Surface_point p{f, {inward, inward, inward}};
  p.barycentric[k] = 1 - 2 * inward;
  const std::complex<double> step = std::polar(distance, c->frame_angle + (angle - c->begin_angle));
  return walk(t, p, step, [](const Surface_point&, const Surface_point&) {}).point;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SURFACE_WALK_H
