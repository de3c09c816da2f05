// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_SURFACE_COMPONENTS_H
#define CGAL_QUARTIC_DIFFERENTIALS_SURFACE_COMPONENTS_H

#include "Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// The component of every face, numbered in the order of their first faces. Complexity: O(n log n).

/// faces that have a vertex in common are in one component. \pre indices are in range
std::vector<std::size_t> components(const Polygon_soup& s);

/// the same, and components with boundary are one if they have points with equal coordinates
std::vector<std::size_t> components_up_to_equal_points(const Polygon_soup& s);

/// triangles that are glued to each other are in one component. \pre indices are in range
std::vector<std::size_t> components(const Glued_triangles& s);

// A surface taken apart: vertices and faces keep their order.

std::vector<Polygon_soup> parts(const Polygon_soup& s, const std::vector<std::size_t>& component);
std::vector<Glued_triangles> parts(const Glued_triangles& s, const std::vector<std::size_t>& component);

/// one more than the greatest that is named
std::size_t number_of_vertices(const Glued_triangles& s);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_SURFACE_COMPONENTS_H
