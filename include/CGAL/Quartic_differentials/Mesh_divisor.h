// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_MESH_DIVISOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_MESH_DIVISOR_H

#include <CGAL/Quartic_differentials/copy_mesh.h>
#include <CGAL/Quartic_differentials/divisor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A point of a mesh with its order in a divisor: positive for zeros, negative for poles.
template <class TriangleMesh>
struct Mesh_singularity
{
  Polygon_mesh_processing::Face_location<TriangleMesh, double> location;
  int  order  = 0;
  bool pinned = false;   ///< may not be moved
  bool on_boundary = false;   ///< a corner, of order m - 2, on a boundary edge: the coordinate opposite to it is exactly 0
};

/// A divisor on a mesh of the user's.
template <class TriangleMesh>
using Mesh_divisor = std::vector<Mesh_singularity<TriangleMesh>>;

namespace internal {

/// which halfedge and which face of the copy is which of the mesh
template <class TriangleMesh>
class Mesh_correspondence
{
public:
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using face_descriptor     = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  template <class NamedParameters>
  Mesh_correspondence(const TriangleMesh& mesh, const Intrinsic_triangulation& copy, const NamedParameters& np)
    : m_copied_halfedge(num_halfedges(mesh)), m_copied_face(num_faces(mesh)), m_halfedge(copy.number_of_halfedges())
  {
    const auto halfedge_index = CGAL::get_initialized_halfedge_index_map(mesh, np);
    const auto face_index = CGAL::get_initialized_face_index_map(mesh, np);
    m_halfedge_index = [halfedge_index](halfedge_descriptor h) { return get(halfedge_index, h); };
    m_face_index = [face_index](face_descriptor f) { return get(face_index, f); };
    for (auto f : faces(mesh)) {
      const Face copied(static_cast<Mesh::size_type>(m_face.size()));
      m_face.push_back(f);
      m_copied_face[get(face_index, f)] = copied;
      const auto there = halfedges_of(f, mesh);
      const auto here = copy.halfedges(copied);
      for (int k = 0; k < 3; ++k) {
        m_copied_halfedge[get(halfedge_index, there[k])] = here[k];
        m_halfedge[here[k]] = there[k];
      }
    }
  }

  Halfedge copied(halfedge_descriptor h) const { return m_copied_halfedge[m_halfedge_index(h)]; }
  Face     copied(face_descriptor f)     const { return m_copied_face[m_face_index(f)]; }
  halfedge_descriptor original(Halfedge h) const { return m_halfedge[h]; }
  face_descriptor     original(Face f)     const { return m_face[f]; }

  Divisor copied(const Mesh_divisor<TriangleMesh>& divisor) const
  {
    Divisor result;
    for (const Mesh_singularity<TriangleMesh>& s : divisor)
      result.push_back({{copied(s.location.first), s.location.second}, s.order, s.pinned, s.on_boundary});
    return result;
  }

  Mesh_divisor<TriangleMesh> original(const Divisor& divisor) const
  {
    Mesh_divisor<TriangleMesh> result;
    for (const Singularity& s : divisor)
      result.push_back({{original(s.location.face), s.location.barycentric}, s.order, s.pinned, s.on_boundary});
    return result;
  }

private:
  std::vector<Halfedge>                           m_copied_halfedge;   // by index in the mesh
  std::vector<Face>                               m_copied_face;       // by index in the mesh
  std::vector<halfedge_descriptor>                m_halfedge;
  std::vector<face_descriptor>                    m_face;
  std::function<std::size_t(halfedge_descriptor)> m_halfedge_index;
  std::function<std::size_t(face_descriptor)>     m_face_index;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_MESH_DIVISOR_H
