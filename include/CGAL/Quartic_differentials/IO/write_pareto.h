// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_PARETO_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_PARETO_H

#include <CGAL/Quartic_differentials/choose_singularities.h>

#include <iosfwd>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// writes a table with the columns `count`, `distortion` and `area_scale_99_to_1_percent`, comma-separated, under a line
/// with their names.
void write_pareto_csv(std::ostream& out, const std::vector<Pareto_point>& points);

/// draws distortion and area scale over the number of singularities, on logarithmic axes, as a picture in SVG.
/// \param chosen the number that was chosen, which is marked
/// \param wanted the distortion that was aimed at, drawn as a line
/// \pre at least one point
void write_pareto_svg(std::ostream& out, const std::vector<Pareto_point>& points, int chosen, double wanted);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_PARETO_H
