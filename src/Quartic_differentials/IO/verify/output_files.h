// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VERIFY_OUTPUT_FILES_H
#define CGAL_QUARTIC_DIFFERENTIALS_VERIFY_OUTPUT_FILES_H

#include <CGAL/Quartic_differentials/IO/verify_outputs.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

// Everything that comes from a JSON file passes through these functions; all but the first throw Malformed.

using Json     = nlohmann::json;
using Checks   = std::vector<Verification>;
using Position = std::array<double, 3>;

/// The file is missing or not of the form it should be.
struct Malformed : Error { using Error::Error; };

const std::int64_t most_items = std::numeric_limits<std::int32_t>::max();
const int          largest_grid_exponent = 62;

bool         has_file(const std::string& folder, const std::string& name);
Json         read_json(const std::string& folder, const std::string& name);
const Json&  member(const Json& object, const char* key);
const Json&  array(const Json& value, const std::string& what);
const Json&  array_of_size(const Json& value, std::size_t size, const std::string& what);
std::int64_t integer(const Json& value, std::int64_t least, std::int64_t greatest, const std::string& what);
std::string  string(const Json& value, const std::string& what);
Position     position(const Json& value, const std::string& what);

inline Point_3 point_3(const Position& p) { return {p[0], p[1], p[2]}; }

} } } // namespace CGAL::Quartic_differentials::verification

#endif // CGAL_QUARTIC_DIFFERENTIALS_VERIFY_OUTPUT_FILES_H
