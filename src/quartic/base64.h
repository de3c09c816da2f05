// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_BASE64_H
#define QUARTIC_BASE64_H

#include <cstddef>
#include <string>

/// `size` bytes as text: RFC 4648, section 4. Complexity: linear.
inline std::string base64(const void* bytes, std::size_t size)
{
  static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* b = static_cast<const unsigned char*>(bytes);
  std::string text;
  text.reserve((size + 2) / 3 * 4);
  for (std::size_t i = 0; i < size; i += 3) {
    const std::size_t n = size - i;   // bytes that are left
    const unsigned three = b[i] << 16 | (n > 1 ? b[i + 1] << 8 : 0) | (n > 2 ? b[i + 2] : 0);
    text += digit[three >> 18];
    text += digit[three >> 12 & 63];
    text += n > 1 ? digit[three >> 6 & 63] : '=';
    text += n > 2 ? digit[three & 63] : '=';
  }
  return text;
}

#endif // QUARTIC_BASE64_H
