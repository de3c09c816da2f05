// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_PARAMETERS_H
#define CGAL_QUARTIC_DIFFERENTIALS_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Quartic_differentials {

/// Named parameters that CGAL does not have. They stand first, and CGAL's follow,
/// `edge_length_map(lengths).vertex_index_map(ids)`, or they are put on others,
/// `edge_length_map(lengths, legalization_options(options))`.
namespace parameters {

/// \cond
struct edge_length_map_t {};
struct legalization_options_t {};
struct singularities_t {};
/// \endcond

/// the lengths of the edges, instead of distances in space: a property map with `edge_descriptor` as key type and values
/// convertible to `double`
template <class EdgeLengthMap>
auto edge_length_map(const EdgeLengthMap& lengths)
{ return CGAL::Named_function_parameters<EdgeLengthMap, edge_length_map_t>(lengths); }

/// \overload
template <class EdgeLengthMap, class NamedParameters>
auto edge_length_map(const EdgeLengthMap& lengths, const NamedParameters& np)
{ return CGAL::Named_function_parameters<EdgeLengthMap, edge_length_map_t, NamedParameters>(lengths, np); }

/// norm, tolerances and limits of `legalize_divisor()`, a `Legalization_options`
template <class Options>
auto legalization_options(const Options& options)
{ return CGAL::Named_function_parameters<Options, legalization_options_t>(options); }

/// \overload
template <class Options, class NamedParameters>
auto legalization_options(const Options& options, const NamedParameters& np)
{ return CGAL::Named_function_parameters<Options, legalization_options_t, NamedParameters>(options, np); }

/// the singularities to start from, a `Mesh_divisor` of the mesh
template <class MeshDivisor>
auto singularities(const MeshDivisor& divisor)
{ return CGAL::Named_function_parameters<MeshDivisor, singularities_t>(divisor); }

/// \overload
template <class MeshDivisor, class NamedParameters>
auto singularities(const MeshDivisor& divisor, const NamedParameters& np)
{ return CGAL::Named_function_parameters<MeshDivisor, singularities_t, NamedParameters>(divisor, np); }

} } } // namespace CGAL::Quartic_differentials::parameters

#endif // CGAL_QUARTIC_DIFFERENTIALS_PARAMETERS_H
