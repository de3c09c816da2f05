// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/render.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

using Vector = Eigen::Vector3d;
using Triangle = std::array<std::size_t, 3>;

const int    samples_per_side = 4;        // of a pixel
const int    rows_at_once = 8;            // pixels; their samples fit into the cache
const double margin = 0.02;               // of the longer side
const double stripe_pull = 3;             // radii by which a primitive is pulled towards the eye
const double tube_pull = 1;
const double ball_pull = 0.5;
const double crease_cosine = 0.5;         // of 60 degrees

Vector vector(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

// ---- Light

// How bright something white is: most light comes from the eye, more from the upper left, some from everywhere.
// \param normal in the coordinates of the camera
Colour lit(const Colour& colour, const Vector& normal)
{
  static const Vector upper_left = Vector(-0.5, 0.65, 0.75).normalized(),
                      half_way = (upper_left + Vector::UnitZ()).normalized();
  const double length = normal.norm();
  if (!(length > 0)) return colour;
  const Vector n = (normal.z() < 0 ? -1 : 1) / length * normal;
  const double diffuse = 0.46 + 0.33 * n.z() + 0.29 * std::max(0.0, n.dot(upper_left));
  const double c = std::max(0.0, n.dot(half_way)), c4 = c * c * c * c, c16 = c4 * c4 * c4 * c4;
  const double glossy = 0.10 * c16 * c16;
  return (colour * static_cast<float>(diffuse) + static_cast<float>(glossy)).min(1.0f);
}

// ---- From space to the samples of a picture

// The camera, scaled and moved so that one unit is one sample, with y downward and z towards the eye.
class Projection
{
public:
  Projection(const Scene& scene, const Camera& camera, int size) : m_camera(camera)
  {
    for (const Point_3& p : scene.points) include(camera(p), 0);
    for (const Scene::Line& l : scene.lines)
      for (const Point_3& p : l.points) include(camera(p), l.width / 2);
    for (const Scene::Ball& b : scene.balls) include(camera(b.centre), b.radius);
    const Eigen::Vector2d extent = m_high - m_low;
    m_scale = (1 - 2 * margin) * size / std::max(extent.maxCoeff(), std::numeric_limits<double>::min());
    m_width  = pixels(extent.x(), size);
    m_height = pixels(extent.y(), size);
    m_scale *= samples_per_side;
  }

  int width() const { return m_width; }
  int height() const { return m_height; }
  double scale() const { return m_scale; }

  Vector operator()(const Point_3& p) const
  {
    const Vector q = m_camera(p);
    const Eigen::Vector2d centre = (m_low + m_high) / 2;
    return {m_width  * samples_per_side / 2.0 + m_scale * (q.x() - centre.x()),
            m_height * samples_per_side / 2.0 - m_scale * (q.y() - centre.y()), m_scale * q.z()};
  }
  Vector direction(const Vector& v) const
  { return {m_camera.right.dot(v), m_camera.up.dot(v), m_camera.towards_eye.dot(v)}; }

private:
  void include(const Vector& q, double radius)
  {
    m_low  = m_low.cwiseMin(q.head<2>() - Eigen::Vector2d::Constant(radius));
    m_high = m_high.cwiseMax(q.head<2>() + Eigen::Vector2d::Constant(radius));
  }
  int pixels(double extent, int size) const
  { return std::min(size, static_cast<int>(std::ceil(extent * m_scale + 2 * margin * size))); }

  Camera          m_camera;
  Eigen::Vector2d m_low  = Eigen::Vector2d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector2d m_high = -m_low;
  double          m_scale = 1;
  int             m_width = 0, m_height = 0;
};

// ---- What is visible

const std::uint32_t background = std::numeric_limits<std::uint32_t>::max();

struct Sample
{
  float         depth = std::numeric_limits<float>::lowest();
  std::uint32_t primitive = background;
};

struct Box { double left, right, top, bottom; };

Box box_of(const Vector& a, const Vector& b, double radius)
{
  return {std::min(a.x(), b.x()) - radius, std::max(a.x(), b.x()) + radius,
          std::min(a.y(), b.y()) - radius, std::max(a.y(), b.y()) + radius};
}

// Some rows of samples of a picture, and which primitive is seen there.
class Rows
{
public:
  Rows(int width, int first, int last)
    : m_width(width), m_first(first), m_last(last), m_samples(static_cast<std::size_t>(width) * (last - first))
  {}

  const Sample& at(int x, int y) const { return m_samples[static_cast<std::size_t>(y - m_first) * m_width + x]; }

  /// draws a primitive: shape.depth(x, y) is asked for at the samples' centres in the box, not a number where it is not
  template <class Shape>
  void draw(std::uint32_t primitive, const Box& box, const Shape& shape)
  {
    const auto bounded = [](double x, int low, int high)
    { return static_cast<int>(std::clamp(x, static_cast<double>(low), static_cast<double>(high))); };
    const int x0 = bounded(std::ceil(box.left - 0.5), 0, m_width),
              y0 = bounded(std::ceil(box.top - 0.5), m_first, m_last),
              x1 = bounded(std::floor(box.right + 0.5), 0, m_width),
              y1 = bounded(std::floor(box.bottom + 0.5), m_first, m_last);
    for (int y = y0; y < y1; ++y) {
      Sample* row = m_samples.data() + static_cast<std::size_t>(y - m_first) * m_width;
      for (int x = x0; x < x1; ++x) {
        const float z = static_cast<float>(shape.depth(x + 0.5, y + 0.5));
        if (z > row[x].depth) row[x] = {z, primitive};
      }
    }
  }

private:
  int                 m_width, m_first, m_last;
  std::vector<Sample> m_samples;
};

// the centres of samples of one pixel
using Samples = boost::container::static_vector<Eigen::Vector2d, samples_per_side * samples_per_side>;

const double outside = std::numeric_limits<double>::quiet_NaN();

// ---- The primitives, in samples

class Flat_triangle
{
public:
  Flat_triangle(const Vector& a, const Vector& b, const Vector& c) : m_origin(a.head<2>()), m_depth(a.z(), b.z(), c.z())
  {
    const Eigen::Vector2d ab = (b - a).head<2>(), ac = (c - a).head<2>();
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    m_is_degenerate = area == 0;
    m_b = Eigen::Vector2d(ac.y(), -ac.x()) / area;
    m_c = Eigen::Vector2d(-ab.y(), ab.x()) / area;
  }

  bool is_degenerate() const { return m_is_degenerate; }

  Vector barycentric(double x, double y) const
  {
    const double dx = x - m_origin.x(), dy = y - m_origin.y();
    const double b = m_b.x() * dx + m_b.y() * dy, c = m_c.x() * dx + m_c.y() * dy;
    return {1 - b - c, b, c};
  }

  double depth(double x, double y) const
  {
    const Vector w = barycentric(x, y);   // a sample on an edge belongs to both sides, up to rounding: no gaps
    const bool is_inside = w[0] >= -1e-12 && w[1] >= -1e-12 && w[2] >= -1e-12;
    return is_inside ? w.dot(m_depth) : outside;
  }

private:
  Eigen::Vector2d m_origin, m_b, m_c;     // barycentric coordinates are affine functions
  Vector          m_depth;
  bool            m_is_degenerate;
};

// All points within a distance of a segment: a tube with round ends; of a point, a ball.
class Tube
{
public:
  Tube(const Vector& p, const Vector& q, double radius) : m_p(p), m_pq(q - p), m_radius(radius)
  {
    m_length = m_pq.norm();
    m_seen_length = m_pq.head<2>().norm();
  }

  /// of the point of its surface that is nearest to the eye, not a number outside
  double depth(double x, double y) const
  {
    const double dx = x - m_p.x(), dy = y - m_p.y();
    if (!(m_seen_length > 0)) return std::max(m_p.z(), m_p.z() + m_pq.z()) + height(dx, dy);
    const double along = (dx * m_pq.x() + dy * m_pq.y()) / m_seen_length,
                 across = (dx * m_pq.y() - dy * m_pq.x()) / m_seen_length;
    const double slope = m_pq.z() / m_seen_length, stretch = m_length / m_seen_length;
    const double h = height(across, 0);
    const double foot = along * stretch + h * slope;        // on the axis, below the point of the infinite tube
    if (foot < 0) return m_p.z() + height(dx, dy);
    if (foot > m_length) return m_p.z() + m_pq.z() + height(dx - m_pq.x(), dy - m_pq.y());
    return m_p.z() + along * slope + h * stretch;
  }

  Vector normal(double x, double y) const
  {
    const Vector from_p = Vector(x, y, depth(x, y)) - m_p;
    const double t = m_length > 0 ? std::clamp(from_p.dot(m_pq) / (m_length * m_length), 0.0, 1.0) : 0;
    return from_p - t * m_pq;
  }

private:
  double height(double dx, double dy) const { return std::sqrt(m_radius * m_radius - dx * dx - dy * dy); }

  Vector m_p, m_pq;
  double m_radius, m_length, m_seen_length;
};

// A stripe with round ends that faces the eye, some way before its axis.
class Stripe
{
public:
  Stripe(const Vector& p, const Vector& q, double radius) : m_p(p), m_pq(q - p), m_radius(radius)
  {
    const double squared_length = m_pq.head<2>().squaredNorm();
    m_inverse = squared_length > 0 ? 1 / squared_length : 0;
  }

  double depth(double x, double y) const
  {
    const double dx = x - m_p.x(), dy = y - m_p.y();
    const double t = std::clamp((dx * m_pq.x() + dy * m_pq.y()) * m_inverse, 0.0, 1.0);
    const double ex = dx - t * m_pq.x(), ey = dy - t * m_pq.y();
    return ex * ex + ey * ey <= m_radius * m_radius ? m_p.z() + t * m_pq.z() + stripe_pull * m_radius : outside;
  }

private:
  Vector m_p, m_pq;
  double m_radius, m_inverse;
};

// The scene in samples: triangles, then the segments of the lines, then the balls, numbered in this order.
class Painter
{
public:
  Painter(const Scene& scene, const Projection& projection) : m_scene(scene), m_projection(projection)
  {
    for (const Point_3& p : scene.points) m_points.push_back(projection(p));
    for (const auto& corners : scene.normals) {
      auto& normals = m_normals.emplace_back();
      for (int k = 0; k < 3; ++k) normals.col(k) = projection.direction(corners[k].normalized());
    }
    for (const Scene::Line& line : scene.lines)
      for (std::size_t k = 0; k + 1 < line.points.size(); ++k)
        m_segments.push_back({&line, projection(line.points[k]), projection(line.points[k + 1])});
  }

  std::size_t number_of_primitives() const
  { return m_scene.triangles.size() + m_segments.size() + m_scene.balls.size(); }

  Box box(std::uint32_t primitive) const
  {
    if (is_triangle(primitive)) {
      const Vector &a = corner(primitive, 0), &b = corner(primitive, 1), &c = corner(primitive, 2);
      return box_of(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), 0);
    }
    if (is_segment(primitive)) return box_of(segment(primitive).p, segment(primitive).q, radius(segment(primitive)));
    const Vector centre = m_projection(ball(primitive).centre);
    return box_of(centre, centre, ball(primitive).radius * m_projection.scale());
  }

  void paint(std::uint32_t primitive, Rows& rows) const
  {
    const Box place = box(primitive);
    if (is_triangle(primitive)) {
      const Flat_triangle t = triangle(primitive);
      if (!t.is_degenerate()) rows.draw(primitive, place, t);
    } else if (is_segment(primitive) && !segment(primitive).line->is_tube) {
      const Segment& s = segment(primitive);
      rows.draw(primitive, place, Stripe(s.p, s.q, radius(s)));
    } else {
      rows.draw(primitive, place, tube(primitive));
    }
  }

  /// the mean colour of a primitive at some samples, with the light at their middle
  Colour colour(std::uint32_t primitive, const Samples& samples) const
  {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& s : samples) middle += s;
    middle /= static_cast<double>(samples.size());
    if (is_triangle(primitive)) return triangle_colour(primitive, samples, middle);
    if (is_segment(primitive) && !segment(primitive).line->is_tube) return segment(primitive).line->colour;
    const Vector normal = tube(primitive).normal(middle.x(), middle.y());
    return lit(is_segment(primitive) ? segment(primitive).line->colour : ball(primitive).colour,
               {normal.x(), -normal.y(), normal.z()});
  }

private:
  struct Segment
  {
    const Scene::Line* line;
    Vector             p, q;
  };

  bool is_triangle(std::size_t primitive) const { return primitive < m_scene.triangles.size(); }
  bool is_segment(std::size_t primitive) const
  { return !is_triangle(primitive) && primitive < m_scene.triangles.size() + m_segments.size(); }
  const Vector& corner(std::size_t primitive, int k) const { return m_points[m_scene.triangles[primitive][k]]; }
  const Segment& segment(std::size_t primitive) const { return m_segments[primitive - m_scene.triangles.size()]; }
  const Scene::Ball& ball(std::size_t primitive) const
  { return m_scene.balls[primitive - m_scene.triangles.size() - m_segments.size()]; }

  double radius(const Segment& s) const { return s.line->width / 2 * m_projection.scale(); }

  Flat_triangle triangle(std::size_t primitive) const
  { return Flat_triangle(corner(primitive, 0), corner(primitive, 1), corner(primitive, 2)); }

  Tube tube(std::size_t primitive) const
  {
    if (is_segment(primitive)) {
      const Segment& s = segment(primitive);
      const Vector pull = tube_pull * radius(s) * Vector::UnitZ();
      return Tube(s.p + pull, s.q + pull, radius(s));
    }
    const double radius = ball(primitive).radius * m_projection.scale();
    const Vector centre = m_projection(ball(primitive).centre) + ball_pull * radius * Vector::UnitZ();
    return Tube(centre, centre, radius);
  }

  Colour triangle_colour(std::size_t t, const Samples& samples,
                         const Eigen::Vector2d& middle) const
  {
    const Flat_triangle flat = triangle(t);
    Colour colour = Colour::Zero();
    if (m_scene.texture) {
      const auto& uv = m_scene.uv[t];
      for (const Eigen::Vector2d& s : samples) {
        const Vector w = flat.barycentric(s.x(), s.y());
        colour += m_scene.texture(w[0] * uv[0] + w[1] * uv[1] + w[2] * uv[2]) / static_cast<float>(samples.size());
      }
    } else {
      colour = m_scene.colours[t];
    }
    return lit(colour, m_normals[t] * flat.barycentric(middle.x(), middle.y()));
  }

  const Scene&                 m_scene;
  const Projection&            m_projection;
  std::vector<Vector>          m_points;
  std::vector<Eigen::Matrix3d> m_normals;    // by triangle, one column a corner
  std::vector<Segment>         m_segments;
};

// The mean of a pixel's samples, primitive by primitive.
Colour pixel_colour(const Rows& rows, int x, int y, const Painter& painter)
{
  const int n = samples_per_side;
  std::array<std::uint32_t, samples_per_side * samples_per_side> primitives;
  for (int j = 0; j < n * n; ++j) primitives[j] = rows.at(n * x + j % n, n * y + j / n).primitive;
  Colour sum = Colour::Zero();
  Samples samples;
  for (int first = 0; first < n * n; ++first) {
    const std::uint32_t primitive = primitives[first];
    if (std::find(primitives.begin(), primitives.begin() + first, primitive) != primitives.begin() + first) continue;
    samples.clear();
    for (int j = first; j < n * n; ++j)
      if (primitives[j] == primitive) samples.emplace_back(n * x + j % n + 0.5, n * y + j / n + 0.5);
    const Colour colour = primitive == background ? Colour::Ones() : painter.colour(primitive, samples);
    sum += static_cast<float>(samples.size()) * colour;
  }
  return sum / static_cast<float>(n * n);
}

// the primitives that may be seen in every strip of `rows_at_once` rows, in their order
std::vector<std::vector<std::uint32_t>> primitives_by_strip(const Painter& painter, int height)
{
  std::vector<std::vector<std::uint32_t>> result((height + rows_at_once - 1) / rows_at_once);
  const auto strip = [&](double y) {
    return static_cast<std::size_t>(std::clamp(y / (rows_at_once * samples_per_side), 0.0, result.size() - 1.0));
  };
  for (std::uint32_t primitive = 0; primitive < painter.number_of_primitives(); ++primitive) {
    const Box box = painter.box(primitive);
    for (std::size_t s = strip(box.top); s <= strip(box.bottom); ++s) result[s].push_back(primitive);
  }
  return result;
}

// ---- Normals

// for every point, the first one with the same coordinates
std::vector<std::size_t> equal_points(const std::vector<Point_3>& points)
{
  std::vector<std::size_t> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return points[i] != points[j] ? points[i] < points[j] : i < j;
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? first[order[k - 1]] : order[k];
  return first;
}

// ---- Views

// second moments of the triangles about their centre of area
Eigen::Matrix3d moments(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles)
{
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Vector first = Vector::Zero();
  double total = 0;
  for (const Triangle& t : triangles) {
    const Vector a = vector(points[t[0]]), b = vector(points[t[1]]), c = vector(points[t[2]]);
    const double area = (b - a).cross(c - a).norm() / 2;
    for (const Vector& m : {Vector((a + b) / 2), Vector((b + c) / 2), Vector((c + a) / 2)}) {   // exact for degree 2
      second += area / 3 * m * m.transpose();
      first += area / 3 * m;
    }
    total += area;
  }
  return total > 0 ? Eigen::Matrix3d(second / total - first * first.transpose() / (total * total)) : second;
}

} // namespace

std::vector<std::array<Vector, 3>> smooth_normals(const std::vector<Point_3>& points,
                                                  const std::vector<Triangle>& triangles)
{
  const std::vector<std::size_t> first = equal_points(points);
  std::vector<Vector> area(triangles.size());
  std::vector<std::vector<std::size_t>> round(points.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vector a = vector(points[triangles[t][0]]);
    area[t] = (vector(points[triangles[t][1]]) - a).cross(vector(points[triangles[t][2]]) - a);
    for (std::size_t v : triangles[t]) round[first[v]].push_back(t);
  }
  std::vector<std::array<Vector, 3>> normals(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      normals[t][k] = area[t];
      for (std::size_t u : round[first[triangles[t][k]]])
        if (u != t && area[t].dot(area[u]) >= crease_cosine * area[t].norm() * area[u].norm()) normals[t][k] += area[u];
    }
  return normals;
}

Camera camera(const Vector& towards_eye, const Vector& up)
{
  const Vector eye = towards_eye.normalized();
  Vector right = up.cross(eye);
  if (!(right.norm() > 1e-6 * up.norm())) right = eye.unitOrthogonal();
  right.normalize();
  return {right, eye.cross(right), eye};
}

Vector usual_up(const Vector& towards_eye)
{
  Eigen::Index largest;
  towards_eye.cwiseAbs().maxCoeff(&largest);
  return largest == 1 ? Vector::UnitZ() : Vector::UnitY();
}

Camera automatic_camera(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles)
{
  Vector axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments(points, triangles)).eigenvectors().col(0);
  Eigen::Index largest;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] < 0) axis = -axis;                     // a sign that does not depend on the solver
  const Camera straight = camera(axis, usual_up(axis));
  const double degree = std::acos(-1.0) / 180;
  const Vector turned = Eigen::AngleAxisd(25 * degree, (straight.up - 0.75 * straight.right).normalized()) * axis;
  return camera(turned, usual_up(axis));
}

Image render(const Scene& scene, const Camera& camera, int size)
{
  const Projection projection(scene, camera, size);
  const Painter painter(scene, projection);
  Image image = blank_image(projection.width(), projection.height(), 3, 255);
  const std::vector<std::vector<std::uint32_t>> by_strip = primitives_by_strip(painter, image.height);
  for (int first = 0; first < image.height; first += rows_at_once) {
    const int last = std::min(first + rows_at_once, image.height);
    Rows rows(image.width * samples_per_side, first * samples_per_side, last * samples_per_side);
    for (std::uint32_t primitive : by_strip[first / rows_at_once]) painter.paint(primitive, rows);
    for (int y = first; y < last; ++y)
      for (int x = 0; x < image.width; ++x) {
        const Colour colour = pixel_colour(rows, x, y, painter);
        for (int k = 0; k < 3; ++k) image.at(x, y, k) = static_cast<std::uint8_t>(255 * colour[k] + 0.5f);
      }
  }
  return image;
}

Image side_by_side(const Image& left, const Image& right)
{
  Image both = blank_image(left.width + right.width, left.height, left.channels, 255);
  for (int y = 0; y < both.height; ++y)
    for (int x = 0; x < both.width; ++x)
      for (int k = 0; k < both.channels; ++k)
        both.at(x, y, k) = x < left.width ? left.at(x, y, k) : right.at(x - left.width, y, k);
  return both;
}

} } } // namespace CGAL::Quartic_differentials::internal
