// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_WALK_GRAPH_H
#define CGAL_QUARTIC_DIFFERENTIALS_WALK_GRAPH_H

#include "Cell_forest.h"
#include "edge_walks.h"

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A graph in which closed walks on a surface are looked for: its vertices are the sites of cells, and its edges are the
/// shortest walks, up to homology, that lead from a site through its cell and over an edge of the surface into the same
/// or another cell, and there to the site. Walks that are closed and bound are left out. Every closed walk on the surface
/// that stays in the cells is homologous to one in the graph, which passes through the same cells.
///
/// It goes by the names of an `Intrinsic_triangulation`: halfedges 2e and 2e+1 make up edge e.
class Walk_graph
{
public:
  /// \param eta on the surface: they tell homology classes apart
  /// Complexity: linear in the vertices of cells and the edges at them.
  Walk_graph(const Intrinsic_triangulation& t, const Integer_cochains& eta, Cell_forest forest);

  std::size_t number_of_vertices() const { return m_forest.sites.size(); }
  std::size_t number_of_edges()    const { return m_length.size(); }

  static Halfedge opposite(Halfedge h) { return Halfedge(h.idx() ^ 1); }
  static Edge     edge(Halfedge h)     { return Edge(h.idx() / 2); }
  Vertex target(Halfedge h) const { return m_target[h]; }
  Vertex source(Halfedge h) const { return m_target[opposite(h)]; }
  Halfedge halfedge_from(Vertex v)        const { return m_first[v]; }
  /// the next halfedge from source(h), in a circle without any meaning
  Halfedge next_around_source(Halfedge h) const { return m_next[h]; }

  const std::vector<double>& lengths() const { return m_length; }
  double length(Halfedge h) const { return m_length[edge(h)]; }
  /// the cochains' integrals along the walks that edges are
  const Integer_cochains& cochains() const { return m_cochains; }

  const Cell_forest& forest() const { return m_forest; }
  /// the vertex of the graph in whose cell a vertex of the surface is
  Vertex vertex_of(Vertex on_surface) const
  { return Vertex(static_cast<Mesh::size_type>(m_forest.cell[on_surface])); }
  /// the closed walk on the surface, without spurs. It is simple if the one in the graph is.
  Walk on_surface(const Walk& closed) const;

private:
  void add_edge(Halfedge bridge, double length, const Eigen::RowVectorXi& integrals);
  void link(Halfedge h, Vertex source);

  const Intrinsic_triangulation& m_surface;
  Cell_forest                    m_forest;
  std::vector<double>            m_length;        // by edge
  std::vector<Halfedge>          m_bridge;        // by edge: where halfedge 2e leaves the cell of its source
  std::vector<Vertex>            m_target;        // by halfedge
  std::vector<Halfedge>          m_next, m_first; // by halfedge, by vertex
  Integer_cochains               m_cochains;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_WALK_GRAPH_H
