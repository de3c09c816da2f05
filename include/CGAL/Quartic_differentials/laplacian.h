// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_LAPLACIAN_H
#define CGAL_QUARTIC_DIFFERENTIALS_LAPLACIAN_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// the cotangent weight (cot alpha + cot beta) / 2 of every edge, for the given edge lengths.
/// Nonnegative (up to rounding) if the triangulation is Delaunay. Complexity: linear.
std::vector<double> cotangent_weights(const Intrinsic_triangulation& t, const std::vector<double>& lengths);

/// a third of the area of the triangles round every vertex.
std::vector<double> vertex_areas(const Intrinsic_triangulation& t);

/// A factorised symmetric positive definite matrix: CHOLMOD's supernodal Cholesky factorisation where the package was
/// built with it, otherwise Eigen's. The symbolic part is kept while the sparsity pattern does not change.
class Symmetric_factorization
{
public:
  Symmetric_factorization();
  ~Symmetric_factorization();
  Symmetric_factorization(Symmetric_factorization&&) noexcept;
  Symmetric_factorization& operator=(Symmetric_factorization&&) noexcept;

  /// \param lower the lower triangle
  /// \throws Numerical_error if the matrix is not positive definite
  /// Complexity: that of a sparse Cholesky factorisation.
  void factorize(const Eigen::SparseMatrix<double>& lower);
  /// one back-substitution a column
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;

  /// the name of the library behind it
  static const char* name();

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

/// The factorised Laplacian L of a connected surface, L_ij = -w_ij, positive semidefinite with the constants as kernel.
class Laplacian_solver
{
public:
  /// \throws Numerical_error if L is not positive definite on functions that vanish at the first vertex
  void factorize(const Intrinsic_triangulation& t, const std::vector<double>& weights);
  /// solves L x = b for every column b, with x = 0 at the first vertex.
  /// \pre every column sums to zero (otherwise the first equation does not hold)
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

private:
  Symmetric_factorization m_factorization;
};

/// solves (M + time L) x = b with M the diagonal of vertex areas: b smoothed by heat flow.
/// \param time in squared surface units
Eigen::VectorXd heat_smoothed(const Intrinsic_triangulation& t, const std::vector<double>& weights, double time,
                              const Eigen::VectorXd& b);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_LAPLACIAN_H
