// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgQuarticDifferentialsConcepts
/// \cgalConcept
///
/// The concept `ClosestVectorSolver` describes how the integer program of step 5 is solved: which integer vectors m are
/// nearest to a target x in the norm of a Gram matrix W, (x - m)^T W (x - m).
///
/// Legalization relies on what is promised below and on nothing else. Every broken promise but the last is found by
/// `check_closest_vectors()` and ends with an `Error`; a false `optimal` cannot be found without solving the problem
/// again, and would only make `Legal_divisor::certified` wrong, never the divisor: every vector leads to a legal
/// divisor if Gauss-Newton steps reach it, a nearer one with less movement.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Quartic_differentials::Certified_closest_vectors}
/// \cgalHasModels{CGAL::Quartic_differentials::Closest_vector_solver}
/// \cgalHasModelsEnd
class ClosestVectorSolver
{
public:
  /// returns integer vectors near `target`, of dimension n. May be called any number of times, also from copies.
  ///
  /// \param gram W, n x n and symmetric positive definite; only the lower triangle need be read
  /// \param target x, any finite numbers
  /// \param options how many vectors are wanted. `radius_factor` and the node caps may be ignored.
  ///
  /// The answer fulfils, with v its `vectors`:
  /// - 1 <= v.size() <= options.count, and v holds no vector twice;
  /// - each of v has n coefficients, and its `squared_distance` is that of `gram` and `target` up to rounding;
  /// - v is sorted by `squared_distance`;
  /// - 0 <= `lower_bound` <= v[0].squared_distance; a solver that knows no lower bound leaves it at 0;
  /// - if `optimal` is true, no integer vector is nearer to x than v[0]. A solver that does not prove this, such as
  ///   Babai's nearest plane, leaves it false.
  ///
  /// `tie`, `gap` and `nodes` are for people, and may be left as they are.
  ///
  /// \throws CGAL::Quartic_differentials::Numerical_error if no vector can be found
  CGAL::Quartic_differentials::Closest_vectors
  operator()(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
             const CGAL::Quartic_differentials::Closest_vector_options& options) const;
};
