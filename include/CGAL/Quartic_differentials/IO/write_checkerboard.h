// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_CHECKERBOARD_H
#define CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_CHECKERBOARD_H

#include <CGAL/Quartic_differentials/Quartic_differential.h>

#include <iosfwd>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// writes a checkerboard as a PNG picture.
///
/// It covers one unit of the charts of q, u to the right and v up, and is to be repeated in every other one; the number
/// of its squares is even and such that about 2500 of them cover the surface.
/// \throws Error if libpng cannot
void write_checkerboard_png(std::ostream& out, const Quartic_differential& q);

/// writes `folder`/`name`.mtl, with one material called `checkerboard`, and its texture `folder`/`name`.png, as
/// `write_checkerboard_png()` does.
/// \throws Error if a file cannot be written
void write_checkerboard(const std::string& folder, const std::string& name, const Quartic_differential& q);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_IO_WRITE_CHECKERBOARD_H
