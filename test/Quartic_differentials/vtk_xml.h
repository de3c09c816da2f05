// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_VTK_XML_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_VTK_XML_H

// Arrays in VTK's XML, written as text, read number by number.

#include "check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace Quartic_test {

inline bool is_identical(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

// the numbers of the data array with this in its tag
inline std::vector<double> data_array(const std::string& file, const std::string& attribute)
{
  const std::size_t tag = file.find(attribute);
  CHECK(tag != std::string::npos);
  std::vector<double> numbers;
  if (tag == std::string::npos) return numbers;
  const char* text = file.c_str() + file.find('>', tag) + 1;
  for (char* end = nullptr; ; text = end) {
    const double x = std::strtod(text, &end);
    if (end == text) break;
    numbers.push_back(x);
  }
  CHECK_EQUAL(std::string(text, 13), "\n</DataArray>");
  return numbers;
}

template <class Values>
void check_data(const std::string& file, const std::string& name, const Values& values)
{
  const std::vector<double> read = data_array(file, "Name=\"" + name + "\"");
  CHECK_EQUAL(read.size(), values.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(read.size(), values.size()); ++i)
    CHECK(is_identical(read[i], static_cast<double>(values[i])));
}

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_VTK_XML_H
