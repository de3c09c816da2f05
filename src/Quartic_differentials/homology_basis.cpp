// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/intersection_number.h>
#include <CGAL/Quartic_differentials/internal/integer_matrix.h>
#include <CGAL/Quartic_differentials/internal/tree_cotree.h>

#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Integer;
using Integer_vector = std::vector<Integer>;

Integer product(const Integer_vector& x, const Eigen::MatrixXi& j, const Integer_vector& y)
{
  Integer sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < y.size(); ++k)
      if (j(i, k) != 0 && x[i] != 0 && y[k] != 0) sum += x[i] * j(i, k) * y[k];
  return sum;
}

void subtract_multiple(Integer_vector& x, const Integer& q, const Integer_vector& y)
{
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= q * y[i];
}

// Removes from `rest` and returns an element with a . b = 1, by Euclid's algorithm on the values a . rest.
Integer_vector partner(const Integer_vector& a, const Eigen::MatrixXi& j, std::vector<Integer_vector>& rest)
{
  Integer_vector value;
  for (const Integer_vector& x : rest) value.push_back(product(a, j, x));
  for (;;) {
    std::size_t least = rest.size(), nonzero = 0;
    for (std::size_t k = 0; k < rest.size(); ++k)
      if (value[k] != 0) {
        ++nonzero;
        if (least == rest.size() || abs(value[k]) < abs(value[least])) least = k;
      }
    if (nonzero == 0) throw Numerical_error("the intersection form of the loops is degenerate");
    if (nonzero == 1) {
      if (abs(value[least]) != 1) throw Numerical_error("the intersection form of the loops is not unimodular");
      Integer_vector b = rest[least];
      for (Integer& x : b) x *= value[least];
      rest.erase(rest.begin() + least);
      return b;
    }
    for (std::size_t k = 0; k < rest.size(); ++k)
      if (k != least && value[k] != 0) {
        const Integer q = value[k] / value[least];
        subtract_multiple(rest[k], q, rest[least]);
        value[k] -= q * value[least];
      }
  }
}

// Integer symplectic Gram-Schmidt: rows a_1 .. a_g, b_1 .. b_g in terms of the loops.
internal::Big_integer_matrix canonical_combination(const Eigen::MatrixXi& j)
{
  const std::size_t n = j.rows();
  std::vector<Integer_vector> rest(n, Integer_vector(n, 0)), a_rows, b_rows;
  for (std::size_t k = 0; k < n; ++k) rest[k][k] = 1;
  while (!rest.empty()) {
    const Integer_vector a = rest.front();
    rest.erase(rest.begin());
    const Integer_vector b = partner(a, j, rest);
    for (Integer_vector& x : rest) {   // make x orthogonal to a and b
      const Integer xa = product(x, j, a), xb = product(x, j, b);
      subtract_multiple(x, xb, a);
      subtract_multiple(x, -xa, b);
    }
    a_rows.push_back(a);
    b_rows.push_back(b);
  }
  a_rows.insert(a_rows.end(), b_rows.begin(), b_rows.end());
  internal::Big_integer_matrix rows(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) rows(i, k) = a_rows[i][k];
  return rows;
}

} // namespace

Eigen::MatrixXi symplectic_unit(int genus)
{
  Eigen::MatrixXi j = Eigen::MatrixXi::Zero(2 * genus, 2 * genus);
  j.topRightCorner(genus, genus).setIdentity();
  j.bottomLeftCorner(genus, genus) = -Eigen::MatrixXi::Identity(genus, genus);
  return j;
}

Eigen::MatrixXi intersection_numbers(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                     const std::vector<std::vector<Halfedge>>& loops)
{
  Eigen::MatrixXi j = Eigen::MatrixXi::Zero(cochains.size(), loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (Halfedge h : edge_walk(t, {loops[l]})) j.col(l) += cochains.row(h).transpose();
  return j;
}

Eigen::MatrixXi intersection_numbers(const Intrinsic_triangulation& t, const Integer_cochains& cochains)
{
  const int n = cochains.size();
  Eigen::MatrixXi doubled = Eigen::MatrixXi::Zero(n, n);
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    const Eigen::RowVectorXi x = cochains.row(h[0]), y = cochains.row(h[1]);
    if (x.isZero() || y.isZero()) continue;
    doubled += x.transpose() * y - y.transpose() * x;
  }
  return doubled / 2;
}

Homology_basis homology_basis(const Intrinsic_triangulation& t)
{
  if (t.has_boundary())
    throw Unusable_surface_error("the surface has a boundary: its homology has no canonical basis of loops");
  const internal::Tree_cotree trees = internal::tree_cotree(t, t.lengths(), *t.vertices().begin());
  const int n = 2 * t.genus();
  CGAL_precondition(static_cast<int>(trees.generators.size()) == n);

  Homology_basis basis;
  Integer_cochains of_loops(t.number_of_edges(), n);
  for (int k = 0; k < n; ++k) {
    basis.loops.push_back(internal::dual_loop(t, trees, t.halfedge(trees.generators[k])));
    for (Halfedge h : basis.loops[k]) of_loops.add(h, k, 1);
  }
  const Eigen::MatrixXi j = intersection_numbers(t, of_loops, basis.loops);
  basis.combination = internal::narrowed(canonical_combination(j));
  basis.intersection_matrix = basis.combination * j * basis.combination.transpose();
  if (basis.intersection_matrix != symplectic_unit(n / 2))
    throw Numerical_error("the intersection form of the canonical basis is not the symplectic unit");

  basis.cochains = cochains_of_loops(basis, t.number_of_edges());
  return basis;
}

Integer_cochains cochains_of_loops(const Homology_basis& basis, std::size_t edges)
{
  const int n = static_cast<int>(basis.loops.size());
  Integer_cochains cochains(edges, n);
  for (int k = 0; k < n; ++k)
    for (Halfedge h : basis.loops[k])
      for (int l = 0; l < n; ++l) cochains.add(h, l, basis.combination(l, k));
  return cochains;
}

} } // namespace CGAL::Quartic_differentials
