// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_ABEL_JACOBI_MAP_H
#define CGAL_QUARTIC_DIFFERENTIALS_ABEL_JACOBI_MAP_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/period_matrix.h>

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 4; paper, section 4.4)
//   p_i, n_i  the singularities of the divisor D and their orders
//   ^g_k(p)   the potential of omega_k, continued along paths: g_k plus the integral of omega_k
//   T_k       turning of gamma_k in the metric of the triangulation
//   K_v       curvature at a vertex
//   F_k(D)    T_k - Sum_v g_k(v) K_v - (pi/2) Sum_i n_i ^g_k(p_i), the holonomy of the conformal cone metric
//   D satisfies the Abel-Jacobi condition <=> F(D) in (pi/2) Z^2g
// On a surface with boundary k runs over 2g loops and b-1 arcs, and the p_i are singularities and corners.

/// A point with the sheet on which the potentials ^g_k are continued, and a frame that is transported along its way.
struct Lifted_point
{
  Surface_point        location;
  Eigen::RowVectorXd   sheet;       ///< integers, added to the potentials
  std::complex<double> frame = 1;   ///< the transported first axis in the unfolded frame of the face, a unit number
  bool                 on_boundary = false;   ///< it slides along the boundary, whose direction is its first axis
};

using Lifted_divisor = std::vector<Lifted_point>;

/// the turning numbers of the loops and arcs dual to the cochains, modulo 2 pi (METHOD, step 4). [radians]
/// \param angles by halfedge, at its source, in any metric on the triangulation
/// Complexity: linear in the edges the loops cross.
Eigen::VectorXd turning_numbers(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                const std::vector<double>& angles);

/// The two routes to the Abel-Jacobi map. They differ by O(discretisation) modulo 2 pi.
enum class Abel_jacobi_route
{
  curvature,   ///< F as above: consistent with the discretisation
  zeros        ///< the paper's, through the zeros z_j of a holomorphic form: (pi/2) (4 Sum_j ^g(z_j) - Sum_i n_i ^g(p_i))
};

/// The Abel-Jacobi map of a surface, in the coordinates in which the Jacobian's lattice is (pi/2) Z^2g.
/// Keeps references to the triangulation and the forms.
class Abel_jacobi_map
{
public:
  /// by curvature
  Abel_jacobi_map(const Intrinsic_triangulation& t, const Integer_cochains& cochains, const Harmonic_1_forms& forms);
  /// by zeros.
  /// \param zeros the divisor of a holomorphic 1-form, degree 2g - 2
  Abel_jacobi_map(const Intrinsic_triangulation& t, const Harmonic_1_forms& forms,
                  const std::vector<Holomorphic_zero>& zeros);

  const Intrinsic_triangulation& triangulation() const { return m_t; }
  const Harmonic_1_forms& forms() const { return m_forms; }
  int dimension() const { return m_forms.size(); }

  /// the part of F that does not depend on the divisor: T_k - Sum_v g_k(v) K_v, or 2 pi Sum_j ^g(z_j)
  const Eigen::VectorXd& constant() const { return m_constant; }

  /// a point on the sheet 0, moved into the interior of its face by 1e-9 if it lies on its boundary
  Lifted_point lift(const Surface_point& p) const;
  /// a point that slides along the boundary, on the sheet 0.
  /// \throws Infeasible_divisor_error if it is not on a boundary edge of its face
  Lifted_point lift_on_boundary(const Surface_point& p) const;
  /// moves a point along a straight line across the faces, or along the boundary.
  /// \param displacement in the unfolded frame of the point's face, surface units; of a point that slides along the
  ///        boundary the way along it, a real number
  /// \throws Numerical_error if the line crosses more than 100,000 edges
  Lifted_point moved(const Lifted_point& p, std::complex<double> displacement) const;
  /// ^g_1 .. ^g_2g
  Eigen::RowVectorXd potential(const Lifted_point& p) const;

  /// F(D). [radians]
  Eigen::VectorXd residual(const Lifted_divisor& points, const std::vector<int>& orders) const;
  /// F(D) with every point on the sheet 0, right up to multiples of pi/2. [radians]
  Eigen::VectorXd residual(const Divisor& divisor) const;
  /// the derivative of F(D) by the positions, two columns (x, y in the unfolded frame of its face) a singularity; of a
  /// corner the first is the derivative along the boundary, the second 0
  Eigen::MatrixXd jacobian(const Lifted_divisor& points, const std::vector<int>& orders) const;

private:
  Eigen::RowVectorXd potential_in_face(const Surface_point& p) const;

  const Intrinsic_triangulation& m_t;
  const Harmonic_1_forms&        m_forms;
  Eigen::VectorXd                m_constant;
};

/// The paper's integers and complex numbers for a divisor with F = (pi/2) m + remainder.
struct Abel_jacobi_image
{
  std::vector<long>  s, t;    ///< Phi(D) - Sum s_k lambda_{a_k} - Sum t_k lambda_{b_k} - Phi(4(phi)) = image
  Eigen::VectorXcd   image;   ///< g complex numbers, 0 for a legal divisor (the paper's table 3)
};

/// translates a residual into the paper's form (METHOD, step 4).
/// \param zeros the divisor of a holomorphic 1-form, on sheet 0
/// \param nearest m, the lattice vector
Abel_jacobi_image abel_jacobi_image(const Abel_jacobi_map& map, const Period_matrix& periods,
                                    const std::vector<Holomorphic_zero>& zeros, const Eigen::VectorXd& residual,
                                    const Eigen::VectorXd& nearest);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_ABEL_JACOBI_MAP_H
