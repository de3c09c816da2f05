// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Polygon_soup.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace CGAL {
namespace Quartic_differentials {

namespace {

struct Ply_property
{
  std::string name, type, size_type;   // size_type is empty unless the property is a list
};

struct Ply_element
{
  std::string               name;
  std::size_t               count;
  std::vector<Ply_property> properties;
};

[[noreturn]] void refuse(const std::string& reason)
{
  throw Unusable_surface_error("the file is not a mesh in ply format: " + reason);
}

std::size_t bytes(const std::string& type)
{
  static const std::map<std::string, std::size_t> size{
    {"char", 1}, {"int8", 1}, {"uchar", 1}, {"uint8", 1}, {"short", 2}, {"int16", 2}, {"ushort", 2}, {"uint16", 2},
    {"int", 4}, {"int32", 4}, {"uint", 4}, {"uint32", 4}, {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = size.find(type);
  if (found == size.end()) refuse("unknown type '" + type + "'");
  return found->second;
}

bool floating(const std::string& type)
{
  return type == "float" || type == "float32" || type == "double" || type == "float64";
}

// The header: elements with their properties, and the format (ascii, binary_little_endian, binary_big_endian).
std::vector<Ply_element> read_header(std::istream& in, std::string& format)
{
  std::vector<Ply_element> elements;
  std::string line, word;
  if (!std::getline(in, line) || line.compare(0, 3, "ply") != 0) refuse("it does not begin with 'ply'");
  while (std::getline(in, line)) {
    std::istringstream words(line);
    if (!(words >> word) || word == "comment" || word == "obj_info") continue;
    if (word == "end_header") return elements;
    if (word == "format") words >> format;
    else if (word == "element") {
      Ply_element e;
      if (!(words >> e.name >> e.count)) refuse("bad header line '" + line + "'");
      elements.push_back(e);
    } else if (word == "property") {
      Ply_property p;
      if (!(words >> p.type) || elements.empty()) refuse("bad header line '" + line + "'");
      if (p.type == "list") words >> p.size_type >> p.type;
      if (!(words >> p.name)) refuse("bad header line '" + line + "'");
      if (floating(p.size_type)) refuse("a list has a length of type '" + p.size_type + "'");
      elements.back().properties.push_back(p);
    }
  }
  refuse("its header does not end");
}

void check_coordinates(const std::vector<Ply_element>& elements)
{
  for (const Ply_element& e : elements) {
    if (e.name != "vertex" && e.name != "vertices") continue;
    for (const char* axis : {"x", "y", "z"})
      if (std::none_of(e.properties.begin(), e.properties.end(), [&](const Ply_property& p) {
            return p.name == axis && p.size_type.empty() && floating(p.type);
          }))
        refuse(std::string("its vertices have no ") + axis + " of floating point type");
    return;
  }
  refuse("it has no vertices");
}

// Reads the numbers of the body one after the other.
class Body
{
public:
  Body(const std::string& contents, std::size_t start, const std::string& format)
    : m_contents(contents), m_position(start), m_ascii(format == "ascii"), m_little(format == "binary_little_endian") {}

  void skip(std::size_t count, const std::string& type)
  {
    if (!m_ascii) {
      const std::size_t width = bytes(type);
      if (count > (m_contents.size() - m_position) / width) refuse("it is cut off");
      m_position += count * width;
    } else {
      for (std::size_t i = 0; i < count; ++i) next_word();
    }
  }

  std::size_t list_length(const std::string& type)
  {
    if (m_ascii) return static_cast<std::size_t>(std::strtoull(next_word().c_str(), nullptr, 10));
    const std::size_t begin = m_position, width = bytes(type);
    skip(1, type);
    std::size_t length = 0;
    for (std::size_t i = 0; i < width; ++i)
      length = 256 * length + static_cast<unsigned char>(m_contents[m_little ? begin + width - 1 - i : begin + i]);
    return length;
  }

private:
  std::string next_word()
  {
    const char* blank = " \t\r\n\v\f";
    const std::size_t begin = m_contents.find_first_not_of(blank, m_position);
    if (begin == std::string::npos) refuse("it is cut off");
    m_position = std::min(m_contents.find_first_of(blank, begin), m_contents.size());
    return m_contents.substr(begin, m_position - begin);
  }

  const std::string& m_contents;
  std::size_t        m_position;
  bool               m_ascii, m_little;
};

} // namespace

void check_ply_layout(const std::string& contents)
{
  std::istringstream in(contents);
  std::string format;
  const std::vector<Ply_element> elements = read_header(in, format);
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
    refuse("unknown format '" + format + "'");
  for (const Ply_element& e : elements) {
    if (e.properties.empty() && e.count > 0) refuse("element '" + e.name + "' has no property");
    for (const Ply_property& p : e.properties) {
      bytes(p.type);
      if (!p.size_type.empty()) bytes(p.size_type);
    }
  }
  check_coordinates(elements);

  if (!in) refuse("it is cut off");
  Body body(contents, in.tellg() < 0 ? contents.size() : static_cast<std::size_t>(in.tellg()), format);
  for (const Ply_element& e : elements)
    for (std::size_t i = 0; i < e.count; ++i)
      for (const Ply_property& p : e.properties)
        body.skip(p.size_type.empty() ? 1 : body.list_length(p.size_type), p.type);
}

} } // namespace CGAL::Quartic_differentials
