// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PIPELINE_H
#define CGAL_QUARTIC_DIFFERENTIALS_PIPELINE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Quartic_differential.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/choose_singularities.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/immersion.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/minimize_distortion.h>
#include <CGAL/Quartic_differentials/quads.h>
#include <CGAL/Quartic_differentials/refined_surface.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// Whether singularities are moved to where they distort areas least.
enum class Optimize { automatic, always, never };   ///< automatic: if they were chosen, not if they were given

/// The choices, tolerances and limits of all steps.
struct Quartic_differential_options
{
  Homology_choice      homology = Homology_choice::handle_tunnel;
  Singularity_choice_options choice;            ///< how singularities are chosen when none are given
  bool                 add_to_given = false;    ///< choose more, beside those that are given
  /// the corners of the boundary, on the faces of the input; without it they are found (`boundary_corners()`), unless there
  /// are corners among the given singularities
  std::optional<Divisor> corners;
  bool                 repair_degree = false;   ///< add simple singularities until the degree is 8g-8
  Optimize             optimize = Optimize::automatic;
  Abel_jacobi_route    route = Abel_jacobi_route::curvature;
  Legalization_options legalization;
  Distortion_options   distortion;
  Cone_metric_options  cone_metric;
  /// binary digits of the flat metric, its holonomy and its layout, 64 to 1024; 0: a double's, and 128 where they are not
  /// enough
  int                  precision = 0;
  Immersion_options    immersion;
  std::optional<Quad_options> quads;            ///< a quad mesh too
};

/// What the steps of the pipeline made; a step that was not reached left its part empty.
struct Quartic_differential_result
{
  /// of a mesh with boundary: its copy with vertices added there, to whose faces all below refers
  std::optional<Intrinsic_triangulation> split_input;
  std::optional<Riemann_surface>      surface;        ///< steps 1 to 3; without `laplacian` from step 7 on
  std::optional<Divisor>              initial;        ///< on `surface->delaunay`
  std::optional<Chosen_singularities> choice;         ///< how `initial` was chosen, if it was
  std::optional<Legal_divisor>        legal;          ///< step 5
  std::optional<Optimal_divisor>      optimal;        ///< how `legal` was optimised, if it was
  double                              distortion = 0; ///< E of the legal divisor, linearised
  std::size_t                         solves = 0;     ///< right-hand sides solved to optimise it on the whole surface
  std::optional<Abel_jacobi_image>    image;          ///< step 4, of the legal divisor; on closed surfaces
  std::optional<Exact_cone_metric>    metric;         ///< step 6
  Divisor                             singularities;  ///< the final divisor, on the faces of the input
  std::optional<Refined_cone_metric>  refined_metric; ///< the flat triangulation and the input
  std::optional<Precision_report>     precision;      ///< of the flat metric that is laid out
  std::optional<Quartic_differential> differential;   ///< step 7, on the flat triangulation
  std::optional<Refined_surface>      refined;        ///< the same on the input, subdivided; if that is embedded
  Immersion_report                    immersion;
  std::optional<T_mesh>               t_mesh;         ///< step 8, on `traced()`
  std::optional<Quads>                quads;          ///< if they were asked for
  std::vector<std::pair<std::string, double>> timings; ///< seconds by step, in the order they ended

  /// the differential on which the T-mesh is traced: on the input where that is possible, otherwise on the flat
  /// triangulation
  const Quartic_differential& traced() const { return refined ? refined->differential : *differential; }
};

/// runs the eight steps from a surface to its T-mesh, and goes on to quads if `options.quads` says how.
///
/// \param singularities the divisor to start from, on the faces of `input`, corners of the boundary may be part of it; none:
///        they are chosen
/// \param result is filled step by step, so that it holds what was computed even if a later step throws
/// \pre `input` is a connected surface without degenerate triangles; with boundary, `split_obtuse_at_boundary()` leaves
///      nothing to do on it. `result` holds nothing, but for `split_input`
/// \throws Infeasible_divisor_error, Numerical_error, Cancelled_error: see the steps
/// \throws Unusable_surface_error if quads are asked for and `input` is not embedded
void quartic_differential(const Intrinsic_triangulation& input, const std::optional<Divisor>& singularities,
                          const Quartic_differential_options& options, Visitor& visitor,
                          Quartic_differential_result& result);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_PIPELINE_H
