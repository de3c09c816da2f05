// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output_report.h"

#include <CGAL/Quartic_differentials/internal/counted.h>

#include <algorithm>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

namespace {

Quads_report read_quads_report(const Json& json)
{
  Quads_report quads;
  quads.quads = integer(member(json, "quads"), 0, most_items, "quad_mesh.quads");
  quads.vertices = integer(member(json, "vertices"), 0, most_items, "quad_mesh.vertices");
  quads.patches = integer(member(json, "patches"), 0, most_items, "quad_mesh.patches");
  const Json& least = member(member(json, "scaled_jacobian"), "min");
  if (!least.is_number()) throw Malformed("quad_mesh.scaled_jacobian.min is not a number");
  quads.least_jacobian = least.get<double>();
  return quads;
}

// \return the order
std::int64_t read_corner(const Json& json)
{
  const std::int64_t order = integer(member(json, "order"), -1, most_items, "the order of a corner");
  if (integer(member(json, "quads"), 1, most_items, "the quads of a corner") != order + 2)
    throw Malformed("the number of quads at a corner is not its order + 2");
  return order;
}

} // namespace

Report read_report(const std::string& folder)
{
  const Json json = read_json(folder, "report.json");
  Report report;
  const Json& input = member(json, "input");
  report.genus = integer(member(input, "genus"), 0, most_items, "input.genus");
  if (input.contains("boundary")) report.boundary_curves = integer(input["boundary"], 0, most_items, "input.boundary");
  for (const Json& s : array(member(json, "singularities"), "singularities"))
    report.orders.push_back(integer(member(s, "order"), -3, most_items, "the order of a singularity"));
  if (!report.is_closed() || json.contains("corners"))
    for (const Json& c : array(member(json, "corners"), "corners")) report.corner_orders.push_back(read_corner(c));
  std::sort(report.orders.begin(), report.orders.end());
  std::sort(report.corner_orders.begin(), report.corner_orders.end());
  if (json.contains("quad_mesh")) report.quads = read_quads_report(json["quad_mesh"]);
  return report;
}

std::string euler_text(const Report& report) { return report.is_closed() ? "2-2g" : "2-2g-b"; }
std::string degree_text(const Report& report) { return report.is_closed() ? "8g-8" : "8g-8+4b"; }

std::string curves_text(std::size_t n)
{ return internal::counted(n, "boundary curve") + ", as in the report"; }

std::size_t number_of_curves(const Report& report) { return static_cast<std::size_t>(report.boundary_curves); }

} } } // namespace CGAL::Quartic_differentials::verification
