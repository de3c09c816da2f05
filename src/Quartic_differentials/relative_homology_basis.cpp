// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/tree_cotree.h>
#include <CGAL/Quartic_differentials/relative_homology_basis.h>

namespace CGAL {
namespace Quartic_differentials {

namespace {

// The halfedge of a boundary edge that is in a face.
Halfedge inner(const Intrinsic_triangulation& t, Edge e)
{
  const Halfedge h = t.halfedge(e);
  return t.is_border(h) ? t.opposite(h) : h;
}

// From outside through the boundary edge of `in`, across the faces, and out through `out`.
std::vector<Halfedge> arc(const Intrinsic_triangulation& t, const internal::Tree_cotree& trees, Halfedge in, Halfedge out)
{
  std::vector<Halfedge> path = internal::dual_path(t, trees, t.face(in), t.face(out));
  path.insert(path.begin(), t.opposite(in));
  path.push_back(out);
  return path;
}

} // namespace

Relative_homology_basis relative_homology_basis(const Intrinsic_triangulation& t)
{
  const internal::Tree_cotree trees = internal::tree_cotree(t, t.lengths(), *t.vertices().begin());
  Relative_homology_basis basis;
  std::vector<Halfedge> open;   // the edge of every boundary curve that is in neither tree
  for (Edge e : trees.generators) {
    if (t.is_border(e)) open.push_back(inner(t, e));
    else                basis.paths.push_back(internal::dual_loop(t, trees, t.halfedge(e)));
  }
  CGAL_precondition(!open.empty());
  for (std::size_t k = 1; k < open.size(); ++k) basis.paths.push_back(arc(t, trees, open.front(), open[k]));

  basis.cochains = Integer_cochains(t.number_of_edges(), static_cast<int>(basis.paths.size()));
  for (std::size_t k = 0; k < basis.paths.size(); ++k)
    for (Halfedge h : basis.paths[k]) basis.cochains.add(h, static_cast<int>(k), 1);
  return basis;
}

} } // namespace CGAL::Quartic_differentials
