// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PERIOD_MATRIX_H
#define CGAL_QUARTIC_DIFFERENTIALS_PERIOD_MATRIX_H

#include <CGAL/Quartic_differentials/holomorphic_forms.h>

#include <Eigen/Core>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 3; paper, section 4.3)
//   J    2g x 2g  intersection numbers of the canonical basis a_1 .. a_g, b_1 .. b_g
//   S    2g x 2g  Dirichlet products of the harmonic forms dual to it, symmetric positive definite
//   C    2g x 2g  Hodge star on cohomology, C = J^-1 S; C C = -I up to discretisation
//   C'   C (-C^2)^(-1/2), the nearest complex structure: C' C' = -I
//   S'   J C'
//   Pi   g x g    period matrix, S'_aa^-1 (S'_ab + i I)

/// The period matrix of a discrete Riemann surface, and what is known of its error.
struct Period_matrix
{
  Eigen::MatrixXcd pi;               ///< symmetric, with positive definite imaginary part
  Eigen::MatrixXd  star;             ///< C': the star of Sum_k c_k omega_k is Sum_k (C' c)_k omega_k
  double           star_defect;      ///< max |C C + I|: dimensionless, O(h^2) on smooth surfaces
  Eigen::MatrixXd  lower, upper;     ///< J S^-1 J^T <= S of the polyhedral metric <= S
};

/// computes the period matrix of the Riemann surface from the Dirichlet products of its harmonic 1-forms.
///
/// Symmetry holds to rounding and the imaginary part is positive definite for every input, because the Hodge star is
/// projected to a complex structure first. Not promised: a rigorous bound on the distance to a smooth surface's matrix.
/// \pre `forms` are dual to a canonical homology basis
/// \throws Numerical_error if S is not positive definite (a degenerate surface)
/// Complexity: O(g^3); no linear system on the mesh is solved here.
Period_matrix period_matrix(const Harmonic_1_forms& forms);

/// 2g x g: the values of omega_1 .. omega_2g times this are those of the normalised holomorphic 1-forms phi_1 .. phi_g,
/// with the integral of phi_j along a_i = delta_ij
Eigen::MatrixXcd normalisation(const Period_matrix& periods);

/// phi_1 .. phi_g on a halfedge. Where many are asked for, multiply by `normalisation()`.
Eigen::RowVectorXcd normalised_forms(const Harmonic_1_forms& forms, const Period_matrix& periods, Halfedge h);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_PERIOD_MATRIX_H
