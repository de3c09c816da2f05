// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/face_frames.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

bool triangle_inequality_holds(const std::array<double, 3>& l)
{
  return l[0] < l[1] + l[2] && l[1] < l[2] + l[0] && l[2] < l[0] + l[1];
}

std::string edge_name(std::size_t triangle, int edge)
{
  return "edge " + std::to_string(edge) + " of triangle " + std::to_string(triangle);
}

bool is_unglued(const std::array<int, 2>& opposite) { return opposite == std::array<int, 2>{-1, -1}; }

void check_gluing(const Glued_triangles& s)
{
  const int n = static_cast<int>(s.triangles.size());
  if (n == 0) throw Unusable_surface_error("the surface has no triangle");
  if (s.opposite.size() != s.triangles.size() || s.lengths.size() != s.triangles.size())
    throw Unusable_surface_error("triangles, opposite and lengths of the surface differ in number");
  for (int t = 0; t < n; ++t) {
    for (int e = 0; e < 3; ++e) {
      const auto [u, f] = s.opposite[t][e];
      if (s.triangles[t][e] < 0) throw Unusable_surface_error("triangle " + std::to_string(t) + " has a negative vertex");
      if (!(s.lengths[t][e] > 0) || !std::isfinite(s.lengths[t][e]))
        throw Unusable_surface_error(edge_name(t, e) + " has no positive finite length");
      if (is_unglued(s.opposite[t][e])) continue;
      if (u < 0 || u >= n || f < 0 || f > 2)
        throw Unusable_surface_error(edge_name(t, e) + " is glued to something that does not exist");
      if ((u == t && f == e) || s.opposite[u][f] != std::array<int, 2>{t, e})
        throw Unusable_surface_error(edge_name(t, e) + " is not glued to exactly one other edge");
      if (s.triangles[t][e] != s.triangles[u][(f + 1) % 3] || s.triangles[t][(e + 1) % 3] != s.triangles[u][f])
        throw Unusable_surface_error(edge_name(t, e) + " is glued to an edge with other end points");
      if (s.lengths[t][e] != s.lengths[u][f])
        throw Unusable_surface_error(edge_name(t, e) + " is glued to an edge of another length");
    }
    if (!triangle_inequality_holds(s.lengths[t]))
      throw Unusable_surface_error("triangle " + std::to_string(t) + " violates the triangle inequality");
  }
}

} // namespace

Intrinsic_triangulation::Intrinsic_triangulation(Mesh mesh)
  : m_mesh(std::move(mesh)), m_length(m_mesh.number_of_edges()), m_embedded(true)
{
  for (Edge e : m_mesh.edges()) {
    const Halfedge h = m_mesh.halfedge(e);
    m_length[e] = std::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))));
  }
  hold_borders();
}

Intrinsic_triangulation::Intrinsic_triangulation(const Glued_triangles& s)
{
  check_gluing(s);
  int last = -1;
  for (const auto& t : s.triangles) last = std::max({last, t[0], t[1], t[2]});
  for (int v = 0; v <= last; ++v) m_mesh.add_vertex();

  // halfedge of (triangle, edge); an edge is made when its first side is met
  std::vector<std::array<Halfedge, 3>> side(s.triangles.size());
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (int e = 0; e < 3; ++e) {
      const auto [u, f] = s.opposite[t][e];
      if (side[t][e] != Mesh::null_halfedge()) continue;
      side[t][e] = m_mesh.add_edge();
      if (!is_unglued(s.opposite[t][e])) side[u][f] = m_mesh.opposite(side[t][e]);
      m_length.push_back(s.lengths[t][e]);
    }
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const Face f = m_mesh.add_face();
    m_mesh.set_halfedge(f, side[t][0]);
    for (int e = 0; e < 3; ++e) {
      const Vertex v(s.triangles[t][(e + 1) % 3]);
      m_mesh.set_next(side[t][e], side[t][(e + 1) % 3]);
      m_mesh.set_face(side[t][e], f);
      m_mesh.set_target(side[t][e], v);
      m_mesh.set_halfedge(v, side[t][e]);
    }
  }
  // a border halfedge leads to the border halfedge at the other end of the fan of faces round its target
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (int e = 0; e < 3; ++e) {
      if (!is_unglued(s.opposite[t][e])) continue;
      const Halfedge border = m_mesh.opposite(side[t][e]);
      m_mesh.set_target(border, Vertex(s.triangles[t][e]));
      Halfedge last = side[t][e];
      do last = m_mesh.opposite(m_mesh.prev(last)); while (!m_mesh.is_border(last));
      m_mesh.set_next(border, last);
    }
  hold_borders();
  const std::string defect = structural_defect(*this);
  if (!defect.empty()) throw Unusable_surface_error(defect);
}

void Intrinsic_triangulation::hold_borders()
{
  for (Halfedge h : halfedges())
    if (is_border(h)) m_mesh.set_halfedge(target(h), h);
}

bool Intrinsic_triangulation::has_boundary() const
{
  return std::any_of(halfedges().begin(), halfedges().end(), [&](Halfedge h) { return is_border(h); });
}

std::vector<std::vector<Halfedge>> Intrinsic_triangulation::boundary_curves() const
{
  std::vector<std::vector<Halfedge>> curves;
  std::vector<char> seen(number_of_edges(), false);
  for (Edge e : edges()) {
    if (!is_border(e) || seen[e]) continue;
    curves.emplace_back();
    const Halfedge first = is_border(halfedge(e)) ? opposite(halfedge(e)) : halfedge(e);
    Halfedge h = first;
    do {
      seen[edge(h)] = true;
      curves.back().push_back(h);
      h = next_on_boundary(h);
    } while (h != first);
  }
  return curves;
}

int Intrinsic_triangulation::genus() const
{
  const long chi = static_cast<long>(number_of_vertices()) - static_cast<long>(number_of_edges())
                 + static_cast<long>(number_of_faces());
  return static_cast<int>((2 - chi - number_of_boundary_curves()) / 2);
}

int Intrinsic_triangulation::corner(Halfedge h) const
{
  const Halfedge h0 = m_mesh.halfedge(m_mesh.face(h));
  return h == h0 ? 0 : m_mesh.next(h0) == h ? 1 : 2;
}

std::array<std::complex<double>, 3> Intrinsic_triangulation::unfolded(Face f) const
{
  const auto [h0, h1, h2] = halfedges(f);
  const double a = length(h0), b = length(h1), c = length(h2);
  const double x = twice_scalar_product(b, c, a) / (2 * a), y = four_times_area(a, b, c) / (2 * a);
  return {std::complex<double>(0, 0), std::complex<double>(a, 0), std::complex<double>(x, y)};
}

double Intrinsic_triangulation::area() const
{
  double sum = 0;
  for (Face f : faces()) {
    const auto [h0, h1, h2] = halfedges(f);
    sum += four_times_area(length(h0), length(h1), length(h2));
  }
  return sum / 4;
}

Edge_flip Intrinsic_triangulation::flip_of(Edge e, double new_length, bool ptolemy) const
{
  const Halfedge h = halfedge(e), o = opposite(h);
  return {e, h, next(h), prev(h), o, next(o), prev(o), m_length[e], new_length, ptolemy};
}

void Intrinsic_triangulation::flip(const Edge_flip& flip)
{
  CGAL_precondition(face(flip.ij) != face(flip.ji));
  CGAL::Euler::flip_edge(flip.ij, m_mesh);
  m_length[flip.edge] = flip.new_length;
}

Intrinsic_triangulation::Insertion Intrinsic_triangulation::insert(const Surface_point& p)
{
  const auto corner = unfolded(p.face);
  const auto rim = halfedges(p.face);
  std::complex<double> z = 0;
  for (int k = 0; k < 3; ++k) z += p.barycentric[k] * corner[k];

  const Halfedge spoke_in = CGAL::Euler::add_center_vertex(rim[0], m_mesh);   // from target(rim[0]) to the new vertex
  m_length.resize(m_mesh.number_of_edges());
  Insertion result;
  result.vertex = m_mesh.target(spoke_in);
  result.rim = rim;
  for (int k = 0; k < 3; ++k) {
    result.spoke[k] = m_mesh.prev(rim[k]);
    m_length[m_mesh.edge(result.spoke[k])] = std::abs(corner[k] - z);
  }
  return result;
}

Intrinsic_triangulation::Boundary_split Intrinsic_triangulation::split_boundary_edge(Halfedge h, double fraction)
{
  CGAL_precondition(!is_border(h) && is_border(opposite(h)) && 0 < fraction && fraction < 1);
  const Halfedge border = opposite(h), to_apex = next(h);
  const double whole = length(h), back = length(prev(h)), across = length(to_apex);
  const double foot = (whole * whole + back * back - across * across) / (2 * whole);
  const double height = four_times_area(whole, back, across) / (2 * whole);

  Boundary_split split;
  split.second = opposite(CGAL::Euler::split_edge(border, m_mesh));   // border becomes the border of v0 p
  split.first = h;
  split.vertex = source(split.second);
  m_mesh.set_halfedge(split.vertex, opposite(split.second));
  m_mesh.set_halfedge(target(split.second), prev(opposite(split.second)));
  split.spoke = CGAL::Euler::split_face(h, to_apex, m_mesh);
  m_length.resize(number_of_edges());
  m_length[edge(split.first)] = fraction * whole;
  m_length[edge(split.second)] = (1 - fraction) * whole;
  m_length[edge(split.spoke)] = std::hypot(foot - fraction * whole, height);
  return split;
}

std::string structural_defect(const Intrinsic_triangulation& t)
{
  for (Halfedge h : t.halfedges()) {
    if (!t.is_border(h) && t.next(t.next(t.next(h))) != h)
      return "halfedge " + std::to_string(h.idx()) + " is not in a triangle";
    if (t.prev(t.next(h)) != h) return "halfedge " + std::to_string(h.idx()) + " is not before its next";
    if (t.face(t.next(h)) != t.face(h)) return "halfedge " + std::to_string(h.idx()) + " changes its face";
    if (t.source(t.next(h)) != t.target(h)) return "halfedge " + std::to_string(h.idx()) + " changes its vertex";
  }
  for (Face f : t.faces())
    if (t.face(t.halfedge(f)) != f) return "face " + std::to_string(f.idx()) + " does not hold its halfedge";
  std::vector<std::size_t> outgoing(t.number_of_vertices(), 0), borders(t.number_of_vertices(), 0);
  for (Halfedge h : t.halfedges()) {
    ++outgoing[t.source(h)];
    if (t.is_border(h) && ++borders[t.target(h)] > 1)
      return "the triangles at vertex " + std::to_string(t.target(h).idx()) + " form more than one fan";
    if (t.is_border(h) && !t.is_border(t.target(h)))
      return "vertex " + std::to_string(t.target(h).idx()) + " does not hold its border halfedge";
  }
  for (Vertex v : t.vertices()) {
    if (outgoing[v] == 0) return "vertex " + std::to_string(v.idx()) + " is not used by any triangle";
    const Halfedge first = t.halfedge_from(v);
    std::size_t n = 0;
    Halfedge h = first;
    do { h = t.next_around_source(h); ++n; } while (h != first && n <= outgoing[v]);
    if (n != outgoing[v]) return "the triangles at vertex " + std::to_string(v.idx()) + " do not form one circle";
  }
  return {};
}

void check_surface(const Intrinsic_triangulation& t)
{
  if (t.number_of_faces() == 0) throw Unusable_surface_error("the surface has no triangle");
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    if (!(four_times_area(t.length(h[0]), t.length(h[1]), t.length(h[2])) > 0))
      throw Unusable_surface_error("face " + std::to_string(f.idx()) + " has no area");
  }
  const std::size_t reached = internal::visit_faces_breadth_first(t, [](Halfedge) {});
  if (reached != t.number_of_faces())
    throw Unusable_surface_error("the surface is not connected: " + std::to_string(reached) + " of "
                                 + std::to_string(t.number_of_faces()) + " faces hang together with the first");
}

} } // namespace CGAL::Quartic_differentials
