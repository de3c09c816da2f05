// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_COPY_MESH_H
#define CGAL_QUARTIC_DIFFERENTIALS_COPY_MESH_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace internal {

/// whether CGAL knows the faces of a type. (Its graph traits are not asked: those of other types do not compile.)
template <class Graph, class = void>
struct is_face_list_graph : std::false_type {};

template <class Graph>
struct is_face_list_graph<Graph, std::void_t<decltype(num_faces(std::declval<const Graph&>()))>> : std::true_type {};

/// the halfedges h0, h1, h2 of a face: `Surface_point` refers to their sources
template <class TriangleMesh>
std::array<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, 3>
halfedges_of(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& mesh)
{
  const auto h = halfedge(f, mesh);
  return {h, next(h, mesh), prev(h, mesh)};
}

template <class TriangleMesh, class NamedParameters>
Intrinsic_triangulation copy_in_space(const TriangleMesh& mesh, const NamedParameters& np)
{
  namespace P = CGAL::parameters;
  const auto point_map = P::choose_parameter(P::get_parameter(np, internal_np::vertex_point),
                                             get_const_property_map(vertex_point, mesh));
  const auto index = CGAL::get_initialized_vertex_index_map(mesh, np);
  Mesh copy;
  std::vector<Vertex> vertex_of(num_vertices(mesh));
  for (auto v : vertices(mesh)) {
    const auto& p = get(point_map, v);
    vertex_of[get(index, v)] =
      copy.add_vertex(Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
  }
  for (auto f : faces(mesh)) {
    std::array<Vertex, 3> corner;
    const auto h = halfedges_of(f, mesh);
    for (int k = 0; k < 3; ++k) corner[k] = vertex_of[get(index, source(h[k], mesh))];
    const Face g = copy.add_face(corner[0], corner[1], corner[2]);
    copy.set_halfedge(g, copy.halfedge(corner[0], corner[1]));
  }
  return Intrinsic_triangulation(std::move(copy));
}

template <class TriangleMesh, class EdgeLengthMap, class NamedParameters>
Intrinsic_triangulation copy_with_lengths(const TriangleMesh& mesh, const EdgeLengthMap& lengths,
                                          const NamedParameters& np)
{
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(mesh, np);
  const auto halfedge_index = CGAL::get_initialized_halfedge_index_map(mesh, np);
  std::vector<int> number(num_vertices(mesh));
  int n = 0;
  for (auto v : vertices(mesh)) number[get(vertex_index, v)] = n++;
  // by halfedge: the number of its face, and 0, 1 or 2
  std::vector<std::array<int, 2>> place(num_halfedges(mesh), {-1, -1});
  n = 0;
  for (auto f : faces(mesh)) {
    const auto h = halfedges_of(f, mesh);
    for (int k = 0; k < 3; ++k) place[get(halfedge_index, h[k])] = {n, k};
    ++n;
  }
  Glued_triangles glued;
  for (auto f : faces(mesh)) {
    const auto h = halfedges_of(f, mesh);
    glued.triangles.emplace_back();
    glued.opposite.emplace_back();
    glued.lengths.emplace_back();
    for (int k = 0; k < 3; ++k) {
      glued.triangles.back()[k] = number[get(vertex_index, source(h[k], mesh))];
      glued.opposite.back()[k] = place[get(halfedge_index, opposite(h[k], mesh))];
      glued.lengths.back()[k] = CGAL::to_double(get(lengths, edge(h[k], mesh)));
    }
  }
  return Intrinsic_triangulation(glued);
}

} // namespace internal

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
///   \cgalParamNBegin{edge_length_map}
///     \cgalParamDescription{the lengths of the edges, of `Quartic_differentials::parameters`: if it is given, points
///                           are not looked at, and the surface need not lie in space. The mesh may be a Delta-complex:
///                           edges may be parallel, or loops}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `edge_descriptor` as key type and values convertible
///                    to `double`}
///     \cgalParamDefault{distances of the points}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{the indices of the vertices, from 0; with an edge length map, those of the halfedges too}
///     \cgalParamDefault{an index map that is made}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Unusable_surface_error if the mesh is empty, has a face that is not a triangle or a vertex that is not
///         manifold, is not connected, has a degenerate face, or lengths that do not satisfy the triangle inequality
/// Complexity: linear.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Intrinsic_triangulation intrinsic_triangulation(const TriangleMesh& mesh,
                                                const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(internal::is_face_list_graph<TriangleMesh>::value,
                "the mesh must be a model of CGAL's concept FaceListGraph, like CGAL::Surface_mesh or Polyhedron_3");
  if (!is_triangle_mesh(mesh)) throw Unusable_surface_error("the mesh has a face that is not a triangle");
  const auto lengths = CGAL::parameters::get_parameter(np, parameters::edge_length_map_t());
  constexpr bool in_space = std::is_same<std::decay_t<decltype(lengths)>, internal_np::Param_not_found>::value;
  Intrinsic_triangulation result;
  if constexpr (in_space) result = internal::copy_in_space(mesh, np);
  else                    result = internal::copy_with_lengths(mesh, lengths, np);
  if (const std::string defect = structural_defect(result); !defect.empty()) throw Unusable_surface_error(defect);
  check_surface(result);
  return result;
}

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_COPY_MESH_H
