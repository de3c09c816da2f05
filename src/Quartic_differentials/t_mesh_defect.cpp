// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/t_mesh.h>

#include "internal/grid_lines.h"

#include <cstdlib>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::along;
using internal::across;
using internal::Doubled_charts;

std::string node_name(std::size_t n)  { return "node " + std::to_string(n); }
std::string arc_name(std::size_t a)   { return "arc " + std::to_string(a); }
std::string patch_name(std::size_t p) { return "patch " + std::to_string(p); }

// whether two places in charts are one point of the surface, in one face or seen across an edge or at a vertex
bool same_point(const Doubled_charts& charts, Face f, Grid_vector z, Face g, Grid_vector w)
{
  if (f == g && z == w) return true;
  const Intrinsic_triangulation& t = charts.triangulation();
  for (Halfedge h : t.halfedges(f)) {
    if (t.face(t.opposite(h)) == g && charts.transition(h)(z) == w) return true;
    if (charts.corner(h) != z) continue;
    for (Halfedge k : t.halfedges(g))
      if (t.source(k) == t.source(h) && charts.corner(k) == w) return true;
  }
  return false;
}

std::string defect_of_nodes(const T_mesh& t, const Quartic_differential& q)
{
  std::vector<char> listed(q.triangulation.number_of_vertices(), false);
  for (Vertex v : q.singularities) listed[v] = true;
  std::size_t singularities = 0;
  for (std::size_t n = 0; n < t.nodes.size(); ++n) {
    const T_mesh::Node& node = t.nodes[n];
    if (node.face.idx() >= q.triangulation.number_of_faces()) return node_name(n) + " is in no face";
    if (!Doubled_charts(q).face_holds(node.face, node.point)) return node_name(n) + " is not in its face";
    if (!node.is_singularity()) {
      if (node.order != 0) return node_name(n) + " is no singularity but has an order";
      continue;
    }
    if (node.vertex.idx() >= listed.size() || !listed[node.vertex])
      return node_name(n) + " is at no singularity, or at one that another node has";
    if (node.order != q.order[node.vertex]) return node_name(n) + " does not have the order of its singularity";
    if ((node.kind == T_mesh::Node_kind::corner) != q.triangulation.is_border(node.vertex))
      return node_name(n) + " is a corner inside the surface, or no corner on the boundary";
    listed[node.vertex] = false;
    ++singularities;
  }
  return singularities == q.singularities.size() ? "" : "there is a singularity without a node";
}

// whether a segment runs along a boundary edge, with the surface on its left
bool is_on_boundary(const Doubled_charts& charts, const Chart_segment& s)
{
  const Intrinsic_triangulation& t = charts.triangulation();
  for (Halfedge h : t.halfedges(s.face)) {
    if (!t.is_border(t.opposite(h))) continue;
    const Grid_vector begin = charts.corner(h), end = charts.corner(t.next(h));
    if (across(s.direction, s.from - begin) == 0 && across(s.direction, end - begin) == 0
        && along(s.direction, s.from - begin) >= 0 && along(s.direction, end - s.to) >= 0)
      return true;
  }
  return false;
}

std::string defect_of_path(const T_mesh& t, const Doubled_charts& charts, const T_mesh::Arc& arc)
{
  if (arc.path.empty()) return "has no path";
  std::int64_t length = 0;
  for (std::size_t k = 0; k < arc.path.size(); ++k) {
    const Chart_segment& s = arc.path[k];
    if (s.face.idx() >= charts.triangulation().number_of_faces()) return "runs through no face";
    const std::int64_t run = along(s.direction, s.to - s.from);
    if (run < 0 || across(s.direction, s.to - s.from) != 0) return "does not run along its direction";
    length += run;
    if (arc.on_boundary && !is_on_boundary(charts, s)) return "leaves the boundary";
    if (k > 0 && !same_point(charts, arc.path[k - 1].face, arc.path[k - 1].to, s.face, s.from)) return "has a gap";
  }
  if (length != arc.length) return "does not have the length of its path";
  const T_mesh::Node &from = t.nodes[arc.from], &to = t.nodes[arc.to];
  if (!same_point(charts, from.face, from.point, arc.path.front().face, arc.path.front().from))
    return "does not start at its node";
  if (!same_point(charts, to.face, to.point, arc.path.back().face, arc.path.back().to))
    return "does not end at its node";
  return {};
}

std::string defect_of_arcs(const T_mesh& t, const Quartic_differential& q)
{
  const Doubled_charts charts(q);
  for (std::size_t a = 0; a < t.arcs.size(); ++a) {
    const T_mesh::Arc& arc = t.arcs[a];
    if (arc.from >= t.nodes.size() || arc.to >= t.nodes.size()) return arc_name(a) + " ends at no node";
    if (arc.length <= 0) return arc_name(a) + " has no positive length";
    const std::string violation = defect_of_path(t, charts, arc);
    if (!violation.empty()) return arc_name(a) + " " + violation;
  }
  return {};
}

std::string defect_of_patch(const T_mesh& t, const T_mesh::Patch& patch)
{
  std::size_t at = 0;   // the node where the walk round the patch is
  for (int pass = 0; pass < 2; ++pass)       // the first time round finds the node where side 0 starts
    for (int k = 0; k < 4; ++k) {
      std::int64_t length = 0;
      if (patch.sides[k].empty()) return "has an empty side";
      for (const T_mesh::Side_piece& piece : patch.sides[k]) {
        if (piece.arc >= t.arcs.size()) return "uses an arc that does not exist";
        const T_mesh::Arc& arc = t.arcs[piece.arc];
        if (pass == 1 && at != (piece.forward ? arc.from : arc.to)) return "has a gap in its boundary";
        at = piece.forward ? arc.to : arc.from;
        length += arc.length;
      }
      if (length != (k % 2 == 0 ? patch.width : patch.height)) return "is not a rectangle";
    }
  return {};
}

std::string defect_of_patches(const T_mesh& t)
{
  std::vector<std::array<int, 2>> used(t.arcs.size(), {0, 0});
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    const std::string violation = defect_of_patch(t, t.patches[p]);
    if (!violation.empty()) return patch_name(p) + " " + violation;
    for (const auto& side : t.patches[p].sides)
      for (const T_mesh::Side_piece& piece : side) ++used[piece.arc][piece.forward];
  }
  for (std::size_t a = 0; a < used.size(); ++a)
    if (used[a][0] != (t.arcs[a].on_boundary ? 0 : 1) || used[a][1] != 1)
      return arc_name(a) + " is not used once in each direction, or once forward on the boundary";
  return {};
}

// arms and patch corners at a node of this kind
std::array<int, 2> expected_at(const T_mesh::Node& node)
{
  switch (node.kind) {
    case T_mesh::Node_kind::singularity: return {node.order + 4, node.order + 4};
    case T_mesh::Node_kind::corner:      return {node.order + 3, node.order + 2};
    case T_mesh::Node_kind::meeting:     return {2, 0};
    case T_mesh::Node_kind::t_junction:  return {3, 2};
    default:                             return {4, 4};
  }
}

std::string defect_at_nodes(const T_mesh& t)
{
  std::vector<std::array<int, 2>> found(t.nodes.size(), {0, 0});
  for (const T_mesh::Arc& arc : t.arcs) {
    ++found[arc.from][0];
    ++found[arc.to][0];
  }
  for (const T_mesh::Patch& patch : t.patches)
    for (const auto& side : patch.sides) {
      const T_mesh::Arc& arc = t.arcs[side.front().arc];
      ++found[side.front().forward ? arc.from : arc.to][1];
    }
  for (std::size_t n = 0; n < t.nodes.size(); ++n)
    if (found[n] != expected_at(t.nodes[n]))
      return node_name(n) + " has " + std::to_string(found[n][0]) + " arms and " + std::to_string(found[n][1])
           + " patch corners, which are not those of its kind";
  return {};
}

// the length of the whole boundary, doubled. \pre boundary edges are parallel to axes
std::int64_t boundary_length(const Quartic_differential& q)
{
  const Doubled_charts charts(q);
  std::int64_t length = 0;
  for (const std::vector<Halfedge>& curve : q.triangulation.boundary_curves())
    for (Halfedge h : curve) {
      const Grid_vector edge = charts.corner(q.triangulation.next(h)) - charts.corner(h);
      length += std::abs(edge.x) + std::abs(edge.y);
    }
  return length;
}

std::string defect_of_sums(const T_mesh& t, const Quartic_differential& q)
{
  const long chi = t.euler_characteristic();
  if (chi != 2 - 2 * q.triangulation.genus() - q.triangulation.number_of_boundary_curves())
    return "the Euler characteristic is " + std::to_string(chi);
  std::int64_t on_boundary = 0;
  for (const T_mesh::Arc& arc : t.arcs) on_boundary += arc.on_boundary ? arc.length : 0;
  if (on_boundary != boundary_length(q)) return "the arcs on the boundary do not have its length";
  __int128 area = 0;
  for (const T_mesh::Patch& patch : t.patches) area += static_cast<__int128>(patch.width) * patch.height;
  // lengths are doubled, areas fourfold; the triangles' sum is that of twice their areas
  return 2 * area == 4 * q.doubled_area() ? "" : "the areas of the patches do not sum to that of the surface";
}

} // namespace

std::string defect(const T_mesh& t, const Quartic_differential& q)
{
  if (t.grid_exponent != q.grid_exponent + 1) return "the grid exponent is not that of doubled coordinates";
  std::string violation = defect_of_nodes(t, q);
  if (violation.empty()) violation = defect_of_arcs(t, q);
  if (violation.empty()) violation = defect_of_patches(t);
  if (violation.empty()) violation = defect_at_nodes(t);
  if (violation.empty()) violation = defect_of_sums(t, q);
  return violation;
}

} } // namespace CGAL::Quartic_differentials
