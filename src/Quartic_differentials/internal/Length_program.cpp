// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/Length_program.h>

#include <CGAL/Quartic_differentials/exceptions.h>

#include <glpk.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

const int chords_on_either_side = 4;

using Clock = std::chrono::steady_clock;

int milliseconds(double seconds)
{
  return static_cast<int>(std::clamp(1000 * seconds, 1.0, double(std::numeric_limits<int>::max())));
}

struct Search
{
  std::size_t nodes_left;
  int         nodes;
  double      bound;   // the best one known to the tree
};

void watch(glp_tree* tree, void* info)
{
  Search& search = *static_cast<Search*>(info);
  glp_ios_tree_size(tree, nullptr, nullptr, &search.nodes);
  const int node = glp_ios_best_node(tree);
  if (node != 0) search.bound = glp_ios_node_bound(tree, node);
  if (static_cast<std::size_t>(search.nodes) > search.nodes_left) glp_ios_terminate(tree);
}

std::vector<std::size_t> arcs_of(const std::vector<T_mesh::Side_piece>& side)
{
  std::vector<std::size_t> result;
  for (const T_mesh::Side_piece& piece : side) result.push_back(piece.arc);
  return result;
}

} // namespace

void Length_program::Delete::operator()(glp_prob* p) const { glp_delete_prob(p); }

Length_program::Length_program(const T_mesh& t, std::vector<double> x, int step)
  : m_t(t), m_x(std::move(x)), m_step(step), m_least(m_x.size(), 0)
{
  for (double length : m_x) {
    const int nearest = step * static_cast<int>(std::floor(length / step));
    m_window.push_back({std::max(0, nearest - chords_on_either_side * step), nearest + chords_on_either_side * step});
  }
}

void Length_program::raise(std::size_t arc, int least)
{
  m_least[arc] = least;
  if (m_problem) glp_set_col_bnds(m_problem.get(), static_cast<int>(arc) + 1, GLP_LO, least, 0);
}

void Length_program::add_cut(const std::vector<std::size_t>& arcs)
{
  m_cuts.push_back(arcs);
  if (m_problem) add_row(arcs, {}, glp_add_rows(m_problem.get(), 1), 1, false);
}

// of the chord of (q - x)^2 from a multiple of the step to the next one
double Length_program::slope(std::size_t arc, int from) const { return 2 * from + m_step - 2 * m_x[arc]; }

// Column a is q_a = low - below + (the chords' parts, each at most a step) + above: the dearer parts come last, since
// slopes increase.
void Length_program::build()
{
  m_problem.reset(glp_create_prob());
  glp_prob* p = m_problem.get();
  const int arcs = static_cast<int>(m_x.size()), patches = static_cast<int>(m_t.patches.size());
  glp_set_obj_dir(p, GLP_MIN);
  glp_add_cols(p, arcs);
  glp_add_rows(p, arcs + 2 * patches + static_cast<int>(m_cuts.size()));
  double constant = 0;
  for (int a = 0; a < arcs; ++a) {
    const Window& w = m_window[a];
    glp_set_col_bnds(p, a + 1, GLP_LO, m_least[a], 0);
    if (m_step == 1) glp_set_col_kind(p, a + 1, GLP_IV);
    std::vector<int> columns{0, a + 1};
    std::vector<double> coefficients{0, 1};
    add_chords(a, columns, coefficients);
    glp_set_row_bnds(p, a + 1, GLP_FX, w.low, w.low);
    glp_set_mat_row(p, a + 1, static_cast<int>(columns.size()) - 1, columns.data(), coefficients.data());
    constant += (w.low - m_x[a]) * (w.low - m_x[a]);
  }
  glp_set_obj_coef(p, 0, constant);
  int row = arcs;
  for (const T_mesh::Patch& patch : m_t.patches)
    for (int k = 0; k < 2; ++k) add_row(arcs_of(patch.sides[k]), arcs_of(patch.sides[k + 2]), ++row, 0, true);
  for (const auto& cut : m_cuts) add_row(cut, {}, ++row, 1, false);
  m_is_solved = false;
}

void Length_program::add_chords(int arc, std::vector<int>& columns, std::vector<double>& coefficients)
{
  glp_prob* p = m_problem.get();
  const Window& w = m_window[arc];
  const auto add = [&](double coefficient, double cost, double most) {
    const int column = glp_add_cols(p, 1);
    glp_set_col_bnds(p, column, most > 0 ? GLP_DB : GLP_LO, 0, most);
    glp_set_obj_coef(p, column, cost);
    columns.push_back(column);
    coefficients.push_back(coefficient);
  };
  if (w.low > 0) add(1, -slope(arc, w.low - m_step), w.low);
  for (int k = w.low; k < w.high; k += m_step) add(-1, slope(arc, k), m_step);
  add(-1, slope(arc, w.high), 0);
}

void Length_program::add_row(const std::vector<std::size_t>& plus, const std::vector<std::size_t>& minus, int row,
                             double least, bool is_equation)
{
  std::map<int, double> sum;
  for (std::size_t a : plus) ++sum[static_cast<int>(a) + 1];
  for (std::size_t a : minus) --sum[static_cast<int>(a) + 1];
  std::vector<int> columns{0};
  std::vector<double> coefficients{0};
  for (const auto& [column, coefficient] : sum) {
    if (coefficient == 0) continue;
    columns.push_back(column);
    coefficients.push_back(coefficient);
  }
  glp_set_row_bnds(m_problem.get(), row, is_equation ? GLP_FX : GLP_LO, least, least);
  glp_set_mat_row(m_problem.get(), row, static_cast<int>(columns.size()) - 1, columns.data(), coefficients.data());
}

// whether the time was enough
bool Length_program::solve_linear(double seconds, bool warm)
{
  ++m_solves;
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = warm ? GLP_DUALP : GLP_PRIMAL;   // what was added keeps the last basis dual feasible
  options.tm_lim = milliseconds(seconds);
  if (!warm) glp_std_basis(m_problem.get());
  const int failure = glp_simplex(m_problem.get(), &options);
  if (failure == GLP_ETMLIM) return false;
  if (failure != 0 || glp_get_status(m_problem.get()) != GLP_OPT) {
    if (warm) return solve_linear(seconds, false);
    throw Numerical_error("the linear program for the arcs' lengths in quads was not solved");
  }
  return true;
}

std::vector<int> Length_program::rounded(const std::vector<double>& value) const
{
  std::vector<int> q;
  for (double v : value) q.push_back(static_cast<int>(std::lround(v)));
  for (const T_mesh::Patch& patch : m_t.patches)
    for (int k = 0; k < 2; ++k) {
      long sum = 0;
      for (std::size_t a : arcs_of(patch.sides[k])) sum += q[a];
      for (std::size_t a : arcs_of(patch.sides[k + 2])) sum -= q[a];
      if (sum != 0) throw Numerical_error("the arcs' lengths in quads, rounded to integers, do not fit");
    }
  return q;
}

// whether a solution uses a last chord beyond its end
bool Length_program::widen_windows(const std::vector<int>& q)
{
  bool are_wider = false;
  for (std::size_t a = 0; a < q.size(); ++a) {
    Window& w = m_window[a];
    if (w.low <= q[a] && q[a] <= w.high + m_step) continue;
    w.low = std::min(w.low, std::max(0, q[a] - chords_on_either_side * m_step));
    w.high = std::max(w.high, q[a] + chords_on_either_side * m_step);
    are_wider = true;
  }
  return are_wider;
}

std::vector<double> Length_program::values(double (*value)(glp_prob*, int)) const
{
  std::vector<double> result;
  for (std::size_t a = 0; a < m_x.size(); ++a) result.push_back(value(m_problem.get(), static_cast<int>(a) + 1));
  return result;
}

// whether time and nodes were enough for a solution, if not for the best one
bool Length_program::branch_and_bound(double seconds, std::size_t& nodes, double& bound)
{
  if (nodes == 0) return false;
  ++m_solves;
  Search search{nodes, 0, bound};
  glp_iocp options;
  glp_init_iocp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.tm_lim = milliseconds(seconds);
  options.cb_func = watch;
  options.cb_info = &search;
  const int failure = glp_intopt(m_problem.get(), &options);
  const int status = glp_mip_status(m_problem.get());
  nodes -= std::min(nodes, static_cast<std::size_t>(search.nodes));
  bound = status == GLP_OPT ? glp_mip_obj_val(m_problem.get()) : search.bound;
  if (status == GLP_OPT || status == GLP_FEAS) return true;
  if (failure == GLP_ETMLIM || failure == GLP_ESTOP) return false;
  throw Numerical_error("the integer program for the arcs' lengths in quads was not solved");
}

std::optional<Length_program::Solution> Length_program::solve(double seconds, std::size_t& nodes)
{
  const auto begin = Clock::now();
  const auto left = [&] { return seconds - std::chrono::duration<double>(Clock::now() - begin).count(); };
  const auto is_fractional = [](double v) { return std::abs(v - std::round(v)) > 1e-6; };
  for (;;) {
    if (!m_problem) build();
    if (left() <= 0 || !solve_linear(left(), m_is_solved)) return std::nullopt;
    m_is_solved = true;
    double bound = glp_get_obj_val(m_problem.get());
    std::vector<double> value = values(glp_get_col_prim);
    if (m_step == 1 && std::any_of(value.begin(), value.end(), is_fractional)) {
      if (!branch_and_bound(left(), nodes, bound)) return std::nullopt;
      value = values(glp_mip_col_val);
    }
    Solution result{rounded(value), bound};
    if (!widen_windows(result.q)) return result;
    m_problem.reset();
  }
}

} } } // namespace CGAL::Quartic_differentials::internal
