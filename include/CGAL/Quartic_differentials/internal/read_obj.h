// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_READ_OBJ_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_READ_OBJ_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// What the OBJ files that a run writes hold: points, texture coordinates, and faces and polylines in groups.
struct Obj_file
{
  struct Element
  {
    std::vector<std::size_t> vertices;
    std::vector<std::size_t> texture;   ///< by vertex, or empty
    std::string              group;     ///< the name that was last set
  };

  std::vector<Point_3>               points;
  std::vector<std::array<double, 2>> texture;
  std::vector<Element>               faces, lines;
};

/// reads an OBJ file; names of materials are passed over.
/// \throws Unusable_surface_error if the file cannot be opened, is cut off within a line, has a line of another kind, too
///         few or too many numbers, a number that is not finite, or an index out of range
/// Complexity: linear.
Obj_file read_obj(const std::string& path);

/// no run numbers its patches as far as this: what is beyond is an error of the file
const std::size_t most_patches = 10000000;

/// What `quads.obj` holds.
struct Quads_obj
{
  std::vector<Point_3>                    points;
  std::vector<std::array<std::size_t, 4>> quads;
  std::vector<std::size_t>                patch;   ///< by quad
};

/// reads `quads.obj`.
/// \throws Unusable_surface_error as `read_obj()`, and if there is anything else than vertices and quads in groups
///         `patch_k`, or no quad
/// Complexity: linear.
Quads_obj read_quads_obj(const std::string& path);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_READ_OBJ_H
