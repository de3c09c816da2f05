// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/distortion_descent.h>
#include <CGAL/Quartic_differentials/internal/near_pairs.h>

#include <Eigen/Dense>

#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const double quarter_turn = CGAL_PI / 2;
const double first_step = 0.02;        // of the singularity with the largest force, times sqrt(area)
const double least_decrease = 1e-4;    // Armijo's constant
const double backtracking = 0.35;
const int    line_search_steps = 6;
const int    failures_allowed = 2;     // of the line search, each followed by a restart with steepest descent
const int    retraction_steps = 12;

// The inverse Hessian of the last steps (Nocedal and Wright, Numerical Optimization, algorithm 7.4). All vectors are in
// transported frames, so that steps and gradients of different iterations can be multiplied.
class Limited_memory_bfgs
{
public:
  explicit Limited_memory_bfgs(int memory) : m_memory(memory) {}

  bool empty() const { return m_pairs.empty(); }
  void clear() { m_pairs.clear(); }
  void add(const Eigen::VectorXd& s, const Eigen::VectorXd& y)
  {
    if (!(s.dot(y) > 1e-8 * s.norm() * y.norm())) return;   // no positive curvature along s
    m_pairs.emplace_back(s, y);
    if (m_pairs.size() > static_cast<std::size_t>(m_memory)) m_pairs.pop_front();
  }
  // \pre not empty
  Eigen::VectorXd times(Eigen::VectorXd q) const
  {
    std::vector<double> alpha;
    for (auto p = m_pairs.rbegin(); p != m_pairs.rend(); ++p) {
      alpha.push_back(p->first.dot(q) / p->first.dot(p->second));
      q -= alpha.back() * p->second;
    }
    const auto& [s, y] = m_pairs.back();
    q *= s.dot(y) / y.squaredNorm();
    for (const auto& p : m_pairs) {
      q += (alpha.back() - p.second.dot(q) / p.first.dot(p.second)) * p.first;
      alpha.pop_back();
    }
    return q;
  }

private:
  std::size_t m_memory;
  std::deque<std::pair<Eigen::VectorXd, Eigen::VectorXd>> m_pairs;
};

// A divisor with its objective.
struct State
{
  Moving_divisor  divisor;
  Eigen::VectorXd u;
  Distance_guard  guard;
  Distortion_step step;
};

class Problem
{
public:
  Problem(const Area_distortion& distortion, const std::optional<Eigen::VectorXd>& m, const Distortion_options& options,
          Visitor& visitor)
    : m_distortion(distortion), m_lattice_vector(m), m_options(options), m_visitor(visitor),
      m_size(std::sqrt(distortion.triangulation().area())), m_has_boundary(distortion.triangulation().has_boundary()) {}

  double size() const { return m_size; }

  // none where the objective is above `most`: E alone may tell, and the guard takes as long as E
  std::optional<State> state(const Moving_divisor& d, double length, double most) const
  {
    Eigen::VectorXd u = m_distortion.log_scale(d.divisor());
    const double e = m_distortion.energy(u);
    if (e > most) return std::nullopt;
    Distance_guard guard = distance_guard(m_distortion.triangulation(), d.divisor(), m_options.guard_distance * m_size,
                                          m_options.guard_strength);
    if (m_has_boundary)
      guard += boundary_guard(m_distortion.triangulation(), d.divisor(), m_options.boundary_distance * m_size,
                              m_options.guard_strength);
    if (e + guard.value > most) return std::nullopt;
    const double residual = m_lattice_vector ? (d.residual() - quarter_turn * *m_lattice_vector).norm() : 0;
    const Distortion_step step{e, e + guard.value, residual, length};
    return State{d, std::move(u), std::move(guard), step};
  }
  // of the objective, on the tangent space of F = (pi/2) m
  Eigen::VectorXd gradient(const State& s) const
  {
    const Eigen::VectorXd w = m_distortion.potential(s.u);
    const Eigen::VectorXd g = m_distortion.recovered_gradient(s.divisor.divisor(), w) + s.guard.gradient;
    return projected(s.divisor, s.divisor.in_transported_frames(g));
  }
  Eigen::VectorXd projected(const Moving_divisor& d, const Eigen::VectorXd& v) const
  {
    if (!m_lattice_vector || m_lattice_vector->size() == 0) return v;
    const Eigen::MatrixXd jt = d.jacobian().transpose();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least_squares(jt);
    least_squares.setThreshold(1e-9);
    return v - jt * least_squares.solve(v);
  }
  // walks and comes back to F = (pi/2) m; none if that fails
  std::optional<Moving_divisor> moved(Moving_divisor d, const Eigen::VectorXd& step) const
  {
    d.move(step);
    if (!m_lattice_vector || m_lattice_vector->size() == 0) return d;
    std::vector<double> history;
    const Newton_limits limits{m_options.tolerance, retraction_steps, m_options.longest_step * m_size};
    if (!move_onto_lattice(d, *m_lattice_vector, limits, history, m_visitor)) return std::nullopt;
    return d;
  }
  // backtracks along a direction until the objective decreases enough (Armijo)
  std::optional<State> line_search(const State& from, const Eigen::VectorXd& direction, double slope) const
  {
    double t = 1;
    for (int k = 0; k < line_search_steps; ++k, t *= backtracking) {
      if (!m_visitor.go_further()) throw Cancelled_error("stopped while optimising the singularities");
      const std::optional<Moving_divisor> d = moved(from.divisor, t * direction);
      if (!d) continue;
      std::optional<State> tried = state(*d, t * longest_move(direction),
                                         from.step.objective + least_decrease * t * slope);
      if (tried) return tried;
    }
    return std::nullopt;
  }

private:
  const Area_distortion&                m_distortion;
  const std::optional<Eigen::VectorXd>& m_lattice_vector;
  const Distortion_options&             m_options;
  Visitor&                              m_visitor;
  double                                m_size;
  bool                                  m_has_boundary;
};

// whether the last five steps together gained less than the given part of the objective
bool stagnates(const std::vector<Distortion_step>& h, double enough)
{
  return h.size() > 5 && h[h.size() - 6].objective - h.back().objective < enough * h.back().objective;
}

// of corners only the part along the boundary is left
void project_on_boundary(const Intrinsic_triangulation& t, const Divisor& divisor, Eigen::VectorXd& gradient)
{
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    if (!divisor[i].on_boundary) continue;
    const std::complex<double> g(gradient[2 * i], gradient[2 * i + 1]);
    const std::complex<double> along = boundary_direction(t, boundary_place(t, divisor[i].location).halfedge);
    gradient.segment<2>(2 * i) << (g * std::conj(along)).real(), 0;
  }
}

} // namespace

Distance_guard distance_guard(const Intrinsic_triangulation& t, const Divisor& divisor, double distance, double strength)
{
  std::map<std::pair<std::size_t, std::size_t>, std::complex<double>> shortest;
  const auto note = [&](std::size_t i, std::size_t k, std::complex<double> way) {
    const auto [known, is_new] = shortest.emplace(std::make_pair(i, k), way);
    if (!is_new && std::abs(way) < std::abs(known->second)) known->second = way;
  };
  visit_near_pairs(t, locations(divisor), distance, note);
  visit_near_corners(t, divisor, distance, [&](std::size_t i, std::size_t k, const Boundary_place& from,
                                               const Boundary_place& to, double way) {
    note(i, k, way * boundary_direction(t, from.halfedge));
    note(k, i, -way * boundary_direction(t, to.halfedge));
  });
  Distance_guard guard{0, Eigen::VectorXd::Zero(2 * divisor.size())};
  for (const auto& [pair, way] : shortest) {
    const double d = std::abs(way), missing = 1 - d / distance;
    // points on top of each other are driven apart in different directions
    const std::complex<double> towards = d > 1e-9 * distance ? way / d : std::polar(1.0, double(pair.first));
    guard.value += 0.5 * strength * missing * missing;   // half, as every pair is seen from both ends
    guard.gradient[2 * pair.first] += 2 * strength * missing / distance * towards.real();
    guard.gradient[2 * pair.first + 1] += 2 * strength * missing / distance * towards.imag();
  }
  project_on_boundary(t, divisor, guard.gradient);
  return guard;
}

Distance_guard boundary_guard(const Intrinsic_triangulation& t, const Divisor& divisor, double distance,
                              double strength)
{
  Distance_guard guard{0, Eigen::VectorXd::Zero(2 * divisor.size())};
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    if (divisor[i].on_boundary) continue;
    const auto way = way_to_boundary(t, divisor[i].location, distance);
    if (!way || *way == 0.) continue;
    const double d = std::abs(*way), missing = 1 - d / distance;
    const std::complex<double> slope = 2 * strength * missing / distance * *way / d;
    guard.value += strength * missing * missing;
    guard.gradient.segment<2>(2 * i) << slope.real(), slope.imag();
  }
  return guard;
}

Descent descend(const Area_distortion& distortion, const Moving_divisor& start,
                const std::optional<Eigen::VectorXd>& lattice_vector, const Distortion_options& options,
                Visitor& visitor)
{
  const Problem problem(distortion, lattice_vector, options, visitor);
  State state = *problem.state(start, 0, std::numeric_limits<double>::infinity());
  std::vector<Distortion_step> history{state.step};
  Limited_memory_bfgs inverse_hessian(options.memory);
  Eigen::VectorXd g = problem.gradient(state);
  for (int iteration = 0, failures = 0; iteration < options.iterations && longest_move(g) > 0; ++iteration) {
    const double longest = options.longest_step * problem.size();
    Eigen::VectorXd direction;
    if (!inverse_hessian.empty()) direction = -problem.projected(state.divisor, inverse_hessian.times(g));
    if (inverse_hessian.empty() || !(direction.dot(g) < -1e-12 * direction.norm() * g.norm())) {
      inverse_hessian.clear();
      direction = -g * (first_step * problem.size() / longest_move(g));
    }
    if (const double l = longest_move(direction); l > longest) direction *= longest / l;

    std::optional<State> next = problem.line_search(state, direction, direction.dot(g));
    if (!next) {
      if (inverse_hessian.empty() || ++failures > failures_allowed) break;
      inverse_hessian.clear();
      continue;
    }
    const Eigen::VectorXd g_next = problem.gradient(*next);
    inverse_hessian.add(next->step.length / longest_move(direction) * direction, g_next - g);
    state = std::move(*next);
    g = g_next;
    history.push_back(state.step);
    std::ostringstream message;
    message << "step " << history.size() - 1 << ": area distortion " << state.step.distortion;
    visitor.progress(message.str());
    if (stagnates(history, options.enough)) break;
  }
  return {std::move(state.divisor), std::move(state.u), std::move(history)};
}

} } } // namespace CGAL::Quartic_differentials::internal
