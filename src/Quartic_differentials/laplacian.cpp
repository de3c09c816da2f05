// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include "internal/Sparse_cholesky.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Sparse_matrix = Eigen::SparseMatrix<double>;

bool same_pattern(const Sparse_matrix& a, const Sparse_matrix& b)
{
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros()
      && std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr())
      && std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

struct Entry
{
  int    row;
  double value;
};

// The square matrix of which column k has the entries first[k] .. first[k+1]-1; those of one row are summed up.
Sparse_matrix compressed(const std::vector<int>& first, std::vector<Entry>& entries)
{
  const int n = static_cast<int>(first.size()) - 1;
  Sparse_matrix m(n, n);
  m.reserve(static_cast<Eigen::Index>(entries.size()));
  for (int column = 0; column < n; ++column) {
    const auto begin = entries.begin() + first[column], end = entries.begin() + first[column + 1];
    std::sort(begin, end, [](const Entry& a, const Entry& b) { return a.row < b.row; });
    m.startVec(column);
    for (auto entry = begin; entry != end; ) {
      double& sum = m.insertBack(entry->row, column) = 0;
      for (const int row = entry->row; entry != end && entry->row == row; ++entry) sum += entry->value;
    }
  }
  m.finalize();
  return m;
}

// Lower triangle of the Laplacian plus a diagonal, without the rows and columns of the first `grounded` vertices.
Sparse_matrix lower_laplacian(const Intrinsic_triangulation& t, const std::vector<double>& weights,
                              std::vector<double> diagonal, int grounded)
{
  const int n = static_cast<int>(t.number_of_vertices()) - grounded;
  const auto ends = [&](Edge e) {   // as row and column, which are negative where a vertex is grounded
    const int i = static_cast<int>(t.source(t.halfedge(e)).idx()), j = static_cast<int>(t.target(t.halfedge(e)).idx());
    return std::make_pair(std::max(i, j) - grounded, std::min(i, j) - grounded);
  };
  std::vector<int> first(n + 1, 1);     // by column; one place for the diagonal
  for (Edge e : t.edges())
    if (const auto [row, column] = ends(e); row != column && column >= 0) ++first[column];
  std::exclusive_scan(first.begin(), first.end(), first.begin(), 0);

  std::vector<Entry> entries(first[n]);
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int v = 0; v < n; ++v) entries[next[v]++] = {v, 0};
  for (Edge e : t.edges()) {
    const auto [row, column] = ends(e);
    if (row == column) continue;   // a loop edge has no part in the energy of a function of vertices
    diagonal[row + grounded] += weights[e];
    diagonal[column + grounded] += weights[e];
    if (column >= 0) entries[next[column]++] = {row, -weights[e]};
  }
  for (int v = 0; v < n; ++v) entries[first[v]].value = diagonal[v + grounded];
  return compressed(first, entries);
}

} // namespace

std::vector<double> cotangent_weights(const Intrinsic_triangulation& t, const std::vector<double>& lengths)
{
  std::vector<double> weights(t.number_of_edges(), 0.0);
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    const double a = lengths[t.edge(h[0])], b = lengths[t.edge(h[1])], c = lengths[t.edge(h[2])];
    const double area4 = std::max(four_times_area(a, b, c), std::numeric_limits<double>::min());
    weights[t.edge(h[0])] += 0.5 * twice_scalar_product(a, b, c) / area4;
    weights[t.edge(h[1])] += 0.5 * twice_scalar_product(b, c, a) / area4;
    weights[t.edge(h[2])] += 0.5 * twice_scalar_product(c, a, b) / area4;
  }
  return weights;
}

std::vector<double> vertex_areas(const Intrinsic_triangulation& t)
{
  std::vector<double> area(t.number_of_vertices(), 0.0);
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    const double third = four_times_area(t.length(h[0]), t.length(h[1]), t.length(h[2])) / 12;
    for (Halfedge k : h) area[t.source(k)] += third;
  }
  return area;
}

struct Symmetric_factorization::Implementation
{
  internal::Sparse_cholesky    solver;
  Sparse_matrix                factorized;   // lower triangle, empty before the first factorisation
  std::optional<Sparse_matrix> near;         // the matrix to solve for, where it is another one than that

  void factorize(const Sparse_matrix& lower)
  {
    if (!same_pattern(factorized, lower)) solver.analyze(lower);
    factorized = lower;
    near.reset();
    if (!solver.factorize(factorized))
      throw Numerical_error("a Laplacian could not be factorised: the triangulation is numerically degenerate");
  }

  // Solves for the near matrix by conjugate gradients with the factorisation as preconditioner (Golub and Van Loan, Matrix
  // Computations, section 11.5): whether the residual is small enough after few iterations.
  bool solve_iteratively(const Eigen::MatrixXd& b, double relative_residual, Eigen::MatrixXd& x) const
  {
    const int most = 12;
    x = Eigen::MatrixXd::Zero(b.rows(), b.cols());
    Eigen::VectorXd r, z, p, ap;
    for (Eigen::Index column = 0; column < b.cols(); ++column) {
      r = b.col(column);
      p.setZero(b.rows());
      const double enough = relative_residual * r.cwiseAbs().maxCoeff();
      double previous = 1;
      for (int k = 0; r.cwiseAbs().maxCoeff() > enough; ++k) {
        if (k == most) return false;
        z = solver.solve(r);
        const double rz = r.dot(z);
        p = z + (rz / previous) * p;
        previous = rz;
        ap.noalias() = near->selfadjointView<Eigen::Lower>() * p;
        const double alpha = rz / p.dot(ap);
        x.col(column) += alpha * p;
        r -= alpha * ap;
      }
    }
    return true;
  }
};

Symmetric_factorization::Symmetric_factorization() : m_implementation(std::make_unique<Implementation>()) {}
Symmetric_factorization::~Symmetric_factorization() = default;
Symmetric_factorization::Symmetric_factorization(Symmetric_factorization&&) noexcept = default;
Symmetric_factorization& Symmetric_factorization::operator=(Symmetric_factorization&&) noexcept = default;

void Symmetric_factorization::factorize(const Sparse_matrix& lower)
{
  if (lower.rows() == 0) return;   // of a surface with one vertex: there is nothing to solve for
  m_implementation->factorize(lower);
}

void Symmetric_factorization::update(const Sparse_matrix& lower)
{
  if (lower.rows() != m_implementation->factorized.rows()) return factorize(lower);
  m_implementation->near = lower;
}

Eigen::MatrixXd Symmetric_factorization::solve(const Eigen::MatrixXd& right_hand_sides, double relative_residual) const
{
  if (right_hand_sides.size() == 0) return right_hand_sides;
  Implementation& s = *m_implementation;
  if (right_hand_sides.rows() != s.factorized.rows())
    throw Numerical_error("no matrix of " + std::to_string(right_hand_sides.rows()) + " rows was factorised");
  Eigen::MatrixXd x;
  if (s.near && !s.solve_iteratively(right_hand_sides, relative_residual, x)) s.factorize(Sparse_matrix(*s.near));
  if (!s.near) x = s.solver.solve(right_hand_sides);
  if (!x.allFinite()) throw Numerical_error("a linear system has no finite solution: the triangulation is degenerate");
  return x;
}

void Symmetric_factorization::set_order_of(const Symmetric_factorization& similar)
{
  m_implementation->solver.set_order(similar.m_implementation->solver.order());
}

const char* Symmetric_factorization::name() { return internal::Sparse_cholesky::name(); }

void Laplacian_solver::factorize(const Intrinsic_triangulation& t, const std::vector<double>& weights)
{
  m_factorization.factorize(lower_laplacian(t, weights, std::vector<double>(t.number_of_vertices(), 0.0), 1));
}

void Laplacian_solver::update(const Intrinsic_triangulation& t, const std::vector<double>& weights)
{
  m_factorization.update(lower_laplacian(t, weights, std::vector<double>(t.number_of_vertices(), 0.0), 1));
}

void Laplacian_solver::set_order_of(const Laplacian_solver& similar)
{
  m_factorization.set_order_of(similar.m_factorization);
}

Eigen::MatrixXd Laplacian_solver::solve(const Eigen::MatrixXd& b, double relative_residual) const
{
  if (b.cols() == 0) return b;   // has no memory whose rows one could take
  Eigen::MatrixXd x(b.rows(), b.cols());
  x.row(0).setZero();
  x.bottomRows(b.rows() - 1) = m_factorization.solve(b.bottomRows(b.rows() - 1), relative_residual);
  return x;
}

Eigen::VectorXd heat_smoothed(const Intrinsic_triangulation& t, const std::vector<double>& weights, double time,
                              const Eigen::VectorXd& b)
{
  std::vector<double> scaled(weights);
  for (double& w : scaled) w *= time;
  Symmetric_factorization heat;
  heat.factorize(lower_laplacian(t, scaled, vertex_areas(t), 0));
  return heat.solve(b);
}

} } // namespace CGAL::Quartic_differentials
