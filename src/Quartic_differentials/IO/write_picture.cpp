// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Vtk_poly_data.h"
#include "picture_scenes.h"

#include <CGAL/Quartic_differentials/IO/write_picture.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/read_obj.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Camera;
using internal::Obj_file;
using internal::Scene;
using Json = nlohmann::json;
using Indices = std::vector<std::size_t>;

// ---- Taking a picture

Eigen::Vector3d vector(const Vector_3& v) { return {v.x(), v.y(), v.z()}; }

Camera camera_for(const Scene& scene, const Picture_options& options)
{
  const Camera automatic = internal::automatic_camera(scene.points, scene.triangles);
  if (!options.direction && !options.up) return automatic;
  const Eigen::Vector3d eye = options.direction ? vector(*options.direction) : automatic.towards_eye;
  return internal::camera(eye, options.up ? vector(*options.up) : internal::usual_up(eye));
}

void write_scene(std::ostream& out, const Scene& scene, const Camera& camera, const Picture_options& options)
{
  internal::Image image = internal::render(scene, camera, options.size);
  if (options.both_sides)
    image = internal::side_by_side(image, internal::render(scene, camera.turned_round(), options.size));
  internal::write_png(out, image);
}

// ---- Files of a run

// Calls read(path) so that what it throws is one sentence that names the file.
template <class Read>
auto from_file(const std::string& folder, const std::string& name, Read read)
{
  const std::string path = folder + "/" + name;
  try {
    if (!std::filesystem::is_regular_file(path)) throw Unusable_surface_error("there is no such file");
    return read(path);
  }
  catch (const Error& e) { throw Unusable_surface_error(path + ": " + e.what()); }
  catch (const Json::exception&) { throw Unusable_surface_error(path + ": this is not JSON as a run writes it"); }
}

using internal::most_patches;

Point_3 point(const Json& p) { return {p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<double>()}; }

std::vector<Marked_point> read_marked_points(const std::string& path)
{
  std::ifstream in(path);
  std::vector<Marked_point> result;
  const Json report = Json::parse(in);
  if (!report.contains("singularities")) return result;   // the run did not come so far
  for (const Json& s : report["singularities"])
    if (s.contains("position")) result.push_back({point(s["position"]), s.at("order").get<int>()});
  return result;
}

struct Flat_surface
{
  std::vector<Point_3>                        points;
  std::vector<Triangle>                       triangles;
  std::vector<std::array<Eigen::Vector2d, 3>> uv;
};

Flat_surface read_flat_surface(const std::string& path)
{
  const Obj_file file = internal::read_obj(path);
  Flat_surface surface{file.points, {}, {}};
  for (const Obj_file::Element& f : file.faces) {
    if (f.vertices.size() != 3 || f.texture.size() != 3)
      throw Unusable_surface_error("a face is not a triangle with texture coordinates");
    surface.triangles.push_back({f.vertices[0], f.vertices[1], f.vertices[2]});
    auto& uv = surface.uv.emplace_back();
    for (int k = 0; k < 3; ++k) uv[k] = {file.texture[f.texture[k]][0], file.texture[f.texture[k]][1]};
  }
  if (surface.triangles.empty()) throw Unusable_surface_error("there is no triangle");
  return surface;
}

std::vector<Drawn_loop> read_loops(const std::string& path)
{
  const Obj_file file = internal::read_obj(path);
  const auto is = [](const std::string& group, const char* kind) { return group.find(kind) != std::string::npos; };
  std::vector<Drawn_loop> loops;
  for (const Obj_file::Element& line : file.lines) {
    Drawn_loop loop{{}, is(line.group, "tunnel") ? Drawn_loop::Kind::tunnel
                      : is(line.group, "handle") ? Drawn_loop::Kind::handle : Drawn_loop::Kind::unknown};
    for (std::size_t v : line.vertices) loop.points.push_back(file.points[v]);
    loops.push_back(std::move(loop));
  }
  return loops;
}

struct Cut_surface
{
  std::vector<Point_3>              points;
  std::vector<Indices>              polygons;
  Indices                           patch;   // by polygon
  std::vector<std::vector<Point_3>> arcs;
};

Cut_surface read_cut_surface(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  const Vtk_poly_data file({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
  if (file.number_of_pieces() != 1) throw Unusable_surface_error("this is not VTK's XML as a run writes it");
  Cut_surface result{file.points(0), file.cells(0, "Polys"), {}, {}};
  for (const Indices& line : file.cells(0, "Lines")) {
    result.arcs.emplace_back();
    for (std::size_t v : line) result.arcs.back().push_back(result.points[v]);
  }
  if (result.polygons.empty()) throw Unusable_surface_error("there is no polygon");
  const std::vector<std::int64_t> patch = file.cell_data(0, "patch");   // lines come first
  if (patch.size() != result.arcs.size() + result.polygons.size()) throw Unusable_surface_error("a cell has no patch");
  for (std::size_t i = result.arcs.size(); i < patch.size(); ++i) {
    result.patch.push_back(static_cast<std::size_t>(patch[i]));       // beyond the range if negative
    if (result.patch.back() > most_patches) throw Unusable_surface_error("a patch is out of range");
  }
  return result;
}

// which patches share an arc
Neighbours read_neighbours(const std::string& path)
{
  std::ifstream in(path);
  const Json json = Json::parse(in);
  std::map<long, std::size_t> patch_at;   // by arc: the first patch that was found beside it
  Neighbours result;
  for (const Json& patch : json.at("patches"))
    for (const Json& side : patch.at("sides"))
      for (const Json& piece : side) {
        const std::size_t id = patch.at("id").get<std::size_t>();
        if (id > most_patches) throw Unusable_surface_error("a patch is out of range");
        result.insert({patch_at.try_emplace(piece.at("arc").get<long>(), id).first->second, id});
      }
  return result;
}

// ---- The pictures of a folder

std::vector<std::string> files_of(Picture picture)
{
  switch (picture) {
    case Picture::checkerboard: return {"flat.obj"};
    case Picture::t_mesh:       return {"tmesh.vtp", "tmesh.json"};
    case Picture::quads:        return {"quads.obj"};
    case Picture::wireframe:    return {"flat.obj"};
    default:                    return {"loops.obj", "flat.obj"};
  }
}

Scene scene_of(const std::string& folder, Picture picture, const std::vector<Marked_point>& singularities)
{
  const auto surface = [&] { return from_file(folder, "flat.obj", read_flat_surface); };
  switch (picture) {
    case Picture::checkerboard: {
      Flat_surface s = surface();
      return checkerboard_scene(std::move(s.points), std::move(s.triangles), std::move(s.uv), singularities);
    }
    case Picture::t_mesh: {
      const Cut_surface c = from_file(folder, "tmesh.vtp", read_cut_surface);
      return patches_scene(c.points, c.polygons, c.patch, from_file(folder, "tmesh.json", read_neighbours), c.arcs,
                           singularities);
    }
    case Picture::quads: {
      const internal::Quads_obj q = from_file(folder, "quads.obj", internal::read_quads_obj);
      return quads_scene(q.points, q.quads, q.patch, singularities);
    }
    case Picture::wireframe: {
      Flat_surface s = surface();
      return wireframe_scene(std::move(s.points), std::move(s.triangles), singularities);
    }
    default: {
      Flat_surface s = surface();
      return loops_scene(std::move(s.points), std::move(s.triangles), from_file(folder, "loops.obj", read_loops),
                         singularities);
    }
  }
}

} // namespace

void write_quads_picture(std::ostream& out, const Quad_mesh& m, const T_mesh& t, const Picture_options& options)
{
  std::vector<Marked_point> singularities;
  for (const T_mesh::Node& node : t.nodes)
    if (node.is_singularity()) singularities.push_back({m.points[m.singularities[singularities.size()]], node.order});
  const Scene scene = quads_scene(m.points, m.quads, m.patch, singularities);
  write_scene(out, scene, camera_for(scene, options), options);
}

std::string picture_name(Picture picture)
{
  switch (picture) {
    case Picture::checkerboard: return "picture_checkerboard.png";
    case Picture::t_mesh:       return "picture_tmesh.png";
    case Picture::quads:        return "picture_quads.png";
    case Picture::wireframe:    return "picture_wireframe.png";
    default:                    return "picture_loops.png";
  }
}

std::vector<std::string> missing_files(const std::string& folder, Picture picture)
{
  std::vector<std::string> missing;
  for (const std::string& name : files_of(picture))
    if (!std::filesystem::is_regular_file(folder + "/" + name)) missing.push_back(name);
  return missing;
}

void write_pictures(const std::string& folder, const std::vector<Picture>& pictures, const std::string& target,
                    const Picture_options& options)
{
  if (!std::filesystem::is_directory(folder)) throw Unusable_surface_error("there is no folder " + folder);
  const std::vector<Marked_point> singularities = from_file(folder, "report.json", read_marked_points);
  std::optional<Camera> camera;
  for (Picture picture : pictures) {
    const Scene scene = scene_of(folder, picture, singularities);
    if (!camera) camera = camera_for(scene, options);
    internal::write_file(target + "/" + picture_name(picture),
                         [&](std::ostream& out) { write_scene(out, scene, *camera, options); });
  }
}

} } // namespace CGAL::Quartic_differentials
