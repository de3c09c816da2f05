// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify_t_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

namespace {

struct Node
{
  std::string             kind;
  std::int64_t            order = 0;
  std::optional<Position> position;
  std::int64_t            arms = 0, corners = 0;
  std::int64_t            boundary_begins = 0, boundary_ends = 0;   // of arcs of the boundary

  bool is_on_boundary() const { return boundary_begins > 0; }
};

struct Arc
{
  std::size_t                                from = 0, to = 0;
  std::int64_t                               length = 0;
  std::optional<std::pair<Position, Position>> ends;   // of the polyline
  std::int64_t                               forward_uses = 0, backward_uses = 0;

  bool is_on_boundary() const { return forward_uses == 1 && backward_uses == 0; }
};

struct Side_piece { std::size_t arc; bool forward; };

struct Patch
{
  std::int64_t                           width = 0, height = 0;
  std::array<std::vector<Side_piece>, 4> sides;
};

struct Tmesh
{
  int                grid_exponent = 0;
  std::vector<Node>  nodes;
  std::vector<Arc>   arcs;
  std::vector<Patch> patches;
  Ids                patch_ids;
};

const std::int64_t largest_integer = std::numeric_limits<std::int64_t>::max();

Ids read_ids(const Json& items, const std::string& what)
{
  Ids ids;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!ids.insert({integer(member(items[i], "id"), 0, most_items, "the id of " + what), i}).second)
      throw Malformed("the id of " + what + " is not unique");
  return ids;
}

std::size_t look_up(const Ids& ids, const Json& value, const std::string& what)
{
  const auto found = ids.find(integer(value, 0, most_items, what));
  if (found == ids.end()) throw Malformed(what + " does not exist");
  return found->second;
}

// Positions and polylines are there if and only if the surface is embedded.

Node read_node(const Json& json, bool is_embedded)
{
  Node node;
  node.kind = string(member(json, "kind"), "the kind of a node");
  node.order = integer(member(json, "order"), -3, most_items, "the order of a node");
  if (is_embedded) node.position = position(member(json, "position"), "the position of a node");
  return node;
}

Arc read_arc(const Json& json, const Ids& nodes, bool is_embedded)
{
  Arc arc;
  arc.from = look_up(nodes, member(json, "from"), "the beginning of an arc");
  arc.to = look_up(nodes, member(json, "to"), "the end of an arc");
  arc.length = integer(member(json, "length"), -largest_integer, largest_integer, "the length of an arc");
  if (!is_embedded) return arc;
  const Json& polyline = array(member(json, "polyline"), "a polyline");
  if (polyline.size() < 2) throw Malformed("a polyline has no two points");
  for (const Json& p : polyline) position(p, "a point of a polyline");
  arc.ends = {position(polyline.front(), "a polyline"), position(polyline.back(), "a polyline")};
  return arc;
}

Patch read_patch(const Json& json, const Ids& arcs)
{
  Patch patch;
  patch.width = integer(member(json, "width"), -largest_integer, largest_integer, "the width of a patch");
  patch.height = integer(member(json, "height"), -largest_integer, largest_integer, "the height of a patch");
  const Json& sides = array_of_size(member(json, "sides"), 4, "the sides of a patch");
  for (int i = 0; i < 4; ++i) {
    if (array(sides[i], "a side of a patch").empty()) throw Malformed("a side of a patch is empty");
    for (const Json& piece : sides[i]) {
      const Json& forward = member(piece, "forward");
      if (!forward.is_boolean()) throw Malformed("\"forward\" is not true or false");
      patch.sides[i].push_back({look_up(arcs, member(piece, "arc"), "an arc of a patch"), forward.get<bool>()});
    }
  }
  return patch;
}

Tmesh read_tmesh(const std::string& folder, bool is_embedded)
{
  const Json json = read_json(folder, "tmesh.json");
  Tmesh t;
  const Json& exponent = member(json, "grid_exponent");
  t.grid_exponent = static_cast<int>(integer(exponent, 0, largest_grid_exponent + 1, "grid_exponent"));
  const std::string surface = string(member(json, "surface"), "surface");
  if (surface != "input" && surface != "flat_intrinsic")
    throw Malformed("\"surface\" is neither \"input\" nor \"flat_intrinsic\"");
  const Json& nodes = array(member(json, "nodes"), "nodes");
  const Json& arcs = array(member(json, "arcs"), "arcs");
  const Ids node_ids = read_ids(nodes, "a node"), arc_ids = read_ids(arcs, "an arc");
  for (const Json& n : nodes) t.nodes.push_back(read_node(n, is_embedded));
  for (const Json& a : arcs) t.arcs.push_back(read_arc(a, node_ids, is_embedded));
  const Json& patches = array(member(json, "patches"), "patches");
  t.patch_ids = read_ids(patches, "a patch");
  for (const Json& p : patches) t.patches.push_back(read_patch(p, arc_ids));
  return t;
}

std::size_t begin_of(const Tmesh& t, Side_piece s) { return s.forward ? t.arcs[s.arc].from : t.arcs[s.arc].to; }
std::size_t end_of(const Tmesh& t, Side_piece s)   { return s.forward ? t.arcs[s.arc].to : t.arcs[s.arc].from; }

bool is_rectangle(const Tmesh& t, const Patch& p)
{
  for (int i = 0; i < 4; ++i) {
    Integer length = 0;
    for (const Side_piece& s : p.sides[i]) length += t.arcs[s.arc].length;
    if (length != (i % 2 == 0 ? p.width : p.height)) return false;
  }
  return p.width > 0 && p.height > 0;
}

bool closes_up(const Tmesh& t, const Patch& p)
{
  std::size_t current = end_of(t, p.sides[3].back());
  for (const auto& side : p.sides)
    for (const Side_piece& s : side) {
      if (begin_of(t, s) != current) return false;
      current = end_of(t, s);
    }
  return true;
}

void count_uses(Tmesh& t)
{
  for (const Patch& p : t.patches)
    for (const auto& side : p.sides) {
      ++t.nodes[begin_of(t, side.front())].corners;
      for (const Side_piece& s : side) ++(s.forward ? t.arcs[s.arc].forward_uses : t.arcs[s.arc].backward_uses);
    }
  for (const Arc& a : t.arcs) {
    ++t.nodes[a.from].arms;
    ++t.nodes[a.to].arms;
    if (!a.is_on_boundary()) continue;
    ++t.nodes[a.from].boundary_begins;
    ++t.nodes[a.to].boundary_ends;
  }
}

bool fits_its_kind(const Node& n)
{
  if (n.kind == "singularity") return n.arms == n.order + 4 && n.corners == n.order + 4;
  if (n.kind == "meeting")     return n.arms == 2 && n.corners == 0;
  if (n.kind == "t_junction")  return n.arms == 3 && n.corners == 2;
  return n.kind == "crossing" && n.arms == 4 && n.corners == 4;
}

// T-junctions are inside or on the boundary. Only singularities and corners have an order.
bool fits_its_kind_with_boundary(const Node& n)
{
  if (n.kind == "corner") return n.is_on_boundary() && n.arms == n.order + 3 && n.corners == n.order + 2;
  if (n.kind != "singularity" && n.order != 0) return false;
  if (n.kind == "boundary")   return n.is_on_boundary() && n.arms == 2 && n.corners == 0;
  if (n.kind == "t_junction") return fits_its_kind(n);
  return !n.is_on_boundary() && fits_its_kind(n);
}

// the number of closed curves that arcs of the boundary form, if one begins where one ends; nothing otherwise
std::optional<std::size_t> number_of_boundary_curves(const Tmesh& t)
{
  for (const Node& n : t.nodes)
    if (n.boundary_begins > 1 || n.boundary_begins != n.boundary_ends) return {};
  std::vector<std::size_t> next(t.nodes.size());
  for (std::size_t n = 0; n < next.size(); ++n) next[n] = n;
  for (const Arc& a : t.arcs)
    if (a.is_on_boundary()) next[a.from] = a.to;
  std::vector<char> seen(next.size(), false);
  std::size_t curves = 0;
  for (std::size_t n = 0; n < next.size(); ++n) {
    if (seen[n] || !t.nodes[n].is_on_boundary()) continue;
    ++curves;
    for (std::size_t m = n; !seen[m]; m = next[m]) seen[m] = true;
  }
  return curves;
}

// the orders of the nodes of a kind, sorted
std::vector<std::int64_t> orders_of(const Tmesh& t, const std::string& kind)
{
  std::vector<std::int64_t> orders;
  for (const Node& n : t.nodes)
    if (n.kind == kind) orders.push_back(n.order);
  std::sort(orders.begin(), orders.end());
  return orders;
}

bool ends_at_its_nodes(const Tmesh& t, const Arc& a, double tolerance)
{
  if (!a.ends) return true;
  const auto near = [&](const Position& p, const Position& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= tolerance;
  };
  return near(a.ends->first, *t.nodes[a.from].position) && near(a.ends->second, *t.nodes[a.to].position);
}

} // namespace

Ids verify_t_mesh(const std::string& folder, const Flat_facts& flat, const Report& report, Checks& checks)
{
  Tmesh t = read_tmesh(folder, flat.is_embedded);
  count_uses(t);
  const auto all = [](const auto& items, auto holds) { return std::all_of(items.begin(), items.end(), holds); };

  checks.push_back({all(t.patches, [&](const Patch& p) { return is_rectangle(t, p); }),
                    "tmesh: " + std::to_string(t.patches.size()) + " patches are exact rectangles"});
  checks.push_back({all(t.patches, [&](const Patch& p) { return closes_up(t, p); }),
                    "tmesh: the sides of every patch close up"});
  const std::string backward = report.is_closed() ? "once backward" : "at most once backward";
  checks.push_back({all(t.arcs, [&](const Arc& a) {
                      return a.forward_uses == 1 && a.backward_uses <= 1 && (a.backward_uses == 1 || !report.is_closed());
                    }), "tmesh: every arc is used once forward and " + backward});
  checks.push_back({all(t.arcs, [](const Arc& a) { return a.length > 0; }), "tmesh: every arc has positive length"});

  const std::int64_t chi = static_cast<std::int64_t>(t.nodes.size()) - static_cast<std::int64_t>(t.arcs.size())
                         + static_cast<std::int64_t>(t.patches.size());
  checks.push_back({chi == report.euler_characteristic(),
                    "tmesh: V-E+F = " + std::to_string(chi) + " = " + euler_text(report)});

  Integer area = 0;
  for (const Patch& p : t.patches) area += Integer(p.width) * p.height;
  checks.push_back({(area << (2 * flat.grid_exponent + 1)) == (flat.doubled_area << (2 * t.grid_exponent)),
                    "tmesh: patch areas sum exactly to the flat area"});

  double size = 0;
  for (const Node& n : t.nodes)
    if (n.position)
      for (double x : *n.position) size = std::max(size, std::abs(x));
  checks.push_back({orders_of(t, "singularity") == flat.orders, "tmesh: one node for every singularity"});
  if (!report.is_closed()) {
    const std::optional<std::size_t> curves = number_of_boundary_curves(t);
    checks.push_back({curves.has_value(), "tmesh: the arcs with a patch on one side form closed curves"});
    if (curves) checks.push_back({*curves == number_of_curves(report), "tmesh: " + curves_text(*curves)});
    checks.push_back({orders_of(t, "corner") == flat.corner_orders, "tmesh: one node for every corner"});
  }
  checks.push_back({all(t.nodes, report.is_closed() ? fits_its_kind : fits_its_kind_with_boundary),
                    "tmesh: arms and patch corners fit the kind of every node"});
  checks.push_back({all(t.arcs, [&](const Arc& a) { return ends_at_its_nodes(t, a, 1e-9 * size); }),
                    "tmesh: polylines end at their nodes"});
  return t.patch_ids;
}

} } } // namespace CGAL::Quartic_differentials::verification
