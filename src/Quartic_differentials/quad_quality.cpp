// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/quad_quality.h>

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/internal/Distance_sum.h>
#include <CGAL/Quartic_differentials/internal/Nearest_point.h>
#include <CGAL/Quartic_differentials/internal/Quad_shape.h>
#include <CGAL/Quartic_differentials/internal/aabb_tree.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Quad_corners = std::array<Point_3, 4>;

struct Spread_sum
{
  double      least = std::numeric_limits<double>::infinity(), most = -least, sum = 0;
  std::size_t number = 0;

  void add(double x)
  {
    least = std::min(least, x);
    most = std::max(most, x);
    sum += x;
    ++number;
  }
  double mean() const { return sum / static_cast<double>(number); }
  Quad_quality::Spread spread() const { return {least, mean(), most}; }
};

double degrees(double radians) { return radians * 180 / half_turn<double>(); }

// The angle at a corner in space, more than a half turn if the corner is seen as reflex along the quad's normal.
double angle_in_degrees(const Quad_corners& p, const internal::Quad_shape& shape, int k)
{
  const Vector_3 a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
  const double angle = std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), CGAL::scalar_product(a, b));
  return degrees(shape.sine[k] < 0 ? 2 * half_turn<double>() - angle : angle);
}

void measure_shapes(const Quad_mesh& m, Quad_quality& result)
{
  const std::vector<std::size_t> next = next_on_boundary(m);
  Spread_sum angle, deviation, edge_ratio, edge_length;
  for (std::size_t f = 0; f < m.quads.size(); ++f) {
    const Quad_corners p = m.corners(f);
    const internal::Quad_shape shape(p);
    for (int k = 0; k < 4; ++k) {
      angle.add(angle_in_degrees(p, shape, k));
      deviation.add(std::abs(angle_in_degrees(p, shape, k) - 90));
      const std::size_t v = m.quads[f][k], w = m.quads[f][(k + 1) % 4];
      if (v < w || next[v] == w) edge_length.add(shape.side[k]);   // or another quad has it reversed
    }
    edge_ratio.add(shape.edge_ratio());
  }
  result.angle = angle.spread();
  result.angle_deviation = deviation.mean();
  result.edge_ratio = edge_ratio.spread();
  result.edge_length = edge_length.spread();
}

// A point of the bilinear surface through the corners of a quad, and the area of that surface by that of (s, t) there.
struct Bilinear_point
{
  Point_3 point;
  double  area;

  Bilinear_point(const Quad_corners& p, double s, double t)
  {
    const Vector_3 u0 = p[1] - p[0], u1 = p[2] - p[3], v0 = p[3] - p[0], v1 = p[2] - p[1];
    point = p[0] + s * u0 + t * (v0 + s * (v1 - v0));
    area = std::sqrt(CGAL::cross_product(u0 + t * (u1 - u0), v0 + s * (v1 - v0)).squared_length());
  }
};

Surface_distance distance_to_input(const Intrinsic_triangulation& input, const Quad_mesh& m)
{
  const int parts = 4;   // by direction
  const internal::Nearest_point nearest(input);
  internal::Distance_sum distances;
  for (std::size_t f = 0; f < m.quads.size(); ++f) {
    Surface_point place = m.input_points[m.quads[f][0]];
    for (int i = 0; i < parts * parts; ++i) {
      const Bilinear_point sample(m.corners(f), (i % parts + 0.5) / parts, (i / parts + 0.5) / parts);
      place = nearest(sample.point, position_on_input(input, place), place.face);
      distances.add(CGAL::squared_distance(sample.point, position_on_input(input, place)), sample.area);
    }
  }
  return distances.by_diagonal(input.mesh());
}

Surface_distance distance_from_input(const Intrinsic_triangulation& input, const Quad_mesh& m)
{
  using Triangles = std::vector<internal::Aabb_kernel::Triangle_3>;
  Triangles triangles;
  for (std::size_t f = 0; f < m.quads.size(); ++f) {
    const Quad_corners p = m.corners(f);
    const Point_3 centre = Bilinear_point(p, 0.5, 0.5).point;
    for (int k = 0; k < 4; ++k) triangles.emplace_back(p[k], p[(k + 1) % 4], centre);
  }
  const internal::Triangle_tree<Triangles::const_iterator> tree(triangles.begin(), triangles.end());
  const std::vector<double> area = vertex_areas(input);
  internal::Distance_sum distances;
  for (Vertex v : input.mesh().vertices()) distances.add(tree.squared_distance(input.mesh().point(v)), area[v]);
  return distances.by_diagonal(input.mesh());
}

void count_irregular_vertices(const Quad_mesh& m, Quad_quality& result)
{
  const std::vector<std::size_t> next = next_on_boundary(m);
  std::vector<std::size_t> valence(m.points.size(), 0);
  for (const auto& quad : m.quads)
    for (std::size_t v : quad) ++valence[v];
  for (std::size_t v = 0; v < valence.size(); ++v) {
    const bool is_inside = next[v] == static_cast<std::size_t>(-1);
    if (valence[v] != (is_inside ? 4u : 2u)) ++(is_inside ? result.irregular_vertices : result.corners)[valence[v]];
  }
}

} // namespace

Quad_quality quad_quality(const Intrinsic_triangulation& input, const Quad_mesh& m)
{
  internal::require_embedded(input, "the distance of quads");
  Quad_quality result;
  result.scaled_jacobian = scaled_jacobian(m);
  measure_shapes(m, result);
  result.to_input = distance_to_input(input, m);
  result.from_input = distance_from_input(input, m);
  count_irregular_vertices(m, result);
  result.patches = std::set<std::size_t>(m.patch.begin(), m.patch.end()).size();
  return result;
}

} } // namespace CGAL::Quartic_differentials
