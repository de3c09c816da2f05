// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/linking_number.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <CGAL/box_intersection_d.h>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

struct Plane_segment { Exact_point_2 source, target; };

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;

std::vector<Plane_segment> projected(const std::vector<Exact_segment>& segments, const Projection& projection)
{
  std::vector<Plane_segment> result;
  result.reserve(segments.size());
  for (const Exact_segment& s : segments) result.push_back({projection(s.source), projection(s.target)});
  return result;
}

std::vector<Box> boxes(const std::vector<Plane_segment>& segments)
{
  std::vector<Box> result;
  result.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    result.emplace_back(segments[i].source.bbox() + segments[i].target.bbox(), i);
  return result;
}

enum class Contact { none, crossing, degenerate };

Contact contact(const Plane_segment& x, const Plane_segment& y)
{
  const int y0 = CGAL::orientation(x.source, x.target, y.source), y1 = CGAL::orientation(x.source, x.target, y.target);
  if (y0 * y1 > 0) return Contact::none;
  const int x0 = CGAL::orientation(y.source, y.target, x.source), x1 = CGAL::orientation(y.source, y.target, x.target);
  if (x0 * x1 > 0) return Contact::none;
  return y0 * y1 < 0 && x0 * x1 < 0 ? Contact::crossing : Contact::degenerate;
}

std::vector<Exact_segment> closed_polyline(const std::vector<Point_3>& points)
{
  std::vector<Exact_point_3> exact;
  for (const Point_3& p : points) exact.emplace_back(p.x(), p.y(), p.z());
  std::vector<Exact_segment> result;
  for (std::size_t i = 0; i < exact.size(); ++i) result.push_back({exact[i], exact[(i + 1) % exact.size()]});
  return result;
}

} // namespace

// Oblique directions without pattern, so that no symmetry of a surface makes many of them degenerate.
Projection::Projection(int k)
  : m_a((37 * k + 11) % 101 - 50), m_b((53 * k + 29) % 97 - 48), m_c(61 + (29 * k) % 43) {}

// (x, y, z) -> (c x - a z, c y - b z, z) preserves orientation and takes the direction (a, b, c) to the third axis.
Exact_point_2 Projection::operator()(const Exact_point_3& p) const
{
  return Exact_point_2(m_c * p.x() - m_a * p.z(), m_c * p.y() - m_b * p.z());
}

std::optional<std::vector<Crossing>>
crossings_over(const std::vector<Exact_segment>& lower, const std::vector<Exact_segment>& upper,
               const Projection& projection, const std::function<bool(std::size_t, std::size_t)>& ignore)
{
  const std::vector<Plane_segment> x = projected(lower, projection), y = projected(upper, projection);
  std::vector<Box> x_boxes = boxes(x), y_boxes = boxes(y);
  std::vector<Crossing> crossings;
  bool generic = true;
  const auto visit = [&](const Box& a, const Box& b) {
    const std::size_t i = a.info(), k = b.info();
    if (!generic || ignore(i, k)) return;
    const Contact c = contact(x[i], y[k]);
    if (c == Contact::none) return;
    // The handedness of two skew segments is the sign of their crossing, whichever of them is the upper one. That is
    // y if and only if, seen from above, y goes from the left of x to its right at a positive crossing.
    const int sign = CGAL::orientation(lower[i].source, lower[i].target, upper[k].source, upper[k].target);
    generic = c == Contact::crossing && sign != 0;
    if (generic && CGAL::orientation(x[i].source, x[i].target, y[k].source) == sign) crossings.push_back({i, k, sign});
  };
  CGAL::box_intersection_d(x_boxes.begin(), x_boxes.end(), y_boxes.begin(), y_boxes.end(), visit);
  if (!generic) return std::nullopt;
  return crossings;
}

int linking_number(const std::vector<Point_3>& x, const std::vector<Point_3>& y)
{
  const std::vector<Exact_segment> lower = closed_polyline(x), upper = closed_polyline(y);
  for (int k = 0; k < Projection::number; ++k)
    if (const auto crossings = crossings_over(lower, upper, Projection(k), [](auto, auto) { return false; })) {
      int sum = 0;
      for (const Crossing& c : *crossings) sum += c.sign;
      return sum;
    }
  throw Numerical_error("the linking number of two curves that meet is not defined");
}

} } } // namespace CGAL::Quartic_differentials::internal
