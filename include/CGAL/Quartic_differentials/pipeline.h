// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PIPELINE_H
#define CGAL_QUARTIC_DIFFERENTIALS_PIPELINE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Quartic_differential.h>
#include <CGAL/Quartic_differentials/Refinement_cells.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/immersion.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/period_matrix.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// Steps 1 to 3: a triangulated surface as a Riemann surface.
struct Riemann_surface
{
  Intrinsic_triangulation         delaunay;     ///< the intrinsic Delaunay triangulation of the input's surface
  std::optional<Refinement_cells> refinement;   ///< carries points between the input's faces and `delaunay`
  std::size_t                     flips = 0;    ///< from the input to `delaunay`
  Homology_basis                  homology;     ///< loops on the input, cochains on `delaunay`
  std::vector<double>             weights;      ///< cotangent weights of `delaunay`
  Laplacian_solver                laplacian;
  Harmonic_1_forms                forms;
  Period_matrix                   periods;
  std::vector<Holomorphic_zero>   zeros;        ///< of the holomorphic form with all coefficients 1, order 2g-2 in all
};

/// computes steps 1 to 3 of the pipeline.
/// \pre `input` is a closed connected surface
/// Complexity: one sparse factorisation, 2g back-substitutions, O(n log n) for the rest.
Riemann_surface riemann_surface(const Intrinsic_triangulation& input, Visitor& visitor);

struct Quartic_differential_options
{
  int                  count = 0;               ///< singularities when none are given; 0: automatic
  bool                 repair_degree = false;   ///< add simple singularities until the degree is 8g-8
  Abel_jacobi_route    route = Abel_jacobi_route::curvature;
  Legalization_options legalization;
  Cone_metric_options  cone_metric;
  Immersion_options    immersion;
};

/// What the eight steps of the pipeline made; a step that was not reached left its part empty.
struct Quartic_differential_result
{
  std::optional<Riemann_surface>      surface;        ///< steps 1 to 3
  std::optional<Divisor>              initial;        ///< on `surface->delaunay`
  std::optional<Legal_divisor>        legal;          ///< step 5
  std::optional<Abel_jacobi_image>    image;          ///< step 4, of the legal divisor
  std::optional<Exact_cone_metric>    metric;         ///< step 6
  Divisor                             singularities;  ///< the final divisor, on the faces of the input
  std::optional<Quartic_differential> differential;   ///< step 7
  Immersion_report                    immersion;
  std::optional<T_mesh>               t_mesh;         ///< step 8
  std::vector<std::pair<std::string, double>> timings; ///< seconds by step, in the order they ended
};

/// runs the eight steps from a surface to its T-mesh.
///
/// \param singularities the divisor to start from, on the faces of `input`; none: chosen from curvature extrema
/// \param result is filled step by step, so that it holds what was computed even if a later step throws
/// \pre `input` is a closed connected surface without degenerate triangles
/// \throws Infeasible_divisor_error, Numerical_error, Cancelled_error: see the steps
void quartic_differential(const Intrinsic_triangulation& input, const std::optional<Divisor>& singularities,
                          const Quartic_differential_options& options, Visitor& visitor,
                          Quartic_differential_result& result);

/// throws Unusable_surface_error if the surface is not connected or has a degenerate triangle.
void check_surface(const Intrinsic_triangulation& surface);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_PIPELINE_H
