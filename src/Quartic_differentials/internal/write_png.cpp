// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/write_png.h>

#include <png.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

Image blank_image(int width, int height, int channels, std::uint8_t value)
{
  return {width, height, channels,
          std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * channels, value)};
}

void write_png(std::ostream& out, const Image& image)
{
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = image.channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<char> file(size);
  if (!png_image_write_to_memory(&png, file.data(), &size, 0, image.bytes.data(), 0, nullptr))
    throw Error(std::string("a picture cannot be written: ") + png.message);
  out.write(file.data(), static_cast<std::streamsize>(size));
}

} } } // namespace CGAL::Quartic_differentials::internal
