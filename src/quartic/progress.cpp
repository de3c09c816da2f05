// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "progress.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace {

const double worth_telling = 2;   // seconds

// the report's key as words: t_mesh is "t mesh"
std::string words(std::string name)
{
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

} // namespace

void Progress::step_begins(const std::string& name)
{
  m_step = name;
  m_begin = Clock::now();
}

void Progress::step_ends(const std::string& name, double seconds)
{
  if (m_quiet || seconds < worth_telling) return;
  std::cerr << words(name) << ": done in " << std::round(10 * seconds) / 10 << " s" << std::endl;
}

void Progress::progress(const std::string& message)
{
  if (m_quiet || std::chrono::duration<double>(Clock::now() - m_begin).count() < worth_telling) return;
  std::cerr << words(m_step) << ": " << message << std::endl;
}
