// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_VTK_POLY_DATA_H
#define CGAL_QUARTIC_DIFFERENTIALS_VTK_POLY_DATA_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

/// The XML PolyData of VTK: arrays as text, in base64, or appended raw or in base64, uncompressed or by zlib, in either
/// byte order, with 32 or 64 bits. What is asked for is decoded, and checked, at that time.
///
/// All functions throw an `Unusable_surface_error` where the file does not hold what is asked for. Memory stays
/// proportional to the file, whatever it announces; zlib expands bytes to at most 1032 times their number.
/// Source: VTK file formats; vtkXMLDataParser.cxx for compressed blocks; RFC 4648 for base64.
class Vtk_poly_data
{
public:
  using Cell = std::vector<std::size_t>;

  explicit Vtk_poly_data(const std::string& contents);
  ~Vtk_poly_data();

  std::size_t number_of_pieces() const;
  std::vector<Point_3> points(std::size_t piece) const;
  /// \param kind Lines, Strips or Polys
  std::vector<Cell> cells(std::size_t piece, const std::string& kind) const;
  std::vector<std::int64_t> cell_data(std::size_t piece, const std::string& name) const;

private:
  struct File;
  std::unique_ptr<const File> m_file;
};

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_VTK_POLY_DATA_H
