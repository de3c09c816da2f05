// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/vertex_places.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double pi = CGAL_PI;
const double smoothing_time = 0.0025;   // of the area
const double slack = 1.1;               // fewer singularities are worth that factor of the range of log scales
const double separation = 0.06;         // least distance of the extrema along edges, times sqrt(area)

// Picks vertices of extreme curvature, keeping a distance from all that was picked before.
class Extremum_picker
{
public:
  Extremum_picker(const Intrinsic_triangulation& t, const std::vector<double>& weights)
    : m_t(t), m_radius(separation * std::sqrt(t.area())),
      m_taken(internal::near_boundary(t))
  {
    const std::vector<double> k = curvatures(t, corner_angles(t, t.lengths()));
    m_curvature = heat_smoothed(t, weights, smoothing_time * t.area(), Eigen::Map<const Eigen::VectorXd>(k.data(), k.size()));
    // what differs by rounding only, as on symmetric surfaces, counts as equal: then the vertices' order decides
    const double grain = std::max(1e-9 * m_curvature.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
    m_curvature = (m_curvature / grain).array().round();
    m_maxima_first = ordered(+1);
    m_minima_first = ordered(-1);
  }

  void take(Vertex v) { m_taken.take(v, m_radius); }

  // the next vertices with the largest sign * curvature: local extrema first, then any vertices
  std::vector<Vertex> pick(int count, int sign)
  {
    std::vector<Vertex> picked;
    for (Vertex v : sign > 0 ? m_maxima_first : m_minima_first) {
      if (static_cast<int>(picked.size()) == count) break;
      if (m_taken[v]) continue;
      picked.push_back(v);
      take(v);
    }
    return picked;
  }

private:
  std::vector<Vertex> ordered(int sign) const
  {
    std::vector<Vertex> order(m_t.vertices().begin(), m_t.vertices().end());
    std::stable_sort(order.begin(), order.end(), [&](Vertex a, Vertex b) {
      return sign * m_curvature[a] > sign * m_curvature[b];
    });
    std::stable_partition(order.begin(), order.end(), [&](Vertex v) { return is_extremum(v, sign); });
    return order;
  }
  bool is_extremum(Vertex v, int sign) const
  {
    const Halfedge first = m_t.halfedge_from(v);
    Halfedge h = first;
    do {
      if (sign * m_curvature[m_t.target(h)] >= sign * m_curvature[v]) return false;
      h = m_t.next_around_source(h);
    } while (h != first);
    return true;
  }

  const Intrinsic_triangulation& m_t;
  double                         m_radius;
  internal::Taken_vertices       m_taken;
  Eigen::VectorXd                m_curvature;   // smoothed, in whole grains
  std::vector<Vertex>            m_maxima_first, m_minima_first;
};

// The range of log scales of the linearised flat metric, L u = K_target - K, for every divisor.
std::vector<double> ranges_of_scales(const Intrinsic_triangulation& t, const Laplacian_solver& laplacian,
                                     const std::vector<Divisor>& divisors)
{
  const std::vector<double> k = curvatures(t, corner_angles(t, t.lengths()));
  Eigen::MatrixXd b = -Eigen::Map<const Eigen::VectorXd>(k.data(), k.size()).replicate(1, divisors.size());
  for (std::size_t d = 0; d < divisors.size(); ++d)
    for (const Singularity& s : divisors[d]) {
      const auto h = t.halfedges(s.location.face);
      for (int c = 0; c < 3; ++c) b(t.source(h[c]).idx(), d) -= s.location.barycentric[c] * s.order * pi / 2;
    }
  const Eigen::MatrixXd u = laplacian.solve(b);
  std::vector<double> ranges;
  for (Eigen::Index d = 0; d < u.cols(); ++d) ranges.push_back(u.col(d).maxCoeff() - u.col(d).minCoeff());
  return ranges;
}

Divisor simple_divisor(const Intrinsic_triangulation& t, const std::vector<Vertex>& poles,
                       const std::vector<Vertex>& zeros)
{
  Divisor divisor;
  for (Vertex v : poles) divisor.push_back({internal::beside(t, v), -1, false});
  for (Vertex v : zeros) divisor.push_back({internal::beside(t, v), +1, false});
  return divisor;
}

} // namespace

Divisor curvature_divisor(const Intrinsic_triangulation& t, const std::vector<double>& weights,
                          const Laplacian_solver& laplacian, int count)
{
  const int needed = 8 * t.genus() - 8, least = std::abs(needed);
  if (count != 0 && count < least)
    throw Infeasible_divisor_error("at least " + std::to_string(least) + " simple singularities are needed on a surface "
                                   "of genus " + std::to_string(t.genus()) + ", not " + std::to_string(count));
  std::vector<int> counts;
  if (count == 0) {
    for (int pairs : {0, 2, 4, 6, 8, 12, 16, 20, 24, 32})
      if (least + 2 * pairs >= 8) counts.push_back(least + 2 * pairs);
  } else {
    counts.push_back(count + (count - least) % 2);
  }

  const Extremum_picker picker(t, weights);
  std::vector<Divisor> candidates;
  for (int n : counts) {
    const std::size_t poles = (n - needed) / 2, zeros = (n + needed) / 2;
    Extremum_picker p = picker;
    const std::vector<Vertex> at_maxima = p.pick(static_cast<int>(poles), +1);
    const std::vector<Vertex> at_minima = p.pick(static_cast<int>(zeros), -1);
    if (at_maxima.size() == poles && at_minima.size() == zeros) candidates.push_back(simple_divisor(t, at_maxima, at_minima));
  }
  if (candidates.empty())
    throw Infeasible_divisor_error("the surface has no room for " + std::to_string(counts.front()) + " singularities: "
                                   "the vertices at which they start are too few or too near each other; use fewer, or "
                                   "subdivide the triangles");
  const std::vector<double> ranges = ranges_of_scales(t, laplacian, candidates);
  const double enough = slack * *std::min_element(ranges.begin(), ranges.end());
  return candidates[std::find_if(ranges.begin(), ranges.end(), [&](double r) { return r <= enough; }) - ranges.begin()];
}

Divisor with_repaired_degree(const Intrinsic_triangulation& t, const std::vector<double>& weights, Divisor divisor)
{
  const int missing = required_degree(t) - degree(divisor);
  if (missing == 0) return divisor;
  Extremum_picker picker(t, weights);
  for (const Singularity& s : divisor) picker.take(internal::nearest_corner(t, s.location));
  const int order = missing > 0 ? 1 : -1;
  const std::vector<Vertex> picked = picker.pick(std::abs(missing), -order);
  if (static_cast<int>(picked.size()) < std::abs(missing))
    throw Infeasible_divisor_error("the surface has no room for the " + std::to_string(std::abs(missing))
                                   + " singularities that the degree " + std::to_string(required_degree(t))
                                   + " asks for");
  for (Vertex v : picked) divisor.push_back({internal::beside(t, v), order, false});
  return divisor;
}

} } // namespace CGAL::Quartic_differentials
