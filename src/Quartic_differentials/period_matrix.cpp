// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/period_matrix.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const std::complex<double> i(0, 1);

// C' = C (-C^2)^(-1/2) for C = J^-1 S. With R = S^(1/2), R C R^-1 = R J^-1 R is skew: its polar factor is orthogonal.
Eigen::MatrixXd nearest_complex_structure(const Eigen::MatrixXd& s, const Eigen::MatrixXd& j)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_s(s);
  if (of_s.info() != Eigen::Success || of_s.eigenvalues().minCoeff() <= 0)
    throw Numerical_error("the Dirichlet products of the harmonic forms are not positive definite: "
                          "the surface is degenerate");
  const Eigen::MatrixXd r = of_s.operatorSqrt(), r_inverse = of_s.operatorInverseSqrt();
  const Eigen::MatrixXd k = r * (-j) * r;   // J^-1 = -J
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_k(k.transpose() * k);
  return r_inverse * k * of_k.operatorInverseSqrt() * r;
}

} // namespace

Period_matrix period_matrix(const Harmonic_1_forms& forms)
{
  const int g = forms.size() / 2;
  Period_matrix result;
  if (g == 0) {
    result.star_defect = 0;
    return result;
  }
  const Eigen::MatrixXd& s = forms.dirichlet;
  const Eigen::MatrixXd j = symplectic_unit(g).cast<double>(), c = -j * s;
  result.star = nearest_complex_structure(s, j);
  result.star_defect = (c * c + Eigen::MatrixXd::Identity(2 * g, 2 * g)).cwiseAbs().maxCoeff();
  result.lower = j * s.inverse() * j.transpose();
  result.upper = s;

  const Eigen::MatrixXd projected = j * result.star;
  const Eigen::MatrixXcd right = projected.topRightCorner(g, g) + i * Eigen::MatrixXd::Identity(g, g);
  const Eigen::MatrixXd aa = 0.5 * (projected.topLeftCorner(g, g) + projected.topLeftCorner(g, g).transpose());
  result.pi = aa.cast<std::complex<double>>().llt().solve(right);
  return result;
}

Eigen::MatrixXcd normalisation(const Period_matrix& periods)
{
  const int g = static_cast<int>(periods.star.rows()) / 2;
  const Eigen::MatrixXcd holomorphic = (Eigen::MatrixXcd::Identity(2 * g, 2 * g) + i * periods.star).rightCols(g);
  const Eigen::MatrixXcd of_loops = symplectic_unit(g).cast<double>().transpose() * holomorphic;   // periods
  return holomorphic * of_loops.topRows(g).inverse();
}

Eigen::RowVectorXcd normalised_forms(const Harmonic_1_forms& forms, const Period_matrix& periods, Halfedge h)
{
  return forms.row(h) * normalisation(periods);
}

} } // namespace CGAL::Quartic_differentials
