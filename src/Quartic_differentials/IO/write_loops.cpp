// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_loops.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <ostream>

namespace CGAL {
namespace Quartic_differentials {

void write_loops_obj(std::ostream& stream, const Intrinsic_triangulation& t, const Handle_tunnel_loops& loops)
{
  internal::require_embedded(t, "loops.obj");
  internal::Text_writer out(stream);
  const int n = static_cast<int>(loops.loops.size());
  std::size_t vertices = 0;
  for (int k = 0; k < n; ++k) {
    const std::vector<Halfedge>& walk = loops.loops[k].walk;
    for (Halfedge h : walk) {
      const Point_3& p = t.mesh().point(t.source(h));
      out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    out << "g " << loop_name(k, n / 2) << ' ' << loop_kind(loops, k) << "\nl";
    for (std::size_t i = 0; i <= walk.size(); ++i) out << ' ' << vertices + 1 + i % walk.size();
    out << '\n';
    vertices += walk.size();
  }
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
