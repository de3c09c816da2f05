// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/internal/Timed_step.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/cone_insertion.h>
#include <CGAL/Quartic_differentials/internal/face_frames.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Inserted_cones;
using internal::Length_derivatives;
using internal::scientific;

const double pi = CGAL_PI;
const double near_error = 1;   // of curvature, radians: from there on the Laplacian changes little

double largest(const Eigen::VectorXd& x) { return x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff(); }

// The flat metric that is being computed, and the data that ride along its flips.
struct Flow
{
  Cone_metric        metric;
  Length_derivatives lambda;
  std::vector<char>  frozen;
  bool               has_boundary = false;
};

// Whether the lengths satisfy all triangle inequalities. Ideal Delaunay triangulations do, but for boundary edges, which
// cannot be flipped.
bool is_metric(const Flow& flow)
{
  if (!flow.has_boundary) return true;
  const Cone_metric& m = flow.metric;
  return std::all_of(m.triangulation.faces().begin(), m.triangulation.faces().end(), [&](Face f) {
    const auto [h0, h1, h2] = m.triangulation.halfedges(f);
    const auto length = [&](Halfedge h) { return m.lengths[m.triangulation.edge(h)]; };
    return four_times_area(length(h0), length(h1), length(h2)) > 0;
  });
}

// Makes the triangulation Delaunay for the scales u and evaluates lengths, angles and curvature there.
std::vector<double> evaluate(Flow& flow, const std::vector<double>& u)
{
  Cone_metric& m = flow.metric;
  m.flow.flips += make_ideal_delaunay(m.triangulation, u, m.cochains, flow.lambda);
  for (Edge e : m.triangulation.edges()) {
    const Halfedge h = m.triangulation.halfedge(e);
    m.lengths[e] = m.triangulation.length(e) * std::exp(0.5 * (u[m.triangulation.source(h)] + u[m.triangulation.target(h)]));
  }
  m.angles = corner_angles(m.triangulation, m.lengths);
  return curvatures(m.triangulation, m.angles);
}

// K - target
Eigen::VectorXd curvature_error(const Cone_metric& m, const std::vector<double>& k)
{
  Eigen::VectorXd r(k.size());
  for (std::size_t v = 0; v < k.size(); ++v) r[v] = k[v] + m.order[v] * pi / 2;
  return r;
}

std::vector<double> moved_scales(const std::vector<double>& u, double step, const Eigen::VectorXd& direction)
{
  std::vector<double> result(u);
  for (std::size_t v = 0; v < u.size(); ++v) result[v] += step * direction[v];
  return result;
}

// the vertices next to these, and themselves
std::vector<Vertex> with_neighbours(const Intrinsic_triangulation& t, const std::vector<Vertex>& vertices)
{
  std::set<Vertex> result(vertices.begin(), vertices.end());
  for (Vertex v : vertices) {
    const Halfedge first = t.halfedge_from(v);
    Halfedge h = first;
    do { result.insert(t.target(h)); h = t.next_around_source(h); } while (h != first);
  }
  return {result.begin(), result.end()};
}

// Sweeps of Gauss and Seidel's method for L d = -error at some vertices.
void relax(const Intrinsic_triangulation& t, const std::vector<double>& weights, const Eigen::VectorXd& error,
           const std::vector<Vertex>& vertices, Eigen::VectorXd& d)
{
  const int sweeps = 20;
  for (int k = 0; k < sweeps; ++k)
    for (Vertex v : vertices) {
      double sum = -error[v], weight = 0;
      const Halfedge first = t.halfedge_from(v);
      Halfedge h = first;
      do {
        if (t.target(h) != v) {
          sum += weights[t.edge(h)] * d[t.target(h)];
          weight += weights[t.edge(h)];
        }
        h = t.next_around_source(h);
      } while (h != first);
      if (weight > 0) d[v] = sum / weight;
    }
}

// The relative residual with which a step of Newton's method is to be solved for, so that it adds no more than the step
// leaves anyway, a fraction of the square of the error, and less than the goal (Dembo, Eisenstat and Steihaug, "Inexact
// Newton methods", 1982).
double enough(double error, double goal) { return 0.2 * std::max(error, goal / error); }

// The direction of Newton's first step from u = 0, nearly, without a factorisation of its own: the linear theory on the
// surface without the cones is this step but for the triangles round them, where it is relaxed.
// \param error K - target at u = 0
Eigen::VectorXd first_direction(const Intrinsic_triangulation& t, const Divisor& divisor, const Cone_metric& m,
                                const Laplacian_solver& factorized, const Eigen::VectorXd& error)
{
  const Eigen::VectorXd u = Area_distortion(t, factorized, vertex_areas(t)).log_scale(divisor);
  Eigen::VectorXd direction(m.u.size());
  direction.head(u.size()) = u;
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    if (m.cones[i].idx() < t.number_of_vertices()) continue;   // it took a vertex
    const Surface_point& p = divisor[i].location;
    const auto h = t.halfedges(p.face);
    direction[m.cones[i]] = 0;
    for (int k = 0; k < 3; ++k) direction[m.cones[i]] += p.barycentric[k] * u[t.source(h[k])];
  }
  const std::vector<Vertex> near = with_neighbours(m.triangulation, with_neighbours(m.triangulation, m.cones));
  relax(m.triangulation, cotangent_weights(m.triangulation, m.lengths), error, near, direction);
  return direction;
}

// Goes along a direction, by the first step of d, d/2, d/4 .. that `is_good(error, step)` accepts, at which triangle
// inequalities hold. If none does, all stays as it was.
template <class Is_good>
bool step_along(Flow& flow, const Eigen::VectorXd& direction, double shortest, Eigen::VectorXd& error, Is_good is_good)
{
  Cone_metric& m = flow.metric;
  const double longest = largest(direction);
  for (double step = longest > 10 ? 10 / longest : 1; step > shortest; step /= 2) {
    const std::vector<double> u = moved_scales(m.u, step, direction);
    const Eigen::VectorXd tried = curvature_error(m, evaluate(flow, u));
    if (!is_metric(flow) || !is_good(tried, step)) continue;
    error = tried;
    m.u = u;
    return true;
  }
  error = curvature_error(m, evaluate(flow, m.u));
  return false;
}

// Newton's method: L d = -(K - target). Along d the norm of the error falls at first, so that a step that shrinks it is
// always found, but for rounding. Once the tolerance is reached, full steps with the last factorisation go on as long as
// they halve the error, down to a hundredth of it: what is left at the vertices adds up along loops.
// \param first the direction of the first step by the error there, or empty
void newton(Flow& flow, const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& first, Laplacian_solver& laplacian,
            const Cone_metric_options& options, Visitor& visitor)
{
  Cone_metric& m = flow.metric;
  Eigen::VectorXd error = curvature_error(m, evaluate(flow, m.u));
  if (!is_metric(flow)) {   // from a metric for other positions: begin with the surface itself
    m.u.assign(m.u.size(), 0);
    error = curvature_error(m, evaluate(flow, m.u));
  }
  m.flow.history.assign(1, largest(error));
  bool factorized = false, is_given = static_cast<bool>(first);
  const double goal = 0.01 * m.flow.tolerance;
  while (m.flow.history.back() > goal && m.flow.newton_iterations < options.newton_iterations) {
    if (!visitor.go_further()) throw Cancelled_error("stopped during the discrete Ricci flow");
    const double largest_error = m.flow.history.back();
    const bool polishing = largest_error <= m.flow.tolerance, near = largest_error < near_error;
    if (!is_given && (!polishing || !factorized)) {
      const std::vector<double> weights = cotangent_weights(m.triangulation, m.lengths);
      near ? laplacian.update(m.triangulation, weights) : laplacian.factorize(m.triangulation, weights);
      factorized = true;
    }
    // the errors add up to zero (Gauss-Bonnet) but for rounding, which is spread evenly
    Eigen::VectorXd direction = is_given ? first(error)
                                         : -laplacian.solve((error.array() - error.mean()).matrix(),
                                                            enough(largest_error, goal)).col(0);
    direction.array() -= direction.mean();
    const bool accepted = polishing
      ? step_along(flow, direction, 0.75, error,
                   [&](const Eigen::VectorXd& e, double) { return largest(e) < 0.5 * largest_error; })
      : step_along(flow, direction, 1e-8, error, [norm = error.norm()](const Eigen::VectorXd& e, double step) {
          return e.norm() < norm * (1 - 1e-4 * step);
        });
    if (!std::exchange(is_given, false) && !accepted) break;   // stagnation: rounding is reached
    if (!accepted) continue;
    ++(polishing ? m.flow.polishing_steps : m.flow.newton_iterations);
    m.flow.history.push_back(largest(error));
    visitor.progress("flow, step " + std::to_string(m.flow.history.size() - 1) + ": curvature error "
                     + scientific(m.flow.history.back()) + ", " + std::to_string(m.flow.flips) + " flips");
  }
  m.flow.max_curvature_error = largest(error);
}

Flow flow_of(const Intrinsic_triangulation& t, const Integer_cochains& cochains, const Divisor& divisor,
             const Cone_metric* warm_start, const Laplacian_solver* factorized, Laplacian_solver& laplacian,
             const Cone_metric_options& options, Visitor& visitor)
{
  Inserted_cones inserted = internal::insert_cones(t, cochains, divisor);
  Flow flow;
  flow.lambda = Length_derivatives(inserted.triangulation, inserted.frames);
  flow.frozen = inserted.frozen;
  flow.has_boundary = t.has_boundary();
  Cone_metric& m = flow.metric;
  m.triangulation = std::move(inserted.triangulation);
  m.cochains = std::move(inserted.cochains);
  m.cones = inserted.cones;
  const std::size_t n = m.triangulation.number_of_vertices();
  m.order.assign(n, 0);
  m.u.assign(n, 0);
  if (warm_start != nullptr)
    std::copy_n(warm_start->u.begin(), t.number_of_vertices(), m.u.begin());
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    m.order[m.cones[i]] = divisor[i].order;
    if (warm_start != nullptr) m.u[m.cones[i]] = warm_start->u[warm_start->cones[i]];
  }
  m.lengths.resize(m.triangulation.number_of_edges());
  m.flow.tolerance = options.curvature_tolerance > 0 ? options.curvature_tolerance : 1e-11 + 1e-15 * static_cast<double>(n);
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> first;
  if (warm_start == nullptr && factorized != nullptr)
    first = [&](const Eigen::VectorXd& error) { return first_direction(t, divisor, m, *factorized, error); };
  newton(flow, first, laplacian, options, visitor);
  return flow;
}

Eigen::MatrixXd jacobian(const Flow& flow, Laplacian_solver& laplacian)
{
  const Cone_metric& m = flow.metric;
  const std::vector<double> weights = cotangent_weights(m.triangulation, m.lengths);
  laplacian.factorize(m.triangulation, weights);
  const Harmonic_1_forms omega = harmonic_1_forms(m.triangulation, m.cochains, weights, laplacian);
  return internal::turning_derivative(m.triangulation, m.angles, flow.lambda, m.cones.size(), omega);
}

Eigen::VectorXd quarter_turn_defects(const Eigen::VectorXd& turning)
{
  return turning.unaryExpr([](double x) { return quarter_turn_defect(x); });
}

void move_cones(const Intrinsic_triangulation& t, const Eigen::VectorXd& step, Divisor& divisor,
                std::vector<double>& moved_by)
{
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    const std::complex<double> d(step[2 * i], step[2 * i + 1]);
    if (d == 0.) continue;
    const auto crossing = [](const Surface_point&, const Surface_point&) {};
    Surface_point& p = divisor[i].location;
    p = divisor[i].on_boundary ? internal::slide(t, p, d.real(), crossing) : internal::walk(t, p, d, crossing).point;
    moved_by[i] += std::abs(d);
  }
}

bool has_full_rank(const Eigen::MatrixXd& j)
{
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(j * j.transpose());
  return lu.rank() == j.rows();
}

// Moves the cones that were frozen only because they are at a vertex 1e-3 of an edge into their face, and corners along
// their boundary edge.
bool move_off_vertices(const Intrinsic_triangulation& t, const std::vector<char>& frozen, Divisor& divisor)
{
  bool moved = false;
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    if (!frozen[i] || divisor[i].pinned) continue;
    moved = true;
    Surface_point& p = divisor[i].location;
    if (divisor[i].on_boundary) {
      const auto [h, fraction] = internal::boundary_place(t, p);
      p = on_edge(t, h, (1 - 2e-3) * fraction + 1e-3);
      continue;
    }
    for (double& b : p.barycentric) b = (1 - 3e-3) * b + 1e-3;
  }
  return moved;
}

void refuse_collisions(const Intrinsic_triangulation& t, const Divisor& divisor, double least)
{
  if (const std::string reason = collision(t, divisor, least); !reason.empty())
    throw Colliding_singularities_error("making the holonomy exact drives together " + reason);
}

} // namespace

double quarter_turn_defect(double angle) { return internal::quarter_turn_defect(angle, pi); }

double max_transition_error(const Intrinsic_triangulation& t, const std::vector<double>& angles)
{
  return internal::max_transition_error(t, angles);
}

Cone_metric cone_metric(const Intrinsic_triangulation& t, const Integer_cochains& cochains, const Divisor& divisor,
                        const Cone_metric* warm_start, const Cone_metric_options& options, Visitor& visitor,
                        const Laplacian_solver* factorized)
{
  Laplacian_solver laplacian;
  if (factorized != nullptr) laplacian.set_order_of(*factorized);
  return flow_of(t, cochains, divisor, warm_start, factorized, laplacian, options, visitor).metric;
}

Eigen::MatrixXd holonomy_jacobian(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                  const Divisor& divisor, const Cone_metric_options& options, Visitor& visitor)
{
  Laplacian_solver laplacian;
  const Flow flow = flow_of(t, cochains, divisor, nullptr, nullptr, laplacian, options, visitor);
  return jacobian(flow, laplacian);
}

Exact_cone_metric exact_cone_metric(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                    const Divisor& divisor, const Cone_metric_options& options, Visitor& visitor,
                                    const Laplacian_solver* factorized)
{
  Exact_cone_metric result;
  result.divisor = divisor;
  result.moved_by.assign(divisor.size(), 0);
  Laplacian_solver laplacian;
  if (factorized != nullptr) laplacian.set_order_of(*factorized);
  const auto first_flow = [&] {
    const internal::Timed_step step(visitor, "cone_metric");
    return flow_of(t, cochains, divisor, nullptr, factorized, laplacian, options, visitor);
  };
  Flow flow = first_flow();
  result.first_flow = flow.metric.flow;
  const internal::Timed_step step(visitor, "holonomy");
  const auto turning = [](const Flow& f) {
    return turning_numbers(f.metric.triangulation, f.metric.cochains, f.metric.angles);
  };
  Eigen::VectorXd defect = quarter_turn_defects(turning(flow));
  result.history.assign(1, largest(defect));

  for (int iteration = 0; iteration < options.outer_iterations && !divisor.empty(); ++iteration) {
    if (result.history.back() <= options.holonomy_tolerance || !flow.metric.flow.is_near()) break;
    Eigen::MatrixXd j = jacobian(flow, laplacian);
    if (!has_full_rank(j)) {
      if (!move_off_vertices(t, flow.frozen, result.divisor))
        throw Infeasible_divisor_error("the singularities that may move cannot make the holonomy exact "
                                       "(rank of the Jacobian below " + std::to_string(j.rows())
                                       + "): pin fewer of them");
      flow = flow_of(t, cochains, result.divisor, &flow.metric, nullptr, laplacian, options, visitor);
      defect = quarter_turn_defects(turning(flow));
      j = jacobian(flow, laplacian);
    }
    const Eigen::VectorXd full_step = -j.transpose() * (j * j.transpose()).ldlt().solve(defect);
    bool accepted = false;
    for (double step = 1; step > 0.02 && !accepted; step /= 2) {
      Divisor tried = result.divisor;
      std::vector<double> moved_by = result.moved_by;
      move_cones(t, step * full_step, tried, moved_by);
      Flow tried_flow = flow_of(t, cochains, tried, &flow.metric, nullptr, laplacian, options, visitor);
      const Eigen::VectorXd tried_defect = quarter_turn_defects(turning(tried_flow));
      accepted = tried_flow.metric.flow.is_near() && tried_defect.norm() < defect.norm();
      if (!accepted) continue;
      result.divisor = tried;
      result.moved_by = moved_by;
      flow = std::move(tried_flow);
      defect = tried_defect;
      result.history.push_back(largest(defect));
      visitor.progress("holonomy, step " + std::to_string(iteration + 1) + ": error " + scientific(result.history.back()));
    }
    if (!accepted) break;   // stagnation: rounding is reached, or the flow fails
  }
  if (!divisor.empty()) refuse_collisions(t, result.divisor, options.least_distance);

  result.turning = turning(flow);
  result.max_holonomy_error = result.history.back();
  result.max_transition_error = max_transition_error(flow.metric.triangulation, flow.metric.angles);
  result.metric = std::move(flow.metric);
  result.reached = result.metric.flow.reached() && result.max_holonomy_error <= options.accepted_holonomy
                && result.max_transition_error <= options.accepted_holonomy;
  return result;
}

} } // namespace CGAL::Quartic_differentials
