// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_OPTION_CHECKS_H
#define QUARTIC_OPTION_CHECKS_H

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

// Checks of options with real numbers. CLI::Range and CLI::PositiveNumber let "nan" pass.

/// from `least` to `most`, both allowed
inline CLI::Validator number_between(double least, double most)
{
  std::ostringstream range;
  range << "in [" << least << " - " << most << ']';
  return {[least, most, text = range.str()](std::string& value) {
            double x = 0;
            const bool holds = CLI::detail::lexical_cast(value, x) && least <= x && x <= most;
            return holds ? std::string() : value + " is not a number " + text;
          }, range.str()};
}

/// greater than 0 and finite
inline CLI::Validator positive_number()
{
  return {[](std::string& value) {
            double x = 0;
            const bool holds = CLI::detail::lexical_cast(value, x) && x > 0 && std::isfinite(x);
            return holds ? std::string() : value + " is not a positive number";
          }, "POSITIVE"};
}

/// a name that is not empty
inline CLI::Validator some_name()
{
  return {[](std::string& value) { return std::string(value.empty() ? "a name is missing" : ""); }, ""};
}

#endif // QUARTIC_OPTION_CHECKS_H
