// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_SMOOTH_QUADS_H
#define CGAL_QUARTIC_DIFFERENTIALS_SMOOTH_QUADS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// Limits of `smooth_quads()`.
struct Smoothing_options
{
  std::size_t sweeps = 60;        ///< at most
  double      guard = 0.6;        ///< a scaled Jacobian that is good enough; see below
  double      least_gain = 1e-4;  ///< a sweep gains something if the least or the mean grows by this
};

/// What a sweep over all vertices has reached. Scaled Jacobians are as in `scaled_jacobian()`, but those of quads that
/// are turned over against the input are taken along the opposite normal: of quads whose unit normal has a scalar
/// product below -1/2 with the mean of the input's unit normals at the vertices. That mean is short, and decides
/// nothing, where they disagree.
struct Smoothing_sweep
{
  double      least, mean;   ///< scaled Jacobian over all quads
  std::size_t moves;         ///< of vertices
};

/// What `smooth_quads()` did, sweep by sweep.
struct Smoothing_report
{
  std::vector<Smoothing_sweep> history;   ///< the mesh as it was, then after every sweep; `least` never falls
  std::size_t lowered = 0;                ///< number of the sweeps that only lower the energy; the others raise the least
  double seconds = 0;
};

/// moves the vertices of a quad mesh along the input surface, singularities too, so that the angles of the quads become
/// more nearly right; `quads` stays as it is.
///
/// Vertices move one after the other, each in its tangent plane and then to the nearest point of the surface: to where
/// the quads around would be parallelograms, on average, or to the middle of its neighbours, or by a step of a pattern
/// search. A move is made only if it lowers an energy of the angles and the ratios of edges at the corners of the quads
/// around, and if the least scaled Jacobian among them stays above the guard or does not fall. The guard is raised to
/// the mesh's least where that is above it; therefore the least of the mesh never falls. After a sweep that gains nothing,
/// if the mesh's least is still below the guard, what quads lack of the guard is penalised; a quad may then become worse for
/// the sake of others, but not worse than the mesh's least, and vertices walk along the surface too, in all directions and
/// as far as the next vertices, until three sweeps in a row gain nothing. Vertices of the boundary slide along it by the
/// same rules, each between its two neighbours there; corners stay.
///
/// Not promised: that every quad that is turned over is turned back, and that no two parts of the mesh cross. Results
/// are the same in every run; points are `position_on_input()` of `input_points`.
///
/// \param input the surface on which `m` lies
/// \pre `defect()` of `m` is empty; its vertices on the boundary are on that of the input, exactly: the coordinate of
///      `input_points` opposite the boundary edge is 0
/// \throws Unusable_surface_error if `input` is not embedded
/// \throws Numerical_error if a walk along it crosses more than 100,000 edges
/// Complexity: O(n log n) for n faces of the input. For every sweep O(m log n) for m quads, if edges are short against
///             the surface's features; vertices around which nothing has moved are passed over.
/// Source: METHOD, "Smoothing"; guarded moves, Freitag and Ollivier-Gooch 1997.
Smoothing_report smooth_quads(const Intrinsic_triangulation& input, const Smoothing_options& options, Quad_mesh& m);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_SMOOTH_QUADS_H
