// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_VERIFY_OUTPUTS_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_VERIFY_OUTPUTS_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// One statement about the output of a run, and whether it holds.
struct Verification
{
  bool        ok;
  std::string what;
};

/// checks the files flat_intrinsic.json, flat.obj, tmesh.json, quads.obj and report.json of an output folder against
/// each other and against the input, in exact integer arithmetic and without any code of the steps that made them:
/// - the flat triangulation is a closed connected oriented surface of the genus in the report, every triangle is
///   positively oriented, charts differ across every edge by exactly a rotation by k*90 degrees and a translation, the
///   cone angles are those of the singularities in the report, and their degree is 8g - 8;
/// - the same holds for the triangles of flat.obj, if it is there, and it has exactly the same area; with the input given,
///   it must be there, have the input's vertices bit by bit, lie on it to 1e-12 of its diagonal and cover its area;
/// - the patches of the T-mesh are exact rectangles that use every arc once in each direction, have the right Euler
///   characteristic and exactly the area of the flat triangulation, and every node has the arms and patch corners of its
///   kind. Where there is no singularity tmesh.json may be missing;
/// - the quads make up a closed connected oriented surface of the genus in the report, no two edges of which have the
///   same ends; its irregular vertices are those of the singularities; quads of a patch, named in tmesh.json, are a
///   regular grid; the numbers of quads, vertices and patches are the report's, and so is the least scaled Jacobian, to
///   1e-12; with the input given, vertices lie on it to 1e-9 of its diagonal. quads.obj must be there if and only if
///   the report has quads.
///
/// On a surface with b boundary curves, as `input.boundary` of the report says, there are as many in all files, Euler
/// characteristics are 2 - 2g - b and the degree 8g - 8 + 4b, and besides:
/// - every edge of the boundary is exactly horizontal or vertical in its chart, and the angles between them are those
///   of the `corners` in the report, 180 degrees elsewhere; with the input given, the boundary of flat.obj lies on the
///   input's to 1e-12 of its diagonal and is as long;
/// - arcs on the boundary are used once, forward; nodes `corner`, `boundary` and `t_junction` fit their places;
/// - the irregular vertices of the quads' boundary are the corners; with the input given, vertices of the boundary lie
///   on the input's to 1e-9 of its diagonal.
///
/// A file that is missing, cut off or not of the right form is a check that failed, never an exception or a crash.
/// \param input null: what the files say of the input is taken for granted
/// Complexity: O(n log n) in the size of the files.
std::vector<Verification> verify_outputs(const std::string& folder, const Intrinsic_triangulation* input = nullptr);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_VERIFY_OUTPUTS_H
