// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Kernel    = CGAL::Simple_cartesian<double>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree      = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

// The barycentric coordinates of a point of a face in space.
Surface_point in_face(const Intrinsic_triangulation& t, Face f, const Point_3& p)
{
  const auto h = t.halfedges(f);
  const auto at = [&](int k) { return t.mesh().point(t.source(h[k])); };
  const Kernel::Vector_3 normal = CGAL::cross_product(at(1) - at(0), at(2) - at(0));
  Surface_point q{f, {}};
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double share = CGAL::cross_product(at((k + 1) % 3) - p, at((k + 2) % 3) - p) * normal;
    sum += q.barycentric[k] = std::max(share, 0.0);
  }
  for (double& b : q.barycentric) b /= sum;
  return q;
}

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
  Tree tree(faces(surface.mesh()).first, faces(surface.mesh()).second, surface.mesh());
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
    const auto [point, face] = tree.closest_point_and_primitive(Point_3(x, y, z));
    s.location = in_face(surface, face, point);
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
