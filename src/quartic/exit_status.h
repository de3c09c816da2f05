// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_EXIT_STATUS_H
#define QUARTIC_EXIT_STATUS_H

#include <CGAL/Quartic_differentials/exceptions.h>

#include <exception>
#include <string>

/// of the program; of several, the worst is the greatest
enum Exit_status { done = 0, usage = 1, unusable_input = 2, numerical_failure = 3 };

/// How the program ends, and the sentence why.
struct Failure
{
  Exit_status status;
  std::string message;
};

Failure failure_of(const std::exception_ptr& error);

/// Some components of a surface have failed, and the sentences why have been said.
struct Failed_components : CGAL::Quartic_differentials::Error
{
  Exit_status worst;

  Failed_components(const std::string& what, Exit_status worst_) : Error(what), worst(worst_) {}
};

/// What is quoted from files may be long, and may hold line ends and codes that control terminals.
std::string one_line(std::string text);

#endif // QUARTIC_EXIT_STATUS_H
