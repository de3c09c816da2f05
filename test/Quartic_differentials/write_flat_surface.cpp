// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// flat.ply, flat.vtp, flat.vtu and flat.glb read back: they are the surface of flat.obj, with its texture coordinates,
// or those but for whole units; and the glb is as the specification of glTF 2.0 wants it.

#include "check.h"
#include "run_pipeline.h"
#include "test_surfaces.h"
#include "vtk_xml.h"

#include <CGAL/Quartic_differentials/IO/write_checkerboard.h>
#include <CGAL/Quartic_differentials/IO/write_flat_surface.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/IO/io.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <nlohmann/json.hpp>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;
using Json = nlohmann::json;

namespace {

using Place = std::array<double, 2>;

// the corner's texture coordinates in flat.obj
Place chart_place(const Quartic_differential& q, Halfedge h)
{
  return {std::ldexp(static_cast<double>(q.corner[h].x), -q.grid_exponent),
          std::ldexp(static_cast<double>(q.corner[h].y), -q.grid_exponent)};
}

double largest_coordinate(const Quartic_differential& q)
{
  double largest = 0;
  for (Halfedge h : q.triangulation.halfedges())
    for (double x : chart_place(q, h)) largest = std::max(largest, std::abs(x));
  return largest;
}

// Triangles as they were read, one place in the plane for every corner.
struct Read_triangles
{
  std::vector<std::array<std::size_t, 3>> vertices;
  std::vector<Place>                      places;   // by vertex
};

// The places of corners are those in the charts, moved by whole units, the same for faces that are glued by identities.
void check_moved_by_whole_units(const Read_triangles& read, const Quartic_differential& q, double tolerance)
{
  const Intrinsic_triangulation& t = q.triangulation;
  CHECK_EQUAL(read.vertices.size(), t.number_of_faces());
  std::vector<Place> shift(t.number_of_halfedges());
  double error = 0;
  for (Face f : t.faces())
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = t.halfedges(f)[k];
      const Place expected = chart_place(q, h), found = read.places[read.vertices[f][k]];
      for (int c = 0; c < 2; ++c) {
        shift[h][c] = std::round(found[c] - expected[c]);
        error = std::max(error, std::abs(found[c] - expected[c] - shift[h][c]));
      }
    }
  CHECK(error <= tolerance);
  for (Halfedge h : t.halfedges()) {
    CHECK(shift[h] == shift[t.next(h)]);
    if (q.transition[h].is_identity()) CHECK(shift[h] == shift[t.opposite(h)]);
  }
}

// ---- PLY

void check_ply(const Refined_surface& refined)
{
  const Quartic_differential& q = refined.differential;
  const Intrinsic_triangulation& t = q.triangulation;
  std::stringstream file;
  write_flat_ply(file, refined, "some.png");
  CHECK(file.str().find("\ncomment TextureFile some.png\n") < 100);
  Mesh mesh;
  std::string comments;
  CGAL::IO::set_binary_mode(file);
  CHECK(CGAL::IO::read_PLY(file, mesh, comments));
  CHECK_EQUAL(file.peek(), std::char_traits<char>::eof());
  const auto [s, no_s] = mesh.add_property_map<Vertex, float>("v:s");   // finds what was read
  const auto [u, no_t] = mesh.add_property_map<Vertex, float>("v:t");
  const auto [order, no_order] = mesh.add_property_map<Vertex, std::int32_t>("v:singularity_order");
  const auto [input_face, no_face] = mesh.add_property_map<Face, std::int32_t>("f:input_face");
  CHECK(!no_s && !no_t && !no_order && !no_face);
  CHECK_EQUAL(mesh.number_of_faces(), t.number_of_faces());
  Read_triangles read;
  for (Vertex v : mesh.vertices()) read.places.push_back({s[v], u[v]});
  for (Face f : mesh.faces()) {
    CHECK_EQUAL(input_face[f], static_cast<std::int32_t>(refined.input_face[f].idx()));
    Halfedge h = mesh.halfedge(f);   // a mesh knows the circle of a face, not where it begins
    const auto begins = [&] { return mesh.point(mesh.source(h)) == t.mesh().point(t.source(t.halfedges(f)[0])); };
    for (int k = 0; k < 2 && !begins(); ++k) h = mesh.next(h);
    auto& triangle = read.vertices.emplace_back();
    for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
      const Vertex corner = t.source(t.halfedges(f)[k]);
      triangle[k] = mesh.source(h);
      CHECK(mesh.point(mesh.source(h)) == t.mesh().point(corner));
      CHECK_EQUAL(order[mesh.source(h)], q.order[corner]);
    }
  }
  check_moved_by_whole_units(read, q, 6e-8 * (1 + largest_coordinate(q)));
}

// ---- VTK

void check_vtk(const std::string& file, const Refined_surface& refined)
{
  const Quartic_differential& q = refined.differential;
  const Intrinsic_triangulation& t = q.triangulation;
  const std::vector<double> x = data_array(file, "NumberOfComponents=\"3\""), uv = data_array(file, "Name=\"uv\"");
  const std::vector<double> order = data_array(file, "Name=\"singularity_order\"");
  const std::vector<double> corner = data_array(file, "Name=\"connectivity\"");
  CHECK(file.find("<Piece NumberOfPoints=\"" + std::to_string(x.size() / 3) + "\" ") != std::string::npos);
  CHECK_EQUAL(uv.size(), x.size() / 3 * 2);
  CHECK_EQUAL(order.size(), x.size() / 3);
  CHECK_EQUAL(corner.size(), 3 * t.number_of_faces());
  std::vector<std::size_t> offsets, input_faces;
  for (Face f : t.faces()) {
    offsets.push_back(3 * f + 3);
    input_faces.push_back(refined.input_face[f]);
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = static_cast<std::size_t>(corner[3 * f + k]);
      const Halfedge h = t.halfedges(f)[k];
      CHECK(Point_3(x[3 * v], x[3 * v + 1], x[3 * v + 2]) == t.mesh().point(t.source(h)));
      CHECK((Place{uv[2 * v], uv[2 * v + 1]}) == chart_place(q, h));   // exact
      CHECK_EQUAL(order[v], q.order[t.source(h)]);
    }
  }
  check_data(file, "offsets", offsets);
  check_data(file, "input_face", input_faces);
}

void check_vtp(const Refined_surface& refined)
{
  std::ostringstream file;
  write_flat_vtp(file, refined);
  CHECK(file.str().find("<VTKFile type=\"PolyData\"") != std::string::npos);
  CHECK(file.str().find("NumberOfPolys=\"" + std::to_string(refined.input_face.size()) + '"') != std::string::npos);
  check_vtk(file.str(), refined);
}

void check_vtu(const Refined_surface& refined)
{
  std::ostringstream file;
  write_flat_vtu(file, refined);
  CHECK(file.str().find("<VTKFile type=\"UnstructuredGrid\"") != std::string::npos);
  CHECK(file.str().find("NumberOfCells=\"" + std::to_string(refined.input_face.size()) + '"') != std::string::npos);
  check_vtk(file.str(), refined);
  check_data(file.str(), "types", std::vector<int>(refined.input_face.size(), 5));   // VTK_TRIANGLE
}

// ---- glTF

std::uint32_t little_endian(const std::string& bytes, std::size_t at)
{
  std::uint32_t x = 0;
  for (int k = 3; k >= 0; --k) x = x << 8 | static_cast<unsigned char>(bytes.at(at + k));
  return x;
}

float float_at(const std::string& bytes, std::size_t at)
{
  const std::uint32_t bits = little_endian(bytes, at);
  float x;
  std::memcpy(&x, &bits, 4);
  return x;
}

// A file taken apart. (specification, section 4: Binary glTF)
struct Glb
{
  Json        json;
  std::string binary;

  explicit Glb(const std::string& file)
  {
    CHECK_EQUAL(file.substr(0, 4), "glTF");
    CHECK_EQUAL(little_endian(file, 4), 2u);
    CHECK_EQUAL(little_endian(file, 8), file.size());
    const std::size_t json_size = little_endian(file, 12);
    CHECK_EQUAL(json_size % 4, 0u);
    CHECK_EQUAL(file.substr(16, 4), "JSON");
    json = Json::parse(file.substr(20, json_size));
    const std::size_t second = 20 + json_size, binary_size = little_endian(file, second);
    CHECK_EQUAL(binary_size % 4, 0u);
    CHECK_EQUAL(file.substr(second + 4, 4), std::string("BIN\0", 4));
    binary = file.substr(second + 8);
    CHECK_EQUAL(binary.size(), binary_size);
    const std::size_t buffer_size = json["buffers"][0]["byteLength"];
    CHECK(buffer_size <= binary_size && buffer_size + 3 >= binary_size);
  }

  /// a view as (offset, length), which lies in the buffer
  std::array<std::size_t, 2> view(const Json& index) const
  {
    const Json& v = json["bufferViews"].at(index.get<std::size_t>());
    const std::size_t offset = v["byteOffset"], length = v["byteLength"];
    CHECK_EQUAL(v["buffer"], 0);
    CHECK_EQUAL(offset % 4, 0u);
    CHECK(offset + length <= json["buffers"][0]["byteLength"]);
    return {offset, length};
  }

  /// where the items of an accessor begin, which fill their view
  std::size_t items(const Json& accessor, const char* type, int component_type, int target) const
  {
    const std::size_t components = type == std::string("SCALAR") ? 1 : type[3] - '0', count = accessor["count"];
    CHECK_EQUAL(accessor["type"], type);
    CHECK_EQUAL(accessor["componentType"], component_type);
    CHECK_EQUAL(json["bufferViews"].at(accessor["bufferView"].get<std::size_t>())["target"], target);
    const auto [offset, length] = view(accessor["bufferView"]);
    CHECK_EQUAL(length, 4 * components * count);
    return offset;
  }
  template <std::size_t n>
  std::vector<std::array<float, n>> floats(const Json& accessor) const
  {
    const std::size_t begin = items(accessor, n == 2 ? "VEC2" : "VEC3", 5126, 34962);
    std::vector<std::array<float, n>> result(accessor["count"].get<std::size_t>());
    for (std::size_t i = 0; i < result.size(); ++i)
      for (std::size_t k = 0; k < n; ++k) result[i][k] = float_at(binary, begin + 4 * (n * i + k));
    return result;
  }
  std::vector<std::uint32_t> indices(const Json& accessor) const
  {
    const std::size_t begin = items(accessor, "SCALAR", 5125, 34963);
    std::vector<std::uint32_t> result(accessor["count"].get<std::size_t>());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = little_endian(binary, begin + 4 * i);
    return result;
  }
};

// A grey picture, row by row from the top.
struct Grey_picture
{
  png_image                 size{};
  std::vector<std::uint8_t> pixels;

  explicit Grey_picture(const std::string& file)
  {
    size.version = PNG_IMAGE_VERSION;
    CHECK(png_image_begin_read_from_memory(&size, file.data(), file.size()) != 0);
    size.format = PNG_FORMAT_GRAY;
    pixels.resize(PNG_IMAGE_SIZE(size));
    CHECK(png_image_finish_read(&size, nullptr, pixels.data(), 0, nullptr) != 0);
    CHECK(size.width >= 16 && size.width == size.height);
  }
  /// what a repeated texture shows at a place, x to the right and y down, in pictures
  std::uint8_t operator()(double x, double y) const
  {
    const auto pixel = [](double z, unsigned n) {
      return std::min(static_cast<unsigned>((z - std::floor(z)) * n), n - 1);
    };
    return pixels[pixel(y, size.height) * size.width + pixel(x, size.width)];
  }
};

void check_range(const Json& accessor, const std::vector<std::array<float, 3>>& points)
{
  for (int k = 0; k < 3; ++k) {
    const auto [least, most] = std::minmax_element(points.begin(), points.end(),
                                                   [k](const auto& p, const auto& q) { return p[k] < q[k]; });
    CHECK_EQUAL(accessor["min"][k].get<float>(), (*least)[k]);
    CHECK_EQUAL(accessor["max"][k].get<float>(), (*most)[k]);
  }
}

// The picture has the colours of flat.obj's, whose v points up, in the middle of every triangle.
void check_colours(const Grey_picture& picture, const Read_triangles& read, const Quartic_differential& q)
{
  std::ostringstream png;
  write_checkerboard_png(png, q);
  const Grey_picture of_obj(png.str());
  std::size_t wrong = 0, light = 0, lights = 0;
  for (Face f : q.triangulation.faces()) {
    Place expected{0, 0}, found{0, 0};
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 2; ++c) {
        expected[c] += chart_place(q, q.triangulation.halfedges(f)[k])[c] / 3;
        found[c] += read.places[read.vertices[f][k]][c] / 3;
      }
    light = of_obj(expected[0], 1 - expected[1]);
    lights += light > 200;
    wrong += picture(found[0], found[1]) != light;
  }
  CHECK(lights > q.triangulation.number_of_faces() / 10);   // there are squares of both colours
  CHECK(lights < q.triangulation.number_of_faces() * 9 / 10);
  CHECK(wrong <= q.triangulation.number_of_faces() / 1000);   // a middle may be rounded across the side of a square
}

void check_normals(const std::vector<std::array<float, 3>>& normals, const Read_triangles& read,
                   const Intrinsic_triangulation& t)
{
  for (const auto& n : normals) CHECK_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-6);
  for (Face f : t.faces()) {
    std::array<Point_3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = t.mesh().point(t.source(t.halfedges(f)[k]));
    const Vector_3 area = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    for (std::size_t v : read.vertices[f])
      CHECK(area * Vector_3(normals[v][0], normals[v][1], normals[v][2]) > 0);
  }
}

void check_glb(const Refined_surface& refined)
{
  const Quartic_differential& q = refined.differential;
  const Intrinsic_triangulation& t = q.triangulation;
  std::ostringstream out;
  write_flat_glb(out, refined);
  const Glb glb(out.str());
  CHECK_EQUAL(glb.json["asset"]["version"], "2.0");
  const Json& node = glb.json["nodes"].at(glb.json["scenes"].at(glb.json["scene"].get<int>())["nodes"].at(0).get<int>());
  const Json& primitive = glb.json["meshes"].at(node["mesh"].get<int>())["primitives"].at(0);
  CHECK(primitive.value("mode", 4) == 4);   // triangles
  const auto accessor = [&](const Json& index) { return glb.json["accessors"].at(index.get<std::size_t>()); };
  const auto positions = glb.floats<3>(accessor(primitive["attributes"]["POSITION"]));
  const auto normals = glb.floats<3>(accessor(primitive["attributes"]["NORMAL"]));
  const auto uv = glb.floats<2>(accessor(primitive["attributes"]["TEXCOORD_0"]));
  const auto corners = glb.indices(accessor(primitive["indices"]));
  CHECK_EQUAL(normals.size(), positions.size());
  CHECK_EQUAL(uv.size(), positions.size());
  CHECK_EQUAL(corners.size(), 3 * t.number_of_faces());
  CHECK(std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return v < positions.size(); }));
  check_range(accessor(primitive["attributes"]["POSITION"]), positions);

  Read_triangles read;
  for (const auto& [u, v] : uv) read.places.push_back({u, -v});
  CGAL::Bbox_3 box;
  for (Vertex v : t.vertices()) box += t.mesh().point(v).bbox();
  const double size = std::max({box.x_span(), box.y_span(), box.z_span()});
  const auto scale = node.value("scale", std::array<double, 3>{1, 1, 1});
  double farthest = 0;
  for (Face f : t.faces()) {
    auto& triangle = read.vertices.emplace_back();
    for (int k = 0; k < 3; ++k) {
      triangle[k] = corners[3 * f + k];
      for (int c = 0; c < 3; ++c) {
        const double x = positions[triangle[k]][c] * scale[c] + node["translation"][c].get<double>();
        farthest = std::max(farthest, std::abs(x - t.mesh().point(t.source(t.halfedges(f)[k]))[c]));
      }
    }
  }
  CHECK(farthest <= 3e-8 * size + 1e-16 * (std::abs(box.xmax()) + std::abs(box.ymax()) + std::abs(box.zmax())));
  check_moved_by_whole_units(read, q, 6e-8 * (1 + largest_coordinate(q)));
  for (auto& place : read.places) place[1] = -place[1];
  check_normals(normals, read, t);

  const Json& material = glb.json["materials"].at(primitive["material"].get<int>());
  const Json& index = material["pbrMetallicRoughness"]["baseColorTexture"]["index"];
  const Json& texture = glb.json["textures"].at(index.get<int>());
  const Json& sampler = glb.json["samplers"].at(texture["sampler"].get<int>());
  CHECK(sampler.value("wrapS", 10497) == 10497 && sampler.value("wrapT", 10497) == 10497);   // REPEAT
  const Json& image = glb.json["images"].at(texture["source"].get<int>());
  CHECK_EQUAL(image["mimeType"], "image/png");
  const auto [offset, length] = glb.view(image["bufferView"]);
  check_colours(Grey_picture(glb.binary.substr(offset, length)), read, q);
}

// ---- Surfaces

void check_all(const Refined_surface& refined)
{
  check_ply(refined);
  check_vtp(refined);
  check_vtu(refined);
  check_glb(refined);
}

// charts moved by many units, as far as the grid allows: floats would not do without whole units subtracted
void move_charts(Quartic_differential& q, std::int64_t units)
{
  const Grid_vector by{units << q.grid_exponent, -(units << q.grid_exponent)};
  for (Halfedge h : q.triangulation.halfedges()) q.corner[h] = q.corner[h] + by;
}

void transform_points(Quartic_differential& q, double scale, const Vector_3& translation)
{
  Mesh mesh = q.triangulation.mesh();
  for (Vertex v : mesh.vertices()) mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN) + translation;
  q.triangulation = Intrinsic_triangulation(std::move(mesh));
}

void surfaces_far_away(Refined_surface refined)
{
  const double extent = largest_coordinate(refined.differential);
  move_charts(refined.differential, 1000);
  CHECK(largest_coordinate(refined.differential) > 900);
  transform_points(refined.differential, 1, {1e5, -2e5, 5e4});
  std::ostringstream glb;
  write_flat_glb(glb, refined);
  const Glb file(glb.str());
  for (const auto& uv : file.floats<2>(file.json["accessors"][2]))
    CHECK(std::abs(uv[0]) <= 2 * extent + 1 && std::abs(uv[1]) <= 2 * extent + 1);
  check_glb(refined);
}

// sizes that single precision does not hold, near the largest and the smallest that the program reads
void surfaces_of_extreme_size(const Refined_surface& refined)
{
  for (double size : {5e39, 1e-39}) {
    Refined_surface r = refined;
    transform_points(r.differential, size, {size, -2 * size, size / 2});
    check_glb(r);
  }
}

void surface_without_positions(Refined_surface refined)
{
  const Intrinsic_triangulation& t = refined.differential.triangulation;
  Glued_triangles glued;
  for (Face f : t.faces()) {
    auto &triangle = glued.triangles.emplace_back();
    auto &opposite = glued.opposite.emplace_back();
    auto &lengths = glued.lengths.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = t.halfedges(f)[k], o = t.opposite(h);
      triangle[k] = static_cast<int>(t.source(h).idx());
      opposite[k] = {static_cast<int>(t.face(o).idx()), t.corner(o)};
      lengths[k] = t.length(t.edge(h));
    }
  }
  refined.differential.triangulation = Intrinsic_triangulation(glued);
  std::ostringstream out;
  CHECK_THROWS(write_flat_ply(out, refined, "flat.png"), Unusable_surface_error, "flat.ply");
  CHECK_THROWS(write_flat_vtp(out, refined), Unusable_surface_error, "flat.vtp");
  CHECK_THROWS(write_flat_vtu(out, refined), Unusable_surface_error, "flat.vtu");
  CHECK_THROWS(write_flat_glb(out, refined), Unusable_surface_error, "flat.glb");
}

} // namespace

int main()
{
  for (const Mesh& mesh : {handle_chain(0, 6), jittered_torus(20, 10, 0.3, 0.5, 2), handle_chain(2, 6)}) {
    const Quartic_differential_result r = run_pipeline(Intrinsic_triangulation(mesh));
    std::cout << r.refined->differential.triangulation.number_of_faces() << " triangles" << std::endl;
    check_all(*r.refined);
    surfaces_far_away(*r.refined);
    surfaces_of_extreme_size(*r.refined);
    surface_without_positions(*r.refined);
  }
  return result();
}
