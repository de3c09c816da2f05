// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_COMPONENTS_H
#define QUARTIC_COMPONENTS_H

#include <CGAL/Quartic_differentials/IO/read_surface.h>

#include <functional>
#include <string>
#include <vector>

/// the name of a component's folder in the folder of results, counted from 0
std::string component_folder(std::size_t number);

/// whether a folder's name is that of a component's
bool is_component_folder(const std::string& name);

/// runs one component, which can be used, with its results in a folder; failure is an exception
using Run_component = std::function<void(CGAL::Quartic_differentials::Surface_component& component,
                                         const std::string& folder)>;

/// runs the components one by one into the folders component_0, component_1, ..., whatever becomes of the others, and
/// writes components.json (components.schema.json). What fails is told on the error stream, and unless `quiet` a table
/// of all on the output stream.
/// \throws Failed_components if any failed
void run_components(const std::string& mesh, std::vector<CGAL::Quartic_differentials::Surface_component> components,
                    const std::string& folder, bool quiet, const Run_component& run);

/// the exit statuses in a folder's components.json, in order
/// \throws Unusable_surface_error if it is not of the form that is written
std::vector<int> exit_statuses_of_components(const std::string& folder);

#endif // QUARTIC_COMPONENTS_H
