// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_FUZZ_TEMPORARY_FILE_H
#define CGAL_QUARTIC_DIFFERENTIALS_FUZZ_TEMPORARY_FILE_H

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace Quartic_fuzz {

/// a folder of this process, removed at its end
class Temporary_folder
{
public:
  Temporary_folder()
    : m_path(std::filesystem::temp_directory_path() / ("quartic_fuzz_" + std::to_string(getpid())))
  { std::filesystem::create_directories(m_path); }
  ~Temporary_folder() { std::error_code ignored; std::filesystem::remove_all(m_path, ignored); }
  Temporary_folder(const Temporary_folder&) = delete;

  std::string path() const { return m_path.string(); }

  /// the path of a file in it with these contents
  std::string file(const std::string& name, const std::string& contents) const
  {
    const std::string path = (m_path / name).string();
    std::ofstream(path, std::ios::binary) << contents;
    return path;
  }

private:
  std::filesystem::path m_path;
};

} // namespace Quartic_fuzz

#endif // CGAL_QUARTIC_DIFFERENTIALS_FUZZ_TEMPORARY_FILE_H
