// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/read_obj.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

double number(const char*& text, const char* what)
{
  char* end = nullptr;
  const double x = std::strtod(text, &end);
  if (end == text || !std::isfinite(x)) throw Unusable_surface_error(std::string(what) + " is not a finite number");
  text = end;
  return x;
}

std::size_t index(const char*& text, std::size_t size)
{
  char* end = nullptr;
  const unsigned long long i = std::strtoull(text, &end, 10);
  if (end == text || i < 1 || i > size) throw Unusable_surface_error("a face refers to what is not there");
  text = end;
  return static_cast<std::size_t>(i - 1);
}

void end_of_line(const char* text, const char* what)
{
  if (text[std::strspn(text, " \t\r")] != '\0') throw Unusable_surface_error(what);
}

Obj_file::Element element(const char* text, const Obj_file& file, const std::string& group)
{
  Obj_file::Element e;
  e.group = group;
  while (*(text += std::strspn(text, " \t\r")) != '\0') {
    e.vertices.push_back(index(text, file.points.size()));
    if (*text == '/') e.texture.push_back(index(++text, file.texture.size()));
  }
  if (!e.texture.empty() && e.texture.size() != e.vertices.size())
    throw Unusable_surface_error("a corner of a face has no texture vertex");
  return e;
}

} // namespace

Obj_file read_obj(const std::string& path)
{
  std::ifstream in(path);
  if (!in) throw Unusable_surface_error("the file cannot be opened");
  Obj_file file;
  const std::set<std::string> other{"", "\r", "mtllib", "usemtl"};
  std::string line, group;
  while (std::getline(in, line)) {
    if (in.eof() || line.find('\0') != std::string::npos)
      throw Unusable_surface_error("the file is not text, or cut off");
    const std::size_t blank = std::min(line.find(' '), line.size());
    const std::string keyword = line.substr(0, blank);
    const char* text = line.c_str() + blank;
    if (keyword == "v") {
      const double x = number(text, "a coordinate"), y = number(text, "a coordinate"), z = number(text, "a coordinate");
      end_of_line(text, "a vertex does not have three coordinates");
      file.points.emplace_back(x, y, z);
    } else if (keyword == "vt") {
      const double u = number(text, "a texture coordinate"), v = number(text, "a texture coordinate");
      end_of_line(text, "a texture vertex does not have two coordinates");
      file.texture.push_back({u, v});
    } else if (keyword == "f") {
      file.faces.push_back(element(text, file, group));
    } else if (keyword == "l") {
      file.lines.push_back(element(text, file, group));
    } else if (keyword == "g") {
      group = line.substr(std::min(blank + 1, line.size()));
      group.erase(group.find_last_not_of(" \t\r") + 1);
    } else if (!other.count(keyword) && line[0] != '#') {
      throw Unusable_surface_error("a line is of no kind that a run writes");
    }
  }
  return file;
}

} } } // namespace CGAL::Quartic_differentials::internal
