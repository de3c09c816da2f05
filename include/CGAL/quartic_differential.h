// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIAL_H
#define CGAL_QUARTIC_DIFFERENTIAL_H

#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <map>
#include <optional>

namespace CGAL {

/// The meromorphic quartic differential of a closed surface, and everything on the way to it. One header per step of
/// the pipeline stands in CGAL/Quartic_differentials/; this header is all that an application needs.
namespace Quartic_differentials {

/// copies a triangle mesh into the form in which the steps work.
///
/// Vertices and faces keep their order, and faces their first halfedge: barycentric coordinates of a `Surface_point` in
/// face number i refer to source(h), target(h), target(next(h)) with h = halfedge(f, mesh) of the i-th face f.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `vertex_descriptor` as key type and a 3D point with
///                    coordinates convertible to `double` as value type}
///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Unusable_surface_error if the mesh is empty, has a boundary or a face that is not a triangle, is not
///         connected, or has a degenerate face
/// Complexity: O(n log n).
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Intrinsic_triangulation intrinsic_triangulation(const TriangleMesh& mesh,
                                                const NamedParameters& np = parameters::default_values())
{
  if (!is_closed(mesh)) throw Unusable_surface_error("the mesh has a boundary");
  if (!is_triangle_mesh(mesh)) throw Unusable_surface_error("the mesh has a face that is not a triangle");
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, mesh));
  Mesh copy;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, Vertex> vertex_of;
  for (auto v : vertices(mesh)) {
    const auto& p = get(point_map, v);
    vertex_of[v] = copy.add_vertex(Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
  }
  for (auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const Vertex a = vertex_of[source(h, mesh)], b = vertex_of[target(h, mesh)], c = vertex_of[target(next(h, mesh), mesh)];
    const Face g = copy.add_face(a, b, c);
    copy.set_halfedge(g, copy.halfedge(a, b));
  }
  Intrinsic_triangulation result(std::move(copy));
  check_surface(result);
  return result;
}

/// computes the meromorphic quartic differential of a closed triangle mesh: singularities that satisfy the Abel-Jacobi
/// condition, the flat cone metric they span, its charts with exact transitions, and the T-mesh of rectangles.
///
/// \param mesh a closed connected triangle mesh of any genus
/// \param options how the singularities are chosen, and the tolerances of the steps
/// \param visitor reports progress and can stop the run
/// \param np see `intrinsic_triangulation()`
/// \throws Unusable_surface_error, Infeasible_divisor_error, Numerical_error, Cancelled_error with a sentence that says why
/// Complexity: a few sparse factorisations; the rest is O(n log n).
/// Source: METHOD; paper, section 4.
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Quartic_differential_result quartic_differential(const TriangleMesh& mesh, const Quartic_differential_options& options,
                                                 Visitor& visitor,
                                                 const NamedParameters& np = parameters::default_values())
{
  Quartic_differential_result result;
  quartic_differential(intrinsic_triangulation(mesh, np), std::nullopt, options, visitor, result);
  return result;
}

/// \overload with default options and without progress
template <class TriangleMesh>
Quartic_differential_result quartic_differential(const TriangleMesh& mesh)
{
  Visitor visitor;
  return quartic_differential(mesh, Quartic_differential_options(), visitor);
}

} // namespace Quartic_differentials
} // namespace CGAL

#endif // CGAL_QUARTIC_DIFFERENTIAL_H
