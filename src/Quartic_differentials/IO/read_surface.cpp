// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Polygon_soup.h"
#include "surface_components.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/IO/surface_json.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const std::size_t none = std::numeric_limits<std::size_t>::max();

// A side of a polygon: the corners `corner` and `corner` + 1 of `face`.
struct Side
{
  std::size_t face = none, corner = 0;
};

bool is_border(Side opposite) { return opposite.face == none; }

std::string text(const Point_3& p)
{
  std::ostringstream out;
  out.precision(9);
  out << '(' << p.x() << ", " << p.y() << ", " << p.z() << ')';
  return out.str();
}

std::string vertex_text(const Polygon_soup& s, std::size_t v)
{
  return "vertex " + std::to_string(v) + " at " + text(s.points[v]);
}

std::string face_text(const Polygon_soup& s, std::size_t f)
{
  return "face " + std::to_string(f) + " at " + text(s.points[s.polygons[f][0]]);
}

std::size_t from(const Polygon_soup& s, Side x) { return s.polygons[x.face][x.corner]; }
std::size_t to(const Polygon_soup& s, Side x)
{
  const auto& p = s.polygons[x.face];
  return p[(x.corner + 1) % p.size()];
}

// both ends of the edge, the smaller index first
std::pair<std::size_t, std::size_t> ends(const Polygon_soup& s, Side x)
{
  return {std::min(from(s, x), to(s, x)), std::max(from(s, x), to(s, x))};
}

std::string edge_text(const Polygon_soup& s, Side x)
{
  const auto [v, w] = ends(s, x);
  return "edge from " + vertex_text(s, v) + " to " + vertex_text(s, w);
}

// all sides, those of the same edge next to each other
std::vector<Side> sides_by_edge(const Polygon_soup& s)
{
  std::vector<Side> sides;
  for (std::size_t f = 0; f < s.polygons.size(); ++f)
    for (std::size_t c = 0; c < s.polygons[f].size(); ++c) sides.push_back({f, c});
  std::stable_sort(sides.begin(), sides.end(), [&](Side x, Side y) { return ends(s, x) < ends(s, y); });
  return sides;
}

// calls action(first, n) for the sides first, ..., first + n - 1 of every edge
template <class Action>
void for_each_edge(const Polygon_soup& s, const std::vector<Side>& sides, Action action)
{
  for (std::size_t i = 0, n; i < sides.size(); i += n) {
    n = 1;
    while (i + n < sides.size() && ends(s, sides[i + n]) == ends(s, sides[i])) ++n;
    action(&sides[i], n);
  }
}

bool has_boundary(const Polygon_soup& s)
{
  bool found = false;
  for_each_edge(s, sides_by_edge(s), [&](const Side*, std::size_t n) { found = found || n == 1; });
  return found;
}

void check_coordinates(const Polygon_soup& s)
{
  for (std::size_t v = 0; v < s.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(s.points[v][i]))
        throw Unusable_surface_error(vertex_text(s, v) + " has a coordinate that is not finite");
}

void check_corners(const Polygon_soup& s)
{
  if (s.points.empty() || s.polygons.empty()) throw Unusable_surface_error("the surface has no face");
  for (std::size_t f = 0; f < s.polygons.size(); ++f) {
    const auto& p = s.polygons[f];
    for (std::size_t v : p)
      if (v >= s.points.size())
        throw Unusable_surface_error("face " + std::to_string(f) + " refers to a vertex that does not exist: there are "
                                     + std::to_string(s.points.size()));
    if (p.size() < 3) throw Unusable_surface_error("face " + std::to_string(f) + " has fewer than three corners");
  }
}

// Vertices at exactly equal points become the first of them.
void merge_equal_points(Polygon_soup& s, std::vector<std::string>& notes)
{
  std::vector<std::size_t> order(s.points.size()), representative(s.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t v, std::size_t w) {
    return s.points[v] == s.points[w] ? v < w : s.points[v] < s.points[w];
  });
  std::size_t merged = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeated = i > 0 && s.points[order[i]] == s.points[order[i - 1]];
    representative[order[i]] = repeated ? representative[order[i - 1]] : order[i];
    merged += repeated;
  }
  if (merged == 0) return;
  for (auto& p : s.polygons)
    for (std::size_t& v : p) v = representative[v];
  notes.push_back(std::to_string(merged) + " vertices had the same coordinates as an earlier one and were merged with it");
}

void check_faces(const Polygon_soup& s)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto exact = [&](std::size_t v) { return Kernel::Point_3(s.points[v].x(), s.points[v].y(), s.points[v].z()); };
  std::vector<std::pair<std::vector<std::size_t>, std::size_t>> sorted;
  for (std::size_t f = 0; f < s.polygons.size(); ++f) {
    const auto& p = s.polygons[f];
    sorted.emplace_back(p, f);
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
    const auto twice = std::adjacent_find(sorted.back().first.begin(), sorted.back().first.end());
    if (twice != sorted.back().first.end())
      throw Unusable_surface_error(face_text(s, f) + " is degenerate: it has " + vertex_text(s, *twice) + " twice");
    if (p.size() == 3 && CGAL::collinear(exact(p[0]), exact(p[1]), exact(p[2])))
      throw Unusable_surface_error(face_text(s, f) + " has no area: its corners lie on a line");
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      throw Unusable_surface_error(face_text(s, sorted[i].second) + " has the same corners as face "
                                   + std::to_string(sorted[i - 1].second));
}

// The side that each side is glued to, on the boundary none, if the polygons form an oriented surface edge by edge.
std::vector<std::vector<Side>> glue(const Polygon_soup& s)
{
  std::vector<std::vector<Side>> opposite;
  for (const auto& p : s.polygons) opposite.emplace_back(p.size());
  const std::vector<Side> sides = sides_by_edge(s);
  for_each_edge(s, sides, [&](const Side* x, std::size_t n) {
    if (n > 2) throw Unusable_surface_error("the " + edge_text(s, x[0]) + " has " + std::to_string(n) + " faces");
    if (n == 2 && from(s, x[0]) == from(s, x[1]))
      throw Unusable_surface_error("the faces " + std::to_string(x[0].face) + " and " + std::to_string(x[1].face)
        + " are oriented against each other at the " + edge_text(s, x[0]));
  });
  for_each_edge(s, sides, [&](const Side* x, std::size_t n) {
    if (n == 1) return;
    opposite[x[0].face][x[0].corner] = x[1];
    opposite[x[1].face][x[1].corner] = x[0];
  });
  return opposite;
}

// the number of faces one meets when going round the beginning of a side: in a circle, or on both hands to the boundary
std::size_t faces_around(const Polygon_soup& s, const std::vector<std::vector<Side>>& opposite, Side leaving)
{
  const auto across = [&](Side x) { return opposite[x.face][x.corner]; };
  std::size_t n = 1;
  for (Side x = across(leaving); !is_border(x); x = across(x)) {   // comes into the vertex ...
    x.corner = (x.corner + 1) % s.polygons[x.face].size();         // ... and the next side of that face leaves it
    if (x.face == leaving.face && x.corner == leaving.corner) return n;
    ++n;
  }
  const auto entering = [&](Side x) {
    const std::size_t size = s.polygons[x.face].size();
    return Side{x.face, (x.corner + size - 1) % size};
  };
  for (Side x = across(entering(leaving)); !is_border(x); x = across(entering(x))) ++n;
  return n;
}

// The faces at every vertex must form one circle, or one fan on the boundary.
void check_vertices(const Polygon_soup& s, const std::vector<std::vector<Side>>& opposite)
{
  std::vector<std::size_t> corners(s.points.size(), 0);
  for (const auto& p : s.polygons)
    for (std::size_t v : p) ++corners[v];
  std::vector<bool> visited(s.points.size(), false);
  for (std::size_t f = 0; f < s.polygons.size(); ++f)
    for (std::size_t c = 0; c < s.polygons[f].size(); ++c) {
      const std::size_t v = s.polygons[f][c];
      if (visited[v]) continue;
      visited[v] = true;
      if (faces_around(s, opposite, {f, c}) < corners[v])
        throw Unusable_surface_error("the faces at " + vertex_text(s, v) + " form more than one fan");
    }
}

// \param component of every face
template <class Place>
void check_connected(const std::vector<std::size_t>& component, Place place)
{
  const auto second = std::find(component.begin(), component.end(), 1u);
  if (second == component.end()) return;
  const std::size_t count = *std::max_element(component.begin(), component.end()) + 1;
  throw Unusable_surface_error("the surface has " + std::to_string(count) + " components: "
                               + place(second - component.begin()) + " is not connected with the first face; "
                               "`quartic run --components each` runs them one by one");
}

void drop_unused_vertices(Polygon_soup& s, std::vector<std::string>& notes)
{
  std::vector<std::size_t> new_index(s.points.size(), 0);
  for (const auto& p : s.polygons)
    for (std::size_t v : p) new_index[v] = 1;
  std::vector<Point_3> used;
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if (new_index[v] == 1) {
      new_index[v] = used.size();
      used.push_back(s.points[v]);
    }
  if (used.size() == s.points.size()) return;
  for (auto& p : s.polygons)
    for (std::size_t& v : p) v = new_index[v];
  notes.push_back(std::to_string(s.points.size() - used.size()) + " vertices belonged to no face and were dropped");
  s.points = std::move(used);
}

Mesh triangle_mesh(const Polygon_soup& s, std::vector<std::string>& notes)
{
  Mesh mesh;
  for (const Point_3& p : s.points) mesh.add_vertex(p);
  std::size_t polygons = 0;
  for (const auto& p : s.polygons) {
    std::vector<Vertex> corners;
    for (std::size_t v : p) corners.push_back(Vertex(static_cast<Mesh::size_type>(v)));
    mesh.add_face(corners);
    if (p.size() > 3) ++polygons;
  }
  if (polygons == 0) return mesh;
  for (std::size_t f = 0; f < s.polygons.size(); ++f)
    if (s.polygons[f].size() > 3
        && !CGAL::Polygon_mesh_processing::triangulate_face(Face(static_cast<Mesh::size_type>(f)), mesh))
      throw Unusable_surface_error(face_text(s, f) + " is a polygon that cannot be triangulated");
  notes.push_back(std::to_string(polygons) + " faces with more than three corners were triangulated");
  return mesh;
}

std::string triangle_text(const Intrinsic_triangulation& t, Face f)
{
  if (!t.is_embedded()) return "triangle " + std::to_string(f.idx());
  const auto h = t.halfedges(f);
  return "triangle " + text(t.mesh().point(t.source(h[0]))) + ", " + text(t.mesh().point(t.source(h[1]))) + ", "
       + text(t.mesh().point(t.source(h[2])));
}

// Products of four lengths must be far from the greatest and the least double, and make triangles with an area.
void check_lengths(const Intrinsic_triangulation& t)
{
  const double most = 1e40, least = 1e-40, longest = *std::max_element(t.lengths().begin(), t.lengths().end());
  if (!(longest >= least && longest <= most))
    throw Unusable_surface_error("its longest edge has the length " + internal::scientific(longest) + "; please choose"
      " another unit of length, in which that is between " + internal::scientific(least) + " and "
      + internal::scientific(most));
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    if (!(four_times_area(t.length(h[0]), t.length(h[1]), t.length(h[2])) > 0))
      throw Unusable_surface_error("the " + triangle_text(t, f) + " has no area in double precision");
  }
}

double six_times_volume(const Intrinsic_triangulation& t)
{
  double sum = 0;
  const Point_3 origin = t.mesh().point(Vertex(0));
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    sum += CGAL::determinant(t.mesh().point(t.source(h[0])) - origin, t.mesh().point(t.source(h[1])) - origin,
                             t.mesh().point(t.source(h[2])) - origin);
  }
  return sum;
}

Intrinsic_triangulation embedded_surface(Polygon_soup s, std::vector<std::string>& notes)
{
  check_corners(s);
  check_coordinates(s);
  if (has_boundary(s)) merge_equal_points(s, notes);
  check_faces(s);
  const auto opposite = glue(s);
  check_vertices(s, opposite);
  check_connected(components(s), [&](std::size_t f) { return vertex_text(s, s.polygons[f][0]); });
  drop_unused_vertices(s, notes);
  Intrinsic_triangulation t(triangle_mesh(s, notes));
  check_lengths(t);
  if (!t.has_boundary() && six_times_volume(t) < 0)
    notes.push_back("the surface is inside-out (its volume is negative); it is used as it is");
  return t;
}

Intrinsic_triangulation glued_surface(const Glued_triangles& s)
{
  Intrinsic_triangulation t(s);
  check_connected(components(s), [&](std::size_t f) { return "vertex " + std::to_string(s.triangles[f][0]); });
  check_lengths(t);
  return t;
}

std::string contents_of(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path, error)) throw Unusable_surface_error("the file does not exist");
  if (!fs::is_regular_file(path, error)) throw Unusable_surface_error("it is not a regular file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Unusable_surface_error("the file cannot be read");
  std::string contents{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) throw Unusable_surface_error("the file cannot be read");
  if (contents.empty()) throw Unusable_surface_error("the file is empty");
  return contents;
}

std::string format_of(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* known : {".off", ".obj", ".ply", ".stl", ".vtp", ".json"})
    if (extension == known) return extension.substr(1);
  throw Unusable_surface_error("the extension '" + extension + "' is not one of .off, .obj, .ply, .stl, .vtp, .json");
}

// A part by itself, used if it can be.
template <class Read>
Surface_component component(std::size_t vertices, std::size_t faces, Read read)
{
  Surface_component c;
  c.vertices = vertices;
  c.faces = faces;
  try { c.surface = read(c.notes); }
  catch (const Unusable_surface_error& e) { c.refusal = e.what(); }
  return c;
}

std::vector<Surface_component> glued_components(const Glued_triangles& s)
{
  if (s.triangles.empty()) throw Unusable_surface_error("the surface has no triangle");
  std::vector<Surface_component> result;
  for (const Glued_triangles& part : parts(s, components(s)))
    result.push_back(component(number_of_vertices(part), part.triangles.size(),
                               [&](auto&) { return glued_surface(part); }));
  return result;
}

std::vector<Surface_component> embedded_components(const Polygon_soup& s)
{
  check_corners(s);
  std::vector<Surface_component> result;
  for (Polygon_soup& part : parts(s, components_up_to_equal_points(s)))
    result.push_back(component(part.points.size(), part.polygons.size(),
                               [&](auto& notes) { return embedded_surface(std::move(part), notes); }));
  return result;
}

// Calls action(contents, format) for a file; what it refuses is said with the file's name.
template <class Action>
auto with_contents_of(const std::string& path, Action action)
{
  try {
    std::string contents = contents_of(path);
    return action(std::move(contents), format_of(path));
  } catch (const Unusable_surface_error& e) {
    throw Unusable_surface_error(path + ": " + e.what());
  }
}

} // namespace

Intrinsic_triangulation read_surface(const std::string& path, std::vector<std::string>& notes)
{
  return with_contents_of(path, [&](std::string contents, const std::string& format) {
    if (format == "json") return glued_surface(read_surface_json(contents));
    return embedded_surface(parse_polygon_soup(std::move(contents), format), notes);
  });
}

std::vector<Surface_component> read_surface_components(const std::string& path)
{
  std::vector<Surface_component> result = with_contents_of(path, [](std::string contents, const std::string& format) {
    if (format == "json") return glued_components(read_surface_json(contents));
    return embedded_components(parse_polygon_soup(std::move(contents), format));
  });
  std::stable_sort(result.begin(), result.end(),
                   [](const Surface_component& a, const Surface_component& b) { return a.faces > b.faces; });
  return result;
}

} } // namespace CGAL::Quartic_differentials
