// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_PAGE_FILES_H
#define QUARTIC_PAGE_FILES_H

/// The files of src/quartic/page, and three.js, as CMake put them into the program.
struct Page_files
{
  static const char* const html;        ///< with {{places}} for what differs between runs
  static const char* const style;
  static const char* const three;       ///< three.js with its controls and wide lines; empty where it was not found
  static const char* const scripts;     ///< what draws the page
};

#endif // QUARTIC_PAGE_FILES_H
