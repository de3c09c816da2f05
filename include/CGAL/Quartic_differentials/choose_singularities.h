// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_CHOOSE_SINGULARITIES_H
#define CGAL_QUARTIC_DIFFERENTIALS_CHOOSE_SINGULARITIES_H

#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/minimize_distortion.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// Where the search for singularities starts.
enum class Singularity_start
{
  automatic,   ///< the field where it has few singularities, and pairs; the better of the two
  curvature,   ///< the paper's: extrema of the curvature; of closed surfaces only
  field,       ///< the singularities of the smoothest 4-direction field, from which pairs are taken away
  pairs        ///< the least number, to which pairs of a pole and a zero are added
};

/// Which singularities `choose_singularities()` looks for, and where it starts.
struct Singularity_choice_options
{
  double            distortion = 0.01;   ///< E aimed at with as few singularities as possible: the least number with
                                         ///< which it is met within a fifth is taken
  int               count      = 0;      ///< this many instead, or one more (parity); 0: as `distortion` asks for
  Singularity_start start      = Singularity_start::automatic;
  int               least_order = -1;    ///< poles are merged down to this order, at least -3 and at most -1
  int               most_order  = 2;     ///< zeros are merged up to this order, at least 1
  double            worth      = 5e-4;   ///< a pair of singularities has to lower E by this
  int               most_singularities = 200;
  std::size_t       coarse_vertices = 10000;   ///< larger surfaces are coarsened to that for the search
  std::size_t       explored_vertices = 5000;  ///< and to that for its first part, without the Abel-Jacobi condition
  std::size_t       field_limit = 150;   ///< `automatic` ignores fields with more singularities
  unsigned          seed       = 0;      ///< of the field's eigenvector
  bool              pareto     = false;  ///< find the least distortion for every count, up to a quarter of the wanted one
};

/// The least distortion that was found for a number of singularities.
struct Pareto_point
{
  int    count;
  double distortion;         ///< E of the legal divisor
  double area_scale_ratio;   ///< 99% / 1% quantile ratio of e^2u, linearised
};

/// A divisor from which the search started, neither legal nor optimised, on the surface of the search's first part.
struct Start_of_search
{
  std::string name;               ///< "curvature", "field" or "pairs"
  int         count;
  double      distortion;         ///< E
  double      area_scale_ratio;   ///< 99% / 1% quantile ratio of e^2u, linearised
};

/// Singularities as a user would have chosen them, and how they were found.
struct Chosen_singularities
{
  Divisor     divisor;               ///< legal, and a local minimum of the distortion, but for the coarsening
  double      distortion;            ///< its E on the surface that was searched
  std::vector<Start_of_search> starts;
  std::vector<Pareto_point> pareto;  ///< by count, not dominated but perhaps for the choice; empty if not asked for
  std::size_t searched_vertices;     ///< of the surface that was searched
  std::size_t solves;                ///< right-hand sides of linear systems on that surface
};

/// chooses singularities that distort areas little: the fewest that meet the wanted distortion within a fifth, or a
/// given number of them with E as low as possible. Where the distortion cannot be met, pairs are added as long as they
/// are worth it; what was reached stands in the result.
///
/// On a surface with boundary, where it is straight but for the corners that are given, simple singularities are placed
/// in the interior only; `boundary_corners()` finds corners. Corners that are not pinned slide to where they distort
/// least.
///
/// Ignoring the Abel-Jacobi condition at first, it adds the pole and zero that lower E most (exactly, by Green's
/// functions), moves all to a local minimum, takes away pairs that are not worth it, merges zeros that meet, looks for
/// the best of the nearest lattice vectors, and goes on from there. Large surfaces are searched on intrinsic coarsenings.
/// Deterministic, but a change in the last digit of a coordinate may lead to another choice as good.
/// \param surface of one with boundary `periods` and `zeros` are not used
/// \param given singularities and corners that must be part of it; they stay where they are if they are pinned
/// \throws Infeasible_divisor_error if the count is below the least possible one, or no legal divisor was found
/// Complexity: a few factorisations, several hundred to thousands of back-substitutions on the searched surface.
/// Source: METHOD, "Choosing the singularities".
Chosen_singularities choose_singularities(const Riemann_surface& surface, const Divisor& given,
                                          const Singularity_choice_options& options,
                                          const Legalization_options& legalization,
                                          const Distortion_options& distortion, Visitor& visitor);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_CHOOSE_SINGULARITIES_H
