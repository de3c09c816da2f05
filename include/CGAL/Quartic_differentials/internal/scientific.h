// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SCIENTIFIC_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SCIENTIFIC_H

#include <sstream>
#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// a number for people, with three significant digits: 1.23e-11
inline std::string scientific(double x)
{
  std::ostringstream out;
  out.precision(2);
  out << std::scientific << x;
  return out.str();
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SCIENTIFIC_H
