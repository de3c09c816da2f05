// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Nearest_point.h>

#include <cmath>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

[[noreturn]] void refuse(int line, const std::string& why)
{
  throw Infeasible_divisor_error("line " + std::to_string(line) + " of the singularities: " + why);
}

} // namespace

Divisor read_singularities(std::istream& in, const Intrinsic_triangulation& surface)
{
  if (!surface.is_embedded())
    throw Infeasible_divisor_error("singularities are given by points in space, but the surface is known by its edge "
                                   "lengths alone");
  const internal::Nearest_point nearest(surface);
  Divisor divisor;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::istringstream words(text.substr(0, text.find('#')));
    double x, y, z;
    std::string first;
    if (!(words >> first)) continue;
    words.clear();
    words.seekg(0);
    Singularity s;
    if (!(words >> x >> y >> z >> s.order)) refuse(line, "expected 'x y z order [pinned]'");
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) refuse(line, "a coordinate is not finite");
    std::string word;
    if (words >> word) {
      if (word != "pinned") refuse(line, "expected 'pinned' or nothing after the order, not '" + word + "'");
      s.pinned = true;
    }
    if (words >> word) refuse(line, "'" + word + "' is one word too many");
    s.location = nearest(Point_3(x, y, z));
    divisor.push_back(s);
  }
  return divisor;
}

void write_singularities(std::ostream& out, const Divisor& divisor, const Intrinsic_triangulation& surface)
{
  out << "# x y z order [pinned]\n";
  out.precision(17);
  for (const Singularity& s : divisor)
    out << position_on_input(surface, s.location) << ' ' << s.order << (s.pinned ? " pinned\n" : "\n");
}

} } // namespace CGAL::Quartic_differentials
