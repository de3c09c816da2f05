// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTRINSIC_TRIANGULATION_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTRINSIC_TRIANGULATION_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

using Point_3  = CGAL::Simple_cartesian<double>::Point_3;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh     = CGAL::Surface_mesh<Point_3>;
using Vertex   = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge     = Mesh::Edge_index;
using Face     = Mesh::Face_index;

/// A point of an intrinsic triangulation: barycentric coordinates with respect to the corners of `face`,
/// in the order source(h0), source(h1), source(h2) with h0 = halfedge(face), h1 = next(h0), h2 = next(h1).
struct Surface_point
{
  Face                  face;
  std::array<double, 3> barycentric{};
};

/// Triangles glued along their edges, the file form of a surface that is known by its edge lengths alone.
/// Edge e of a triangle joins its corners e and e+1 (modulo 3).
struct Glued_triangles
{
  std::vector<std::array<int, 3>>                 triangles;  ///< vertex ids
  std::vector<std::array<std::array<int, 2>, 3>>  opposite;   ///< {triangle, edge} glued to each edge; {-1, -1}: boundary
  std::vector<std::array<double, 3>>              lengths;
};

/// The halfedges and lengths round an edge e = ij that is about to be flipped to f = kl (METHOD, step 6):
/// the faces are (ij, jk, ki) and (ji, il, lj).
struct Edge_flip
{
  Edge     edge;
  Halfedge ij, jk, ki, ji, il, lj;
  double   old_length, new_length;
  bool     ptolemy;   ///< the new length is Ptolemy's (ideal), otherwise the Euclidean diagonal
};

/// A compact oriented surface glued from Euclidean triangles: a `Surface_mesh` used as a Delta-complex
/// (edges may be parallel, or loops; a face may be glued to itself), with a length for every edge.
///
/// It is closed, or has boundary curves. A boundary edge has a halfedge in a face, along which the surface lies on the
/// left, and a *border* halfedge, which has no face.
///
/// Indices are never removed or renumbered; a flip keeps the index of its edge and of the four halfedges
/// round it; an insertion appends. Data that ride along are vectors indexed by descriptors.
/// The point of a vertex of `mesh()` is its position in space if the surface `is_embedded()`.
class Intrinsic_triangulation
{
public:
  Intrinsic_triangulation() = default;

  /// takes the lengths from the positions in space.
  /// \pre `mesh` is a triangle mesh without removed elements; the faces round a vertex form one circle or one fan
  explicit Intrinsic_triangulation(Mesh mesh);

  /// glues triangles along their edges.
  /// \throws Unusable_surface_error if the gluing is not an orientation reversing involution that respects
  ///         vertices and lengths, a triangle inequality fails, or the link of a vertex is not one circle or one path
  explicit Intrinsic_triangulation(const Glued_triangles& glued);

  const Mesh& mesh() const { return m_mesh; }
  bool is_embedded() const { return m_embedded; }

  std::size_t number_of_vertices()  const { return m_mesh.number_of_vertices(); }
  std::size_t number_of_edges()     const { return m_mesh.number_of_edges(); }
  std::size_t number_of_halfedges() const { return m_mesh.number_of_halfedges(); }
  std::size_t number_of_faces()     const { return m_mesh.number_of_faces(); }
  /// g, with V - E + F = 2 - 2g - b. Complexity: linear.
  int genus() const;
  /// b. Complexity: linear.
  int number_of_boundary_curves() const { return static_cast<int>(boundary_curves().size()); }
  /// whether there is a boundary. Complexity: linear.
  bool has_boundary() const;
  /// every boundary curve, as the halfedges in faces along it, one after the other. Complexity: linear.
  std::vector<std::vector<Halfedge>> boundary_curves() const;

  Mesh::Vertex_range   vertices()  const { return m_mesh.vertices(); }
  Mesh::Halfedge_range halfedges() const { return m_mesh.halfedges(); }
  Mesh::Edge_range     edges()     const { return m_mesh.edges(); }
  Mesh::Face_range     faces()     const { return m_mesh.faces(); }

  Halfedge next(Halfedge h)     const { return m_mesh.next(h); }
  Halfedge prev(Halfedge h)     const { return m_mesh.prev(h); }
  Halfedge opposite(Halfedge h) const { return m_mesh.opposite(h); }
  Vertex   source(Halfedge h)   const { return m_mesh.source(h); }
  Vertex   target(Halfedge h)   const { return m_mesh.target(h); }
  Face     face(Halfedge h)     const { return m_mesh.face(h); }
  Edge     edge(Halfedge h)     const { return m_mesh.edge(h); }
  /// the first halfedge of an edge, of even index (`Surface_mesh` 5.5 gives back the one the descriptor was made from)
  Halfedge halfedge(Edge e)     const { return Halfedge(2 * e.idx()); }
  Halfedge halfedge(Face f)     const { return m_mesh.halfedge(f); }

  bool is_border(Halfedge h) const { return m_mesh.is_border(h); }
  bool is_border(Edge e)     const { return is_border(halfedge(e)) || is_border(opposite(halfedge(e))); }
  bool is_border(Vertex v)   const { return is_border(m_mesh.halfedge(v)); }
  /// the next and the previous halfedge along a boundary curve. \pre h is in a face, its opposite a border halfedge
  Halfedge next_on_boundary(Halfedge h)     const { return opposite(prev(opposite(h))); }
  Halfedge previous_on_boundary(Halfedge h) const { return opposite(next(opposite(h))); }

  /// a halfedge whose source is v and which is in a face: the first one of the fan of faces if v is on the boundary
  Halfedge halfedge_from(Vertex v) const { return m_mesh.opposite(m_mesh.halfedge(v)); }
  /// the next halfedge from source(h), counterclockwise: it leaves through the face of h. After the last face of a
  /// boundary vertex comes a border halfedge, and then the first of the fan.
  Halfedge next_around_source(Halfedge h) const { return m_mesh.opposite(m_mesh.prev(h)); }
  /// h0, h1, h2 of `Surface_point`
  std::array<Halfedge, 3> halfedges(Face f) const
  { const Halfedge h = m_mesh.halfedge(f), n = m_mesh.next(h); return {h, n, m_mesh.next(n)}; }
  /// 0, 1 or 2: the corner of face(h) at source(h). \pre h is in a face
  int corner(Halfedge h) const;

  double length(Edge e)     const { return m_length[e]; }
  double length(Halfedge h) const { return m_length[m_mesh.edge(h)]; }
  const std::vector<double>& lengths() const { return m_length; }
  /// takes the surface to another metric. \pre the triangle inequalities hold
  void set_lengths(std::vector<double> lengths) { m_length = std::move(lengths); }

  /// the positions of the corners of f, unfolded with source(h0) at 0 and target(h0) on the positive real axis
  std::array<std::complex<double>, 3> unfolded(Face f) const;
  /// the total area of the triangles
  double area() const;

  /// \pre e has two different faces: no boundary edge is ever flipped
  Edge_flip flip_of(Edge e, double new_length, bool ptolemy) const;
  /// replaces the edge ij by kl: afterwards halfedge ij runs from k to l, with (kl, lj, jk) and (lk, ki, il) as faces.
  void flip(const Edge_flip& flip);

  /// The vertex that was inserted into a face, and the halfedges round it.
  struct Insertion
  {
    Vertex                  vertex;
    std::array<Halfedge, 3> rim;    ///< the halfedges v0v1, v1v2, v2v0 of the face that was split (rim[0] = its h0)
    std::array<Halfedge, 3> spoke;  ///< from the new vertex to v0, v1, v2
  };
  /// inserts a vertex in the interior of a face; the surface does not change.
  Insertion insert(const Surface_point& p);

  /// The vertex p that was inserted on a boundary edge v0 v1 of a face (v0, v1, v2), and the halfedges round it.
  struct Boundary_split
  {
    Vertex   vertex;
    Halfedge first, second;   ///< v0 p, in the face that was there (p, v2, v0), and p v1, in the new face (p, v1, v2)
    Halfedge spoke;           ///< p v2, in the face of `first`
  };
  /// inserts a vertex on a boundary edge, at the given fraction of its length from source(h); the surface does not change.
  /// \pre h is in a face, its opposite a border halfedge; 0 < fraction < 1
  Boundary_split split_boundary_edge(Halfedge h, double fraction);
  /// moves a vertex in space (only meaningful for embedded surfaces)
  void set_point(Vertex v, const Point_3& p) { m_mesh.point(v) = p; }

private:
  void hold_borders();

  Mesh                m_mesh;   // a vertex of the boundary holds the border halfedge that ends there
  std::vector<double> m_length;
  bool                m_embedded = false;
};

/// the point at a vertex, in one of the faces round it
inline Surface_point at_vertex(const Intrinsic_triangulation& t, Vertex v)
{
  const Halfedge h = t.halfedge_from(v);
  Surface_point p{t.face(h)};
  p.barycentric[t.corner(h)] = 1;
  return p;
}

/// the point of an edge at a fraction of its length from source(h), in the face of h: its coordinate opposite the edge is
/// exactly 0
inline Surface_point on_edge(const Intrinsic_triangulation& t, Halfedge h, double fraction)
{
  Surface_point p{t.face(h)};
  const int k = t.corner(h);
  p.barycentric[k] = 1 - fraction;
  p.barycentric[(k + 1) % 3] = fraction;
  return p;
}

/// pi, in radians, in a number type
template <class FT>
FT half_turn()
{
  using std::acos;
  return acos(FT(-1));
}

/// four times the area of the triangle with sides a, b, c (Kahan's formula: accurate for needles);
/// 0 where the triangle inequality fails. Complexity: constant.
template <class FT>
FT four_times_area(FT a, FT b, FT c)
{
  using std::sqrt;
  const FT most = (std::max)(a, (std::max)(b, c)), least = (std::min)(a, (std::min)(b, c));
  const FT middle = (std::max)((std::min)(a, b), (std::min)((std::max)(a, b), c));   // sorted without jumps
  const FT x = (most + (middle + least)) * (least - (most - middle)) * (least + (most - middle)) * (most + (middle - least));
  return x > 0 ? FT(sqrt(x)) : FT(0);
}

/// b^2 + c^2 - a^2: twice the scalar product of the sides of lengths b and c of a triangle, a opposite of their corner;
/// without cancellation in needles. Over `four_times_area(a, b, c)` it is the cotangent of the angle. Complexity: constant.
template <class FT>
FT twice_scalar_product(const FT& a, const FT& b, const FT& c)
{
  const FT &shorter = (std::min)(b, c), &longer = (std::max)(b, c);
  return (longer - a) * (longer + a) + shorter * shorter;
}

/// the angle at source(h) in face(h), for every halfedge and the given edge lengths, in their number type. [radians]
/// Right to the last digits in needles too. 0 for border halfedges. Complexity: linear.
/// \pre the lengths satisfy the triangle inequality in every face
template <class FT>
std::vector<FT> corner_angles(const Intrinsic_triangulation& t, const std::vector<FT>& lengths)
{
  using std::atan2;
  std::vector<FT> angle(t.number_of_halfedges(), FT(0));
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    const FT &a = lengths[t.edge(h[0])], &b = lengths[t.edge(h[1])], &c = lengths[t.edge(h[2])];
    const FT area4 = four_times_area(a, b, c);
    angle[h[0]] = atan2(area4, twice_scalar_product(b, c, a));
    angle[h[1]] = atan2(area4, twice_scalar_product(c, a, b));
    angle[h[2]] = atan2(area4, twice_scalar_product(a, b, c));
  }
  return angle;
}

/// K_v = 2*pi, or pi on the boundary, minus the angles round v. [radians]
template <class FT>
std::vector<FT> curvatures(const Intrinsic_triangulation& t, const std::vector<FT>& angles)
{
  const FT pi = half_turn<FT>();
  std::vector<FT> k(t.number_of_vertices(), 2 * pi);
  for (Vertex v : t.vertices())
    if (t.is_border(v)) k[v] = pi;
  for (Halfedge h : t.halfedges())
    if (!t.is_border(h)) k[t.source(h)] -= angles[h];
  return k;
}

/// checks every structural invariant of a Delta-complex that `is_valid_polygon_mesh` cannot (it refuses parallel
/// edges and loops) and returns the first violation as a sentence, or the empty string.
std::string structural_defect(const Intrinsic_triangulation& t);

/// throws Unusable_surface_error if the surface is empty, not connected, or has a degenerate triangle.
void check_surface(const Intrinsic_triangulation& surface);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTRINSIC_TRIANGULATION_H
