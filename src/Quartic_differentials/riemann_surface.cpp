// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/internal/Timed_step.h>
#include <CGAL/Quartic_differentials/relative_homology_basis.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Timed_step;

void add_harmonic_forms(Riemann_surface& s)
{
  s.weights = cotangent_weights(s.delaunay, s.delaunay.lengths());
  s.laplacian.factorize(s.delaunay, s.weights);
  s.forms = harmonic_1_forms(s.delaunay, s.homology.cochains, s.weights, s.laplacian);
}

Homology_basis basis_along_boundary(const Intrinsic_triangulation& t)
{
  Relative_homology_basis basis = relative_homology_basis(t);
  Homology_basis result;
  const int n = basis.cochains.size();
  result.loops = std::move(basis.paths);
  result.combination = Eigen::MatrixXi::Identity(n, n);
  result.cochains = std::move(basis.cochains);
  return result;
}

} // namespace

Riemann_surface riemann_surface(const Intrinsic_triangulation& input, Visitor& visitor, Homology_choice choice)
{
  const bool is_closed = !input.has_boundary();
  Riemann_surface s;
  {
    const Timed_step step(visitor, "homology");
    s.homology = is_closed ? homology_basis(input) : basis_along_boundary(input);
    if (is_closed && choice == Homology_choice::handle_tunnel) {
      s.loops = handle_tunnel_loops(input, handle_tunnel_basis(input, s.homology));
      s.homology = s.loops->classes.basis;
    }
  }
  {
    const Timed_step step(visitor, "refinement");
    s.delaunay = input;
    Common_refinement refinement(input);
    s.flips = make_delaunay(s.delaunay, s.homology.cochains, refinement);
    s.refinement.emplace(Refinement_cells(refinement, s.delaunay), refinement, s.delaunay);
  }
  {
    const Timed_step step(visitor, "holomorphic_forms");
    add_harmonic_forms(s);
  }
  if (is_closed) {
    const Timed_step step(visitor, "period_matrix");
    s.periods = period_matrix(s.forms);
    if (input.genus() > 1)
      s.zeros = zeros_of_holomorphic_form(s.delaunay, s.forms, Eigen::VectorXd::Ones(s.forms.size()), s.periods.star);
  }
  return s;
}

Divisor on_delaunay(const Riemann_surface& s, Divisor divisor)
{
  for (Singularity& p : divisor) p.location = s.refinement->from_input(p.location);
  return divisor;
}

Divisor on_input(const Riemann_surface& s, Divisor divisor)
{
  for (Singularity& p : divisor) p.location = s.refinement->to_input(p.location);
  return divisor;
}

Riemann_surface riemann_surface(const Coarse_surface& coarse)
{
  Riemann_surface s;
  s.delaunay = coarse.triangulation;
  s.homology.cochains = coarse.cochains;
  add_harmonic_forms(s);
  if (!s.delaunay.has_boundary()) s.periods = period_matrix(s.forms);
  return s;
}

} } // namespace CGAL::Quartic_differentials
