// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/Timed_step.h>
#include <CGAL/Quartic_differentials/internal/face_frames.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <sstream>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Timed_step;

Divisor starting_divisor(const Riemann_surface& s, const std::optional<Divisor>& singularities,
                         const Quartic_differential_options& options)
{
  if (!singularities) return curvature_divisor(s.delaunay, s.weights, s.laplacian, options.count);
  Divisor divisor = *singularities;
  for (Singularity& p : divisor) p.location = s.refinement->from_input(p.location);
  return options.repair_degree ? with_repaired_degree(s.delaunay, s.weights, divisor) : divisor;
}

std::vector<int> orders(const Divisor& divisor)
{
  std::vector<int> n;
  for (const Singularity& s : divisor) n.push_back(s.order);
  return n;
}

Lifted_divisor lifted(const Abel_jacobi_map& map, const Divisor& divisor)
{
  Lifted_divisor points;
  for (const Singularity& s : divisor) points.push_back(map.lift(s.location));
  return points;
}

// The image of the legal divisor: its residual is known on the sheet where it was legalized, the integers on sheet 0.
Abel_jacobi_image image_of(const Abel_jacobi_map& map, const Riemann_surface& s, const Legal_divisor& legal)
{
  const Eigen::VectorXd on_sheet_0 = map.residual(lifted(map, legal.divisor), orders(legal.divisor));
  const Eigen::VectorXd nearest = (on_sheet_0 / (0.5 * CGAL_PI)).array().round();
  return abel_jacobi_image(map, s.periods, s.zeros, on_sheet_0, nearest);
}

std::string scientific(double x)
{
  std::ostringstream out;
  out << std::scientific << x;
  return out.str();
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

Riemann_surface riemann_surface(const Intrinsic_triangulation& input, Visitor& visitor)
{
  Riemann_surface s;
  {
    const Timed_step step(visitor, "homology");
    s.homology = homology_basis(input);
  }
  {
    const Timed_step step(visitor, "refinement");
    s.delaunay = input;
    Common_refinement refinement(input);
    s.flips = make_delaunay(s.delaunay, s.homology.cochains, refinement);
    s.refinement.emplace(refinement, s.delaunay);
  }
  {
    const Timed_step step(visitor, "holomorphic_forms");
    s.weights = cotangent_weights(s.delaunay, s.delaunay.lengths());
    s.laplacian.factorize(s.delaunay, s.weights);
    s.forms = harmonic_1_forms(s.delaunay, s.homology.cochains, s.weights, s.laplacian);
  }
  {
    const Timed_step step(visitor, "period_matrix");
    s.periods = period_matrix(s.forms);
    if (input.genus() > 1)
      s.zeros = zeros_of_holomorphic_form(s.delaunay, s.forms, Eigen::VectorXd::Ones(s.forms.size()), s.periods.star);
  }
  return s;
}

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
    result.initial = starting_divisor(s, singularities, options);
  }
  {
    const Timed_step step(visitor, "legalization");
    result.legal = legalize_divisor(*map, s.periods, *result.initial, options.legalization, visitor);
    result.image = image_of(*map, s, *result.legal);
  }
  result.metric = exact_cone_metric(s.delaunay, s.homology.cochains, result.legal->divisor, options.cone_metric, visitor);
  place_singularities(input, result);
  require_reached(*result.metric);
  {
    const Timed_step step(visitor, "immersion");
    const Cone_metric& m = result.metric->metric;
    result.differential = immersion(m.triangulation, m.lengths, m.cones, m.order, input.area(), options.immersion,
                                    result.immersion);
    require_resolved_triangles(result.immersion);
  }
  if (!result.singularities.empty()) {
    const Timed_step step(visitor, "t_mesh");
    result.t_mesh = t_mesh(*result.differential, visitor);
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
