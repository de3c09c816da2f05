// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SPARSE_CHOLESKY_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SPARSE_CHOLESKY_H

#ifdef QUARTIC_HAS_CHOLMOD
#include <cholmod.h>
#else
#include <Eigen/SparseCholesky>
#endif

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// In which order the rows of a symmetric matrix are eliminated.
struct Elimination_order
{
  std::vector<int> rows;        ///< empty where none was found yet
  double           fill = 0;    ///< nonzeros of the factor for each of the matrix for which it was found
};

#ifdef QUARTIC_HAS_CHOLMOD

/// CHOLMOD's Cholesky factorisation of a symmetric matrix, given by its lower triangle. An order of elimination is found
/// once and kept for matrices of other patterns: those of a triangulation differ by few edges, and finding a good order
/// takes longer than a factorisation.
class Sparse_cholesky
{
public:
  using Matrix = Eigen::SparseMatrix<double>;

  Sparse_cholesky();
  ~Sparse_cholesky();
  Sparse_cholesky(const Sparse_cholesky&) = delete;
  Sparse_cholesky& operator=(const Sparse_cholesky&) = delete;

  /// prepares for matrices of this pattern
  void analyze(const Matrix& lower);
  /// whether the matrix is positive definite. \pre its pattern was analyzed last
  bool factorize(const Matrix& lower);
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const;

  const Elimination_order& order() const { return m_order; }
  /// an order for the patterns to come, whose rows are those it holds but for some at the end
  void set_order(Elimination_order order) { m_order = std::move(order); }

  static const char* name() { return "SuiteSparse CHOLMOD"; }

private:
  void find_order(cholmod_sparse& matrix);
  void free_factor();

  mutable cholmod_common m_common;
  mutable cholmod_dense* m_solution = nullptr;                   // memory that serves all solves, with the next
  mutable cholmod_dense* m_workspace[2] = {nullptr, nullptr};
  cholmod_factor*        m_factor = nullptr;
  Elimination_order      m_order;
};

#else

/// Eigen's Cholesky factorisation of a symmetric matrix, given by its lower triangle. It orders every pattern anew.
class Sparse_cholesky
{
public:
  using Matrix = Eigen::SparseMatrix<double>;

  void analyze(const Matrix& lower) { m_solver.analyzePattern(lower); }
  bool factorize(const Matrix& lower)
  {
    m_solver.factorize(lower);
    return m_solver.info() == Eigen::Success;
  }
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const { return m_solver.solve(b); }
  Elimination_order order() const { return {}; }
  void set_order(const Elimination_order&) {}
  static const char* name() { return "Eigen SimplicialLDLT"; }

private:
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> m_solver;
};

#endif

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SPARSE_CHOLESKY_H
