// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include <CGAL/Quartic_differentials/internal/counted.h>

#include <map>
#include <ostream>
#include <sstream>

using CGAL::Quartic_differentials::internal::counted;

namespace {

std::string number(double x, int digits = 3)
{
  std::ostringstream out;
  out.precision(digits);
  out << x;
  return out.str();
}

// "12 of valence 3, 20 of valence 5"
std::string valences(const Json& singularities)
{
  std::map<int, int> count;
  for (const Json& s : singularities) ++count[s["valence"].get<int>()];
  std::string text;
  for (const auto& [valence, n] : count)
    text += (text.empty() ? "" : ", ") + std::to_string(n) + " of valence " + std::to_string(valence);
  return text.empty() ? "none" : text;
}

// "4 with 1 quad, 1 with 3 quads"
std::string corners_text(const Json& corners)
{
  std::map<int, int> count;
  for (const Json& c : corners) ++count[c["quads"].get<int>()];
  std::string text;
  for (const auto& [quads, n] : count)
    text += (text.empty() ? "" : ", ") + std::to_string(n) + " with " + counted(quads, "quad");
  return text.empty() ? "none" : text;
}

void row(std::ostream& out, const std::string& what, const std::string& value)
{
  out << "  " << what << std::string(what.size() < 18 ? 18 - what.size() : 1, ' ') << value << '\n';
}

} // namespace

void print_summary(std::ostream& out, const Json& report)
{
  const Json& input = report["input"];
  const int curves = input["boundary"].get<int>();
  row(out, "surface", "genus " + std::to_string(input["genus"].get<int>()) + ", "
      + (curves == 0 ? "" : counted(curves, "boundary curve") + ", ")
      + std::to_string(input["vertices"].get<std::size_t>()) + " vertices, "
      + std::to_string(input["faces"].get<std::size_t>()) + " faces");
  for (const Json& note : input["notes"]) row(out, "note", note.get<std::string>());
  if (report.contains("period_matrix") && input["genus"] > 0)
    row(out, "period matrix", "symmetric, discretisation indicator " + number(report["period_matrix"]["star_defect"]));
  if (report.contains("abel_jacobi"))
    row(out, "Abel-Jacobi", "residual " + number(report["abel_jacobi"]["residual"]) + " rad after "
        + std::to_string(report["abel_jacobi"]["iterations"].get<int>()) + " Gauss-Newton steps");
  if (report.contains("singularities"))
    row(out, "singularities", std::to_string(report["singularities"].size()) + ": " + valences(report["singularities"]));
  if (report.contains("corners")) row(out, "corners", corners_text(report["corners"]));
  if (report.contains("distortion")) {
    const Json& d = report["distortion"];
    std::string text = number(d["distortion"]);
    if (d.contains("before_optimization") && !d.contains("search"))
      text += ", from " + number(d["before_optimization"]["distortion"]);
    text += " (mean square of the log scale of lengths)";
    row(out, "area distortion", text);
  }
  if (report.contains("flow")) {
    row(out, "flat metric", "curvature error " + number(report["flow"]["max_curvature_error"]) + " rad, "
        + std::to_string(report["flow"]["newton_iterations"].get<int>()) + " Newton steps; area scale varies by a factor of "
        + number(report["quality"]["area_scale_99_to_1_percent"]));
    row(out, "holonomy", "multiples of 90 degrees up to " + number(report["max_holonomy_error_radians"]) + " rad");
  }
  if (report.contains("precision") && report["precision"]["bits"] != 53) {
    const Json& p = report["precision"];
    row(out, "precision", std::to_string(p["bits"].get<int>()) + " bits: curvature error " + number(p["max_curvature_error"])
        + " rad");
    if (p.contains("reason")) row(out, "", "because " + p["reason"].get<std::string>());
  }
  if (report.contains("immersion") && report["immersion"]["flips"] == 0)
    row(out, "charts", "exact on a grid of 2^-" + std::to_string(report["immersion"]["grid_exponent"].get<int>())
        + ", no triangle flipped");
  if (report.contains("refinement"))
    row(out, "flat surface", std::to_string(report["refinement"]["faces"].get<std::size_t>())
        + " triangles in the input's faces, conformal distortion "
        + number(report["quality"]["conformal_distortion"]["mean"], 4) + " on average");
  if (report.contains("tmesh"))
    row(out, "T-mesh", std::to_string(report["tmesh"]["patches"].get<std::size_t>()) + " rectangles, "
        + std::to_string(report["tmesh"]["t_junctions"].get<int>()) + " T-junctions");
  else if (report["status"] == "done")
    row(out, "T-mesh", "none: it starts from singularities, and there is none");
  if (report.contains("quad_mesh")) {
    const Json& q = report["quad_mesh"];
    row(out, "quads", std::to_string(q["quads"].get<std::size_t>()) + ", scaled Jacobian at least "
        + number(q["scaled_jacobian"]["min"]) + ", " + number(q["scaled_jacobian"]["mean"]) + " on average");
    row(out, "", "angles " + number(q["angle_degrees"]["min"]) + " to " + number(q["angle_degrees"]["max"])
        + " degrees, sides of a quad up to 1 : " + number(q["edge_ratio"]["max"]));
    const Json& distance = q["distance_by_diagonal"];
    row(out, "", "distance to the surface at most " + number(distance["quads_to_input"]["max"])
        + " of its diagonal, of its vertices to the quads " + number(distance["input_vertices_to_quads"]["max"]));
    if (q.contains("splines"))
      row(out, "splines", std::to_string(q["splines"]["patches"].get<std::size_t>()) + " bicubic patches, distance to the "
          "surface at most " + number(q["splines"]["distance_by_diagonal"]["max"]) + " of its diagonal, rms "
          + number(q["splines"]["distance_by_diagonal"]["rms"]));
    if (q.contains("shortfall"))
      row(out, "", std::to_string(q["target"].get<std::size_t>()) + " were asked for, but "
          + q["shortfall"].get<std::string>());
  }
  if (!input["embedded"].get<bool>())
    row(out, "not written", "flat.obj, tmesh.vtp, loops.obj, singularities.txt: the surface has no positions in space");
  row(out, "time", number(report["timings"]["total"]) + " s, "
      + number(report["peak_memory_bytes"].get<double>() / (1 << 20)) + " MiB");
}
