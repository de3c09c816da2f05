// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_AABB_TREE_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_AABB_TREE_H

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/config.h>

// CGAL 6 knows trees in the plane too; what is for space has got names of its own, and the old ones warn.
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_segment_primitive_3.h>
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_segment_primitive.h>
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

using Aabb_kernel = CGAL::Simple_cartesian<double>;

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
template <class Primitive> using Aabb_traits = CGAL::AABB_traits_3<Aabb_kernel, Primitive>;
template <class Iterator> using Triangle_primitive = CGAL::AABB_triangle_primitive_3<Aabb_kernel, Iterator>;
template <class Iterator> using Segment_primitive = CGAL::AABB_segment_primitive_3<Aabb_kernel, Iterator>;
#else
template <class Primitive> using Aabb_traits = CGAL::AABB_traits<Aabb_kernel, Primitive>;
template <class Iterator> using Triangle_primitive = CGAL::AABB_triangle_primitive<Aabb_kernel, Iterator>;
template <class Iterator> using Segment_primitive = CGAL::AABB_segment_primitive<Aabb_kernel, Iterator>;
#endif

/// finds nearest points on the faces of a mesh.
template <class Mesh>
using Face_tree = CGAL::AABB_tree<Aabb_traits<CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

/// finds nearest points on triangles in a sequence.
template <class Iterator>
using Triangle_tree = CGAL::AABB_tree<Aabb_traits<Triangle_primitive<Iterator>>>;

/// finds nearest points on segments in a sequence.
template <class Iterator>
using Segment_tree = CGAL::AABB_tree<Aabb_traits<Segment_primitive<Iterator>>>;

/// finds nearest points on the edges of a mesh.
template <class Mesh>
using Edge_tree = CGAL::AABB_tree<Aabb_traits<CGAL::AABB_halfedge_graph_segment_primitive<Mesh>>>;

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_AABB_TREE_H
