// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/quads.h>

namespace CGAL {
namespace Quartic_differentials {

namespace {

Quantization_options quantization_options(const T_mesh& t, const Refined_surface& refined, const Quad_options& options)
{
  const std::size_t blocks_by_patch = 3;   // where angles are nearly as good as those of free quads (METHOD, "Splines")
  Quantization_options result = options.quantization;
  result.surface_units_per_unit = refined.differential.surface_units_per_unit;
  if (options.splines && result.number_of_blocks == 0) result.number_of_blocks = blocks_by_patch * t.patches.size();
  return result;
}

} // namespace

Quads quads(const Intrinsic_triangulation& input, const T_mesh& t, const Refined_surface& refined,
            const Quad_options& options, Visitor& visitor)
{
  Quads result;
  result.quantization = quantize(t, quantization_options(t, refined, options), visitor);
  result.mesh = quad_mesh(t, result.quantization.length, refined);
  if (options.smooth) result.smoothing = smooth_quads(input, options.smoothing, result.mesh);
  result.quality = quad_quality(input, result.mesh);
  if (options.splines) {
    result.splines = multipatch(input, surface_mesh(result.mesh, t));
    result.splines_quality = multipatch_quality(input, *result.splines);
    visitor.progress("splines: " + std::to_string(result.splines->patches.size()) + " patches");
  }
  return result;
}

} } // namespace CGAL::Quartic_differentials
