// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <new>
#include <string>

namespace QD = CGAL::Quartic_differentials;

namespace {

enum Exit_status { done = 0, usage = 1, unusable_input = 2, numerical_failure = 3 };

// What is quoted from files may be long, and may hold line ends and codes that control terminals.
std::string one_line(std::string text)
{
  const std::size_t most = 500;
  if (text.size() > most) text = text.substr(0, most) + " ...";
  std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return text;
}

int failed(const std::string& message, Exit_status status)
{
  std::cerr << "quartic: " << one_line(message) << std::endl;
  return status;
}

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
  } catch (const QD::Unusable_surface_error& e) {
    return failed(e.what(), unusable_input);
  } catch (const QD::Infeasible_divisor_error& e) {
    return failed(e.what(), unusable_input);
  } catch (const QD::Numerical_error& e) {
    return failed(e.what(), numerical_failure);
  } catch (const QD::Error& e) {          // a file that cannot be written
    return failed(e.what(), usage);
  } catch (const std::bad_alloc&) {
    return failed("there is not enough memory for this", numerical_failure);
  } catch (const std::exception& e) {     // an error in the program
    return failed(e.what(), numerical_failure);
  }
}
