// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Texture_vertices.h"
#include "little_endian.h"
#include "vtk_data_array.h"

#include <CGAL/Quartic_differentials/IO/write_flat_surface.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Text_writer;

double in_units(std::int64_t x, int grid_exponent) { return std::ldexp(static_cast<double>(x), -grid_exponent); }

// What PolyData and UnstructuredGrid have in common.
class Vtk_surface
{
public:
  explicit Vtk_surface(const Refined_surface& refined)
    : m_refined(refined), m_q(refined.differential), m_mesh(m_q.triangulation), m_texture(texture_vertices(m_q)) {}

  std::size_t points() const { return m_texture.points.size(); }
  std::size_t triangles() const { return m_mesh.number_of_faces(); }

  void write_points_and_data(Text_writer& out) const
  {
    out << "<Points>\n";
    write_data_array(out, "type=\"Float64\" NumberOfComponents=\"3\"", points(), [&](std::size_t v) {
      internal::write_point(out, m_mesh.mesh().point(m_texture.vertices[v]), ' ');
    });
    out << "</Points>\n<PointData TCoords=\"uv\">\n";
    write_data_array(out, "type=\"Float64\" Name=\"uv\" NumberOfComponents=\"2\"", points(), [&](std::size_t v) {
      const Grid_vector z = m_texture.points[v];
      out << in_units(z.x, m_q.grid_exponent) << ' ' << in_units(z.y, m_q.grid_exponent);
    });
    write_data_array(out, "type=\"Int32\" Name=\"singularity_order\"", points(),
                     [&](std::size_t v) { out << m_q.order[m_texture.vertices[v]]; });
    out << "</PointData>\n<CellData Scalars=\"input_face\">\n";
    write_data_array(out, "type=\"Int64\" Name=\"input_face\"", triangles(),
                     [&](std::size_t f) { out << m_refined.input_face[f].idx(); });
    out << "</CellData>\n";
  }

  void write_cells(Text_writer& out) const
  {
    write_data_array(out, "type=\"Int64\" Name=\"connectivity\"", triangles(), [&](std::size_t f) {
      const auto [a, b, c] = m_texture.triangle(m_mesh, Face(static_cast<Mesh::size_type>(f)));
      out << a << ' ' << b << ' ' << c;
    });
    write_data_array(out, "type=\"Int64\" Name=\"offsets\"", triangles(), [&](std::size_t f) { out << 3 * (f + 1); });
  }

private:
  const Refined_surface&         m_refined;
  const Quartic_differential&    m_q;
  const Intrinsic_triangulation& m_mesh;
  Texture_vertices               m_texture;
};

std::string ply_header(std::size_t vertices, std::size_t faces, const std::string& texture)
{
  return "ply\nformat binary_little_endian 1.0\ncomment TextureFile " + texture + "\nelement vertex "
       + std::to_string(vertices)
       + "\nproperty double x\nproperty double y\nproperty double z\nproperty float s\nproperty float t\n"
         "property int singularity_order\nelement face " + std::to_string(faces)
       + "\nproperty list uchar int vertex_indices\nproperty int input_face\nend_header\n";
}

} // namespace

void write_flat_ply(std::ostream& out, const Refined_surface& refined, const std::string& texture_file)
{
  const Quartic_differential& q = refined.differential;
  internal::require_embedded(q.triangulation, "flat.ply");
  Texture_vertices texture = texture_vertices(q);
  subtract_whole_units(texture, q);
  std::string bytes = ply_header(texture.points.size(), q.triangulation.number_of_faces(), texture_file);
  for (std::size_t v = 0; v < texture.points.size(); ++v) {
    const Point_3& p = q.triangulation.mesh().point(texture.vertices[v]);
    for (int k = 0; k < 3; ++k) append_little_endian(bytes, p[k]);
    append_little_endian(bytes, static_cast<float>(in_units(texture.points[v].x, q.grid_exponent)));
    append_little_endian(bytes, static_cast<float>(in_units(texture.points[v].y, q.grid_exponent)));
    append_little_endian(bytes, static_cast<std::int32_t>(q.order[texture.vertices[v]]));
  }
  for (Face f : q.triangulation.faces()) {
    append_little_endian(bytes, std::uint8_t(3));
    for (std::size_t v : texture.triangle(q.triangulation, f)) append_little_endian(bytes, static_cast<std::int32_t>(v));
    append_little_endian(bytes, static_cast<std::int32_t>(refined.input_face[f].idx()));
  }
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void write_flat_vtp(std::ostream& stream, const Refined_surface& refined)
{
  internal::require_embedded(refined.differential.triangulation, "flat.vtp");
  const Vtk_surface surface(refined);
  Text_writer out(stream);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << surface.points() << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
         "NumberOfStrips=\"0\" NumberOfPolys=\"" << surface.triangles() << "\">\n";
  surface.write_points_and_data(out);
  out << "<Polys>\n";
  surface.write_cells(out);
  out << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  out.finish();
}

void write_flat_vtu(std::ostream& stream, const Refined_surface& refined)
{
  const int vtk_triangle = 5;
  internal::require_embedded(refined.differential.triangulation, "flat.vtu");
  const Vtk_surface surface(refined);
  Text_writer out(stream);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << surface.points() << "\" NumberOfCells=\""
      << surface.triangles() << "\">\n";
  surface.write_points_and_data(out);
  out << "<Cells>\n";
  surface.write_cells(out);
  write_data_array(out, "type=\"UInt8\" Name=\"types\"", surface.triangles(), [&](std::size_t) { out << vtk_triangle; });
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
