// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "picture_scenes.h"

#include "../internal/border_sides.h"

#include <CGAL/Quartic_differentials/internal/checkerboard.h>
#include <CGAL/Quartic_differentials/internal/diagonal.h>
#include <CGAL/Quartic_differentials/internal/different_colours.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Colour;
using internal::Scene;
using internal::diagonal;
using Polyline = std::vector<Point_3>;

// Colours that are told apart in print, light enough for lines on them.
const Colour patch_colours[] = {{0.72f, 0.84f, 0.95f}, {0.98f, 0.83f, 0.69f}, {0.79f, 0.91f, 0.74f},
                                {0.87f, 0.79f, 0.93f}, {0.98f, 0.93f, 0.68f}, {0.97f, 0.78f, 0.80f},
                                {0.69f, 0.89f, 0.87f}, {0.88f, 0.85f, 0.78f}};
const std::size_t number_of_patch_colours = std::size(patch_colours);

const Colour light_square{0.97f, 0.96f, 0.93f}, dark_square{0.40f, 0.52f, 0.68f};
const Colour plain{0.90f, 0.89f, 0.86f}, ink{0.13f, 0.14f, 0.18f}, soft_ink{0.38f, 0.39f, 0.44f};

// Widths and radii, as parts of the diagonal of the surface.
const double arc_width = 0.0030, border_width = 0.0024, edge_width = 0.0010, loop_width = 0.0100, ball_radius = 0.0095;

// Poles are red, the darker the higher their order; simple zeros blue, double ones green.
Colour singularity_colour(int order)
{
  if (order <= -3) return {0.45f, 0.05f, 0.15f};
  if (order == -2) return {0.96f, 0.55f, 0.10f};
  if (order == -1) return {0.86f, 0.16f, 0.14f};
  if (order == 0)  return {0.55f, 0.55f, 0.55f};
  if (order == 1)  return {0.13f, 0.36f, 0.80f};
  if (order == 2)  return {0.12f, 0.60f, 0.28f};
  return {0.05f, 0.62f, 0.68f};
}

Colour loop_colour(Drawn_loop::Kind kind)
{
  switch (kind) {
    case Drawn_loop::Kind::tunnel: return {0.95f, 0.60f, 0.10f};
    case Drawn_loop::Kind::handle: return {0.04f, 0.50f, 0.48f};
    default:                       return {0.50f, 0.30f, 0.62f};
  }
}

Scene surface_scene(std::vector<Point_3> points, std::vector<Triangle> triangles)
{
  Scene scene;
  scene.points = std::move(points);
  scene.triangles = std::move(triangles);
  scene.normals = internal::smooth_normals(scene.points, scene.triangles);
  return scene;
}

void add_singularities(Scene& scene, const std::vector<Marked_point>& singularities)
{
  const double radius = ball_radius * diagonal(scene.points);
  for (const Marked_point& s : singularities) scene.balls.push_back({s.point, radius, singularity_colour(s.order)});
}

void add_boundary(Scene& scene)
{
  const double width = border_width * diagonal(scene.points);
  for (const auto& [v, w] : internal::border_sides(scene.triangles))
    scene.lines.push_back({{scene.points[v], scene.points[w]}, width, ink, false});
}

double flat_area(const std::vector<std::array<Eigen::Vector2d, 3>>& uv)
{
  double doubled = 0;
  for (const auto& [a, b, c] : uv) {
    const Eigen::Vector2d ab = b - a, ac = c - a;
    doubled += ab.x() * ac.y() - ab.y() * ac.x();
  }
  return doubled / 2;
}

// A closed polyline along edges, for the eye without its zigzag: every point moves towards the middle of its
// neighbours, then a little farther back, which keeps the loop's size (Taubin 1995).
Polyline rounded(Polyline loop)
{
  if (loop.size() < 4) return loop;
  loop.pop_back();                              // the first point again
  const std::size_t n = loop.size();
  for (int i = 0; i < 10; ++i)
    for (double step : {0.5, -0.53}) {
      const Polyline old = loop;
      for (std::size_t k = 0; k < n; ++k)
        loop[k] = old[k] + step * (CGAL::midpoint(old[(k + 1) % n], old[(k + n - 1) % n]) - old[k]);
    }
  loop.push_back(loop.front());
  return loop;
}

std::size_t number_of_patches(const std::vector<std::size_t>& patch, const Neighbours& neighbours)
{
  std::size_t n = 0;
  for (std::size_t p : patch) n = std::max(n, p + 1);
  for (const auto& [p, q] : neighbours) n = std::max({n, p + 1, q + 1});
  return n;
}

// a width for the edges of a mesh, of which there may be many
double thin_width(const std::vector<Point_3>& points, const std::vector<Polyline>& edges)
{
  double length = 0;
  for (const Polyline& edge : edges) length += std::sqrt(CGAL::squared_distance(edge.front(), edge.back()));
  return std::min(edge_width * diagonal(points), 0.1 * length / static_cast<double>(edges.size()));
}

} // namespace

Scene checkerboard_scene(std::vector<Point_3> points, std::vector<Triangle> triangles,
                         std::vector<std::array<Eigen::Vector2d, 3>> uv, const std::vector<Marked_point>& singularities)
{
  Scene scene = surface_scene(std::move(points), std::move(triangles));
  const int squares = internal::checkerboard_squares_per_unit(flat_area(uv));
  scene.uv = std::move(uv);
  scene.texture = [squares](const Eigen::Vector2d& z) {
    return internal::is_light_square(squares * z.x(), squares * z.y()) ? light_square : dark_square;
  };
  add_boundary(scene);
  add_singularities(scene, singularities);
  return scene;
}

Scene patches_scene(std::vector<Point_3> points, const std::vector<std::vector<std::size_t>>& polygons,
                    const std::vector<std::size_t>& patch, const Neighbours& neighbours,
                    const std::vector<Polyline>& arcs, const std::vector<Marked_point>& singularities)
{
  const std::vector<std::size_t> colour =
    internal::different_colours(number_of_patches(patch, neighbours), number_of_patch_colours, neighbours);
  std::vector<Triangle> triangles;
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (std::size_t k = 1; k + 1 < polygons[i].size(); ++k) {
      triangles.push_back({polygons[i][0], polygons[i][k], polygons[i][k + 1]});
      colours.push_back(patch_colours[colour[patch[i]]]);
    }
  Scene scene = surface_scene(std::move(points), std::move(triangles));
  scene.colours = std::move(colours);
  const double size = diagonal(scene.points);
  for (const Polyline& arc : arcs) scene.lines.push_back({arc, arc_width * size, ink, false});
  add_singularities(scene, singularities);
  return scene;
}

Scene quads_scene(std::vector<Point_3> points, const std::vector<std::array<std::size_t, 4>>& quads,
                  const std::vector<std::size_t>& patch, const std::vector<Marked_point>& singularities)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> sides;   // by edge: the patches beside it
  for (std::size_t i = 0; i < quads.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) sides[std::minmax(quads[i][k], quads[i][(k + 1) % 4])].push_back(patch[i]);
  Neighbours neighbours;
  for (const auto& [edge, beside] : sides) neighbours.insert({beside.front(), beside.back()});

  std::vector<Polyline> borders, inner, all;
  for (const auto& [edge, beside] : sides) {
    all.push_back({points[edge.first], points[edge.second]});
    const bool is_inner = beside.size() == 2 && beside.front() == beside.back();
    (is_inner ? inner : borders).push_back(all.back());
  }
  const double thin = thin_width(points, all);

  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& quad : quads) polygons.emplace_back(quad.begin(), quad.end());
  Scene scene = patches_scene(std::move(points), polygons, patch, neighbours, {}, singularities);
  for (Colour& colour : scene.colours) colour = 0.7f * colour + 0.3f;     // paler than the lines
  for (Polyline& edge : inner) scene.lines.push_back({std::move(edge), thin, soft_ink, false});
  for (Polyline& edge : borders) scene.lines.push_back({std::move(edge), border_width / edge_width * thin, ink, false});
  return scene;
}

Scene wireframe_scene(std::vector<Point_3> points, std::vector<Triangle> triangles,
                      const std::vector<Marked_point>& singularities)
{
  std::vector<Polyline> edges;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k)
      if (t[k] < t[(k + 1) % 3]) edges.push_back({points[t[k]], points[t[(k + 1) % 3]]});   // of two triangles: once
  Scene scene = surface_scene(std::move(points), std::move(triangles));
  scene.colours.assign(scene.triangles.size(), plain);
  const double thin = thin_width(scene.points, edges);
  for (Polyline& edge : edges) scene.lines.push_back({std::move(edge), thin, soft_ink, false});
  add_boundary(scene);
  add_singularities(scene, singularities);
  return scene;
}

Scene loops_scene(std::vector<Point_3> points, std::vector<Triangle> triangles, const std::vector<Drawn_loop>& loops,
                  const std::vector<Marked_point>& singularities)
{
  Scene scene = surface_scene(std::move(points), std::move(triangles));
  scene.colours.assign(scene.triangles.size(), plain);
  const double size = diagonal(scene.points);
  add_boundary(scene);
  for (const Drawn_loop& loop : loops)
    scene.lines.push_back({rounded(loop.points), loop_width * size, loop_colour(loop.kind), true});
  add_singularities(scene, singularities);
  return scene;
}

} } // namespace CGAL::Quartic_differentials
