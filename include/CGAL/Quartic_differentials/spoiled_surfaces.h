// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_SPOILED_SURFACES_H
#define CGAL_QUARTIC_DIFFERENTIALS_SPOILED_SURFACES_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

namespace CGAL {
namespace Quartic_differentials {

// Surfaces made as bad as scans and careless modelling make them, to see what survives. The same on every run and with
// every standard library. Complexity: linear in the size of the result.

/// the surface stretched along the x axis
Mesh stretched(Mesh mesh, double factor);

/// every vertex moved at random, by up to a part of the mean edge length in every coordinate
Mesh noisy(Mesh mesh, double part, unsigned seed);

/// one face in five split by a vertex that is `height` times the altitude away from an edge: a needle of that height
/// \pre 0 < height < 1
Mesh with_slivers(Mesh mesh, double height, unsigned seed);

/// one face replaced by a fan of n triangles round a vertex of valence n, and the triangles that join it to the rest
/// \pre n >= 3
Mesh with_hub(const Mesh& mesh, int n);

/// every boundary edge in a triangle with an obtuse angle opposite to it: its face is split by a vertex at which the
/// angle is random between 95 degrees and this, or greater than at the opposite vertex. The surface does not change.
/// \pre 95 <= degrees < 180
Mesh with_obtuse_boundary(Mesh mesh, double degrees, unsigned seed);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_SPOILED_SURFACES_H
