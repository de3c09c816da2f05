// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TIMED_STEP_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TIMED_STEP_H

#include <CGAL/Quartic_differentials/Visitor.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// tells the visitor when a step begins and, however it is left, ends.
class Timed_step
{
public:
  Timed_step(Visitor& visitor, std::string name) : m_visitor(visitor), m_name(std::move(name))
  { m_visitor.step_begins(m_name); }
  ~Timed_step()
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - m_begin;
    m_visitor.step_ends(m_name, seconds.count());
  }
  Timed_step(const Timed_step&) = delete;
  Timed_step& operator=(const Timed_step&) = delete;

private:
  Visitor&                              m_visitor;
  std::string                           m_name;
  std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

/// passes everything on to another visitor and keeps the seconds of every step.
class Timing_visitor : public Visitor
{
public:
  Timing_visitor(Visitor& next, std::vector<std::pair<std::string, double>>& timings)
    : m_next(next), m_timings(timings) {}

  void step_begins(const std::string& name) override { m_next.step_begins(name); }
  void step_ends(const std::string& name, double seconds) override
  {
    m_timings.emplace_back(name, seconds);
    m_next.step_ends(name, seconds);
  }
  void progress(const std::string& message) override { m_next.progress(message); }
  bool go_further() override { return m_next.go_further(); }

private:
  Visitor&                                     m_next;
  std::vector<std::pair<std::string, double>>& m_timings;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TIMED_STEP_H
