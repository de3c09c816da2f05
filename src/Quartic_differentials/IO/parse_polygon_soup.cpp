// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Polygon_soup.h"
#include "Vtk_poly_data.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace CGAL {
namespace Quartic_differentials {

namespace {

// A vector that cannot be resized to what only a broken file asks for: CGAL's readers allocate what a header announces.
template <class T>
struct Bounded_vector : std::vector<T>
{
  std::size_t limit = 1000000;
  Bounded_vector() = default;
  explicit Bounded_vector(std::size_t limit) : limit(limit) {}
  void resize(std::size_t n)
  {
    if (n > limit) throw Unusable_surface_error("the file announces more than it holds");
    std::vector<T>::resize(n);
  }
};

// CGAL's OFF reader looks up colours, normals and texture coordinates unchecked; without the letters that announce them,
// as in "STCNOFF", it skips them.
void drop_announcements(std::string& off)
{
  std::istringstream in(off);
  std::string line, keyword;
  std::size_t start = 0;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    if (words >> keyword && keyword[0] != '#') break;
    start = static_cast<std::size_t>(in.tellg());
  }
  std::size_t letters = keyword.compare(0, 2, "ST") == 0 ? 2 : 0;
  for (char letter : {'C', 'N'})
    if (letters < keyword.size() && keyword[letters] == letter) ++letters;
  const bool binary = line.find("BINARY") != std::string::npos;
  if (!binary && letters > 0) off.erase(off.find(keyword, start), letters);
}

std::string number_of_first_line_with_a_non_finite_number(const std::string& text)
{
  std::istringstream in(text);
  std::string line, word;
  for (int number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line);
    while (words >> word) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end == '\0' && !std::isfinite(value)) return std::to_string(number);
    }
  }
  return {};
}

template <class Polygons>
std::string place_where_reading_ended(const Polygons& polygons)
{
  const std::size_t read = std::count_if(polygons.begin(), polygons.end(), [](const auto& p) { return !p.empty(); });
  return read == 0 ? "before the first face" : "at or after face " + std::to_string(read - 1);
}

// CGAL's reader merges equal points with a map, in which a NaN would equal any point.
void check_binary_stl(const std::string& stl)
{
  std::uint32_t n = 0;
  if (stl.size() < 84) return;
  std::memcpy(&n, stl.data() + 80, 4);
  if (stl.size() != 84 + 50 * static_cast<std::size_t>(n)) return;    // not binary, or cut off: the reader says so
  for (std::size_t t = 0; t < n; ++t)
    for (int i = 0; i < 9; ++i) {
      float x;
      std::memcpy(&x, stl.data() + 84 + 50 * t + 12 + 4 * i, 4);
      if (!std::isfinite(x))
        throw Unusable_surface_error("face " + std::to_string(t) + " has a coordinate that is not a finite number");
    }
}

// Appends the triangles of a strip, every other one turned round.
void add_strip(const std::vector<std::size_t>& strip, std::vector<std::vector<std::size_t>>& triangles)
{
  for (std::size_t k = 0; k + 2 < strip.size(); ++k)
    triangles.push_back({strip[k + k % 2], strip[k + 1 - k % 2], strip[k + 2]});
}

Polygon_soup parse_vtp(const std::string& contents)
{
  try {
    const Vtk_poly_data file(contents);
    Polygon_soup soup;
    for (std::size_t piece = 0; piece < file.number_of_pieces(); ++piece) {
      const std::size_t first_point = soup.points.size(), first_polygon = soup.polygons.size();
      const std::vector<Point_3> points = file.points(piece);
      soup.points.insert(soup.points.end(), points.begin(), points.end());
      for (auto& polygon : file.cells(piece, "Polys")) soup.polygons.push_back(std::move(polygon));
      for (const auto& strip : file.cells(piece, "Strips")) add_strip(strip, soup.polygons);
      for (std::size_t f = first_polygon; f < soup.polygons.size(); ++f)
        for (std::size_t& v : soup.polygons[f]) v += first_point;
    }
    return soup;
  } catch (const Unusable_surface_error& e) {
    throw Unusable_surface_error(std::string("the file is not a mesh in vtp format: ") + e.what());
  }
}

} // namespace

Polygon_soup parse_polygon_soup(std::string contents, const std::string& format)
{
  if (format == "vtp") return parse_vtp(contents);
  if (format == "off") drop_announcements(contents);
  if (format == "ply") check_ply_layout(contents);
  if (format == "stl") check_binary_stl(contents);

  Bounded_vector<Point_3> points(contents.size() / 2);
  Bounded_vector<Bounded_vector<std::size_t>> polygons(contents.size() / 2);
  std::istringstream in(contents);
  const auto quiet = CGAL::parameters::verbose(false);
  bool understood = false;
  try {
    if (format == "off") understood = CGAL::IO::read_OFF(in, points, polygons, quiet);
    if (format == "obj") understood = CGAL::IO::read_OBJ(in, points, polygons, quiet);
    if (format == "ply") understood = CGAL::IO::read_PLY(in, points, polygons, quiet);
    if (format == "stl") understood = CGAL::IO::read_STL(in, points, polygons, quiet);
  } catch (const std::length_error&) {       // a negative or absurd number of corners
    understood = false;
  }
  if (!understood) {
    const std::string line = number_of_first_line_with_a_non_finite_number(contents);
    if (!line.empty()) throw Unusable_surface_error("line " + line + " holds a number that is not finite");
    throw Unusable_surface_error("the file is not a mesh in " + format + " format, is cut off, or refers to a vertex "
                                 "that does not exist: reading it ended " + place_where_reading_ended(polygons));
  }

  Polygon_soup soup;
  soup.points.assign(points.begin(), points.end());
  soup.polygons.reserve(polygons.size());
  for (const auto& p : polygons) soup.polygons.emplace_back(p.begin(), p.end());
  return soup;
}

} } // namespace CGAL::Quartic_differentials
