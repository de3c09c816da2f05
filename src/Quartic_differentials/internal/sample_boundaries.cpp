// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The surfaces with boundary of sample_surfaces.h.

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/face_frames.h>
#include <CGAL/Quartic_differentials/internal/shortest_path_tree.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double pi = CGAL_PI;

// A part of a mesh: some of its faces.
class Part
{
public:
  // the faces that have no corner for which `is_out(v)`
  template <class Is_out>
  Part(const Mesh& mesh, Is_out is_out) : m_mesh(mesh), m_is_in(mesh.number_of_faces(), true)
  {
    for (Halfedge h : mesh.halfedges())
      if (!mesh.is_border(h) && is_out(mesh.source(h))) m_is_in[mesh.face(h)] = false;
    while (leave_out_pinched() || leave_out_ears()) {}
  }

  Mesh mesh() const
  {
    Mesh part;
    std::vector<Vertex> copy(m_mesh.number_of_vertices(), Mesh::null_vertex());
    for (Face f : m_mesh.faces()) {
      if (!m_is_in[f]) continue;
      std::array<Vertex, 3> v;
      Halfedge h = m_mesh.halfedge(f);
      for (Vertex& w : v) {
        Vertex& c = copy[m_mesh.source(h)];
        if (c == Mesh::null_vertex()) c = part.add_vertex(m_mesh.point(m_mesh.source(h)));
        w = c;
        h = m_mesh.next(h);
      }
      part.add_face(v[0], v[1], v[2]);
    }
    return part;
  }

private:
  bool is_in(Halfedge h) const { return !m_mesh.is_border(h) && m_is_in[m_mesh.face(h)]; }
  bool is_border(Halfedge h) const { return is_in(h) && !is_in(m_mesh.opposite(h)); }

  // faces at vertices through which two boundary curves would pass
  bool leave_out_pinched()
  {
    std::vector<int> passing(m_mesh.number_of_vertices(), 0);
    for (Halfedge h : m_mesh.halfedges()) passing[m_mesh.source(h)] += is_border(h);
    bool any = false;
    for (Halfedge h : m_mesh.halfedges())
      if (is_in(h) && passing[m_mesh.source(h)] > 1) {
        m_is_in[m_mesh.face(h)] = false;
        any = true;
      }
    return any;
  }

  bool leave_out_ears()
  {
    bool any = false;
    for (Face f : m_mesh.faces()) {
      const Halfedge h = m_mesh.halfedge(f), n = m_mesh.next(h), p = m_mesh.prev(h);
      if (!m_is_in[f] || is_border(h) + is_border(n) + is_border(p) < 2) continue;
      m_is_in[f] = false;
      any = true;
    }
    return any;
  }

  const Mesh&       m_mesh;
  std::vector<char> m_is_in;   // by face
};

// Rings of 6k vertices round a centre, k = 1 .. n, in a disk of radius 1.
Mesh rings(int n)
{
  Mesh mesh;
  mesh.add_vertex(Point_3(0, 0, 0));
  for (int k = 1; k <= n; ++k)
    for (int i = 0; i < 6 * k; ++i) {
      const double angle = 2 * pi * i / (6 * k), r = static_cast<double>(k) / n;
      mesh.add_vertex(Point_3(r * std::cos(angle), r * std::sin(angle), 0));
    }
  const auto vertex = [](int k, int i) {   // vertex i of ring k
    return Vertex(static_cast<Mesh::size_type>(k == 0 ? 0 : 1 + 3 * k * (k - 1) + i % (6 * k)));
  };
  for (int k = 0; k < n; ++k)
    for (int sector = 0; sector < 6; ++sector)
      for (int j = 0; j <= k; ++j) {
        const int inner = sector * k + j, outer = sector * (k + 1) + j;
        mesh.add_face(vertex(k, inner), vertex(k + 1, outer), vertex(k + 1, outer + 1));
        if (j < k) mesh.add_face(vertex(k, inner), vertex(k + 1, outer + 1), vertex(k, inner + 1));
      }
  return mesh;
}

} // namespace

Mesh plate(int holes, int resolution)
{
  CGAL_precondition(0 <= holes && holes <= 5 && resolution >= 12);
  const double radius = holes == 1 ? 0.35 : 0.2, distance = holes == 1 ? 0 : 0.55;
  const Mesh disk = rings(resolution);
  return Part(disk, [&](Vertex v) {
    for (int i = 0; i < holes; ++i) {
      const double angle = 2 * pi * i / holes + 0.3;
      const Point_3 centre(distance * std::cos(angle), distance * std::sin(angle), 0);
      if (CGAL::squared_distance(disk.point(v), centre) < radius * radius) return true;
    }
    return false;
  }).mesh();
}

Mesh with_disks_cut_out(const Mesh& mesh, int count, double radius)
{
  CGAL_precondition(count >= 1);
  const Intrinsic_triangulation t{Mesh(mesh)};
  std::vector<double> distance(t.number_of_vertices(), std::numeric_limits<double>::infinity());
  Vertex centre = *t.vertices().begin();
  for (int i = 0; i < count; ++i) {
    const std::vector<double> from_here = internal::shortest_path_tree(t, t.lengths(), centre).distance;
    for (Vertex v : t.vertices()) distance[v] = std::min(distance[v], from_here[v]);
    centre = Vertex(static_cast<Mesh::size_type>(std::max_element(distance.begin(), distance.end()) - distance.begin()));
  }
  const double out = radius * std::sqrt(t.area());
  Mesh part = Part(t.mesh(), [&](Vertex v) { return distance[v] < out; }).mesh();
  const Intrinsic_triangulation surface(part);
  if (surface.number_of_faces() == 0
      || internal::visit_faces_breadth_first(surface, [](Halfedge) {}) != surface.number_of_faces()
      || surface.number_of_boundary_curves() != count + t.number_of_boundary_curves() || surface.genus() != t.genus())
    throw Unusable_surface_error("the disks that are cut out meet each other or the boundary: take a smaller radius");
  return part;
}

} } // namespace CGAL::Quartic_differentials
