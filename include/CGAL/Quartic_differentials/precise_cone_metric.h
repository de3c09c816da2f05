// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PRECISE_CONE_METRIC_H
#define CGAL_QUARTIC_DIFFERENTIALS_PRECISE_CONE_METRIC_H

#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Flat_metric_newton.h>
#include <CGAL/Quartic_differentials/internal/flat_metric_errors.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>
#include <CGAL/Quartic_differentials/refined_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A flat metric on the flat triangulation of a `Refined_cone_metric` in a number type FT, and how exact it is.
template <class FT>
struct Precise_cone_metric
{
  std::vector<FT>     u;                      ///< by vertex: log of the scale of lengths
  std::vector<FT>     lengths;                ///< by edge, in the flat metric
  std::vector<FT>     curvature_error;        ///< by vertex: K - target [radians]
  std::vector<FT>     turning_error;          ///< by basis loop: T minus the nearest multiple of pi/2 [radians]
  FT                  max_transition_error;   ///< over all edges of a frame propagated over all faces [radians]
  Eigen::VectorXd     moved;                  ///< x, y by singularity, in the frames of their faces of the input; of a
                                              ///< corner the distance along the boundary, and 0
  std::vector<double> history;                ///< max error of curvature and turning, before and after every step
  bool                reached = false;        ///< all errors are within the tolerance
};

namespace internal {

/// x in units of `unit`, as doubles: small differences stay in their range
template <class FT>
Eigen::VectorXd in_units_of(const FT& unit, const std::vector<FT>& x)
{
  Eigen::VectorXd result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = static_cast<double>(FT(x[i] / unit));
  return result;
}

/// The lengths of the input with the cones inserted, in FT, as functions of the cones' places.
template <class FT>
class Cone_places
{
public:
  using Point = std::array<FT, 2>;

  Cone_places(const Intrinsic_triangulation& input, const Refined_cone_metric& metric)
    : m_length(metric.refinement.input().number_of_edges()), m_cones(metric.construction.cones)
  {
    for (Edge e : input.edges()) m_length[e] = exact_length(input, input.halfedge(e));
    for (const Construction::Cone& c : m_cones) {
      const auto [it, is_new] = m_corner.try_emplace(c.location.face);
      if (is_new) it->second = unfolded(input, c.location.face);
      Point z{FT(0), FT(0)};
      for (int k = 0; k < 3; ++k)
        for (int x = 0; x < 2; ++x) z[x] += FT(c.location.barycentric[k]) * it->second[k][x];
      m_place.push_back(z);
    }
    place_spokes();
  }

  const std::vector<FT>& lengths() const { return m_length; }

  /// whether cone i would still be inside its face after a move
  bool stays_inside(std::size_t i, const Point& displacement) const
  {
    const std::array<Point, 3>& corner = m_corner.at(m_cones[i].location.face);
    const Point z{m_place[i][0] + displacement[0], m_place[i][1] + displacement[1]};
    for (int k = 0; k < 3; ++k) {
      if (m_cones[i].on_boundary && k == side_of(m_cones[i])) continue;   // there it stays
      const Point &p = corner[k], &q = corner[(k + 1) % 3];
      if (!((q[0] - p[0]) * (z[1] - p[1]) > (q[1] - p[1]) * (z[0] - p[0]))) return false;
    }
    return true;
  }

  /// the displacement in the frame of the face of a cone that moves by (x, y) there; of a corner by x along the boundary
  Point in_face(std::size_t i, const Point& d) const
  {
    using std::sqrt;
    if (!m_cones[i].on_boundary) return d;
    const std::array<Point, 3>& corner = m_corner.at(m_cones[i].location.face);
    const int k = side_of(m_cones[i]);
    const FT x = corner[(k + 1) % 3][0] - corner[k][0], y = corner[(k + 1) % 3][1] - corner[k][1];
    const FT length = sqrt(FT(x * x + y * y));
    return {FT(d[0] * x / length), FT(d[0] * y / length)};
  }

  void move(std::size_t i, const Point& displacement)
  {
    m_place[i][0] += displacement[0];
    m_place[i][1] += displacement[1];
  }

  void place_spokes()
  {
    using std::sqrt;
    for (std::size_t i = 0; i < m_cones.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const int name = m_cones[i].end[k];
        const Point& end = name < 3 ? m_corner.at(m_cones[i].location.face)[name] : m_place[name - 3];
        const FT x = end[0] - m_place[i][0], y = end[1] - m_place[i][1];
        m_length[m_cones[i].spoke[k]] = sqrt(FT(x * x + y * y));
      }
  }

private:
  // the side of its face on which a corner lies
  static int side_of(const Construction::Cone& c)
  {
    for (int k = 0; k < 3; ++k)
      if (c.location.barycentric[(k + 2) % 3] == 0) return k;
    return 0;
  }

  static FT exact_length(const Intrinsic_triangulation& t, Halfedge h)
  {
    using std::sqrt;
    if (!t.is_embedded()) return FT(t.length(h));
    const Point_3 &p = t.mesh().point(t.source(h)), &q = t.mesh().point(t.target(h));
    const FT x = FT(q.x()) - FT(p.x()), y = FT(q.y()) - FT(p.y()), z = FT(q.z()) - FT(p.z());
    return sqrt(FT(x * x + y * y + z * z));
  }

  std::array<Point, 3> unfolded(const Intrinsic_triangulation& t, Face f) const
  {
    const auto h = t.halfedges(f);
    const FT &a = m_length[t.edge(h[0])], &b = m_length[t.edge(h[1])], &c = m_length[t.edge(h[2])];
    return {Point{FT(0), FT(0)}, Point{a, FT(0)},
            Point{FT(twice_scalar_product(b, c, a) / (2 * a)), FT(four_times_area(a, b, c) / (2 * a))}};
  }

  std::vector<FT>                        m_length;   // by edge
  const std::vector<Construction::Cone>& m_cones;
  std::map<Face, std::array<Point, 3>>   m_corner;   // of the faces with cones
  std::vector<Point>                     m_place;    // of the cones, in the frames of their faces
};

/// the lengths after the flips of a log
template <class FT>
std::vector<FT> flipped(std::vector<FT> l, const Flip_log& flips)
{
  for (const Flip_log::Entry& f : flips.entries())
    l[f.e] = f.ptolemy ? ptolemy_diagonal(l[f.e], l[f.a], l[f.b], l[f.c], l[f.d])
                       : euclidean_diagonal(l[f.e], l[f.a], l[f.b], l[f.c], l[f.d]);
  return l;
}

/// Newton's method in FT for the metric of `refined`.
template <class FT>
class Precise_newton
{
public:
  Precise_newton(const Intrinsic_triangulation& input, const Cone_metric& metric, const Refined_cone_metric& refined)
    : m_metric(metric), m_refined(refined), m_places(input, refined), m_linear(refined, metric.cones.size())
  {
    m_result.u.assign(metric.u.begin(), metric.u.end());
    m_result.lengths.resize(refined.triangulation.number_of_edges());
    m_result.moved = Eigen::VectorXd::Zero(2 * metric.cones.size());
    evaluate();
  }

  const FT& error() const { return m_error; }

  void step()
  {
    const Eigen::VectorXd curvature_error = in_units_of(m_error, m_result.curvature_error);
    const Eigen::VectorXd displacement = moved_cones(curvature_error, in_units_of(m_error, m_result.turning_error));
    const Eigen::VectorXd du = m_linear.scales(curvature_error, displacement);
    for (std::size_t v = 0; v < m_result.u.size(); ++v) m_result.u[v] += FT(du[v]) * m_error;
    evaluate();
  }

  Precise_cone_metric<FT> result(const FT& tolerance) const
  {
    Precise_cone_metric<FT> m = m_result;
    m.max_transition_error = max_transition_error(m_refined.triangulation, m_angles);
    m.reached = m_error <= tolerance && m.max_transition_error <= tolerance;
    return m;
  }

private:
  // Moves the cones and returns the displacements, in units of the error. A cone that would leave its face is held.
  Eigen::VectorXd moved_cones(const Eigen::VectorXd& curvature_error, const Eigen::VectorXd& turning_error)
  {
    const std::vector<Construction::Cone>& cones = m_refined.construction.cones;
    Eigen::VectorXd move;
    const auto displacement = [&](std::size_t i) {
      const std::size_t s = cones[i].singularity;
      return m_places.in_face(i, {FT(FT(move[2 * s]) * m_error), FT(FT(move[2 * s + 1]) * m_error)});
    };
    for (bool inside = false; !inside;) {
      move = m_linear.cones(curvature_error, turning_error);
      inside = true;
      for (std::size_t i = 0; i < cones.size(); ++i) {
        if (move.segment<2>(2 * cones[i].singularity).isZero(0) || m_places.stays_inside(i, displacement(i))) continue;
        m_linear.hold(cones[i].singularity);
        inside = false;
      }
    }
    for (std::size_t i = 0; i < cones.size(); ++i) m_places.move(i, displacement(i));
    m_places.place_spokes();
    m_result.moved += static_cast<double>(m_error) * move;
    return move;
  }

  void evaluate()
  {
    using std::exp;
    const Intrinsic_triangulation& t = m_refined.triangulation;
    const std::vector<FT> l = flipped(m_places.lengths(), m_refined.construction.flips);
    std::vector<FT> scale;
    for (const FT& u : m_result.u) scale.push_back(exp(FT(u / 2)));
    for (Edge e : t.edges()) {
      const Halfedge h = t.halfedge(e);
      m_result.lengths[e] = l[e] * scale[t.source(h)] * scale[t.target(h)];
    }
    Flat_metric_errors<FT> errors = flat_metric_errors(t, m_refined.cochains, m_metric.order, m_result.lengths);
    m_angles = std::move(errors.angles);
    m_result.curvature_error = std::move(errors.curvature);
    m_result.turning_error = std::move(errors.turning);
    m_error = (std::max)(largest(m_result.curvature_error), largest(m_result.turning_error));
    m_result.history.push_back(static_cast<double>(m_error));
  }

  const Cone_metric&         m_metric;
  const Refined_cone_metric& m_refined;
  Cone_places<FT>            m_places;
  Flat_metric_newton         m_linear;
  Precise_cone_metric<FT>    m_result;
  std::vector<FT>            m_angles;
  FT                         m_error;
};

} // namespace internal

/// makes a flat metric and its holonomy exact to the precision of a number type, by Newton's method whose linear part
/// stays in doubles: residuals in FT, corrections from one sparse factorisation in doubles (iterative refinement).
///
/// The combinatorics stays as it was decided in doubles; lengths, also of the input, where that is embedded, are
/// computed anew in FT. A cone that would leave its face of the input stays where it is; the others make up for it.
/// \tparam FT a field with sqrt, exp, acos, atan2, round, abs and conversions from and to `double`, such as
///         `boost::multiprecision::mpfr_float`
/// \param metric of which `refined` was made; its scales are where the iteration starts
/// \param tolerance what all errors must reach; the iteration goes on to a thousandth of it, or to stagnation
/// Always returns: see `reached`.
/// \throws Numerical_error if the cones that may move cannot correct the holonomy
/// \throws Cancelled_error
/// Complexity: one sparse factorisation in doubles, and linear in the edges and flips in FT a step.
/// Source: METHOD, step 6, "Precision".
template <class FT>
Precise_cone_metric<FT> precise_cone_metric(const Intrinsic_triangulation& input, const Cone_metric& metric,
                                            const Refined_cone_metric& refined, const FT& tolerance, Visitor& visitor)
{
  internal::Precise_newton<FT> newton(input, metric, refined);
  for (bool progresses = true; progresses && newton.error() > tolerance / 1000;) {
    if (!visitor.go_further()) throw Cancelled_error("stopped while the flat metric was made more precise");
    const FT before = newton.error();
    newton.step();
    progresses = newton.error() < before / 2;
    visitor.progress("precision: error " + internal::scientific(static_cast<double>(newton.error())));
  }
  return newton.result(tolerance);
}

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_PRECISE_CONE_METRIC_H
