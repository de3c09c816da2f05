// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTEGER_COCHAINS_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTEGER_COCHAINS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <Eigen/Core>

namespace CGAL {
namespace Quartic_differentials {

/// Closed integer 1-forms eta_1 .. eta_n: eta_k(h) counts the crossings of a loop gamma_k of the dual graph with the
/// halfedge h, +1 where the loop leaves the face of h through h, and eta_k(opposite h) = -eta_k(h). On a surface with
/// boundary gamma_k may be an arc, which comes in through a border halfedge and goes out through a boundary edge.
/// They ride along flips and insertions, so that no loop is ever re-routed. (METHOD, step 1)
class Integer_cochains
{
public:
  using Row_matrix = Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Integer_cochains() = default;
  Integer_cochains(std::size_t edges, int size) : m_value(Row_matrix::Zero(edges, size)) {}

  int size() const { return static_cast<int>(m_value.cols()); }
  int operator()(Halfedge h, int k) const { return sign(h) * m_value(h.idx() / 2, k); }
  void add(Halfedge h, int k, int n) { m_value(h.idx() / 2, k) += sign(h) * n; }
  /// all n values on h
  Eigen::RowVectorXi row(Halfedge h) const { return sign(h) * m_value.row(h.idx() / 2); }
  /// by edge, on its halfedge(e)
  const Row_matrix& values() const { return m_value; }

  /// closedness on the new face (kl, lj, jk)
  void before_flip(const Intrinsic_triangulation&, const Edge_flip& f)
  { set_row(f.ij, -(row(f.lj) + row(f.jk))); }

  /// extends the forms to the spokes of a new vertex p: 0 on p v0
  void after_insertion(const Intrinsic_triangulation& t, const Intrinsic_triangulation::Insertion& i)
  {
    m_value.conservativeResize(t.number_of_edges(), Eigen::NoChange);
    set_row(i.spoke[0], Eigen::RowVectorXi::Zero(size()));
    set_row(i.spoke[1], row(i.rim[0]));
    set_row(i.spoke[2], -row(i.rim[2]));
  }

  /// extends the forms to the halves of a boundary edge v0 v1: 0 on v0 p
  void after_boundary_split(const Intrinsic_triangulation& t, const Intrinsic_triangulation::Boundary_split& s)
  {
    m_value.conservativeResize(t.number_of_edges(), Eigen::NoChange);
    set_row(s.second, row(s.first));
    set_row(s.first, Eigen::RowVectorXi::Zero(size()));
    set_row(s.spoke, -row(t.next(s.spoke)));
  }

private:
  static int sign(Halfedge h) { return h.idx() % 2 == 0 ? 1 : -1; }   // halfedges 2e and 2e+1 make edge e
  void set_row(Halfedge h, const Eigen::RowVectorXi& r) { m_value.row(h.idx() / 2) = sign(h) * r; }

  Row_matrix m_value;
};

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTEGER_COCHAINS_H
