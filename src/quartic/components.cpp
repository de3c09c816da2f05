// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "components.h"
#include "exit_status.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <utility>

using namespace CGAL::Quartic_differentials;
using Json = nlohmann::ordered_json;

namespace {

const std::string prefix = "component_";

Json facts(const Surface_component& c, const std::string& name)
{
  if (!c.surface) return {{"folder", name}, {"vertices", c.vertices}, {"faces", c.faces}};
  const Intrinsic_triangulation& t = *c.surface;
  return {{"folder", name}, {"vertices", t.number_of_vertices()}, {"edges", t.number_of_edges()},
          {"faces", t.number_of_faces()}, {"genus", t.genus()}, {"boundary", t.number_of_boundary_curves()}};
}

void print_table(std::ostream& out, const Json& components)
{
  const std::array<const char*, 5> columns{"vertices", "edges", "faces", "genus", "boundary"};
  out << "  " << std::left << std::setw(16) << "folder" << std::right;
  for (const char* column : columns) out << std::setw(10) << column;
  out << "  status\n";
  for (const Json& c : components) {
    out << "  " << std::left << std::setw(16) << c["folder"].get<std::string>() << std::right;
    for (const char* column : columns) out << std::setw(10) << (c.contains(column) ? c[column].dump() : "-");
    out << "  " << c["exit_status"] << (c.contains("reason") ? ": " + one_line(c["reason"]) : ", done") << '\n';
  }
}

} // namespace

std::string component_folder(std::size_t number) { return prefix + std::to_string(number); }

bool is_component_folder(const std::string& name)
{
  return name.size() > prefix.size() && name.compare(0, prefix.size(), prefix) == 0
      && name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
}

void run_components(const std::string& mesh, std::vector<Surface_component> components, const std::string& folder,
                    bool quiet, const Run_component& run)
{
  Json list = Json::array();
  std::size_t failed = 0;
  Exit_status worst = done;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::string name = component_folder(i);
    Json& entry = list.emplace_back(facts(components[i], name));
    if (!quiet) std::cout << (i == 0 ? "" : "\n") << name << ":\n";
    Failure failure{done, ""};
    try {
      if (!components[i].surface) throw Unusable_surface_error(components[i].refusal);
      run(components[i], folder + "/" + name);
    } catch (...) {
      failure = failure_of(std::current_exception());
    }
    components[i].surface.reset();
    entry["exit_status"] = static_cast<int>(failure.status);
    if (failure.status == done) continue;
    entry["reason"] = failure.message;
    std::cerr << "quartic: " << name << ": " << one_line(failure.message) << std::endl;
    worst = std::max(worst, failure.status);
    ++failed;
  }
  const Json file{{"mesh", mesh}, {"components", list}, {"exit_status", static_cast<int>(worst)}};
  internal::write_file(folder + "/components.json", [&](std::ostream& out) { out << file.dump(1) << '\n'; });
  if (!quiet) {
    std::cout << '\n';
    print_table(std::cout, list);
  }
  if (failed > 0)
    throw Failed_components(std::to_string(failed) + " of " + std::to_string(components.size()) + " components failed",
                            worst);
}

std::vector<int> exit_statuses_of_components(const std::string& folder)
{
  const std::string path = folder + "/components.json";
  try {
    std::ifstream in(path);
    const Json file = Json::parse(in);
    std::vector<int> statuses;
    for (const Json& c : file.at("components")) statuses.push_back(c.at("exit_status").get<int>());
    return statuses;
  } catch (const Json::exception&) {
    throw Unusable_surface_error(path + " is not the list of components that `quartic run --components each` writes");
  }
}
