// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include "distortion.h"

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/version.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <sstream>

using namespace CGAL::Quartic_differentials;

namespace {

Json rounded_integers(const Eigen::MatrixXi& m)
{
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) rows.push_back(std::vector<int>(m.row(i).begin(), m.row(i).end()));
  return rows;
}

Json reals(const Eigen::MatrixXd& m)
{
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) rows.push_back(std::vector<double>(m.row(i).begin(), m.row(i).end()));
  return rows;
}

Json point(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

Json input_report(const Run_facts& facts)
{
  const Intrinsic_triangulation& t = *facts.input;
  return {{"mesh", facts.mesh}, {"vertices", t.number_of_vertices()}, {"edges", t.number_of_edges()},
          {"faces", t.number_of_faces()}, {"genus", t.genus()}, {"boundary", t.number_of_boundary_curves()},
          {"area", t.area()}, {"embedded", t.is_embedded()}, {"notes", facts.notes}};
}

// the loops of the canonical basis, as vertices of the input one after the other
Json loops_report(const Intrinsic_triangulation& t, const Handle_tunnel_loops& loops)
{
  Json list = Json::array();
  for (int k = 0; k < static_cast<int>(loops.loops.size()); ++k) {
    const Edge_loop& loop = loops.loops[k];
    std::vector<std::size_t> vertices;
    for (Halfedge h : loop.walk) vertices.push_back(t.source(h).idx());
    Json entry = {{"name", loop_name(k, t.genus())}};
    if (loops.classes.found) entry["kind"] = loop_kind(loops, k);
    entry.update({{"length", loop.length}, {"simple", loop.simple}, {"vertices", vertices}});
    list.push_back(entry);
  }
  return list;
}

Json homology_report(const Intrinsic_triangulation& t, const Riemann_surface& s)
{
  Json report = {{"delaunay_flips", s.flips}};
  if (!t.has_boundary()) report["intersection_matrix"] = rounded_integers(s.homology.intersection_matrix);
  if (!s.loops) return report;
  report["handles_and_tunnels"] = {{"found", s.loops->classes.found}, {"certified", s.loops->classes.certified}};
  if (!s.loops->classes.certified) report["handles_and_tunnels"]["reason"] = s.loops->classes.reason;
  report["loops"] = loops_report(t, *s.loops);
  return report;
}

Json versions()
{
  return {{"quartic", QUARTIC_VERSION}, {"cgal", CGAL_VERSION_STR},
          {"eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "."
                    + std::to_string(EIGEN_MINOR_VERSION)},
          {"factorisation", Symmetric_factorization::name()}, {"compiler", __VERSION__}};
}

std::size_t peak_memory_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

// the turning of a loop that is off a multiple of 90 degrees by `error`
Json holonomy_of(const std::string& loop, double radians, double error)
{
  const long multiple = std::lround((radians - error) / (CGAL_PI / 2));
  const double error_degrees = error * 180 / CGAL_PI;
  return {{"loop", loop}, {"degrees", 90.0 * static_cast<double>(multiple) + error_degrees}, {"multiple_of_90", multiple},
          {"error_degrees", error_degrees}};
}

// the turning of a loop modulo 360 degrees, from -135 to 225: multiples of 90 are then -1, 0, 1, 2 whatever the rounding
double reduced_turning(double radians)
{
  const double reduced = std::remainder(radians, 2 * CGAL_PI);
  return reduced < -0.75 * CGAL_PI ? reduced + 2 * CGAL_PI : reduced;
}

// the name of a path of the basis: on surfaces with boundary there are loops and arcs
std::string path_name(const Intrinsic_triangulation& t, int k)
{
  const int loops = 2 * t.genus();
  if (!t.has_boundary()) return loop_name(k, loops / 2);
  return k < loops ? "loop " + std::to_string(k + 1) : "arc " + std::to_string(k - loops + 1);
}

// the paper's table 2: the rotation along every basis loop and round every singularity, and the angle of every corner, of
// the metric that was laid out, or, if the run did not come so far, of step 6
Json holonomy_report(const Exact_cone_metric& m, const std::optional<Precision_report>& precision)
{
  Json table = Json::array();
  const Intrinsic_triangulation& t = m.metric.triangulation;
  for (int k = 0; k < static_cast<int>(m.turning.size()); ++k) {
    const double error = precision ? precision->turning_error[k] : quarter_turn_defect(m.turning[k]);
    table.push_back(holonomy_of(path_name(t, k), reduced_turning(m.turning[k]), error));
  }
  const std::vector<double> curvature = curvatures(t, m.metric.angles);
  int singularities = 0, corners = 0;
  for (Vertex v : m.metric.cones) {
    const double angle = (t.is_border(v) ? CGAL_PI : 2 * CGAL_PI) - curvature[v];
    const double error = precision ? -precision->curvature_error[v] : quarter_turn_defect(angle);
    const std::string name = t.is_border(v) ? "corner " + std::to_string(++corners)
                                            : "singularity " + std::to_string(++singularities);
    table.push_back(holonomy_of(name, angle, error));
  }
  return table;
}

Json precision_report(const Precision_report& p)
{
  Json report = {{"bits", p.bits}, {"max_curvature_error", p.max_curvature_error},
                 {"max_holonomy_error_radians", p.max_holonomy_error},
                 {"max_transition_error_radians", p.max_transition_error}, {"history", p.history}};
  if (!p.reason.empty()) report["reason"] = p.reason;
  return report;
}

Json abel_jacobi_report(const Quartic_differential_result& r)
{
  Json report = {{"residual", r.legal->residual.norm()}, {"iterations", r.legal->history.size() - 1},
                 {"history", r.legal->history}, {"lattice_vectors_tried", r.legal->tried},
                 {"closest_vector_certified", r.legal->certified}};
  if (!r.image) return report;
  Json image = Json::array();
  for (Eigen::Index k = 0; k < r.image->image.size(); ++k)
    image.push_back({{"re", r.image->image[k].real()}, {"im", r.image->image[k].imag()}});
  report.update({{"integers", {{"s", r.image->s}, {"t", r.image->t}}}, {"image", image}});
  return report;
}

// E of the linearised flat metric and its area scale, from the first choice to the legal divisor
Json distortion_report(const Quartic_differential_result& r)
{
  Json report;
  if (r.choice) {
    const Chosen_singularities& c = *r.choice;
    Json starts = Json::array();
    for (const Start_of_search& s : c.starts)
      starts.push_back({{"from", s.name}, {"count", s.count}, {"distortion", s.distortion},
                        {"area_scale_99_to_1_percent", s.area_scale_ratio}});
    report["starts"] = starts;
    report["search"] = {{"vertices", c.searched_vertices}, {"count", c.divisor.size()}, {"distortion", c.distortion},
                        {"solves", c.solves}};
    if (!c.pareto.empty()) {
      Json curve = Json::array();
      for (const Pareto_point& p : c.pareto)
        curve.push_back({{"count", p.count}, {"distortion", p.distortion}, {"area_scale_99_to_1_percent", p.area_scale_ratio}});
      report["pareto"] = curve;
    }
  }
  if (r.optimal) {
    Json history = Json::array();
    for (const Distortion_step& s : r.optimal->history) history.push_back(s.distortion);
    report["before_optimization"] = {{"distortion", r.optimal->history.front().distortion},
                                     {"area_scale_99_to_1_percent", r.optimal->area_scale_before}};
    report["after_optimization"] = {{"distortion", r.distortion},
                                    {"area_scale_99_to_1_percent", r.optimal->area_scale_after}};
    report["history"] = history;
  }
  report["distortion"] = r.distortion;
  report["solves"] = r.solves;
  return report;
}

// those inside, or the corners of the boundary
Json singularities_report(const Run_facts& facts, const Quartic_differential_result& r, bool on_boundary)
{
  Json list = Json::array();
  for (std::size_t i = 0; i < r.singularities.size(); ++i) {
    const Singularity& s = r.singularities[i];
    if (s.on_boundary != on_boundary) continue;
    Json entry = {{"order", s.order}, {on_boundary ? "quads" : "valence", s.order + (on_boundary ? 2 : 4)},
                  {"pinned", s.pinned}, {"face", s.location.face.idx()}, {"barycentric", s.location.barycentric}};
    if (facts.input->is_embedded()) entry["position"] = point(position_on_input(*facts.input, s.location));
    if (facts.input->is_embedded())
      entry["started_at"] = point(position_on_input(*facts.input, r.surface->refinement->to_input((*r.initial)[i].location)));
    entry["moved_by"] = r.legal->moved_by[i] + r.metric->moved_by[i];
    list.push_back(entry);
  }
  return list;
}

Json flow_report(const Exact_cone_metric& m)
{
  return {{"newton_iterations", m.first_flow.newton_iterations},
          {"polishing_steps", m.first_flow.polishing_steps}, {"flips", m.first_flow.flips},
          {"max_curvature_error", m.metric.flow.max_curvature_error}, {"tolerance", m.metric.flow.tolerance},
          {"history", m.first_flow.history}, {"holonomy_iterations", m.history.size() - 1},
          {"holonomy_history", m.history}};
}

Json t_mesh_report(const T_mesh& t)
{
  std::map<T_mesh::Node_kind, int> count;
  for (const T_mesh::Node& n : t.nodes) ++count[n.kind];
  Json report = {{"grid_exponent", t.grid_exponent}, {"nodes", t.nodes.size()}, {"arcs", t.arcs.size()},
                 {"patches", t.patches.size()}, {"singularities", count[T_mesh::Node_kind::singularity]},
                 {"t_junctions", count[T_mesh::Node_kind::t_junction]}, {"crossings", count[T_mesh::Node_kind::crossing]},
                 {"meetings", count[T_mesh::Node_kind::meeting]}};
  if (count[T_mesh::Node_kind::corner] > 0) report["corners"] = count[T_mesh::Node_kind::corner];
  return report;
}

// over the triangles of the subdivided input
Json conformal_report(const Quartic_differential& q)
{
  const Area_samples d = conformal_distortion(q);
  return {{"mean", d.mean()}, {"95_percent", weighted_quantile(d.value, d.area, 0.95)}, {"max", d.value.maxCoeff()},
          {"share_of_area_above_10", (d.value.array() > 10).select(d.area.array(), 0).sum() / d.area.sum()}};
}

// Area scale e^2u over the input's vertices; conformal distortion where there are positions in space.
Json quality_report(const Run_facts& facts, const Quartic_differential_result& r)
{
  const Area_samples u = log_scale(*facts.input, r.metric->metric.u);
  Json quality = {{"area_scale_99_to_1_percent", area_scale_ratio(u.value, u.area)},
                  {"area_distortion", (u.value.array() - u.mean()).square().matrix().dot(u.area) / u.area.sum()}};
  if (r.refined) quality["conformal_distortion"] = conformal_report(r.refined->differential);
  return quality;
}

Json distance_report(const Surface_distance& d) { return {{"max", d.most}, {"rms", d.rms}}; }

Json splines_report(const Quads& quads)
{
  const Multipatch_quality& q = *quads.splines_quality;
  return {{"patches", quads.splines->patches.size()}, {"interfaces", quads.splines->interfaces.size()}, {"degree", 3},
          {"spans_by_patch_side", quads.quantization.block_size},
          {"distance_by_diagonal", distance_report(q.distance)},
          {"sine_of_angle", {{"min", q.least_sine}, {"mean", q.mean_sine}}}};
}

Json by_number(const std::map<std::size_t, std::size_t>& counts)
{
  Json report = Json::object();
  for (const auto& [number, count] : counts) report[std::to_string(number)] = count;
  return report;
}

Json quads_report(const Quads& quads)
{
  const Quantization& q = quads.quantization;
  const Quad_quality& quality = quads.quality;
  Json report = {{"target", q.target}, {"quads", quads.mesh.quads.size()}, {"vertices", quads.mesh.points.size()},
                 {"patches", quality.patches}, {"irregular_vertices", by_number(quality.irregular_vertices)},
                 {"scaled_jacobian", {{"min", quality.scaled_jacobian.least}, {"mean", quality.scaled_jacobian.mean}}},
                 {"angle_degrees", {{"min", quality.angle.least}, {"max", quality.angle.most},
                                    {"mean_deviation_from_90", quality.angle_deviation}}},
                 {"edge_ratio", {{"mean", quality.edge_ratio.mean}, {"max", quality.edge_ratio.most}}},
                 {"edge_length", {{"min", quality.edge_length.least}, {"mean", quality.edge_length.mean},
                                  {"max", quality.edge_length.most}}},
                 {"distance_by_diagonal", {{"quads_to_input", distance_report(quality.to_input)},
                                           {"input_vertices_to_quads", distance_report(quality.from_input)}}},
                 {"quantization", {{"method", name(q.method)}, {"optimal", q.optimal}, {"cost", q.cost},
                                   {"lower_bound", q.lower_bound}, {"scale", q.scale}, {"block_size", q.block_size},
                                   {"cuts", q.cuts}, {"programs_solved", q.solves}, {"seconds", q.seconds}}}};
  if (!quality.corners.empty()) report["corners"] = by_number(quality.corners);
  if (!q.shortfall.empty()) report["shortfall"] = q.shortfall;
  if (const Smoothing_report& s = quads.smoothing; !s.history.empty())
    report["smoothing"] = {{"sweeps", s.history.size() - 1}, {"seconds", s.seconds},
                           {"before", {{"min", s.history.front().least}, {"mean", s.history.front().mean}}}};
  if (quads.splines) report["splines"] = splines_report(quads);
  return report;
}

// the paper's table 1
Json timings_report(const Run_facts& facts, const Quartic_differential_result& r)
{
  Json seconds;
  for (const char* key : {"read", "homology", "holomorphic_forms", "period_matrix", "abel_jacobi", "legalization",
                          "cone_metric", "holonomy", "immersion", "refinement", "t_mesh", "quad_mesh", "write"})
    seconds[key] = 0.0;
  double total = 0;
  for (const auto* timings : {&facts.timings, &r.timings})
    for (const auto& [key, s] : *timings) {
      seconds[key] = seconds[key].get<double>() + s;
      total += s;
    }
  seconds["total"] = total;
  return seconds;
}

} // namespace

Json surface_report(const Run_facts& facts, const Riemann_surface* s)
{
  Json report = {{"input", input_report(facts)}};
  if (s == nullptr) return report;
  Json zeros = Json::array();
  for (const Holomorphic_zero& z : s->zeros) {
    Json zero = {{"order", z.order}};
    if (facts.input->is_embedded())
      zero["position"] = point(position_on_input(*facts.input, s->refinement->to_input(z.location)));
    zeros.push_back(zero);
  }
  report["homology"] = homology_report(*facts.input, *s);
  report["holomorphic_forms"] = {{"residual", s->forms.residual}, {"zeros", zeros}};
  if (facts.input->has_boundary()) return report;
  report["period_matrix"] = {{"re", reals(s->periods.pi.real())}, {"im", reals(s->periods.pi.imag())},
                             {"star_defect", s->periods.star_defect},
                             {"dirichlet_lower", reals(s->periods.lower)}, {"dirichlet_upper", reals(s->periods.upper)}};
  return report;
}

Json run_report(const Run_facts& facts, const Quartic_differential_result& r)
{
  Json report = {{"status", facts.failure.empty() ? "done" : "failed"}};
  if (!facts.failure.empty()) report["failure"] = facts.failure;
  report.update(surface_report(facts, r.surface ? &*r.surface : nullptr));
  if (r.legal) report["abel_jacobi"] = abel_jacobi_report(r);
  if (r.legal) report["distortion"] = distortion_report(r);
  if (r.metric) {
    report["singularities"] = singularities_report(facts, r, false);
    if (facts.input->has_boundary()) report["corners"] = singularities_report(facts, r, true);
    report["flow"] = flow_report(*r.metric);
    report["holonomy"] = holonomy_report(*r.metric, r.precision);
    report["max_holonomy_error_radians"] = r.precision
      ? std::max(r.precision->max_holonomy_error, r.precision->max_transition_error)
      : std::max(r.metric->max_holonomy_error, r.metric->max_transition_error);
    report["quality"] = quality_report(facts, r);
  }
  if (r.precision) report["precision"] = precision_report(*r.precision);
  if (r.immersion.grid_exponent != 0) {
    report["immersion"] = {{"grid_exponent", r.immersion.grid_exponent},
                           {"surface_units_per_unit", r.differential ? r.differential->surface_units_per_unit : 0},
                           {"flips", r.immersion.flipped_triangles}, {"min_altitude", r.immersion.min_altitude},
                           {"cut_edges", r.immersion.cut_edges}, {"segments", r.immersion.segments},
                           {"rotation_error_radians", r.immersion.rotation_error},
                           {"largest_move", r.immersion.largest_move}};
  }
  if (r.refined) {
    const Intrinsic_triangulation& t = r.refined->differential.triangulation;
    report["refinement"] = {{"vertices", t.number_of_vertices()}, {"faces", t.number_of_faces()},
                            {"faces_by_input_face", static_cast<double>(t.number_of_faces())
                                                    / static_cast<double>(facts.input->number_of_faces())},
                            {"flips", r.refined->flipped_triangles},
                            {"max_curvature_error", r.refined_metric->precision.max_curvature_error}};
  }
  if (r.t_mesh) report["tmesh"] = t_mesh_report(*r.t_mesh);
  if (r.quads) report["quad_mesh"] = quads_report(*r.quads);

  report["timings"] = timings_report(facts, r);
  report["peak_memory_bytes"] = peak_memory_bytes();
  report["versions"] = versions();
  return report;
}
