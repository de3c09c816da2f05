// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/closest_vector.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Moving_divisor.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/counted.h>
#include <CGAL/Quartic_differentials/internal/near_pairs.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>

#include <Eigen/Dense>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Moving_divisor;

const double quarter_turn = CGAL_PI / 2;

std::string signed_number(int n) { return (n > 0 ? "+" : "") + std::to_string(n); }

std::string name(const Divisor& d, std::size_t i)
{
  return "singularity " + std::to_string(i + 1) + " (order " + signed_number(d[i].order) + ")";
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

bool on_same_curve(const Intrinsic_triangulation& t, const Singularity& a, const Singularity& b)
{
  const internal::Boundary_place x = internal::boundary_place(t, a.location), y = internal::boundary_place(t, b.location);
  const double any = std::numeric_limits<double>::infinity();
  return x.halfedge == y.halfedge || std::isfinite(internal::way_along_boundary(t, x, y, any));
}

void check_corners(const Abel_jacobi_map& map, const Divisor& divisor)
{
  const Intrinsic_triangulation& t = map.triangulation();
  for (const Singularity& s : divisor)
    if (s.on_boundary) map.lift_on_boundary(s.location);
  if (divisor.size() == 2 && divisor[0].on_boundary && divisor[1].on_boundary && std::abs(divisor[0].order) == 1
      && t.genus() == 0 && t.number_of_boundary_curves() == 2 && on_same_curve(t, divisor[0], divisor[1]))
    throw Infeasible_divisor_error("corners with one and with three quads on the same curve of an annulus, and nothing else: "
                                   "the Abel-Jacobi condition forces them to coincide");
}

Legal_divisor result_of(const Moving_divisor& d, const Eigen::VectorXd& m, std::vector<double> history)
{
  Legal_divisor legal;
  legal.divisor = d.divisor();
  legal.moved_by = d.moved_by();
  legal.nearest = m;
  legal.residual = d.residual() - quarter_turn * m;
  legal.history = std::move(history);
  return legal;
}

// The divisor as it is, if it is legal: at vertices too, where a `Moving_divisor` does not begin.
std::optional<Legal_divisor> legal_as_it_is(const Abel_jacobi_map& map, const Divisor& divisor, double tolerance)
{
  if (!internal::is_legal(map, divisor, tolerance)) return std::nullopt;
  const Eigen::VectorXd f = map.residual(divisor);
  Legal_divisor legal;
  legal.nearest = internal::rounded_to_lattice(f);
  legal.residual = f - quarter_turn * legal.nearest;
  legal.divisor = divisor;
  legal.moved_by.assign(divisor.size(), 0);
  legal.history = {legal.residual.norm()};
  return legal;
}

} // namespace

void check_orders(const Divisor& divisor, int genus, int boundary_curves)
{
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    if (divisor[i].on_boundary && divisor[i].order < -1)
      throw Infeasible_divisor_error(name(divisor, i) + " is a corner of the boundary of order below -1: its angle would not "
                                     "be positive");
    if (divisor[i].order < -3)
      throw Infeasible_divisor_error(name(divisor, i) + " is a pole of order above 3: its cone angle would not be positive");
    if (divisor[i].order == 0)
      throw Infeasible_divisor_error(name(divisor, i) + " has order 0: it is a regular point, not a singularity");
  }
  const int d = degree(divisor), wanted = 8 * genus - 8 + 4 * boundary_curves;
  if (d != wanted && boundary_curves > 0)
    throw Infeasible_divisor_error("the orders of singularities and corners add up to " + std::to_string(d) + ", but on a "
                                   "surface of genus " + std::to_string(genus) + " with "
                                   + internal::counted(boundary_curves, "boundary curve")
                                   + " they must add up to 8g-8+4b = " + std::to_string(wanted) + " (Gauss-Bonnet)");
  if (d != wanted)
    throw Infeasible_divisor_error("the degree of the divisor is " + std::to_string(d) + ", but on a surface of genus "
                                   + std::to_string(genus) + " it must be 8g-8 = " + std::to_string(wanted)
                                   + " (Gauss-Bonnet)");
  if (genus == 1 && boundary_curves == 0 && divisor.size() == 2 && std::abs(divisor[0].order) == 1)
    throw Infeasible_divisor_error("one simple zero and one simple pole on a surface of genus 1: the Abel-Jacobi "
                                   "condition forces them to coincide");
}

Nearest_singularities nearest_singularities(const Intrinsic_triangulation& t, const std::vector<Surface_point>& points,
                                            double radius)
{
  Nearest_singularities nearest{0, 0, std::numeric_limits<double>::infinity()};
  internal::visit_near_pairs(t, points, radius, [&](std::size_t i, std::size_t k, std::complex<double> way) {
    if (std::abs(way) < nearest.distance) nearest = {std::min(i, k), std::max(i, k), std::abs(way)};
  });
  return nearest;
}

Nearest_singularities nearest_singularities(const Intrinsic_triangulation& t, const Divisor& divisor, double radius)
{
  Nearest_singularities nearest = nearest_singularities(t, locations(divisor), radius);
  internal::visit_near_corners(t, divisor, radius, [&](std::size_t i, std::size_t k, const internal::Boundary_place&,
                                                       const internal::Boundary_place&, double way) {
    if (way < nearest.distance) nearest = {std::min(i, k), std::max(i, k), way};
  });
  return nearest;
}

std::string collision(const Intrinsic_triangulation& t, const Divisor& d, double least)
{
  const double size = std::sqrt(t.area());
  const auto text = [&](double distance, double wanted) {
    return " (distance " + std::to_string(distance / size) + ", at least " + std::to_string(wanted)
         + " sqrt(area) is asked for)";
  };
  const Nearest_singularities n = nearest_singularities(t, d, least * size);
  if (n.distance < least * size) return name(d, n.first) + " and " + name(d, n.second) + text(n.distance, least);
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (d[i].on_boundary) continue;
    const auto way = internal::way_to_boundary(t, d[i].location, 0.5 * least * size);
    if (way) return name(d, i) + " and the boundary" + text(std::abs(*way), 0.5 * least);
  }
  return {};
}

Eigen::MatrixXd lattice_gram(Lattice_norm norm, const Eigen::MatrixXd& jacobian, const Eigen::MatrixXcd& pi)
{
  if (norm == Lattice_norm::movement) {
    const Eigen::MatrixXd gram = quarter_turn * quarter_turn * (jacobian * jacobian.transpose()).inverse();
    return 0.5 * (gram + gram.transpose());
  }
  const Eigen::Index g = pi.rows();
  const Eigen::MatrixXd X = pi.real(), Y = pi.imag();
  // z = -q + Pi p, real and imaginary part (METHOD, Abel-Jacobi map), and the matrix of the norm of C^g
  Eigen::MatrixXd real(g, 2 * g), imaginary(g, 2 * g);
  real << X, -Eigen::MatrixXd::Identity(g, g);
  imaginary << Y, Eigen::MatrixXd::Zero(g, g);
  const Eigen::MatrixXd N = norm == Lattice_norm::invariant ? Eigen::MatrixXd(Y.inverse())
                                                            : Eigen::MatrixXd::Identity(g, g);
  const Eigen::MatrixXd gram = real.transpose() * N * real + imaginary.transpose() * N * imaginary;
  return 0.5 * (gram + gram.transpose());
}

Lattice_candidates nearest_lattice_vectors(const internal::Moving_divisor& d, const Period_matrix& periods,
                                           const Legalization_options& options)
{
  const Eigen::MatrixXd j = d.jacobian();
  require_full_rank(j);
  if (options.norm != Lattice_norm::movement && 2 * periods.pi.rows() != j.rows())
    throw Infeasible_divisor_error("the norms of C^g belong to closed surfaces and their period matrices: take the norm "
                                   "of least movement");
  Closest_vector_options lattice;
  lattice.count = options.lattice_vectors;
  lattice.radius_factor = 2;
  const Eigen::MatrixXd gram = lattice_gram(options.norm, j, periods.pi);
  const Eigen::VectorXd x = d.residual() / quarter_turn;
  if (!options.solver) throw Error("there is no closest vector solver");
  const Closest_vectors closest = options.solver(gram, x, lattice);
  check_closest_vectors(closest, gram, x, lattice);
  Lattice_candidates candidates{{}, closest.optimal};
  for (const Lattice_vector& v : closest.vectors) {
    candidates.vectors.emplace_back(v.coefficients.size());
    for (std::size_t k = 0; k < v.coefficients.size(); ++k)
      candidates.vectors.back()[k] = static_cast<double>(v.coefficients[k]);
  }
  return candidates;
}

Legal_divisor legalize_divisor(const Abel_jacobi_map& map, const Period_matrix& periods, const Divisor& divisor,
                               const Legalization_options& options, Visitor& visitor)
{
  const Intrinsic_triangulation& t = map.triangulation();
  check_orders(divisor, t.genus(), t.number_of_boundary_curves());
  check_corners(map, divisor);
  const double size = std::sqrt(t.area());

  const Moving_divisor start(map, divisor);
  if (const std::string reason = collision(t, start.divisor(), options.least_distance); !reason.empty())
    throw Infeasible_divisor_error("too near each other: " + reason);

  if (const std::optional<Legal_divisor> legal = legal_as_it_is(map, divisor, options.tolerance)) return *legal;

  const Lattice_candidates candidates = nearest_lattice_vectors(start, periods, options);
  const internal::Newton_limits limits{options.tolerance, options.iterations, options.longest_step * size};
  std::string collided;
  double best = std::numeric_limits<double>::infinity();
  int tried = 0;
  for (const Eigen::VectorXd& m : candidates.vectors) {
    ++tried;
    Moving_divisor d = start;
    std::vector<double> history;
    const bool reached = internal::move_onto_lattice(d, m, limits, history, visitor);
    visitor.progress("lattice vector " + std::to_string(tried) + ": |F| " + std::to_string(history.front()) + " -> "
                     + std::to_string(history.back()) + " in " + std::to_string(history.size() - 1) + " steps");
    if (!reached) {
      best = std::min(best, history.back());
      continue;
    }
    const std::string reason = collision(t, d.divisor(), options.least_distance);
    if (!reason.empty()) {
      collided = reason;
      continue;
    }
    Legal_divisor legal = result_of(d, m, std::move(history));
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

Legal_divisor legalize_divisor(const Abel_jacobi_map& map, const Divisor& divisor, const Legalization_options& options,
                               Visitor& visitor)
{
  return legalize_divisor(map, Period_matrix(), divisor, options, visitor);
}

} } // namespace CGAL::Quartic_differentials
