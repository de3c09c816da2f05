// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_components.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Sets = boost::disjoint_sets_with_storage<>;

const std::size_t unseen = std::numeric_limits<std::size_t>::max();

// The number of every face's set, in the order in which the faces come to them. \param place in a set, of a face
template <class Place>
std::vector<std::size_t> numbered(Sets& sets, std::size_t places, std::size_t faces, Place place)
{
  std::vector<std::size_t> number(places, unseen), component(faces);
  std::size_t count = 0;
  for (std::size_t f = 0; f < faces; ++f) {
    std::size_t& n = number[sets.find_set(place(f))];
    if (n == unseen) n = count++;
    component[f] = n;
  }
  return component;
}

Sets joined_by_polygons(const Polygon_soup& s)
{
  Sets sets(s.points.size());
  for (const auto& p : s.polygons)
    for (std::size_t v : p) sets.union_set(p[0], v);
  return sets;
}

std::vector<std::size_t> numbered(Sets& sets, const Polygon_soup& s)
{ return numbered(sets, s.points.size(), s.polygons.size(), [&](std::size_t f) { return s.polygons[f][0]; }); }

// whether each point belongs to a set of polygons with an edge that only one of them has
std::vector<char> has_boundary(const Polygon_soup& s, Sets& sets)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& p : s.polygons)
    for (std::size_t c = 0; c < p.size(); ++c) edges.push_back(std::minmax(p[c], p[(c + 1) % p.size()]));
  std::sort(edges.begin(), edges.end());
  std::vector<char> of_set(s.points.size(), false), result(s.points.size());
  for (auto first = edges.begin(), last = first; first != edges.end(); first = last) {
    last = std::find_if(first, edges.end(), [&](const auto& e) { return e != *first; });
    if (last - first == 1) of_set[sets.find_set(first->first)] = true;
  }
  for (std::size_t v = 0; v < s.points.size(); ++v) result[v] = of_set[sets.find_set(v)];
  return result;
}

bool is_finite(const Point_3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

// The faces of every component, in order
std::vector<std::vector<std::size_t>> by_component(const std::vector<std::size_t>& component)
{
  std::vector<std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < component.size(); ++f) {
    if (component[f] >= faces.size()) faces.resize(component[f] + 1);
    faces[component[f]].push_back(f);
  }
  return faces;
}

// Sorted, every vertex once; the place of a vertex is its new name.
template <class Polygon>
std::vector<std::size_t> vertices_of(const std::vector<Polygon>& polygons, const std::vector<std::size_t>& faces)
{
  std::vector<std::size_t> used;
  for (std::size_t f : faces) used.insert(used.end(), polygons[f].begin(), polygons[f].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

std::size_t place_in(const std::vector<std::size_t>& sorted, std::size_t x)
{ return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), x) - sorted.begin()); }

} // namespace

std::vector<std::size_t> components(const Polygon_soup& s)
{
  Sets sets = joined_by_polygons(s);
  return numbered(sets, s);
}

std::vector<std::size_t> components_up_to_equal_points(const Polygon_soup& s)
{
  Sets sets = joined_by_polygons(s);
  const std::vector<char> may_join = has_boundary(s, sets);
  std::vector<std::size_t> points;
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if (may_join[v] && is_finite(s.points[v])) points.push_back(v);
  std::sort(points.begin(), points.end(), [&](std::size_t v, std::size_t w) { return s.points[v] < s.points[w]; });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (s.points[points[i]] == s.points[points[i - 1]]) sets.union_set(points[i], points[i - 1]);
  return numbered(sets, s);
}

std::vector<std::size_t> components(const Glued_triangles& s)
{
  const std::size_t n = s.triangles.size();
  Sets sets(n);
  for (std::size_t t = 0; t < n; ++t)
    for (const auto& [u, e] : s.opposite[t])
      if (u >= 0) sets.union_set(t, static_cast<std::size_t>(u));
  return numbered(sets, n, n, [](std::size_t t) { return t; });
}

std::vector<Polygon_soup> parts(const Polygon_soup& s, const std::vector<std::size_t>& component)
{
  std::vector<Polygon_soup> result;
  for (const std::vector<std::size_t>& faces : by_component(component)) {
    Polygon_soup& part = result.emplace_back();
    const std::vector<std::size_t> used = vertices_of(s.polygons, faces);
    for (std::size_t v : used) part.points.push_back(s.points[v]);
    for (std::size_t f : faces) {
      part.polygons.push_back(s.polygons[f]);
      for (std::size_t& v : part.polygons.back()) v = place_in(used, v);
    }
  }
  return result;
}

std::vector<Glued_triangles> parts(const Glued_triangles& s, const std::vector<std::size_t>& component)
{
  std::vector<Glued_triangles> result;
  for (const std::vector<std::size_t>& faces : by_component(component)) {
    Glued_triangles& part = result.emplace_back();
    const std::vector<std::size_t> used = vertices_of(s.triangles, faces);
    for (std::size_t f : faces) {
      part.triangles.push_back(s.triangles[f]);
      part.opposite.push_back(s.opposite[f]);
      part.lengths.push_back(s.lengths[f]);
      for (int& v : part.triangles.back()) v = static_cast<int>(place_in(used, static_cast<std::size_t>(v)));
      for (auto& [u, e] : part.opposite.back())
        if (u >= 0) u = static_cast<int>(place_in(faces, static_cast<std::size_t>(u)));
    }
  }
  return result;
}

std::size_t number_of_vertices(const Glued_triangles& s)
{
  int last = -1;
  for (const auto& t : s.triangles) last = std::max({last, t[0], t[1], t[2]});
  return static_cast<std::size_t>(last + 1);
}

} } // namespace CGAL::Quartic_differentials
