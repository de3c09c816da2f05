// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "internal/faces_that_may_meet.h"

#include <CGAL/Quartic_differentials/handle_tunnel_basis.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Lattice_basis.h>
#include <CGAL/Quartic_differentials/internal/integer_matrix.h>
#include <CGAL/Quartic_differentials/internal/linking_number.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Big_integer_matrix;
using internal::Integer;
using internal::narrowed;
using internal::widened;

// ---- the surface in space

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// the vertices as points of a kernel with exact predicates
struct Exact_positions
{
  using key_type   = Vertex;
  using value_type = Kernel::Point_3;
  using reference  = Kernel::Point_3;
  using category   = boost::readable_property_map_tag;
  const Mesh* mesh;
  friend Kernel::Point_3 get(const Exact_positions& m, Vertex v)
  {
    const Point_3& p = m.mesh->point(v);
    return Kernel::Point_3(p.x(), p.y(), p.z());
  }
};

auto exactly(const Mesh& mesh)
{
  return CGAL::parameters::vertex_point_map(Exact_positions{&mesh}).geom_traits(Kernel());
}

// where the surface meets itself, or nothing. Only the few faces are tested of which that is not plain to see.
std::string self_intersection(const Intrinsic_triangulation& t)
{
  const std::vector<Face> faces = internal::faces_that_may_meet(t);
  std::optional<std::pair<Face, Face>> pair;
  const auto keep = boost::make_function_output_iterator([&](const std::pair<Face, Face>& p) { pair = p; });
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(faces, t.mesh(), keep,
                                                                          exactly(t.mesh()).maximum_number(1));
  if (!pair) return "";
  return "the surface meets itself, for example in the triangles " + std::to_string(pair->first.idx()) + " and "
       + std::to_string(pair->second.idx()) + ": it has no exact inside and outside";
}

// ---- linking numbers

// A vector with an integer for every loop at each of a few edges or halfedges, by index; 0 elsewhere.
class Sparse_rows
{
public:
  explicit Sparse_rows(int size) : m_zero(Eigen::RowVectorXi::Zero(size)) {}
  const Eigen::RowVectorXi& operator[](std::size_t i) const
  {
    const auto found = m_row.find(i);
    return found == m_row.end() ? m_zero : found->second;
  }
  void add(std::size_t i, int k, int n) { m_row.try_emplace(i, m_zero).first->second[k] += n; }
  /// where the vector is not 0, in increasing order
  std::vector<std::size_t> support() const
  {
    std::vector<std::size_t> indices;
    for (const auto& [i, row] : m_row)
      if (!row.isZero()) indices.push_back(i);
    return indices;
  }

private:
  std::map<std::size_t, Eigen::RowVectorXi> m_row;
  Eigen::RowVectorXi                        m_zero;
};

// The loops gamma_k twice, as sums of segments on the surface: x_k along edges, y_k across faces.
struct Curves
{
  Sparse_rows along;    // by edge: how often x_k runs along its first halfedge
  Sparse_rows across;   // by edge: eta_k, how often y_k leaves through its first halfedge, at its midpoint
  Sparse_rows turns;    // by halfedge: how often y_k goes from its midpoint straight to the next one's
};

Curves curves(const Intrinsic_triangulation& t, const std::vector<std::vector<Halfedge>>& loops)
{
  const int n = static_cast<int>(loops.size());
  const auto add = [](Sparse_rows& by_edge, Halfedge h, int k, int count) {
    by_edge.add(h.idx() / 2, k, h.idx() % 2 == 0 ? count : -count);
  };
  Curves c{Sparse_rows(n), Sparse_rows(n), Sparse_rows(n)};
  for (int k = 0; k < n; ++k)
    for (std::size_t i = 0; i < loops[k].size(); ++i) {
      const Halfedge in = t.opposite(loops[k][i]), out = loops[k][(i + 1) % loops[k].size()];
      add(c.across, out, k, 1);
      if (out == t.next(in)) {   // turning right round target(in), the left side goes backwards along prev(in)
        add(c.along, t.prev(in), k, -1);
        c.turns.add(in.idx(), k, 1);
      } else {
        c.turns.add(out.idx(), k, -1);
      }
    }
  return c;
}

// The linking numbers of x_k with y_l pushed off by an infinitely small distance along the normals, read off a
// projection of the curves, which are segments with exact end points on the surface itself.
//
// Linking numbers are the sums of the signs of the crossings in which y_l passes over x_k. Where the two curves are
// apart in space, pushing y_l does not change the crossing. They meet only where y_l leaves a face f through an edge h
// of x_k. There the projections of both faces of h are injective (this is checked), and
//   if both faces are seen from outside, y+ passes over h, from its left to its right: sign +1; y- passes under it;
//   if both are seen from inside, y- passes over h and, seen in the mirror, from its right to its left: sign -1;
//   if h is a fold of the projection, both faces lie on the same side of its image. At a convex edge y- stays between
//     the faces and does not cross the image; y+ goes round the edge and crosses it twice, once above: where the face
//     that is seen from outside is the upper one, in the direction in which that face is left or entered: sign +1.
//     At a concave edge it is the other way round, and y- passes over h with sign -1.
// So every meeting contributes to exactly one of V+ and V-, and the difference is V+ - V- = -J in every projection.
class Linking_form
{
public:
  Linking_form(const Intrinsic_triangulation& t, const std::vector<std::vector<Halfedge>>& loops)
    : m_t(t), m_size(static_cast<int>(loops.size())), m_curves(curves(t, loops))
  {
    for (std::size_t e : m_curves.along.support()) m_edges.push_back(t.halfedge(Edge(static_cast<Mesh::size_type>(e))));
    for (std::size_t h : m_curves.turns.support()) m_turns.push_back(Halfedge(static_cast<Mesh::size_type>(h)));
    for (Halfedge h : m_edges) m_lower.push_back({point(t.source(h)), point(t.target(h))});
    for (Halfedge h : m_turns) m_upper.push_back({midpoint(h), midpoint(t.next(h))});
  }

  // V+ and V-, or nothing if the projection is degenerate
  std::optional<Linking_matrices> read_off(const internal::Projection& projection) const
  {
    for (Halfedge h : m_turns)
      if (facing(h, projection) == CGAL::ZERO) return std::nullopt;
    // a face projects injectively: a segment in it crosses none of its edges elsewhere than on the surface
    const auto in_one_face = [&](std::size_t i, std::size_t k) {
      const Face f = m_t.face(m_turns[k]);
      return m_t.face(m_edges[i]) == f || m_t.face(m_t.opposite(m_edges[i])) == f;
    };
    const auto crossings = internal::crossings_over(m_lower, m_upper, projection, in_one_face);
    if (!crossings) return std::nullopt;
    Eigen::MatrixXi apart = Eigen::MatrixXi::Zero(m_size, m_size);
    for (const internal::Crossing& c : *crossings)
      apart += c.sign * along(m_edges[c.lower]).transpose() * m_curves.turns[m_turns[c.upper].idx()];
    Linking_matrices v{apart, apart};
    for (Halfedge h : m_edges) {
      const Eigen::RowVectorXi& across = m_curves.across[h.idx() / 2];
      if (across.isZero()) continue;
      const Eigen::MatrixXi meetings = along(h).transpose() * across;
      if (outer_push_passes_over(h, projection)) v.plus += meetings;
      else                                       v.minus -= meetings;
    }
    return v;
  }

private:
  // on the first halfedge of an edge
  const Eigen::RowVectorXi& along(Halfedge h) const { return m_curves.along[h.idx() / 2]; }

  internal::Exact_point_3 point(Vertex v) const
  {
    const Point_3& p = m_t.mesh().point(v);
    return internal::Exact_point_3(p.x(), p.y(), p.z());
  }
  internal::Exact_point_3 midpoint(Halfedge h) const
  {
    return CGAL::midpoint(point(m_t.source(h)), point(m_t.target(h)));
  }

  // +1 where the face of h is seen from its outer side
  CGAL::Sign facing(Halfedge h, const internal::Projection& projection) const
  {
    return CGAL::orientation(projection(point(m_t.source(h))), projection(point(m_t.target(h))),
                             projection(point(m_t.target(m_t.next(h)))));
  }

  bool is_convex(Halfedge h) const
  {
    const auto apex = [&](Halfedge k) { return point(m_t.target(m_t.next(k))); };
    return CGAL::orientation(point(m_t.source(h)), point(m_t.target(h)), apex(h), apex(m_t.opposite(h)))
        == CGAL::NEGATIVE;
  }

  bool outer_push_passes_over(Halfedge h, const internal::Projection& projection) const
  {
    const CGAL::Sign left = facing(h, projection), right = facing(m_t.opposite(h), projection);
    return left == right ? left == CGAL::POSITIVE : is_convex(h);
  }

  const Intrinsic_triangulation&       m_t;
  int                                  m_size;              // the number of loops
  Curves                               m_curves;
  std::vector<Halfedge>                m_edges, m_turns;    // m_edges are first halfedges
  std::vector<internal::Exact_segment> m_lower, m_upper;
};

// ---- the classes

// a basis of the same lattice with small coefficients, by rows
Big_integer_matrix reduced(const Big_integer_matrix& basis)
{
  const Eigen::MatrixXd rows = basis.unaryExpr([](const Integer& x) { return static_cast<double>(x); });
  const internal::Lattice_basis lattice(rows * rows.transpose());
  return lattice.basis().unaryExpr([](std::int64_t x) { return Integer(x); }).transpose() * basis;
}

// The rows a_1 .. a_g, b_1 .. b_g with respect to a canonical basis, or nothing if V+ and V- are no linking numbers of
// an embedded surface. For normals that point outwards:
//
// Every class is a sum h + t of a handle and a tunnel class. A handle class bounds inside, where nothing that was
// pushed off to the outside links it, and a tunnel class links nothing inside: h V+ = 0 = t V-. Hence (h + t) V+ = t V+
// = t (V+ - V-) = -t J: the projections to tunnel and handle classes are the integer matrices -V+ J^-1 and V- J^-1.
// That they are complementary projections of rank g and that M = T J H^T is unimodular is checked.
std::optional<Big_integer_matrix> dual_classes(const Big_integer_matrix& v_plus, const Big_integer_matrix& v_minus,
                                               bool outward)
{
  const int n = static_cast<int>(v_plus.rows()), g = n / 2;
  const Big_integer_matrix j = widened(symplectic_unit(g));
  Big_integer_matrix to_tunnels = v_plus * j, to_handles = -(v_minus * j);   // J^-1 = -J
  if (!outward) to_tunnels.swap(to_handles);
  if (Big_integer_matrix(v_plus - v_minus) != Big_integer_matrix(-j)) return std::nullopt;
  if (Big_integer_matrix(v_plus.transpose()) != v_minus) return std::nullopt;
  if (Big_integer_matrix(to_tunnels * to_tunnels) != to_tunnels) return std::nullopt;
  const Big_integer_matrix t = internal::row_lattice(to_tunnels);
  Big_integer_matrix h = internal::row_lattice(to_handles);
  if (t.rows() != g || h.rows() != g) return std::nullopt;
  if (g > 0) h = reduced(h);
  const auto inverse = internal::unimodular_inverse(t * j * h.transpose());   // M^-1
  if (!inverse) return std::nullopt;
  Big_integer_matrix classes(n, n);
  classes << *inverse * t, h;
  return classes;
}

} // namespace

Linking_matrices linking_matrices(const Intrinsic_triangulation& t, const std::vector<std::vector<Halfedge>>& loops)
{
  internal::require_embedded(t, "a linking number");
  const Linking_form form(t, loops);
  for (int k = 0; k < internal::Projection::number; ++k)
    if (const auto v = form.read_off(internal::Projection(k))) return *v;
  return {};
}

Handle_tunnel_basis handle_tunnel_basis(const Intrinsic_triangulation& t, const Homology_basis& basis)
{
  Handle_tunnel_basis result{basis, false, false, ""};
  if (!t.is_embedded()) {
    result.reason = "the surface is known by its edge lengths alone: it has no inside and no outside";
    return result;
  }
  const Linking_matrices v = linking_matrices(t, basis.loops);
  if (v.plus.rows() != static_cast<int>(basis.loops.size())) {
    result.reason = "the loops touch themselves in every projection that was tried: triangles may be degenerate";
    return result;
  }
  const Big_integer_matrix c = widened(basis.combination);
  const bool outward = CGAL::Polygon_mesh_processing::is_outward_oriented(t.mesh(), exactly(t.mesh()));
  const auto classes = dual_classes(c * widened(v.plus) * c.transpose(), c * widened(v.minus) * c.transpose(), outward);
  if (!classes) {
    result.reason = "the linking numbers of the loops are not those of a surface without self-intersections";
    return result;
  }
  result.basis.combination = narrowed(*classes * c);
  const Big_integer_matrix j = *classes * widened(basis.intersection_matrix) * classes->transpose();
  result.basis.intersection_matrix = narrowed(j);
  if (result.basis.intersection_matrix != symplectic_unit(t.genus()))
    throw Numerical_error("the intersection form of the handle and tunnel classes is not the symplectic unit");
  result.basis.cochains = cochains_of_loops(result.basis, t.number_of_edges());
  result.found = true;
  result.reason = self_intersection(t);
  result.certified = result.reason.empty();
  return result;
}

} } // namespace CGAL::Quartic_differentials
