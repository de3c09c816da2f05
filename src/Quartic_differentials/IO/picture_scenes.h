// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PICTURE_SCENES_H
#define CGAL_QUARTIC_DIFFERENTIALS_PICTURE_SCENES_H

#include <CGAL/Quartic_differentials/internal/render.h>

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// How the results of a run look, from the least that is needed to draw them. A boundary is a line.

using Triangle  = std::array<std::size_t, 3>;
using Neighbours = std::set<std::pair<std::size_t, std::size_t>>;   // pairs of patches

struct Marked_point
{
  Point_3 point;
  int     order;
};

struct Drawn_loop
{
  std::vector<Point_3> points;
  enum class Kind { tunnel, handle, unknown } kind;
};

/// the surface and its charts, with about 2500 squares
internal::Scene checkerboard_scene(std::vector<Point_3> points, std::vector<Triangle> triangles,
                                   std::vector<std::array<Eigen::Vector2d, 3>> uv,
                                   const std::vector<Marked_point>& singularities);

/// convex polygons that lie in patches, and the arcs between these
internal::Scene patches_scene(std::vector<Point_3> points, const std::vector<std::vector<std::size_t>>& polygons,
                              const std::vector<std::size_t>& patch, const Neighbours& neighbours,
                              const std::vector<std::vector<Point_3>>& arcs,
                              const std::vector<Marked_point>& singularities);

/// \param patch by quad
internal::Scene quads_scene(std::vector<Point_3> points, const std::vector<std::array<std::size_t, 4>>& quads,
                            const std::vector<std::size_t>& patch, const std::vector<Marked_point>& singularities);

/// a surface with all its edges
internal::Scene wireframe_scene(std::vector<Point_3> points, std::vector<Triangle> triangles,
                                const std::vector<Marked_point>& singularities);

internal::Scene loops_scene(std::vector<Point_3> points, std::vector<Triangle> triangles,
                            const std::vector<Drawn_loop>& loops, const std::vector<Marked_point>& singularities);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_PICTURE_SCENES_H
