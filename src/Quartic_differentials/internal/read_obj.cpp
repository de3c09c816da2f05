// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/read_obj.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
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

std::size_t patch_of(const std::string& group)
{
  const std::string begin = "patch_";
  if (group.empty()) throw Unusable_surface_error("a quad is not in a group");
  std::size_t patch = most_patches + 1;   // stays so where the number does not fit
  const char* const end = group.data() + group.size();
  if (group.compare(0, begin.size(), begin) != 0
      || std::from_chars(group.data() + begin.size(), end, patch).ptr != end || group.size() == begin.size()
      || patch > most_patches)
    throw Unusable_surface_error("a group does not have the name of a patch");
  return patch;
}

} // namespace

Obj_file read_obj(const std::string& path)
{
  std::error_code error;
  std::ifstream in;
  if (std::filesystem::is_regular_file(path, error)) in.open(path);   // a pipe might never end
  if (!in.is_open()) throw Unusable_surface_error("the file cannot be opened");
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

Quads_obj read_quads_obj(const std::string& path)
{
  const Obj_file file = read_obj(path);
  if (!file.lines.empty() || !file.texture.empty())
    throw Unusable_surface_error("a line is neither a vertex, nor a group, nor a quad");
  Quads_obj result{file.points, {}, {}};
  for (const Obj_file::Element& face : file.faces) {
    if (face.vertices.size() != 4) throw Unusable_surface_error("a face is not a quad");
    result.quads.push_back({face.vertices[0], face.vertices[1], face.vertices[2], face.vertices[3]});
    result.patch.push_back(patch_of(face.group));
  }
  if (result.quads.empty()) throw Unusable_surface_error("there is no quad");
  return result;
}

} } } // namespace CGAL::Quartic_differentials::internal
