// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_VERIFY_OUTPUTS_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_VERIFY_OUTPUTS_H

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

/// checks the files flat_intrinsic.json, tmesh.json and report.json of an output folder against each other, in exact
/// integer arithmetic and without any code of the steps that made them:
/// - the flat triangulation is a closed connected oriented surface of the genus in the report, every triangle is
///   positively oriented, charts differ across every edge by exactly a rotation by k*90 degrees and a translation, the
///   cone angles are those of the singularities in the report, and their degree is 8g - 8;
/// - the patches of the T-mesh are exact rectangles that use every arc once in each direction, have the right Euler
///   characteristic and exactly the area of the flat triangulation, and every node has the arms and patch corners of its
///   kind. Where there is no singularity tmesh.json may be missing.
///
/// A file that is missing, cut off or not of the right form is a check that failed, never an exception or a crash.
/// Not checked: that the files belong to a given input mesh.
/// Complexity: O(n log n) in the size of the files.
std::vector<Verification> verify_outputs(const std::string& folder);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_VERIFY_OUTPUTS_H
