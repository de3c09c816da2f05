// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_multipatch.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/bezier_net.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Text_writer;
using internal::comma;
using internal::write_point;

// Sides 0 and 1 run with their parameter, sides 2 and 3 against it.
bool runs_with_parameter(int side) { return side < 2; }

// The sides of an interface run against one another, but do their parameters?
bool is_reversed(const Multipatch::Interface& i)
{
  return runs_with_parameter(i.first.side) == runs_with_parameter(i.second.side);
}

void write_knots(Text_writer& out, std::size_t n, char separator)
{
  for (std::size_t k = 0; k < n + 7; ++k) {
    if (k > 0) out << separator;
    out << internal::knot(k, n);
  }
}

// G+Smo

// A side is a direction, 0 or 1, the one that is constant there, and whether it is at its end: 1 is west, 2 east,
// 3 south, 4 north. (gismo, src/gsCore/gsBoundary.h: boundary::side, boxSide)
struct Gismo_side
{
  int  direction;
  bool at_end;

  int number() const { return 2 * direction + at_end + 1; }
};

Gismo_side gismo_side(int side)
{
  static constexpr std::array<Gismo_side, 4> sides{{{1, false}, {0, true}, {1, true}, {0, false}}};
  return sides[static_cast<std::size_t>(side)];
}

// A tensor product's coefficient (i, j) is number i + j n: direction 0 runs faster. (src/gsTensor/gsTensorBasis.h;
// elements and attributes: src/gsIO/gsXmlGenericUtils.hpp, getGeometryFromXml and getTensorBasisFromXml)
void write_xml_patch(Text_writer& out, const Multipatch::Patch& patch, std::size_t id)
{
  out << " <Geometry type=\"TensorBSpline2\" id=\"" << id << "\">\n  <Basis type=\"TensorBSplineBasis2\">\n";
  for (std::size_t direction = 0; direction < 2; ++direction) {
    out << "   <Basis type=\"BSplineBasis\" index=\"" << direction << "\">\n    <KnotVector degree=\"3\">";
    write_knots(out, patch.spans[direction], ' ');
    out << "</KnotVector>\n   </Basis>\n";
  }
  out << "  </Basis>\n  <coefs geoDim=\"3\">\n";
  for (const Point_3& p : patch.control_points) {
    write_point(out, p, ' ');
    out << '\n';
  }
  out << "  </coefs>\n </Geometry>\n";
}

// patch side patch side, then for direction 0 and 1 of the first patch the direction of the second that runs along it,
// then whether the two run the same way; across the interface G+Smo takes this to be whether both are at the beginning
// or both at the end. (src/gsIO/gsXml.cpp, getInterfaces; src/gsCore/gsBoundary.h, boundaryInterface and its mapCorner)
void write_xml_interface(Text_writer& out, const Multipatch::Interface& i)
{
  const Gismo_side first = gismo_side(i.first.side), second = gismo_side(i.second.side);
  std::array<int, 2>  map;
  std::array<bool, 2> same_way;
  map[first.direction] = second.direction;
  map[1 - first.direction] = 1 - second.direction;
  same_way[first.direction] = first.at_end == second.at_end;
  same_way[1 - first.direction] = !is_reversed(i);
  out << i.first.patch << ' ' << first.number() << ' ' << i.second.patch << ' ' << second.number();
  for (int direction : map) out << ' ' << direction;
  for (bool same : same_way) out << ' ' << (same ? '1' : '0');
  out << '\n';
}

// patch side, a line each (src/gsIO/gsXml.cpp, getBoundaries)
void write_xml_boundary(Text_writer& out, const std::vector<Multipatch::Side>& boundary)
{
  out << "  <boundary>\n";
  for (const Multipatch::Side& s : boundary) out << s.patch << ' ' << gismo_side(s.side).number() << '\n';
  out << "  </boundary>\n";
}

// JSON

void write_json_patch(Text_writer& out, const Multipatch::Patch& patch)
{
  out << "{\"spans\":[" << patch.spans[0] << ',' << patch.spans[1] << "],\n\"knots\":[[";
  write_knots(out, patch.spans[0], ',');
  out << "],[";
  write_knots(out, patch.spans[1], ',');
  out << "]],\n\"control_points\":[";
  for (std::size_t k = 0; k < patch.control_points.size(); ++k) {
    out << comma(k) << "\n[";
    write_point(out, patch.control_points[k], ',');
    out << ']';
  }
  out << "],\n\"quads\":[";
  for (std::size_t k = 0; k < patch.quads.size(); ++k) out << comma(k) << patch.quads[k];
  out << "]}";
}

void write_json_interface(Text_writer& out, const Multipatch::Interface& i)
{
  out << "{\"patches\":[" << i.first.patch << ',' << i.second.patch << "],\"sides\":[" << i.first.side << ','
      << i.second.side << "],\"reversed\":" << (is_reversed(i) ? "true" : "false") << '}';
}

void write_json_boundary(Text_writer& out, const std::vector<Multipatch::Side>& boundary)
{
  out << ",\n\"boundary\":[";
  for (std::size_t i = 0; i < boundary.size(); ++i)
    out << comma(i) << "\n{\"patch\":" << boundary[i].patch << ",\"side\":" << boundary[i].side << '}';
  out << ']';
}

// VTK

// The place (i, j) in a bicubic cell of its 16 points: corners counterclockwise, then two on each of the edges bottom,
// right, top, left, with the rising parameter, then the interior. (VTK, vtkHigherOrderQuadrilateral::PointIndexFromIJK)
constexpr std::array<std::array<std::size_t, 2>, 16> vtk_order{{
  {0, 0}, {3, 0}, {3, 3}, {0, 3},
  {1, 0}, {2, 0}, {3, 1}, {3, 2}, {1, 3}, {2, 3}, {0, 1}, {0, 2},
  {1, 1}, {2, 1}, {1, 2}, {2, 2}}};
constexpr int vtk_bezier_quadrilateral = 77;   // vtkCellType.h

void begin_array(Text_writer& out, std::string_view type, std::string_view name)
{
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n";
}

void end_array(Text_writer& out) { out << "</DataArray>\n"; }

void write_vtu_points(Text_writer& out, const Multipatch& m)
{
  out << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Multipatch::Patch& patch : m.patches)
    for (const Point_3& p : internal::bezier_net(patch)) {
      write_point(out, p, ' ');
      out << '\n';
    }
  end_array(out);
  out << "</Points>\n";
}

std::size_t number_of_bezier_points(const Multipatch::Patch& patch)
{
  return (3 * patch.spans[0] + 1) * (3 * patch.spans[1] + 1);
}

void write_vtu_cells(Text_writer& out, const Multipatch& m)
{
  out << "<Cells>\n";
  begin_array(out, "Int64", "connectivity");
  std::size_t first = 0, cells = 0;
  for (const Multipatch::Patch& patch : m.patches) {
    const auto [n_u, n_v] = patch.spans;
    for (std::size_t j = 0; j < n_v; ++j)
      for (std::size_t i = 0; i < n_u; ++i) {
        for (const auto& [a, b] : vtk_order) out << first + (3 * j + b) * (3 * n_u + 1) + 3 * i + a << ' ';
        out << '\n';
      }
    first += number_of_bezier_points(patch);
    cells += patch.quads.size();
  }
  end_array(out);
  begin_array(out, "Int64", "offsets");
  for (std::size_t c = 1; c <= cells; ++c) out << vtk_order.size() * c << '\n';
  end_array(out);
  begin_array(out, "UInt8", "types");
  for (std::size_t c = 0; c < cells; ++c) out << vtk_bezier_quadrilateral << '\n';
  end_array(out);
  out << "</Cells>\n";
}

void write_vtu_cell_data(Text_writer& out, const Multipatch& m)
{
  out << "<CellData Scalars=\"patch\">\n";
  begin_array(out, "Int64", "patch");
  for (std::size_t p = 0; p < m.patches.size(); ++p)
    for (std::size_t q = 0; q < m.patches[p].quads.size(); ++q) out << p << '\n';
  end_array(out);
  begin_array(out, "Int64", "quad");
  for (const Multipatch::Patch& patch : m.patches)
    for (std::size_t quad : patch.quads) out << quad << '\n';
  end_array(out);
  out << "</CellData>\n";
}

} // namespace

// src/gsIO/gsXmlUtils.hpp (later src/gsCore/gsCoreXml.hpp), gsXml<gsMultiPatch>: the patches are siblings of the
// MultiPatch, known by their ids. With ids from 0 these are also the patches' indices. A closed surface has no element
// `boundary`.
void write_multipatch_xml(std::ostream& stream, const Multipatch& m)
{
  Text_writer out(stream);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n";
  for (std::size_t p = 0; p < m.patches.size(); ++p) write_xml_patch(out, m.patches[p], p);
  out << " <MultiPatch parDim=\"2\" id=\"" << m.patches.size() << "\">\n  <patches type=\"id_range\">0 "
      << m.patches.size() - 1 << "</patches>\n  <interfaces>\n";
  for (const Multipatch::Interface& i : m.interfaces) write_xml_interface(out, i);
  out << "  </interfaces>\n";
  if (!m.boundary.empty()) write_xml_boundary(out, m.boundary);
  out << " </MultiPatch>\n</xml>\n";
  out.finish();
}

void write_multipatch_json(std::ostream& stream, const Multipatch& m)
{
  Text_writer out(stream);
  out << "{\"degree\":3,\n\"patches\":[";
  for (std::size_t p = 0; p < m.patches.size(); ++p) {
    out << comma(p) << '\n';
    write_json_patch(out, m.patches[p]);
  }
  out << "],\n\"interfaces\":[";
  for (std::size_t i = 0; i < m.interfaces.size(); ++i) {
    out << comma(i) << '\n';
    write_json_interface(out, m.interfaces[i]);
  }
  out << ']';
  if (!m.boundary.empty()) write_json_boundary(out, m.boundary);
  out << "}\n";
  out.finish();
}

void write_multipatch_vtu(std::ostream& stream, const Multipatch& m)
{
  std::size_t points = 0, cells = 0;
  for (const Multipatch::Patch& patch : m.patches) {
    points += number_of_bezier_points(patch);
    cells += patch.quads.size();
  }
  Text_writer out(stream);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << points << "\" NumberOfCells=\"" << cells << "\">\n";
  write_vtu_points(out, m);
  write_vtu_cells(out, m);
  write_vtu_cell_data(out, m);
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
