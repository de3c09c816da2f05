// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_HOLOMORPHIC_FORMS_H
#define CGAL_QUARTIC_DIFFERENTIALS_HOLOMORPHIC_FORMS_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 2; paper, section 4.2)
//   eta_k    closed integer cochains dual to a_1 .. a_g, b_1 .. b_g
//   g_k      functions on the vertices with L g_k = -d^T W eta_k
//   omega_k  harmonic 1-forms eta_k + d g_k
//   S_kl     Dirichlet products sum_e w_e omega_k(e) omega_l(e)

/// The harmonic 1-forms omega_k = eta_k + dg_k of a discrete Riemann surface.
struct Harmonic_1_forms
{
  using Row_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Row_matrix      potential;   ///< by vertex: g_1 .. g_2g
  Row_matrix      by_edge;     ///< by edge, on its halfedge(e): omega_1 .. omega_2g
  Eigen::MatrixXd dirichlet;   ///< S, symmetric positive definite
  double          residual;    ///< max |d^T W omega_k| over vertices and k: how harmonic they are

  int size() const { return static_cast<int>(by_edge.cols()); }
  double operator()(Halfedge h, int k) const
  { return (h.idx() % 2 == 0 ? 1 : -1) * by_edge(h.idx() / 2, k); }
  /// omega_1 .. omega_2g on h
  Eigen::RowVectorXd row(Halfedge h) const { return (h.idx() % 2 == 0 ? 1 : -1) * by_edge.row(h.idx() / 2); }
};

/// computes the harmonic 1-forms in the cohomology classes of the given cochains.
///
/// \param weights cotangent weights of the edges
/// \param laplacian the factorised Laplacian for these weights: one factorisation serves everything
/// Complexity: one back-substitution a form.
Harmonic_1_forms harmonic_1_forms(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                  const std::vector<double>& weights, const Laplacian_solver& laplacian);

/// the gradients of omega_1 .. omega_2g in a face, as complex numbers in its `unfolded()` frame: omega(e) = Re(conj(G) e)
Eigen::RowVectorXcd gradients(const Intrinsic_triangulation& t, const Harmonic_1_forms& forms, Face f);

/// A zero of a holomorphic 1-form.
struct Holomorphic_zero
{
  Vertex        vertex;     ///< the vertex whose index counts the zero, null if it is a face
  int           order;      ///< positive for zeros; a discrete form may have a negative index at a vertex of low degree
  Surface_point location;   ///< refined below the vertex: the zero of a + b z fitted to the form round it
};

/// finds all zeros of the holomorphic 1-form Sum_k c_k (omega_k + i * omega_k).
///
/// The index 1 - (sign changes round the vertex)/2 of the real part is an integer at every vertex and sums up to
/// exactly 2 - 2g, so no zero is ever missed (Gortler, Gotsman and Thurston 2006). Exact zeros of the form on an edge
/// count as positive on the halfedge of even index, and the indices of faces are counted too.
/// \param coefficients c_1 .. c_2g
/// \param star 2g x 2g, the Hodge star: the coefficients of the imaginary part are star * coefficients
/// \post the orders sum up to 2g - 2
/// Complexity: linear.
/// Source: METHOD, step 2; paper, section 4.2.
std::vector<Holomorphic_zero> zeros_of_holomorphic_form(const Intrinsic_triangulation& t, const Harmonic_1_forms& forms,
                                                        const Eigen::VectorXd& coefficients, const Eigen::MatrixXd& star);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_HOLOMORPHIC_FORMS_H
