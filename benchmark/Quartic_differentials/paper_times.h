// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_PAPER_TIMES_H
#define CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_PAPER_TIMES_H

#include "measure.h"

#include <cctype>
#include <string>

/// A row of the paper's table 1, "Running time", in seconds on an Intel Core i5-8250U at 1.60 GHz; NaN: not given.
/// Source: X. Zheng, Y. Zhu, N. Lei, Z. Luo and X. Gu, Quadrilateral Mesh Generation III: Optimizing Singularity
/// Configuration Based on Abel-Jacobi Theory.
struct Paper_times
{
  const char* model;
  double      kilovertices, kilofaces;
  int         genus;
  double      holomorphic_forms, zeros, legalization, ricci_flow, immersion;
};

constexpr Paper_times paper_times[] = {
  {"Kitten",     10.2,  20.4, 1,  10.247, not_given, 0.002,   0.013, 0.006},
  {"Ornament",   28.8,  57.7, 1,  47.954, not_given, 0.005,   6.177, 0.014},
  {"Rockerarm",  40.2,  80.4, 1,  39.014, not_given, 0.004,  12.134, 0.021},
  {"Dancer",     43.0,  86.0, 1,  43.913, not_given, 0.005, 10.0659, 0.027},
  {"Bull",       75.8, 151.5, 1,  95.904, not_given, 0.003,  18.160, 0.054},
  {"Sculpt",      4.0,   8.0, 2,   4.828,     0.029, 0.052,   1.485, 0.002},
  {"Starcup",    30.0,  60.0, 2,  51.682,     0.301, 0.005,   6.654, 0.013},
  {"Monk",       38.5,  77.0, 2,  86.741,     4.037, 0.108,   8.624, 0.022},
  {"Hermanubis", 39.9,  79.9, 2,  96.122,     1.441, 0.043,  10.370, 0.025},
  {"Amphora",    82.6, 164.3, 2, 174.396,     0.883, 0.016, 21.4288, 0.046},
  {"Loveme",     86.7, 173.5, 2, 191.663,     1.156, 0.020, 25.7747, not_given},   // printed as "0.0.57"
  {"Buddha",     59.4, 118.7, 3, 179.568,     2.623, 2.021,  13.117, 0.026},
  {"2Kids",      61.7, 123.5, 3, 201.353,     6.274, 0.546,  14.633, 0.027},
  {"3Holes",     65.0, 130.0, 3, 218.954,     0.819, 0.9333, 16.756, 0.032},
  {"Witch",      75.0, 150.0, 4, 363.533,    10.877, 1.033,  20.343, 0.051},
};

/// the paper's row for a mesh whose name begins with the word that names the model, in either case
/// ("rockerarm_20k"), and whose genus is the model's; null if there is none.
inline const Paper_times* paper_times_of(const std::string& mesh, int genus)
{
  std::string word;
  for (char c : mesh) {
    if (!std::isalnum(static_cast<unsigned char>(c))) break;
    word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (const Paper_times& row : paper_times) {
    std::string model = row.model;
    for (char& c : model) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (model == word && row.genus == genus) return &row;
  }
  return nullptr;
}

#endif // CGAL_QUARTIC_DIFFERENTIALS_BENCHMARK_PAPER_TIMES_H
