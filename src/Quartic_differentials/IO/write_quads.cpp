// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtk_data_array.h"

#include <CGAL/Quartic_differentials/IO/write_quads.h>
#include <CGAL/Quartic_differentials/internal/Quad_shape.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>

#include <CGAL/IO/io.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Text_writer;

} // namespace

void write_quads_obj(std::ostream& stream, const Quad_mesh& m)
{
  Text_writer out(stream);
  for (const Point_3& p : m.points) {
    out << "v ";
    internal::write_point(out, p, ' ');
    out << '\n';
  }
  for (std::size_t i = 0; i < m.quads.size(); ++i) {
    if (i == 0 || m.patch[i] != m.patch[i - 1]) out << "g patch_" << m.patch[i] << '\n';
    out << 'f';
    for (std::size_t v : m.quads[i]) out << ' ' << v + 1;
    out << '\n';
  }
  out.finish();
}

void write_quads_off(std::ostream& out, const Quad_mesh& m, const T_mesh& t)
{
  CGAL::IO::write_OFF(out, surface_mesh(m, t),
                      CGAL::parameters::stream_precision(std::numeric_limits<double>::max_digits10));
}

void write_quads_ply(std::ostream& out, const Quad_mesh& m, const T_mesh& t)
{
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, surface_mesh(m, t));
}

void write_quads_vtu(std::ostream& stream, const Quad_mesh& m, const T_mesh& t)
{
  const int vtk_quad = 9;
  const std::vector<int> order = singularity_orders(m, t);
  const std::size_t points = m.points.size(), quads = m.quads.size();
  const auto shape = [&](std::size_t f) { return internal::Quad_shape(m.corners(f)); };
  Text_writer out(stream);
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
      << "<Piece NumberOfPoints=\"" << points << "\" NumberOfCells=\"" << quads << "\">\n<Points>\n";
  write_data_array(out, "type=\"Float64\" NumberOfComponents=\"3\"", points,
                   [&](std::size_t v) { internal::write_point(out, m.points[v], ' '); });
  out << "</Points>\n<PointData Scalars=\"singularity_order\">\n";
  write_data_array(out, "type=\"Int32\" Name=\"singularity_order\"", points, [&](std::size_t v) { out << order[v]; });
  out << "</PointData>\n<CellData Scalars=\"patch\">\n";
  write_data_array(out, "type=\"Int64\" Name=\"patch\"", quads, [&](std::size_t f) { out << m.patch[f]; });
  write_data_array(out, "type=\"Float64\" Name=\"scaled_jacobian\"", quads,
                   [&](std::size_t f) { out << shape(f).scaled_jacobian(); });
  write_data_array(out, "type=\"Float64\" Name=\"edge_ratio\"", quads,
                   [&](std::size_t f) { out << shape(f).edge_ratio(); });
  out << "</CellData>\n<Cells>\n";
  write_data_array(out, "type=\"Int64\" Name=\"connectivity\"", quads, [&](std::size_t f) {
    const auto& [a, b, c, d] = m.quads[f];
    out << a << ' ' << b << ' ' << c << ' ' << d;
  });
  write_data_array(out, "type=\"Int64\" Name=\"offsets\"", quads, [&](std::size_t f) { out << 4 * (f + 1); });
  write_data_array(out, "type=\"UInt8\" Name=\"types\"", quads, [&](std::size_t) { out << vtk_quad; });
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
