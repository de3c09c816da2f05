// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_COMMANDS_H
#define QUARTIC_COMMANDS_H

#include <string>

namespace CLI { class App; }

// Each adds its subcommand, which runs while the command line is parsed and reports failure by an exception of
// CGAL/Quartic_differentials/exceptions.h; main() turns that into the exit status.

/// \param command_line what was typed, for the page that says how to do it again
void add_run(CLI::App& app, const std::string& command_line);
void add_info(CLI::App& app);
void add_sample(CLI::App& app);
void add_verify(CLI::App& app);
void add_render(CLI::App& app);

#endif // QUARTIC_COMMANDS_H
