// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_VERIFIED_OUTPUT_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_VERIFIED_OUTPUT_H

// An output folder that is written, spoilt and verified.

#include <CGAL/Quartic_differentials/IO/verify_outputs.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace Quartic_test {

using CGAL::Quartic_differentials::Verification;
using nlohmann::json;

/// The three JSON files of an output folder, and the folder they are written to.
struct Output
{
  json flat, tmesh, report;

  std::vector<Verification> verified() const
  {
    write("flat_intrinsic.json", flat.dump());
    write("tmesh.json", tmesh.dump());
    write("report.json", report.dump());
    return CGAL::Quartic_differentials::verify_outputs(folder());
  }

  const json& file(const std::string& name) const
  { return name == "tmesh.json" ? tmesh : name == "report.json" ? report : flat; }

  static std::string folder()
  {
    static const std::filesystem::path path = std::filesystem::temp_directory_path()
                                            / ("quartic_verify_" + std::to_string(std::random_device()()));
    std::filesystem::create_directories(path);
    return path.string();
  }
  static void write(const std::string& name, const std::string& text) { std::ofstream(folder() + "/" + name) << text; }
};

inline bool all_hold(const std::vector<Verification>& checks)
{
  return !checks.empty() && std::all_of(checks.begin(), checks.end(), [](const Verification& c) { return c.ok; });
}

inline bool fails_with(const std::vector<Verification>& checks, const std::string& sentence)
{
  return std::any_of(checks.begin(), checks.end(),
                     [&](const Verification& c) { return !c.ok && c.what.find(sentence) != std::string::npos; });
}

using Lines = std::vector<std::string>;

inline Lines lines_of(const std::string& name)
{
  Lines lines;
  std::ifstream in(Output::folder() + "/" + name);
  for (std::string line; std::getline(in, line); ) lines.push_back(line);
  return lines;
}

inline std::string joined(const Lines& lines)
{
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_VERIFIED_OUTPUT_H
