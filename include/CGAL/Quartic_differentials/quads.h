// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_QUADS_H
#define CGAL_QUARTIC_DIFFERENTIALS_QUADS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/multipatch.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>
#include <CGAL/Quartic_differentials/quad_quality.h>
#include <CGAL/Quartic_differentials/quantize.h>
#include <CGAL/Quartic_differentials/refined_surface.h>
#include <CGAL/Quartic_differentials/smooth_quads.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <optional>

namespace CGAL {
namespace Quartic_differentials {

/// How many quads are made of a T-mesh, and what is made of them.
struct Quad_options
{
  Quantization_options quantization;     ///< its `surface_units_per_unit` is taken from the quartic differential
  bool                 smooth = true;
  Smoothing_options    smoothing;
  bool                 splines = false;  ///< on blocks of quads: 3 for every patch of the T-mesh, unless a number is given
};

/// What is made of a T-mesh.
struct Quads
{
  Quantization                      quantization;
  Quad_mesh                         mesh;
  Smoothing_report                  smoothing;         ///< empty if the mesh was not smoothed
  Quad_quality                      quality;
  std::optional<Multipatch>         splines;
  std::optional<Multipatch_quality> splines_quality;   ///< where there are splines
};

/// quantizes a T-mesh, fills it with quads, smooths those along the surface, measures them, and fits splines, as far as
/// is asked for.
/// \param refined the input surface with the T-mesh's quartic differential
/// \throws Infeasible_divisor_error, Numerical_error, Cancelled_error: see the steps
Quads quads(const Intrinsic_triangulation& input, const T_mesh& t, const Refined_surface& refined,
            const Quad_options& options, Visitor& visitor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_QUADS_H
