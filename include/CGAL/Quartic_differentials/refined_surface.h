// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_REFINED_SURFACE_H
#define CGAL_QUARTIC_DIFFERENTIALS_REFINED_SURFACE_H

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Quartic_differential.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/internal/Construction.h>
#include <CGAL/Quartic_differentials/internal/Grouped.h>
#include <CGAL/Quartic_differentials/internal/cone_insertion.h>

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 7, "Common refinement")
//   A  the input with the cones inserted
//   C  the flat triangulation, on the same vertices

/// A flat metric on the flat triangulation C, with the common refinement of the input and C.
struct Refined_cone_metric
{
  Intrinsic_triangulation      triangulation;   ///< C, with unscaled lengths
  Integer_cochains             cochains;        ///< the homology basis on C
  std::vector<double>          lengths;         ///< by edge of C, in the flat metric
  Common_refinement            refinement;      ///< of A and C
  std::vector<Face>            input_face;      ///< by face of A: the face of the input it is part of
  Precision_report             precision;       ///< of `lengths`
  internal::Construction       construction;    ///< how C was made, to do it again in another number type
  internal::Length_derivatives derivatives;     ///< of the logarithms of the lengths of C by the positions of the cones
};

/// computes the flat triangulation of a cone metric anew, from the input with the cones inserted, with the common
/// refinement riding along: intrinsic Delaunay flips first, then Ptolemy flips straight to the given scales.
///
/// C is the triangulation of `metric` but for ties and rounding; the flow's own detours leave no trace.
/// \param input the surface of which `metric` is a conformal flat metric
/// \param cochains a homology basis on `input`
/// \param divisor its cones, on the faces of `input`
/// Complexity: O(n log n), linear in the crossings.
Refined_cone_metric refined_cone_metric(const Intrinsic_triangulation& input, const Integer_cochains& cochains,
                                        const Divisor& divisor, const Cone_metric& metric);

/// The input surface, subdivided by the edges of the flat triangulation, as a quartic differential: its triangulation is
/// embedded, its triangles lie in faces of the input and of C, and it is the differential of C on all of them.
///
/// Its vertices are the input's, then the cones inserted in faces, then the crossings of edges. Points of the input go to
/// the plane by `differential.chart(from_input(p))`, and back by `to_input(from_chart(f, z))`.
struct Refined_surface
{
  Quartic_differential differential;
  std::vector<Face>    input_face;     ///< by face: the face of the input in which it lies
  std::vector<std::array<double, 3>> input_corner;   ///< by halfedge: source(h) in barycentric coordinates of
                                                     ///< input_face[face(h)]
  internal::Grouped<Face> faces_in;                  ///< by face of the input: the faces that fill it
  std::size_t          flipped_triangles = 0;        ///< flipped or degenerate after rounding to the grid

  /// the point of the subdivision at a point of the input. Complexity: linear in the faces in the point's face.
  Surface_point from_input(const Surface_point& p) const;
  /// the point of the input at a point of the subdivision
  Surface_point to_input(const Surface_point& p) const;
  /// the point of a face at a place in its chart, in units. \pre z lies in the face, up to rounding
  Surface_point from_chart(Face f, std::complex<double> z) const;
};

/// the subdivided input as a `Surface_mesh` for applications, with the property maps
/// - `h:texture`, `Point_2` of `Simple_cartesian<double>`: target(h) in the chart of face(h), exact multiples of
///   2^-grid_exponent;
/// - `f:input_face`, `Face`: the index of the face of the input in which it lies;
/// - `v:input_point`, `Surface_point`: where it is on the input;
/// - `v:singularity_order`, `int`: order of the zero, minus that of the pole, 0 where regular.
/// Complexity: linear.
Mesh mesh_with_property_maps(const Refined_surface& refined);

/// subdivides the input along the edges of C.
///
/// First C is flipped back towards A inside its charts, where edges of A are straight in the plane, or nearly so: that
/// leaves far fewer triangles where the input's are long and thin.
/// A crossing of two edges lies on its A edge where straight lines of the flat metric cross (in the discrete conformal
/// map, projective on every triangle), and on the grid point nearest to that place of the C edge, moved along it where
/// points would come too near each other. On a seam one copy is computed, the other is its exact image. Cells are cut
/// into triangles whose least altitude on the grid is largest.
/// \param flat the quartic differential on `metric.triangulation`
/// \param u log scales by vertex
/// \throws Unusable_surface_error if `input` is not embedded
/// Complexity: linear in vertices and crossings.
/// Source: METHOD, step 7.
Refined_surface refined_surface(const Intrinsic_triangulation& input, const Refined_cone_metric& metric,
                                const std::vector<double>& u, const Quartic_differential& flat);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_REFINED_SURFACE_H
