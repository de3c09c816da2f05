// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VERIFY_FLAT_H
#define CGAL_QUARTIC_DIFFERENTIALS_VERIFY_FLAT_H

#include "output_report.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace verification {

using Integer = boost::multiprecision::cpp_int;

struct Point { std::int64_t x, y; };

inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }

struct Corner { std::int64_t triangle = -1; int index = -1; };   // also an edge: the one that begins there

struct Flat_triangle
{
  std::array<std::int64_t, 3> vertex;
  std::array<Point, 3>        point;
  std::array<Corner, 3>       opposite;   // on the boundary none

  Point edge(int k) const { return point[(k + 1) % 3] - point[k]; }
  bool  is_border(int k) const { return opposite[k].triangle < 0; }
};

struct Flat
{
  int                        grid_exponent = 0;
  bool                       is_embedded = false;
  std::vector<Flat_triangle> triangles;
};

struct Flat_facts
{
  Integer                   doubled_area;   // in squared grid units
  int                       grid_exponent = 0;
  bool                      is_embedded = false;
  std::vector<std::int64_t> orders, corner_orders;   // sorted, without 0
};

/// of flat_intrinsic.json
Flat read_flat(const std::string& folder, bool is_closed);

std::size_t number_of_border_edges(const Flat& flat);

/// angles less the usual one, without 0, sorted
std::vector<std::int64_t> orders_of(const std::vector<std::int64_t>& angles, std::int64_t usual);

/// checks a flat triangulation for itself and against the report
/// \param name of the file, for the sentences
Flat_facts verify_flat(const std::string& name, const Flat& flat, const Report& report, Checks& checks);

} } } // namespace CGAL::Quartic_differentials::verification

#endif // CGAL_QUARTIC_DIFFERENTIALS_VERIFY_FLAT_H
