// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_LITTLE_ENDIAN_H
#define CGAL_QUARTIC_DIFFERENTIALS_LITTLE_ENDIAN_H

#include <boost/endian/conversion.hpp>

#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// appends the bytes of an integer or a floating point number, the least significant first.
template <class Number>
void append_little_endian(std::string& bytes, Number x)
{
  unsigned char ordered[sizeof x];
  boost::endian::endian_store<Number, sizeof x, boost::endian::order::little>(ordered, x);
  bytes.append(ordered, ordered + sizeof x);
}

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_LITTLE_ENDIAN_H
