// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Texture_vertices.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quartic_differentials {

namespace {

// whether the charts on both sides of an edge are one
bool is_inside_chart(const Quartic_differential& q, Halfedge h)
{
  return !q.triangulation.is_border(q.triangulation.edge(h)) && q.transition[h].is_identity();
}

// the faces that are connected with f by identities and were not visited before
std::vector<Face> chart_of(const Quartic_differential& q, Face f, std::vector<char>& visited)
{
  const Intrinsic_triangulation& t = q.triangulation;
  std::vector<Face> chart{f};
  visited[f] = true;
  for (std::size_t i = 0; i < chart.size(); ++i)
    for (Halfedge h : t.halfedges(chart[i])) {
      if (!is_inside_chart(q, h)) continue;
      const Face g = t.face(t.opposite(h));
      if (visited[g]) continue;
      visited[g] = true;
      chart.push_back(g);
    }
  return chart;
}

// the corner of the grid of whole units nearest to the middle of a chart
Grid_vector whole_units_near_middle(const Quartic_differential& q, const std::vector<Face>& chart)
{
  Bbox_2 box;
  for (Face f : chart)
    for (Halfedge h : q.triangulation.halfedges(f)) {
      const double x = static_cast<double>(q.corner[h].x), y = static_cast<double>(q.corner[h].y);
      box += Bbox_2(x, y, x, y);
    }
  const auto rounded = [&](double a, double b) {
    const double units = std::nearbyint(std::ldexp((a + b) / 2, -q.grid_exponent));
    return static_cast<std::int64_t>(std::ldexp(units, q.grid_exponent));
  };
  return {rounded(box.xmin(), box.xmax()), rounded(box.ymin(), box.ymax())};
}

} // namespace

Texture_vertices texture_vertices(const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  const std::size_t none = std::numeric_limits<std::size_t>::max();
  Texture_vertices result{std::vector<std::size_t>(t.number_of_halfedges(), none), {}, {}};
  for (Halfedge h : t.halfedges()) {
    if (t.is_border(h) || result.of_corner[h] != none) continue;
    Halfedge first = h;   // of its sector: turn clockwise to a change of charts or the boundary, or once round
    while (is_inside_chart(q, first)) {
      first = t.next(t.opposite(first));
      if (first == h) break;
    }
    Halfedge g = first;
    do {
      result.of_corner[g] = result.points.size();
      if (!is_inside_chart(q, t.prev(g))) break;
      g = t.next_around_source(g);
    } while (g != first);
    result.points.push_back(q.corner[h]);
    result.vertices.push_back(t.source(h));
  }
  return result;
}

void subtract_whole_units(Texture_vertices& texture, const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  std::vector<char> visited(t.number_of_faces(), false);
  for (Face start : t.faces()) {
    if (visited[start]) continue;
    const std::vector<Face> chart = chart_of(q, start, visited);
    const Grid_vector middle = whole_units_near_middle(q, chart);
    for (Face f : chart)
      for (Halfedge h : t.halfedges(f)) texture.points[texture.of_corner[h]] = q.corner[h] - middle;
  }
}

} } // namespace CGAL::Quartic_differentials
