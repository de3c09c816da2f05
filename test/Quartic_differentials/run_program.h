// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_RUN_PROGRAM_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_RUN_PROGRAM_H

// The program that the environment variable QUARTIC_PROGRAM names, run in a folder of its own.

#include "check.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>

namespace Quartic_test {

struct Outcome
{
  int         status;
  std::string out, err;
  double      cpu_seconds;
};

/// of all programs that were run so far
inline double cpu_seconds_of_children()
{
  rusage used;
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::string contents(const std::filesystem::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// what a shell takes for this one word
inline std::string quoted(const std::string& word)
{
  std::string text = "'";
  for (char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// a temporary folder, removed at the end, and the program run in it
class Program_folder
{
public:
  Program_folder()
    : m_path(std::filesystem::temp_directory_path() / ("quartic_program_" + std::to_string(std::random_device{}())))
  { std::filesystem::create_directories(m_path); }
  ~Program_folder() { std::error_code ignored; std::filesystem::remove_all(m_path, ignored); }
  Program_folder(const Program_folder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return m_path / name; }

  /// of the files and folders in it
  std::set<std::string> names() const
  {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(m_path)) names.insert(entry.path().filename());
    return names;
  }

  /// \param before what stands before the program's name: variables, or a command that runs it
  Outcome quartic(const std::string& arguments, const std::string& before = "") const
  {
    const std::string command = "cd '" + m_path.string() + "' && " + before + " '" + environment("QUARTIC_PROGRAM") + "' "
                              + arguments + " >out.txt 2>err.txt";
    const double cpu_before = cpu_seconds_of_children();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(m_path / "out.txt"), contents(m_path / "err.txt"),
            cpu_seconds_of_children() - cpu_before};
  }

private:
  std::filesystem::path m_path;
};

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_RUN_PROGRAM_H
