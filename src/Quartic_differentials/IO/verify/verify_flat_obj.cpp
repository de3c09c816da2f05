// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "on_input.h"
#include "verify_flat_obj.h"

#include <CGAL/Quartic_differentials/internal/read_obj.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

namespace {

using internal::scientific;

// The triangles of flat.obj, and its points in space.
struct Flat_obj
{
  Flat                  flat;
  std::vector<Position> points;
};

// a texture coordinate, in units of 2^-exponent
std::int64_t grid_coordinate(double x, int exponent)
{
  const double scaled = std::ldexp(x, exponent);
  if (!(std::abs(scaled) <= std::ldexp(1.0, 60)) || scaled != std::floor(scaled))
    throw Malformed("a texture coordinate is not on the grid of 2^-" + std::to_string(exponent));
  return static_cast<std::int64_t>(scaled);
}

// Glues triangles that share two vertices in opposite directions; returns whether no edge found more than one partner,
// and all found one if the surface is closed.
bool glue(std::vector<Flat_triangle>& triangles, bool is_closed)
{
  std::vector<std::tuple<std::int64_t, std::int64_t, std::int64_t, int>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      edges.emplace_back(triangles[t].vertex[k], triangles[t].vertex[(k + 1) % 3], static_cast<std::int64_t>(t), k);
  std::sort(edges.begin(), edges.end());
  const auto has_ends = [&](auto edge, std::int64_t from, std::int64_t to) {
    return edge != edges.end() && std::get<0>(*edge) == from && std::get<1>(*edge) == to;
  };
  for (auto edge = edges.begin(); edge != edges.end(); ++edge) {
    const auto& [from, to, t, k] = *edge;
    if (has_ends(std::next(edge), from, to)) return false;
    const auto partner = std::lower_bound(edges.begin(), edges.end(), std::make_tuple(to, from, std::int64_t(-1), -1));
    if (has_ends(partner, to, from)) triangles[t].opposite[k] = {std::get<2>(*partner), std::get<3>(*partner)};
    else if (is_closed) return false;
  }
  return true;
}

Flat_obj read_flat_obj(const std::string& folder, int grid_exponent)
{
  const internal::Obj_file file = internal::read_obj(folder + "/flat.obj");
  Flat_obj obj;
  obj.flat.grid_exponent = grid_exponent;
  obj.flat.is_embedded = true;
  for (const Point_3& p : file.points) obj.points.push_back({p.x(), p.y(), p.z()});
  std::vector<Point> texture;
  for (const auto& [u, v] : file.texture)
    texture.push_back({grid_coordinate(u, grid_exponent), grid_coordinate(v, grid_exponent)});
  for (const internal::Obj_file::Element& face : file.faces) {
    if (face.vertices.size() != 3) throw Malformed("a face is not a triangle");
    if (face.texture.size() != 3) throw Malformed("a corner of a face has no texture vertex");
    Flat_triangle& f = obj.flat.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      f.vertex[k] = static_cast<std::int64_t>(face.vertices[k]);
      f.point[k] = texture[face.texture[k]];
    }
  }
  if (obj.flat.triangles.empty()) throw Malformed("there is no triangle");
  return obj;
}

// The boundary lies on that of the input and covers it.
void verify_boundary_on_input(const Flat_obj& obj, const Mesh& input, double size, Checks& checks)
{
  const Segments expected = boundary_of(input);
  Segments segments;
  std::vector<Point_3> points;
  for (const Flat_triangle& f : obj.flat.triangles)
    for (int k = 0; k < 3; ++k) {
      if (!f.is_border(k)) continue;
      const Point_3 from = point_3(obj.points[f.vertex[k]]), to = point_3(obj.points[f.vertex[(k + 1) % 3]]);
      segments.emplace_back(from, to);
      points.insert(points.end(), {from, CGAL::midpoint(from, to)});
    }
  const bool both = !expected.empty() && !segments.empty();
  const double farthest = both ? farthest_from(expected, points) : 0, length = total_length(expected);
  checks.push_back({both && farthest <= 1e-12 * size, "flat.obj: its boundary lies on the input's, within "
                                                    + scientific(farthest / size) + " of its diagonal"});
  checks.push_back({both && std::abs(total_length(segments) - length) <= 1e-9 * length,
                    "flat.obj: its boundary is as long as the input's"});
}

// The triangles lie on the input and cover it.
void verify_on_input(const Flat_obj& obj, const Mesh& input, Checks& checks)
{
  std::size_t moved = 0;
  const std::size_t n = std::min<std::size_t>(obj.points.size(), input.number_of_vertices());
  for (std::size_t v = 0; v < n; ++v)
    if (input.point(Vertex(static_cast<Mesh::size_type>(v))) != point_3(obj.points[v])) ++moved;
  moved += input.number_of_vertices() - n;
  checks.push_back({moved == 0, "flat.obj: " + std::to_string(moved) + " of "
                              + std::to_string(input.number_of_vertices())
                              + " vertices of the input are missing or have moved (exact)"});

  const Surface_tree tree(input.faces().begin(), input.faces().end(), input);
  const double size = diagonal(tree.bbox());
  double farthest = 0, area = 0, input_area = 0;
  const auto look = [&](const Point_3& p) { farthest = std::max(farthest, std::sqrt(tree.squared_distance(p))); };
  for (std::size_t v = n; v < obj.points.size(); ++v) look(point_3(obj.points[v]));
  for (const Flat_triangle& f : obj.flat.triangles) {
    const Point_3 a = point_3(obj.points[f.vertex[0]]), b = point_3(obj.points[f.vertex[1]]),
                  c = point_3(obj.points[f.vertex[2]]);
    look(CGAL::centroid(a, b, c));
    area += std::sqrt(CGAL::squared_area(a, b, c));
  }
  for (Face f : input.faces()) {
    const Halfedge h = input.halfedge(f);
    input_area += std::sqrt(CGAL::squared_area(input.point(input.source(h)), input.point(input.target(h)),
                                               input.point(input.target(input.next(h)))));
  }
  checks.push_back({farthest <= 1e-12 * size, "flat.obj: lies on the input, within " + scientific(farthest / size)
                                            + " of its diagonal"});
  checks.push_back({std::abs(area - input_area) <= 1e-9 * input_area,
                    "flat.obj: covers the input's area up to " + scientific(std::abs(area - input_area) / input_area)});
  if (number_of_border_edges(obj.flat) > 0 || !CGAL::is_closed(input))
    verify_boundary_on_input(obj, input, size, checks);
}

} // namespace

void verify_flat_obj(const std::string& folder, const Flat_facts& flat, const Report& report, const Mesh* input,
                     Checks& checks)
{
  Flat_obj obj = read_flat_obj(folder, flat.grid_exponent);
  const bool glued = glue(obj.flat.triangles, report.is_closed());
  const std::string shared = report.is_closed() ? "every edge is shared by two triangles"
                                                : "no edge is shared by more than two triangles";
  checks.push_back({glued, "flat.obj: " + shared + ", in opposite directions"});
  if (!glued) return;
  const Flat_facts facts = verify_flat("flat.obj", obj.flat, report, checks);
  checks.push_back({facts.doubled_area == flat.doubled_area, "flat.obj: exactly the area of the flat triangulation"});
  if (input != nullptr) verify_on_input(obj, *input, checks);
}

} } } // namespace CGAL::Quartic_differentials::verification
