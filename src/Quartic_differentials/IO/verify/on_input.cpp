// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "on_input.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

double diagonal(const CGAL::Bbox_3& box)
{ return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()); }

Segments boundary_of(const Mesh& mesh)
{
  Segments segments;
  for (Halfedge h : mesh.halfedges())
    if (mesh.is_border(h)) segments.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  return segments;
}

double total_length(const Segments& segments)
{
  double length = 0;
  for (const Kernel::Segment_3& s : segments) length += std::sqrt(s.squared_length());
  return length;
}

double farthest_from(const Segments& segments, const std::vector<Point_3>& points)
{
  const internal::Segment_tree<Segments::const_iterator> tree(segments.begin(), segments.end());
  double farthest = 0;
  for (const Point_3& p : points) farthest = std::max(farthest, std::sqrt(tree.squared_distance(p)));
  return farthest;
}

} } } // namespace CGAL::Quartic_differentials::verification
