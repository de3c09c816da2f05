// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/surface_json.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <nlohmann/json.hpp>

#include <limits>
#include <ostream>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using nlohmann::json;

const json& member(const json& object, const char* name)
{
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array())
    throw Unusable_surface_error(std::string("the surface has no list '") + name + "'");
  return *found;
}

template <std::size_t n>
const json& list_of(const json& value, const std::string& place)
{
  if (!value.is_array() || value.size() != n)
    throw Unusable_surface_error(place + " is not a list of " + std::to_string(n));
  return value;
}

// a number or a word as it is written; of what may be nested without end only what it is
std::string shown(const json& value)
{ return value.is_array() ? "a list" : value.is_object() ? "an object" : value.dump(); }

// below `limit`, so that a broken id cannot ask for memory without end
int index(const json& value, std::size_t limit, const std::string& place)
{
  if (!value.is_number_unsigned() || value.get<std::size_t>() >= limit)
    throw Unusable_surface_error(place + " holds " + shown(value) + ", which is not an index below "
                                 + std::to_string(limit));
  return value.get<int>();
}

double number(const json& value, const std::string& place)
{
  if (!value.is_number()) throw Unusable_surface_error(place + " holds " + shown(value) + ", which is not a number");
  return value.get<double>();
}

} // namespace

Glued_triangles read_surface_json(const std::string& text)
{
  json file;
  try {
    file = json::parse(text);
  } catch (const json::exception& e) {
    throw Unusable_surface_error(std::string("the file is not JSON: ") + e.what());
  }
  if (!file.is_object()) throw Unusable_surface_error("the file is JSON, but not an object");

  Glued_triangles s;
  const json& triangles = member(file, "triangles");
  const json& opposite = member(file, "opposite");
  const json& lengths = member(file, "lengths");
  const std::size_t n = triangles.size();
  if (opposite.size() != n || lengths.size() != n)
    throw Unusable_surface_error("the lists triangles, opposite and lengths differ in length");
  if (n > std::numeric_limits<int>::max() / 3) throw Unusable_surface_error("the surface has too many triangles");

  s.triangles.resize(n);
  s.opposite.resize(n);
  s.lengths.resize(n);
  for (std::size_t t = 0; t < n; ++t) {
    const std::string in_triangles = "triangles[" + std::to_string(t) + "]";
    const std::string in_opposite = "opposite[" + std::to_string(t) + "]";
    const std::string in_lengths = "lengths[" + std::to_string(t) + "]";
    list_of<3>(triangles[t], in_triangles);
    list_of<3>(opposite[t], in_opposite);
    list_of<3>(lengths[t], in_lengths);
    for (std::size_t e = 0; e < 3; ++e) {
      const json& glued_to = list_of<2>(opposite[t][e], in_opposite);
      s.triangles[t][e] = index(triangles[t][e], 3 * n, in_triangles);
      if (glued_to == json{-1, -1}) s.opposite[t][e] = {-1, -1};
      else s.opposite[t][e] = {index(glued_to[0], n, in_opposite), index(glued_to[1], 3, in_opposite)};
      s.lengths[t][e] = number(lengths[t][e], in_lengths);
    }
  }
  return s;
}

void write_surface_json(std::ostream& out, const Glued_triangles& s)
{
  const json file{{"triangles", s.triangles}, {"opposite", s.opposite}, {"lengths", s.lengths}};
  out << file << '\n';
}

} } // namespace CGAL::Quartic_differentials
