// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/patch_mesh.h>

#include "internal/grid_lines.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/geodesic_disk.h>
#include <CGAL/Quartic_differentials/internal/patch_pieces.h>
#include <CGAL/Quartic_differentials/pull_back.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Chart_point;
using internal::Patch_piece;
using Complex = std::complex<double>;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

// A rational number a + (b - a) n / d.
struct Coordinate
{
  std::int64_t a, b, n, d;

  bool is(std::int64_t x) const { return static_cast<__int128>(b - a) * n == static_cast<__int128>(x - a) * d; }
  // exact where it is an integer, and 0 nowhere else: what is added to the next lower integer is not negative
  double rounded() const
  {
    const __int128 numerator = static_cast<__int128>(b - a) * n;
    const std::int64_t remainder = static_cast<std::int64_t>(numerator % d);
    const std::int64_t rest = remainder < 0 ? remainder + d : remainder;
    return static_cast<double>(a + static_cast<std::int64_t>((numerator - rest) / d))
         + static_cast<double>(rest) / static_cast<double>(d);
  }
};

// A corner of a piece, in its patch.
struct Piece_corner
{
  Vertex   vertex;
  Complex  z;       // in grid units
  unsigned sides;   // a bit for every side of the patch on which it lies
};

// The piece is convex, so collinear corners lie on a side of it, which is one of the patch or of the face. On a side of
// the face there are only two, unless arcs run along it: every other arc that meets it goes on into the face.
bool are_collinear(const Piece_corner& a, const Piece_corner& b, const Piece_corner& c)
{
  return (a.sides & b.sides & c.sides) != 0;
}

double altitude(const Piece_corner& a, const Piece_corner& b, const Piece_corner& c)
{
  if (are_collinear(a, b, c)) return -std::numeric_limits<double>::infinity();
  const double not_0 = std::numeric_limits<double>::min();   // points may be nearer to each other than doubles can tell
  return internal::cross(b.z - a.z, c.z - a.z)
       / std::max({std::abs(b.z - a.z), std::abs(c.z - b.z), std::abs(a.z - c.z), not_0});
}

// The triangulation of a convex polygon with the largest least altitude, by dynamic programming.
class Polygon_triangulation
{
public:
  using Triangle = std::array<std::size_t, 3>;

  explicit Polygon_triangulation(const std::vector<Piece_corner>& polygon)
    : m_n(polygon.size()), m_best(m_n * m_n, {std::numeric_limits<double>::infinity(), 0})
  {
    for (std::size_t span = 2; span < m_n; ++span)
      for (std::size_t i = 0; i + span < m_n; ++i) m_best[i * m_n + i + span] = best_apex(polygon, i, i + span);
  }

  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> result;
    add_triangles(0, m_n - 1, result);
    return result;
  }

private:
  struct Best
  {
    double      altitude;   // the least one in the polygon from i to j
    std::size_t apex;       // of the triangle on ij
  };

  const Best& best(std::size_t i, std::size_t j) const { return m_best[i * m_n + j]; }

  Best best_apex(const std::vector<Piece_corner>& polygon, std::size_t i, std::size_t j) const
  {
    Best result{-std::numeric_limits<double>::infinity(), i + 1};
    for (std::size_t k = i + 1; k < j; ++k) {
      const double least = std::min({altitude(polygon[i], polygon[k], polygon[j]), best(i, k).altitude,
                                     best(k, j).altitude});
      if (least > result.altitude) result = {least, k};
    }
    return result;
  }

  void add_triangles(std::size_t i, std::size_t j, std::vector<Triangle>& result) const
  {
    if (j == i + 1) return;
    const std::size_t k = best(i, j).apex;
    result.push_back({i, k, j});
    add_triangles(i, k, result);
    add_triangles(k, j, result);
  }

  std::size_t       m_n;
  std::vector<Best> m_best;   // by i, j
};

// Puts the pieces together.
class Patch_mesh_builder
{
public:
  Patch_mesh_builder(const T_mesh& t, const Refined_surface& refined)
    : m_t(t), m_refined(refined), m_q(refined.differential), m_charts(m_q),
      m_patch(m_mesh.add_property_map<Face, std::uint32_t>("f:patch").first),
      m_input_face(m_mesh.add_property_map<Face, Face>("f:input_face").first),
      m_texture(m_mesh.add_property_map<Halfedge, Point_2>("h:texture").first),
      m_arc(m_mesh.add_property_map<Edge, std::uint32_t>("e:arc", no_arc).first),
      m_place(m_mesh.add_property_map<Vertex, Surface_point>("v:input_point").first),
      m_order(m_mesh.add_property_map<Vertex, int>("v:singularity_order", 0).first)
  {
    add_refined_vertices();
    for (const Patch_piece& piece : internal::patch_pieces(t, m_q)) add_piece(piece);
    for (std::size_t a = 0; a < t.arcs.size(); ++a) mark_arc(a);
  }

  Mesh result() && { return std::move(m_mesh); }

private:
  const Intrinsic_triangulation& triangulation() const { return m_q.triangulation; }

  void add_refined_vertices()
  {
    for (Vertex v : triangulation().vertices())
      m_order[m_mesh.add_vertex(triangulation().mesh().point(v))] = m_q.order[v];
    for (Halfedge h : triangulation().halfedges())
      if (!triangulation().is_border(h))
        m_place[triangulation().source(h)] = {m_refined.input_face[triangulation().face(h)], m_refined.input_corner[h]};
  }

  Vertex vertex(const Chart_point& p)
  {
    if (p.place == Chart_point::Place::corner) return triangulation().source(p.halfedge);
    const auto [it, is_new] = m_added.try_emplace(exact_name(p));
    if (is_new) {
      it->second = m_mesh.add_vertex(internal::position(m_q, p));
      m_place[it->second] = m_refined.to_input({p.face, barycentric(p)});
    }
    return it->second;
  }

  // the same from all faces: a point of an edge is a node, or on one arc, and its fraction is counted in one way
  std::array<std::int64_t, 4> exact_name(const Chart_point& p) const
  {
    if (p.place == Chart_point::Place::interior) return {0, p.face.idx(), p.z.x, p.z.y};
    return {1, triangulation().edge(p.halfedge).idx(), internal::numerator_along_edge(m_q, p), p.denominator};
  }

  std::array<double, 3> barycentric(const Chart_point& p) const
  {
    if (p.place == Chart_point::Place::interior) {
      const auto [h0, h1, h2] = triangulation().halfedges(p.face);
      return internal::barycentric({m_charts.corner(h0), m_charts.corner(h1), m_charts.corner(h2)}, p.z);
    }
    const double x = static_cast<double>(p.numerator) / static_cast<double>(p.denominator);
    std::array<double, 3> result{};
    result[triangulation().corner(p.halfedge)] = 1 - x;
    result[triangulation().corner(triangulation().next(p.halfedge))] = x;
    return result;
  }

  // x and y in the patch, in grid units; an edge's ends are in the same order for both its faces
  std::array<Coordinate, 2> in_patch(const Patch_piece& piece, const Chart_point& p) const
  {
    if (p.place == Chart_point::Place::interior) {
      const Grid_vector z = piece.to_patch(p.z);
      return {Coordinate{z.x, z.x, 0, 1}, Coordinate{z.y, z.y, 0, 1}};
    }
    Halfedge first = p.halfedge, second = triangulation().next(first);
    if (first != triangulation().halfedge(triangulation().edge(first))) std::swap(first, second);
    const Grid_vector a = piece.to_patch(m_charts.corner(first)), b = piece.to_patch(m_charts.corner(second));
    const std::int64_t n = internal::numerator_along_edge(m_q, p);
    return {Coordinate{a.x, b.x, n, p.denominator}, Coordinate{a.y, b.y, n, p.denominator}};
  }

  Piece_corner corner(const Patch_piece& piece, const Chart_point& p)
  {
    const std::int64_t width = m_t.patches[piece.patch].width, height = m_t.patches[piece.patch].height;
    const auto [x, y] = in_patch(piece, p);
    const unsigned sides = x.is(0) | x.is(width) << 1 | y.is(0) << 2 | y.is(height) << 3;
    return {vertex(p), {x.rounded(), y.rounded()}, sides};
  }

  void add_piece(const Patch_piece& piece)
  {
    std::vector<Piece_corner> polygon;
    for (const Chart_point& p : piece.corner) polygon.push_back(corner(piece, p));
    for (const auto& [i, j, k] : Polygon_triangulation(polygon).triangles())
      add_triangle(piece, polygon[i], polygon[j], polygon[k]);
  }

  void add_triangle(const Patch_piece& piece, const Piece_corner& a, const Piece_corner& b, const Piece_corner& c)
  {
    const Face f = m_mesh.add_face(a.vertex, b.vertex, c.vertex);
    if (f == Mesh::null_face())
      throw Numerical_error("the pieces of face " + std::to_string(piece.face.idx()) + " do not fit their neighbours");
    m_patch[f] = static_cast<std::uint32_t>(piece.patch);
    m_input_face[f] = m_refined.input_face[piece.face];
    const double unit = std::ldexp(1.0, -m_t.grid_exponent);
    for (const Piece_corner& p : {a, b, c})
      m_texture[halfedge_to(p.vertex, f)] = Point_2(p.z.real() * unit, p.z.imag() * unit);
  }

  // the halfedge of f that ends at v
  Halfedge halfedge_to(Vertex v, Face f) const
  {
    Halfedge h = m_mesh.halfedge(f);
    while (m_mesh.target(h) != v) h = m_mesh.next(h);
    return h;
  }

  Vertex vertex(const T_mesh::Node& node) { return vertex(internal::chart_point(m_q, node.face, node.point)); }

  void mark_arc(std::size_t a)
  {
    const T_mesh::Arc& arc = m_t.arcs[a];
    Vertex from = vertex(m_t.nodes[arc.from]);
    for (const Chart_segment& s : arc.path) {
      const Vertex to = &s == &arc.path.back() ? vertex(m_t.nodes[arc.to]) : vertex(internal::exit_of(m_q, s));
      const Halfedge h = m_mesh.halfedge(from, to);
      if (h == Mesh::null_halfedge()) throw Numerical_error("arc " + std::to_string(a) + " is no path of edges");
      m_arc[m_mesh.edge(h)] = static_cast<std::uint32_t>(a);
      from = to;
    }
  }

  const T_mesh&                                 m_t;
  const Refined_surface&                        m_refined;
  const Quartic_differential&                   m_q;
  const internal::Doubled_charts                m_charts;
  Mesh                                          m_mesh;
  Mesh::Property_map<Face, std::uint32_t>       m_patch;
  Mesh::Property_map<Face, Face>                m_input_face;
  Mesh::Property_map<Halfedge, Point_2>         m_texture;
  Mesh::Property_map<Edge, std::uint32_t>       m_arc;
  Mesh::Property_map<Vertex, Surface_point>     m_place;
  Mesh::Property_map<Vertex, int>               m_order;
  std::map<std::array<std::int64_t, 4>, Vertex> m_added;   // the vertices that are not the refined surface's
};

} // namespace

Mesh patch_mesh(const T_mesh& t, const Refined_surface& refined)
{
  return Patch_mesh_builder(t, refined).result();
}

} } // namespace CGAL::Quartic_differentials
