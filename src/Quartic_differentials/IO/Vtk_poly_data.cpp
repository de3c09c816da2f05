// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Vtk_poly_data.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <boost/endian/conversion.hpp>
#include <pugixml.hpp>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Quartic_differentials {

namespace {

[[noreturn]] void refuse(const std::string& reason) { throw Unusable_surface_error(reason); }

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

// Bytes one after the other.
class Byte_reader
{
public:
  Byte_reader(std::string_view text, bool is_base64) : m_text(text), m_is_base64(is_base64) {}

  std::string read(std::size_t n)
  {
    if (n > most_bytes_left()) refuse("an array is cut off: it announces more than the file holds");
    std::string bytes;
    if (!m_is_base64) {
      bytes = m_text.substr(0, n);
      m_text.remove_prefix(n);
      return bytes;
    }
    while (m_decoded.size() < n) decode_four();
    bytes = m_decoded.substr(0, n);
    m_decoded.erase(0, n);
    return bytes;
  }

private:
  std::size_t most_bytes_left() const
  { return m_is_base64 ? m_text.size() / 4 * 3 + m_decoded.size() : m_text.size(); }

  // Four characters are three bytes, or less if padded; after padding another run begins.
  void decode_four()
  {
    unsigned bits = 0;
    int padding = 0;
    for (int k = 0; k < 4; ++k) {
      while (!m_text.empty() && is_blank(m_text.front())) m_text.remove_prefix(1);
      if (m_text.empty()) refuse("an array is cut off: it announces more than the file holds");
      const char c = m_text.front();
      m_text.remove_prefix(1);
      padding += c == '=';
      bits = bits << 6 | (c == '=' ? 0 : digit(c));
    }
    for (int k = 2; k >= std::min(padding, 2); --k) m_decoded.push_back(static_cast<char>(bits >> 8 * k & 255));
  }
  static unsigned digit(char c)
  {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t value = digits.find(c);
    if (value == std::string::npos) refuse("an array holds a character that is not one of base64");
    return static_cast<unsigned>(value);
  }

  std::string_view m_text;
  std::string      m_decoded;
  bool             m_is_base64;
};

// How the file writes numbers.
struct Encoding
{
  bool        is_little_endian = true, is_compressed = false;
  std::size_t header_width = 4;   // bytes of the numbers before an array

  template <class Number>
  Number number(const char* bytes) const
  {
    namespace endian = boost::endian;
    const auto* const p = reinterpret_cast<const unsigned char*>(bytes);
    return is_little_endian ? endian::endian_load<Number, sizeof(Number), endian::order::little>(p)
                            : endian::endian_load<Number, sizeof(Number), endian::order::big>(p);
  }

  std::size_t header_item(Byte_reader& in) const
  {
    const std::string bytes = in.read(header_width);
    return header_width == 8 ? number<std::uint64_t>(bytes.data()) : number<std::uint32_t>(bytes.data());
  }
};

std::string inflated(const std::string& compressed, std::size_t size)
{
  if (size / 1032 > compressed.size()) refuse("a compressed array announces more than it holds");
  std::string bytes(size, '\0');
  uLongf length = static_cast<uLongf>(size);
  const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                                reinterpret_cast<const Bytef*>(compressed.data()), static_cast<uLong>(compressed.size()));
  if (status != Z_OK || length != size) refuse("a compressed array is broken");
  return bytes;
}

// The number of blocks, their size, that of the last if it is another, and the sizes of all when they are compressed.
std::string read_compressed(Byte_reader& in, const Encoding& encoding)
{
  const std::size_t blocks = encoding.header_item(in), size = encoding.header_item(in), last = encoding.header_item(in);
  std::vector<std::size_t> compressed_size;
  for (std::size_t b = 0; b < blocks; ++b) compressed_size.push_back(encoding.header_item(in));
  std::string bytes;
  for (std::size_t b = 0; b < blocks; ++b)
    bytes += inflated(in.read(compressed_size[b]), b + 1 == blocks && last > 0 ? last : size);
  return bytes;
}

std::string read_array(Byte_reader in, const Encoding& encoding)
{
  return encoding.is_compressed ? read_compressed(in, encoding) : in.read(encoding.header_item(in));
}

template <class Result, class Number>
std::vector<Result> converted(const std::string& bytes, const Encoding& encoding)
{
  if (bytes.size() % sizeof(Number) != 0) refuse("an array does not hold whole numbers of its type");
  std::vector<Result> result;
  result.reserve(bytes.size() / sizeof(Number));
  for (std::size_t k = 0; k < bytes.size(); k += sizeof(Number))
    result.push_back(static_cast<Result>(encoding.number<Number>(bytes.data() + k)));
  return result;
}

template <class Result>
std::vector<Result> numbers_of_type(const std::string& type, const std::string& bytes, const Encoding& encoding)
{
  if (type == "Int64") return converted<Result, std::int64_t>(bytes, encoding);
  if (type == "Int32") return converted<Result, std::int32_t>(bytes, encoding);
  if (type == "Int16") return converted<Result, std::int16_t>(bytes, encoding);
  if (type == "Int8") return converted<Result, std::int8_t>(bytes, encoding);
  if (type == "UInt64") return converted<Result, std::uint64_t>(bytes, encoding);
  if (type == "UInt32") return converted<Result, std::uint32_t>(bytes, encoding);
  if (type == "UInt16") return converted<Result, std::uint16_t>(bytes, encoding);
  if (type == "UInt8") return converted<Result, std::uint8_t>(bytes, encoding);
  if constexpr (std::is_floating_point_v<Result>) {
    if (type == "Float64") return converted<Result, double>(bytes, encoding);
    if (type == "Float32") return converted<Result, float>(bytes, encoding);
  }
  refuse("an array has the type '" + type + "', which is not one for it");
}

template <class Number>
std::vector<Number> numbers_in_text(std::string_view text)
{
  std::vector<Number> result;
  const char *at = text.data(), *const end = at + text.size();
  while ((at = std::find_if_not(at, end, is_blank)) != end) {
    const std::from_chars_result read = std::from_chars(at, end, result.emplace_back());
    if (read.ec != std::errc() || (read.ptr != end && !is_blank(*read.ptr)))
      refuse("something is not a finite number");
    at = read.ptr;
  }
  return result;
}

std::size_t count(const pugi::xml_node& node, const std::string& attribute)
{
  const std::vector<std::size_t> read = numbers_in_text<std::size_t>(node.attribute(attribute.c_str()).value());
  if (read.size() > 1) refuse("the attribute " + attribute + " is not a number");
  return read.empty() ? 0 : read[0];
}

} // namespace

struct Vtk_poly_data::File
{
  explicit File(const std::string& contents)
  {
    const std::size_t element = contents.find("<AppendedData"), begin = contents.find('>', element);
    std::string text = contents;
    if (element != std::string::npos && begin != std::string::npos) {   // what follows need not be XML
      text = contents.substr(0, begin + 1) + "</AppendedData></VTKFile>";
      const std::size_t underscore = contents.find('_', begin);
      if (underscore == std::string::npos) refuse("the appended data do not begin with an underscore");
      appended = contents.substr(underscore + 1);
    }
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) refuse(std::string("this is not VTK's XML: ") + parsed.description());
    read_head(document.child("VTKFile"));
  }

  void read_head(const pugi::xml_node& root)
  {
    if (!root) refuse("this is not VTK's XML: there is no element VTKFile");
    const std::string type = root.attribute("type").value(), compressor = root.attribute("compressor").value();
    const std::string order = root.attribute("byte_order").as_string("LittleEndian");
    const std::string header = root.attribute("header_type").as_string("UInt32");
    const std::string appended_as = root.child("AppendedData").attribute("encoding").as_string("base64");
    if (type != "PolyData") refuse("the data are of the type '" + type + "', but only PolyData is a surface");
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      refuse("the compressor '" + compressor + "' is not known; please write the file with zlib or uncompressed");
    if (order != "LittleEndian" && order != "BigEndian") refuse("the byte order '" + order + "' is not known");
    if (header != "UInt32" && header != "UInt64") refuse("the header type '" + header + "' is not known");
    if (appended_as != "base64" && appended_as != "raw") refuse("the encoding '" + appended_as + "' is not known");
    encoding = {order == "LittleEndian", !compressor.empty(), header == "UInt64" ? std::size_t(8) : std::size_t(4)};
    is_appended_in_base64 = appended_as == "base64";
    for (const pugi::xml_node& piece : root.child("PolyData").children("Piece")) pieces.push_back(piece);
  }

  Byte_reader bytes_of(const pugi::xml_node& array) const
  {
    if (std::string(array.attribute("format").value()) == "binary") return {array.text().get(), true};
    const std::size_t offset = count(array, "offset");
    if (offset > appended.size()) refuse("an array begins behind the end of the appended data");
    return {std::string_view(appended).substr(offset), is_appended_in_base64};
  }

  template <class Number>
  std::vector<Number> numbers(const pugi::xml_node& section, const pugi::xml_node& array) const
  {
    if (!array) refuse(std::string("a list of numbers is missing in ") + section.name());
    const std::string format = array.attribute("format").as_string("ascii");
    if (format == "ascii") return numbers_in_text<Number>(array.text().get());
    if (format != "binary" && format != "appended") refuse("the format '" + format + "' is not known");
    return numbers_of_type<Number>(array.attribute("type").value(), read_array(bytes_of(array), encoding), encoding);
  }
  template <class Number>
  std::vector<Number> numbers(const pugi::xml_node& section, const char* name) const
  { return numbers<Number>(section, section.find_child_by_attribute("DataArray", "Name", name)); }

  pugi::xml_document          document;
  std::string                 appended;                       // behind the underscore
  bool                        is_appended_in_base64 = true;
  Encoding                    encoding;
  std::vector<pugi::xml_node> pieces;
};

Vtk_poly_data::Vtk_poly_data(const std::string& contents) : m_file(std::make_unique<File>(contents)) {}

Vtk_poly_data::~Vtk_poly_data() = default;

std::size_t Vtk_poly_data::number_of_pieces() const { return m_file->pieces.size(); }

std::vector<Point_3> Vtk_poly_data::points(std::size_t piece) const
{
  const pugi::xml_node node = m_file->pieces[piece], section = node.child("Points");
  const std::size_t announced = count(node, "NumberOfPoints");
  if (announced == 0) return {};
  const std::vector<double> x = m_file->numbers<double>(section, section.child("DataArray"));
  if (x.size() % 3 != 0 || x.size() / 3 != announced)
    refuse("there are " + std::to_string(x.size()) + " coordinates for " + std::to_string(announced) + " points");
  if (!std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); }))
    refuse("something is not a finite number");
  std::vector<Point_3> result;
  for (std::size_t k = 0; k < x.size(); k += 3) result.emplace_back(x[k], x[k + 1], x[k + 2]);
  return result;
}

std::vector<Vtk_poly_data::Cell> Vtk_poly_data::cells(std::size_t piece, const std::string& kind) const
{
  const pugi::xml_node node = m_file->pieces[piece], section = node.child(kind.c_str());
  const std::size_t points = count(node, "NumberOfPoints"), announced = count(node, "NumberOf" + kind);
  if (announced == 0) return {};
  const std::vector<std::int64_t> connectivity = m_file->numbers<std::int64_t>(section, "connectivity");
  const std::vector<std::int64_t> offsets = m_file->numbers<std::int64_t>(section, "offsets");
  if (offsets.size() != announced)
    refuse("there are " + std::to_string(offsets.size()) + " offsets for " + std::to_string(announced) + " cells");
  std::vector<Cell> result;
  std::size_t begin = 0;
  for (std::int64_t offset : offsets) {
    const std::size_t end = static_cast<std::size_t>(offset);   // beyond all range if negative
    if (end < begin || end > connectivity.size()) refuse("an offset is out of range, or less than the one before");
    Cell& cell = result.emplace_back();
    for (; begin < end; ++begin) {
      const std::size_t v = static_cast<std::size_t>(connectivity[begin]);
      if (v >= points)
        refuse("a point that does not exist is used by cell " + std::to_string(result.size() - 1) + " of " + kind);
      cell.push_back(v);
    }
  }
  if (begin != connectivity.size()) refuse("the offsets end before the list of corners does");
  return result;
}

std::vector<std::int64_t> Vtk_poly_data::cell_data(std::size_t piece, const std::string& name) const
{
  return m_file->numbers<std::int64_t>(m_file->pieces[piece].child("CellData"), name.c_str());
}

} } // namespace CGAL::Quartic_differentials
