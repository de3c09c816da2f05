// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every format is read, every refusal names its reason and its place, and no broken file crashes the reader.

#include "base64.h"
#include "check.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/IO/surface_json.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
namespace fs = std::filesystem;

struct Temporary_folder
{
  fs::path path;
  Temporary_folder() : path(fs::temp_directory_path() / ("read_surface_" + std::to_string(std::random_device{}())))
  {
    fs::create_directories(path);
  }
  ~Temporary_folder() { fs::remove_all(path); }
};

const Temporary_folder folder;

std::string written(const std::string& name, const std::string& contents)
{
  const std::string path = (folder.path / name).string();
  fs::remove(path);     // some file systems wait for the disk when a file is overwritten
  std::ofstream(path, std::ios::binary) << contents;
  return path;
}

Intrinsic_triangulation read(const std::string& name, const std::string& contents)
{
  std::vector<std::string> notes;
  return read_surface(written(name, contents), notes);
}

std::string notes_of(const std::string& name, const std::string& contents)
{
  std::vector<std::string> notes;
  read_surface(written(name, contents), notes);
  std::string all;
  for (const std::string& n : notes) all += n + "\n";
  return all;
}

std::vector<Surface_component> components(const std::string& name, const std::string& contents)
{ return read_surface_components(written(name, contents)); }

#define CHECK_REFUSED(name, contents, part) CHECK_THROWS(read(name, contents), Unusable_surface_error, part)

const std::string four_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string tetrahedron = "OFF\n4 4 0\n" + four_points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
const std::string cube =
  "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
  "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

const std::string one_triangle =
  R"({"triangles":[[0,1,2]],"opposite":[[[-1,-1],[-1,-1],[-1,-1]]],"lengths":[[1,1,1]]})";
const std::string two_spheres_json =
  R"({"triangles":[[0,1,2],[0,2,1],[3,4,5],[3,5,4]],"opposite":[[[1,2],[1,1],[1,0]],[[0,2],[0,1],[0,0]],)"
  R"([[3,2],[3,1],[3,0]],[[2,2],[2,1],[2,0]]],"lengths":[[1,1,1],[1,1,1],[1,1,1],[1,1,1]]})";

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t at = text.find(what);
  CHECK(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

std::string with_windows_line_ends(const std::string& text)
{
  std::string result;
  for (char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

void check_sphere(const Intrinsic_triangulation& t, std::size_t v, std::size_t f)
{
  CHECK_EQUAL(structural_defect(t), "");
  CHECK_EQUAL(t.genus(), 0);
  CHECK_EQUAL(t.number_of_vertices(), v);
  CHECK_EQUAL(t.number_of_faces(), f);
}

void check_off()
{
  check_sphere(read("t.off", tetrahedron), 4, 4);
  CHECK_EQUAL(notes_of("t.off", tetrahedron), "");
  check_sphere(read("T.OFF", with_windows_line_ends(tetrahedron)), 4, 4);
  check_sphere(read("t.off", replaced(tetrahedron, "4 4 0\n", "# a comment\n\n4 4 0 # sizes\n")), 4, 4);
  check_sphere(read("t.off", replaced(tetrahedron, "OFF\n4 4 0", "OFF 4 4 0")), 4, 4);
  check_sphere(read("t.off", replaced(tetrahedron, "OFF\n", "COFF\n")), 4, 4);
  check_sphere(read("c.off", cube), 8, 12);
  CHECK(notes_of("c.off", cube).find("6 faces with more than three corners were triangulated") == 0);
  const std::string inside_out = "OFF\n4 4 0\n" + four_points + "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 0 2 3\n";
  CHECK(notes_of("i.off", inside_out).find("inside-out") != std::string::npos);

  const std::string unused = "OFF\n6 4 0\n9 9 9\n0 0 0\n1 0 0\n8 8 8\n0 1 0\n0 0 1\n3 1 4 2\n3 1 2 5\n3 2 4 5\n3 1 5 4\n";
  const Intrinsic_triangulation t = read("u.off", unused);
  check_sphere(t, 4, 4);
  CHECK(t.mesh().point(Vertex(2)) == Point_3(0, 1, 0));
  CHECK(notes_of("u.off", unused).find("2 vertices belonged to no face") == 0);

  const std::string soup = "OFF\n12 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n1 0 0\n0 1 0\n0 0 1\n0 0 0\n0 0 1\n0 1 0\n"
                           "3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n";
  check_sphere(read("s.off", soup), 4, 4);
  CHECK(notes_of("s.off", soup).find("8 vertices had the same coordinates") == 0);

  // two closed tetrahedra that touch at a point, but not in their indices, stay two
  CHECK_REFUSED("touching.off", "OFF\n8 8 0\n" + four_points + "0 0 0\n-1 0 0\n0 -1 0\n0 0 -1\n"
    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 4 5 6\n3 4 7 5\n3 5 7 6\n3 4 6 7\n",
    "the surface has 2 components: vertex 4 at (0, 0, 0)");
}

void check_other_formats()
{
  check_sphere(read("t.obj", "# c\nmtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\n"
                             "f 1/1 3/1 2/1\nf 1 2 4\nf -3 -2 -1\nf 1//1 4//1 3//1\n"), 4, 4);
  const std::string ply_header = "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\n"
                                 "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string ply = ply_header + four_points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  check_sphere(read("t.ply", ply), 4, 4);
  check_sphere(read("t.ply", replaced(ply, "uchar", "int")), 4, 4);
  check_sphere(read("t.ply", with_windows_line_ends(ply)), 4, 4);
  CHECK_REFUSED("t.ply", replaced(replaced(ply, "uchar", "int"), "3 0 2 1", "2000000000 0 2 1"), "cut off");
  CHECK_REFUSED("t.ply", replaced(ply, "property float x", "property int x"), "no x of floating point type");
  CHECK_REFUSED("t.ply", replaced(ply, "property float x", "property quad x"), "unknown type 'quad'");
  CHECK_REFUSED("t.ply", replaced(ply, "element face 4", "element nothing 1000000000000\nelement face 4"), "no property");
  CHECK_REFUSED("t.ply", replaced(ply, "element vertex 4", "element vertex 1000000000000"), "cut off");
  CHECK_REFUSED("t.ply", replaced(ply, "end_header", "end_head"), "header does not end");
  CHECK_REFUSED("t.ply", replaced(ply, "1 0 0", "1 nan 0"), "holds a number that is not finite");
  CHECK_REFUSED("t.ply", tetrahedron, "does not begin with 'ply'");
  CHECK_REFUSED("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
                "refers to a vertex that does not exist: reading it ended at or after face 0");
  CHECK_REFUSED("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "face 0 refers to a vertex that does not exist");
  CHECK_REFUSED("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "face 0 has fewer than three corners");
  CHECK_REFUSED("t.obj", "v 0 0 0\nv 1 0\n", "not a mesh in obj format");

  // every format that CGAL writes, text and binary
  const Mesh torus_mesh = torus(2, 1, 12, 6);
  for (const char* name : {"w.off", "w.obj", "w.ply", "w.stl"})
    for (bool binary : {false, true}) {
      const std::string path = (folder.path / name).string();
      CHECK(CGAL::IO::write_polygon_mesh(path, torus_mesh,
                                         CGAL::parameters::stream_precision(17).use_binary_mode(binary)));
      std::vector<std::string> notes;
      const Intrinsic_triangulation t = read_surface(path, notes);
      CHECK_EQUAL(t.genus(), 1);
      CHECK_EQUAL(t.number_of_vertices(), 72u);
      CHECK_EQUAL(t.number_of_faces(), 144u);
    }
  std::string stl = written("n.stl", "");
  CHECK(CGAL::IO::write_polygon_mesh(stl, torus_mesh, CGAL::parameters::use_binary_mode(true)));
  std::ifstream in(stl, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  in.close();
  for (int i = 0; i < 4; ++i) bytes[84 + 50 * 3 + 12 + i] = '\xff';
  CHECK_REFUSED("n.stl", bytes, "face 3 has a coordinate that is not a finite number");
  bytes.resize(bytes.size() - 10);
  CHECK_REFUSED("n.stl", bytes, "not a mesh in stl format");
}

void check_json()
{
  std::ostringstream out;
  write_surface_json(out, hyperelliptic(2, 1));
  const Intrinsic_triangulation t = read("h.json", out.str());
  CHECK_EQUAL(t.genus(), 2);
  CHECK(!t.is_embedded());
  CHECK(t.lengths() == Intrinsic_triangulation(hyperelliptic(2, 1)).lengths());

  // a sphere of two triangles glued along their borders
  const std::string good = R"({"triangles":[[0,1,2],[0,2,1]],"opposite":[[[1,2],[1,1],[1,0]],[[0,2],[0,1],[0,0]]],)"
                           R"("lengths":[[1,1,1],[1,1,1]]})";
  check_sphere(read("g.json", good), 3, 2);
  CHECK_REFUSED("b.json", good.substr(0, 40), "not JSON");
  CHECK_REFUSED("b.json", "[1,2]", "not an object");
  CHECK_REFUSED("b.json", "{}", "no list 'triangles'");
  CHECK_REFUSED("b.json", replaced(good, "[0,1,2]", "[0,1]"), "triangles[0] is not a list of 3");
  CHECK_REFUSED("b.json", replaced(good, "[0,1,2]", "[0,1,2000000000]"), "not an index below 6");
  CHECK_REFUSED("b.json", replaced(good, "[0,1,2]", "[0,1,-2]"), "not an index");
  CHECK_REFUSED("b.json", replaced(good, "[0,1,2]", "[0,1,1.5]"), "not an index");
  CHECK_REFUSED("b.json", replaced(good, "[1,1,1]]", "[1,1,\"x\"]]"), "lengths[1] holds \"x\"");
  CHECK_REFUSED("b.json", replaced(good, "[[1,1,1]", "[[1,1,5]"), "another length");
  CHECK_REFUSED("b.json", replaced(good, "[[1,2]", "[[1,1]"), "not glued to exactly one other edge");
  CHECK_REFUSED("b.json", replaced(good, "[[1,2]", "[[-1,2]"), "not an index below 2");
  CHECK_REFUSED("b.json", R"({"triangles":[],"opposite":[],"lengths":[]})", "the surface has no triangle");
  const Intrinsic_triangulation triangle = read("open.json", one_triangle);
  CHECK_EQUAL(structural_defect(triangle), "");
  CHECK_EQUAL(triangle.number_of_boundary_curves(), 1);
  CHECK_REFUSED("two.json", two_spheres_json,
                "the surface has 2 components: vertex 3 is not connected with the first face;");
}

// ---- VTP in all its encodings

enum class Vtp_data { text, base64, appended_base64, appended_raw };

struct Vtp_style
{
  Vtp_data    data = Vtp_data::text;
  bool        compressed = false, big_endian = false, wide_header = false, single_precision = false, narrow_ids = false;
  std::size_t block = 100;   // bytes of a compressed block
};

// Writes PolyData as VTK does. (VTK file formats; vtkXMLDataParser.cxx)
class Vtp_writer
{
public:
  explicit Vtp_writer(const Vtp_style& style) : m_style(style) {}

  template <class Number>
  std::string bytes(const std::vector<Number>& numbers) const
  {
    std::string result;
    for (Number x : numbers) {
      std::string one(sizeof x, '\0');
      std::memcpy(one.data(), &x, sizeof x);
      if (m_style.big_endian) std::reverse(one.begin(), one.end());   // of a little-endian host
      result += one;
    }
    return result;
  }

  template <class Number>
  std::string array(const char* type, const char* name, const std::vector<Number>& numbers)
  {
    const std::string head = "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name + "\" format=\"";
    if (m_style.data == Vtp_data::text) {
      std::ostringstream out;
      out.precision(17);
      for (Number x : numbers) out << +x << '\n';
      return head + "ascii\">\n" + out.str() + "</DataArray>\n";
    }
    const std::string data = encoded(bytes(numbers));
    if (m_style.data == Vtp_data::base64) return head + "binary\">\n  " + data + "\n</DataArray>\n";
    const std::string offset = std::to_string(m_appended.size());
    m_appended += data;
    return head + "appended\" offset=\"" + offset + "\"/>\n";
  }

  std::string file(const std::string& pieces) const
  {
    std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"";
    head += m_style.big_endian ? "BigEndian\"" : "LittleEndian\"";
    if (m_style.wide_header) head += " header_type=\"UInt64\"";
    if (m_style.compressed) head += " compressor=\"vtkZLibDataCompressor\"";
    std::string appended;
    if (!m_appended.empty())
      appended = std::string("<AppendedData encoding=\"") + (m_style.data == Vtp_data::appended_raw ? "raw" : "base64")
               + "\">\n _" + m_appended + "\n</AppendedData>\n";
    return head + ">\n<PolyData>\n" + pieces + "</PolyData>\n" + appended + "</VTKFile>\n";
  }

private:
  std::string header(const std::vector<std::uint64_t>& items) const
  { return m_style.wide_header ? bytes(items) : bytes(std::vector<std::uint32_t>(items.begin(), items.end())); }

  // a run of base64 of its own, if it is not raw
  std::string run(const std::string& data) const
  { return m_style.data == Vtp_data::appended_raw ? data : base64(data.data(), data.size()); }

  std::string encoded(const std::string& data) const
  {
    if (!m_style.compressed) return run(header({data.size()}) + data);
    std::vector<std::uint64_t> items{(data.size() + m_style.block - 1) / m_style.block, m_style.block,
                                     data.size() % m_style.block};
    std::string blocks;
    for (std::size_t begin = 0; begin < data.size(); begin += m_style.block) {
      const std::string block = data.substr(begin, m_style.block);
      uLongf size = compressBound(block.size());
      std::string compressed(size, '\0');
      compress(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(block.data()), block.size());
      blocks += compressed.substr(0, size);
      items.push_back(size);
    }
    return run(header(items)) + run(blocks);
  }

  Vtp_style   m_style;
  std::string m_appended;
};

using Polygons = std::vector<std::vector<int>>;

std::string vtp_cells(Vtp_writer& writer, const Vtp_style& style, const char* kind, const Polygons& cells)
{
  std::vector<std::int64_t> connectivity, offsets;
  for (const auto& cell : cells) {
    connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  const auto array = [&](const char* name, const std::vector<std::int64_t>& numbers) {
    if (!style.narrow_ids) return writer.array("Int64", name, numbers);
    return writer.array("Int32", name, std::vector<std::int32_t>(numbers.begin(), numbers.end()));
  };
  const std::string list = array("connectivity", connectivity);
  return std::string("<") + kind + ">\n" + list + array("offsets", offsets) + "</" + kind + ">\n";
}

std::string vtp_piece(Vtp_writer& writer, const Vtp_style& style, const std::vector<double>& x, const Polygons& polygons,
                      const Polygons& strips)
{
  const std::string points = style.single_precision
    ? writer.array("Float32", "Points", std::vector<float>(x.begin(), x.end())) : writer.array("Float64", "Points", x);
  const std::string polys = vtp_cells(writer, style, "Polys", polygons), lines = vtp_cells(writer, style, "Lines", {{0, 1}});
  return "<Piece NumberOfPoints=\"" + std::to_string(x.size() / 3) + "\" NumberOfLines=\"1\" NumberOfStrips=\""
       + std::to_string(strips.size()) + "\" NumberOfPolys=\"" + std::to_string(polygons.size()) + "\">\n<Points>\n"
       + points + "</Points>\n" + lines + vtp_cells(writer, style, "Strips", strips) + polys + "</Piece>\n";
}

std::string vtp(const Vtp_style& style, const std::vector<double>& x, const Polygons& polygons, const Polygons& strips = {})
{
  Vtp_writer writer(style);
  return writer.file(vtp_piece(writer, style, x, polygons, strips));
}

const std::vector<double> cube_points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1 / 3.0};
const Polygons cube_quads{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::vector<Vtp_style> all_vtp_styles()
{
  std::vector<Vtp_style> styles;
  for (Vtp_data data : {Vtp_data::text, Vtp_data::base64, Vtp_data::appended_base64, Vtp_data::appended_raw})
    for (unsigned bits = 0; bits < 32; ++bits)
      styles.push_back({data, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0,
                        bits % 3 == 0 ? std::size_t(96) : std::size_t(100)});   // 192 is two full blocks of 96
  return styles;
}

void check_vtp()
{
  for (const Vtp_style& style : all_vtp_styles()) {
    const Intrinsic_triangulation t = read("c.vtp", vtp(style, cube_points, cube_quads));
    check_sphere(t, 8, 12);
    for (Vertex v : t.vertices())
      for (int k = 0; k < 3; ++k) {
        const double x = cube_points[3 * v + k];
        CHECK(t.mesh().point(v)[k] == (style.single_precision ? static_cast<float>(x) : x));
      }
    for (Face f : t.faces())   // orientations were kept
      for (Halfedge h : t.halfedges(f)) CHECK(t.face(t.opposite(h)) != f);
  }
  CHECK(notes_of("c.vtp", vtp({}, cube_points, cube_quads)).find("6 faces with more than three corners") == 0);

  // strips turn every other triangle round; pieces count their points from 0
  const std::vector<double> four{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  check_sphere(read("s.vtp", vtp({}, four, {{0, 1, 3}}, {{0, 2, 1, 3}, {0, 3, 2}})), 4, 4);
  Vtp_writer writer({});
  const std::string pieces = vtp_piece(writer, {}, four, {{0, 2, 1}, {0, 1, 3}}, {})
                           + vtp_piece(writer, {}, four, {{1, 2, 3}, {0, 3, 2}}, {});
  check_sphere(read("p.vtp", writer.file(pieces)), 4, 4);
  CHECK(notes_of("p.vtp", writer.file(pieces)).find("4 vertices had the same coordinates") == 0);
}

void check_vtp_refusals()
{
  const std::string text = vtp({}, cube_points, cube_quads);
  const auto refused = [](const std::string& contents, const std::string& part) {
    CHECK_REFUSED("b.vtp", contents, "the file is not a mesh in vtp format: " + part);
  };
  const auto with = [&](const std::string& what, const std::string& by) { return replaced(text, what, by); };
  refused(text.substr(0, text.size() / 2), "this is not VTK's XML");
  refused(tetrahedron, "this is not VTK's XML");
  refused("<other/>", "this is not VTK's XML: there is no element VTKFile");
  refused(with("\"PolyData\"", "\"UnstructuredGrid\""), "the data are of the type 'UnstructuredGrid'");
  refused(with("LittleEndian", "MiddleEndian"), "the byte order 'MiddleEndian' is not known");
  refused(with("byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order"), "the compressor 'vtkLZ4DataCompressor'");
  refused(with("byte_order", "header_type=\"UInt16\" byte_order"), "the header type 'UInt16' is not known");
  refused(with("format=\"ascii\"", "format=\"ebcdic\""), "the format 'ebcdic' is not known");
  refused(with("NumberOfPoints=\"8\"", "NumberOfPoints=\"9\""), "there are 24 coordinates for 9 points");
  refused(with("NumberOfPoints=\"8\"", "NumberOfPoints=\"6148914691236517213\""), "there are 24 coordinates for");
  refused(with("NumberOfPoints=\"8\"", "NumberOfPoints=\"99999999999999999999\""), "something is not a finite number");
  refused(with("NumberOfPolys=\"6\"", "NumberOfPolys=\"5\""), "there are 6 offsets for 5 cells");
  refused(with("\n4\n8\n12", "\n4\n3\n12"), "an offset is out of range, or less than the one before");
  refused(with("\n4\n8\n12", "\n4\n-8\n12"), "an offset is out of range");
  refused(with("\n20\n24\n", "\n20\n25\n"), "an offset is out of range");
  refused(with("\n20\n24\n", "\n20\n23\n"), "the offsets end before the list of corners does");
  refused(with("\n0\n3\n2\n", "\n0\n8\n2\n"), "a point that does not exist is used by cell 0 of Polys");
  refused(with("\n0\n3\n2\n", "\n0\n-3\n2\n"), "a point that does not exist");
  refused(with("\n0\n3\n2\n", "\n0\n3.5\n2\n"), "something is not a finite number");
  refused(with("<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\"", "<Polys>\n<DataArray type=\"Int64\" Name=\"a\""),
          "a list of numbers is missing in Polys");
  refused(with("<Points>", "<Points><DataArray/></Points><Points>"), "there are 0 coordinates for 8 points");
  refused(with("1\n1\n1\n", "1\nnan\n1\n"), "something is not a finite number");
  CHECK_REFUSED("b.vtp", with("NumberOfPolys=\"6\"", "NumberOfPolys=\"0\""), "the surface has no face");
  CHECK_REFUSED("b.vtp", "<VTKFile type=\"PolyData\"/>", "the surface has no face");

  const std::string inlined = vtp({Vtp_data::base64}, cube_points, cube_quads);
  refused(replaced(inlined, "\"Float64\"", "\"Float16\""), "an array has the type 'Float16'");
  refused(replaced(inlined, "\"Int64\" Name=\"connectivity\" format=\"binary\">\n  wAAA", 
                   "\"Float64\" Name=\"connectivity\" format=\"binary\">\n  wAAA"), "an array has the type 'Float64'");
  refused(replaced(inlined, "wAAA", "w*AA"), "an array holds a character that is not one of base64");
  refused(replaced(inlined, "wAAAA", "/////"), "an array is cut off: it announces more than the file holds");
  refused(replaced(inlined, "wAAAA", "vAAAA"), "an array does not hold whole numbers of its type");
  const Vtp_style raw{Vtp_data::appended_raw};
  const std::string appended = vtp(raw, cube_points, cube_quads);
  refused(replaced(appended, "offset=\"0\"", "offset=\"9999\""), "an array begins behind the end of the appended data");
  refused(replaced(appended, " _", "  "), "the appended data do not begin with an underscore");
  refused(replaced(appended, "\"raw\"", "\"base85\""), "the encoding 'base85' is not known");
  refused(appended.substr(0, appended.find(" _") + 100), "an array is cut off");

  const Vtp_style zipped{Vtp_data::appended_raw, true};
  const std::string compressed = vtp(zipped, cube_points, cube_quads);
  const std::size_t header = compressed.find(" _") + 2;
  const auto with_header_item = [&](int item, std::uint32_t value) {
    std::string bad = compressed;
    std::memcpy(bad.data() + header + 4 * item, &value, 4);
    return bad;
  };
  refused(with_header_item(0, 0xffffffff), "an array is cut off");
  refused(with_header_item(1, 0xffffffff), "a compressed array announces more than it holds");
  refused(with_header_item(1, 99), "a compressed array is broken");
  refused(with_header_item(2, 93), "a compressed array is broken");
  refused(with_header_item(3, 0xffffffff), "an array is cut off");

  // nested as deep as this, a parser that calls itself would need more stack than there is
  std::string deep;
  for (int i = 0; i < 2000000; ++i) deep += "<a>";
  refused(deep, "this is not VTK's XML");
}

void check_refusals()
{
  std::vector<std::string> notes;
  CHECK_THROWS(read_surface((folder.path / "missing.off").string(), notes), Unusable_surface_error, "does not exist");
  CHECK_THROWS(read_surface(folder.path.string(), notes), Unusable_surface_error, "not a regular file");
  CHECK_REFUSED("e.off", "", "the file is empty");
  CHECK_REFUSED("t.xyz", tetrahedron, "the extension '.xyz' is not one of .off, .obj, .ply, .stl, .vtp, .json");
  CHECK_REFUSED("t.off", "this is not a mesh\n", "not a mesh in off format");
  CHECK_REFUSED("t.off", "OFF\n0 0 0\n", "the surface has no face");
  CHECK_REFUSED("t.off", tetrahedron.substr(0, tetrahedron.size() - 10), "cut off");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "3 0 2 1", "3 0 2 7"), "vertex that does not exist: reading it ended at or after face 0");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "4 4 0", "1000000000 4 0"), "announces more than it holds");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "4 4 0", "4 1000000000 0"), "announces more than it holds");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "3 0 2 1", "2000000000 0 2 1"), "announces more than it holds");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "1 0 0", "1 nan 0"), "line 4 holds a number that is not finite");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "1 0 0", "1 1e999 0"), "line 4 holds a number that is not finite");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "0 1 0", "0.5 0 0"), "face 0 at (0, 0, 0) has no area");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "0 1 0", "0.5 1e-300 0"), "has no area in double precision");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "3 0 2 1", "3 0 2 2"), "it has vertex 2 at (0, 1, 0) twice");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "3 0 3 2", "3 3 1 2"), "face 3 at (0, 0, 1) has the same corners as face 2");
  CHECK_REFUSED("t.off", replaced(tetrahedron, "3 0 2 1", "3 0 1 2"),
    "the faces 0 and 1 are oriented against each other at the edge from vertex 0 at (0, 0, 0) to vertex 1 at (1, 0, 0)");
  CHECK_REFUSED("page.off", "OFF\n5 5 0\n" + four_points + "1 1 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 1 4\n",
    "the edge from vertex 0 at (0, 0, 0) to vertex 1 at (1, 0, 0) has 3 faces");
  CHECK_REFUSED("fan.off", "OFF\n7 8 0\n" + four_points + "-1 0 0\n0 -1 0\n0 0 -1\n"
    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 4 5\n3 0 6 4\n3 4 6 5\n3 0 5 6\n",
    "the faces at vertex 0 at (0, 0, 0) form more than one fan");
  // two fans, of two faces each and of one and two, and a fan beside a circle
  const std::string pinched = "the faces at vertex 2 at (0, 1, 0) form more than one fan";
  CHECK_REFUSED("fans.off", "OFF\n7 3 0\n" + four_points + "2 1 0\n2 2 0\n2 3 0\n3 0 1 2\n3 2 4 5\n3 2 5 6\n", pinched);
  CHECK_REFUSED("fans.off", "OFF\n7 3 0\n" + four_points + "2 1 0\n2 2 0\n2 3 0\n3 2 4 5\n3 2 5 6\n3 2 0 1\n", pinched);
  CHECK_REFUSED("fans.off", "OFF\n6 5 0\n" + four_points + "2 1 0\n2 2 0\n"
                            "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 2 4 5\n", pinched);
}

void check_boundary()
{
  const auto curves = [](const std::string& name, const std::string& contents, std::size_t vertices) {
    const Intrinsic_triangulation t = read(name, contents);
    CHECK_EQUAL(structural_defect(t), "");
    CHECK_EQUAL(t.number_of_vertices(), vertices);
    return t.number_of_boundary_curves();
  };
  const std::string open = "OFF\n4 3 0\n" + four_points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n";
  CHECK_EQUAL(curves("open.off", open, 4), 1);
  CHECK_EQUAL(notes_of("open.off", open), "");   // it encloses no volume that could be negative
  const std::string inside_out = "OFF\n4 3 0\n" + four_points + "3 0 1 2\n3 0 3 1\n3 1 3 2\n";
  CHECK_EQUAL(notes_of("open.off", inside_out), "");
  CHECK_EQUAL(curves("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3), 1);
  // the faces of the first vertex are listed from both ends of its fan
  CHECK_EQUAL(curves("fan.off", "OFF\n6 4 0\n0 0 0\n2 0 0\n2 1 0\n1 2 0\n0 2 0\n-1 1 0\n"
                                "3 0 2 3\n3 0 4 5\n3 0 1 2\n3 0 3 4\n", 6), 1);
  CHECK_EQUAL(curves("tube.off", replaced(replaced(replaced(cube, "8 6 0", "8 4 0"), "4 0 3 2 1\n", ""),
                                          "4 4 5 6 7\n", ""), 8), 2);
  for (int holes = 0; holes <= 4; ++holes) {
    const std::string path = (folder.path / "plate.ply").string();
    const Mesh mesh = plate(holes, 14);
    CHECK(CGAL::IO::write_polygon_mesh(path, mesh, CGAL::parameters::use_binary_mode(true)));
    std::vector<std::string> notes;
    const Intrinsic_triangulation t = read_surface(path, notes);
    CHECK_EQUAL(t.number_of_boundary_curves(), holes + 1);
    CHECK_EQUAL(t.genus(), 0);
    CHECK(t.number_of_faces() == mesh.number_of_faces() && notes.empty());
  }
}

struct Off_file
{
  std::vector<std::string> points, faces;

  std::string text() const
  {
    std::string all = "OFF\n" + std::to_string(points.size()) + ' ' + std::to_string(faces.size()) + " 0\n";
    for (const std::string& line : points) all += line + '\n';
    for (const std::string& line : faces) all += line + '\n';
    return all;
  }
};

void check_components()
{
  // vertices and faces of two tetrahedra and a triangle, shuffled, and a vertex without a face
  const Off_file mixed{{"0 0 0", "5 0 0", "1 0 0", "6 0 0", "9 9 9", "0 1 0", "5 1 0", "0 0 1", "5 0 1", "0 0 3", "1 0 3",
                        "0 1 3"},
                       {"3 9 10 11", "3 1 6 3", "3 0 5 2", "3 1 3 8", "3 0 2 7", "3 3 6 8", "3 2 5 7", "3 1 8 6",
                        "3 0 7 5"}};
  CHECK_REFUSED("mixed.off", mixed.text(), "the surface has 3 components: vertex 1 at (5, 0, 0)");
  const std::vector<Surface_component> three = components("mixed.off", mixed.text());
  CHECK_EQUAL(three.size(), 3u);
  for (int i = 0; i < 2; ++i) check_sphere(*three[i].surface, 4, 4);
  CHECK_EQUAL(three[2].surface->number_of_boundary_curves(), 1);
  CHECK_EQUAL(three[2].surface->number_of_faces(), 1u);
  // as large as each other: in the order of their first faces, each as if it were alone
  const std::vector<Point_3> points{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}};
  const Intrinsic_triangulation alone = read("alone.off", "OFF\n4 4 0\n5 0 0\n6 0 0\n5 1 0\n5 0 1\n"
                                                          "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  const Intrinsic_triangulation& first = *three[0].surface;
  for (Vertex v : first.vertices()) CHECK(first.mesh().point(v) == points[v]);
  for (Halfedge h : alone.halfedges()) CHECK(first.source(h) == alone.source(h) && first.face(h) == alone.face(h));
  CHECK(three[1].surface->mesh().point(Vertex(3)) == Point_3(0, 0, 1));
  for (const Surface_component& c : three) CHECK(c.notes.empty() && c.refusal.empty());

  // a flat face, and an edge with three faces, spoil only their own component
  Off_file spoilt = mixed;
  spoilt.points[11] = "2 0 3";
  const std::vector<Surface_component> flat = components("flat.off", spoilt.text());
  CHECK(flat[0].surface && flat[1].surface && !flat[2].surface);
  CHECK(flat[2].refusal.find("face 0 at (0, 0, 3) has no area") == 0);
  CHECK(flat[2].vertices == 3 && flat[2].faces == 1);
  spoilt = mixed;
  spoilt.faces.push_back("3 1 3 5");   // three faces at an edge, and the tetrahedra are one component
  const std::vector<Surface_component> page = components("page.off", spoilt.text());
  CHECK_EQUAL(page.size(), 2u);
  CHECK(page[0].refusal.find("has 3 faces") != std::string::npos && page[1].surface);
  spoilt.faces.back() = "3 1 3 12";
  CHECK_THROWS(components("index.off", spoilt.text()), Unusable_surface_error,
               "refers to a vertex that does not exist");
  CHECK_THROWS(components("none.off", "OFF\n0 0 0\n"), Unusable_surface_error, "none.off: the surface has no face");

  // equal points: two closed tetrahedra that touch stay two, triangles of an open soup are joined
  const std::string touching = "OFF\n8 8 0\n" + four_points + "0 0 0\n-1 0 0\n0 -1 0\n0 0 -1\n"
    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 4 5 6\n3 4 7 5\n3 5 7 6\n3 4 6 7\n";
  CHECK_EQUAL(components("touching.off", touching).size(), 2u);
  Mesh two = torus(2, 1, 12, 6), other = bumpy_sphere(1);
  for (Vertex v : other.vertices()) other.point(v) = other.point(v) + Vector_3(9, 0, 0);
  CGAL::copy_face_graph(other, two);
  Off_file soup;
  for (Face f : two.faces()) {
    const std::size_t n = soup.points.size();
    for (Vertex v : two.vertices_around_face(two.halfedge(f))) {
      std::ostringstream point;
      point.precision(17);
      point << two.point(v);
      soup.points.push_back(point.str());
    }
    soup.faces.push_back("3 " + std::to_string(n) + ' ' + std::to_string(n + 1) + ' ' + std::to_string(n + 2));
  }
  const std::vector<Surface_component> joined = components("soup.off", soup.text());
  CHECK_EQUAL(joined.size(), 2u);
  CHECK(joined[0].surface->genus() == 1 && joined[1].surface->genus() == 0);
  CHECK_EQUAL(joined[0].surface->number_of_vertices(), 72u);
  CHECK_EQUAL(joined[0].vertices, 3 * 144u);
  CHECK_EQUAL(joined[0].notes.size(), 2u);   // merged, and the others dropped
  CHECK(joined[0].notes[0].find(std::to_string(3 * 144 - 72) + " vertices had the same coordinates") == 0);

  const std::vector<Surface_component> glued = components("two.json", two_spheres_json);
  CHECK_EQUAL(glued.size(), 2u);
  for (const Surface_component& c : glued) check_sphere(*c.surface, 3, 2);
  CHECK(glued[1].vertices == 3 && glued[1].faces == 2);
  CHECK_THROWS(components("b.json", R"({"triangles":[],"opposite":[],"lengths":[]})"), Unusable_surface_error,
               "the surface has no triangle");
}

// Whatever the bytes, reading ends with a surface or with a refusal.
void check_broken_bytes(const std::string& name, const std::string& good)
{
  std::mt19937 random(7);
  const auto survives = [&](const std::string& contents) {
    bool sound = true;
    try {
      sound = structural_defect(read(name, contents)).empty();
    } catch (const Unusable_surface_error&) {
    }
    try {
      for (const Surface_component& c : components(name, contents))
        sound = sound && c.surface.has_value() == c.refusal.empty()
             && (!c.surface || structural_defect(*c.surface).empty());
    } catch (const Unusable_surface_error&) {
    }
    return sound;
  };
  for (std::size_t n = 0; n < good.size(); n += 1 + good.size() / 200) CHECK(survives(good.substr(0, n)));
  for (int i = 0; i < 300; ++i) {
    std::string bad = good;
    for (int k = 0; k < 1 + i % 3; ++k) bad[random() % bad.size()] = static_cast<char>(random());
    CHECK(survives(bad));
    for (int k = 0; k < 1 + i % 3; ++k) bad[random() % bad.size()] = "0123456789-. \n#e"[random() % 16];
    CHECK(survives(bad));
  }
}

void check_broken_files()
{
  Mesh mesh = torus(2, 1, 5, 4);
  for (const char* extension : {".off", ".obj", ".ply", ".stl"})
    for (bool binary : {false, true}) {
      const std::string path = (folder.path / ("fuzz" + std::string(extension))).string();
      CHECK(CGAL::IO::write_polygon_mesh(path, mesh, CGAL::parameters::use_binary_mode(binary)));
      std::ifstream in(path, std::ios::binary);
      const std::string good{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
      in.close();
      check_broken_bytes("fuzzed" + std::string(extension), good);
    }
  check_broken_bytes("fuzzed.off", replaced(cube, "OFF", "COFF"));
  for (Vtp_data data : {Vtp_data::text, Vtp_data::base64, Vtp_data::appended_base64, Vtp_data::appended_raw})
    for (bool compressed : {false, true})
      check_broken_bytes("fuzzed.vtp", vtp({data, compressed}, cube_points, cube_quads));
  std::ostringstream json;
  write_surface_json(json, hyperelliptic(1, 0));
  check_broken_bytes("fuzzed.json", json.str());
}

int main()
{
  check_off();
  check_other_formats();
  check_json();
  check_vtp();
  check_vtp_refusals();
  check_refusals();
  check_boundary();
  check_components();
  check_broken_files();
  return Quartic_test::result();
}
