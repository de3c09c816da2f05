// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/quantize.h>

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Length_program.h>
#include <CGAL/Quartic_differentials/internal/Quad_grid.h>
#include <CGAL/Quartic_differentials/internal/scientific.h>
#include <CGAL/Quartic_differentials/internal/zero_complex.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Length_program;
using internal::Quad_grid;
using internal::Separating_cut;
using internal::side_length;

const double promised_tolerance = 0.05;
const std::size_t most_scales = 12, most_scales_above = 4;   // the latter if all give too many quads

double squared(double x) { return x * x; }

// in squared grid units
double area(const T_mesh& t)
{
  double sum = 0;
  for (const T_mesh::Patch& patch : t.patches)
    sum += static_cast<double>(patch.width) * static_cast<double>(patch.height);
  return sum;
}

void refuse_what_has_no_quads(const T_mesh& t)
{
  if (t.patches.empty()) throw Infeasible_divisor_error("there is no T-mesh that could be cut into quads");
  for (std::size_t n = 0; n < t.nodes.size(); ++n)
    if (t.nodes[n].order <= -3)
      throw Infeasible_divisor_error("the singularity of node " + std::to_string(n) + " has order "
                                     + std::to_string(t.nodes[n].order) + ": it would be a vertex with a single quad,"
                                     " which no quad mesh has");
}

double scale_for_edge_length(const T_mesh& t, const Quantization_options& options)
{ return std::ldexp(options.surface_units_per_unit / options.edge_length, -t.grid_exponent); }

// the number of quads that is asked for
double number_wanted(const T_mesh& t, const Quantization_options& options)
{
  if (options.edge_length > 0) return std::round(squared(scale_for_edge_length(t, options)) * area(t));
  return double(options.number_of_quads);
}

// A run with this number takes 14 GB; and lengths of arcs must fit an int.
const double most_quads = 1e7;

void refuse_too_many(double quads)
{
  if (!(quads <= most_quads))
    throw Infeasible_divisor_error("the mesh would have about " + internal::scientific(quads) + " quads, more than "
                                   + internal::scientific(most_quads) + ": ask for fewer, or for longer sides");
}

std::string defect_of_sums(const T_mesh& t, const std::vector<int>& q)
{
  if (q.size() != t.arcs.size()) return "there is not one length for every arc";
  for (std::size_t a = 0; a < q.size(); ++a)
    if (q[a] < 0) return "arc " + std::to_string(a) + " has a negative length";
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    const auto& sides = t.patches[p].sides;
    if (side_length(sides[0], q) != side_length(sides[2], q) || side_length(sides[1], q) != side_length(sides[3], q))
      return "opposite sides of patch " + std::to_string(p) + " are not equal";
  }
  return {};
}

// \param grid that of t and q
std::string defect_of(const T_mesh& t, const std::vector<int>& q, const Quad_grid& grid)
{
  const std::string violation = defect_of_sums(t, q);
  return violation.empty() ? grid.defect(t) : violation;
}

class Quantizer
{
public:
  Quantizer(const T_mesh& t, const Quantization_options& options, Visitor& visitor)
    : m_t(t), m_options(options), m_visitor(visitor), m_block_size(block_size()) {}

  Quantization run()
  {
    Quantization result = m_options.edge_length > 0 ? for_edge_length() : for_number_of_quads();
    result.rounds = m_rounds;
    result.solves = m_solves;
    result.scales = m_scales;
    result.seconds = seconds();
    return result;
  }

private:
  using Clock = std::chrono::steady_clock;

  double target() const { return number_wanted(m_t, m_options); }

  int block_size() const
  {
    if (m_options.number_of_blocks == 0) return 1;
    return std::max(1, static_cast<int>(std::lround(std::sqrt(target() / double(m_options.number_of_blocks)))));
  }

  bool is_used_up() const { return m_nodes_left == 0 || seconds() >= m_options.time_limit; }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  static bool is_near(double number, double target, double tolerance)
  { return std::abs(number - target) <= tolerance * target; }

  Quantization for_edge_length()
  {
    Quantization result = at_scale(scale_for_edge_length(m_t, m_options));
    result.target = static_cast<std::size_t>(target());
    if (!is_near(double(result.number_of_quads), double(result.target), promised_tolerance))
      result.shortfall = "where singularities stay apart and patches are rectangles, the lengths nearest to the edge"
                         " length make " + std::to_string(result.number_of_quads) + " quads";
    return result;
  }

  // A scale that was tried, and the square root of the number of quads, which is nearly linear in it.
  struct Sample { double scale, root; };

  Quantization for_number_of_quads()
  {
    const double target = this->target();
    std::optional<Sample> below, above;   // the target
    Quantization best;
    double scale = std::sqrt(target / area(m_t));
    while (m_scales < most_scales && (m_scales == 0 || !is_used_up())) {
      Quantization q = at_scale(scale);
      const double number = double(q.number_of_quads);
      (number < target ? below : above) = Sample{scale, std::sqrt(number)};
      if (m_scales == 1 || std::abs(number - target) < std::abs(double(best.number_of_quads) - target))
        best = std::move(q);
      if (is_near(number, target, m_options.tolerance) || (!below && m_scales == most_scales_above)) break;
      scale = next_scale(below, above, std::sqrt(target));
    }
    best.target = m_options.number_of_quads;
    if (!is_near(double(best.number_of_quads), target, promised_tolerance)) best.shortfall = shortfall(!below);
    return best;
  }

  double next_scale(const std::optional<Sample>& below, const std::optional<Sample>& above, double target) const
  {
    if (!above) return below->scale * target / below->root;
    if (!below) return above->scale * std::max(target / above->root, 0.5);
    const double part = (target - below->root) / (above->root - below->root);
    return below->scale + std::clamp(part, 0.1, 0.9) * (above->scale - below->scale);
  }

  std::string shortfall(bool all_are_above) const
  {
    if (is_used_up()) return "the limit of work or time was reached before a nearer number was found";
    if (all_are_above) return "no coarser quads were found in which singularities stay apart";
    return "none of the " + std::to_string(m_scales) + " scales that were tried gave a nearer number";
  }

  // the first method that succeeds in its share of the time; lengths are in blocks until the end
  Quantization at_scale(double scale)
  {
    ++m_scales;
    std::vector<double> x;
    for (const T_mesh::Arc& arc : m_t.arcs) x.push_back(scale * static_cast<double>(arc.length) / m_block_size);
    std::optional<Quantization> result;
    if (m_options.method == Quantization_method::optimal)
      result = attempt(Quantization_method::optimal, x);
    if (!result && m_options.method != Quantization_method::even) result = attempt(Quantization_method::incumbent, x);
    if (!result) result = attempt(Quantization_method::even, x);
    result->scale = scale;
    m_visitor.progress("quantization: " + std::to_string(result->number_of_quads) + " quads at scale "
                       + std::to_string(m_scales) + ", " + std::to_string(result->cuts) + " cuts, "
                       + (result->optimal ? "optimal" : "optimality not proved"));
    return *std::move(result);
  }

  // solves, separates and solves again, until there is nothing to separate; nothing if its share of what is left of the
  // nodes, a quarter, or of the time is used up before
  std::optional<Quantization> attempt(Quantization_method method, const std::vector<double>& x)
  {
    std::size_t nodes = (m_nodes_left + 3) / 4;
    const double left = std::max(m_options.time_limit - seconds(), 0.0);
    const double deadline = method == Quantization_method::even ? no_deadline : seconds() + left / 4;
    const int step = method == Quantization_method::even ? 2 : 1;
    Length_program program(m_t, x, step);
    Quantization result;
    result.method = method;
    bool is_relaxation = step == 1;   // every quantization satisfies the program
    for (;;) {
      if (!m_visitor.go_further()) throw Cancelled_error("the quantization was cancelled");
      const std::size_t solves_before = program.solves(), nodes_before = nodes;
      const std::optional<Length_program::Solution> solution = program.solve(deadline - seconds(), nodes);
      m_solves += program.solves() - solves_before;
      m_nodes_left -= nodes_before - nodes;
      if (!solution) return std::nullopt;
      if (is_relaxation) result.lower_bound = std::max(result.lower_bound, solution->bound);
      result.length = solution->q;
      const std::vector<Separating_cut> cuts = internal::separating_cuts(m_t, result.length);
      ++m_rounds;
      for (const Separating_cut& cut : cuts) {
        const bool is_row = method == Quantization_method::optimal;
        if (is_row) program.add_cut(cut.arcs);
        else program.raise(most_shortened(cut.arcs, x, {}), step);
        is_relaxation = is_relaxation && is_row && cut.is_valid;
      }
      result.cuts += cuts.size();
      if (!cuts.empty()) continue;
      const Quad_grid grid(m_t, result.length);
      const std::vector<std::vector<std::size_t>> crowded = grid.crowded_arcs();
      if (crowded.empty()) return finished(std::move(result), grid, x);
      for (const auto& arcs : crowded) {
        const std::size_t a = most_shortened(arcs, x, result.length);
        program.raise(a, result.length[a] + step);
      }
      result.cuts += crowded.size();
      is_relaxation = false;
    }
  }

  // the arc that is furthest below the length it should have; without q, the longest one
  static std::size_t most_shortened(const std::vector<std::size_t>& arcs, const std::vector<double>& x,
                                    const std::vector<int>& q)
  {
    const auto missing = [&](std::size_t a) { return q.empty() ? x[a] : x[a] - q[a]; };
    return *std::max_element(arcs.begin(), arcs.end(),
                             [&](std::size_t a, std::size_t b) { return missing(a) < missing(b); });
  }

  Quantization finished(Quantization result, const Quad_grid& grid, const std::vector<double>& x) const
  {
    const std::string violation = defect_of(m_t, result.length, grid);
    if (!violation.empty()) throw Numerical_error("the quantization is not valid: " + violation);
    for (std::size_t a = 0; a < x.size(); ++a) result.cost += squared(result.length[a] - x[a]);
    const double rounding = 1e-6 * (1 + result.cost);
    result.optimal = result.cost <= result.lower_bound + rounding;
    return in_quads(std::move(result), grid.quads().size());
  }

  Quantization in_quads(Quantization result, std::size_t number_of_blocks) const
  {
    const int k = m_block_size;
    result.block_size = k;
    result.number_of_quads = number_of_blocks * static_cast<std::size_t>(k * k);
    result.cost *= k * k;
    result.lower_bound *= k * k;
    for (int& q : result.length) q *= k;
    return result;
  }

  static constexpr double no_deadline = 1e9;

  const T_mesh&               m_t;
  const Quantization_options& m_options;
  Visitor&                    m_visitor;
  const int                   m_block_size;
  const Clock::time_point     m_start = Clock::now();
  std::size_t                 m_nodes_left = m_options.node_limit;
  std::size_t                 m_rounds = 0, m_solves = 0, m_scales = 0;
};

} // namespace

const char* name(Quantization_method method)
{
  switch (method) {
    case Quantization_method::optimal:   return "optimal";
    case Quantization_method::incumbent: return "incumbent";
    default:                             return "even";
  }
}

Quantization quantize(const T_mesh& t, const Quantization_options& options, Visitor& visitor)
{
  refuse_what_has_no_quads(t);
  refuse_too_many(number_wanted(t, options));
  return Quantizer(t, options, visitor).run();
}

std::string quantization_defect(const T_mesh& t, const std::vector<int>& q)
{
  const std::string violation = defect_of_sums(t, q);
  return violation.empty() ? Quad_grid(t, q).defect(t) : violation;
}

} } // namespace CGAL::Quartic_differentials
