// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/face_frames.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double pi = CGAL_PI;

// Sum_j order_j ^g(z_j), on sheet 0
Eigen::VectorXd potential_of(const Abel_jacobi_map& map, const std::vector<Holomorphic_zero>& zeros)
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(map.dimension());
  for (const Holomorphic_zero& z : zeros) sum += z.order * map.potential(map.lift(z.location)).transpose();
  return sum;
}

} // namespace

Eigen::VectorXd turning_numbers(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                const std::vector<double>& angles)
{
  const std::vector<double> turning = internal::turning_numbers(t, cochains, angles);
  return Eigen::Map<const Eigen::VectorXd>(turning.data(), cochains.size());
}

Abel_jacobi_map::Abel_jacobi_map(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                 const Harmonic_1_forms& forms)
  : m_t(t), m_forms(forms)
{
  const std::vector<double> angles = corner_angles(t, t.lengths()), k = curvatures(t, angles);
  m_constant = turning_numbers(t, cochains, angles)
             - forms.potential.transpose() * Eigen::Map<const Eigen::VectorXd>(k.data(), k.size());
}

Abel_jacobi_map::Abel_jacobi_map(const Intrinsic_triangulation& t, const Harmonic_1_forms& forms,
                                 const std::vector<Holomorphic_zero>& zeros)
  : m_t(t), m_forms(forms), m_constant(Eigen::VectorXd::Zero(forms.size()))
{
  m_constant = 2 * pi * potential_of(*this, zeros);
}

Lifted_point Abel_jacobi_map::lift(const Surface_point& p) const
{
  const bool on_boundary = *std::min_element(p.barycentric.begin(), p.barycentric.end()) < internal::inward;
  return {on_boundary ? internal::moved_inside(p, internal::inward) : p, Eigen::RowVectorXd::Zero(dimension()), 1};
}

Lifted_point Abel_jacobi_map::lift_on_boundary(const Surface_point& p) const
{
  if (internal::boundary_place(m_t, p).halfedge == Mesh::null_halfedge())
    throw Infeasible_divisor_error("a singularity in face " + std::to_string(p.face.idx()) + " is marked as a corner of the "
                                   "boundary, but it is not on a boundary edge of this face");
  return {p, Eigen::RowVectorXd::Zero(dimension()), 1, true};
}

Eigen::RowVectorXd Abel_jacobi_map::potential_in_face(const Surface_point& p) const
{
  const auto [h0, h1, h2] = m_t.halfedges(p.face);
  return m_forms.potential.row(m_t.source(h0)) + p.barycentric[1] * m_forms.row(h0) - p.barycentric[2] * m_forms.row(h2);
}

Eigen::RowVectorXd Abel_jacobi_map::potential(const Lifted_point& p) const
{
  return potential_in_face(p.location) + p.sheet;
}

Lifted_point Abel_jacobi_map::moved(const Lifted_point& p, std::complex<double> displacement) const
{
  Lifted_point q = p;
  const auto crossing = [&](const Surface_point& before, const Surface_point& after) {
    q.sheet += (potential_in_face(before) - potential_in_face(after)).array().round().matrix();
  };
  if (p.on_boundary) {
    q.location = internal::slide(m_t, p.location, displacement.real(), crossing);
    return q;
  }
  const internal::Walk_end end = internal::walk(m_t, p.location, displacement, crossing);
  q.location = end.point;
  q.frame *= end.rotation;
  return q;
}

Eigen::VectorXd Abel_jacobi_map::residual(const Lifted_divisor& points, const std::vector<int>& orders) const
{
  Eigen::VectorXd f = m_constant;
  for (std::size_t i = 0; i < points.size(); ++i) f -= 0.5 * pi * orders[i] * potential(points[i]).transpose();
  return f;
}

Eigen::VectorXd Abel_jacobi_map::residual(const Divisor& divisor) const
{
  Lifted_divisor points;
  std::vector<int> orders;
  for (const Singularity& s : divisor) {
    points.push_back({s.location, Eigen::RowVectorXd::Zero(dimension()), 1});
    orders.push_back(s.order);
  }
  return residual(points, orders);
}

Eigen::MatrixXd Abel_jacobi_map::jacobian(const Lifted_divisor& points, const std::vector<int>& orders) const
{
  Eigen::MatrixXd j(dimension(), 2 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].on_boundary) {
      const Halfedge h = internal::boundary_place(m_t, points[i].location).halfedge;
      j.col(2 * i) = -0.5 * pi * orders[i] / m_t.length(h) * m_forms.row(h).transpose();
      j.col(2 * i + 1).setZero();
      continue;
    }
    const Eigen::VectorXcd g = gradients(m_t, m_forms, points[i].location.face).transpose();
    j.col(2 * i) = -0.5 * pi * orders[i] * g.real();
    j.col(2 * i + 1) = -0.5 * pi * orders[i] * g.imag();
  }
  return j;
}

Abel_jacobi_image abel_jacobi_image(const Abel_jacobi_map& map, const Period_matrix& periods,
                                    const std::vector<Holomorphic_zero>& zeros, const Eigen::VectorXd& residual,
                                    const Eigen::VectorXd& nearest)
{
  const int g = map.dimension() / 2;
  const Eigen::VectorXd turns = map.constant() / (2 * pi) - potential_of(map, zeros);
  const Eigen::VectorXd m = -(nearest - 4 * turns.array().round().matrix());
  const Eigen::VectorXd rho = -(residual - 0.5 * pi * nearest) / (0.5 * pi);
  Abel_jacobi_image image;
  for (int k = 0; k < g; ++k) {
    image.s.push_back(-std::lround(m[g + k]));
    image.t.push_back(std::lround(m[k]));
  }
  image.image = -rho.tail(g).cast<std::complex<double>>() + periods.pi * rho.head(g).cast<std::complex<double>>();
  return image;
}

} } // namespace CGAL::Quartic_differentials
