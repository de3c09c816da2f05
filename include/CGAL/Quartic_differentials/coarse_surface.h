// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_COARSE_SURFACE_H
#define CGAL_QUARTIC_DIFFERENTIALS_COARSE_SURFACE_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A vertex of the fine surface that the coarse one lacks: where it was between three others when it was removed.
struct Removed_vertex
{
  Vertex                vertex;        ///< of the fine surface, as the next
  std::array<Vertex, 3> corner;        ///< left on the coarse surface, or removed later
  std::array<double, 3> barycentric;
};

/// A surface of fewer triangles with nearly the same conformal structure: some of the vertices, and new edge lengths.
struct Coarse_surface
{
  Intrinsic_triangulation triangulation;   ///< intrinsic Delaunay, indices compact
  Integer_cochains        cochains;        ///< the same cohomology classes
  std::vector<double>     mass;            ///< by vertex: its share of the area of the fine surface (they sum up to it)
  std::vector<Vertex>     fine_vertex;     ///< by vertex: the vertex of the fine surface that it is
  std::vector<Removed_vertex> removed;     ///< the other vertices of the fine surface, in the order of their removal
};

/// removes vertices until `vertices` are left, or none can be removed, deterministically.
///
/// To remove a vertex, the edges at it are scaled by one factor so that its angles sum up to 2 pi, a discrete conformal
/// map that leaves every other vertex alone; then it is a point of a flat polygon, which is triangulated without it. So
/// log scale factors with respect to the coarse metric are those with respect to the fine one, at the vertices left.
/// Vertices are never removed that are on the boundary, whose edges stay what they are, that have a loop, less than
/// three or very many triangles, or that cannot be flattened. A surface that is coarse enough already is copied;
/// otherwise the result is not embedded.
/// \pre `t` is connected and intrinsic Delaunay, and every triangle has a positive area
/// \throws Numerical_error if the flips to the Delaunay triangulation do not end
/// \throws Unusable_surface_error if a triangle inequality is lost to rounding (not seen with angles of 0.03 degrees)
/// Complexity: O(n log n).
/// Source: Liu, Gillespie, Chislett, Sharp, Jacobson and Crane, "Surface simplification using intrinsic error metrics",
/// 2023, with another order of removal.
Coarse_surface coarsened(const Intrinsic_triangulation& t, const Integer_cochains& cochains, std::size_t vertices);
/// the same with given masses for the fine vertices' shares of the area, as those of a surface that is coarse itself
Coarse_surface coarsened(const Intrinsic_triangulation& t, const Integer_cochains& cochains, std::vector<double> mass,
                         std::size_t vertices);

/// the place on the fine surface of a point of the coarse one, nearly: in the interior of a face, where the barycentric
/// coordinates of the point, as functions that are continued linearly to the removed vertices, have their values.
/// A vertex comes to lie beside itself, if the three corners of the face differ.
/// Complexity: linear in the vertices of the fine surface.
Surface_point on_fine_surface(const Coarse_surface& coarse, const Surface_point& p, const Intrinsic_triangulation& fine);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_COARSE_SURFACE_H
