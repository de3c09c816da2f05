// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_QUANTIZE_H
#define CGAL_QUARTIC_DIFFERENTIALS_QUANTIZE_H

#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, "Quantization")
//   l_a  the length of arc a, s the scale, x_a = s l_a the length it should have, in quads
//   q_a  the integer it gets
//   X    the zero complex: what shrinks to points where q is 0

/// How integers are found; each is tried when the one before it has used up its share of the work.
enum class Quantization_method
{
  optimal,     ///< integer program, a cut for every path and loop that must not shrink
  incumbent,   ///< integer program, the longest arc of every such path or loop is at least 1
  even         ///< linear program with even bounds and breakpoints, which is integral: always succeeds
};

/// "optimal", "incumbent" or "even"
const char* name(Quantization_method method);

/// How many quads are wanted, and how long `quantize()` looks for them.
struct Quantization_options
{
  std::size_t number_of_quads = 2000;        ///< the target
  double      edge_length = 0;               ///< if positive, the target instead: the length of a quad's side
  std::size_t number_of_blocks = 0;          ///< if positive, quads come in about this number of blocks of k x k
  double      surface_units_per_unit = 1;    ///< that of the quartic differential: the unit of `edge_length`
  double      tolerance = 0.03;              ///< the scale is searched until the number of quads is as near as this
  std::size_t node_limit = 1000;             ///< of search trees, for all scales: the work, the same on all machines
  double      time_limit = 60;               ///< in seconds, a last resort: what is found then depends on the machine
  Quantization_method method = Quantization_method::optimal;   ///< the first that is tried
};

/// The integer lengths of the arcs of a T-mesh, and how they were found.
struct Quantization
{
  std::vector<int>    length;                ///< q, by arc; multiples of `block_size`
  int                 block_size = 1;        ///< k: quads come in blocks of k x k, which meet side to side
  double              scale = 0;             ///< s, by grid unit
  std::size_t         number_of_quads = 0;   ///< reached
  std::size_t         target = 0;            ///< asked for; where an edge length was given, the number it stands for
  std::string         shortfall;             ///< why it is further from the target than 5%, a sentence; or empty
  Quantization_method method = Quantization_method::optimal;   ///< that found it
  double              cost = 0;              ///< the sum of (q - s l)^2
  double              lower_bound = 0;       ///< of the cost of every quantization at this scale
  bool                optimal = false;       ///< proved, to the linear program's rounding: the cost is the lower bound
  std::size_t         cuts = 0;              ///< at this scale
  std::size_t         scales = 0;            ///< tried
  std::size_t         rounds = 0, solves = 0;   ///< of separation; of linear and integer programs
  double              seconds = 0;
};

/// gives every arc of a T-mesh an integer length q >= 0, so that opposite sides of every patch are equal, a regular
/// grid in every patch fits its neighbours, and the quads make up a surface of the same genus and with the same number
/// of boundary curves, with every singularity at a vertex of its own, corners on the boundary and the others inside;
/// q is as near as possible to s times the arc's length, in the sum of squares.
///
/// The scale s is searched for the number of quads, unless an edge length is given. Arcs may get length 0, so that
/// meshes can be coarser than the T-mesh. No quad has a vertex twice, and no two edges have the same ends.
///
/// Where blocks are asked for, q is k times a quantization for that number of quads. They are patches for splines: the
/// lines of a fine mesh from singularity to singularity cut it into about as many patches as it has quads.
///
/// The squares enter as chords between successive integers. The linear program then has half-integral solutions (it is
/// a bidirected flow: every arc is on two sides), except for the cuts. Cuts are separated: X is the complex of zero
/// arcs, of the chords across patches of width 0, and of patches of size 0 x 0; the quantization is valid if every
/// component of X has Euler characteristic 1 and at most one singularity, and meets the boundary nowhere, or in a
/// connected part and without a singularity inside the surface; a shortest path or loop that contradicts gets a sum of
/// at least 1. Paths of arcs between singularities, or from one inside to the boundary, and loops of arcs, or paths
/// from boundary to boundary, that bound no disk in which all could shrink, must have that in every quantization; the others
/// may cut off valid ones, and then optimality is not claimed.
///
/// \pre `options.number_of_quads` is positive; `defect()` of the T-mesh is empty
/// \throws Infeasible_divisor_error if there is a singularity of order -3, which no quad mesh has, or no patch,
///         or if more than 10^7 quads are asked for
/// \throws Numerical_error if the linear program fails
/// \throws Cancelled_error
/// Complexity: measured, not bounded: a few integer programs with 9 variables an arc, each linear in the quads beside.
///             With `Quantization_method::even`, as many linear programs as there are arcs, at most.
/// Source: METHOD, "Quantization"; the integer program without separation, Campen, Bommes and Kobbelt 2015.
Quantization quantize(const T_mesh& t, const Quantization_options& options, Visitor& visitor);

/// checks a quantization exactly, and returns the first violation as a sentence, or the empty string: no length is
/// negative, opposite sides of patches have equal sums, and the quads make up a surface of the T-mesh's genus with its
/// number of boundary curves, in which every singularity is a vertex of its own with order + 4 quads, on the boundary
/// order + 2, and all other vertices have 4, on the boundary 2.
///
/// It builds that surface, and does not look at X. \pre `defect()` of the T-mesh is empty
/// Complexity: O(n log n) in the quads and arcs.
std::string quantization_defect(const T_mesh& t, const std::vector<int>& q);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_QUANTIZE_H
