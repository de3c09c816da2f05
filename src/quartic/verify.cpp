// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Quartic_differentials/IO/verify_outputs.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

void verify(const std::string& folder)
{
  const std::vector<Verification> checks = verify_outputs(folder);
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
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("verify", "Check the results in a folder in exact arithmetic, independently of "
                                                   "the steps that made them");
  command->add_option("DIR", *folder, "Output folder of a run")->required()->check(CLI::ExistingDirectory);
  command->callback([folder] { verify(*folder); });
}
