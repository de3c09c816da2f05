// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_RIEMANN_SURFACE_H
#define CGAL_QUARTIC_DIFFERENTIALS_RIEMANN_SURFACE_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Refinement_map.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/coarse_surface.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/handle_tunnel_loops.h>
#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/period_matrix.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// Which canonical basis of the homology is taken.
enum class Homology_choice
{
  any,            ///< the first that is found
  handle_tunnel   ///< one of short handle and tunnel loops, which people recognise
};

/// Steps 1 to 3: a triangulated surface as a Riemann surface. With boundary there are neither periods nor zeros, and the
/// homology basis is that of `relative_homology_basis()`, which has no intersection numbers.
struct Riemann_surface
{
  Intrinsic_triangulation         delaunay;     ///< the intrinsic Delaunay triangulation of the input's surface
  std::optional<Refinement_map>   refinement;   ///< carries points between the input's faces and `delaunay`
  std::size_t                     flips = 0;    ///< from the input to `delaunay`
  Homology_basis                  homology;     ///< loops on the input, cochains on `delaunay`
  std::optional<Handle_tunnel_loops> loops;     ///< on the input, if they were asked for
  std::vector<double>             weights;      ///< cotangent weights of `delaunay`
  Laplacian_solver                laplacian;
  Harmonic_1_forms                forms;
  Period_matrix                   periods;
  std::vector<Holomorphic_zero>   zeros;        ///< of the holomorphic form with all coefficients 1, order 2g-2 in all
};

/// computes steps 1 to 3 of the pipeline.
/// \pre `input` is connected; with boundary, `split_obtuse_at_boundary()` leaves nothing to do on it
/// Complexity: one sparse factorisation, 2g back-substitutions, O(n log n) for the rest; and that of
/// `handle_tunnel_basis()` and `handle_tunnel_loops()` if their basis is chosen.
Riemann_surface riemann_surface(const Intrinsic_triangulation& input, Visitor& visitor,
                                Homology_choice choice = Homology_choice::any);

/// takes the places of a divisor from the faces of the input to those of `s.delaunay`.
/// \pre `s` was made from an input, not from a coarsened surface
Divisor on_delaunay(const Riemann_surface& s, Divisor divisor);
/// the inverse of `on_delaunay()`, up to rounding
Divisor on_input(const Riemann_surface& s, Divisor divisor);

/// computes steps 2 and 3 on a coarsened surface: there are no loops, no refinement and no zeros, and no period matrix
/// of a surface with boundary.
Riemann_surface riemann_surface(const Coarse_surface& coarse);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_RIEMANN_SURFACE_H
