// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Moving_divisor.h>

#include <Eigen/Dense>

#include <algorithm>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const double quarter_turn = CGAL_PI / 2;
using Complex = std::complex<double>;

} // namespace

Moving_divisor::Moving_divisor(const Abel_jacobi_map& map, const Divisor& divisor)
  : m_map(&map), m_divisor(divisor), m_moved_by(divisor.size(), 0)
{
  for (Singularity& s : m_divisor) {
    m_points.push_back(s.on_boundary ? map.lift_on_boundary(s.location) : map.lift(s.location));
    m_orders.push_back(s.order);
    s.location = m_points.back().location;
  }
}

Eigen::MatrixXd Moving_divisor::jacobian() const
{
  Eigen::MatrixXd j = m_map->jacobian(m_points, m_orders);
  for (Eigen::Index k = 0; k < j.rows(); ++k) j.row(k) = in_transported_frames(j.row(k).transpose()).transpose();
  return j;
}

Eigen::VectorXd Moving_divisor::in_transported_frames(const Eigen::VectorXd& in_faces) const
{
  Eigen::VectorXd v = Eigen::VectorXd::Zero(in_faces.size());
  for (std::size_t i = 0; i < size(); ++i) {
    if (m_divisor[i].pinned) continue;
    const Complex z = Complex(in_faces[2 * i], in_faces[2 * i + 1]) * std::conj(m_points[i].frame);
    v[2 * i] = z.real();
    v[2 * i + 1] = z.imag();
  }
  return v;
}

void Moving_divisor::move(const Eigen::VectorXd& step)
{
  for (std::size_t i = 0; i < size(); ++i) {
    const Complex d(step[2 * i], step[2 * i + 1]);
    if (d == 0. || m_divisor[i].pinned) continue;
    m_points[i] = m_map->moved(m_points[i], d * m_points[i].frame);
    m_divisor[i].location = m_points[i].location;
    m_moved_by[i] += std::abs(d);
  }
}

Eigen::VectorXd rounded_to_lattice(const Eigen::VectorXd& f) { return (f / quarter_turn).array().round(); }

bool is_legal(const Abel_jacobi_map& map, const Divisor& divisor, double tolerance)
{
  if (divisor.empty()) return required_degree(map.triangulation()) == 0;
  const bool stays = std::all_of(divisor.begin(), divisor.end(), [](const Singularity& s) { return s.pinned; });
  const double rounding = 1e-15 * static_cast<double>(map.triangulation().number_of_vertices());
  const Eigen::VectorXd f = map.residual(divisor);
  return (f - quarter_turn * rounded_to_lattice(f)).norm() <= (stays ? std::max(tolerance, rounding) : tolerance);
}

double longest_move(const Eigen::VectorXd& step)
{
  double longest = 0;
  for (Eigen::Index i = 0; i + 1 < step.size(); i += 2) longest = std::max(longest, step.segment<2>(i).norm());
  return longest;
}

bool move_onto_lattice(Moving_divisor& d, const Eigen::VectorXd& m, const Newton_limits& limits,
                       std::vector<double>& history, Visitor& visitor)
{
  Eigen::VectorXd f = d.residual() - quarter_turn * m;
  history.assign(1, f.norm());
  double damping = 0;
  for (int iteration = 0; iteration < limits.iterations; ++iteration) {
    if (history.back() <= limits.tolerance) return true;
    if (!visitor.go_further()) throw Cancelled_error("stopped while legalizing the divisor");
    const Eigen::MatrixXd j = d.jacobian(), jjt = j * j.transpose();
    const double scale = jjt.trace() / static_cast<double>(jjt.rows());
    for (;;) {
      const Eigen::MatrixXd damped = jjt + damping * scale * Eigen::MatrixXd::Identity(jjt.rows(), jjt.cols());
      Eigen::VectorXd step = -j.transpose() * damped.ldlt().solve(f);
      const double longest = longest_move(step);
      const double shortened = longest > limits.longest_step ? limits.longest_step / longest : 1;
      step *= shortened;
      Moving_divisor tried = d;
      tried.move(step);
      const Eigen::VectorXd f_tried = tried.residual() - quarter_turn * m;
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
  return history.back() <= limits.tolerance;
}

} } } // namespace CGAL::Quartic_differentials::internal
