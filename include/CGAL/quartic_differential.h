// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIAL_H
#define CGAL_QUARTIC_DIFFERENTIAL_H

#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/Mesh_divisor.h>
#include <CGAL/Quartic_differentials/copy_mesh.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/parameters.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/split_obtuse_at_boundary.h>

#include <CGAL/Named_function_parameters.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {

/// The meromorphic quartic differential of a surface, and everything on the way to it. One header per step of
/// the pipeline stands in CGAL/Quartic_differentials/; this header is all that an application needs.
namespace Quartic_differentials {

/// computes the meromorphic quartic differential of a triangle mesh: singularities that satisfy the Abel-Jacobi
/// condition, the flat cone metric they span, its charts with exact transitions, and the T-mesh of rectangles; quads and
/// splines too if `options.quads` says how.
///
/// \param mesh a connected triangle mesh of any genus, closed or with boundary, a model of `FaceListGraph`. If it has a
///        boundary, vertices may be added on that (`split_obtuse_at_boundary()`): results refer to `result.split_input`
/// \param options how the singularities are chosen, and the tolerances of the steps
/// \param visitor reports progress and can stop the run
/// \param result what was in it is forgotten; it is filled step by step, so that it holds what was computed even if a later
///        step throws
/// \param np see `intrinsic_triangulation()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{singularities}
///     \cgalParamDescription{the divisor to start from, of `Quartic_differentials::parameters`}
///     \cgalParamType{`Mesh_divisor<TriangleMesh>`}
///     \cgalParamDefault{none: the singularities are chosen}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Unusable_surface_error, Infeasible_divisor_error, Numerical_error, Cancelled_error with a sentence that says why
/// Complexity: a few sparse factorisations; the rest is O(n log n).
/// Source: METHOD; paper, section 4.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void quartic_differential(const TriangleMesh& mesh, const Quartic_differential_options& options, Visitor& visitor,
                          Quartic_differential_result& result,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  result = Quartic_differential_result();
  Intrinsic_triangulation copy = intrinsic_triangulation(mesh, np);
  std::optional<Divisor> start;
  const auto given = CGAL::parameters::get_parameter(np, parameters::singularities_t());
  if constexpr (!std::is_same<std::decay_t<decltype(given)>, internal_np::Param_not_found>::value)
    start = internal::Mesh_correspondence<TriangleMesh>(mesh, copy, np).copied(given);
  if (!copy.has_boundary()) return quartic_differential(copy, start, options, visitor, result);
  if (start) split_obtuse_at_boundary(copy, *start);
  else       split_obtuse_at_boundary(copy);
  result.split_input = std::move(copy);
  quartic_differential(*result.split_input, start, options, visitor, result);
}

/// \overload
/// This one returns the result, for those who want all or nothing.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Quartic_differential_result quartic_differential(const TriangleMesh& mesh,
                                                 const Quartic_differential_options& options = {},
                                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  Visitor visitor;
  Quartic_differential_result result;
  quartic_differential(mesh, options, visitor, result, np);
  return result;
}

} // namespace Quartic_differentials
} // namespace CGAL

#endif // CGAL_QUARTIC_DIFFERENTIAL_H
