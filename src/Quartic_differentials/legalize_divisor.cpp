// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/closest_vector.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/geodesic_disk.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>

#include <Eigen/Dense>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double pi = CGAL_PI;
const double quarter_turn = pi / 2;

std::string signed_number(int n) { return (n > 0 ? "+" : "") + std::to_string(n); }

std::string name(const Divisor& d, std::size_t i)
{
  return "singularity " + std::to_string(i + 1) + " (order " + signed_number(d[i].order) + ")";
}

// Positions while they are moved, with the orders and which may move.
struct Moving_divisor
{
  Lifted_divisor      points;
  std::vector<int>    orders;
  std::vector<char>   pinned;
  std::vector<double> moved_by;

  // no column where a singularity is pinned
  Eigen::MatrixXd jacobian(const Abel_jacobi_map& map) const
  {
    Eigen::MatrixXd j = map.jacobian(points, orders);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (pinned[i]) j.middleCols(2 * i, 2).setZero();
    return j;
  }
  Eigen::VectorXd residual(const Abel_jacobi_map& map) const { return map.residual(points, orders); }

  void move(const Abel_jacobi_map& map, const Eigen::VectorXd& step)
  {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::complex<double> d(step[2 * i], step[2 * i + 1]);
      if (d == 0.) continue;
      points[i] = map.moved(points[i], d);
      moved_by[i] += std::abs(d);
    }
  }
};

double longest_move(const Eigen::VectorXd& step)
{
  double longest = 0;
  for (Eigen::Index i = 0; i + 1 < step.size(); i += 2) longest = std::max(longest, step.segment<2>(i).norm());
  return longest;
}

int rank(const Eigen::MatrixXd& j)
{
  if (j.size() == 0) return 0;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(j);
  svd.setThreshold(1e-10);
  return static_cast<int>(svd.rank());
}

void require_full_rank(const Eigen::MatrixXd& j)
{
  const int r = rank(j);
  if (r < j.rows())
    throw Infeasible_divisor_error("the singularities that may move control only " + std::to_string(r) + " of the "
                                   + std::to_string(j.rows()) + " Abel-Jacobi conditions (rank of the Jacobian): "
                                   "add singularities, or pin fewer of them");
}

// The Gram matrix of the norm in which the integer program is solved, in the coordinates F / (pi/2).
Eigen::MatrixXd lattice_gram(const Eigen::MatrixXd& j, const Period_matrix& periods, Lattice_norm norm)
{
  const int n = static_cast<int>(j.rows()), g = n / 2;
  Eigen::MatrixXd gram(n, n);
  if (norm == Lattice_norm::movement) {
    gram = quarter_turn * quarter_turn * (j * j.transpose()).inverse();
  } else {   // |-rho_b + Pi rho_a|^2 (METHOD, Abel-Jacobi map)
    gram.topLeftCorner(g, g) = (periods.pi.adjoint() * periods.pi).real();
    gram.topRightCorner(g, g) = -periods.pi.real().transpose();
    gram.bottomLeftCorner(g, g) = -periods.pi.real();
    gram.bottomRightCorner(g, g).setIdentity();
  }
  return 0.5 * (gram + gram.transpose());
}

// Gauss-Newton steps of minimal norm towards F = (pi/2) m, damped (Levenberg) where the full step does not help.
// Returns whether the tolerance was reached.
bool reach(const Abel_jacobi_map& map, const Eigen::VectorXd& m, const Legalization_options& options, double size,
           Moving_divisor& d, std::vector<double>& history, Visitor& visitor)
{
  Eigen::VectorXd f = d.residual(map) - quarter_turn * m;
  history.assign(1, f.norm());
  double damping = 0;
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    if (history.back() <= options.tolerance) return true;
    if (!visitor.go_further()) throw Cancelled_error("stopped while legalizing the divisor");
    const Eigen::MatrixXd j = d.jacobian(map), jjt = j * j.transpose();
    const double scale = jjt.trace() / static_cast<double>(jjt.rows());
    for (;;) {
      const Eigen::MatrixXd damped = jjt + damping * scale * Eigen::MatrixXd::Identity(jjt.rows(), jjt.cols());
      Eigen::VectorXd step = -j.transpose() * damped.ldlt().solve(f);
      const double longest = longest_move(step), cap = options.longest_step * size;
      const double shortened = longest > cap ? cap / longest : 1;
      step *= shortened;
      Moving_divisor tried = d;
      tried.move(map, step);
      const Eigen::VectorXd f_tried = tried.residual(map) - quarter_turn * m;
      if (f_tried.norm() < history.back() * (1 - 1e-3 * shortened)) {
        d = std::move(tried);
        f = f_tried;
        history.push_back(f.norm());
        damping = damping > 1e-8 ? damping / 10 : 0;
        break;
      }
      damping = std::max(4 * damping, 1e-3);
      if (damping > 1e6) return false;
    }
  }
  return history.back() <= options.tolerance;
}

std::vector<Surface_point> locations(const Lifted_divisor& points)
{
  std::vector<Surface_point> result;
  for (const Lifted_point& p : points) result.push_back(p.location);
  return result;
}

// Two singularities that are too near each other and their distance, or "".
std::string collision(const Intrinsic_triangulation& t, const Divisor& d, const Lifted_divisor& points, double least,
                      double size)
{
  const Nearest_singularities n = nearest_singularities(t, locations(points), least * size);
  if (!(n.distance < least * size)) return {};
  return name(d, n.first) + " and " + name(d, n.second) + " (distance "
       + std::to_string(n.distance / size) + ", at least " + std::to_string(least) + " sqrt(area) is asked for)";
}

Legal_divisor result_of(const Divisor& divisor, const Moving_divisor& d, const Abel_jacobi_map& map,
                        const Eigen::VectorXd& m, std::vector<double> history)
{
  Legal_divisor legal;
  legal.divisor = divisor;
  for (std::size_t i = 0; i < divisor.size(); ++i) legal.divisor[i].location = d.points[i].location;
  legal.moved_by = d.moved_by;
  legal.nearest = m;
  legal.residual = d.residual(map) - quarter_turn * m;
  legal.history = std::move(history);
  return legal;
}

} // namespace

void check_orders(const Divisor& divisor, int genus)
{
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    if (divisor[i].order < -3)
      throw Infeasible_divisor_error(name(divisor, i) + " is a pole of order above 3: its cone angle would not be positive");
    if (divisor[i].order == 0)
      throw Infeasible_divisor_error(name(divisor, i) + " has order 0: it is a regular point, not a singularity");
  }
  if (const int d = degree(divisor); d != 8 * genus - 8)
    throw Infeasible_divisor_error("the degree of the divisor is " + std::to_string(d) + ", but on a surface of genus "
                                   + std::to_string(genus) + " it must be 8g-8 = " + std::to_string(8 * genus - 8)
                                   + " (Gauss-Bonnet)");
  if (genus == 1 && divisor.size() == 2 && std::abs(divisor[0].order) == 1)
    throw Infeasible_divisor_error("one simple zero and one simple pole on a surface of genus 1: the Abel-Jacobi "
                                   "condition forces them to coincide");
}

Nearest_singularities nearest_singularities(const Intrinsic_triangulation& t, const std::vector<Surface_point>& points,
                                            double radius)
{
  Nearest_singularities nearest{0, 0, std::numeric_limits<double>::infinity()};
  std::vector<std::vector<std::size_t>> in_face(t.number_of_faces());
  for (std::size_t i = 0; i < points.size(); ++i) in_face[points[i].face].push_back(i);
  for (std::size_t i = 0; i < points.size(); ++i)
    internal::explore_geodesic_disk(t, points[i], radius, [&](Face f, const std::array<std::complex<double>, 3>& corner,
                                                              std::complex<double> right, std::complex<double> left) {
      for (std::size_t k : in_face[f]) {
        if (k == i) continue;
        const std::complex<double> z = internal::point_in_frame(corner, points[k].barycentric);
        if (right != left && (internal::cross(right, z) < 0 || internal::cross(z, left) < 0)) continue;   // not in sight
        if (std::abs(z) < nearest.distance) nearest = {std::min(i, k), std::max(i, k), std::abs(z)};
      }
    });
  return nearest;
}

Legal_divisor legalize_divisor(const Abel_jacobi_map& map, const Period_matrix& periods, const Divisor& divisor,
                               const Legalization_options& options, Visitor& visitor)
{
  const Intrinsic_triangulation& t = map.triangulation();
  check_orders(divisor, map.dimension() / 2);
  const double size = std::sqrt(t.area());

  Moving_divisor start;
  for (const Singularity& s : divisor) {
    start.points.push_back(map.lift(s.location));
    start.orders.push_back(s.order);
    start.pinned.push_back(s.pinned);
    start.moved_by.push_back(0);
  }
  if (const std::string reason = collision(t, divisor, start.points, options.least_distance, size); !reason.empty())
    throw Infeasible_divisor_error("too near each other: " + reason);

  const Eigen::VectorXd x = start.residual(map) / quarter_turn;
  const Eigen::VectorXd rounded = x.array().round();
  if (divisor.empty() || quarter_turn * (x - rounded).norm() <= options.tolerance)   // legal as it is
    return result_of(divisor, start, map, rounded, {quarter_turn * (x - rounded).norm()});

  const Eigen::MatrixXd j = start.jacobian(map);
  require_full_rank(j);
  Closest_vector_options lattice;
  lattice.count = options.lattice_vectors;
  lattice.radius_factor = 2;
  const Closest_vectors candidates = closest_vectors(lattice_gram(j, periods, options.norm), x, lattice);

  std::string collided;
  double best = std::numeric_limits<double>::infinity();
  int tried = 0;
  for (const Lattice_vector& candidate : candidates.vectors) {
    ++tried;
    Eigen::VectorXd m(x.size());
    for (Eigen::Index k = 0; k < m.size(); ++k) m[k] = static_cast<double>(candidate.coefficients[k]);
    Moving_divisor d = start;
    std::vector<double> history;
    const bool reached = reach(map, m, options, size, d, history, visitor);
    visitor.progress("lattice vector " + std::to_string(tried) + ": |F| " + std::to_string(history.front()) + " -> "
                     + std::to_string(history.back()) + " in " + std::to_string(history.size() - 1) + " steps");
    if (!reached) {
      best = std::min(best, history.back());
      continue;
    }
    const std::string reason = collision(t, divisor, d.points, options.least_distance, size);
    if (!reason.empty()) {
      collided = reason;
      continue;
    }
    Legal_divisor legal = result_of(divisor, d, map, m, std::move(history));
    legal.certified = candidates.optimal;
    legal.tried = tried;
    return legal;
  }
  if (!collided.empty()) throw Infeasible_divisor_error("singularities run into each other: " + collided
                                                        + ", for each of the " + std::to_string(tried)
                                                        + " nearest lattice vectors that could be reached");
  throw Numerical_error("no lattice vector of " + std::to_string(tried) + " could be reached by moving the singularities; "
                        "the best residual is " + std::to_string(best) + " rad");
}

} } // namespace CGAL::Quartic_differentials
