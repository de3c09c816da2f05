// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LENGTH_PROGRAM_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LENGTH_PROGRAM_H

#include <CGAL/Quartic_differentials/t_mesh.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

struct glp_prob;

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The least sum of (q - x)^2 over the arcs of a T-mesh, for integers q >= 0 such that opposite sides of every patch
/// have equal sums; with lower bounds and cuts.
///
/// The square is replaced by its chords between multiples of a step; chords are added near the solution until it lies
/// among them. With step 1 that changes nothing for integers, and the program is an integer one. With step 2 it is a
/// linear one: half of it is a bidirected flow with integer bounds and breakpoints, its vertices are half-integral, and
/// so those of the whole are integers.
class Length_program
{
public:
  struct Solution
  {
    std::vector<int> q;
    double           bound;   ///< of the sum, for every solution
  };

  /// \pre `step` is 1 or 2, all x are finite and not negative
  Length_program(const T_mesh& t, std::vector<double> x, int step);

  /// q of an arc must not be less. \pre `least` is a multiple of the step, not less than the bound before
  void raise(std::size_t arc, int least);
  /// the q of these arcs must sum to 1 at least. \pre the step is 1
  void add_cut(const std::vector<std::size_t>& arcs);

  /// \param nodes of search trees that may be made; is reduced by those that were
  /// \return nothing if the time or the nodes are used up before there is a solution; the best one if there is
  /// \throws Numerical_error if the linear program has no solution, or one that is none after rounding
  std::optional<Solution> solve(double seconds, std::size_t& nodes);

  /// linear and integer programs solved so far
  std::size_t solves() const { return m_solves; }

private:
  struct Window { int low, high; };   // the chords between them are there
  struct Delete { void operator()(glp_prob* p) const; };

  void build();
  void add_chords(int arc, std::vector<int>& columns, std::vector<double>& coefficients);
  void add_row(const std::vector<std::size_t>& plus, const std::vector<std::size_t>& minus, int row, double least,
               bool is_equation);
  double slope(std::size_t arc, int from) const;
  bool solve_linear(double seconds, bool warm);
  bool branch_and_bound(double seconds, std::size_t& nodes, double& bound);
  std::vector<double> values(double (*value)(glp_prob*, int)) const;
  bool widen_windows(const std::vector<int>& q);
  std::vector<int> rounded(const std::vector<double>& value) const;

  const T_mesh&                         m_t;
  std::vector<double>                   m_x;
  int                                   m_step;
  std::vector<int>                      m_least;    // by arc
  std::vector<Window>                   m_window;   // by arc
  std::vector<std::vector<std::size_t>> m_cuts;
  std::unique_ptr<glp_prob, Delete>     m_problem;  // built when it is solved first, or windows are wider
  bool                                  m_is_solved = false;   // so that its basis is a start for the next time
  std::size_t                           m_solves = 0;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LENGTH_PROGRAM_H
