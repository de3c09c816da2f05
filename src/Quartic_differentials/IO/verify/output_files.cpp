// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output_files.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

bool has_file(const std::string& folder, const std::string& name)
{
  std::error_code error;
  return std::filesystem::is_regular_file(folder + "/" + name, error);   // a pipe might never end
}

Json read_json(const std::string& folder, const std::string& name)
{
  if (!has_file(folder, name)) throw Malformed("the file cannot be opened");
  std::ifstream in(folder + "/" + name);
  try { return Json::parse(in); }
  catch (const Json::exception&) { throw Malformed("the file is not JSON, or cut off"); }
}

const Json& member(const Json& object, const char* key)
{
  if (!object.is_object() || !object.contains(key)) throw Malformed(std::string("\"") + key + "\" is missing");
  return object[key];
}

const Json& array(const Json& value, const std::string& what)
{
  if (!value.is_array()) throw Malformed(what + " is not an array");
  return value;
}

const Json& array_of_size(const Json& value, std::size_t size, const std::string& what)
{
  if (array(value, what).size() != size) throw Malformed(what + " does not have " + std::to_string(size) + " entries");
  return value;
}

std::int64_t integer(const Json& value, std::int64_t least, std::int64_t greatest, const std::string& what)
{
  if (!value.is_number_integer()) throw Malformed(what + " is not an integer of 64 bits");
  const bool beyond = value.is_number_unsigned()
                   && value.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (beyond || value.get<std::int64_t>() < least || value.get<std::int64_t>() > greatest)
    throw Malformed(what + " is out of range");
  return value.get<std::int64_t>();
}

std::string string(const Json& value, const std::string& what)
{
  if (!value.is_string()) throw Malformed(what + " is not a string");
  return value.get<std::string>();
}

Position position(const Json& value, const std::string& what)
{
  Position p;
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& x = array_of_size(value, 3, what)[k];
    if (!x.is_number() || !std::isfinite(x.get<double>())) throw Malformed(what + " is not three finite numbers");
    p[k] = x.get<double>();
  }
  return p;
}

} } } // namespace CGAL::Quartic_differentials::verification
