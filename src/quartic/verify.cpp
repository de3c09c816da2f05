// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/IO/verify_outputs.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

void verify(const std::vector<std::string>& paths)
{
  const std::string& folder = paths.back();
  if (!std::filesystem::is_directory(folder)) throw Unusable_surface_error("there is no folder " + folder);
  std::optional<Intrinsic_triangulation> input;
  std::vector<std::string> notes;
  if (paths.size() == 2) input = read_surface(paths.front(), notes);
  const std::vector<Verification> checks = verify_outputs(folder, input ? &*input : nullptr);
  std::size_t failed = 0;
  for (const Verification& check : checks) {
    std::cout << (check.ok ? "ok    " : "FAIL  ") << check.what << '\n';
    if (!check.ok) ++failed;
  }
  if (failed > 0)
    throw Unusable_surface_error(std::to_string(failed) + " of " + std::to_string(checks.size()) + " checks of " + folder
                                 + " failed");
}

} // namespace

void add_verify(CLI::App& app)
{
  auto paths = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("verify", "Check the results in a folder in exact arithmetic, independently of "
                                                   "the steps that made them");
  command->add_option("[INPUT] DIR", *paths, "Output folder of a run; before it, the mesh it was run on, if it is to be "
                                             "compared with the results")->required()->expected(1, 2);
  command->callback([paths] { verify(*paths); });
}
