// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/Timed_step.h>
#include <CGAL/Quartic_differentials/internal/face_frames.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>
#include <CGAL/Quartic_differentials/pipeline.h>


namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Timed_step;
using internal::scientific;

// The divisor to start from: given, completed, or chosen.
Divisor starting_divisor(const Riemann_surface& s, const std::optional<Divisor>& singularities,
                         const Quartic_differential_options& options, Visitor& visitor,
                         std::optional<Chosen_singularities>& choice)
{
  Divisor given = singularities.value_or(Divisor());
  for (Singularity& p : given) p.location = s.refinement->from_input(p.location);
  if (!singularities || options.add_to_given) {
    const bool from_curvature = options.choice.start == Singularity_start::curvature
                             || options.choice.start == Singularity_start::automatic;
    if (!singularities && options.optimize == Optimize::never && from_curvature)
      return curvature_divisor(s.delaunay, s.weights, s.laplacian, options.choice.count);   // the paper's
    choice = choose_singularities(s, given, options.choice, options.legalization, options.distortion, visitor);
    return choice->divisor;
  }
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
    r.legal = legalize_divisor(map, s.periods, *r.initial, options.legalization, visitor);
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

void require_reached(const Exact_cone_metric& m)
{
  if (m.reached) return;
  const Flow_report& flow = m.metric.flow;
  if (!flow.reached())
    throw Numerical_error("the flat metric was not reached: the curvature error is " + scientific(flow.max_curvature_error)
                          + " rad after " + std::to_string(flow.newton_iterations) + " Newton steps (tolerance "
                          + scientific(flow.tolerance) + "); use more or better placed singularities");
  throw Numerical_error("the holonomy was not made exact: the error is " + scientific(m.max_holonomy_error)
                        + " rad on the basis loops and " + scientific(m.max_transition_error) + " rad on edges");
}

void require_same_metric(const Refined_cone_metric& r)
{
  if (r.max_curvature_error <= 1e-6) return;   // radians; what the layout accepts of rotations
  throw Numerical_error("the input's triangles are too thin to carry the flat metric: its curvature error is "
                        + scientific(r.max_curvature_error) + " rad there");
}

void require_valid(const Refined_surface& refined)
{
  if (refined.flipped_triangles > 0)
    throw Numerical_error(std::to_string(refined.flipped_triangles) + " triangles of the refined surface are too small for "
                          "the grid: the input has triangles that are too thin, or the scale factors vary too much");
  if (const std::string violation = defect(refined.differential); !violation.empty())
    throw Numerical_error("the refined surface does not carry the flat metric: " + violation);
}

// The final divisor on the input, and the cones' places in space.
void place_singularities(const Intrinsic_triangulation& input, Quartic_differential_result& r)
{
  r.singularities = r.metric->divisor;
  for (std::size_t i = 0; i < r.singularities.size(); ++i) {
    Surface_point& p = r.singularities[i].location;
    p = r.surface->refinement->to_input(p);
    if (const Vertex v = r.metric->metric.cones[i]; input.is_embedded() && v.idx() >= input.number_of_vertices())
      r.metric->metric.triangulation.set_point(v, position_on_input(input, p));
  }
}

} // namespace

void quartic_differential(const Intrinsic_triangulation& input, const std::optional<Divisor>& singularities,
                          const Quartic_differential_options& options, Visitor& user_visitor,
                          Quartic_differential_result& result)
{
  internal::Timing_visitor visitor(user_visitor, result.timings);
  result.surface = riemann_surface(input, visitor);
  const Riemann_surface& s = *result.surface;

  std::optional<Abel_jacobi_map> map;
  {
    const Timed_step step(visitor, "abel_jacobi");
    if (options.route == Abel_jacobi_route::curvature) map.emplace(s.delaunay, s.homology.cochains, s.forms);
    else map.emplace(s.delaunay, s.forms, s.zeros);
  }
  {
    const Timed_step step(visitor, "legalization");
    result.initial = starting_divisor(s, singularities, options, visitor, result.choice);
    legalize(*map, s, options, visitor, result);
    result.image = image_of(*map, s, *result.legal);
  }
  result.metric = exact_cone_metric(s.delaunay, s.homology.cochains, result.legal->divisor, options.cone_metric, visitor);
  place_singularities(input, result);
  require_reached(*result.metric);
  const Cone_metric& m = result.metric->metric;
  {
    const Timed_step step(visitor, "refinement");
    result.refined_metric = refined_cone_metric(input, result.singularities, m);
    require_same_metric(*result.refined_metric);
  }
  const Refined_cone_metric& r = *result.refined_metric;
  {
    const Timed_step step(visitor, "immersion");
    result.differential = immersion(r.triangulation, r.lengths, m.cones, m.order, input.area(), options.immersion,
                                    result.immersion);
    require_resolved_triangles(result.immersion);
  }
  if (input.is_embedded()) {
    const Timed_step step(visitor, "refinement");
    result.refined = refined_surface(input, r, m.u, *result.differential);
    require_valid(*result.refined);
  }
  if (!result.singularities.empty()) {
    const Timed_step step(visitor, "t_mesh");
    result.t_mesh = t_mesh(result.traced(), visitor);
  }
}

void check_surface(const Intrinsic_triangulation& t)
{
  if (t.number_of_faces() == 0) throw Unusable_surface_error("the surface has no triangle");
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    if (!(four_times_area(t.length(h[0]), t.length(h[1]), t.length(h[2])) > 0))
      throw Unusable_surface_error("face " + std::to_string(f.idx()) + " has no area");
  }
  const std::size_t reached = internal::visit_faces_breadth_first(t, [](Halfedge) {});
  if (reached != t.number_of_faces())
    throw Unusable_surface_error("the surface is not connected: " + std::to_string(reached) + " of "
                                 + std::to_string(t.number_of_faces()) + " faces hang together with the first");
}

} } // namespace CGAL::Quartic_differentials
