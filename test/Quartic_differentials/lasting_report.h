// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_LASTING_REPORT_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_LASTING_REPORT_H

#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace Quartic_test {

/// a report.json without times, memory and the name of the mesh
inline nlohmann::json lasting_report(const std::string& text)
{
  const auto lasts = [](int, nlohmann::json::parse_event_t event, const nlohmann::json& key) {
    static const std::set<std::string> others{"timings", "seconds", "peak_memory_bytes", "mesh"};
    return event != nlohmann::json::parse_event_t::key || others.count(key) == 0;
  };
  return nlohmann::json::parse(text, lasts);
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_LASTING_REPORT_H
