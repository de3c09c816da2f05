// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Walk_graph.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

using Integrals = Eigen::RowVectorXi;

// Names for vectors of integers, of which few differ: 0 is that of the zero vector.
class Names
{
public:
  explicit Names(int size) { (*this)(Integrals::Zero(size)); }
  int operator()(const Integrals& x)
  {
    const auto [found, is_new] = m_name.insert({std::vector<int>(x.begin(), x.end()), static_cast<int>(m_value.size())});
    if (is_new) m_value.push_back(x);
    return found->second;
  }
  const Integrals& operator[](int name) const { return m_value[name]; }

private:
  std::map<std::vector<int>, int> m_name;
  std::vector<Integrals>          m_value;
};

// by vertex in a cell, the name of the cochains' integrals along the path from its site
std::vector<int> integrals_along_paths(const Intrinsic_triangulation& t, const Integer_cochains& eta,
                                       const Cell_forest& forest, Names& names)
{
  std::vector<int> name(t.number_of_vertices(), 0);
  for (Vertex v : forest.vertices) {
    const Halfedge h = forest.parent[v];
    if (h == Mesh::null_halfedge()) continue;
    const int before = name[t.source(h)];
    name[v] = eta.values().row(h.idx() / 2).isZero() ? before : names(names[before] + eta.row(h));
  }
  return name;
}

bool is_turned(const Integrals& x)
{
  const auto first = std::find_if(x.begin(), x.end(), [](int c) { return c != 0; });
  return first != x.end() && *first < 0;
}

// The walk from a site through its cell, over a halfedge of the surface, and to another site.
struct Connection
{
  Halfedge bridge;
  double   length;
  int      to;          // the cell
  int      integrals;   // their name
  int      next;        // connection from the same cell, or -1
};

// The shortest walk of every class between every two sites, in one of its directions.
class Connections
{
public:
  Connections(const Intrinsic_triangulation& t, const Integer_cochains& eta, const Cell_forest& forest)
    : m_t(t), m_eta(eta), m_forest(forest), m_names(eta.size()),
      m_name(integrals_along_paths(t, eta, forest, m_names)), m_first(forest.sites.size(), -1)
  {}

  void add(Halfedge h)
  {
    const int from = m_forest.cell[m_t.source(h)], to = m_forest.cell[m_t.target(h)];
    if (to < 0) return;
    const bool is_zero = m_name[m_t.source(h)] == m_name[m_t.target(h)] && m_eta.values().row(h.idx() / 2).isZero();
    if (!is_zero)
      m_sum = m_names[m_name[m_t.source(h)]] + m_eta.row(h) - m_names[m_name[m_t.target(h)]];
    if (from == to && (is_zero || m_sum.isZero())) return;
    if (from == to ? is_turned(m_sum) : from > to) return add(m_t.opposite(h));
    keep({h, m_forest.distance[m_t.source(h)] + m_t.length(h) + m_forest.distance[m_t.target(h)], to,
          is_zero ? 0 : m_names(m_sum), m_first[from]}, from);
  }

  const std::vector<Connection>& list() const { return m_list; }
  const Integrals& integrals(const Connection& c) const { return m_names[c.integrals]; }

private:
  void keep(const Connection& c, int from)
  {
    for (int i = m_first[from]; i >= 0; i = m_list[i].next) {
      Connection& known = m_list[i];
      if (known.to != c.to || known.integrals != c.integrals) continue;
      if (c.length < known.length) std::tie(known.bridge, known.length) = std::tie(c.bridge, c.length);
      return;
    }
    m_first[from] = static_cast<int>(m_list.size());
    m_list.push_back(c);
  }

  const Intrinsic_triangulation& m_t;
  const Integer_cochains&        m_eta;
  const Cell_forest&             m_forest;
  Names                          m_names;
  std::vector<int>               m_name;   // by vertex: that of the integrals along the path from its site
  Integrals                      m_sum;
  std::vector<int>               m_first;  // by cell: the last connection from it, or -1
  std::vector<Connection>        m_list;
};

} // namespace

Walk_graph::Walk_graph(const Intrinsic_triangulation& t, const Integer_cochains& eta, Cell_forest forest)
  : m_surface(t), m_forest(std::move(forest)), m_first(m_forest.sites.size(), Mesh::null_halfedge())
{
  Connections connections(t, eta, m_forest);
  for (Vertex v : m_forest.vertices) {
    const Halfedge first = t.halfedge_from(v);
    Halfedge h = first;
    do {
      if (h == t.halfedge(t.edge(h))) connections.add(h);   // once an edge
      h = t.next_around_source(h);
    } while (h != first);
  }
  m_cochains = Integer_cochains(connections.list().size(), eta.size());
  for (const Connection& c : connections.list()) add_edge(c.bridge, c.length, connections.integrals(c));
}

void Walk_graph::add_edge(Halfedge bridge, double length, const Eigen::RowVectorXi& integrals)
{
  const Halfedge h(static_cast<Mesh::size_type>(2 * m_length.size()));
  m_length.push_back(length);
  m_bridge.push_back(bridge);
  const Vertex from = vertex_of(m_surface.source(bridge)), to = vertex_of(m_surface.target(bridge));
  m_target.insert(m_target.end(), {to, from});
  m_next.resize(m_target.size());
  link(h, from);
  link(opposite(h), to);
  for (int k = 0; k < m_cochains.size(); ++k) m_cochains.add(h, k, integrals[k]);
}

// puts h into the circle of halfedges at its source.
void Walk_graph::link(Halfedge h, Vertex source)
{
  Halfedge& first = m_first[source];
  if (first == Mesh::null_halfedge()) first = m_next[h] = h;
  else m_next[h] = std::exchange(m_next[first], h);
}

Walk Walk_graph::on_surface(const Walk& closed) const
{
  Walk walk;
  for (Halfedge h : closed) {
    const Halfedge bridge = m_bridge[edge(h)], over = h.idx() % 2 == 0 ? bridge : m_surface.opposite(bridge);
    const Walk out = path_from_root(m_surface, m_forest.parent, m_surface.source(over)),
               in = reversed(m_surface, path_from_root(m_surface, m_forest.parent, m_surface.target(over)));
    walk.insert(walk.end(), out.begin(), out.end());
    walk.push_back(over);
    walk.insert(walk.end(), in.begin(), in.end());
  }
  return without_spurs(m_surface, walk);
}

} } } // namespace CGAL::Quartic_differentials::internal
