// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VTK_DATA_ARRAY_H
#define CGAL_QUARTIC_DIFFERENTIALS_VTK_DATA_ARRAY_H

#include <CGAL/Quartic_differentials/internal/Text_writer.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

/// writes an array of VTK's XML, one line for every i < size, as `write_line(i)` writes it.
template <class Write_line>
void write_data_array(internal::Text_writer& out, const std::string& attributes, std::size_t size, Write_line write_line)
{
  out << "<DataArray " << attributes << " format=\"ascii\">\n";
  for (std::size_t i = 0; i < size; ++i) {
    write_line(i);
    out << '\n';
  }
  out << "</DataArray>\n";
}

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_VTK_DATA_ARRAY_H
