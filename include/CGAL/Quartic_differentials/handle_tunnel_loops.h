// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_HANDLE_TUNNEL_LOOPS_H
#define CGAL_QUARTIC_DIFFERENTIALS_HANDLE_TUNNEL_LOOPS_H

#include <CGAL/Quartic_differentials/handle_tunnel_basis.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// A closed walk along edges: every halfedge ends where the next begins, cyclically.
struct Edge_loop
{
  std::vector<Halfedge> walk;
  double                length = 0;
  bool                  simple = true;   ///< it passes through no vertex twice
};

/// A canonical basis a_1 .. a_g, b_1 .. b_g that people recognise, and what to draw.
struct Handle_tunnel_loops
{
  Handle_tunnel_basis    classes;   ///< which loops these are: tunnels a_i and handles b_i if `found`
  std::vector<Edge_loop> loops;     ///< by class, row by row
};

/// finds short loops in handle and tunnel classes that form a canonical basis, for people to look at.
///
/// Shortest loops through some vertices, spread over the surface, are sorted by length. Those that are tunnels make a
/// basis of the tunnel classes greedily, to which a basis of the handle classes is dual, or the other way round:
/// whichever is shorter in all. Classes are added to each other as long as that makes loops shorter, and every loop is
/// tightened: shorter ones in its class are looked for through vertices on it. If handles and tunnels were not found,
/// this gives a canonical basis of short loops, a_i and b_i of no particular kind. Deterministic.
/// Not promised: that a loop is the shortest in its class. Every loop that was found in one piece is simple; `simple`
/// tells where pieces had to be put together.
/// \param classes its cochains live on `t`
/// \param roots the number of vertices that are tried at first
/// \pre `roots > 0`
/// \throws Numerical_error if an integer leaves the 16-bit range
/// Surfaces of more than 2000 vertices are searched in about as many cells, and a loop is tightened in a ribbon of the
/// surface round it.
/// Complexity: O(n log n) to make the cells, O(roots + g^4) for n large, and O(g k log k) for a loop that is tightened in a
/// ribbon of k vertices.
/// Source: J. Erickson, K. Whittlesey, "Greedy optimal homotopy and homology generators", SODA 2005; METHOD, step 1.
Handle_tunnel_loops handle_tunnel_loops(const Intrinsic_triangulation& t, const Handle_tunnel_basis& classes,
                                        int roots = 16);

/// "a1" .. "ag", "b1" .. "bg": the name of class k of a canonical basis
std::string loop_name(int k, int genus);

/// what class k is: "tunnel" or "handle", or "" if that is not known
std::string loop_kind(const Handle_tunnel_loops& loops, int k);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_HANDLE_TUNNEL_LOOPS_H
