// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_MOTORCYCLE_TRACING_H
#define CGAL_QUARTIC_DIFFERENTIALS_MOTORCYCLE_TRACING_H

#include "grid_lines.h"

#include <CGAL/Quartic_differentials/Visitor.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// What a trace does in one face, or along one of its edges with the face on its left.
struct Visit
{
  Face         face;
  Ray          ray;
  std::int64_t entry;              ///< the time of entering the face, rounded down
  bool         entry_is_rounded;   ///< the time is not an integer
};

const std::size_t no_singularity = static_cast<std::size_t>(-1);

/// The way of one motorcycle from its singularity to where it stopped. The last visits may begin after that.
///
/// Or a wall: the boundary from a corner to the next one, with the surface on its left; or a whole boundary curve without
/// corners, twice round.
struct Trace
{
  std::size_t        singularity;   ///< where it starts, index in `Quartic_differential::singularities`; or none
  std::vector<Visit> visits;
  std::int64_t       stop;          ///< time; the start is at time 0
  bool               is_wall = false;
  std::size_t        end = no_singularity;   ///< the corner where a wall ends

  bool is_closed() const { return is_wall && end == no_singularity; }
};

/// Two traces that come through one point, or end there.
struct Meeting
{
  std::size_t  first;
  std::int64_t first_time;
  std::size_t  second;
  std::int64_t second_time;
  int          turn;          ///< from the direction of the first to that of the second, in quarters
};

struct Traces
{
  std::vector<Trace>   traces;     ///< singularity by singularity, counterclockwise, those of corners from the wall that
                                   ///< starts there; then those that start elsewhere
  std::vector<Meeting> meetings;   ///< all of them; some more than once
};

/// runs order + 4 motorcycles from every singularity, order + 1 from every corner; each stops where it meets the track of
/// another, or a wall. If there is no singularity one runs across the surface from its boundary.
/// \throws Numerical_error, Cancelled_error as `t_mesh()`
Traces trace_motorcycles(const Quartic_differential& q, Visitor& visitor);

} // namespace internal
} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_MOTORCYCLE_TRACING_H
