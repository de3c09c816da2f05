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

/// A factorised symmetric positive definite matrix: CHOLMOD's Cholesky factorisation where the package was built
/// with it, otherwise Eigen's. The symbolic part is kept while the sparsity pattern does not change, and the order
/// of elimination of the first pattern serves the later ones, which differ by a few flipped edges or inserted vertices.
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
  /// takes a matrix near the one that was factorised: systems are solved by conjugate gradients, preconditioned with that
  /// factorisation, as long as this takes few iterations. If there is none of as many rows, it factorises.
  void update(const Eigen::SparseMatrix<double>& lower);
  /// one back-substitution a column, several after an update
  /// \param relative_residual that is enough after an update: of every column of b - A x, the largest entry against that of b
  /// \throws Numerical_error if no matrix of as many rows was factorised, or there is no finite solution
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides, double relative_residual = 1e-10) const;
  /// takes over the order of elimination of a similar matrix: of the same rows but for some at the end
  void set_order_of(const Symmetric_factorization& similar);

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
  /// the same for a Laplacian near the one that was factorised, most often without another factorisation
  void update(const Intrinsic_triangulation& t, const std::vector<double>& weights);
  /// solves L x = b for every column b, with x = 0 at the first vertex.
  /// \param relative_residual that is enough after an update: of every column of b - L x, the largest entry against that of b
  /// \pre every column sums to zero (otherwise the first equation does not hold)
  /// \throws Numerical_error if no Laplacian of as many vertices was factorised, or there is no finite solution
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b, double relative_residual = 1e-10) const;
  /// takes over the order of elimination from the solver of a triangulation with the same vertices but for some at the end
  void set_order_of(const Laplacian_solver& similar);

private:
  Symmetric_factorization m_factorization;
};

/// solves (M + time L) x = b with M the diagonal of vertex areas: b smoothed by heat flow.
/// \param time in squared surface units
Eigen::VectorXd heat_smoothed(const Intrinsic_triangulation& t, const std::vector<double>& weights, double time,
                              const Eigen::VectorXd& b);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_LAPLACIAN_H
