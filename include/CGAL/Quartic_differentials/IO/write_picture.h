// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_PICTURE_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_PICTURE_H

#include <CGAL/Quartic_differentials/quad_mesh.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// Size and view of a picture.
struct Picture_options
{
  int                     size = 1200;       ///< pixels of the longer side
  std::optional<Vector_3> direction;         ///< from the surface to the eye; none: chosen by the shape
  std::optional<Vector_3> up;                ///< what is upward in the picture; none: y, or z in a view along y
  bool                    both_sides = false;   ///< a second picture from behind, on the right
};

/// draws a quad mesh as a PNG file: its quads, softly coloured by patch so that neighbours differ, patch borders
/// thicker than other edges, and singularities as balls: simple poles red, double ones orange, higher ones dark red,
/// simple zeros blue, double ones green, higher ones turquoise. Equal meshes give equal bytes.
/// \pre `defect(m, t)` is empty
/// Complexity: O(n log n) for n quads, and linear in the pixels.
void write_quads_picture(std::ostream& out, const Quad_mesh& m, const T_mesh& t, const Picture_options& options = {});

/// What a picture of the results of a run shows.
enum class Picture
{
  checkerboard,   ///< the charts, `flat.obj`
  t_mesh,         ///< patches in colours that differ between neighbours, and arcs: `tmesh.vtp`, `tmesh.json`
  quads,          ///< as `write_quads_picture()`: `quads.obj`
  wireframe,      ///< the edges of `flat.obj`
  loops           ///< tunnel loops amber, handle loops teal, their zigzag smoothed: `loops.obj`, `flat.obj`
};

/// "picture_checkerboard.png" and so on
std::string picture_name(Picture picture);

/// the files that a picture needs and that are not in the output folder of a run
std::vector<std::string> missing_files(const std::string& folder, Picture picture);

/// draws pictures of what a run left in a folder, each as a PNG file `picture_name()` in `target`, all from one
/// direction, with the singularities of `report.json`.
/// \throws Unusable_surface_error if a file is missing, or not of the form that a run writes; the sentence names it
/// \throws Error if a picture cannot be written
/// Complexity: O(n log n) in the size of the files, and linear in the pixels.
void write_pictures(const std::string& folder, const std::vector<Picture>& pictures, const std::string& target,
                    const Picture_options& options = {});

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_PICTURE_H
