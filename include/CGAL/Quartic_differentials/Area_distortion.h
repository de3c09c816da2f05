// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_AREA_DISTORTION_H
#define CGAL_QUARTIC_DIFFERENTIALS_AREA_DISTORTION_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, "Choosing the singularities")
//   M    diagonal of the masses of the vertices, A their sum
//   K    curvature, L Laplacian
//   q_i  -n_i pi/2, the curvature that a singularity of order n_i needs; b(p) the barycentric coordinates of p
//   u    L u = Sum_i q_i b(p_i) - K with M-weighted mean 0: log of the scale of lengths of the linearised flat metric
//   E    u^T M u / A, the area distortion: the mean square of u
//   w    L w = M u, the potential that pushes the singularities
//   G_a  L G_a = b(p_a) - M 1 / A with M-weighted mean 0, Green's function

/// How much the flat metric of a divisor distorts the areas of a surface, to first order, and the forces on the
/// singularities. Every function that needs a linear system says so; they share the given factorisation.
///
/// The linear theory tracks the final, nonlinear metric closely: the E of both differ by 1 to 6 percent where E is
/// about 0.01.
class Area_distortion
{
public:
  /// Keeps references to the triangulation and its factorised Laplacian.
  /// \param mass by vertex
  Area_distortion(const Intrinsic_triangulation& t, const Laplacian_solver& laplacian, const std::vector<double>& mass);

  const Intrinsic_triangulation& triangulation() const { return m_t; }
  const Eigen::VectorXd& mass() const { return m_mass; }

  /// u. A degree other than 8g - 8 + 4b is made up for by curvature spread evenly over the area. One solve.
  Eigen::VectorXd log_scale(const Divisor& divisor) const;
  /// E
  double energy(const Eigen::VectorXd& u) const { return u.cwiseAbs2().dot(m_mass) / m_area; }
  /// w. One solve.
  Eigen::VectorXd potential(const Eigen::VectorXd& u) const;

  /// The derivative of E by the positions, -(pi n_i / A) grad w(p_i), two entries (x, y in the unfolded frame of its
  /// face) a singularity; of a corner along the boundary, and 0. Exact as long as the singularity stays in its face, or
  /// on its edge.
  Eigen::VectorXd gradient(const Divisor& divisor, const Eigen::VectorXd& w) const;
  /// The same with a continuous field instead of grad w, which jumps at edges: at a vertex the mean over the faces round
  /// it, weighted by area, in polar coordinates; linear in between. On the boundary it is tangent.
  Eigen::VectorXd recovered_gradient(const Divisor& divisor, const Eigen::VectorXd& w) const;

  /// the Green's functions G_a of points, by columns. One solve a column.
  Eigen::MatrixXd greens_functions(const std::vector<Surface_point>& points) const;

  /// number of right-hand sides solved so far
  std::size_t solves() const { return m_solves; }

private:
  std::complex<double> face_gradient(Face f, const Eigen::VectorXd& w) const;
  std::complex<double> vertex_gradient(Halfedge h, double share, const Eigen::VectorXd& w, bool along_boundary) const;
  Eigen::MatrixXd solve(Eigen::MatrixXd right_hand_sides) const;

  const Intrinsic_triangulation& m_t;
  const Laplacian_solver&        m_laplacian;
  Eigen::VectorXd                m_mass, m_curvature;
  double                         m_area;
  mutable std::size_t            m_solves = 0;
};

/// The exact changes of E when charges q_a with sum zero are added at points: (2 q.l + q^T Q q) / A.
class Charge_changes
{
public:
  /// \param greens the Green's functions of the points
  Charge_changes(const Area_distortion& distortion, const Eigen::VectorXd& u, const Eigen::MatrixXd& greens);
  /// the change by charges `qa` at the point a and -qa at b
  double of_pair(Eigen::Index a, Eigen::Index b, double qa) const;

private:
  double          m_area;
  Eigen::VectorXd m_linear;      // l_a = G_a^T M u
  Eigen::MatrixXd m_quadratic;   // Q_ab = G_a^T M G_b
};

/// the value below which the given share of the weight lies.
/// \pre at least one value
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double share);

/// how much the area scale e^2u varies: its 99% quantile over its 1% quantile.
double area_scale_ratio(const Eigen::VectorXd& u, const Eigen::VectorXd& mass);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_AREA_DISTORTION_H
