// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TEXT_WRITER_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TEXT_WRITER_H

#include <CGAL/Quartic_differentials/exceptions.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// Writes text and numbers to a stream through a buffer of its own, independently of the locale; a double is written
/// with the fewest digits that read back to the identical double.
/// `finish()` must be called at the end.
class Text_writer
{
public:
  explicit Text_writer(std::ostream& out) : m_out(out) { m_buffer.reserve(2 * flush_at); }

  Text_writer& operator<<(char c) { m_buffer.push_back(c); return *this; }
  Text_writer& operator<<(std::string_view s)
  {
    m_buffer.append(s);
    if (m_buffer.size() > flush_at) finish();
    return *this;
  }
  template <class Number, class = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Text_writer& operator<<(Number x)
  {
    char digits[32];
    const char* end = std::to_chars(digits, digits + sizeof digits, x).ptr;
    return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
  }

  void finish()
  {
    m_out.write(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
    m_buffer.clear();
  }

private:
  static constexpr std::size_t flush_at = 1 << 16;
  std::ostream& m_out;
  std::string   m_buffer;
};

/// writes the coordinates of a point
template <class Point>
void write_point(Text_writer& out, const Point& p, char separator)
{
  out << p.x() << separator << p.y() << separator << p.z();
}

/// what stands before element k of a list
inline std::string_view comma(std::size_t k) { return k == 0 ? "" : ","; }

/// calls `make(part)`, which makes a file of that name, and gives it its final name. It is removed if that fails; links of
/// either name are replaced, not followed.
/// \throws Error if the file cannot get its name, and what `make` throws
template <class Make>
void make_file(const std::string& path, const std::string& part, Make make)
{
  namespace fs = std::filesystem;
  std::error_code error;
  fs::remove(part, error);
  try {
    make(part);
    fs::rename(part, path, error);
    if (error) throw Error("cannot give " + part + " its final name");
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
}

/// opens a file, calls `write(out)` and closes it. The file has another name until it is whole.
/// \throws Error if the file cannot be written to its end
template <class Write>
void write_file(const std::string& path, Write write)
{
  make_file(path, path + ".part", [&](const std::string& part) {
    std::ofstream out(part, std::ios::binary);
    if (!out) throw Error("cannot open " + part + " for writing");
    write(out);
    out.close();
    if (!out) throw Error("cannot write " + part + " to its end");
  });
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_TEXT_WRITER_H
