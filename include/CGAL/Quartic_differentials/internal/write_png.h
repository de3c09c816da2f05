// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_WRITE_PNG_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_WRITE_PNG_H

#include <cstdint>
#include <iosfwd>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Pixels row by row from the top, one byte for every channel: grey, or red, green and blue.
struct Image
{
  int                       width = 0, height = 0, channels = 3;
  std::vector<std::uint8_t> bytes;

  std::uint8_t&       at(int x, int y, int channel)       { return bytes[index(x, y, channel)]; }
  const std::uint8_t& at(int x, int y, int channel) const { return bytes[index(x, y, channel)]; }

private:
  std::size_t index(int x, int y, int channel) const
  { return (static_cast<std::size_t>(y) * width + x) * channels + channel; }
};

/// an image in one colour
Image blank_image(int width, int height, int channels, std::uint8_t value);

/// writes a PNG file; the same image gives the same bytes.
/// \throws Error if libpng cannot
void write_png(std::ostream& out, const Image& image);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_WRITE_PNG_H
