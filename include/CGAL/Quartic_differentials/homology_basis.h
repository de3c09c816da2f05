// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_HOMOLOGY_BASIS_H
#define CGAL_QUARTIC_DIFFERENTIALS_HOMOLOGY_BASIS_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 1; paper, section 4.1)
//   gamma_k  2g loops of the dual graph from a tree-cotree decomposition
//   eta_k    the closed integer cochain that counts crossings with gamma_k
//   J_kl     gamma_k . gamma_l, positive when gamma_l crosses gamma_k from right to left
//   U        2g x 2g unimodular, U J U^T = [[0, I], [-I, 0]]

/// A canonical basis a_1 .. a_g, b_1 .. b_g of the first homology group, a_i . b_j = delta_ij.
struct Homology_basis
{
  /// closed walks in the dual graph: the halfedges through which gamma_k leaves one face after the other
  std::vector<std::vector<Halfedge>> loops;
  /// row k: the k-th canonical class as an integer combination of the loops
  Eigen::MatrixXi                    combination;
  /// intersection numbers of the canonical classes, computed from the loops: [[0, I], [-I, 0]]
  Eigen::MatrixXi                    intersection_matrix;
  /// crossings with the canonical classes
  Integer_cochains                   cochains;
};

/// computes a canonical homology basis of a closed surface, deterministically.
///
/// The loops are short: the cotree is the maximal spanning tree for the length of the loop an edge closes
/// (Erickson and Whittlesey 2005). The canonical basis is made from them by integer symplectic Gram-Schmidt.
/// \pre the surface is connected
/// \throws Unusable_surface_error if the surface has a boundary (see `relative_homology_basis()`)
/// \throws Numerical_error if an integer leaves the 32-bit range or the intersection form is not unimodular
/// Complexity: O(n log n + g n + g^3).
Homology_basis homology_basis(const Intrinsic_triangulation& t);

/// the crossings of the edges of the triangulation on which a basis was computed with its canonical classes: what
/// `cochains` was before it rode along flips.
Integer_cochains cochains_of_loops(const Homology_basis& basis, std::size_t edges);

/// the intersection numbers of loops of the dual graph, exactly: J_kl = integral of eta_k along gamma_l's left side.
/// \param cochains dual to the loops
Eigen::MatrixXi intersection_numbers(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                     const std::vector<std::vector<Halfedge>>& loops);

/// the intersection numbers of the classes dual to closed cochains, exactly, by the wedge product over faces.
Eigen::MatrixXi intersection_numbers(const Intrinsic_triangulation& t, const Integer_cochains& cochains);

/// [[0, I], [-I, 0]], 2g x 2g
Eigen::MatrixXi symplectic_unit(int genus);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_HOMOLOGY_BASIS_H
