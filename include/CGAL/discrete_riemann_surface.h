// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_RIEMANN_SURFACE_H
#define CGAL_DISCRETE_RIEMANN_SURFACE_H

#include <CGAL/Quartic_differentials/Mesh_divisor.h>
#include <CGAL/Quartic_differentials/copy_mesh.h>
#include <CGAL/Quartic_differentials/handle_tunnel_loops.h>
#include <CGAL/Quartic_differentials/jacobian_point.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/riemann_surface.h>

#include <CGAL/Named_function_parameters.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Steps 1 to 5 on a mesh of the user's. Each function stands alone: it takes a model of `FaceListGraph`, closed,
// connected and of triangles, and the named parameters of `intrinsic_triangulation()`, `halfedge_index_map` and
// `face_index_map`. An application that needs several of them makes one `Discrete_riemann_surface`, which has them as
// members.

/// A canonical basis of the homology: closed walks of halfedges, each ending where the next begins.
template <class TriangleMesh>
struct Canonical_homology_basis
{
  using Walk = std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>;
  std::vector<Walk> loops;       ///< a_1 .. a_g, b_1 .. b_g, with a_i . b_j = delta_ij
  bool              certified;   ///< it is proved that every a_i is a tunnel and every b_i a handle loop
  std::string       reason;      ///< if not `certified`: why not, a sentence
};

namespace internal {

template <class TriangleMesh>
Canonical_homology_basis<TriangleMesh> on_mesh(const Handle_tunnel_loops& found,
                                               const Mesh_correspondence<TriangleMesh>& correspondence)
{
  Canonical_homology_basis<TriangleMesh> basis{{}, found.classes.certified, found.classes.reason};
  for (const Edge_loop& loop : found.loops) {
    basis.loops.emplace_back();
    for (Halfedge h : loop.walk) basis.loops.back().push_back(correspondence.original(h));
  }
  return basis;
}

} // namespace internal

template <class TriangleMesh>
class Discrete_riemann_surface;

/// The normalised holomorphic 1-forms phi_1 .. phi_g, a model of `ReadablePropertyMap`: their integrals along halfedges.
template <class TriangleMesh>
struct Holomorphic_1_form_map
{
  using key_type   = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using value_type = Eigen::RowVectorXcd;
  using reference  = value_type;
  using category   = boost::readable_property_map_tag;

  Discrete_riemann_surface<TriangleMesh> surface;

  /// g complex numbers; those of the opposite halfedge are the negatives
  friend value_type get(const Holomorphic_1_form_map& forms, key_type h) { return forms.surface.integrals(h); }
};

/// The Riemann surface of a triangle mesh: a canonical basis of handle and tunnel loops, the holomorphic 1-forms and the
/// period matrix, computed once. Copies share it.
/// \tparam TriangleMesh a model of `FaceListGraph`. The mesh must not change as long as this is used.
template <class TriangleMesh>
class Discrete_riemann_surface
{
public:
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// \param np see `intrinsic_triangulation()`
  /// \throws Unusable_surface_error as there, and if the mesh has a boundary
  /// Complexity: one sparse factorisation, 2g back-substitutions, O(n log n) for the rest.
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Discrete_riemann_surface(const TriangleMesh& mesh,
                                    const NamedParameters& np = CGAL::parameters::default_values())
    : m_data(std::make_shared<const Data>(mesh, np)) {}

  int genus() const { return m_data->input.genus(); }

  /// a copy of the mesh, and what was computed, in the form in which the steps work
  const Intrinsic_triangulation& input() const { return m_data->input; }
  const Riemann_surface&         steps() const { return m_data->surface; }

  Canonical_homology_basis<TriangleMesh> canonical_homology_basis() const
  { return internal::on_mesh(*steps().loops, m_data->correspondence); }

  Holomorphic_1_form_map<TriangleMesh> holomorphic_1_form_basis() const { return {*this}; }

  const Period_matrix& period_matrix() const { return steps().periods; }

  /// the integrals of the normalised holomorphic 1-forms phi_1 .. phi_g along a halfedge. Complexity: O(g^2).
  Eigen::RowVectorXcd integrals(halfedge_descriptor h) const
  {
    // harmonic forms are eta_k + dg_k in every triangulation of the surface that has these vertices
    const Halfedge e = m_data->correspondence.copied(h);
    const auto& eta = steps().loops->classes.basis.cochains;
    const auto& g = steps().forms.potential;
    return (eta.row(e).template cast<double>() + g.row(input().target(e)) - g.row(input().source(e)))
         * m_data->normalisation;
  }

  /// see `jacobian_point()`
  Jacobian_point abel_jacobi_map(const Mesh_divisor<TriangleMesh>& divisor) const
  { return jacobian_point(steps(), m_data->correspondence.copied(divisor)); }

  /// see `legalize_divisor()`
  Mesh_divisor<TriangleMesh> legalize_divisor(const Mesh_divisor<TriangleMesh>& divisor,
                                              const Legalization_options& options = Legalization_options()) const
  {
    const Riemann_surface& s = steps();
    const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
    const Divisor start = on_delaunay(s, m_data->correspondence.copied(divisor));
    Visitor visitor;
    const Legal_divisor legal = Quartic_differentials::legalize_divisor(map, s.periods, start, options, visitor);
    return m_data->correspondence.original(on_input(s, legal.divisor));
  }

private:
  struct Data
  {
    template <class NamedParameters>
    Data(const TriangleMesh& mesh, const NamedParameters& np)
      : input(intrinsic_triangulation(mesh, np)), correspondence(mesh, input, np), surface(steps_1_to_3(input)),
        normalisation(Quartic_differentials::normalisation(surface.periods))
    {}

    static Riemann_surface steps_1_to_3(const Intrinsic_triangulation& input)
    {
      if (input.has_boundary())
        throw Unusable_surface_error("the mesh has a boundary: only closed surfaces have a period matrix");
      Visitor visitor;
      return riemann_surface(input, visitor, Homology_choice::handle_tunnel);
    }

    Intrinsic_triangulation                     input;
    internal::Mesh_correspondence<TriangleMesh> correspondence;
    Riemann_surface                             surface;
    Eigen::MatrixXcd                            normalisation;
  };

  std::shared_ptr<const Data> m_data;
};

/// finds a canonical homology basis, deterministically: short closed walks of halfedges, tunnel loops a_i and handle
/// loops b_i where the mesh lies in space without meeting itself.
/// \param np see `intrinsic_triangulation()`
/// Complexity: O(n log n); no linear system is solved.
/// Source: METHOD, step 1.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Canonical_homology_basis<TriangleMesh>
canonical_homology_basis(const TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values())
{
  const Intrinsic_triangulation copy = intrinsic_triangulation(mesh, np);
  const Handle_tunnel_loops found = handle_tunnel_loops(copy, handle_tunnel_basis(copy, homology_basis(copy)));
  return internal::on_mesh(found, internal::Mesh_correspondence<TriangleMesh>(mesh, copy, np));
}

/// computes the basis of holomorphic 1-forms with the integral of phi_j along a_i = delta_ij.
/// The forms are closed: their integrals round a face are 0 up to rounding.
/// \param np see `intrinsic_triangulation()`
/// Complexity: one sparse factorisation and 2g back-substitutions; O(g^2) for the values on a halfedge.
/// Source: METHOD, step 2; paper, section 4.2.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Holomorphic_1_form_map<TriangleMesh>
holomorphic_1_form_basis(const TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values())
{ return Discrete_riemann_surface<TriangleMesh>(mesh, np).holomorphic_1_form_basis(); }

/// computes the period matrix in the basis of `canonical_homology_basis()`.
/// \param np see `intrinsic_triangulation()`
/// Complexity: one sparse factorisation and 2g back-substitutions.
/// Source: METHOD, step 3; paper, section 4.3.
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Period_matrix period_matrix(const TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values())
{ return Discrete_riemann_surface<TriangleMesh>(mesh, np).period_matrix(); }

/// maps a divisor of degree 0, or 8g - 8, to the Jacobian: see `jacobian_point()`.
/// \param np see `intrinsic_triangulation()`
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Jacobian_point abel_jacobi_map(const TriangleMesh& mesh, const Mesh_divisor<TriangleMesh>& divisor,
                               const NamedParameters& np = CGAL::parameters::default_values())
{ return Discrete_riemann_surface<TriangleMesh>(mesh, np).abel_jacobi_map(divisor); }

/// moves the singularities of a divisor of degree 8g - 8 by as little as possible until it is that of a quartic
/// differential: see `legalize_divisor()` of the steps. Orders and pins stay.
/// \param np see `intrinsic_triangulation()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{legalization_options}
///     \cgalParamDescription{norm, tolerances and limits, of `Quartic_differentials::parameters`}
///     \cgalParamType{`Legalization_options`}
///     \cgalParamDefault{`Legalization_options()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Infeasible_divisor_error, Numerical_error as there
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Mesh_divisor<TriangleMesh> legalize_divisor(const TriangleMesh& mesh, const Mesh_divisor<TriangleMesh>& divisor,
                                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const Legalization_options options = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, parameters::legalization_options_t()), Legalization_options());
  return Discrete_riemann_surface<TriangleMesh>(mesh, np).legalize_divisor(divisor, options);
}

} // namespace Quartic_differentials
} // namespace CGAL

#endif // CGAL_DISCRETE_RIEMANN_SURFACE_H
