// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/jacobian_point.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <complex>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

double Jacobian_point::distance_from_origin() const
{
  return s.size() == 0 ? 0 : std::max(s.cwiseAbs().maxCoeff(), t.cwiseAbs().maxCoeff());
}

Jacobian_point jacobian_point(const Riemann_surface& surface, const Divisor& divisor)
{
  const int g = surface.forms.size() / 2, d = degree(divisor);
  if (d != 0 && d != 8 * g - 8)
    throw Infeasible_divisor_error("the degree of the divisor is " + std::to_string(d) + ": a point of the Jacobian "
                                   "belongs to degree 0, and to 8g-8 = " + std::to_string(8 * g - 8)
                                   + " when quartic differentials are asked for");
  const Abel_jacobi_map map(surface.delaunay, surface.homology.cochains, surface.forms);
  // F is affine in the divisor, with a constant that belongs to quartic differentials
  Eigen::VectorXd f = map.residual(on_delaunay(surface, divisor));
  if (d == 0) f -= map.constant();
  const Eigen::VectorXd quarter_turns = f / (0.5 * CGAL_PI);
  const Eigen::VectorXd rho = quarter_turns.array().round().matrix() - quarter_turns;

  Jacobian_point p{-rho.tail(g), rho.head(g), {}};
  p.image = p.s.cast<std::complex<double>>() + surface.periods.pi * p.t.cast<std::complex<double>>();
  return p;
}

} } // namespace CGAL::Quartic_differentials
