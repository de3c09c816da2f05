// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_PROGRESS_H
#define QUARTIC_PROGRESS_H

#include <CGAL/Quartic_differentials/Visitor.h>

#include <chrono>

/// Tells on the error stream what happens in steps that take longer than two seconds.
class Progress : public CGAL::Quartic_differentials::Visitor
{
public:
  explicit Progress(bool quiet) : m_quiet(quiet) {}

  void step_begins(const std::string& name) override;
  void step_ends(const std::string& name, double seconds) override;
  void progress(const std::string& message) override;

private:
  using Clock = std::chrono::steady_clock;

  bool              m_quiet;
  std::string       m_step;
  Clock::time_point m_begin = Clock::now();
};

#endif // QUARTIC_PROGRESS_H
