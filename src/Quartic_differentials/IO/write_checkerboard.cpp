// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_checkerboard.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/checkerboard.h>
#include <CGAL/Quartic_differentials/internal/write_png.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

double area(const Quartic_differential& q)
{
  return std::ldexp(static_cast<double>(q.doubled_area()), -2 * q.grid_exponent - 1);
}

// one unit of the charts, the first row on top
internal::Image checkerboard(int squares)
{
  const int pixels = std::max(4, 1024 / squares), side = squares * pixels;
  internal::Image image = internal::blank_image(side, side, 1, 90);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (internal::is_light_square(x / pixels, squares - 1 - y / pixels)) image.at(x, y, 0) = 235;
  return image;
}

} // namespace

void write_checkerboard_png(std::ostream& out, const Quartic_differential& q)
{
  internal::write_png(out, checkerboard(internal::checkerboard_squares_per_unit(area(q))));
}

void write_checkerboard(const std::string& folder, const std::string& name, const Quartic_differential& q)
{
  const std::string texture = name + ".png";
  internal::write_file(folder + "/" + name + ".mtl", [&](std::ostream& out) {
    out << "newmtl checkerboard\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " << texture << '\n';
  });
  internal::write_file(folder + "/" + texture, [&](std::ostream& out) { write_checkerboard_png(out, q); });
}

} } // namespace CGAL::Quartic_differentials
