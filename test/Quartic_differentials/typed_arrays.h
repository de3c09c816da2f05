// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_TYPED_ARRAYS_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_TYPED_ARRAYS_H

// The lists of numbers that report.html holds, read by code of its own.

#include "check.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace Quartic_test {

inline std::vector<unsigned char> decoded(const std::string& base64)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned bits = 0;
  int      held = 0;
  for (char c : base64) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) break;   // padding
    bits = bits << 6 | static_cast<unsigned>(digit);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> held & 255));
    }
  }
  return bytes;
}

template <class T>
std::vector<T> numbers(const nlohmann::json& array, const std::string& type)
{
  CHECK(array["type"] == type);
  const std::vector<unsigned char> bytes = decoded(array["base64"]);
  std::vector<T> result(array["length"].get<std::size_t>());
  CHECK_EQUAL(bytes.size(), result.size() * sizeof(T));
  if (!result.empty() && bytes.size() == result.size() * sizeof(T))
    std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}
inline std::vector<float> floats(const nlohmann::json& array) { return numbers<float>(array, "Float32Array"); }
inline std::vector<std::uint32_t> indices(const nlohmann::json& array)
{
  return numbers<std::uint32_t>(array, "Uint32Array");
}

using Point = std::array<float, 3>;

inline std::vector<Point> points(const std::vector<float>& x)
{
  std::vector<Point> result;
  for (std::size_t k = 0; k + 2 < x.size(); k += 3) result.push_back({x[k], x[k + 1], x[k + 2]});
  return result;
}

// twice the signed area of the triangle of corners a, b, c in a list of (u, v)
inline double doubled_area(const std::vector<float>& uv, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  const double ux = uv[2 * b] - uv[2 * a], uy = uv[2 * b + 1] - uv[2 * a + 1];
  const double vx = uv[2 * c] - uv[2 * a], vy = uv[2 * c + 1] - uv[2 * a + 1];
  return ux * vy - uy * vx;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_TYPED_ARRAYS_H
