// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The surfaces with boundary of sample_surfaces.h and sample_boundaries.h.

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/face_frames.h>
#include <CGAL/Quartic_differentials/internal/shortest_path_tree.h>
#include <CGAL/Quartic_differentials/sample_boundaries.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
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

// The squares (i, j) of the plane for which `is_in(i, j)`, 0 <= i < columns, 0 <= j < rows, cut along their diagonals.
template <class Is_in>
Mesh squares(int columns, int rows, double side, Is_in is_in)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Vertex> vertices;
  const auto vertex = [&](int i, int j) {
    const auto [at, is_new] = vertices.try_emplace({i, j});
    if (is_new) at->second = mesh.add_vertex(Point_3(side * i, side * j, 0));
    return at->second;
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      if (!is_in(i, j)) continue;
      const Vertex a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      mesh.add_face(a, b, c);
      mesh.add_face(a, c, d);
    }
  return mesh;
}

// the middles of the holes
std::vector<std::pair<double, double>> middles_of_holes(Plate_shape shape, int holes)
{
  if (shape == Plate_shape::l) {
    const std::vector<std::pair<double, double>> all{{0.75, 0.75}, {2.25, 0.75}, {0.75, 2.25}, {1.5, 0.75}};
    return {all.begin(), all.begin() + holes};
  }
  if (holes == 4) return {{0.75, 0.5}, {2.25, 0.5}, {0.75, 1.5}, {2.25, 1.5}};
  std::vector<std::pair<double, double>> row;
  for (int i = 0; i < holes; ++i) row.emplace_back(3 * (i + 0.5) / holes, 1);
  return row;
}

bool is_connected(const Intrinsic_triangulation& t)
{ return internal::visit_faces_breadth_first(t, [](Halfedge) {}) == t.number_of_faces(); }

Mesh without_disks(const Mesh& mesh, int count, double radius, Vertex first)
{
  CGAL_precondition(count >= 1);
  const Intrinsic_triangulation t{Mesh(mesh)};
  std::vector<double> distance(t.number_of_vertices(), std::numeric_limits<double>::infinity());
  Vertex centre = first;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> from_here = internal::shortest_path_tree(t, t.lengths(), centre).distance;
    for (Vertex v : t.vertices()) distance[v] = std::min(distance[v], from_here[v]);
    const auto farthest = std::max_element(distance.begin(), distance.end());
    centre = Vertex(static_cast<Mesh::size_type>(farthest - distance.begin()));
  }
  const double out = radius * std::sqrt(t.area());
  Mesh part = Part(t.mesh(), [&](Vertex v) { return distance[v] < out; }).mesh();
  const Intrinsic_triangulation surface(part);
  if (surface.number_of_faces() == 0 || !is_connected(surface)
      || surface.number_of_boundary_curves() != count + t.number_of_boundary_curves() || surface.genus() != t.genus())
    throw Unusable_surface_error("the disks that are cut out meet each other or the boundary: take a smaller radius");
  return part;
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

Mesh plate(Plate_shape shape, int holes, int resolution)
{
  CGAL_precondition(0 <= holes && holes <= 4 && resolution >= 6);
  const double side = 1.0 / resolution;
  const auto middles = middles_of_holes(shape, holes);
  return squares(3 * resolution, (shape == Plate_shape::l ? 3 : 2) * resolution, side, [&](int i, int j) {
    const double x = side * (i + 0.5), y = side * (j + 0.5);
    const bool in_hole = std::any_of(middles.begin(), middles.end(), [&](const auto& m) {
      return std::max(std::abs(x - m.first), std::abs(y - m.second)) < 0.25;
    });
    return !in_hole && !(shape == Plate_shape::l && x > 1.5 && y > 1.5);
  });
}

Mesh with_disks_cut_out(const Mesh& mesh, int count, double radius)
{ return without_disks(mesh, count, radius, Vertex(0)); }

Mesh with_disks_cut_out(const Mesh& mesh, int count, double radius, unsigned seed)
{
  std::mt19937 random(seed);
  return without_disks(mesh, count, radius, Vertex(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())));
}

Mesh part_in_front(const Mesh& mesh, const Vector_3& normal)
{
  CGAL::Bbox_3 box;
  for (Vertex v : mesh.vertices()) box += mesh.point(v).bbox();
  const Point_3 middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
  Mesh part = Part(mesh, [&](Vertex v) { return (mesh.point(v) - middle) * normal < 0; }).mesh();
  if (part.number_of_faces() == 0 || part.number_of_faces() == mesh.number_of_faces())
    throw Unusable_surface_error("the plane does not cut the surface: take another normal");
  if (!is_connected(Intrinsic_triangulation(part)))
    throw Unusable_surface_error("the surface in front of the plane is not connected: take another normal");
  return part;
}

} } // namespace CGAL::Quartic_differentials
