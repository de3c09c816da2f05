// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_QUAD_MESH_H
#define CGAL_QUARTIC_DIFFERENTIALS_QUAD_MESH_H

#include <CGAL/Quartic_differentials/refined_surface.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A surface of quads with its vertices on the input surface, and those of its boundary on the input's boundary.
struct Quad_mesh
{
  std::vector<Point_3>                    points;        ///< by vertex
  std::vector<Surface_point>              input_points;  ///< by vertex: where it is on the input
  std::vector<std::array<std::size_t, 4>> quads;         ///< vertices, counterclockwise seen from outside
  std::vector<std::size_t>                patch;         ///< by quad: the patch of the T-mesh
  std::vector<std::size_t>                singularities; ///< vertices, by singular node of the T-mesh in their order

  std::array<Point_3, 4> corners(std::size_t quad) const
  {
    const auto& [a, b, c, d] = quads[quad];
    return {points[a], points[b], points[c], points[d]};
  }
};

/// cuts the patches of a T-mesh into the regular grids that a quantization gives them, glued along the arcs.
///
/// A point of a grid lies on the surface where the map from the patch's rectangle takes it: along a side its arcs are
/// divided evenly, inside, straight lines in the rectangle join opposite sides. Points that become one vertex are put
/// at the singularity or corner among them, or at the first node or point of the boundary, node, point of an arc, or
/// point of a patch. Places in the rectangle
/// are rounded to the T-mesh's grid, and the face in which one lies is found exactly.
///
/// \param q a quantization, as `quantize()` finds it
/// \pre `quantization_defect(t, q)` and `defect(t, refined.differential)` are empty
/// \throws Numerical_error if the result violates an invariant, see `defect()`
/// Complexity: O(n log n + p log p) for n quads and p pieces of faces in patches, if the pieces in a patch are not too
/// uneven in size and shape.
/// Source: METHOD, "Quad mesh".
Quad_mesh quad_mesh(const T_mesh& t, const std::vector<int>& q, const Refined_surface& refined);

/// checks, from the vertices of the quads alone, and returns the first violation as a sentence, or the empty string:
/// no quad has a vertex twice; every two vertices are joined by one edge at most, with a quad on either side that runs
/// along it the other way, or on one side on the boundary; the quads at every vertex are one circle, on the boundary
/// one fan; they are order + 4 at the singularities, which are vertices of their own, order + 2 at corners, likewise, 2 at
/// other vertices of the boundary, and 4 elsewhere; genus and number of boundary curves are those of the T-mesh.
/// Complexity: O(n log n).
std::string defect(const Quad_mesh& m, const T_mesh& t);

/// by vertex, the next one along the boundary with the quads on the left, `std::size_t(-1)` inside.
/// \pre `defect()` of `m` is empty
/// Complexity: O(n log n).
std::vector<std::size_t> next_on_boundary(const Quad_mesh& m);

/// by vertex, the order of the zero there, minus that of the pole, 0 where regular; m - 2 at a corner of m quads.
/// \pre `defect(m, t)` is empty
/// Complexity: linear.
std::vector<int> singularity_orders(const Quad_mesh& m, const T_mesh& t);

/// the quads as a `Surface_mesh` for applications, with the same indices and the property maps
/// - `f:patch`, `std::uint32_t`, as in `patch_mesh()`;
/// - `v:input_point`, `Surface_point`: where it is on the input;
/// - `v:singularity_order`, `int`, as above.
/// \pre `defect(m, t)` is empty
/// Complexity: linear.
Mesh surface_mesh(const Quad_mesh& m, const T_mesh& t);

/// The scaled Jacobians of all quads in two numbers.
struct Scaled_jacobian
{
  double least, mean;   ///< over all quads
};

/// the scaled Jacobian of a quad: the least sine of its angles, each seen along the normal of the quad and negative
/// where it is turned over; 1 for rectangles. The normal is that of its diagonals.
/// Complexity: linear. Source: Knupp 2000.
Scaled_jacobian scaled_jacobian(const Quad_mesh& m);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_QUAD_MESH_H
