// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_GROUND_TRUTH_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_GROUND_TRUTH_H

// How far computed Dirichlet products and periods are from the truth. The cycles of a known surface are carried to the
// computed basis by exact intersection numbers, so that nothing is searched for and any genus will do.
//   N   2g x 2g  the known cycles in the computed basis, integers: N J N^T = K
//   S   2g x 2g  Dirichlet products of the harmonic forms dual to the known cycles

#include "known_surfaces.h"
#include "period_comparison.h"

#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Quartic_test {

/// S + iK = conj(P) Z^-1 P^T with Z = P^T K^-1 conj(P) / 2i, which is positive definite: Riemann's bilinear relations
/// for cycles that need not be canonical. (For P = (I, Pi) this is Z = Im Pi and the S of `gram_of_periods()`.)
inline Eigen::MatrixXcd hermitian_form(const Eigen::MatrixXcd& p, const Eigen::MatrixXi& k)
{
  const Eigen::MatrixXcd inverse = k.cast<double>().inverse().cast<Complex>();
  const Eigen::MatrixXcd z = p.transpose() * inverse * p.conjugate() / Complex(0, 2);
  return p.conjugate() * z.inverse() * p.transpose();
}

/// the least and the greatest eigenvalue of b^-1 a for symmetric positive definite matrices: a <= c b if and only if
/// the greatest is at most c. It does not depend on the basis.
struct Relative_spectrum
{
  Relative_spectrum(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
  {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(a, b, Eigen::EigenvaluesOnly);
    least = solver.eigenvalues().minCoeff();
    greatest = solver.eigenvalues().maxCoeff();
  }

  double least, greatest;
};

inline double error_of(const Relative_spectrum& s) { return std::max(s.greatest, 1 / s.least) - 1; }

/// What was computed, and the truth; matrices belong to the known cycles.
struct Ground_truth_result
{
  int             genus;
  std::size_t     faces;
  double          h;                     ///< the longest edge, where the area is 1
  Eigen::MatrixXi cycles;                ///< N
  bool            cycles_are_exact;      ///< N J N^T = K
  Eigen::MatrixXd truth;                 ///< S of the Riemann surface
  Eigen::MatrixXd lower, upper;          ///< the bracket
  Eigen::MatrixXd projected;             ///< S of the period matrix
  double          star_defect;

  /// of S, relative and in no basis: the greatest factor by which an energy is too large or too small, minus 1
  double error() const { return error_of({upper, truth}); }
  /// the same for the period matrix
  double period_error() const { return error_of({projected, truth}); }
  /// the greatest factor between both bounds, minus 1
  double bracket_width() const { return Relative_spectrum(upper, lower).greatest - 1; }
};

/// N: the homology classes of the walks, in the computed canonical basis
inline Eigen::MatrixXi classes_of(const QD::Intrinsic_triangulation& t, const QD::Homology_basis& basis,
                                  const std::vector<Walk>& walks)
{
  const QD::Integer_cochains cochains = QD::cochains_of_loops(basis, t.number_of_edges());
  Eigen::MatrixXi n(walks.size(), 2 * t.genus());
  for (std::size_t k = 0; k < walks.size(); ++k)
    n.row(k) = QD::homology_class(t, cochains, QD::closed_curve_along_edges(t, walks[k])).cast<int>().transpose();
  return n;
}

inline Ground_truth_result compare_with_truth(const Known_surface& known)
{
  const QD::Intrinsic_triangulation& t = known.surface;
  QD::Visitor visitor;
  const QD::Riemann_surface s = QD::riemann_surface(t, visitor);
  const Eigen::MatrixXi n = classes_of(t, s.homology, known.cycles);
  const auto of_cycles = [&](const Eigen::MatrixXd& m) -> Eigen::MatrixXd {
    return n.cast<double>() * m * n.transpose().cast<double>();
  };
  const double longest = *std::max_element(t.lengths().begin(), t.lengths().end());
  return {t.genus(), t.number_of_faces(), longest / std::sqrt(t.area()), n,
          n * QD::symplectic_unit(t.genus()) * n.transpose() == known.intersections,
          hermitian_form(known.periods, known.intersections).real(), of_cycles(s.periods.lower),
          of_cycles(s.periods.upper), of_cycles(gram_of_periods(s.periods.pi)), s.periods.star_defect};
}

/// p where errors grow like h^p, for h like the square root of the area of a triangle
inline double observed_order(double coarse_error, double fine_error, std::size_t coarse_faces, std::size_t fine_faces)
{
  return 2 * std::log(coarse_error / fine_error) / std::log(static_cast<double>(fine_faces) / coarse_faces);
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_GROUND_TRUTH_H
