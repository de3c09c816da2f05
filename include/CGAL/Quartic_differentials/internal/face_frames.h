// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FACE_FRAMES_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FACE_FRAMES_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <queue>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// alpha(h): the direction of h in the frame of its face whose axis is h0. [radians] (METHOD, step 4)
/// \param angles by halfedge, at its source
inline double direction_in_face(const Intrinsic_triangulation& t, const std::vector<double>& angles, Halfedge h)
{
  const auto [h0, h1, h2] = t.halfedges(t.face(h));
  if (h == h0) return 0;
  return h == h1 ? CGAL_PI - angles[h1] : 2 * CGAL_PI - angles[h1] - angles[h2];
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

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_FACE_FRAMES_H
