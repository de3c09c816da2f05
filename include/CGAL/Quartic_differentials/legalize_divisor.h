// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_LEGALIZE_DIVISOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_LEGALIZE_DIVISOR_H

#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/closest_vector.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/period_matrix.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace internal { class Moving_divisor; }

/// The norm in which the integer program looks for the nearest lattice vector.
enum class Lattice_norm
{
  movement,   ///< least total movement of the singularities, (J J^T)^-1
  paper,      ///< the paper's Euclidean norm of C^g, which depends on the canonical basis
  invariant   ///< z* (Im Pi)^-1 z on C^g, which does not: it is the flat metric of the Jacobian
};

/// Norm, tolerances and limits of `legalize_divisor()`.
struct Legalization_options
{
  Lattice_norm norm          = Lattice_norm::movement;
  double       tolerance     = 1e-12;   ///< |F - (pi/2) m|, radians
  int          iterations    = 100;     ///< Gauss-Newton steps for one lattice vector
  double       longest_step  = 0.05;    ///< of any singularity in one step, times sqrt(area)
  double       least_distance = 0.01;   ///< between singularities, and half of it to the boundary, times sqrt(area)
  int          lattice_vectors = 16;    ///< tried, nearest first, within twice the best distance
  Closest_vector_solver solver = Certified_closest_vectors();   ///< a model of `ClosestVectorSolver`
};

/// A divisor that satisfies the Abel-Jacobi condition, and how it was reached.
struct Legal_divisor
{
  Divisor             divisor;          ///< same orders, moved
  std::vector<double> moved_by;         ///< length of the way of each singularity, surface units
  Eigen::VectorXd     nearest;          ///< the integers m
  Eigen::VectorXd     residual;         ///< F - (pi/2) m
  std::vector<double> history;          ///< |F - (pi/2) m| before the first and after every Gauss-Newton step
  bool                certified = true; ///< m is a certified closest lattice vector (of those that could be reached)
  int                 tried = 0;        ///< number of lattice vectors tried
};

/// moves the singularities by as little as possible until the divisor satisfies the Abel-Jacobi condition.
///
/// The integers m come from a closest vector problem, the positions from Gauss-Newton steps of minimal norm, with the
/// singularities walking across faces. If a lattice vector cannot be reached, or only by driving singularities
/// together, the next nearest is tried.
/// \throws Infeasible_divisor_error with the mathematical reason: wrong degree, order below -3, genus 1 with one zero and
///         one pole of order one, rank of the Jacobian below 2g, singularities that run into each other
/// \throws Numerical_error if no lattice vector can be reached within the iterations
/// \throws Error if the solver of `options` breaks the contract of `ClosestVectorSolver`
/// Source: METHOD, step 5; paper, section 4.5.
Legal_divisor legalize_divisor(const Abel_jacobi_map& map, const Period_matrix& periods, const Divisor& divisor,
                               const Legalization_options& options, Visitor& visitor);

/// the same on a surface with boundary, where corners slide along it. It has no period matrix: the norm is that of the least
/// movement.
/// \throws Infeasible_divisor_error also for corners off the boundary or of order below -1, for corners with m = 1 and m = 3
///         as the only singularities and on the same curve of an annulus, and singularities that run into the boundary
/// Source: METHOD, "Surfaces with boundary".
Legal_divisor legalize_divisor(const Abel_jacobi_map& map, const Divisor& divisor, const Legalization_options& options,
                               Visitor& visitor);

/// The lattice vectors m nearest to F(D) / (pi/2), nearest first.
struct Lattice_candidates
{
  std::vector<Eigen::VectorXd> vectors;
  bool                         optimal;   ///< the first is certified to be a closest one
};

/// the Gram matrix W of a norm in the coordinates x = F / (pi/2): |x|^2 = x^T W x.
///
/// With Pi = X + iY and x = (p, q) by the canonical classes a and b, the norms of C^g are those of z = -q + Pi p, so
/// that the invariant norm is (X p - q)^T Y^-1 (X p - q) + p^T Y p. Its matrix is the inverse of the Dirichlet products: a
/// change U of the canonical basis takes x to U x and W to U^-T W U^-1.
/// \param jacobian the derivative of F by the positions, 2g rows; used by `Lattice_norm::movement` only
/// \pre `jacobian` has rank 2g if it is used
Eigen::MatrixXd lattice_gram(Lattice_norm norm, const Eigen::MatrixXd& jacobian, const Eigen::MatrixXcd& pi);

/// solves the closest vector problem of a divisor with the solver of `options`.
/// \throws Infeasible_divisor_error if the rank of its Jacobian is below 2g
/// \throws Error if there is no solver, or its answer breaks the contract of `ClosestVectorSolver`
Lattice_candidates nearest_lattice_vectors(const internal::Moving_divisor& d, const Period_matrix& periods,
                                           const Legalization_options& options);

/// throws Infeasible_divisor_error if no position whatever makes these orders legal on a surface of this genus.
void check_orders(const Divisor& divisor, int genus, int boundary_curves = 0);

/// The two singularities that are nearest to each other along a straight line on the surface.
struct Nearest_singularities
{
  std::size_t first = 0, second = 0;
  double      distance;   ///< infinite if none are within the radius searched
};
Nearest_singularities nearest_singularities(const Intrinsic_triangulation& t, const std::vector<Surface_point>& points,
                                            double radius);
/// the same with the way between two corners along the boundary
Nearest_singularities nearest_singularities(const Intrinsic_triangulation& t, const Divisor& divisor, double radius);

/// which singularities are too near each other or, unless they are corners, to the boundary, and how near, as a part of a
/// sentence; or "". From the boundary half the distance is asked for: then it is as far from its mirror image.
/// \param least distance, times sqrt(area)
std::string collision(const Intrinsic_triangulation& t, const Divisor& divisor, double least);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_LEGALIZE_DIVISOR_H
