// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERSECTION_NUMBER_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERSECTION_NUMBER_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Intersection numbers of any two closed curves on a closed triangulated surface, exactly. (METHOD, step 1)
//   eta_a(h)   crossings of a with the halfedge h: +1 where a leaves the face of h through h, -1 where it comes back
//   a . b      sum of eta_a over a walk along edges homologous to b; positive when b crosses a from right to left
// Only halfedges are followed, so parallel edges, loops and faces glued to themselves are no exception.

/// A closed curve up to homotopy, as a closed walk in the dual graph (like the `loops` of a `Homology_basis`): the
/// halfedges through which it leaves one face after the other. Without crossings it stays in a face.
struct Closed_curve
{
  std::vector<Halfedge> crossings;
};

/// A straight piece of a curve in a closed face; barycentric coordinates as in `Surface_point`.
struct Face_segment
{
  Face                  face;
  std::array<double, 3> source{}, target{};
};

/// the curve along edges, pushed to its left.
/// \param walk the target of each halfedge is the source of the next, cyclically
/// \throws Error if it is not
/// Complexity: linear in the edges at the vertices of the walk.
Closed_curve closed_curve_along_edges(const Intrinsic_triangulation& t, const std::vector<Halfedge>& walk);

/// the curve along straight segments, pushed to its left at vertices. It may pass through vertices and run along edges.
///
/// A point lies on an edge, or at a vertex, if and only if its barycentric coordinates there are exactly 0: no
/// tolerance decides. A coordinate that was rounded to 0 does no harm, as a curve is free to touch an edge.
/// \param segments the target of each is the same point of the surface as the source of the next, cyclically
/// \throws Error if this is not so, as far as vertices, edges and faces are concerned: a target inside a face is
///         followed by a source inside it, on an edge by one on that edge, at a vertex by one at that vertex
/// Complexity: linear in the segments and the edges at the vertices passed.
Closed_curve closed_curve_along_segments(const Intrinsic_triangulation& t, const std::vector<Face_segment>& segments);

/// the same along points of which each lies in the closed face of the one before, cyclically: what `Pulled_back_arc`
/// holds. A point that names the same face as the one before is taken where its coordinates say.
/// \throws Error if a point does not lie in the closed face of the one before, or is a vertex at which that face has
///         two corners: then only segments say which is meant
Closed_curve closed_curve_along_polyline(const Intrinsic_triangulation& t, const std::vector<Surface_point>& points);

/// the closed walk along edges on the left side of a curve, homotopic to it.
/// \throws Error if the crossings are not a closed walk in the dual graph
/// Complexity: linear.
std::vector<Halfedge> edge_walk(const Intrinsic_triangulation& t, const Closed_curve& curve);

/// a . b, exactly: positive when b crosses a from right to left, seen from outside.
/// \throws Error if the crossings are not closed walks in the dual graph
/// Complexity: linear in the crossings.
std::int64_t intersection_number(const Intrinsic_triangulation& t, const Closed_curve& a, const Closed_curve& b);

/// a class of the first homology group by its 2g coefficients in a canonical basis a_1 .. a_g, b_1 .. b_g
using Homology_class = Eigen::Matrix<std::int64_t, Eigen::Dynamic, 1>;

/// the coefficients of the class x on which the cochains dual to a canonical basis have the values a_i . x, b_i . x
template <class Vector>
Vector coefficients_of_class(const Vector& values)
{
  const Eigen::Index g = values.size() / 2;
  Vector x(2 * g);
  x.head(g) = -values.tail(g);
  x.tail(g) = values.head(g);
  return x;
}

/// the homology class of a curve. It is 0 if and only if the curve bounds.
/// \param canonical the cochains dual to a canonical basis, on the triangulation of the curve: `cochains` of a
///        `Homology_basis`, or `cochains_of_loops()` where those rode along flips
/// \throws Error if the crossings are not a closed walk in the dual graph
/// Complexity: O(g) a crossing.
Homology_class homology_class(const Intrinsic_triangulation& t, const Integer_cochains& canonical,
                              const Closed_curve& curve);

/// the intersection number of two classes: the symplectic form Sum_i x_{a_i} y_{b_i} - x_{b_i} y_{a_i}.
/// \pre both have the same even dimension
std::int64_t intersection_number(const Homology_class& x, const Homology_class& y);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERSECTION_NUMBER_H
