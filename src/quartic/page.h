// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_PAGE_H
#define QUARTIC_PAGE_H

#include "report.h"

#include <iosfwd>

/// writes `report.html`: one page that shows a run, also one that failed, and asks for nothing else to be loaded.
/// \param model what `page_model()` made of the result
/// \param report what `run_report()` made of it, which is embedded as it is
void write_page(std::ostream& out, const Run_facts& facts, const Json& model, const Json& report);

#endif // QUARTIC_PAGE_H
