// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VERIFY_T_MESH_H
#define CGAL_QUARTIC_DIFFERENTIALS_VERIFY_T_MESH_H

#include "verify_flat.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

/// the places of a list's items by their "id"
using Ids = std::map<std::int64_t, std::size_t>;

/// checks tmesh.json for itself, against the report and what is known of flat_intrinsic.json
/// \return the patches
Ids verify_t_mesh(const std::string& folder, const Flat_facts& flat, const Report& report, Checks& checks);

} } } // namespace CGAL::Quartic_differentials::verification

#endif // CGAL_QUARTIC_DIFFERENTIALS_VERIFY_T_MESH_H
