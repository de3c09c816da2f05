// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_OWN_INPUT_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_OWN_INPUT_H

#include <CGAL/Quartic_differentials/refined_surface.h>

namespace Quartic_test {

/// the surface of a quartic differential as its own input: nothing is subdivided
inline CGAL::Quartic_differentials::Refined_surface
own_input(const CGAL::Quartic_differentials::Quartic_differential& q)
{
  CGAL::Quartic_differentials::Refined_surface r;
  r.differential = q;
  r.input_corner.resize(q.triangulation.number_of_halfedges());
  for (auto f : q.triangulation.faces()) {
    r.input_face.push_back(f);
    for (auto h : q.triangulation.halfedges(f)) r.input_corner[h][q.triangulation.corner(h)] = 1;
  }
  r.faces_in = {r.input_face.size(), r.input_face.size(), [](std::size_t f) { return f; }};
  return r;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_OWN_INPUT_H
