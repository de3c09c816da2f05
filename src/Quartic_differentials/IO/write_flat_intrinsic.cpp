// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Texture_vertices.h"

#include <CGAL/Quartic_differentials/IO/write_checkerboard.h>
#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Text_writer;

// "name":[item(x),...] over a range, one item a line
template <class Range, class Item>
void write_array(Text_writer& out, const char* name, const Range& range, Item item)
{
  out << ",\n\"" << name << "\":[";
  const char* separator = "\n";
  for (const auto x : range) {
    out << separator;
    item(x);
    separator = ",\n";
  }
  out << ']';
}

} // namespace

void write_flat_intrinsic_json(std::ostream& stream, const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  Text_writer out(stream);
  out << "{\"grid_exponent\":" << q.grid_exponent;
  const auto positions = t.is_embedded() ? std::vector<Vertex>(t.vertices().begin(), t.vertices().end())
                                         : std::vector<Vertex>();
  write_array(out, "vertices", positions, [&](Vertex v) {
    const Point_3& p = t.mesh().point(v);
    out << '[' << p.x() << ',' << p.y() << ',' << p.z() << ']';
  });
  write_array(out, "triangles", t.faces(), [&](Face f) {
    const auto h = t.halfedges(f);
    out << '[' << t.source(h[0]).idx() << ',' << t.source(h[1]).idx() << ',' << t.source(h[2]).idx() << ']';
  });
  write_array(out, "uv", t.faces(), [&](Face f) {
    const auto h = t.halfedges(f);
    out << '[';
    for (int k = 0; k < 3; ++k) out << q.corner[h[k]].x << ',' << q.corner[h[k]].y << (k < 2 ? ',' : ']');
  });
  write_array(out, "opposite", t.faces(), [&](Face f) {
    const auto h = t.halfedges(f);
    out << '[';
    for (int k = 0; k < 3; ++k) {
      const Halfedge o = t.opposite(h[k]);
      if (t.is_border(o)) out << "[-1,-1";
      else                out << '[' << t.face(o).idx() << ',' << t.corner(o);
      out << (k < 2 ? "]," : "]]");
    }
  });
  out << "}\n";
  out.finish();
}

void write_flat_obj(const std::string& folder, const std::string& name, const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  internal::require_embedded(t, "an .obj file");
  const Texture_vertices texture = texture_vertices(q);
  internal::write_file(folder + "/" + name + ".obj", [&](std::ostream& stream) {
    Text_writer out(stream);
    out << "# texture coordinates are charts of a quartic differential, exact multiples of 2^-" << q.grid_exponent
        << "\nmtllib " << name << ".mtl\nusemtl checkerboard\n";
    for (Vertex v : t.vertices()) {
      const Point_3& p = t.mesh().point(v);
      out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    for (Grid_vector z : texture.points)
      out << "vt " << std::ldexp(static_cast<double>(z.x), -q.grid_exponent) << ' '
          << std::ldexp(static_cast<double>(z.y), -q.grid_exponent) << '\n';
    for (Face f : t.faces()) {
      out << 'f';
      for (Halfedge h : t.halfedges(f))
        out << ' ' << t.source(h).idx() + 1 << '/' << texture.of_corner[h] + 1;
      out << '\n';
    }
    out.finish();
  });
  write_checkerboard(folder, name, q);
}

} } // namespace CGAL::Quartic_differentials
