// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_checkerboard.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>

#include <png.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

int squares_per_unit(const Quartic_differential& q)
{
  const double area = std::ldexp(static_cast<double>(q.doubled_area()), -2 * q.grid_exponent - 1);
  const double n = std::sqrt(2500 / area);
  return 2 * static_cast<int>(std::clamp(std::round(n / 2), 4.0, 128.0));
}

void write_png(const std::string& path, int squares)
{
  const int pixels = std::max(4, 1024 / squares), side = squares * pixels;
  std::vector<png_byte> grey(static_cast<std::size_t>(side) * side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      grey[static_cast<std::size_t>(y) * side + x] = (x / pixels + y / pixels) % 2 == 0 ? 235 : 90;

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = static_cast<png_uint_32>(side);
  image.format = PNG_FORMAT_GRAY;
  if (!png_image_write_to_file(&image, path.c_str(), 0, grey.data(), 0, nullptr))
    throw Error("cannot write " + path + ": " + image.message);
}

} // namespace

void write_checkerboard(const std::string& folder, const std::string& name, const Quartic_differential& q)
{
  const std::string texture = name + ".png";
  internal::write_file(folder + "/" + name + ".mtl", [&](std::ostream& out) {
    out << "newmtl checkerboard\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " << texture << '\n';
  });
  write_png(folder + "/" + texture, squares_per_unit(q));
}

} } // namespace CGAL::Quartic_differentials
