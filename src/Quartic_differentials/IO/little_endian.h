// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_LITTLE_ENDIAN_H
#define CGAL_QUARTIC_DIFFERENTIALS_LITTLE_ENDIAN_H

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Quartic_differentials {

/// appends the bytes of an integer or a floating point number, the least significant first.
template <class Number>
void append_little_endian(std::string& bytes, Number x)
{
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
               std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint8_t>>;
  static_assert(sizeof(Bits) == sizeof(Number), "a number of 1, 4 or 8 bytes");
  Bits bits;
  std::memcpy(&bits, &x, sizeof x);
  for (std::size_t k = 0; k < sizeof x; ++k) bytes.push_back(static_cast<char>(bits >> 8 * k & 255));
}

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_LITTLE_ENDIAN_H
