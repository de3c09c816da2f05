// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "faces_that_may_meet.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// ---- pairs of faces whose boxes overlap

CGAL::Bbox_3 box(const Intrinsic_triangulation& t, Face f)
{
  CGAL::Bbox_3 result;
  for (Halfedge h : t.halfedges(f)) result += t.mesh().point(t.source(h)).bbox();
  return result;
}

// the lowest 21 bits of x, with two zeros between each and the next
std::uint64_t spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// The boxes of faces as the leaves of a binary tree; neighbours along a space-filling curve are neighbours in it.
class Face_boxes
{
public:
  explicit Face_boxes(const Intrinsic_triangulation& t)
  {
    for (const auto& [code, face] : along_curve(t)) m_face.push_back(face);
    while (m_leaves < m_face.size()) m_leaves *= 2;
    m_box.resize(2 * m_leaves);   // empty boxes, which overlap none
    for (std::size_t i = 0; i < m_face.size(); ++i) m_box[m_leaves + i] = box(t, m_face[i]);
    for (std::size_t i = m_leaves - 1; i > 0; --i) m_box[i] = m_box[2 * i] + m_box[2 * i + 1];
  }

  /// calls visit(f, g) for all pairs of faces whose boxes overlap.
  template <class Visit>
  void for_each_pair(Visit visit) const { within(1, visit); }

private:
  // Morton's curve through the cubes of a grid, by the middles of boxes
  static std::vector<std::pair<std::uint64_t, Face>> along_curve(const Intrinsic_triangulation& t)
  {
    CGAL::Bbox_3 all;
    for (Face f : t.faces()) all += box(t, f);
    const double size = std::max({all.x_span(), all.y_span(), all.z_span()});
    const auto cell = [&](double twice, double least) {
      return spread(static_cast<std::uint64_t>(0x1fffff * std::min(1.0, (0.5 * twice - least) / size)));
    };
    std::vector<std::pair<std::uint64_t, Face>> order;
    for (Face f : t.faces()) {
      const CGAL::Bbox_3 b = box(t, f);
      order.emplace_back(cell(b.xmin() + b.xmax(), all.xmin()) | cell(b.ymin() + b.ymax(), all.ymin()) << 1
                         | cell(b.zmin() + b.zmax(), all.zmin()) << 2, f);
    }
    std::sort(order.begin(), order.end());
    return order;
  }

  template <class Visit>
  void within(std::size_t node, Visit& visit) const
  {
    if (node >= m_leaves) return;
    within(2 * node, visit);
    within(2 * node + 1, visit);
    between(2 * node, 2 * node + 1, visit);
  }

  // \pre both stand in the same row of the tree
  template <class Visit>
  void between(std::size_t a, std::size_t b, Visit& visit) const
  {
    if (!CGAL::do_overlap(m_box[a], m_box[b])) return;
    if (a >= m_leaves) return visit(m_face[a - m_leaves], m_face[b - m_leaves]);
    for (std::size_t i : {2 * a, 2 * a + 1})
      for (std::size_t k : {2 * b, 2 * b + 1}) between(i, k, visit);
  }

  std::vector<Face>         m_face;         // by leaf
  std::size_t               m_leaves = 1;   // a power of 2
  std::vector<CGAL::Bbox_3> m_box;          // by node: 1 is the root, 2i and 2i + 1 are the children of i, then leaves
};

// ---- proofs

struct Corner
{
  Vertex          vertex;
  Kernel::Point_3 point;
};
using Corners = std::array<Corner, 3>;

Corners corners(const Intrinsic_triangulation& t, Face f)
{
  Corners result;
  const auto h = t.halfedges(f);
  for (int k = 0; k < 3; ++k) {
    const Point_3& p = t.mesh().point(t.source(h[k]));
    result[k] = {t.source(h[k]), Kernel::Point_3(p.x(), p.y(), p.z())};
  }
  return result;
}

bool has(const Corners& f, Vertex v)
{
  return std::any_of(f.begin(), f.end(), [&](const Corner& c) { return c.vertex == v; });
}

// Whether all corners of g that f does not have lie on one side of the plane of f, off it. Then g meets this plane in the
// common corners and what is between them only.
bool apart_by_plane(const Corners& f, const Corners& g)
{
  int side = 0;
  for (const Corner& c : g) {
    if (has(f, c.vertex)) continue;
    const int s = CGAL::orientation(f[0].point, f[1].point, f[2].point, c.point);
    if (s == 0 || s == -side) return false;
    side = s;
  }
  return side != 0;
}

// The axis nearest to the normal of f: along it, f is seen best. (Any will do for a proof.)
int axis_of(const Corners& f)
{
  const auto n = CGAL::cross_product(f[1].point - f[0].point, f[2].point - f[0].point);
  const std::array<double, 3> size{std::abs(n.x()), std::abs(n.y()), std::abs(n.z())};
  return static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
}

// The same for the plane through an edge of f that is parallel to an axis, if the rest of f lies on its other side. Corners
// of g may lie in it, on the line of the edge, if all of them are past the same end of it, which g may have.
bool apart_by_edge(const Corners& f, const Corners& g, int axis, int k)
{
  const auto seen = [&](const Corner& c) { return Kernel::Point_2(c.point[(axis + 1) % 3], c.point[(axis + 2) % 3]); };
  const Corner &from = f[k], &to = f[(k + 1) % 3];
  const int own = CGAL::orientation(seen(from), seen(to), seen(f[(k + 2) % 3]));
  bool past_from = !has(g, to.vertex), past_to = !has(g, from.vertex), is_on_line = false;
  for (const Corner& c : g) {
    if (c.vertex == from.vertex || c.vertex == to.vertex) continue;
    const int side = CGAL::orientation(seen(from), seen(to), seen(c));
    if (side == own) return false;
    if (side != 0) continue;
    is_on_line = true;
    past_from = past_from && CGAL::collinear_are_strictly_ordered_along_line(seen(to), seen(from), seen(c));
    past_to = past_to && CGAL::collinear_are_strictly_ordered_along_line(seen(from), seen(to), seen(c));
  }
  return own != 0 && (!is_on_line || past_from || past_to);
}

bool apart_by_some_edge(const Corners& f, const Corners& g)
{
  const int axis = axis_of(f);
  return apart_by_edge(f, g, axis, 0) || apart_by_edge(f, g, axis, 1) || apart_by_edge(f, g, axis, 2);
}

// Neighbours are most often apart by an edge, which is quick to see even where they lie nearly in one plane.
bool are_apart(const Corners& f, const Corners& g)
{
  return apart_by_some_edge(f, g) || apart_by_some_edge(g, f) || apart_by_plane(f, g) || apart_by_plane(g, f);
}

} // namespace

std::vector<Face> faces_that_may_meet(const Intrinsic_triangulation& t)
{
  std::vector<Face> faces;
  Face_boxes(t).for_each_pair([&](Face f, Face g) {
    if (!are_apart(corners(t, f), corners(t, g))) faces.insert(faces.end(), {f, g});
  });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

} } } // namespace CGAL::Quartic_differentials::internal
