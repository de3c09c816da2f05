// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_QUAD_QUALITY_H
#define CGAL_QUARTIC_DIFFERENTIALS_QUAD_QUALITY_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Surface_distance.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>

#include <cstddef>
#include <map>

namespace CGAL {
namespace Quartic_differentials {

/// What one wants to know of a quad mesh before one uses it.
struct Quad_quality
{
  /// Least value, mean and greatest value.
  struct Spread { double least, mean, most; };

  Scaled_jacobian  scaled_jacobian;
  Spread           angle;             ///< at the corners of quads [degrees]; a corner seen as reflex has more than 180
  double           angle_deviation;   ///< from 90, the mean of absolute values [degrees]
  Spread           edge_ratio;        ///< of quads: the longest side by the shortest
  Spread           edge_length;       ///< of edges
  Surface_distance to_input;          ///< from the quads, as bilinear surfaces, at the centres of their 4 x 4 parts
  Surface_distance from_input;        ///< from the input's vertices, to quads cut into 4 triangles round their centres
  std::map<std::size_t, std::size_t> irregular_vertices;   ///< inside: their number, by valence
  std::map<std::size_t, std::size_t> corners;              ///< of the boundary, not of 2 quads: their number, by quads
  std::size_t      patches;           ///< of the T-mesh that have quads; others have width or height 0
};

/// measures the shape of the quads, and how far they are from the surface in both directions.
///
/// Not promised: an upper bound on the distance; it is that of the samples.
/// \param input the surface that `m` is a mesh of; `m.input_points` tell where the search for nearest points begins
/// \pre `m` has a quad, and its quads make up a surface
/// \throws Unusable_surface_error if `input` is not embedded
/// Complexity: O((m + n) log (m + n)) for m quads and n faces of the input, if the mesh is near the input.
/// Source: scaled Jacobian and edge ratio, Stimpson, Ernst, Knupp, Pebay and Thompson 2007 (Verdict).
Quad_quality quad_quality(const Intrinsic_triangulation& input, const Quad_mesh& m);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_QUAD_QUALITY_H
