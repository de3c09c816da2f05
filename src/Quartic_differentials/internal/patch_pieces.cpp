// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/patch_pieces.h>

#include "grid_lines.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const std::size_t none = static_cast<std::size_t>(-1);

Chart_point at_corner(Face f, Halfedge h) { return {Chart_point::Place::corner, h, 0, 1, f, {}}; }
Chart_point on_edge(Face f, Halfedge h, std::int64_t numerator, std::int64_t denominator)
{
  return {Chart_point::Place::edge, h, numerator, denominator, f, {}};
}

// The part of an arc in a face, with exact ends.
struct Arc_piece
{
  std::size_t  arc;
  int          direction;      // of the arc
  Chart_point  from, to;
  Grid_vector  anchor;         // a grid point on the arc's line ...
  std::int64_t distance;       // ... so far from the start of the arc
};

// Where a patch lies in the chart of a face.
struct Placement
{
  std::size_t patch = none;
  Transition  to_patch;
};

// An arc on the boundary of the patch on its left.
struct Patch_side
{
  std::size_t  patch;
  int          side;
  Grid_vector  start;   // in the patch
};

// By directed arc: 2a is arc a run forward. Of no meaning where an arc of the boundary runs backward.
std::vector<Patch_side> patch_sides(const T_mesh& t)
{
  std::vector<Patch_side> result(2 * t.arcs.size());
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    Grid_vector at;
    for (int side = 0; side < 4; ++side)
      for (const T_mesh::Side_piece& piece : t.patches[p].sides[side]) {
        result[2 * piece.arc + !piece.forward] = {p, side, at};
        at = at + rotated({t.arcs[piece.arc].length, 0}, side);
      }
  }
  return result;
}

// Cuts one face. The arcs end where they meet, so the arc pieces and the intervals of the boundary are the edges of a
// planar graph as they stand; its faces are walked round with the sharpest left turn at every point.
class Face_cutter
{
public:
  Face_cutter(const T_mesh& t, const Quartic_differential& q, const std::vector<Patch_side>& sides)
    : m_t(t), m_charts(q), m_sides(sides) {}

  void cut(Face f, const std::vector<Arc_piece>& arcs, std::vector<Patch_piece>& result)
  {
    m_face = f;
    m_halfedge = m_charts.triangulation().halfedges(f);
    collect_points(arcs);
    m_edges.clear();
    m_leaving.assign(m_points.size(), {});
    add_boundary();
    for (const Arc_piece& piece : arcs) add_arc(piece);
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      if (!m_edges[e].used) result.push_back(walk_round(e));
  }

private:
  struct Directed_edge
  {
    std::size_t from, to;
    Grid_vector along;
    bool        outer;        // on the boundary of the triangle
    bool        used;
    Placement   placement;    // of the piece on the left, if this is part of an arc
  };

  // The points of the boundary in their order from corner 0, then the interior ones; each once.
  void collect_points(const std::vector<Arc_piece>& arcs)
  {
    m_points.clear();
    for (Halfedge h : m_halfedge) m_points.push_back(at_corner(m_face, h));
    for (const Arc_piece& piece : arcs) {
      m_points.push_back(piece.from);
      m_points.push_back(piece.to);
    }
    const auto less = [this](const Chart_point& a, const Chart_point& b) { return before(a, b); };
    std::sort(m_points.begin(), m_points.end(), less);
    m_points.erase(std::unique(m_points.begin(), m_points.end(),
                               [&](const Chart_point& a, const Chart_point& b) { return !less(a, b); }),
                   m_points.end());
  }

  int rank(const Chart_point& p) const
  {
    return p.place == Chart_point::Place::interior ? 3 : m_charts.triangulation().corner(p.halfedge);
  }

  bool before(const Chart_point& a, const Chart_point& b) const
  {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (a.place == Chart_point::Place::interior) return std::make_pair(a.z.x, a.z.y) < std::make_pair(b.z.x, b.z.y);
    return static_cast<__int128>(a.numerator) * b.denominator < static_cast<__int128>(b.numerator) * a.denominator;
  }

  std::size_t index(const Chart_point& p) const
  {
    return std::lower_bound(m_points.begin(), m_points.end(), p,
                            [this](const Chart_point& a, const Chart_point& b) { return before(a, b); })
           - m_points.begin();
  }

  void add_edge(std::size_t from, std::size_t to, Grid_vector along, bool outer, const Placement& placement)
  {
    m_leaving[from].push_back(m_edges.size());
    m_edges.push_back({from, to, along, outer, false, placement});
  }

  void add_boundary()
  {
    const std::size_t n = std::count_if(m_points.begin(), m_points.end(),
                                        [this](const Chart_point& p) { return rank(p) < 3; });
    for (std::size_t k = 0; k < n; ++k) {
      const Halfedge h = m_points[k].halfedge;
      add_edge(k, (k + 1) % n, m_charts.corner(m_charts.triangulation().next(h)) - m_charts.corner(h), true, {});
    }
  }

  void add_arc(const Arc_piece& piece)
  {
    const std::size_t from = index(piece.from), to = index(piece.to);
    for (const bool forward : {true, false}) {
      if (!forward && m_t.arcs[piece.arc].on_boundary) continue;   // there is no surface
      const std::size_t a = forward ? from : to, b = forward ? to : from;
      const Placement placement = placement_beside(piece, forward);
      const auto same = std::find_if(m_leaving[a].begin(), m_leaving[a].end(), [&](std::size_t e) {
        return m_edges[e].outer && m_edges[e].to == b && across(piece.direction, m_edges[e].along) == 0;
      });
      if (same != m_leaving[a].end()) m_edges[*same].placement = placement;
      else if (!is_outer(a, b, piece.direction))
        add_edge(a, b, rotated({1, 0}, piece.direction + (forward ? 0 : 2)), false, placement);
    }
  }

  // whether the triangle's boundary runs along the arc piece from b to a
  bool is_outer(std::size_t a, std::size_t b, int direction) const
  {
    return std::any_of(m_leaving[b].begin(), m_leaving[b].end(), [&](std::size_t e) {
      return m_edges[e].outer && m_edges[e].to == a && across(direction, m_edges[e].along) == 0;
    });
  }

  // The directed arc runs along a side of the patch on its left: the charts differ by the turn between the two, and by
  // what takes the anchor to its place on the side.
  Placement placement_beside(const Arc_piece& piece, bool forward) const
  {
    const Patch_side& s = m_sides[2 * piece.arc + !forward];
    const std::int64_t run = forward ? piece.distance : m_t.arcs[piece.arc].length - piece.distance;
    const int rotation = (s.side - piece.direction - (forward ? 0 : 2)) & 3;
    return {s.patch, {rotation, s.start + rotated({run, 0}, s.side) - rotated(piece.anchor, rotation)}};
  }

  Patch_piece walk_round(std::size_t first)
  {
    Patch_piece piece{m_face, none, {}, {}};
    std::size_t e = first;
    do {
      Directed_edge& edge = m_edges[e];
      edge.used = true;
      piece.corner.push_back(m_points[edge.from]);
      const Placement& p = edge.placement;
      if (p.patch != none) {
        if (piece.patch != none && !(piece.patch == p.patch && piece.to_patch.rotation == p.to_patch.rotation
                                     && piece.to_patch.translation == p.to_patch.translation))
          throw Numerical_error("two arcs in face " + std::to_string(m_face.idx()) + " place a patch differently");
        piece.patch = p.patch;
        piece.to_patch = p.to_patch;
      }
      e = sharpest_left(edge);
    } while (e != first);
    return piece;
  }

  std::size_t sharpest_left(const Directed_edge& edge) const
  {
    std::size_t best = none;
    for (std::size_t e : m_leaving[edge.to]) {
      if (cross(edge.along, m_edges[e].along) < 0 || is_way_back(edge, m_edges[e])) continue;   // pieces are convex
      if (best == none || cross(m_edges[best].along, m_edges[e].along) > 0) best = e;
    }
    if (best == none) throw Numerical_error("the arcs in face " + std::to_string(m_face.idx()) + " leave a gap");
    return best;
  }

  static bool is_way_back(const Directed_edge& a, const Directed_edge& b)
  {
    return cross(a.along, b.along) == 0
        && static_cast<__int128>(a.along.x) * b.along.x + static_cast<__int128>(a.along.y) * b.along.y < 0;
  }

  static __int128 cross(Grid_vector a, Grid_vector b)
  {
    return static_cast<__int128>(a.x) * b.y - static_cast<__int128>(a.y) * b.x;
  }

  const T_mesh&                         m_t;
  const Doubled_charts                  m_charts;
  const std::vector<Patch_side>&        m_sides;
  Face                                  m_face;
  std::array<Halfedge, 3>               m_halfedge;
  std::vector<Chart_point>              m_points;
  std::vector<Directed_edge>            m_edges;
  std::vector<std::vector<std::size_t>> m_leaving;   // by point
};

// By face: the parts of arcs in it and on its boundary.
std::vector<std::vector<Arc_piece>> arc_pieces(const T_mesh& t, const Quartic_differential& q)
{
  const Doubled_charts charts(q);
  const Intrinsic_triangulation& mesh = q.triangulation;
  std::vector<std::vector<Arc_piece>> result(mesh.number_of_faces());
  for (std::size_t a = 0; a < t.arcs.size(); ++a) {
    std::int64_t distance = 0;
    const std::vector<Chart_segment>& path = t.arcs[a].path;
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Chart_segment& s = path[k];
      const Chart_segment back{s.face, s.direction ^ 2, s.to, s.from};
      result[s.face].push_back({a, s.direction, k == 0 ? chart_point(q, s.face, s.from) : exit_of(q, back),
                                k + 1 == path.size() ? chart_point(q, s.face, s.to) : exit_of(q, s), s.from, distance});
      const Ray ray = ray_through(s.from, s.direction, 0);
      for (Halfedge h : mesh.halfedges(s.face)) {
        if (mesh.is_border(mesh.opposite(h))) continue;
        if (ray.side(charts.corner(h)) != 0 || ray.side(charts.corner(mesh.next(h))) != 0) continue;
        // along an edge: all ends are grid points, and the face on the other side needs them as well
        const Transition across_h = charts.transition(h);
        const Face g = mesh.face(mesh.opposite(h));
        result[g].push_back({a, (s.direction + across_h.rotation) & 3, chart_point(q, g, across_h(s.from)),
                             chart_point(q, g, across_h(s.to)), across_h(s.from), distance});
      }
      distance += along(s.direction, s.to - s.from);
    }
  }
  return result;
}

// Faces without arcs lie in the patch of any neighbour.
void spread_to_whole_faces(const Quartic_differential& q, std::vector<Patch_piece>& pieces)
{
  const Doubled_charts charts(q);
  const Intrinsic_triangulation& mesh = q.triangulation;
  std::vector<char> reached(mesh.number_of_faces(), false);
  for (const Patch_piece& p : pieces) reached[p.face] = true;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::size_t n = pieces[k].corner.size();
    for (std::size_t c = 0; c < n; ++c) {
      const Chart_point &from = pieces[k].corner[c], &to = pieces[k].corner[(c + 1) % n];
      const Halfedge h = from.halfedge;
      if (from.place != Chart_point::Place::corner || to.place != Chart_point::Place::corner) continue;
      if (to.halfedge != mesh.next(h)) continue;
      const Halfedge o = mesh.opposite(h);
      const Face g = mesh.face(o);
      if (mesh.is_border(o) || reached[g]) continue;
      reached[g] = true;
      Patch_piece whole{g, pieces[k].patch, charts.transition(o).then(pieces[k].to_patch), {}};
      for (Halfedge corner : mesh.halfedges(g)) whole.corner.push_back(at_corner(g, corner));
      pieces.push_back(std::move(whole));
    }
  }
}

} // namespace

std::vector<Patch_piece> patch_pieces(const T_mesh& t, const Quartic_differential& q)
{
  const std::vector<Patch_side> sides = patch_sides(t);
  const std::vector<std::vector<Arc_piece>> arcs = arc_pieces(t, q);
  std::vector<Patch_piece> result;
  Face_cutter cutter(t, q, sides);
  for (Face f : q.triangulation.faces())
    if (!arcs[f].empty()) cutter.cut(f, arcs[f], result);
  spread_to_whole_faces(q, result);
  return result;
}

Chart_point chart_point(const Quartic_differential& q, Face f, Grid_vector z)
{
  const Doubled_charts charts(q);
  const auto halfedges = q.triangulation.halfedges(f);
  for (Halfedge h : halfedges)
    if (charts.corner(h) == z) return at_corner(f, h);
  for (Halfedge h : halfedges) {
    const Grid_vector a = charts.corner(h), b = charts.corner(q.triangulation.next(h)), edge = b - a;
    if (doubled_area(a, b, z) != 0) continue;
    const bool flat = std::abs(edge.x) >= std::abs(edge.y);
    return on_edge(f, h, std::abs(flat ? z.x - a.x : z.y - a.y), std::abs(flat ? edge.x : edge.y));
  }
  return {Chart_point::Place::interior, Mesh::null_halfedge(), 0, 1, f, z};
}

Chart_point exit_of(const Quartic_differential& q, const Chart_segment& s)
{
  const Doubled_charts charts(q);
  const Ray ray = ray_through(s.from, s.direction, 0);
  Halfedge last = Mesh::null_halfedge();   // the farthest corner on the line
  for (Halfedge h : q.triangulation.halfedges(s.face)) {
    const Grid_vector a = charts.corner(h);
    const std::int64_t s_a = ray.side(a), s_b = ray.side(charts.corner(q.triangulation.next(h)));
    if (s_a < 0 && s_b > 0) return on_edge(s.face, h, -s_a, s_b - s_a);
    if (s_a == 0 && (last == Mesh::null_halfedge() || ray.time(a) > ray.time(charts.corner(last)))) last = h;
  }
  return at_corner(s.face, last);
}

std::int64_t numerator_along_edge(const Quartic_differential& q, const Chart_point& p)
{
  const Intrinsic_triangulation& mesh = q.triangulation;
  return p.halfedge == mesh.halfedge(mesh.edge(p.halfedge)) ? p.numerator : p.denominator - p.numerator;
}

Point_3 position(const Quartic_differential& q, const Chart_point& p)
{
  const Intrinsic_triangulation& mesh = q.triangulation;
  const auto vertex = [&](Halfedge h) { return mesh.mesh().point(mesh.source(h)); };
  if (p.place == Chart_point::Place::corner) return vertex(p.halfedge);
  double x = 0, y = 0, z = 0;
  const auto add = [&](double weight, const Point_3& v) { x += weight * v.x(); y += weight * v.y(); z += weight * v.z(); };
  if (p.place == Chart_point::Place::edge) {
    const double t = static_cast<double>(numerator_along_edge(q, p)) / static_cast<double>(p.denominator);
    const Halfedge h = mesh.halfedge(mesh.edge(p.halfedge));
    add(1 - t, vertex(h));
    add(t, vertex(mesh.opposite(h)));
  } else {
    const Doubled_charts charts(q);
    const auto [h0, h1, h2] = mesh.halfedges(p.face);
    const Grid_vector a = charts.corner(h0), b = charts.corner(h1), c = charts.corner(h2);
    const double whole = static_cast<double>(doubled_area(a, b, c));
    add(static_cast<double>(doubled_area(b, c, p.z)) / whole, vertex(h0));
    add(static_cast<double>(doubled_area(c, a, p.z)) / whole, vertex(h1));
    add(static_cast<double>(doubled_area(a, b, p.z)) / whole, vertex(h2));
  }
  return Point_3(x, y, z);
}

} // namespace internal
} } // namespace CGAL::Quartic_differentials
