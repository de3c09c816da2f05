// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/arbitrary_precision.h>
#include <CGAL/Quartic_differentials/precise_cone_metric.h>

#include <boost/multiprecision/mpfr.hpp>

#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;

// The precision of the numbers made in its scope, in this thread.
class Precision_scope
{
public:
  explicit Precision_scope(int bits) : m_digits(Real::default_precision())
  { Real::default_precision(static_cast<unsigned>(std::ceil(bits * std::log10(2.0)))); }
  ~Precision_scope() { Real::default_precision(m_digits); }
  Precision_scope(const Precision_scope&) = delete;
  Precision_scope& operator=(const Precision_scope&) = delete;

private:
  unsigned m_digits;
};

std::vector<double> rounded(const std::vector<Real>& x)
{
  std::vector<double> result;
  for (const Real& y : x) result.push_back(static_cast<double>(y));
  return result;
}

void require_reached(const Precise_cone_metric<Real>& m, int bits)
{
  if (m.reached) return;
  throw Numerical_error("with " + std::to_string(bits) + " bits the flat metric reaches an error of "
                        + internal::scientific(m.history.back()) + " rad only, after "
                        + std::to_string(m.history.size() - 1) + " steps from "
                        + internal::scientific(m.history.front()) + " rad (tolerance "
                        + internal::scientific(precision_tolerance(bits)) + ")");
}

} // namespace

double precision_tolerance(int bits) { return std::exp2(-0.78 * bits); }

Precise_immersion precise_immersion(const Intrinsic_triangulation& input, const Cone_metric& metric,
                                    const Refined_cone_metric& refined, int bits, const Immersion_options& options,
                                    Visitor& visitor)
{
  CGAL_precondition(64 <= bits && bits <= 1024);
  const Precision_scope scope(bits);
  const auto m = precise_cone_metric<Real>(input, metric, refined, Real(precision_tolerance(bits)), visitor);
  require_reached(m, bits);
  Precise_immersion result;
  result.u = rounded(m.u);
  result.moved = m.moved;
  result.precision = {bits, "", rounded(m.curvature_error), rounded(m.turning_error),
                      static_cast<double>(internal::largest(m.curvature_error)),
                      static_cast<double>(internal::largest(m.turning_error)),
                      static_cast<double>(m.max_transition_error), m.history};
  result.differential = immersion(refined.triangulation, m.lengths, metric.cones, metric.order, input.area(), options,
                                  result.immersion);
  return result;
}

} } // namespace CGAL::Quartic_differentials
