// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Texture_vertices.h"
#include "little_endian.h"

#include <CGAL/Quartic_differentials/IO/write_checkerboard.h>
#include <CGAL/Quartic_differentials/IO/write_flat_surface.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/diagonal.h>
#include <CGAL/Quartic_differentials/internal/render.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Json = nlohmann::json;
using Floats = std::array<float, 3>;
const std::array<const char*, 5> vector_type{"", "SCALAR", "VEC2", "VEC3", "VEC4"};   // by number of components

// glTF's numbers (specification, 5.1.3, 5.11.5, 5.26)
enum : int { unsigned_int = 5125, single_precision = 5126, vertex_data = 34962, index_data = 34963, repeat = 10497,
             linear = 9729, linear_mipmap_linear = 9987 };

// What glTF draws: one position, normal and texture coordinate a vertex.
struct Gltf_surface
{
  double                                    unit;      // of length
  Floats                                    middle;    // positions are relative to this
  std::vector<Floats>                       positions, normals;
  std::vector<std::array<float, 2>>         uv;
  std::vector<std::array<std::uint32_t, 1>> corners;   // three a triangle
};

// 1, or a power of two near the size of a surface that is too large or too small for single precision
double unit_of_length(const Intrinsic_triangulation& t)
{
  const double size = internal::diagonal(t.mesh().points());
  return 1e-20 < size && size < 1e20 ? 1 : std::exp2(std::ilogb(size));
}

Floats middle_of(const Intrinsic_triangulation& t, double unit)
{
  const Bbox_3 box = bbox_3(t.mesh().points().begin(), t.mesh().points().end());
  Floats middle;
  for (int k = 0; k < 3; ++k) middle[k] = static_cast<float>((box.min(k) / 2 + box.max(k) / 2) / unit);
  return middle;
}

// by corner of a face; positions are made comparable to 1 first, so that squares of lengths stay in range
std::vector<std::array<Eigen::Vector3d, 3>> corner_normals(const Intrinsic_triangulation& t)
{
  const double size = internal::diagonal(t.mesh().points());
  std::vector<Point_3> points;
  for (Vertex v : t.vertices()) {
    const Point_3& p = t.mesh().point(v);
    points.emplace_back(p.x() / size, p.y() / size, p.z() / size);
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    triangles.push_back({t.source(h[0]), t.source(h[1]), t.source(h[2])});
  }
  return internal::smooth_normals(points, triangles);
}

// glTF wants length 1, also where a triangle has no area in doubles
Floats unit_vector(const Eigen::Vector3d& n)
{
  const Eigen::Vector3d unit = n.norm() > 0 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  return {static_cast<float>(unit.x()), static_cast<float>(unit.y()), static_cast<float>(unit.z())};
}

Gltf_surface gltf_surface(const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  Texture_vertices texture = texture_vertices(q);
  subtract_whole_units(texture, q);
  const auto normals = corner_normals(t);
  const auto in_units = [&](std::int64_t x) {
    return static_cast<float>(std::ldexp(static_cast<double>(x), -q.grid_exponent));
  };
  Gltf_surface s;
  s.unit = unit_of_length(t);
  s.middle = middle_of(t, s.unit);
  std::map<std::pair<std::size_t, Floats>, std::uint32_t> vertex;   // by texture vertex and normal
  for (Face f : t.faces()) {
    const auto corners = texture.triangle(t, f);
    for (int k = 0; k < 3; ++k) {
      const Floats normal = unit_vector(normals[f][k]);
      const auto [it, is_new] = vertex.try_emplace({corners[k], normal}, static_cast<std::uint32_t>(s.positions.size()));
      s.corners.push_back({it->second});
      if (!is_new) continue;
      const Point_3& p = t.mesh().point(texture.vertices[corners[k]]);
      Floats& position = s.positions.emplace_back();
      for (int c = 0; c < 3; ++c) position[c] = static_cast<float>(p[c] / s.unit - s.middle[c]);
      s.normals.push_back(normal);
      const Grid_vector z = texture.points[corners[k]];
      s.uv.push_back({in_units(z.x), -in_units(z.y)});   // 1 - v, but for a whole unit: the origin is at the upper left
    }
  }
  return s;
}

// The binary chunk, and the parts of the JSON that say what lies where in it.
class Gltf_buffer
{
public:
  // returns the index of the accessor
  template <class Number, std::size_t n>
  int add(const std::vector<std::array<Number, n>>& items, int component_type, int target, bool with_range)
  {
    const std::size_t begin = m_bytes.size();
    for (const auto& item : items)
      for (Number x : item) append_little_endian(m_bytes, x);
    Json accessor = {{"bufferView", add_view(begin, target)}, {"componentType", component_type}, {"count", items.size()},
                     {"type", vector_type[n]}};
    if (with_range) {
      std::array<Number, n> least = items.front(), most = items.front();
      for (const auto& item : items)
        for (std::size_t k = 0; k < n; ++k) {
          least[k] = std::min(least[k], item[k]);
          most[k] = std::max(most[k], item[k]);
        }
      accessor["min"] = least;
      accessor["max"] = most;
    }
    accessors.push_back(accessor);
    return static_cast<int>(accessors.size()) - 1;
  }

  // returns the index of the view
  int add_image(const std::string& png)
  {
    const std::size_t begin = m_bytes.size();
    m_bytes += png;
    return add_view(begin, 0);
  }

  const std::string& bytes() const { return m_bytes; }

  Json accessors = Json::array(), views = Json::array();

private:
  int add_view(std::size_t begin, int target)
  {
    Json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", m_bytes.size() - begin}};
    if (target != 0) view["target"] = target;
    views.push_back(view);
    m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0');   // the next one is aligned
    return static_cast<int>(views.size()) - 1;
  }

  std::string m_bytes;
};

Json list_of_one(Json item)
{
  Json list = Json::array();
  list.push_back(std::move(item));
  return list;
}

// brings positions back to where they belong
Json gltf_node(const Gltf_surface& s)
{
  Json node = {{"name", "surface"}, {"mesh", 0}};
  for (float x : s.middle) node["translation"].push_back(x * s.unit);
  if (s.unit != 1) node["scale"] = {s.unit, s.unit, s.unit};
  return node;
}

Json gltf_json(const Gltf_surface& s, const std::string& png, Gltf_buffer& buffer)
{
  const Json attributes = {{"POSITION", buffer.add(s.positions, single_precision, vertex_data, true)},
                           {"NORMAL", buffer.add(s.normals, single_precision, vertex_data, false)},
                           {"TEXCOORD_0", buffer.add(s.uv, single_precision, vertex_data, false)}};
  const int indices = buffer.add(s.corners, unsigned_int, index_data, false);
  const int image = buffer.add_image(png);
  const Json primitive = {{"attributes", attributes}, {"indices", indices}, {"material", 0}};
  const Json shading = {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}};
  return {{"asset", {{"version", "2.0"}, {"generator", "CGAL Quartic Differentials"}}},
          {"scene", 0},
          {"scenes", list_of_one({{"nodes", list_of_one(0)}})},
          {"nodes", list_of_one(gltf_node(s))},
          {"meshes", list_of_one({{"primitives", list_of_one(primitive)}})},
          {"materials", list_of_one({{"name", "checkerboard"}, {"doubleSided", true}, {"pbrMetallicRoughness", shading}})},
          {"textures", list_of_one({{"sampler", 0}, {"source", 0}})},
          {"samplers", list_of_one({{"wrapS", repeat}, {"wrapT", repeat}, {"magFilter", linear},
                                    {"minFilter", linear_mipmap_linear}})},
          {"images", list_of_one({{"bufferView", image}, {"mimeType", "image/png"}})},
          {"accessors", buffer.accessors},
          {"bufferViews", buffer.views},
          {"buffers", list_of_one({{"byteLength", buffer.bytes().size()}})}};
}

void append_chunk(std::string& file, const char* type, std::string contents, char padding)
{
  contents.resize((contents.size() + 3) / 4 * 4, padding);
  append_little_endian(file, static_cast<std::uint32_t>(contents.size()));
  file.append(type, 4);
  file += contents;
}

} // namespace

void write_flat_glb(std::ostream& out, const Refined_surface& refined)
{
  const Quartic_differential& q = refined.differential;
  internal::require_embedded(q.triangulation, "flat.glb");
  std::ostringstream png;
  write_checkerboard_png(png, q);
  Gltf_buffer buffer;
  const Json json = gltf_json(gltf_surface(q), png.str(), buffer);
  std::string chunks;
  append_chunk(chunks, "JSON", json.dump(), ' ');
  append_chunk(chunks, "BIN\0", buffer.bytes(), '\0');
  const std::size_t length = 12 + chunks.size();
  if (length > std::numeric_limits<std::uint32_t>::max())
    throw Error("flat.glb would be larger than 4 GiB, the most that binary glTF allows");
  std::string header = "glTF";
  append_little_endian(header, std::uint32_t(2));
  append_little_endian(header, static_cast<std::uint32_t>(length));
  out << header;
  out.write(chunks.data(), static_cast<std::streamsize>(chunks.size()));
}

} } // namespace CGAL::Quartic_differentials
