// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/coarse_surface.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/internal/geodesic_disk.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::cross;

const double pi = CGAL_PI;
const double      most_scaling = 8;      // of the squared lengths, when a vertex is flattened
const double      least_shape = 1e-5;    // 4 area / (sum of the squared sides) of a triangle that is made
const std::size_t most_spokes = 64;      // so that a vertex is removed in constant time
const double      round_share = 0.15;    // of the vertices may be removed before the flips to Delaunay
const double      least_coordinate = 0.05;   // barycentric, of a point that is carried to the fine surface

// The star of a vertex v without loops, flattened, and how it becomes a single triangle by flips of its spokes.
// One object serves many vertices, so that nothing is allocated again.
class Flat_star
{
public:
  /// flattens the star and chooses the flips; says whether that is possible.
  bool reset(const Intrinsic_triangulation& t, Vertex v)
  { return collect(t, v) && flatten() && choose_flips(); }

  /// spokes from v, counterclockwise
  const std::vector<Halfedge>& spokes() const { return m_spoke; }
  /// in their order: a spoke, and the length of the edge that replaces it
  const std::vector<std::pair<Halfedge, double>>& flips() const { return m_flips; }
  /// after the flips: the spokes that are left
  std::array<Halfedge, 3> last_spokes() const
  { return {m_spoke[m_polygon[0]], m_spoke[m_polygon[1]], m_spoke[m_polygon[2]]}; }
  /// the barycentric coordinates of v with respect to their ends
  std::array<double, 3> barycentric() const
  {
    std::array<double, 3> b;
    for (int k = 0; k < 3; ++k)   // not below 0 but for rounding
      b[k] = std::max(cross(m_position[m_polygon[(k + 1) % 3]], m_position[m_polygon[(k + 2) % 3]]), 0.0);
    const double sum = b[0] + b[1] + b[2];
    for (double& x : b) x /= sum;
    return b;
  }

private:
  // a corner at v, between two spokes of lengths a and b opposite to a side e: (a - b)^2, (a + b)^2, e^2
  struct Corner { double difference, sum, opposite; };

  bool collect(const Intrinsic_triangulation& t, Vertex v)
  {
    if (t.is_border(v)) return false;
    m_spoke.clear();
    m_length.clear();
    m_rim.clear();
    const Halfedge first = t.halfedge_from(v);
    Halfedge h = first;
    do {
      if (t.target(h) == v || m_spoke.size() == most_spokes) return false;
      m_spoke.push_back(h);
      m_length.push_back(t.length(h));
      m_rim.push_back(t.length(t.next(h)));
      h = t.next_around_source(h);
    } while (h != first);
    return m_spoke.size() >= 3;
  }

  // The angle of a corner for spokes scaled by 1 / sqrt(w), and its derivative. sin^2 and cos^2 of half of it are
  // linear in w, and accurate for needles.
  static std::pair<double, double> angle(const Corner& c, double w)
  {
    const double s = std::max(c.opposite * w - c.difference, 0.0), t = std::max(c.sum - c.opposite * w, 0.0);
    return {2 * std::atan2(std::sqrt(s), std::sqrt(t)), c.opposite / std::sqrt(s * t)};
  }
  // the sum of the angles minus 2 pi, which increases with w, and its derivative
  std::pair<double, double> excess(double w) const
  {
    std::pair<double, double> sum{-2 * pi, 0};
    for (const Corner& c : m_corner) {
      const auto [a, d] = angle(c, w);
      sum.first += a;
      sum.second += d;
    }
    return sum;
  }

  // Newton's method, with bisection where it leaves the interval in which triangles exist
  bool flatten()
  {
    m_corner.clear();
    double low = 1 / most_scaling, high = most_scaling;
    for (std::size_t i = 0; i < m_spoke.size(); ++i) {
      const double a = m_length[i], b = m_length[(i + 1) % m_spoke.size()], e = m_rim[i];
      m_corner.push_back({(a - b) * (a - b), (a + b) * (a + b), e * e});
      low = std::max(low, m_corner.back().difference / m_corner.back().opposite);
      high = std::min(high, m_corner.back().sum / m_corner.back().opposite);
    }
    if (!(low < high) || !(excess(low).first < 0) || !(excess(high).first > 0)) return false;
    double w = low < 1 && 1 < high ? 1 : 0.5 * (low + high);
    for (int n = 0; n < 60; ++n) {
      const auto [value, slope] = excess(w);
      if (std::abs(value) < 1e-12) break;
      (value < 0 ? low : high) = w;
      const double newton = w - value / slope;
      w = low < newton && newton < high ? newton : 0.5 * (low + high);
    }
    m_position.clear();
    double direction = 0;
    for (std::size_t i = 0; i < m_spoke.size(); ++i) {
      m_position.push_back(std::polar(m_length[i] / std::sqrt(w), direction));
      direction += angle(m_corner[i], w).first;
    }
    return true;
  }

  static double shape(double a, double b, double c) { return four_times_area(a, b, c) / (a * a + b * b + c * c); }

  // The ear at corner i of the polygon: the length of its diagonal, and its shape, 0 if the flip is not possible.
  std::pair<double, double> ear(std::size_t i) const
  {
    const std::size_t n = m_polygon.size(), before = (i + n - 1) % n;
    const std::complex<double> p = m_position[m_polygon[before]], q = m_position[m_polygon[i]],
                               r = m_position[m_polygon[(i + 1) % n]];
    const double diagonal = std::abs(r - p);
    const bool is_convex = cross(q - p, r - q) > 0 && cross(p, r) > 0;   // the quadrilateral p q r 0
    return {diagonal, is_convex ? shape(m_side[before], m_side[i], diagonal) : 0};
  }

  // Cuts off the ear of the best shape until a triangle is left.
  bool choose_flips()
  {
    m_flips.clear();
    m_side = m_rim;
    m_polygon.resize(m_spoke.size());
    std::iota(m_polygon.begin(), m_polygon.end(), std::size_t(0));
    while (m_polygon.size() > 3) {
      std::size_t best = 0;
      std::pair<double, double> best_ear{0, 0};
      for (std::size_t i = 0; i < m_polygon.size(); ++i)
        if (const auto e = ear(i); e.second > best_ear.second) { best = i; best_ear = e; }
      if (best_ear.second < least_shape) return false;
      m_flips.push_back({m_spoke[m_polygon[best]], best_ear.first});
      m_side[(best + m_side.size() - 1) % m_side.size()] = best_ear.first;
      m_side.erase(m_side.begin() + best);
      m_polygon.erase(m_polygon.begin() + best);
    }
    return shape(m_side[0], m_side[1], m_side[2]) >= least_shape;
  }

  std::vector<Halfedge>                    m_spoke;
  std::vector<double>                      m_length, m_rim;   // of spoke i, and of the side opposite to its corner
  std::vector<Corner>                      m_corner;
  std::vector<std::complex<double>>        m_position;        // of the ends of the spokes, with v at 0
  std::vector<std::size_t>                 m_polygon;         // the spokes not flipped yet
  std::vector<double>                      m_side;            // of the polygon, from corner i to the next
  std::vector<std::pair<Halfedge, double>> m_flips;
};

// The vertices in the order in which they should be removed: those first that stand for the least area, so that the
// ones left are spread evenly. To spare vertices of high curvature as well was measured to change little: energies of
// log scale factors get better by a fifth, Dirichlet products of harmonic forms worse by as much.
std::vector<Vertex> order_of_removal(const Coarse_surface& s)
{
  std::vector<Vertex> order(s.triangulation.vertices().begin(), s.triangulation.vertices().end());
  std::sort(order.begin(), order.end(), [&](Vertex a, Vertex b) {
    return std::make_pair(s.mass[a], a) < std::make_pair(s.mass[b], b);
  });
  return order;
}

// Flips the edges at v until three are left, gives away its mass, and notes where it was.
void detach(Coarse_surface& s, Vertex v, const Flat_star& star)
{
  Intrinsic_triangulation& t = s.triangulation;
  for (const auto& [spoke, length] : star.flips()) {
    const Edge_flip flip = t.flip_of(t.edge(spoke), length, false);
    s.cochains.before_flip(t, flip);
    t.flip(flip);
  }
  const auto last = star.last_spokes();
  const auto b = star.barycentric();
  Removed_vertex removed{s.fine_vertex[v], {}, b};
  for (int k = 0; k < 3; ++k) {
    const Vertex w = t.target(last[k]);
    s.mass[w] += b[k] * s.mass[v];
    removed.corner[k] = s.fine_vertex[w];
  }
  s.removed.push_back(removed);
}

// Makes up to `most` vertices, no two of them neighbours, the middle of three faces that can be joined to one triangle.
// The three edges at such a vertex keep their old lengths, which are of no use any more.
std::vector<char> detach_vertices(Coarse_surface& s, std::size_t most)
{
  std::vector<char> detached(s.mass.size(), false), has_changed(s.mass.size(), false);
  std::size_t n = 0;
  Flat_star star;
  for (Vertex v : order_of_removal(s)) {
    if (n == most) break;
    if (has_changed[v] || !star.reset(s.triangulation, v)) continue;
    for (Halfedge h : star.spokes()) has_changed[s.triangulation.target(h)] = true;
    detach(s, v, star);
    detached[v] = true;
    ++n;
  }
  return detached;
}

using Triangles = std::vector<std::array<Halfedge, 3>>;   // the halfedges round them

// The triangles that are left when the three round every detached vertex are joined.
Triangles triangles_without(const Intrinsic_triangulation& t, const std::vector<char>& detached)
{
  Triangles triangles;
  triangles.reserve(t.number_of_faces());
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    if (std::none_of(h.begin(), h.end(), [&](Halfedge k) { return detached[t.source(k)]; })) triangles.push_back(h);
  }
  for (Vertex v : t.vertices()) {
    if (!detached[v]) continue;
    const Halfedge a = t.halfedge_from(v), b = t.next_around_source(a), c = t.next_around_source(b);
    triangles.push_back({t.next(a), t.next(b), t.next(c)});
  }
  return triangles;
}

Glued_triangles glued(const Intrinsic_triangulation& t, const Triangles& triangles, const std::vector<int>& new_index)
{
  std::vector<std::array<int, 2>> place(t.number_of_halfedges());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) place[triangles[i][k]] = {static_cast<int>(i), k};
  Glued_triangles g;
  g.triangles.resize(triangles.size());
  g.opposite.resize(triangles.size());
  g.lengths.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = triangles[i][k];
      g.triangles[i][k] = new_index[t.source(h)];
      g.opposite[i][k] = t.is_border(t.opposite(h)) ? std::array<int, 2>{-1, -1} : place[t.opposite(h)];
      g.lengths[i][k] = t.length(h);
    }
  return g;
}

// The cochains on the triangulation t that was made of these triangles of the old one.
Integer_cochains carried_over(const Integer_cochains& cochains, const Triangles& triangles,
                              const Intrinsic_triangulation& t)
{
  Integer_cochains result(t.number_of_edges(), cochains.size());
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    for (int k = 0; k < 3; ++k) {
      if (h[k] != t.halfedge(t.edge(h[k]))) continue;   // once an edge
      for (int n = 0; n < cochains.size(); ++n) result.add(h[k], n, cochains(triangles[f][k], n));
    }
  }
  return result;
}

Coarse_surface without(const Coarse_surface& s, const std::vector<char>& detached)
{
  Coarse_surface result;
  std::vector<int> new_index(detached.size(), -1);
  for (Vertex v : s.triangulation.vertices()) {
    if (detached[v]) continue;
    new_index[v] = static_cast<int>(result.mass.size());
    result.mass.push_back(s.mass[v]);
    result.fine_vertex.push_back(s.fine_vertex[v]);
  }
  const auto triangles = triangles_without(s.triangulation, detached);
  result.triangulation = Intrinsic_triangulation(glued(s.triangulation, triangles, new_index));
  result.cochains = carried_over(s.cochains, triangles, result.triangulation);
  return result;
}

// The barycentric coordinates in a coarse face, continued linearly to the vertices of the fine surface, where not all of
// them are 0.
class Continued_coordinates
{
public:
  Continued_coordinates(const Coarse_surface& coarse, Face f, std::size_t fine_vertices) : m_place(fine_vertices, -1)
  {
    const auto h = coarse.triangulation.halfedges(f);
    for (int k = 0; k < 3; ++k) add(coarse.fine_vertex[coarse.triangulation.source(h[k])], Eigen::Vector3d::Unit(k));
    for (auto r = coarse.removed.rbegin(); r != coarse.removed.rend(); ++r) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) sum += r->barycentric[k] * at(r->corner[k]);
      if (!sum.isZero(0)) add(r->vertex, sum);
    }
  }

  Eigen::Vector3d at(Vertex v) const
  {
    if (m_place[v] < 0) return Eigen::Vector3d::Zero();
    return m_value[m_place[v]];
  }
  // the vertex where they are nearest to these values
  Vertex nearest(const Eigen::Vector3d& values) const
  {
    const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
    { return (a - values).squaredNorm() < (b - values).squaredNorm(); };
    return m_vertex[std::min_element(m_value.begin(), m_value.end(), nearer) - m_value.begin()];
  }

private:
  void add(Vertex v, const Eigen::Vector3d& value)
  {
    if (m_place[v] >= 0) {   // a corner of the face for the second time
      m_value[m_place[v]] += value;
      return;
    }
    m_place[v] = static_cast<int>(m_vertex.size());
    m_vertex.push_back(v);
    m_value.push_back(value);
  }

  std::vector<int>             m_place;   // by vertex: in the next two, or -1
  std::vector<Vertex>          m_vertex;
  std::vector<Eigen::Vector3d> m_value;
};

} // namespace

Coarse_surface coarsened(const Intrinsic_triangulation& t, const Integer_cochains& cochains, std::size_t vertices)
{
  return coarsened(t, cochains, vertex_areas(t), vertices);
}

Coarse_surface coarsened(const Intrinsic_triangulation& t, const Integer_cochains& cochains, std::vector<double> mass,
                         std::size_t vertices)
{
  Coarse_surface s{t, cochains, std::move(mass), {t.vertices().begin(), t.vertices().end()}, {}};
  while (s.mass.size() > vertices) {
    const std::size_t share = static_cast<std::size_t>(round_share * s.mass.size()) + 1;
    const std::vector<char> detached = detach_vertices(s, std::min(s.mass.size() - vertices, share));
    if (std::none_of(detached.begin(), detached.end(), [](char d) { return d; })) break;
    Coarse_surface fewer = without(s, detached);
    fewer.removed = std::move(s.removed);
    s = std::move(fewer);
    make_delaunay(s.triangulation, s.cochains);
  }
  return s;
}

Surface_point on_fine_surface(const Coarse_surface& coarse, const Surface_point& p, const Intrinsic_triangulation& fine)
{
  const Continued_coordinates coordinates(coarse, p.face, fine.number_of_vertices());
  const Eigen::Vector3d goal(p.barycentric[0], p.barycentric[1], p.barycentric[2]);
  const Vertex v = coordinates.nearest(goal);
  Surface_point best;
  double most_inside = -std::numeric_limits<double>::infinity();
  const Halfedge first = fine.halfedge_from(v);
  Halfedge h = first;
  do {   // of the faces round the vertex the one in which the point is, or that it is nearest to being in
    Surface_point q{fine.face(h)};
    const auto corner = fine.halfedges(q.face);
    const Eigen::Vector3d origin = coordinates.at(fine.source(corner[0]));
    Eigen::Matrix<double, 3, 2> sides;
    sides << coordinates.at(fine.source(corner[1])) - origin, coordinates.at(fine.source(corner[2])) - origin;
    const Eigen::Vector2d x = sides.colPivHouseholderQr().solve(goal - origin);
    q.barycentric = {1 - x.sum(), x[0], x[1]};
    if (const double least = std::min({1 - x.sum(), x[0], x[1]}); least > most_inside) {
      most_inside = least;
      best = q;
    }
    h = fine.next_around_source(h);
  } while (h != first && !fine.is_border(h));
  return internal::moved_inside(best, least_coordinate);
}

} } // namespace CGAL::Quartic_differentials
