// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_CHECK_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_CHECK_H

// Checks that stay on in every type of build. A failed check prints its place and the test goes on;
// `return Quartic_test::result();` ends main() and fails as well if no check was run at all.

#include <cstdlib>
#include <iostream>
#include <string>

namespace Quartic_test {

inline int& checks()   { static int n = 0; return n; }
inline int& failures() { static int n = 0; return n; }

/// exit status of a test that needs something that is not there (ctest reports it as skipped)
constexpr int skipped = 77;

inline std::ostream& failure(const char* file, int line)
{
  ++failures();
  return std::cerr << file << ':' << line << ": ";
}

inline void check(bool holds, const char* condition, const char* file, int line)
{
  ++checks();
  if (!holds) failure(file, line) << "does not hold: " << condition << std::endl;
}

template <class A, class B>
void check_equal(const A& a, const B& b, const char* condition, const char* file, int line)
{
  ++checks();
  if (!(a == b)) failure(file, line) << condition << ": " << a << " != " << b << std::endl;
}

inline void check_near(double a, double b, double tolerance, const char* condition, const char* file, int line)
{
  ++checks();
  if (!(a - b <= tolerance && b - a <= tolerance))
    failure(file, line) << condition << ": " << a << " and " << b << " differ by " << a - b << std::endl;
}

/// the value of an environment variable, "" where it is not set
inline std::string environment(const char* name)
{
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

inline int result()
{
  if (checks() == 0) std::cerr << "no check was run" << std::endl;
  std::cout << checks() << " checks, " << failures() << " failed" << std::endl;
  return checks() > 0 && failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace Quartic_test

#define CHECK(condition) Quartic_test::check(static_cast<bool>(condition), #condition, __FILE__, __LINE__)
#define CHECK_EQUAL(a, b) Quartic_test::check_equal((a), (b), #a " == " #b, __FILE__, __LINE__)
#define CHECK_NEAR(a, b, tolerance) Quartic_test::check_near((a), (b), (tolerance), #a " ~ " #b, __FILE__, __LINE__)

/// the expression throws `exception` with `part` in its message
#define CHECK_THROWS(expression, exception, part)                                                                    \
  do {                                                                                                               \
    std::string message = "nothing was thrown";                                                                      \
    try { (void)(expression); } catch (const exception& e) { message = e.what(); }                                   \
    ++Quartic_test::checks();                                                                                        \
    if (message.find(part) == std::string::npos)                                                                     \
      Quartic_test::failure(__FILE__, __LINE__) << #expression << ": expected \"" << part << "\", got \"" << message \
                                                << '"' << std::endl;                                                 \
  } while (false)

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_CHECK_H
