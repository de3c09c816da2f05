// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/patch_pieces.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>
#include <CGAL/Quartic_differentials/internal/t_mesh_nodes.h>
#include <CGAL/Quartic_differentials/patch_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Chart_point;
using internal::Patch_piece;
using internal::Text_writer;
using internal::comma;
using internal::write_point;

// from node to node, with a point on every edge and at every vertex between
std::vector<Point_3> polyline(const T_mesh& t, const Quartic_differential& q, const T_mesh::Arc& arc)
{
  std::vector<Point_3> result{internal::position(q, t.nodes[arc.from])};
  for (std::size_t k = 0; k + 1 < arc.path.size(); ++k)
    result.push_back(internal::position(q, internal::exit_of(q, arc.path[k])));
  result.push_back(internal::position(q, t.nodes[arc.to]));
  return result;
}

void write_json_point(Text_writer& out, const Point_3& p)
{
  out << '[';
  write_point(out, p, ',');
  out << ']';
}

void write_json_nodes(Text_writer& out, const T_mesh& t, const Quartic_differential& q)
{
  out << "\"nodes\":[";
  for (std::size_t n = 0; n < t.nodes.size(); ++n) {
    const T_mesh::Node& node = t.nodes[n];
    out << comma(n) << "\n{\"id\":" << n << ",\"kind\":\"" << internal::name(node.kind) << "\",\"order\":" << node.order;
    if (q.triangulation.is_embedded()) {
      out << ",\"position\":";
      write_json_point(out, internal::position(q, node));
    }
    out << '}';
  }
  out << "\n]";
}

void write_json_arcs(Text_writer& out, const T_mesh& t, const Quartic_differential& q)
{
  out << "\"arcs\":[";
  for (std::size_t a = 0; a < t.arcs.size(); ++a) {
    const T_mesh::Arc& arc = t.arcs[a];
    out << comma(a) << "\n{\"id\":" << a << ",\"from\":" << arc.from << ",\"to\":" << arc.to
        << ",\"length\":" << arc.length;
    if (q.triangulation.is_embedded()) {
      out << ",\"polyline\":[";
      const std::vector<Point_3> points = polyline(t, q, arc);
      for (std::size_t k = 0; k < points.size(); ++k) {
        out << comma(k);
        write_json_point(out, points[k]);
      }
      out << ']';
    }
    out << '}';
  }
  out << "\n]";
}

void write_json_patches(Text_writer& out, const T_mesh& t)
{
  out << "\"patches\":[";
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    const T_mesh::Patch& patch = t.patches[p];
    out << comma(p) << "\n{\"id\":" << p << ",\"width\":" << patch.width << ",\"height\":" << patch.height
        << ",\"sides\":[";
    for (std::size_t side = 0; side < 4; ++side) {
      out << comma(side) << '[';
      for (std::size_t k = 0; k < patch.sides[side].size(); ++k) {
        const T_mesh::Side_piece& piece = patch.sides[side][k];
        out << comma(k) << "{\"arc\":" << piece.arc << ",\"forward\":" << (piece.forward ? "true" : "false") << '}';
      }
      out << ']';
    }
    out << "]}";
  }
  out << "\n]";
}

// The polygons and lines of the vtp file.
class Poly_data
{
public:
  Poly_data(const T_mesh& t, const Quartic_differential& q) : m_q(q), m_unit(std::ldexp(1.0, -t.grid_exponent))
  {
    for (const T_mesh::Arc& arc : t.arcs) add_line(polyline(t, q, arc));
    for (const Patch_piece& piece : internal::patch_pieces(t, q)) add_polygon(piece);
  }

  void write(Text_writer& out) const
  {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
        << "<Piece NumberOfPoints=\"" << m_points.size() << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << m_lines.size()
        << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << m_polygons.size() << "\">\n"
        << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (const Point_3& p : m_points) {
      write_point(out, p, ' ');
      out << '\n';
    }
    out << "</DataArray>\n</Points>\n<PointData TCoords=\"uv\">\n"
        << "<DataArray type=\"Float64\" Name=\"uv\" NumberOfComponents=\"2\" format=\"ascii\">\n";
    for (const auto& [u, v] : m_uv) out << u << ' ' << v << '\n';
    out << "</DataArray>\n</PointData>\n";
    write_cell_data(out);
    write_cells(out, "Lines", m_lines);
    write_cells(out, "Polys", m_polygons);
    out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  }

private:
  using Cell = std::vector<std::size_t>;

  void add_line(const std::vector<Point_3>& points)
  {
    Cell line;
    for (const Point_3& p : points) line.push_back(add_point(p, 0, 0));
    m_lines.push_back(std::move(line));
  }

  void add_polygon(const Patch_piece& piece)
  {
    Cell polygon;
    for (const Chart_point& p : piece.corner) {
      const auto [u, v] = place_in_patch(piece, p);
      const auto [it, is_new] = m_shared.try_emplace({piece.patch, u, v}, m_points.size());
      if (is_new) add_point(internal::position(m_q, p), u * m_unit, v * m_unit);
      polygon.push_back(it->second);
    }
    m_polygons.push_back(std::move(polygon));
    m_patch.push_back(piece.patch);
  }

  std::size_t add_point(const Point_3& p, double u, double v)
  {
    m_points.push_back(p);
    m_uv.emplace_back(u, v);
    return m_points.size() - 1;
  }

  // in grid units; the same doubles from all faces
  std::pair<double, double> place_in_patch(const Patch_piece& piece, const Chart_point& p) const
  {
    const Intrinsic_triangulation& mesh = m_q.triangulation;
    const auto corner = [&](Halfedge h) { return piece.to_patch(m_q.corner[h] + m_q.corner[h]); };
    const auto rounded = [](Grid_vector z) { return std::make_pair(static_cast<double>(z.x), static_cast<double>(z.y)); };
    if (p.place == Chart_point::Place::interior) return rounded(piece.to_patch(p.z));
    if (p.place == Chart_point::Place::corner) return rounded(corner(p.halfedge));
    Grid_vector a = corner(p.halfedge), b = corner(mesh.next(p.halfedge));
    if (p.halfedge != mesh.halfedge(mesh.edge(p.halfedge))) std::swap(a, b);
    const std::int64_t n = internal::numerator_along_edge(m_q, p);
    return {between(a.x, b.x, n, p.denominator), between(a.y, b.y, n, p.denominator)};
  }

  // a + (b - a) n / d, exact where it is an integer: on the sides of a patch
  static double between(std::int64_t a, std::int64_t b, std::int64_t n, std::int64_t d)
  {
    const __int128 numerator = static_cast<__int128>(b - a) * n;
    const std::int64_t whole = static_cast<std::int64_t>(numerator / d), rest = static_cast<std::int64_t>(numerator % d);
    return static_cast<double>(a + whole) + static_cast<double>(rest) / static_cast<double>(d);
  }

  // Hues one golden ratio apart; lines are black.
  static std::array<int, 3> colour(std::size_t patch)
  {
    const double hue = 6 * std::fmod(0.6180339887498949 * static_cast<double>(patch), 1.0);
    std::array<int, 3> rgb;
    for (int k = 0; k < 3; ++k) {
      const double distance = std::abs(std::remainder(hue - 2 * k, 6.0));   // from this primary, in sixths of the circle
      rgb[k] = static_cast<int>(255 * (0.45 + 0.5 * std::min(1.0, std::max(0.0, 2 - distance))));
    }
    return rgb;
  }

  void write_cell_data(Text_writer& out) const
  {
    out << "<CellData Scalars=\"patch\">\n<DataArray type=\"Int64\" Name=\"patch\" format=\"ascii\">\n";
    for (std::size_t a = 0; a < m_lines.size(); ++a) out << "-1\n";
    for (std::size_t patch : m_patch) out << patch << '\n';
    out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"arc\" format=\"ascii\">\n";
    for (std::size_t a = 0; a < m_lines.size(); ++a) out << a << '\n';
    for (std::size_t p = 0; p < m_polygons.size(); ++p) out << "-1\n";
    out << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"colour\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (std::size_t a = 0; a < m_lines.size(); ++a) out << "0 0 0\n";
    for (std::size_t patch : m_patch) {
      const auto [r, g, b] = colour(patch);
      out << r << ' ' << g << ' ' << b << '\n';
    }
    out << "</DataArray>\n</CellData>\n";
  }

  static void write_cells(Text_writer& out, const char* kind, const std::vector<Cell>& cells)
  {
    out << '<' << kind << ">\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
    for (const Cell& cell : cells)
      for (std::size_t k = 0; k < cell.size(); ++k) out << cell[k] << (k + 1 < cell.size() ? ' ' : '\n');
    out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
    std::size_t offset = 0;
    for (const Cell& cell : cells) out << (offset += cell.size()) << '\n';
    out << "</DataArray>\n</" << kind << ">\n";
  }

  const Quartic_differential&            m_q;
  double                                 m_unit;
  std::vector<Point_3>                   m_points;
  std::vector<std::pair<double, double>> m_uv;
  std::vector<Cell>                      m_lines, m_polygons;
  std::vector<std::size_t>               m_patch;    // by polygon
  std::map<std::tuple<std::size_t, double, double>, std::size_t> m_shared;   // point by patch, u, v
};

// The groups of the obj file.
class Patch_groups
{
public:
  explicit Patch_groups(Mesh patches)   // add_property_map() finds what is there
    : m_mesh(std::move(patches)), m_patch(m_mesh.add_property_map<Face, std::uint32_t>("f:patch").first),
      m_texture(m_mesh.add_property_map<Halfedge, Point_2>("h:texture").first),
      m_arc(m_mesh.add_property_map<Edge, std::uint32_t>("e:arc").first),
      m_order(m_mesh.add_property_map<Vertex, int>("v:singularity_order").first) {}

  void write(Text_writer& out)
  {
    for (Vertex v : m_mesh.vertices()) {
      out << "v ";
      write_point(out, m_mesh.point(v), ' ');
      out << '\n';
    }
    std::map<std::size_t, std::vector<Face>> faces;   // by patch
    for (Face f : m_mesh.faces()) faces[m_patch[f]].push_back(f);
    for (const auto& [patch, members] : faces) {
      out << "g patch_" << patch << '\n';
      write_patch(out, members);
    }
    std::map<std::size_t, std::vector<Edge>> edges;   // by arc
    for (Edge e : m_mesh.edges())
      if (m_arc[e] != no_arc) edges[m_arc[e]].push_back(e);
    for (const auto& [arc, members] : edges) {
      out << "g arc_" << arc << "\nl";
      for (Vertex v : polyline(members)) out << ' ' << v.idx() + 1;
      out << '\n';
    }
  }

private:
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

  // A patch may meet itself, so that one of its points has several places in it.
  void write_patch(Text_writer& out, const std::vector<Face>& faces)
  {
    std::map<std::pair<Vertex, Point_2>, std::size_t> texture_vertex;
    std::vector<std::array<std::pair<Vertex, std::size_t>, 3>> triangles;
    for (Face f : faces) {
      auto& corners = triangles.emplace_back();
      std::size_t k = 0;
      for (Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) {
        const auto [it, is_new] = texture_vertex.try_emplace({m_mesh.target(h), m_texture[h]}, m_texture_vertices + 1);
        if (is_new) {
          out << "vt " << m_texture[h].x() << ' ' << m_texture[h].y() << '\n';
          ++m_texture_vertices;
        }
        corners[k++] = {m_mesh.target(h), it->second};
      }
    }
    for (const auto& corners : triangles) {
      out << 'f';
      for (const auto& [v, texture] : corners) out << ' ' << v.idx() + 1 << '/' << texture;
      out << '\n';
    }
  }

  bool is_on_arc(Halfedge h) const { return m_arc[m_mesh.edge(h)] != no_arc; }
  // Between its ends an arc meets no other: a node is where there are not just two edges of arcs, or at a singularity,
  // where both may be of one arc.
  bool is_end(Vertex v, std::size_t arc) const
  {
    std::size_t of_arc = 0, of_others = 0;
    for (Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (is_on_arc(h)) ++(m_arc[m_mesh.edge(h)] == arc ? of_arc : of_others);
    return of_arc != 2 || of_others != 0 || m_order[v] != 0;
  }

  // the edges of an arc as a path, closed if it ends where it begins
  std::vector<Vertex> polyline(const std::vector<Edge>& edges) const
  {
    const std::size_t arc = m_arc[edges.front()];
    Halfedge h = m_mesh.halfedge(edges.front());
    for (Edge e : edges)
      for (Halfedge k : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
        if (is_end(m_mesh.source(k), arc)) h = k;
    std::vector<Vertex> path{m_mesh.source(h), m_mesh.target(h)};
    while (path.size() <= edges.size()) {
      const Edge from = m_mesh.edge(h);
      for (Halfedge k : m_mesh.halfedges_around_target(h))
        if (m_mesh.edge(k) != from && m_arc[m_mesh.edge(k)] == arc) {
          h = m_mesh.opposite(k);
          break;
        }
      path.push_back(m_mesh.target(h));
    }
    return path;
  }

  Mesh                                    m_mesh;
  Mesh::Property_map<Face, std::uint32_t> m_patch;
  Mesh::Property_map<Halfedge, Point_2>   m_texture;
  Mesh::Property_map<Edge, std::uint32_t> m_arc;
  Mesh::Property_map<Vertex, int>         m_order;
  std::size_t                             m_texture_vertices = 0;
};

} // namespace

void write_t_mesh_json(std::ostream& stream, const T_mesh& t, const Quartic_differential& q, const std::string& surface)
{
  Text_writer out(stream);
  out << "{\"grid_exponent\":" << t.grid_exponent << ",\n\"surface\":\"" << surface << "\",\n";
  write_json_nodes(out, t, q);
  out << ",\n";
  write_json_arcs(out, t, q);
  out << ",\n";
  write_json_patches(out, t);
  out << "\n}\n";
  out.finish();
}

void write_t_mesh_vtp(std::ostream& stream, const T_mesh& t, const Quartic_differential& q)
{
  internal::require_embedded(q.triangulation, "tmesh.vtp");
  Text_writer out(stream);
  Poly_data(t, q).write(out);
  out.finish();
}

void write_t_mesh_obj(std::ostream& stream, Mesh patches)
{
  Text_writer out(stream);
  Patch_groups(std::move(patches)).write(out);
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
