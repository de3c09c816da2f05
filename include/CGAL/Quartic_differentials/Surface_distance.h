// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_SURFACE_DISTANCE_H
#define CGAL_QUARTIC_DIFFERENTIALS_SURFACE_DISTANCE_H

namespace CGAL {
namespace Quartic_differentials {

/// A one-sided distance, as a fraction of the diagonal of the input's bounding box.
struct Surface_distance
{
  double most, rms;   ///< the mean of squares is weighted by area
};

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_SURFACE_DISTANCE_H
