// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VERIFY_FLAT_OBJ_H
#define CGAL_QUARTIC_DIFFERENTIALS_VERIFY_FLAT_OBJ_H

#include "verify_flat.h"

#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

/// checks flat.obj for itself, against the report and what is known of flat_intrinsic.json, and against the input
/// \param input may be null
void verify_flat_obj(const std::string& folder, const Flat_facts& flat, const Report& report, const Mesh* input,
                     Checks& checks);

} } } // namespace CGAL::Quartic_differentials::verification

#endif // CGAL_QUARTIC_DIFFERENTIALS_VERIFY_FLAT_OBJ_H
