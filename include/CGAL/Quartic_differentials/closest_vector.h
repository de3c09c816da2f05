// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_CLOSEST_VECTOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_CLOSEST_VECTOR_H

#include <CGAL/Quartic_differentials/exceptions.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// An integer vector m and (x - m)^T W (x - m), rounded from the exact value.
struct Lattice_vector
{
  std::vector<std::int64_t> coefficients;
  double                    squared_distance = 0;
};

/// How many vectors `closest_vectors()` looks for, and how long.
struct Closest_vector_options
{
  std::size_t count         = 1;         ///< how many of the nearest integer vectors are wanted, at least 1
  double      radius_factor = std::numeric_limits<double>::infinity();
                                         ///< only vectors within this times the best distance, at least 1
  std::size_t max_nodes     = 1000000;   ///< of the search tree, and of those for a better lower bound if it is capped
  std::size_t max_runner_up_nodes = 10000;   ///< of the search tree for the gap, where the list does not show it
};

/// The nearest integer vectors that were found, and what is certified of them.
struct Closest_vectors
{
  std::vector<Lattice_vector> vectors;          ///< nearest first, equally near ones in lexicographic order
  bool                        optimal = false;  ///< certified: no other integer vector belongs into this list
  bool                        tie     = false;  ///< another vector is exactly as near as the first
  std::optional<double>       gap;              ///< distance of the runner-up minus the least distance, certified;
                                                ///< none if a node cap was reached before it was known
  std::size_t                 nodes   = 0;      ///< of all search trees
  double                      lower_bound = 0;  ///< certified: no integer vector has a smaller squared distance
};

/// finds the integer vectors m for which (x - m)^T W (x - m) is least, W = `gram` and x = `target`.
///
/// LLL reduction, then enumeration by Schnorr and Euchner. The result is exact for the lattice given by the doubles of
/// `gram` and `target`: the reduction is an exact integer transformation, the search keeps whatever lies within
/// the rounding errors of its radius, and what it keeps is compared in exact arithmetic.
/// When the search reaches `max_nodes` the best vectors found are returned with `optimal` false; the first of them is
/// at least as near as Babai's nearest plane vector, and `lower_bound` says how much nearer another one can be at most:
/// it is the least cost of the branches that were left open, made a true bound by bounds on the rounding errors, and
/// does not fall if `max_nodes` rises. If `optimal` is true it is the least squared distance, rounded down.
///
/// \param gram symmetric positive definite; only its lower triangle is read
/// \pre all numbers are finite, and `gram` is square with the dimension of `target`. Dimension 0 is allowed.
/// \throws Numerical_error if `gram` is not positive definite beyond rounding after the reduction, or an integer
///         leaves the 64-bit range
/// Complexity: exponential in the dimension in the worst case; milliseconds up to dimension 24, and up to dimension 100
///             for a target much nearer to a lattice vector than lattice vectors are to each other.
/// Source: METHOD, step 5; C. P. Schnorr, M. Euchner, Lattice basis reduction, Math. Programming 66 (1994);
///         A. K. Lenstra, H. W. Lenstra, L. Lovasz, Math. Ann. 261 (1982).
Closest_vectors closest_vectors(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                                const Closest_vector_options& options = Closest_vector_options());

/// The default model of `ClosestVectorSolver`: `closest_vectors()`.
struct Certified_closest_vectors
{
  Closest_vectors operator()(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                             const Closest_vector_options& options) const
  { return closest_vectors(gram, target, options); }
};

/// Any model of `ClosestVectorSolver`.
using Closest_vector_solver = std::function<Closest_vectors(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                                                            const Closest_vector_options& options)>;

/// throws Error if the answer of a `ClosestVectorSolver` breaks the contract of the concept, as far as this can be seen
/// without solving the problem again: whether the vectors are the nearest ones is not checked.
/// Complexity: O(k n^2 + k log k) for k vectors of dimension n.
void check_closest_vectors(const Closest_vectors& answer, const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                           const Closest_vector_options& options);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_CLOSEST_VECTOR_H
