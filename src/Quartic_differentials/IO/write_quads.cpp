// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_quads.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>

#include <ostream>

namespace CGAL {
namespace Quartic_differentials {

void write_quads_obj(std::ostream& stream, const Quad_mesh& m)
{
  internal::Text_writer out(stream);
  for (const Point_3& p : m.points) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (std::size_t i = 0; i < m.quads.size(); ++i) {
    if (i == 0 || m.patch[i] != m.patch[i - 1]) out << "g patch_" << m.patch[i] << '\n';
    out << 'f';
    for (std::size_t v : m.quads[i]) out << ' ' << v + 1;
    out << '\n';
  }
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
