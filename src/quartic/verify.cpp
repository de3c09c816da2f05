// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "components.h"
#include "exit_status.h"

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

class Verifier
{
public:
  /// \param name what stands before every check
  void check(const std::string& folder, const Intrinsic_triangulation* input, const std::string& name = "")
  {
    for (const Verification& check : verify_outputs(folder, input)) {
      std::cout << (check.ok ? "ok    " : "FAIL  ") << name << check.what << '\n';
      ++m_checks;
      if (!check.ok) ++m_failed;
    }
  }

  void require_success(const std::string& folder) const
  {
    if (m_failed > 0)
      throw Unusable_surface_error(std::to_string(m_failed) + " of " + std::to_string(m_checks) + " checks of " + folder
                                   + " failed");
  }

private:
  std::size_t m_checks = 0, m_failed = 0;
};

// the results of every component whose run ended well
void verify_components(const std::string& folder, const std::string& mesh, Verifier& verifier)
{
  const std::vector<int> statuses = exit_statuses_of_components(folder);
  std::vector<Surface_component> components;
  if (!mesh.empty()) components = read_surface_components(mesh);
  if (!mesh.empty() && components.size() != statuses.size())
    throw Unusable_surface_error(mesh + " has " + std::to_string(components.size()) + " components, but there are "
                                 "results of " + std::to_string(statuses.size()) + " in " + folder);
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    const std::string name = component_folder(i);
    if (statuses[i] != done) std::cout << "-     " << name << ": its run failed, it is not checked\n";
    else if (!mesh.empty() && !components[i].surface)
      throw Unusable_surface_error(mesh + ", " + name + ": " + components[i].refusal);
    else verifier.check(folder + "/" + name, mesh.empty() ? nullptr : &*components[i].surface, name + ": ");
  }
}

void verify(const std::vector<std::string>& paths)
{
  const std::string& folder = paths.back();
  const std::string mesh = paths.size() == 2 ? paths.front() : "";
  if (!std::filesystem::is_directory(folder)) throw Unusable_surface_error("there is no folder " + folder);
  Verifier verifier;
  if (std::filesystem::is_regular_file(folder + "/components.json")) {
    verify_components(folder, mesh, verifier);
  } else {
    std::optional<Intrinsic_triangulation> input;
    std::vector<std::string> notes;
    if (!mesh.empty()) input = read_surface(mesh, notes);
    verifier.check(folder, input ? &*input : nullptr);
  }
  verifier.require_success(folder);
}

} // namespace

void add_verify(CLI::App& app)
{
  auto paths = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("verify", "Check the results in a folder in exact arithmetic, independently of "
                                                   "the steps that made them");
  command->add_option("[INPUT] DIR", *paths, "Output folder of a run; before it, the mesh it was run on, if it is to be "
                                             "compared with the results; also of a run with --components each")
         ->required()->expected(1, 2);
  command->callback([paths] { verify(*paths); });
}
