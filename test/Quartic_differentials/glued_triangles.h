// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_GLUED_TRIANGLES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_GLUED_TRIANGLES_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

namespace Quartic_test {

/// the triangles of a surface without positions: triangle number f is face f, its edge k is halfedges(f)[k]
inline CGAL::Quartic_differentials::Glued_triangles
glued_triangles(const CGAL::Quartic_differentials::Intrinsic_triangulation& t)
{
  CGAL::Quartic_differentials::Glued_triangles s;
  for (auto f : t.faces()) {
    s.triangles.emplace_back();
    s.opposite.emplace_back();
    s.lengths.emplace_back();
    for (auto h : t.halfedges(f)) {
      const int e = t.corner(h);
      const auto o = t.opposite(h);
      s.triangles.back()[e] = static_cast<int>(t.source(h).idx());
      if (t.is_border(o)) s.opposite.back()[e] = {-1, -1};
      else                s.opposite.back()[e] = {static_cast<int>(t.face(o).idx()), t.corner(o)};
      s.lengths.back()[e] = t.length(h);
    }
  }
  return s;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_GLUED_TRIANGLES_H
