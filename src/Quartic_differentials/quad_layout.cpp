// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/quad_layout.h>

#include <CGAL/Quartic_differentials/exceptions.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

// Lines of edges through a quad mesh, and the regions between them.
class Cut_quads
{
public:
  explicit Cut_quads(const Mesh& m) : m_m(m), m_is_cut(m.num_edges(), false)
  {
    for (Edge e : m.edges()) m_is_cut[e] = m.is_border(e);
    bool all_are_regular = true;
    for (Vertex v : m.vertices()) all_are_regular = all_are_regular && is_regular(v);
    for (Halfedge h : m.halfedges())
      if (!is_regular(m.source(h))) cut(h);
    if (all_are_regular) cut_regular();
  }

  Quad_layout layout() const
  {
    Quad_layout result;
    std::vector<char> is_taken(m_m.num_faces(), false);
    std::size_t taken = 0;
    for (Face f : m_m.faces())
      for (Halfedge h : halfedges_around_face(m_m.halfedge(f), m_m))
        if (!is_taken[f] && is_corner(h)) {
          result.patches.push_back(patch(h));
          for (Halfedge g : result.patches.back().quads) is_taken[m_m.face(g)] = true;
          taken += result.patches.back().quads.size();
        }
    if (taken != m_m.number_of_faces()) throw Unusable_surface_error("the quad mesh is not connected");
    add_sides(result);
    return result;
  }

private:
  // a torus, or an annulus
  void cut_regular()
  {
    for (Halfedge h : m_m.halfedges())
      if (m_m.is_border(m_m.source(h)) && !is_cut(h)) return cut(h);
    const Halfedge any = *m_m.halfedges().begin();
    cut(any);
    cut(m_m.next(any));
  }

  // sorts the sides of the patches
  void add_sides(Quad_layout& layout) const
  {
    std::vector<Quad_layout::Side> side_of(m_m.num_halfedges());   // that end with a halfedge
    for (std::size_t p = 0; p < layout.patches.size(); ++p)
      for (int k = 0; k < 4; ++k) side_of[last_on_side(layout.patches[p], k)] = {p, k};
    for (std::size_t p = 0; p < layout.patches.size(); ++p)
      for (int k = 0; k < 4; ++k) {
        const Halfedge outside = m_m.opposite(first_on_side(layout.patches[p], k));
        if (m_m.is_border(outside)) {
          layout.boundary.push_back({p, k});
          continue;
        }
        const Quad_layout::Side other = side_of[outside];
        if (p < other.patch || (p == other.patch && k < other.side)) layout.interfaces.push_back({{p, k}, other});
      }
  }

  // by its edges
  bool is_regular(Vertex v) const { return m_m.degree(v) == (m_m.is_border(v) ? 3 : 4); }
  bool is_cut(Halfedge h) const { return m_is_cut[m_m.edge(h)]; }
  // the quad is the first of its patch, and h runs along the first row
  bool is_corner(Halfedge h) const { return is_cut(h) && is_cut(m_m.prev(h)); }

  Halfedge straight_on(Halfedge h) const { return m_m.next(m_m.opposite(m_m.next(h))); }
  Halfedge in_next_column(Halfedge h) const { return straight_on(h); }
  Halfedge in_next_row(Halfedge h) const { return m_m.opposite(m_m.next(m_m.next(h))); }

  // along a line, to the boundary, which is cut; past an irregular vertex too, since all edges there are cut
  void cut(Halfedge h)
  {
    for (; !is_cut(h); h = straight_on(h)) {
      m_is_cut[m_m.edge(h)] = true;
      if (m_m.is_border(m_m.target(h))) return;
    }
  }

  Quad_layout::Patch patch(Halfedge corner) const
  {
    Quad_layout::Patch p{{0, 0}, {}};
    for (Halfedge row = corner;; row = in_next_row(row)) {
      for (Halfedge h = row;; h = in_next_column(h)) {
        p.quads.push_back(h);
        if (is_cut(m_m.next(h))) break;
      }
      ++p.size[1];
      if (!is_cut(m_m.next(m_m.next(row)))) continue;
      p.size[0] = p.quads.size() / p.size[1];
      return p;
    }
  }

  Halfedge first_on_side(const Quad_layout::Patch& p, int k) const { return on_side(p.quads[corner(p, k)], k); }
  Halfedge last_on_side(const Quad_layout::Patch& p, int k) const { return on_side(p.quads[corner(p, k + 1)], k); }

  // the quad in which side k begins
  static std::size_t corner(const Quad_layout::Patch& p, int k)
  {
    const std::size_t corners[] = {0, p.size[0] - 1, p.quads.size() - 1, p.quads.size() - p.size[0]};
    return corners[k % 4];
  }

  Halfedge on_side(Halfedge h, int k) const
  {
    for (int i = 0; i < k; ++i) h = m_m.next(h);
    return h;
  }

  const Mesh&       m_m;
  std::vector<char> m_is_cut;   // by edge
};

void require_quads(const Mesh& m)
{
  if (m.number_of_faces() == 0) throw Unusable_surface_error("the quad mesh has no faces");
  for (Face f : m.faces())
    if (m.degree(f) != 4)
      throw Unusable_surface_error("face " + std::to_string(f.idx()) + " has " + std::to_string(m.degree(f))
                                   + " corners: a layout is made of quads");
}

} // namespace

std::vector<Vertex> grid_vertices(const Mesh& quads, const Quad_layout::Patch& patch)
{
  const auto [columns, rows] = patch.size;
  std::vector<Vertex> result((columns + 1) * (rows + 1));
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t first = j * (columns + 1) + i;
      const Halfedge h = patch.quads[j * columns + i];
      result[first] = quads.source(h);
      result[first + 1] = quads.target(h);
      result[first + columns + 2] = quads.target(quads.next(h));
      result[first + columns + 1] = quads.source(quads.prev(h));
    }
  return result;
}

Quad_layout quad_layout(const Mesh& quads)
{
  require_quads(quads);
  return Cut_quads(quads).layout();
}

} } // namespace CGAL::Quartic_differentials
