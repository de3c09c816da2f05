// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/delaunay_flips.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double epsilon = 0x1p-53;

// Sign of P + 16 eps M in the number type FT, with P the Delaunay polynomial and M its magnitude.
template <class FT>
auto sign_with_margin(double e_, double a_, double b_, double c_, double d_)
{
  const FT e(e_), a(a_), b(b_), c(c_), d(d_);
  const FT ee = e * e, ab = a * b, cd = c * d, sum_ab = a * a + b * b, sum_cd = c * c + d * d;
  const FT p = (sum_ab - ee) * cd + (sum_cd - ee) * ab;
  const FT m = (sum_ab + ee) * cd + (sum_cd + ee) * ab;
  const FT value = p + m * FT(16 * epsilon);
  return CGAL::sign(value);
}

} // namespace

bool certified_not_delaunay(double e, double a, double b, double c, double d)
{
  const double ee = e * e, ab = a * b, cd = c * d, sum_ab = a * a + b * b, sum_cd = c * c + d * d;
  const double p = (sum_ab - ee) * cd + (sum_cd - ee) * ab;
  const double m = (sum_ab + ee) * cd + (sum_cd + ee) * ab;
  // every operation above rounds by at most eps of the magnitude; 8 of them stand between the lengths and p
  if (m > 1e-250 && m < 1e250) {
    if (p < -24.5 * epsilon * m) return true;
    if (p > -7.5 * epsilon * m) return false;
  }
  {
    CGAL::Protect_FPU_rounding<true> protection;
    const CGAL::Uncertain<CGAL::Sign> s = sign_with_margin<CGAL::Interval_nt<false>>(e, a, b, c, d);
    if (CGAL::is_certain(s)) return CGAL::get_certain(s) == CGAL::NEGATIVE;
  }
  return sign_with_margin<CGAL::Exact_rational>(e, a, b, c, d) == CGAL::NEGATIVE;
}

} } // namespace CGAL::Quartic_differentials
