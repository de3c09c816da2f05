// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "exit_status.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>

namespace {

// what is typed into a POSIX shell to get this argument
std::string quoted(const std::string& argument)
{
  const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) return argument;
  std::string text = "'";
  for (char c : argument) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

std::string command_line(int argc, char** argv)
{
  std::string text = "quartic";
  for (int i = 1; i < argc; ++i) text += ' ' + quoted(argv[i]);
  return text;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{
    "Finds singularities on a closed surface at which it can be cut into rectangles: it computes a flat metric\n"
    "with cone angles that are multiples of 90 degrees, conformal to the surface, the meromorphic quartic\n"
    "differential that goes with it, and the T-mesh of its critical trajectories.\n\n"
    "A first try:\n"
    "  quartic sample chain --genus 2 -o surface.off     make a surface with two handles\n"
    "  quartic run surface.off -o results                run everything on it\n", "quartic"};
  app.set_version_flag("--version", "quartic " QUARTIC_VERSION);
  app.require_subcommand(1);
  app.footer("'quartic COMMAND --help' explains a command.\n"
             "Exit status: 0 done; 1 wrong usage; 2 the input or the singularities cannot be used;\n"
             "3 a computation did not reach its tolerance.");
  add_run(app, command_line(argc, argv));
  add_info(app);
  add_sample(app);
  add_verify(app);
  add_render(app);

  try {
    app.parse(argc, argv);
    return done;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? done : usage;
  } catch (...) {
    const Failure failure = failure_of(std::current_exception());
    std::cerr << "quartic: " << one_line(failure.message) << std::endl;
    return failure.status;
  }
}
