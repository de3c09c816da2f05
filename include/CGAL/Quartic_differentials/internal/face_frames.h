// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FACE_FRAMES_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FACE_FRAMES_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

// These functions take pi from their callers: in a multiprecision type it is not a constant of the compiler.

/// the deviation from the nearest multiple of pi/2, in [-pi/4, pi/4]
template <class FT>
FT quarter_turn_defect(const FT& angle, const FT& pi)
{
  using std::round;
  const FT quarter_turn = pi / 2;
  return angle - quarter_turn * FT(round(FT(angle / quarter_turn)));
}

/// alpha(h): the direction of h in the frame of its face whose axis is h0. [radians] (METHOD, step 4)
/// \param angles by halfedge, at its source. \pre h is in a face
template <class FT>
FT direction_in_face(const Intrinsic_triangulation& t, const std::vector<FT>& angles, const FT& pi, Halfedge h)
{
  const auto [h0, h1, h2] = t.halfedges(t.face(h));
  if (h == h0) return FT(0);
  return h == h1 ? FT(pi - angles[h1]) : FT(2 * pi - angles[h1] - angles[h2]);
}

/// the turning on the way out of the face of h through h: from the axis of that face to the axis of the next one, or to
/// the direction of the boundary; through a border halfedge it begins with the boundary's direction. [radians]
template <class FT>
FT turn_across(const Intrinsic_triangulation& t, const std::vector<FT>& angles, const FT& pi, Halfedge h)
{
  const Halfedge o = t.opposite(h);
  if (t.is_border(o)) return direction_in_face(t, angles, pi, h);
  if (t.is_border(h)) return -direction_in_face(t, angles, pi, o);
  return direction_in_face(t, angles, pi, h) - direction_in_face(t, angles, pi, o) - pi;
}

/// T of the loops and arcs dual to the cochains: the turning of a frame along them. [radians, not reduced]
/// (METHOD, step 4)
template <class FT>
std::vector<FT> turning_numbers(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                const std::vector<FT>& angles)
{
  std::vector<FT> turning(cochains.size(), FT(0));
  const FT pi = half_turn<FT>();
  for (Edge e : t.edges()) {
    const Halfedge h = t.halfedge(e);
    if (cochains.row(h).isZero()) continue;
    const FT turn = turn_across(t, angles, pi, h);
    for (int k = 0; k < cochains.size(); ++k) turning[k] += cochains(h, k) * turn;
  }
  return turning;
}

/// visits the faces breadth first from the first one: `visit(h)` is called for the halfedge h through which the face on
/// its other side is reached. Returns the number of faces reached.
template <class Visit>
std::size_t visit_faces_breadth_first(const Intrinsic_triangulation& t, Visit visit)
{
  std::vector<char> seen(t.number_of_faces(), false);
  std::queue<Face> queue;
  queue.push(*t.faces().begin());
  seen[queue.front()] = true;
  std::size_t reached = 1;
  while (!queue.empty()) {
    const Face f = queue.front();
    queue.pop();
    for (Halfedge h : t.halfedges(f)) {
      if (t.is_border(t.opposite(h))) continue;
      const Face g = t.face(t.opposite(h));
      if (seen[g]) continue;
      seen[g] = true;
      ++reached;
      visit(h);
      queue.push(g);
    }
  }
  return reached;
}

/// propagates a frame over a spanning tree of the faces and returns the largest deviation of the rotation across any
/// edge, and of the angle between any two boundary edges in this frame, from a multiple of pi/2. [radians]
template <class FT>
FT max_transition_error(const Intrinsic_triangulation& t, const std::vector<FT>& angles)
{
  using std::abs;
  using std::round;
  const FT pi = half_turn<FT>();
  const auto rotation = [&](Halfedge h) {
    return FT(direction_in_face(t, angles, pi, t.opposite(h)) - direction_in_face(t, angles, pi, h) + pi);
  };
  std::vector<FT> frame(t.number_of_faces(), FT(0));
  visit_faces_breadth_first(t, [&](Halfedge h) {
    const FT turned = frame[t.face(h)] + rotation(h);
    frame[t.face(t.opposite(h))] = turned - 2 * pi * FT(round(FT(turned / (2 * pi))));
  });
  FT worst = 0;
  FT axis = 0;   // the direction of the first boundary edge in the frame
  bool has_axis = false;
  for (Edge e : t.edges()) {
    const Halfedge h = t.halfedge(e);
    if (t.is_border(e)) {
      const Halfedge in = t.is_border(h) ? t.opposite(h) : h;
      const FT direction = direction_in_face(t, angles, pi, in) - frame[t.face(in)];
      if (!has_axis) axis = direction;
      has_axis = true;
      worst = (std::max)(worst, FT(abs(quarter_turn_defect(FT(direction - axis), pi))));
      continue;
    }
    const FT defect = quarter_turn_defect(FT(frame[t.face(h)] + rotation(h) - frame[t.face(t.opposite(h))]), pi);
    worst = (std::max)(worst, FT(abs(defect)));
  }
  return worst;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FACE_FRAMES_H
