// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Nearest_boundary_point.h>
#include <CGAL/Quartic_differentials/internal/Nearest_point.h>

#include <cmath>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double far = 0.05;   // from the boundary, times sqrt(area)

// A line of a file: a point and a whole number.
struct Numbered_point
{
  int     line;
  Point_3 point;
  int     number;
  bool    pinned;
};

// Reads lines `x y z number [pinned]`. What they are is for messages: "singularities", and what the number is: "order".
class Point_reader
{
public:
  Point_reader(std::istream& in, const std::string& what, const std::string& number)
    : m_in(in), m_what(what), m_number(number) {}

  [[noreturn]] void refuse(int line, const std::string& why) const
  { throw Infeasible_divisor_error("line " + std::to_string(line) + " of the " + m_what + ": " + why); }

  void require_embedded(const Intrinsic_triangulation& surface) const
  {
    if (!surface.is_embedded())
      throw Infeasible_divisor_error(m_what + " are given by points in space, but the surface is known by its edge "
                                     "lengths alone");
  }

  // calls `visit(point)` for every line that has one
  template <class Visit>
  void read(Visit visit) const
  {
    std::string text;
    for (int line = 1; std::getline(m_in, text); ++line) {
      std::istringstream words(text.substr(0, text.find('#')));
      double x, y, z;
      std::string first;
      if (!(words >> first)) continue;
      words.clear();
      words.seekg(0);
      Numbered_point p{line, {}, 0, false};
      if (!(words >> x >> y >> z >> p.number)) refuse(line, "expected 'x y z " + m_number + " [pinned]'");
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) refuse(line, "a coordinate is not finite");
      std::string word;
      if (words >> word) {
        if (word != "pinned")
          refuse(line, "expected 'pinned' or nothing after the " + m_number + ", not '" + word + "'");
        p.pinned = true;
      }
      if (words >> word) refuse(line, "'" + word + "' is one word too many");
      p.point = Point_3(x, y, z);
      visit(p);
    }
  }

private:
  std::istream& m_in;
  std::string   m_what, m_number;
};

void write_line(std::ostream& out, const Intrinsic_triangulation& surface, const Singularity& s, int number)
{ out << position_on_input(surface, s.location) << ' ' << number << (s.pinned ? " pinned\n" : "\n"); }

} // namespace

Divisor read_singularities(std::istream& in, const Intrinsic_triangulation& surface)
{
  const Point_reader reader(in, "singularities", "order");
  reader.require_embedded(surface);
  const internal::Nearest_point nearest(surface);
  Divisor divisor;
  reader.read([&](const Numbered_point& p) { divisor.push_back({nearest(p.point), p.number, p.pinned}); });
  return divisor;
}

void write_singularities(std::ostream& out, const Divisor& divisor, const Intrinsic_triangulation& surface)
{
  out << "# x y z order [pinned]\n";
  out.precision(17);
  for (const Singularity& s : divisor)
    if (!s.on_boundary) write_line(out, surface, s, s.order);
}

Divisor read_corners(std::istream& in, const Intrinsic_triangulation& surface)
{
  const Point_reader reader(in, "corners", "m");
  reader.require_embedded(surface);
  if (!surface.has_boundary())
    throw Infeasible_divisor_error("corners are given, but the surface is closed: there is no boundary on which they "
                                   "could lie");
  const internal::Nearest_boundary_point nearest(surface);
  const double size = std::sqrt(surface.area());
  Divisor corners;
  reader.read([&](const Numbered_point& p) {
    if (p.number < 1) reader.refuse(p.line, "at least one quad must meet at a corner, not " + std::to_string(p.number));
    if (p.number == 2)
      reader.refuse(p.line, "where two quads meet the boundary is straight: this is no corner, leave it out");
    const Surface_point place = nearest(p.point);
    const double distance = std::sqrt(CGAL::squared_distance(p.point, position_on_input(surface, place)));
    if (!(distance <= far * size))
      reader.refuse(p.line, "the point is not on the boundary: its distance is " + std::to_string(distance / size)
                            + " sqrt(area), at most " + std::to_string(far) + " is allowed");
    corners.push_back({place, p.number - 2, p.pinned, true});
  });
  return corners;
}

void write_corners(std::ostream& out, const Divisor& divisor, const Intrinsic_triangulation& surface)
{
  out << "# x y z m [pinned], m quads at the corner\n";
  out.precision(17);
  for (const Singularity& s : divisor)
    if (s.on_boundary) write_line(out, surface, s, s.order + 2);
}

} } // namespace CGAL::Quartic_differentials
