// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIAL_H
#define CGAL_QUARTIC_DIFFERENTIAL_H

#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/copy_mesh.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <CGAL/Named_function_parameters.h>

#include <optional>

namespace CGAL {

/// The meromorphic quartic differential of a closed surface, and everything on the way to it. One header per step of
/// the pipeline stands in CGAL/Quartic_differentials/; this header is all that an application needs.
namespace Quartic_differentials {

/// computes the meromorphic quartic differential of a closed triangle mesh: singularities that satisfy the Abel-Jacobi
/// condition, the flat cone metric they span, its charts with exact transitions, and the T-mesh of rectangles.
///
/// \param mesh a closed connected triangle mesh of any genus
/// \param options how the singularities are chosen, and the tolerances of the steps
/// \param visitor reports progress and can stop the run
/// \param np see `intrinsic_triangulation()`
/// \throws Unusable_surface_error, Infeasible_divisor_error, Numerical_error, Cancelled_error with a sentence that says why
/// Complexity: a few sparse factorisations; the rest is O(n log n).
/// Source: METHOD; paper, section 4.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Quartic_differential_result quartic_differential(const TriangleMesh& mesh, const Quartic_differential_options& options,
                                                 Visitor& visitor,
                                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  Quartic_differential_result result;
  quartic_differential(intrinsic_triangulation(mesh, np), std::nullopt, options, visitor, result);
  return result;
}

/// \overload with default options and without progress
template <class TriangleMesh>
Quartic_differential_result quartic_differential(const TriangleMesh& mesh)
{
  Visitor visitor;
  return quartic_differential(mesh, Quartic_differential_options(), visitor);
}

} // namespace Quartic_differentials
} // namespace CGAL

#endif // CGAL_QUARTIC_DIFFERENTIAL_H
