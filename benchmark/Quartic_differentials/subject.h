// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_SUBJECT_H
#define CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_SUBJECT_H

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/boost/graph/IO/OFF.h>

#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

/// A surface to run on; `load` is timed as the step "read".
struct Subject
{
  std::string                                                          name;
  std::function<CGAL::Quartic_differentials::Intrinsic_triangulation()> load;
  bool                                                                 is_file = false;
};

inline Subject from_file(const std::string& path)
{
  return {std::filesystem::path(path).stem().string(), [path] {
    std::vector<std::string> notes;
    return CGAL::Quartic_differentials::read_surface(path, notes);
  }, true};
}

inline Subject chain(int genus, int resolution)
{
  return {"handle_chain(" + std::to_string(genus) + ", " + std::to_string(resolution) + ")", [genus, resolution] {
    namespace QD = CGAL::Quartic_differentials;
    return QD::Intrinsic_triangulation(QD::handle_chain(genus, resolution));
  }};
}

inline Subject torus_of_revolution(int n, int m)
{
  return {"torus(2, 1, " + std::to_string(n) + ", " + std::to_string(m) + ")", [n, m] {
    namespace QD = CGAL::Quartic_differentials;
    return QD::Intrinsic_triangulation(QD::torus(2, 1, n, m));
  }};
}

/// the subject with every triangle split into four, `subdivisions` times.
inline Subject finer(const Subject& subject, int subdivisions)
{
  return {subject.name + ", subdivided " + std::to_string(subdivisions), [load = subject.load, subdivisions] {
    namespace QD = CGAL::Quartic_differentials;
    QD::Intrinsic_triangulation t = load();
    if (subdivisions == 0) return t;
    if (!t.is_embedded()) throw QD::Error("only surfaces in space can be subdivided here");
    QD::Mesh mesh = t.mesh();
    for (int i = 0; i < subdivisions; ++i) mesh = QD::subdivided(mesh);
    return QD::Intrinsic_triangulation(std::move(mesh));
  }};
}

/// A generated surface in a file, so that what is timed begins with reading one; the file is there as long as this is.
class Stored_subject
{
public:
  Stored_subject(const std::string& name, const CGAL::Quartic_differentials::Mesh& mesh)
    : m_path(std::filesystem::temp_directory_path()
             / ("quartic_benchmark_" + std::to_string(std::random_device{}()) + ".off")), m_name(name)
  {
    const int digits = 17;   // doubles are read back as they were
    if (!CGAL::IO::write_OFF(m_path.string(), mesh, CGAL::parameters::stream_precision(digits)))
      throw CGAL::Quartic_differentials::Error("cannot write " + m_path.string());
  }
  ~Stored_subject() { std::error_code ignored; std::filesystem::remove(m_path, ignored); }
  Stored_subject(const Stored_subject&) = delete;
  Stored_subject& operator=(const Stored_subject&) = delete;

  Subject subject() const { return {m_name, from_file(m_path.string()).load, true}; }

private:
  std::filesystem::path m_path;
  std::string           m_name;
};

#endif // CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_SUBJECT_H
