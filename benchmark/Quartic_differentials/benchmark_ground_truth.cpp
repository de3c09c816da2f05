// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors of Dirichlet products and periods on surfaces whose periods are known, under refinement. Prints a Markdown
// table; the numbers go to a file for plotting as well.

#include "ground_truth.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

using namespace Quartic_test;

namespace {

const double rounding = 1e-12;   // errors below it say nothing about refinement

std::string formatted(const char* format, double x)
{
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

std::string error_cell(double error) { return error < rounding ? "exact" : formatted("%.1e", error); }

std::string order_cell(double coarse, double fine, const Ground_truth_result& before, const Ground_truth_result& now)
{
  if (coarse < rounding || fine < rounding) return "–";
  return formatted("%.2f", observed_order(coarse, fine, before.faces, now.faces));
}

void print_header()
{
  std::cout << "| surface | g | faces | h | error of S | order | expected | error of Π | order | bracket width | star "
               "defect |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|" << std::endl;
}

void print_row(const Family& family, const std::optional<Ground_truth_result>& before, const Ground_truth_result& now)
{
  std::cout << "| " << family.name << " | " << now.genus << " | " << now.faces << " | " << formatted("%.3f", now.h)
            << " | " << error_cell(now.error()) << " | "
            << (before ? order_cell(before->error(), now.error(), *before, now) : "") << " | "
            << formatted("%.2f", family.expected_order) << " | " << error_cell(now.period_error()) << " | "
            << (before ? order_cell(before->period_error(), now.period_error(), *before, now) : "") << " | "
            << error_cell(now.bracket_width()) << " | " << error_cell(now.star_defect) << " |" << std::endl;
}

// A block for gnuplot, which takes "?" for a missing value.
void write_row(std::ostream& data, const Ground_truth_result& r)
{
  const auto value = [](double error) { return error < rounding ? std::string("?") : formatted("%.6e", error); };
  data << r.faces << ' ' << value(r.error()) << ' ' << value(r.period_error()) << '\n';
}

void measure(const Family& family, int fewer, std::ostream& data)
{
  data << "# " << family.name << '\n';
  std::optional<Ground_truth_result> before;
  for (int level = family.first_level; level <= family.last_level - fewer; ++level) {
    const Ground_truth_result now = compare_with_truth(family.at_level(level));
    if (!now.cycles_are_exact) throw std::runtime_error(family.name + ": the cycles are not what they should be");
    print_row(family, before, now);
    write_row(data, now);
    before = now;
  }
  data << "\n\n";
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Errors of Dirichlet products and periods on surfaces whose periods are known, under refinement."};
  std::string file;
  int fewer = 0;
  app.add_option("--data", file, "Also write faces, error of S and error of Pi to this file, a block for each surface");
  app.add_option("--fewer", fewer, "How many of the five levels of refinement to leave out, finest first (0)")
     ->check(CLI::Range(0, 4));
  CLI11_PARSE(app, argc, argv);

  try {
    std::ofstream data(file);
    data << "# faces, error of S, error of Pi; ? for rounding errors\n\n\n";
    print_header();
    for (const Family& family : ground_truth_families()) measure(family, fewer, data);
    data.close();
    if (!file.empty() && !data) throw std::runtime_error(file + " cannot be written");
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
