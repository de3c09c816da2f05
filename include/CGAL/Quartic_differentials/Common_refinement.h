// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_COMMON_REFINEMENT_H
#define CGAL_QUARTIC_DIFFERENTIALS_COMMON_REFINEMENT_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 7, "Common refinement")
//   A         the input triangulation, which stays as it is
//   C         the current triangulation on the same vertices: A, flipped
//   P         where an A edge m -> n crosses a C edge v -> w, in homogeneous coordinates:
//             P = p[0] v + p[1] w = sigma[0] m + sigma[1] n, all four weights positive
//   q         the weights of a flip of ij to kl: q_i v_i + q_j v_j = q_k v_k + q_l v_l

/// the first of the two halfedges of an edge, by which edges are directed here.
/// (`Surface_mesh` returns either: the one from which the descriptor was made.)
inline Halfedge first_halfedge(Edge e) { return Halfedge(2 * e.idx()); }
inline bool is_first_of_its_edge(Halfedge h) { return h.idx() % 2 == 0; }

/// The address of a crossing: the `rank`-th on a C edge, counted along first_halfedge(edge); or no crossing at all.
/// It stays the same until that edge is flipped.
struct Crossing_id
{
  Edge            edge;
  Mesh::size_type rank = 0;

  bool is_none() const { return !edge.is_valid(); }
  friend bool operator==(Crossing_id x, Crossing_id y)
  { return x.is_none() ? y.is_none() : x.edge == y.edge && x.rank == y.rank; }
  friend bool operator!=(Crossing_id x, Crossing_id y) { return !(x == y); }
};

/// Where an edge of A crosses an edge of C.
struct Crossing
{
  Edge                  a;          ///< the A edge, directed like its first halfedge
  Halfedge              ahead;      ///< the C halfedge into whose face the A edge goes on
  Crossing_id           prev, next; ///< along the A edge; none where it comes from, or goes to, a vertex
  std::array<double, 2> p;          ///< weights of the ends of the C edge, directed like its first halfedge
  std::array<double, 2> sigma;      ///< weights of the ends of the A edge

  /// position along the A edge, between 0 and 1, in the metric of the flips (see `Common_refinement::rescale()`)
  double position_on_a() const { return sigma[1] / (sigma[0] + sigma[1]); }
  /// position along the C edge, between 0 and 1, in the metric of the flips (see `Common_refinement::rescale()`)
  double position_on_c() const { return p[1] / (p[0] + p[1]); }
};

/// The common refinement of a fixed triangulation A with a triangulation C that starts as A and is flipped: for every
/// edge of C the ordered crossings with the edges of A.
///
/// It rides along: pass it to `make_delaunay`. Every vertex of the refinement is a vertex of A or one crossing, every
/// cell is a convex polygon in one face of A and in one face of C; this is combinatorial and does not depend on how
/// well the weights are rounded. Euclidean and Ptolemy flips differ in their weights only.
///
/// Not promised: that the rounded positions of crossings on an edge are strictly monotone.
/// Source: METHOD, step 7. Complexity: linear in the number of crossings on and next to the flipped edge, times the
/// logarithm of the number of new ones.
class Common_refinement
{
public:
  Common_refinement() = default;
  /// the refinement of a triangulation with itself
  explicit Common_refinement(Intrinsic_triangulation a);

  /// \pre `c` is the triangulation that all flips so far have led to
  void before_flip(const Intrinsic_triangulation& c, const Edge_flip& flip);

  /// how many crossings the edge will have after a flip. Complexity: as for the flip.
  std::size_t crossings_after(const Edge_flip& flip) const;

  /// goes over to lengths exp((u_i + u_j) / 2) l_ij: positions along the edges, those of A too, and flips are in this
  /// metric then.
  /// \pre `c` is the triangulation that all flips so far have led to
  void rescale(const Intrinsic_triangulation& c, const std::vector<double>& u);

  const Intrinsic_triangulation& input() const { return m_a; }
  /// moves a vertex of A in space
  void set_point(Vertex v, const Point_3& p) { m_a.set_point(v, p); }

  /// the crossings on a C edge, in order along first_halfedge(c)
  const std::vector<Crossing>& crossings(Edge c) const { return m_crossings[c]; }
  const Crossing& operator[](Crossing_id id) const { return m_crossings[id.edge][id.rank]; }
  std::size_t number_of_crossings() const;

  /// the first crossing along an A edge, none if the edge is also one of C
  Crossing_id first_crossing(Edge a) const { return m_first[a]; }
  /// the A halfedge with which a C halfedge coincides, or the null halfedge
  Halfedge coincident(Halfedge c) const;

  /// Where an A edge goes inside a face of C.
  struct Step
  {
    Crossing_id to;       ///< none: to the corner of the face opposite to where it came in
    Halfedge    at;       ///< the halfedge of the C face on which `to` lies; null at a corner
    bool        forward;  ///< whether this is along the direction of the A edge
  };
  /// follows the A edge through a crossing `x` on `c` into face(c).
  Step step(const Crossing& x, Halfedge c) const;

  /// checks every link against the connectivity of `c`, and by the order along the edges that A edges do not cross each
  /// other; returns the first violation as a sentence, or "". Complexity: linear in edges and crossings.
  std::string defect(const Intrinsic_triangulation& c) const;

private:
  class Quadrilateral;
  struct Arc;

  Crossing& at(Crossing_id id) { return m_crossings[id.edge][id.rank]; }
  void link(Edge a, Crossing_id from, Crossing_id to);

  Intrinsic_triangulation            m_a;
  std::vector<std::vector<Crossing>> m_crossings;   // by C edge
  std::vector<Halfedge>              m_coincident;  // by C edge: the A halfedge along the first halfedge, or null
  std::vector<Crossing_id>           m_first;       // by A edge
};

/// the position in space of a point of a surface.
/// \throws Unusable_surface_error if `t` is not embedded
Point_3 position_on_input(const Intrinsic_triangulation& t, const Surface_point& p);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_COMMON_REFINEMENT_H
