// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_COUNTED_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_COUNTED_H

#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// a number of things for people: "1 boundary curve", "3 boundary curves"
template <class Integer>
std::string counted(Integer n, const std::string& thing) { return std::to_string(n) + ' ' + thing + (n == 1 ? "" : "s"); }

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_COUNTED_H
