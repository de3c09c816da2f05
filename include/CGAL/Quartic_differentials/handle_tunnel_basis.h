// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_HANDLE_TUNNEL_BASIS_H
#define CGAL_QUARTIC_DIFFERENTIALS_HANDLE_TUNNEL_BASIS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/homology_basis.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 1)
//   x_k, y_l  gamma_k along edges (on its left side), gamma_l across faces
//   V+, V-    2g x 2g: V+_kl (V-_kl) is the linking number of x_k and y_l pushed off along (against) the normals
//   H, T      g x 2g: bases of the handle and of the tunnel classes
// All matrices are with respect to the canonical basis that is given, whose intersection numbers are J.

/// A canonical basis a_1 .. a_g, b_1 .. b_g of the first homology group of a surface in space that knows which loops
/// are which: a_i is a tunnel loop (it bounds outside the surface: it runs along a handle or round a hole), b_i is a
/// handle loop (it bounds inside: it runs round a handle).
struct Handle_tunnel_basis
{
  /// if not `found`, the basis that was given
  Homology_basis basis;
  /// the linking numbers of the loops separate handle and tunnel classes
  bool           found = false;
  /// `found`, and the surface is embedded, exactly: this proves which classes bound inside and outside. Otherwise the
  /// surface meets itself and the linking numbers are those of these particular loops, not of their classes.
  bool           certified = false;
  /// if not `certified`: why not, a sentence for a person
  std::string    reason;
};

/// finds the handle and the tunnel classes of a closed surface in space by linking numbers. All decisions are exact.
/// Inside and outside do not depend on the orientation of the surface.
/// \param basis a canonical basis made on this triangulation, before any flip or insertion
/// \throws Numerical_error if an integer leaves the 16-bit range
/// Complexity: O(n log n + g n + k log^2 k + c g^2 + g^4) for loops of k halfedges with c crossings in a projection.
/// Source: T. K. Dey, K. Li, J. Sun, "On computing handle and tunnel loops", Cyberworlds 2007 (the classes); linking
/// forms as in Seifert matrices.
Handle_tunnel_basis handle_tunnel_basis(const Intrinsic_triangulation& t, const Homology_basis& basis);

/// V+ and V- of the loops of a basis; empty if there is no answer (the surface touches itself or is degenerate).
struct Linking_matrices { Eigen::MatrixXi plus, minus; };
/// computes the linking numbers of the loops gamma_k with each other, pushed off along the normals round which the
/// faces are counterclockwise (`plus`) and against them (`minus`), exactly.
/// If the surface is embedded, V+ - V- = -J and V+ transposed = V-, where J are the intersection numbers of the loops.
/// \throws Unusable_surface_error if `t` is not embedded
Linking_matrices linking_matrices(const Intrinsic_triangulation& t, const std::vector<std::vector<Halfedge>>& loops);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_HANDLE_TUNNEL_BASIS_H
