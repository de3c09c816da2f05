// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exit_status.h"

#include <algorithm>
#include <new>

namespace QD = CGAL::Quartic_differentials;

Failure failure_of(const std::exception_ptr& error)
{
  try {
    std::rethrow_exception(error);
  } catch (const Failed_components& e) {
    return {e.worst, e.what()};
  } catch (const QD::Unusable_surface_error& e) {
    return {unusable_input, e.what()};
  } catch (const QD::Infeasible_divisor_error& e) {
    return {unusable_input, e.what()};
  } catch (const QD::Numerical_error& e) {
    return {numerical_failure, e.what()};
  } catch (const QD::Error& e) {          // a file that cannot be written
    return {usage, e.what()};
  } catch (const std::bad_alloc&) {
    return {numerical_failure, "there is not enough memory for this"};
  } catch (const std::exception& e) {     // an error in the program
    return {numerical_failure, e.what()};
  }
}

std::string one_line(std::string text)
{
  const std::size_t most = 500;
  if (text.size() > most) text = text.substr(0, most) + " ...";
  std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return text;
}
