// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VISITOR_H
#define CGAL_QUARTIC_DIFFERENTIALS_VISITOR_H

#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// Reports the progress of a run and can stop it. The default does nothing and never stops.
class Visitor
{
public:
  virtual ~Visitor() = default;

  /// is called when a step of the pipeline begins; `name` is its key in the report's timings.
  virtual void step_begins(const std::string& /*name*/) {}

  /// is called when a step ends; `seconds` is its wall-clock time. Must not throw.
  virtual void step_ends(const std::string& /*name*/, double /*seconds*/) {}

  /// is called inside iterative steps with one line for a person.
  virtual void progress(const std::string& /*message*/) {}

  /// is polled between iterations; returning `false` ends the run with `Cancelled_error`.
  virtual bool go_further() { return true; }
};

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_VISITOR_H
