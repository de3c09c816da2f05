// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VERIFY_ON_INPUT_H
#define CGAL_QUARTIC_DIFFERENTIALS_VERIFY_ON_INPUT_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/aabb_tree.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

using Surface_tree = internal::Face_tree<Mesh>;

using Kernel   = CGAL::Simple_cartesian<double>;
using Segments = std::vector<Kernel::Segment_3>;

double   diagonal(const CGAL::Bbox_3& box);
Segments boundary_of(const Mesh& mesh);
double   total_length(const Segments& segments);

/// of the points that farthest from the segments: its distance. \pre there are segments
double farthest_from(const Segments& segments, const std::vector<Point_3>& points);

} } } // namespace CGAL::Quartic_differentials::verification

#endif // CGAL_QUARTIC_DIFFERENTIALS_VERIFY_ON_INPUT_H
