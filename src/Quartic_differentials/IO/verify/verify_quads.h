// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VERIFY_QUADS_H
#define CGAL_QUARTIC_DIFFERENTIALS_VERIFY_QUADS_H

#include "verify_t_mesh.h"

#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

/// checks quads.obj for itself, against the report and the input
/// \param patch_ids those of the T-mesh
/// \param input may be null
void verify_quads(const std::string& folder, const Report& report, const Ids& patch_ids, const Mesh* input,
                  Checks& checks);

} } } // namespace CGAL::Quartic_differentials::verification

#endif // CGAL_QUARTIC_DIFFERENTIALS_VERIFY_QUADS_H
