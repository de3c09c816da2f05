// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CONSTRUCTION_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CONSTRUCTION_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/cone_insertion.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The flips that led from one triangulation to another, in order. Rides along.
class Flip_log
{
public:
  /// The edges of a flip: e = ij to kl, a = jk, b = ki, c = il, d = lj (METHOD, step 6).
  struct Entry
  {
    Edge e, a, b, c, d;
    bool ptolemy;
  };

  void before_flip(const Intrinsic_triangulation& t, const Edge_flip& f)
  { m_entries.push_back({f.edge, t.edge(f.jk), t.edge(f.ki), t.edge(f.il), t.edge(f.lj), f.ptolemy}); }
  const std::vector<Entry>& entries() const { return m_entries; }

private:
  std::vector<Entry> m_entries;
};

/// How a flat triangulation was made from the input: cones inserted in its faces and corners on its boundary edges, then
/// flips. What is decided here in doubles is combinatorics, which another number type takes over.
struct Construction
{
  struct Cone
  {
    std::size_t         singularity;
    Surface_point       location;      ///< on the input
    bool                on_boundary;
    Vertex              vertex;
    std::array<Edge, 3> spoke;         ///< from the new vertex
    std::array<int, 3>  end;           ///< where the spokes end, named as in `Face_piece`
  };
  std::vector<Cone> cones;   ///< those that are no vertices of the input, in the order of their insertion
  Flip_log          flips;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CONSTRUCTION_H
