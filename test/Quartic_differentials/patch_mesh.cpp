// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The input cut along the arcs of its T-mesh: a closed mesh, in which every patch is a disk and fills its rectangle.

#include "check.h"
#include "exact_charts.h"
#include "named_surfaces.h"
#include "own_input.h"

#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/internal/read_obj.h>
#include <CGAL/Quartic_differentials/patch_mesh.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

/// a patch mesh with its property maps
struct Patches
{
  Mesh                                      mesh;
  Mesh::Property_map<Face, std::uint32_t>   patch;
  Mesh::Property_map<Face, Face>            input_face;
  Mesh::Property_map<Halfedge, Point_2>     texture;
  Mesh::Property_map<Edge, std::uint32_t>   arc;
  Mesh::Property_map<Vertex, Surface_point> place;
  Mesh::Property_map<Vertex, int>           order;

  explicit Patches(Mesh m)   // add_property_map() finds what is there; CGAL 5 and 6 agree on its result
    : mesh(std::move(m)), patch(mesh.add_property_map<Face, std::uint32_t>("f:patch").first),
      input_face(mesh.add_property_map<Face, Face>("f:input_face").first),
      texture(mesh.add_property_map<Halfedge, Point_2>("h:texture").first),
      arc(mesh.add_property_map<Edge, std::uint32_t>("e:arc").first),
      place(mesh.add_property_map<Vertex, Surface_point>("v:input_point").first),
      order(mesh.add_property_map<Vertex, int>("v:singularity_order").first) {}

  Halfedge halfedge(Edge e) const { return mesh.halfedge(e); }
  std::size_t patch_left_of(Halfedge h) const { return patch[mesh.face(h)]; }
  bool on_arc(Halfedge h) const { return arc[mesh.edge(h)] != no_arc; }
  /// where h begins and ends in the patch on its left
  Point_2 begin(Halfedge h) const { return texture[mesh.prev(h)]; }
  Point_2 end(Halfedge h) const { return texture[h]; }
};

double area(const Mesh& mesh, Face f)
{
  const Halfedge h = mesh.halfedge(f);
  const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h));
  const Point_3 &c = mesh.point(mesh.target(mesh.next(h)));
  return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
}

// whether the corners of a face lie on one edge of the input
bool is_flat(const Patches& p, Face f, const Intrinsic_triangulation& input)
{
  std::set<Vertex> between;   // the vertices of the input between which they lie
  for (Vertex v : CGAL::vertices_around_face(p.mesh.halfedge(f), p.mesh)) {
    const auto h = input.halfedges(p.place[v].face);
    for (int k = 0; k < 3; ++k)
      if (p.place[v].barycentric[k] != 0) between.insert(input.source(h[k]));
  }
  return between.size() < 3;
}

// It is the refined surface, with more vertices.
void check_surface(const Patches& p, const Intrinsic_triangulation& input, const Refined_surface& refined)
{
  const Mesh& mesh = p.mesh;
  CHECK(CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh) && CGAL::is_valid_polygon_mesh(mesh) && mesh.is_valid());
  const long euler = static_cast<long>(mesh.number_of_vertices()) - static_cast<long>(mesh.number_of_edges())
                   + static_cast<long>(mesh.number_of_faces());
  CHECK_EQUAL(euler, 2 - 2 * input.genus());
  const Intrinsic_triangulation& t = refined.differential.triangulation;
  for (Vertex v : t.vertices()) CHECK(mesh.point(v) == t.mesh().point(v));

  std::vector<double> filled(input.number_of_faces(), 0);
  for (Face f : mesh.faces()) filled[p.input_face[f]] += area(mesh, f);
  for (Face f : input.faces()) CHECK_NEAR(filled[f], area(input.mesh(), f), 1e-12 * input.area());

  CHECK(std::none_of(mesh.faces().begin(), mesh.faces().end(), [&](Face f) { return is_flat(p, f, input); }));

  int degree = 0;
  double farthest = 0;
  for (Vertex v : mesh.vertices()) {
    degree += p.order[v];
    farthest = std::max(farthest, CGAL::squared_distance(position_on_input(input, p.place[v]), mesh.point(v)));
  }
  CHECK_EQUAL(degree, 8 * input.genus() - 8);
  CHECK(std::sqrt(farthest / input.area()) < 1e-9);
}

// Cut open along the arcs, the connected parts are the patches, and each is a disk: V - E + F is counted without the
// boundary, which has as many vertices as edges.
void check_disks(const Patches& p, std::size_t number_of_patches)
{
  const Mesh& mesh = p.mesh;
  std::vector<long> euler(number_of_patches, 0), parts(number_of_patches, 0);
  for (Face f : mesh.faces()) ++euler[p.patch[f]];
  for (Edge e : mesh.edges())
    if (!p.on_arc(p.halfedge(e))) --euler[p.patch_left_of(p.halfedge(e))];
  for (Vertex v : mesh.vertices()) {
    const auto round = CGAL::halfedges_around_target(v, mesh);
    if (std::none_of(round.begin(), round.end(), [&](Halfedge h) { return p.on_arc(h); }))
      ++euler[p.patch_left_of(mesh.halfedge(v))];
  }
  std::vector<char> seen(mesh.number_of_faces(), false);
  for (Face start : mesh.faces()) {
    if (seen[start]) continue;
    ++parts[p.patch[start]];
    std::vector<Face> stack{start};
    seen[start] = true;
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      for (Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        const Face g = mesh.face(mesh.opposite(h));
        if (p.on_arc(h) || seen[g]) continue;
        seen[g] = true;
        stack.push_back(g);
      }
    }
  }
  for (std::size_t k = 0; k < number_of_patches; ++k) {
    CHECK_EQUAL(euler[k], 1);
    CHECK_EQUAL(parts[k], 1);
  }
}

// only coordinates that are 0 are rounded to 0
bool are_on_one_axis(const std::array<Point_2, 3>& corner)
{
  return std::all_of(corner.begin(), corner.end(), [](const Point_2& z) { return z.x() == 0; })
      || std::all_of(corner.begin(), corner.end(), [](const Point_2& z) { return z.y() == 0; });
}

// The triangles of a patch fill its rectangle and fit together in it.
// \param is_resolved doubles can tell all points apart
void check_rectangles(const Patches& p, const T_mesh& t, bool is_resolved)
{
  const double unit = std::ldexp(1.0, -t.grid_exponent);
  const auto width = [&](std::size_t patch) { return static_cast<double>(t.patches[patch].width) * unit; };
  const auto height = [&](std::size_t patch) { return static_cast<double>(t.patches[patch].height) * unit; };
  std::vector<double> filled(t.patches.size(), 0);
  std::size_t not_positive = 0, on_one_axis = 0;
  for (Face f : p.mesh.faces()) {
    const Halfedge h = p.mesh.halfedge(f);
    const double doubled = CGAL::determinant(p.end(h) - p.begin(h), p.end(p.mesh.next(h)) - p.begin(h));
    filled[p.patch[f]] += doubled / 2;
    not_positive += doubled <= 0;
    on_one_axis += are_on_one_axis({p.end(h), p.begin(h), p.end(p.mesh.next(h))});
  }
  CHECK(!is_resolved || not_positive == 0);
  CHECK_EQUAL(on_one_axis, 0u);
  for (std::size_t k = 0; k < t.patches.size(); ++k) CHECK_NEAR(filled[k], width(k) * height(k), 1e-12 * filled[k]);
  for (Halfedge h : p.mesh.halfedges()) {
    const Point_2 a = p.begin(h), b = p.end(h);
    const std::size_t patch = p.patch_left_of(h);
    CHECK(b.x() >= 0 && b.x() <= width(patch) && b.y() >= 0 && b.y() <= height(patch));
    const Halfedge o = p.mesh.opposite(h);
    if (!p.on_arc(h)) CHECK(patch == p.patch_left_of(o) && a == p.end(o) && b == p.begin(o));
    else
      CHECK((a.y() == 0 && b.y() == 0 && a.x() <= b.x()) || (a.x() == width(patch) && b.x() == a.x() && a.y() <= b.y())
            || (a.y() == height(patch) && b.y() == a.y() && a.x() >= b.x())
            || (a.x() == 0 && b.x() == 0 && a.y() >= b.y()));
    CHECK(!is_resolved || a != b);
  }
}

// Every arc is a path of edges of its length.
void check_arcs(const Patches& p, const T_mesh& t)
{
  std::vector<std::size_t> edges(t.arcs.size(), 0);
  std::vector<double> length(t.arcs.size(), 0);
  std::int64_t largest = 0;
  for (const T_mesh::Patch& patch : t.patches) largest = std::max({largest, patch.width, patch.height});
  const double rounding = std::ldexp(static_cast<double>(largest), -t.grid_exponent - 50);
  for (Edge e : p.mesh.edges()) {
    const Halfedge h = p.halfedge(e);
    if (!p.on_arc(h)) continue;
    ++edges[p.arc[e]];
    length[p.arc[e]] += std::sqrt(CGAL::squared_distance(p.begin(h), p.end(h)));
  }
  for (std::size_t a = 0; a < t.arcs.size(); ++a) {
    const double whole = std::ldexp(static_cast<double>(t.arcs[a].length), -t.grid_exponent);
    CHECK_EQUAL(edges[a], t.arcs[a].path.size());
    CHECK_NEAR(length[a], whole, 1e-12 * whole + rounding);
  }
}

// tmesh.obj read back: it is the mesh, with a group for every patch and a path from end to end for every arc.
void check_obj(const Patches& p, const T_mesh& t)
{
  const std::string path = (std::filesystem::temp_directory_path()
                            / ("tmesh_" + std::to_string(std::random_device{}()) + ".obj")).string();
  {
    std::ofstream out(path);
    write_t_mesh_obj(out, p.mesh);
  }
  const internal::Obj_file file = internal::read_obj(path);
  std::filesystem::remove(path);
  CHECK_EQUAL(file.points.size(), p.mesh.number_of_vertices());
  for (Vertex v : p.mesh.vertices()) CHECK(file.points[v] == p.mesh.point(v));
  CHECK_EQUAL(file.faces.size(), p.mesh.number_of_faces());

  std::vector<Face> in_file(p.mesh.faces().begin(), p.mesh.faces().end());   // patch by patch, otherwise in their order
  std::stable_sort(in_file.begin(), in_file.end(), [&](Face f, Face g) { return p.patch[f] < p.patch[g]; });
  std::map<std::size_t, std::size_t> patch_of;                                 // by texture vertex
  for (std::size_t i = 0; i < in_file.size(); ++i) {
    const internal::Obj_file::Element& f = file.faces[i];
    const std::size_t patch = p.patch[in_file[i]];
    CHECK_EQUAL(f.group, "patch_" + std::to_string(patch));
    std::size_t k = 0;
    for (Halfedge h : p.mesh.halfedges_around_face(p.mesh.halfedge(in_file[i]))) {
      CHECK_EQUAL(f.vertices.at(k), p.mesh.target(h));
      CHECK(Point_2(file.texture[f.texture.at(k)][0], file.texture[f.texture[k]][1]) == p.texture[h]);
      CHECK_EQUAL(patch_of.try_emplace(f.texture[k], patch).first->second, patch);   // shared in patches only
      ++k;
    }
  }
  CHECK_EQUAL(file.lines.size(), t.arcs.size());
  for (std::size_t a = 0; a < std::min(file.lines.size(), t.arcs.size()); ++a) {
    CHECK_EQUAL(file.lines[a].group, "arc_" + std::to_string(a));
    CHECK_EQUAL(file.lines[a].vertices.size(), t.arcs[a].path.size() + 1);
    std::set<Edge> edges;
    for (std::size_t k = 0; k + 1 < file.lines[a].vertices.size(); ++k) {
      const Vertex v(file.lines[a].vertices[k]), w(file.lines[a].vertices[k + 1]);
      for (Halfedge h : p.mesh.halfedges_around_target(p.mesh.halfedge(w)))
        if (p.mesh.source(h) == v && p.arc[p.mesh.edge(h)] == a) edges.insert(p.mesh.edge(h));
    }
    CHECK_EQUAL(edges.size(), t.arcs[a].path.size());
  }
}

void check_patch_mesh(const Patches& p, const T_mesh& t, const Intrinsic_triangulation& input,
                      const Refined_surface& refined, bool is_resolved)
{
  check_surface(p, input, refined);
  check_disks(p, t.patches.size());
  check_rectangles(p, t, is_resolved);
  check_arcs(p, t);
  check_obj(p, t);
}

// CGAL writes it with its numbers, and reads them back.
void check_ply(const Patches& p)
{
  std::stringstream file;
  CGAL::IO::set_binary_mode(file);
  CHECK(CGAL::IO::write_PLY(file, p.mesh));
  Mesh read;
  std::string comments;
  CHECK(CGAL::IO::read_PLY(file, read, comments));
  CHECK_EQUAL(read.number_of_faces(), p.mesh.number_of_faces());
  const auto [patch, is_new_patch] = read.add_property_map<Face, std::uint32_t>("f:patch");   // finds what was read
  const auto [arc, is_new_arc] = read.add_property_map<Edge, std::uint32_t>("e:arc");
  CHECK(!is_new_patch && !is_new_arc);
  for (Face f : read.faces()) CHECK_EQUAL(patch[f], p.patch[f]);
  std::size_t on_arcs = 0, read_on_arcs = 0;
  for (Edge e : p.mesh.edges()) on_arcs += p.arc[e] != no_arc;
  for (Edge e : read.edges()) read_on_arcs += arc[e] != no_arc;
  CHECK_EQUAL(read_on_arcs, on_arcs);
  CHECK(on_arcs > 0);
}

void sample_surface(const Quartic_test::Named_surface& named)
{
  Visitor quiet;
  Quartic_differential_result result;
  quartic_differential(named.surface, std::nullopt, {}, quiet, result);
  if (!result.refined) return;
  const Patches patches(patch_mesh(*result.t_mesh, *result.refined));
  std::cout << named.name << ": " << result.t_mesh->patches.size() << " patches, "
            << result.refined->differential.triangulation.number_of_faces() << " -> " << patches.mesh.number_of_faces()
            << " faces" << std::endl;
  check_patch_mesh(patches, *result.t_mesh, named.surface, *result.refined, true);
  check_ply(patches);
}

// Surfaces glued from squares: arcs run along edges, through vertices, and very near to them.

/// a surface as its own input, with random places in space for its vertices
Refined_surface placed_at_random(Quartic_differential q, std::mt19937& random)
{
  Mesh mesh = q.triangulation.mesh();
  const auto coordinate = [&] { return Quartic_test::uniform(random, 0, 1); };
  for (Vertex v : mesh.vertices()) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    mesh.point(v) = Point_3(x, y, z);
  }
  q.triangulation = Intrinsic_triangulation(std::move(mesh));
  return Quartic_test::own_input(q);
}

/// a side of the squares: slanted by little, by nothing or by 45 degrees; on large ones, pieces are thinner than the
/// rounding of doubles
Grid_vector random_side(bool is_large, std::mt19937& random)
{
  const std::int64_t length = is_large ? std::int64_t(1) << 40 : 3 + random() % 3;
  return {length, random() % 3 == 0 ? length : static_cast<std::int64_t>(random() % 3)};
}

Quartic_differential random_differential(bool is_large, std::mt19937& random)
{
  using namespace Quartic_test;
  const int squares = 1 + static_cast<int>(random() % 6);
  Gluing glued;
  do glued = random_gluing(squares, random);
  while (!is_connected(glued));
  const Grid_vector u = random_side(is_large, random);
  Quartic_differential q = exact_differential(subdivided(glued, 3), u, rotated(u, 1));
  if (q.singularities.empty()) q.singularities.push_back(Vertex(0));
  flip_exactly(q, static_cast<int>(random() % 100), 4 * u.x, random);
  return q;
}

/// no loops, no parallel edges
bool is_simple(const Intrinsic_triangulation& t)
{
  std::set<std::pair<Vertex, Vertex>> ends;
  for (Halfedge h : t.halfedges()) ends.emplace(t.source(h), t.target(h));
  const auto is_loop = [&](Halfedge h) { return t.source(h) == t.target(h); };
  return ends.size() == t.number_of_halfedges() && std::none_of(t.halfedges().begin(), t.halfedges().end(), is_loop);
}

void degenerate_surfaces()
{
  std::mt19937 random(9);
  std::size_t tried = 0;
  for (int done = 0; done < 200; ++tried) {
    const bool is_large = tried % 2 == 0;
    const Quartic_differential q = random_differential(is_large, random);
    if (!is_simple(q.triangulation)) continue;
    const Refined_surface refined = placed_at_random(q, random);
    Visitor quiet;
    const T_mesh t = t_mesh(refined.differential, quiet);
    check_patch_mesh(Patches(patch_mesh(t, refined)), t, refined.differential.triangulation, refined,
                     !is_large);
    ++done;
  }
  std::cout << tried << " square-tiled surfaces" << std::endl;
}

} // namespace

int main()
{
  for (const Quartic_test::Named_surface& named : Quartic_test::sample_surfaces()) sample_surface(named);
  degenerate_surfaces();
  return Quartic_test::result();
}
