// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACE_FILES_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACE_FILES_H

// Points and faces, right or wrong, written in every format that the program reads.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace Quartic_test {

struct Soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<int>>      faces;
};

/// the first occurrence replaced, which must be there
inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);   // throws where there is none
}

inline std::string replaced_everywhere(const std::string& text, const std::string& from, const std::string& to)
{
  std::string result;
  std::size_t begin = 0;
  for (std::size_t found; (found = text.find(from, begin)) != std::string::npos; begin = found + from.size())
    result += text.substr(begin, found - begin) + to;
  return result + text.substr(begin);
}

/// the same faces, no two of which share a vertex
inline Soup separate_faces(const Soup& s)
{
  Soup result;
  for (const auto& f : s.faces) {
    result.faces.emplace_back();
    for (int v : f) {
      result.faces.back().push_back(static_cast<int>(result.points.size()));
      result.points.push_back(s.points[v]);
    }
  }
  return result;
}

const std::vector<std::string> all_formats{"off", "obj", "ply", "binary ply", "stl", "binary stl"};

/// "ply" for "binary ply"
inline std::string extension(const std::string& format) { return format.substr(format.find(' ') + 1); }

/// the bytes of a number, the little end first
template <class Number>
std::string bytes(Number x)
{
  std::string result(sizeof x, '\0');
  std::memcpy(&result[0], &x, sizeof x);   // the machine's order, little-endian wherever this is tested
  return result;
}

template <class Number>
std::string big_endian_bytes(Number x)
{
  const std::string little = bytes(x);
  return {little.rbegin(), little.rend()};
}

inline std::string text_of(const std::array<double, 3>& p)
{
  std::ostringstream out;
  out.precision(17);
  out << p[0] << ' ' << p[1] << ' ' << p[2];
  return out.str();
}

/// the file of this format; binary STL holds floats, and STL no more than three corners of a face
inline std::string written(const std::string& format, const Soup& s)
{
  std::ostringstream out;
  if (format == "off") {
    out << "OFF\n" << s.points.size() << ' ' << s.faces.size() << " 0\n";
    for (const auto& p : s.points) out << text_of(p) << '\n';
    for (const auto& f : s.faces) {
      out << f.size();
      for (int v : f) out << ' ' << v;
      out << '\n';
    }
  } else if (format == "obj") {
    for (const auto& p : s.points) out << "v " << text_of(p) << '\n';
    for (const auto& f : s.faces) {
      out << 'f';
      for (int v : f) out << ' ' << (v < 0 ? v : v + 1);
      out << '\n';
    }
  } else if (format == "stl") {
    out << "solid surface\n";
    for (const auto& f : s.faces) {
      out << "facet normal 0 0 0\nouter loop\n";
      for (int v : f) out << "vertex " << text_of(s.points[v]) << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid surface\n";
  } else if (format == "binary stl") {
    out << std::string(80, ' ') << bytes(static_cast<std::uint32_t>(s.faces.size()));
    for (const auto& f : s.faces) {
      out << std::string(12, '\0');
      for (int v : f)
        for (double x : s.points[v]) out << bytes(static_cast<float>(x));
      out << std::string(2, '\0');
    }
  } else {
    const bool ascii = format == "ply", big = format == "big-endian ply";
    out << "ply\nformat " << (ascii ? "ascii" : big ? "binary_big_endian" : "binary_little_endian") << " 1.0\n"
        << "element vertex " << s.points.size() << "\nproperty double x\nproperty double y\nproperty double z\n"
        << "element face " << s.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& p : s.points) {
      if (ascii) out << text_of(p) << '\n';
      else for (double x : p) out << (big ? big_endian_bytes(x) : bytes(x));
    }
    for (const auto& f : s.faces) {
      if (ascii) out << f.size();
      else out << static_cast<char>(f.size());
      for (int v : f) {
        if (ascii) out << ' ' << v;
        else out << (big ? big_endian_bytes(v) : bytes(v));
      }
      if (ascii) out << '\n';
    }
  }
  return out.str();
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACE_FILES_H
