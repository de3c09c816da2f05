// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_CLOSEST_VECTOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_CLOSEST_VECTOR_H

#include <CGAL/Quartic_differentials/exceptions.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
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

struct Closest_vector_options
{
  std::size_t count         = 1;         ///< how many of the nearest integer vectors are wanted, at least 1
  double      radius_factor = std::numeric_limits<double>::infinity();
                                         ///< only vectors within this times the best distance, at least 1
  std::size_t max_nodes     = 1000000;   ///< of each of the (at most two) search trees
};

struct Closest_vectors
{
  std::vector<Lattice_vector> vectors;          ///< nearest first, equally near ones in lexicographic order
  bool                        optimal = false;  ///< certified: no other integer vector belongs into this list
  bool                        tie     = false;  ///< another vector is exactly as near as the first
  std::optional<double>       gap;              ///< distance of the runner-up minus the least distance, certified;
                                                ///< none if the node cap was reached before it was known
  std::size_t                 nodes   = 0;      ///< of the search trees
};

/// finds the integer vectors m for which (x - m)^T W (x - m) is least, W = `gram` and x = `target`.
///
/// LLL reduction, then enumeration by Schnorr and Euchner. The result is exact for the lattice given by the doubles of
/// `gram` and `target`: the reduction is an exact integer transformation, the search keeps whatever lies within
/// the rounding errors of its radius, and what it keeps is compared in exact arithmetic.
/// When the search exceeds `max_nodes` the best vectors found are returned with `optimal` false; the first of them is
/// at least as near as Babai's nearest plane vector.
///
/// \param gram symmetric positive definite; only its lower triangle is read
/// \pre all numbers are finite, and `gram` is square with the dimension of `target`. Dimension 0 is allowed.
/// \throws Numerical_error if `gram` is not positive definite beyond rounding after the reduction, or an integer
///         leaves the 64-bit range
/// Complexity: exponential in the dimension in the worst case; milliseconds up to dimension 24.
/// Source: METHOD, step 5; C. P. Schnorr, M. Euchner, Lattice basis reduction, Math. Programming 66 (1994);
///         A. K. Lenstra, H. W. Lenstra, L. Lovasz, Math. Ann. 261 (1982).
Closest_vectors closest_vectors(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                                const Closest_vector_options& options = Closest_vector_options());

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_CLOSEST_VECTOR_H
