// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/arbitrary_precision.h>
#include <CGAL/Quartic_differentials/boundary_corners.h>
#include <CGAL/Quartic_differentials/choose_corners.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/Timed_step.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <algorithm>
#include <complex>
#include <string>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Timed_step;
using internal::scientific;

void append(Divisor& divisor, const Divisor& more) { divisor.insert(divisor.end(), more.begin(), more.end()); }

// Surfaces with boundary have no period matrix.
void refuse_what_needs_periods(const Quartic_differential_options& options)
{
  if (options.route == Abel_jacobi_route::zeros)
    throw Infeasible_divisor_error("the Abel-Jacobi map from the zeros of a holomorphic 1-form belongs to closed surfaces: "
                                   "take the one from the curvature");
  if (options.legalization.norm != Lattice_norm::movement)
    throw Infeasible_divisor_error("the norms of the periods belong to closed surfaces: take the norm of least movement");
}

// The divisor to start from: given, completed, or chosen. Corners of the boundary are found if none are given.
Divisor starting_divisor(const Riemann_surface& s, const std::optional<Divisor>& singularities,
                         const Quartic_differential_options& options, Visitor& visitor,
                         std::optional<Chosen_singularities>& choice)
{
  Divisor given = singularities.value_or(Divisor());
  if (options.corners) append(given, *options.corners);
  given = on_delaunay(s, std::move(given));
  const bool has_boundary = s.delaunay.has_boundary();
  const bool finds_corners = has_boundary && !options.corners
    && std::none_of(given.begin(), given.end(), [](const Singularity& p) { return p.on_boundary; });
  if (!singularities || options.add_to_given) {
    const bool from_curvature = options.choice.start == Singularity_start::curvature
                             || options.choice.start == Singularity_start::automatic;
    if (!singularities && options.optimize == Optimize::never && from_curvature && !has_boundary)
      return curvature_divisor(s.delaunay, s.weights, s.laplacian, options.choice.count);   // the paper's
    const auto choose = finds_corners ? choose_corners_and_singularities : choose_singularities;
    choice = choose(s, given, options.choice, options.legalization, options.distortion, visitor);
    return choice->divisor;
  }
  if (finds_corners) append(given, boundary_corners(s.delaunay));
  return options.repair_degree ? with_repaired_degree(s.delaunay, s.weights, given) : given;
}

// Step 5: onto the Abel-Jacobi variety, and along it to where areas are distorted least.
void legalize(const Abel_jacobi_map& map, const Riemann_surface& s, const Quartic_differential_options& options,
              Visitor& visitor, Quartic_differential_result& r)
{
  const Area_distortion distortion(s.delaunay, s.laplacian, vertex_areas(s.delaunay));
  const bool chosen = r.choice.has_value();
  if (options.optimize == Optimize::always || (options.optimize == Optimize::automatic && chosen)) {
    r.optimal = minimize_distortion(distortion, map, s.periods, *r.initial, options.legalization, options.distortion,
                                    visitor);
    r.legal = r.optimal->legal;
    r.distortion = r.optimal->distortion;
  } else {
    r.legal = s.delaunay.has_boundary() ? legalize_divisor(map, *r.initial, options.legalization, visitor)
                                        : legalize_divisor(map, s.periods, *r.initial, options.legalization, visitor);
    r.distortion = distortion.energy(distortion.log_scale(r.legal->divisor));
  }
  r.solves = distortion.solves();
}

// The image of the legal divisor: its residual is known on the sheet where it was legalized, the integers on sheet 0.
Abel_jacobi_image image_of(const Abel_jacobi_map& map, const Riemann_surface& s, const Legal_divisor& legal)
{
  const Eigen::VectorXd on_sheet_0 = map.residual(legal.divisor);
  const Eigen::VectorXd nearest = (on_sheet_0 / (0.5 * CGAL_PI)).array().round();
  return abel_jacobi_image(map, s.periods, s.zeros, on_sheet_0, nearest);
}

// Steps 5 and 6. Where singularities that were chosen come too near each other when the holonomy is made exact, as they may
// on coarse meshes, others are chosen that keep twice the distance before.
void find_metric(const Abel_jacobi_map& map, const Riemann_surface& s, const std::optional<Divisor>& singularities,
                 Quartic_differential_options options, Visitor& visitor, Quartic_differential_result& r)
{
  for (int choices_left = 2; ; --choices_left) {
    {
      const Timed_step step(visitor, "legalization");
      r.initial = starting_divisor(s, singularities, options, visitor, r.choice);
      legalize(map, s, options, visitor, r);
      if (!s.delaunay.has_boundary()) r.image = image_of(map, s, *r.legal);
    }
    try {
      r.metric = exact_cone_metric(s.delaunay, s.homology.cochains, r.legal->divisor, options.cone_metric, visitor,
                                   &s.laplacian);
      return;
    } catch (const Colliding_singularities_error& e) {
      if (!r.choice || choices_left == 0) throw;
      visitor.progress(std::string(e.what()) + "; others are chosen, farther from each other");
    }
    options.distortion.guard_distance *= 2;
    options.distortion.boundary_distance *= 2;
  }
}

// Why the flat metric of step 6 is not good enough, as a sentence, or "".
std::string shortfall(const Exact_cone_metric& m)
{
  const Flow_report& flow = m.metric.flow;
  if (m.reached) return {};
  if (!flow.reached())
    return "the flat metric was not reached: the curvature error is " + scientific(flow.max_curvature_error) + " rad after "
           + std::to_string(flow.newton_iterations) + " Newton steps (tolerance " + scientific(flow.tolerance) + ")";
  return "the holonomy was not made exact: the error is " + scientific(m.max_holonomy_error) + " rad on the basis loops and "
         + scientific(m.max_transition_error) + " rad on edges";
}

// More digits help where a solution is near; where it is not, the divisor is to blame.
void require_near(const Exact_cone_metric& m)
{
  const double near = 1e-3;   // radians
  if (m.metric.flow.max_curvature_error < near && m.max_holonomy_error < near) return;
  throw Numerical_error(shortfall(m) + "; use more or better placed singularities");
}

// The same for the metric on the triangulation that is laid out, made from the input's own triangles.
std::string shortfall(const Precision_report& p, double accepted)
{
  if (p.max_curvature_error <= accepted && p.max_transition_error <= accepted) return {};
  return "the input's triangles are too thin: the curvature error is " + scientific(p.max_curvature_error)
         + " rad there, that of transitions " + scientific(p.max_transition_error) + " rad";
}

void require_valid(const Refined_surface& refined)
{
  if (refined.flipped_triangles > 0)
    throw Numerical_error(std::to_string(refined.flipped_triangles) + " triangles of the refined surface are too small for "
                          "the grid: the input has triangles that are too thin, or the scale factors vary too much");
  if (const std::string violation = defect(refined.differential); !violation.empty())
    throw Numerical_error("the refined surface does not carry the flat metric: " + violation);
}

// Puts the cones that were inserted in faces to their places in space, on anything that has `set_point()`.
template <class Surface>
void set_positions(const Intrinsic_triangulation& input, const Divisor& divisor, const std::vector<Vertex>& cones,
                   Surface& surface)
{
  if (!input.is_embedded()) return;
  for (std::size_t i = 0; i < divisor.size(); ++i)
    if (cones[i].idx() >= input.number_of_vertices())
      surface.set_point(cones[i], position_on_input(input, divisor[i].location));
}

// The final divisor on the input, and the cones' places in space.
void place_singularities(const Intrinsic_triangulation& input, Quartic_differential_result& r)
{
  r.singularities = on_input(*r.surface, r.metric->divisor);
  set_positions(input, r.singularities, r.metric->metric.cones, r.metric->metric.triangulation);
}

// Step 7 in numbers of more digits; the cones' last moves and the scales go back into the results in doubles.
void immerse_precisely(const Intrinsic_triangulation& input, int bits, const std::string& reason,
                       const Quartic_differential_options& options, Visitor& visitor, Quartic_differential_result& r)
{
  if (!reason.empty())
    visitor.progress("double precision is not enough: " + reason + "; going on with " + std::to_string(bits) + " bits");
  Cone_metric& m = r.metric->metric;
  Precise_immersion precise = precise_immersion(input, m, *r.refined_metric, bits, options.immersion, visitor);
  r.precision = std::move(precise.precision);
  r.precision->reason = reason;
  m.u = precise.u;
  for (std::size_t i = 0; i < r.singularities.size(); ++i) {
    const std::complex<double> move(precise.moved[2 * i], precise.moved[2 * i + 1]);
    if (move == 0.) continue;
    Surface_point& p = r.singularities[i].location;
    if (r.singularities[i].on_boundary) {
      p = internal::slide(input, p, move.real(), [](const Surface_point&, const Surface_point&) {});
    } else {
      const auto corner = input.unfolded(p.face);
      p.barycentric = internal::barycentric(corner, internal::point_in_frame(corner, p.barycentric) + move);
    }
    r.metric->moved_by[i] += std::abs(move);
  }
  set_positions(input, r.singularities, m.cones, r.refined_metric->refinement);
  set_positions(input, r.singularities, m.cones, precise.differential.triangulation);
  r.differential = std::move(precise.differential);
  r.immersion = precise.immersion;
}

// Step 7, with as many digits as are asked for or needed.
void immerse(const Intrinsic_triangulation& input, const Quartic_differential_options& options, Visitor& visitor,
             Quartic_differential_result& r)
{
  if (options.precision != 0) return immerse_precisely(input, options.precision, "", options, visitor, r);
  const int enough = 128;
  std::string reason = shortfall(*r.metric);
  if (reason.empty()) reason = shortfall(*r.precision, options.cone_metric.accepted_holonomy);
  if (reason.empty()) {
    const Cone_metric& m = r.metric->metric;
    r.differential = immersion(r.refined_metric->triangulation, r.refined_metric->lengths, m.cones, m.order, input.area(),
                               options.immersion, r.immersion);
    reason = unresolved_triangles(r.immersion);
  }
  if (!reason.empty()) immerse_precisely(input, enough, reason, options, visitor, r);
}

} // namespace

void quartic_differential(const Intrinsic_triangulation& input, const std::optional<Divisor>& singularities,
                          const Quartic_differential_options& options, Visitor& user_visitor,
                          Quartic_differential_result& result)
{
  if (options.quads) internal::require_embedded(input, "quads");
  if (input.has_boundary()) refuse_what_needs_periods(options);
  internal::Timing_visitor visitor(user_visitor, result.timings);
  result.surface = riemann_surface(input, visitor, options.homology);
  const Riemann_surface& s = *result.surface;

  std::optional<Abel_jacobi_map> map;
  {
    const Timed_step step(visitor, "abel_jacobi");
    if (options.route == Abel_jacobi_route::curvature) map.emplace(s.delaunay, s.homology.cochains, s.forms);
    else map.emplace(s.delaunay, s.forms, s.zeros);
  }
  find_metric(*map, s, singularities, options, visitor, result);
  result.surface->laplacian = Laplacian_solver();   // it would be the largest part of the result
  place_singularities(input, result);
  require_near(*result.metric);
  {
    const Timed_step step(visitor, "refinement");
    result.refined_metric = refined_cone_metric(input, cochains_of_loops(s.homology, input.number_of_edges()),
                                                result.singularities, result.metric->metric);
    result.precision = result.refined_metric->precision;
  }
  {
    const Timed_step step(visitor, "immersion");
    immerse(input, options, visitor, result);
    require_resolved_triangles(result.immersion);
  }
  if (input.is_embedded()) {
    const Timed_step step(visitor, "refinement");
    result.refined = refined_surface(input, *result.refined_metric, result.metric->metric.u, *result.differential);
    require_valid(*result.refined);
  }
  if (!result.singularities.empty() || input.has_boundary()) {
    const Timed_step step(visitor, "t_mesh");
    result.t_mesh = t_mesh(result.traced(), visitor);
  }
  if (options.quads) {
    const Timed_step step(visitor, "quad_mesh");
    if (!result.t_mesh)
      throw Infeasible_divisor_error("there is no singularity, hence no T-mesh that could be cut into quads");
    result.quads = quads(input, *result.t_mesh, *result.refined, *options.quads, visitor);
  }
}

} } // namespace CGAL::Quartic_differentials
