// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_POLYGON_SOUP_H
#define CGAL_QUARTIC_DIFFERENTIALS_POLYGON_SOUP_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// What a mesh file says: polygons as lists of point indices, unchecked.
struct Polygon_soup
{
  std::vector<Point_3>                  points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// parses the contents of a mesh file; `format` is off, obj, ply, stl or vtp.
/// Memory stays proportional to the contents, whatever a header announces.
/// \throws Unusable_surface_error if the contents are not of this format
Polygon_soup parse_polygon_soup(std::string contents, const std::string& format);

/// checks what CGAL's PLY reader takes for granted: a complete header, coordinates of floating point type, every
/// element with properties, and lists that end before the file does.
/// \throws Unusable_surface_error
void check_ply_layout(const std::string& contents);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_POLYGON_SOUP_H
