// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "internal/Walk_graph.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/handle_tunnel_loops.h>
#include <CGAL/Quartic_differentials/internal/integer_matrix.h>
#include <CGAL/Quartic_differentials/internal/shortest_path_tree.h>
#include <CGAL/Quartic_differentials/internal/tree_cotree.h>
#include <CGAL/Quartic_differentials/intersection_number.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Shortest_path_tree;
using internal::Walk;
using internal::Walk_graph;
using internal::loop_in_tree;
using internal::path_from_root;
using internal::reversed;
using internal::without_spurs;

const double infinity = std::numeric_limits<double>::infinity();

// ---- loops

template <class Graph>
Edge_loop edge_loop(const Graph& g, Walk walk)
{
  Edge_loop loop;
  std::set<Vertex> visited;
  for (Halfedge h : walk) {
    loop.length += g.length(h);
    loop.simple = visited.insert(g.source(h)).second && loop.simple;
  }
  loop.walk = std::move(walk);
  return loop;
}

// ---- homology classes

// coefficients of a_1 .. a_g, b_1 .. b_g
using Class = std::vector<int>;

// The class of a walk on which the cochains dual to a canonical basis have these integrals.
Class class_of(const Eigen::RowVectorXi& integrals)
{
  const Eigen::RowVectorXi x = coefficients_of_class(integrals);
  return Class(x.begin(), x.end());
}

Eigen::RowVectorXi integrals(const Integer_cochains& eta, const Walk& walk)
{
  Eigen::RowVectorXi sum = Eigen::RowVectorXi::Zero(eta.size());
  for (Halfedge h : walk) sum += eta.row(h);
  return sum;
}

Class negative(Class x)
{
  for (int& c : x) c = -c;
  return x;
}

Class row(const Eigen::MatrixXi& m, int i) { return Class(m.row(i).begin(), m.row(i).end()); }

bool is_zero(const Class& x, int first, int last)
{
  return std::all_of(x.begin() + first, x.begin() + last, [](int c) { return c == 0; });
}

// whether the first coefficient that is not 0 is negative: one of x and -x stands for both
bool is_turned(const Class& x)
{
  const auto first = std::find_if(x.begin(), x.end(), [](int c) { return c != 0; });
  return first != x.end() && *first < 0;
}

// The shortest loop known of every class in a graph, up to orientation.
class Loop_catalogue
{
public:
  explicit Loop_catalogue(const Walk_graph& g)
    : m_g(g), m_eta(g.cochains()), m_crosses(g.number_of_edges()), m_distance(g.number_of_vertices(), infinity)
  {
    for (std::size_t e = 0; e < m_crosses.size(); ++e) m_crosses[e] = !m_eta.values().row(e).isZero();
  }

  // looks at the loops through a vertex that are at most twice the radius long
  void add_root(Vertex root, double radius = infinity)
  {
    const Shortest_path_tree tree = internal::shortest_path_tree(m_g, m_g.lengths(), root, radius);
    for (Vertex v : tree.order) m_distance[v] = std::min(m_distance[v], tree.distance[v]);
    for (const auto& [x, nearest] : nearest_loops(tree)) keep(x, loop_in_tree(m_g, tree.parent, nearest.second));
  }

  // the vertex that is farthest from all roots
  Vertex farthest() const
  {
    return Vertex(static_cast<Mesh::size_type>(std::max_element(m_distance.begin(), m_distance.end())
                                               - m_distance.begin()));
  }

  double length(const Class& x) const
  {
    const auto found = m_loops.find(is_turned(x) ? negative(x) : x);
    return found == m_loops.end() ? infinity : found->second.length;
  }

  // \pre its length is finite
  Edge_loop loop(const Class& x) const
  {
    if (!is_turned(x)) return m_loops.at(x);
    return edge_loop(m_g, reversed(m_g, m_loops.at(negative(x)).walk));
  }

  // the classes by the length of their loops
  std::vector<std::pair<double, Class>> by_length() const
  {
    std::vector<std::pair<double, Class>> list;
    for (const auto& [x, loop] : m_loops) list.emplace_back(loop.length, x);
    std::sort(list.begin(), list.end());
    return list;
  }

private:
  // of every class, the halfedge outside the tree that closes the shortest loop through the root
  std::map<Class, std::pair<double, Halfedge>> nearest_loops(const Shortest_path_tree& tree) const
  {
    // the integrals of the cochains along the tree: few differ, so vertices only name theirs
    std::vector<Eigen::RowVectorXi> value{Eigen::RowVectorXi::Zero(m_eta.size())};
    std::vector<int> value_at(m_g.number_of_vertices(), 0);
    for (Vertex v : tree.order) {
      const Halfedge h = tree.parent[v];
      if (h == Mesh::null_halfedge()) continue;
      value_at[v] = value_at[m_g.source(h)];
      if (!m_crosses[m_g.edge(h)]) continue;
      value.push_back(value[value_at[v]] + m_eta.row(h));
      value_at[v] = static_cast<int>(value.size()) - 1;
    }
    std::map<Class, std::pair<double, Halfedge>> nearest;
    for (std::size_t e = 0; e < m_crosses.size(); ++e) {
      Halfedge h(static_cast<Mesh::size_type>(2 * e));
      const Vertex from = m_g.source(h), to = m_g.target(h);
      const double length = tree.distance[from] + m_g.length(h) + tree.distance[to];
      if (length == infinity || (value_at[from] == value_at[to] && !m_crosses[e])) continue;
      Class x = class_of(value[value_at[from]] + m_eta.row(h) - value[value_at[to]]);
      if (is_turned(x)) { x = negative(x); h = m_g.opposite(h); }
      if (is_zero(x, 0, m_eta.size())) continue;
      const auto [entry, is_new] = nearest.insert({x, {length, h}});
      if (!is_new && length < entry->second.first) entry->second = {length, h};
    }
    return nearest;
  }

  void keep(const Class& x, Walk walk)
  {
    Edge_loop loop = edge_loop(m_g, std::move(walk));
    const auto [entry, is_new] = m_loops.insert({x, loop});
    if (!is_new && loop.length < entry->second.length) entry->second = std::move(loop);
  }

  const Walk_graph&          m_g;
  const Integer_cochains&    m_eta;
  std::vector<char>          m_crosses;    // by edge: a cochain is not 0 on it
  std::map<Class, Edge_loop> m_loops;
  std::vector<double>        m_distance;   // from the nearest root
};

// ---- the choice of classes

using internal::Big_integer_matrix;
using internal::narrowed;
using internal::widened;

// A basis of the tunnel classes (first = 0) or of the handle classes (first = g), greedily from the shortest loops, in
// coefficients of the old basis; nothing if the loops do not reach.
std::optional<Eigen::MatrixXi> greedy_basis(const Loop_catalogue& catalogue, int g, int first)
{
  Eigen::MatrixXi rows(0, g);
  for (const auto& [length, x] : catalogue.by_length()) {
    if (!is_zero(x, g - first, 2 * g - first)) continue;   // not in this half
    Eigen::MatrixXi more(rows.rows() + 1, g);
    more.topRows(rows.rows()) = rows;
    for (int k = 0; k < g; ++k) more(rows.rows(), k) = x[first + k];
    if (internal::is_primitive(widened(more))) rows = more;
    if (rows.rows() == g) return rows;
  }
  return std::nullopt;
}

// The symplectic change of basis that takes a to p a, or b to p b, and the other half to the dual basis.
Eigen::MatrixXi with_dual(const Eigen::MatrixXi& p, bool tunnels)
{
  const Eigen::Index g = p.rows();
  const Eigen::MatrixXi dual = narrowed(internal::unimodular_inverse(widened(p))->transpose());
  Eigen::MatrixXi u = Eigen::MatrixXi::Zero(2 * g, 2 * g);
  u.topLeftCorner(g, g) = tunnels ? p : dual;
  u.bottomRightCorner(g, g) = tunnels ? dual : p;
  return u;
}

// how many of these classes have no loop, and the length of all others
std::pair<int, double> total_length(const Loop_catalogue& catalogue, const Eigen::MatrixXi& classes)
{
  std::pair<int, double> total{0, 0};
  for (int i = 0; i < classes.rows(); ++i) {
    const double length = catalogue.length(row(classes, i));
    if (length == infinity) ++total.first;
    else total.second += length;
  }
  return total;
}

// Rows p and partner(q) of a canonical basis after s times row q is added to row p: the other changes too, to keep the
// basis canonical, unless it is p.
Eigen::MatrixXi sum_of_rows(const Eigen::MatrixXi& u, int p, int q, int s)
{
  const int n = static_cast<int>(u.rows()), g = n / 2;
  const auto partner = [&](int i) { return (i + g) % n; };
  Eigen::MatrixXi changed(2, n);
  changed.row(0) = u.row(p) + s * u.row(q);
  if (partner(q) == p) changed.row(1) = changed.row(0);
  else changed.row(1) = u.row(partner(q)) - ((p < g) == (q < g) ? s : -s) * u.row(partner(p));
  return changed;
}

// Adds classes to each other as long as the loops get shorter; tunnels and handles to their own kind only, if `apart`.
void descend(const Loop_catalogue& catalogue, bool apart, Eigen::MatrixXi& u)
{
  const int n = static_cast<int>(u.rows()), g = n / 2;
  for (bool improved = true; improved;) {
    improved = false;
    for (int p = 0; p < n; ++p)
      for (int q = 0; q < n; ++q)
        for (int s : {1, -1}) {
          if (p == q || (apart && (p < g) != (q < g))) continue;
          Eigen::MatrixXi before(2, n);
          before << u.row(p), u.row((q + g) % n);
          const Eigen::MatrixXi after = sum_of_rows(u, p, q, s);
          if (!(total_length(catalogue, after) < total_length(catalogue, before))) continue;
          u.row(p) = after.row(0);
          u.row((q + g) % n) = after.row(1);
          improved = true;
        }
  }
}

// A change of basis to shorter classes, tunnels to tunnels and handles to handles if `apart`.
Eigen::MatrixXi short_classes(const Loop_catalogue& catalogue, bool apart, Eigen::MatrixXi best)
{
  const int g = static_cast<int>(best.rows()) / 2;
  for (bool tunnels : {true, false})
    if (const auto p = apart ? greedy_basis(catalogue, g, tunnels ? 0 : g) : std::nullopt) {
      const Eigen::MatrixXi u = with_dual(*p, tunnels);
      if (total_length(catalogue, u) < total_length(catalogue, best)) best = u;
    }
  descend(catalogue, apart, best);
  return best;
}

Homology_basis changed(const Homology_basis& basis, const Eigen::MatrixXi& u, std::size_t edges)
{
  Homology_basis result{basis.loops, narrowed(widened(u) * widened(basis.combination)), {}, {}};
  result.intersection_matrix = narrowed(widened(u) * widened(basis.intersection_matrix) * widened(u).transpose());
  if (result.intersection_matrix != symplectic_unit(static_cast<int>(u.rows()) / 2))
    throw Numerical_error("the intersection form of the short loops is not the symplectic unit");
  result.cochains = cochains_of_loops(result, edges);
  return result;
}

// ---- one loop after the other

template <class Graph>
Vertex vertex_on(const Graph& g, const Walk& walk, int i, int n)
{
  return g.source(walk[walk.size() * i / n]);
}

// Looks for shorter loops in a class through vertices of the one known.
void tighten(const Walk_graph& g, const Class& x, Loop_catalogue& catalogue)
{
  const int vertices = 3, rounds = 4;
  double before = infinity;
  for (int round = 0; round < rounds && catalogue.length(x) < before; ++round) {
    before = catalogue.length(x);
    const Walk walk = catalogue.loop(x).walk;
    for (int i = 0; i < vertices; ++i) catalogue.add_root(vertex_on(g, walk, i, vertices), catalogue.length(x) / 2);
  }
}

// Looks for loops in a class x through vertices of a loop that every such loop crosses.
void search_across(const Walk_graph& g, const Class& x, const Class& across, Loop_catalogue& catalogue)
{
  if (catalogue.length(across) == infinity) return;
  const int vertices = 8;
  const Walk walk = catalogue.loop(across).walk;
  for (int i = 0; i < vertices && catalogue.length(x) == infinity; ++i)
    catalogue.add_root(vertex_on(g, walk, i, vertices));
}

// The shortest walk through a vertex in a class, by Dijkstra's algorithm in the homology cover: a place is a vertex
// with the class of the way to it, and the way back is at least as long as in the surface (A*). Nothing if there are
// too many places.
std::optional<Edge_loop> loop_in_cover(const Walk_graph& g, const Class& x, Vertex root)
{
  using Place = std::pair<Class, Vertex>;
  struct Arrival { double length; Halfedge by; };
  const std::size_t most = 600000 / x.size();   // about a second
  const Shortest_path_tree back = internal::shortest_path_tree(g, g.lengths(), root);
  const Place start{Class(x.size(), 0), root}, end{x, root};
  std::map<Place, Arrival> reached{{start, {0, Mesh::null_halfedge()}}};
  std::set<std::pair<double, Place>> queue{{0, start}};
  const auto moved = [&](Class y, Halfedge h, int sign) {
    const Class step = class_of(g.cochains().row(h));
    for (std::size_t k = 0; k < y.size(); ++k) y[k] += sign * step[k];
    return y;
  };
  while (!queue.empty() && reached.size() < most) {
    const Place here = queue.begin()->second;
    queue.erase(queue.begin());
    const double length = reached.at(here).length;
    if (here == end) {
      Walk walk;
      for (Place p = end; p != start; p = {moved(p.first, walk.back(), -1), g.source(walk.back())})
        walk.push_back(reached.at(p).by);
      std::reverse(walk.begin(), walk.end());
      return edge_loop(g, std::move(walk));
    }
    const Halfedge first = g.halfedge_from(here.second);
    Halfedge h = first;
    do {
      const Place there{moved(here.first, h, 1), g.target(h)};
      const Arrival arrival{length + g.length(h), h};
      const auto [entry, is_new] = reached.insert({there, arrival});
      if (is_new || arrival.length < entry->second.length) {
        if (!is_new) queue.erase({entry->second.length + back.distance[there.second], there});
        entry->second = arrival;
        queue.insert({arrival.length + back.distance[there.second], there});
      }
      h = g.next_around_source(h);
    } while (h != first);
  }
  return std::nullopt;
}

// A walk in a class that is put together from the 2g greedy loops through a vertex.
Edge_loop composed_loop(const Intrinsic_triangulation& t, const Integer_cochains& eta, const Class& x, Vertex root)
{
  const internal::Tree_cotree trees = internal::tree_cotree(t, t.lengths(), root);
  const int n = static_cast<int>(trees.generators.size());
  std::vector<Walk> loops;
  Eigen::MatrixXi classes(n, n), wanted(1, n);
  for (int k = 0; k < n; ++k) {
    loops.push_back(loop_in_tree(t, trees.vertex_parent, t.halfedge(trees.generators[k])));
    const Class y = class_of(integrals(eta, loops[k]));
    for (int l = 0; l < n; ++l) classes(k, l) = y[l];
    wanted(0, k) = x[k];
  }
  const auto inverse = internal::unimodular_inverse(widened(classes));
  if (!inverse) throw Numerical_error("the loops through a vertex do not generate the homology");
  const Eigen::MatrixXi coefficient = narrowed(widened(wanted) * *inverse);
  Walk walk;
  for (int k = 0; k < n; ++k) {
    Walk piece = path_from_root(t, trees.vertex_parent, t.source(loops[k].front()));
    const Walk back = reversed(t, piece), turn = coefficient(0, k) > 0 ? loops[k] : reversed(t, loops[k]);
    for (int m = 0; m < std::abs(coefficient(0, k)); ++m) piece.insert(piece.end(), turn.begin(), turn.end());
    piece.insert(piece.end(), back.begin(), back.end());
    walk.insert(walk.end(), piece.begin(), piece.end());
  }
  return edge_loop(t, without_spurs(t, walk));
}

// Any loop in a class that no single shortest path closes, through a vertex of a loop that all of them cross.
Edge_loop long_way_round(const Intrinsic_triangulation& t, const Integer_cochains& eta, const Walk_graph& g,
                         const Class& x, const Class& across, const Loop_catalogue& catalogue)
{
  const bool known = catalogue.length(across) < infinity;
  const Vertex root = known ? g.source(catalogue.loop(across).walk.front()) : Vertex(0);
  if (const auto loop = loop_in_cover(g, x, root)) return edge_loop(t, g.on_surface(loop->walk));
  return composed_loop(t, eta, x, g.forest().sites[root]);
}

// Chooses classes and looks for shorter loops in them by turns.
Eigen::MatrixXi chosen_classes(const Walk_graph& g, int genus, bool apart, Loop_catalogue& catalogue)
{
  const int n = 2 * genus, rounds = 4;
  Eigen::MatrixXi u = Eigen::MatrixXi::Identity(n, n);
  for (int round = 0; round < rounds; ++round) {
    const Eigen::MatrixXi v = short_classes(catalogue, apart, u);
    if (round > 0 && v == u) break;
    u = v;
    for (int i = 0; i < n; ++i) {
      const Class x = row(u, i);
      if (catalogue.length(x) == infinity) search_across(g, x, row(u, (i + n / 2) % n), catalogue);
      if (catalogue.length(x) < infinity) tighten(g, x, catalogue);
    }
  }
  return u;
}

// ---- from cells to vertices

// Cells in which the shape of the surface can still be seen, or single vertices where these are few enough.
internal::Cell_forest cells(const Intrinsic_triangulation& t)
{
  const double most = 2000;
  if (t.number_of_vertices() <= most) return internal::cells_within(t, 0);
  return internal::cells_within(t, std::sqrt(t.area() / most));
}

// A ribbon round a loop: the vertices in the cells that it passes through and in some rings of cells round them.
std::vector<Vertex> ribbon(const Intrinsic_triangulation& t, const Walk_graph& g, const Walk& walk)
{
  const int rings = 2;
  std::vector<char> inside(g.number_of_vertices(), false);
  for (Halfedge h : walk) inside[g.vertex_of(t.source(h))] = true;
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> before = inside;
    for (std::size_t e = 0; e < g.number_of_edges(); ++e) {
      const Halfedge h(static_cast<Mesh::size_type>(2 * e));
      if (before[g.source(h)]) inside[g.target(h)] = true;
      if (before[g.target(h)]) inside[g.source(h)] = true;
    }
  }
  std::vector<Vertex> vertices;
  for (Vertex v : t.vertices())
    if (inside[g.vertex_of(v)]) vertices.push_back(v);
  return vertices;
}

// Looks for shorter loops in a class near the one known, which move with it.
Edge_loop tightened(const Intrinsic_triangulation& t, const Integer_cochains& eta, const Walk_graph& g, const Class& x,
                    Edge_loop loop)
{
  const int vertices = 2, rounds = 4;
  double before = infinity;
  for (int round = 0; round < rounds && loop.length < before; ++round) {
    before = loop.length;
    const Walk_graph near(t, eta, internal::single_vertices(t, ribbon(t, g, loop.walk)));
    Loop_catalogue catalogue(near);
    for (int i = 0; i < vertices; ++i) {
      catalogue.add_root(near.vertex_of(vertex_on(t, loop.walk, i, vertices)), loop.length / 2);
      if (catalogue.length(x) < loop.length) loop = edge_loop(t, near.on_surface(catalogue.loop(x).walk));
    }
  }
  return loop;
}

} // namespace

std::string loop_name(int k, int genus) { return (k < genus ? "a" : "b") + std::to_string(k % genus + 1); }

std::string loop_kind(const Handle_tunnel_loops& loops, int k)
{
  if (!loops.classes.found) return "";
  return 2 * k < static_cast<int>(loops.loops.size()) ? "tunnel" : "handle";
}

Handle_tunnel_loops handle_tunnel_loops(const Intrinsic_triangulation& t, const Handle_tunnel_basis& classes, int roots)
{
  CGAL_precondition(roots > 0);
  const int g = t.genus();
  const Homology_basis& old = classes.basis;
  Handle_tunnel_loops result{classes, {}};
  if (g == 0) return result;
  const Walk_graph graph(t, old.cochains, cells(t));
  Loop_catalogue catalogue(graph);
  catalogue.add_root(Vertex(0));
  for (int i = 1; i < roots; ++i) catalogue.add_root(catalogue.farthest());

  const Eigen::MatrixXi u = chosen_classes(graph, g, classes.found, catalogue);
  result.classes.basis = changed(old, u, t.number_of_edges());
  for (int i = 0; i < 2 * g; ++i) {
    const Class x = row(u, i), across = row(u, (i + g) % (2 * g));
    Edge_loop loop = catalogue.length(x) < infinity ? edge_loop(t, graph.on_surface(catalogue.loop(x).walk))
                                                    : long_way_round(t, old.cochains, graph, x, across, catalogue);
    if (graph.number_of_vertices() < t.number_of_vertices()) loop = tightened(t, old.cochains, graph, x, loop);
    result.loops.push_back(std::move(loop));
    if (integrals(result.classes.basis.cochains, result.loops[i].walk) != symplectic_unit(g).col(i).transpose())
      throw Numerical_error("a short loop is not in its class");
  }
  return result;
}

} } // namespace CGAL::Quartic_differentials
