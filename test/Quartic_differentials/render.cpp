// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures show what the scene says: areas, what hides what, where the texture changes; and the program draws results.

#include <CGAL/Quartic_differentials/IO/write_picture.h>
#include <CGAL/Quartic_differentials/internal/checkerboard.h>
#include <CGAL/Quartic_differentials/internal/different_colours.h>
#include <CGAL/Quartic_differentials/internal/render.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include "check.h"
#include "run_program.h"

#include <Eigen/Geometry>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>

using namespace CGAL::Quartic_differentials;
using namespace CGAL::Quartic_differentials::internal;
using Quartic_test::Outcome;
using Quartic_test::contains;
using Quartic_test::contents;

namespace {

const Colour black{0, 0, 0}, red{1, 0, 0}, blue{0, 0, 1};
const double pi = half_turn<double>();

Camera from(double x, double y, double z) { return camera({x, y, z}, Eigen::Vector3d::UnitY()); }

std::array<int, 3> pixel(const Image& i, int x, int y) { return {i.at(x, y, 0), i.at(x, y, 1), i.at(x, y, 2)}; }
bool is_red(const std::array<int, 3>& c)   { return c[0] > 100 && c[1] < 60 && c[2] < 60; }
bool is_blue(const std::array<int, 3>& c)  { return c[2] > 100 && c[0] < 60 && c[1] < 60; }
bool is_dark(const std::array<int, 3>& c)  { return std::max({c[0], c[1], c[2]}) < 128; }
bool is_white(const std::array<int, 3>& c) { return std::min({c[0], c[1], c[2]}) == 255; }

template <class Holds>
int count(const Image& image, Holds holds)
{
  int n = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (holds(pixel(image, x, y))) ++n;
  return n;
}

// the square of the points with |x|, |y| <= size and this z, in front of nothing
void add_square(Scene& scene, double size, double z, const Colour& colour)
{
  const std::size_t n = scene.points.size();
  for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
    scene.points.emplace_back(size * x, size * y, z);
  for (std::size_t k : {1, 2}) {
    scene.triangles.push_back({n, n + k, n + k + 1});
    scene.colours.push_back(colour);
  }
  scene.normals = smooth_normals(scene.points, scene.triangles);
}

std::string png(const Image& image)
{
  std::ostringstream out;
  write_png(out, image);
  return out.str();
}

Image decoded(const std::string& file)
{
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  CHECK(png_image_begin_read_from_memory(&png, file.data(), file.size()));
  png.format = PNG_FORMAT_RGB;
  Image image = blank_image(static_cast<int>(png.width), static_cast<int>(png.height), 3, 0);
  CHECK(png_image_finish_read(&png, nullptr, image.bytes.data(), 0, nullptr));
  return image;
}

// ---- The renderer

// Two balls of radius 1, ten apart: their distance in the picture is its scale.
void balls_cover_their_area()
{
  Scene scene;
  scene.balls = {{Point_3(0, 0, 0), 1, black}, {Point_3(10, 0, 0), 1, black}};
  for (const Camera& c : {from(0, 0, 1), from(0, 1, 1)}) {
    const Image image = render(scene, c, 1000);
    double area[2] = {0, 0}, x_sum[2] = {0, 0};
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (is_dark(pixel(image, x, y))) {
          const int half = 2 * x < image.width ? 0 : 1;
          ++area[half];
          x_sum[half] += x;
        }
    const double scale = (x_sum[1] / area[1] - x_sum[0] / area[0]) / 10;
    CHECK(scale > 50);
    for (double a : area) CHECK_NEAR(a / (pi * scale * scale), 1, 0.01);
  }
}

void tubes_cover_their_area()
{
  Scene scene;
  scene.lines = {{{Point_3(-1, 0, 0), Point_3(1, 0, 0)}, 0.2, black, true}};
  const double radius = 0.1;
  for (double angle : {0.0, 0.5, 1.2, pi / 2}) {   // from the side, and more and more along the axis
    const double seen_length = 2 * std::cos(angle), extent = seen_length + 2 * radius;
    const Image image = render(scene, from(std::sin(angle), 0, std::cos(angle)), 800);
    const double scale = static_cast<double>(count(image, is_dark)) / (seen_length * 2 * radius + pi * radius * radius);
    CHECK_NEAR(std::sqrt(scale) * extent / image.width, 0.96, 0.005);   // all but the margins
  }
}

// No beads where segments meet: a tube in many pieces looks as in one.
void tubes_have_no_joints()
{
  Scene whole, pieces;
  whole.lines = {{{Point_3(-1, 0, 0), Point_3(1, 0, 0)}, 0.2, red, true}};
  pieces.lines = {{{}, 0.2, red, true}};
  for (int k = 0; k <= 40; ++k) pieces.lines[0].points.emplace_back(-1 + k / 20.0, 0, 0);
  for (double angle : {0.0, 0.5, 1.2}) {
    const Camera c = from(std::sin(angle), 0.1, std::cos(angle));
    const Image a = render(whole, c, 400), b = render(pieces, c, 400);
    int largest = 0;
    for (std::size_t k = 0; k < a.bytes.size(); ++k) largest = std::max(largest, std::abs(a.bytes[k] - b.bytes[k]));
    CHECK(largest <= 8);
  }
}

void what_is_nearer_hides_what_is_farther()
{
  for (bool front_first : {true, false}) {
    Scene scene;
    if (front_first) add_square(scene, 1, 0, red);
    add_square(scene, 2, -1, blue);
    if (!front_first) add_square(scene, 1, 0, red);
    const Image front = render(scene, from(0, 0, 1), 200), back = render(scene, from(0, 0, 1).turned_round(), 200);
    CHECK_EQUAL(front.width, 200);
    CHECK_EQUAL(front.height, 200);
    CHECK(is_red(pixel(front, 100, 100)));
    CHECK(is_blue(pixel(front, 20, 100)) && is_blue(pixel(front, 100, 180)));
    CHECK(is_white(pixel(front, 0, 0)) && is_white(pixel(front, 199, 199)));
    CHECK_EQUAL(count(back, is_red), 0);
    CHECK(is_blue(pixel(back, 100, 100)));
  }
}

void lines_are_seen_on_the_surface_and_not_behind_it()
{
  const auto line_at = [](double z, bool is_tube) {
    Scene scene;
    add_square(scene, 1, 0, red);
    scene.lines = {{{Point_3(-0.9, 0.1, z), Point_3(0.9, 0.1, z)}, 0.02, black, is_tube}};
    return scene;
  };
  for (bool is_tube : {false, true})
    for (const Camera& c : {from(0, 0, 1), from(1, 1, 1), from(-1, 0.4, 1)}) {
      const int whole = count(render(line_at(0.5, is_tube), c, 500), is_dark);
      CHECK(whole > 1000);
      CHECK_NEAR(static_cast<double>(count(render(line_at(0, is_tube), c, 500), is_dark)) / whole, 1, 0.1);
      CHECK_EQUAL(count(render(line_at(-0.5, is_tube), from(0, 0, 1), 500), is_dark), 0);
    }
}

void checkerboard_changes_where_the_coordinates_say()
{
  Scene scene;
  add_square(scene, 1, 0, red);
  const auto place = [&](std::size_t v) { return Eigen::Vector2d(scene.points[v].x(), scene.points[v].y()); };
  for (const auto& t : scene.triangles) scene.uv.push_back({place(t[0]), place(t[1]), place(t[2])});
  scene.texture = [](const Eigen::Vector2d& z) { return is_light_square(4 * z.x(), 4 * z.y()) ? red : blue; };
  const int size = 1000, left = 20, side = 960 / 8;      // margins of 2 %, eight squares
  const Image image = render(scene, from(0, 0, 1), size);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      const bool light = (row + column) % 2 == 0;        // row 0 is the top one, from y = 3/4 to 1
      const int x0 = left + side * column, y0 = left + side * row;
      for (int x : {x0 + 1, x0 + side / 2, x0 + side - 2})
        for (int y : {y0 + 1, y0 + side / 2, y0 + side - 2})
          CHECK(light ? is_red(pixel(image, x, y)) : is_blue(pixel(image, x, y)));
    }
}

void squares_repeat_and_are_as_many_as_promised()
{
  CHECK_EQUAL(checkerboard_squares_per_unit(25), 10);
  CHECK_EQUAL(checkerboard_squares_per_unit(1e9), 8);     // at least
  CHECK(!is_light_square(0.5, 0.5) && is_light_square(-0.5, 0.5) && is_light_square(0.5, 1.5));
  CHECK(!is_light_square(-0.5, -0.5) && !is_light_square(-1.5, 2.5));
}

// A pixel is the mean of its samples: half covered, it is half as dark.
void edges_are_smooth()
{
  Scene scene;
  scene.balls = {{Point_3(0, 0, 0), 1, black}};
  const Image image = render(scene, from(0, 0, 1), 100);
  std::set<int> shades;
  for (int y = 0; y < image.height; ++y) shades.insert(image.at(2, y, 0));
  CHECK(shades.size() >= 3);
}

void same_scene_same_bytes()
{
  Scene scene;
  add_square(scene, 1, 0, red);
  scene.balls = {{Point_3(0, 0, 0), 0.3, blue}};
  scene.lines = {{{Point_3(-1, 0, 0), Point_3(1, 0.3, 0)}, 0.05, black, true}};
  const Image image = render(scene, from(1, 2, 3), 300);
  CHECK(png(image) == png(render(scene, from(1, 2, 3), 300)));
  const Image read = decoded(png(image));
  CHECK_EQUAL(read.width, image.width);
  CHECK_EQUAL(read.height, image.height);
  CHECK(read.bytes == image.bytes);
  const Image both = side_by_side(image, read);
  CHECK_EQUAL(both.width, 2 * image.width);
  CHECK(pixel(both, 150, 100) == pixel(both, image.width + 150, 100));
}

// ---- Normals, cameras, colours

void normals_are_smooth_up_to_sharp_edges()
{
  const Mesh sphere = bumpy_sphere(3);
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (Face f : sphere.faces()) {                       // three points of its own for every triangle
    for (Halfedge h : CGAL::halfedges_around_face(sphere.halfedge(f), sphere))
      points.push_back(sphere.point(sphere.target(h)));
    triangles.push_back({points.size() - 3, points.size() - 2, points.size() - 1});
  }
  const auto smooth = smooth_normals(points, triangles);
  std::map<Point_3, Eigen::Vector3d> normal_at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d n = smooth[t][k].normalized();
      CHECK((normal_at.try_emplace(points[triangles[t][k]], n).first->second - n).norm() < 1e-9);
    }
  // two faces of a cube
  const std::vector<Point_3> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto sharp = smooth_normals(corner, {{0, 1, 2}, {0, 3, 1}});
  for (int k = 0; k < 3; ++k) {
    CHECK_EQUAL(sharp[0][k], Eigen::Vector3d(0, 0, 1));
    CHECK_EQUAL(sharp[1][k], Eigen::Vector3d(0, 1, 0));
  }
}

void check_basis(const Camera& c)
{
  CHECK_NEAR(c.right.norm(), 1, 1e-12);
  CHECK_NEAR(c.up.norm(), 1, 1e-12);
  CHECK((c.right.cross(c.up) - c.towards_eye).norm() < 1e-12);
}

// A torus, flattened along one of the axes.
void automatic_cameras_see_the_broad_side()
{
  for (int thin = 0; thin < 3; ++thin) {
    Mesh mesh = torus(2, 1, 24, 12);
    std::vector<Point_3> points;
    std::vector<std::array<std::size_t, 3>> triangles;
    for (Vertex v : mesh.vertices()) {
      double p[3] = {mesh.point(v).x(), mesh.point(v).y(), 0.5 * mesh.point(v).z()};
      std::rotate(p, p + (2 - thin), p + 3);
      points.emplace_back(p[0] + 10, p[1] - 20, p[2] + 5);
    }
    for (Face f : mesh.faces()) {
      auto& t = triangles.emplace_back();
      int k = 0;
      for (Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) t[k++] = mesh.target(h);
    }
    const Camera c = automatic_camera(points, triangles);
    check_basis(c);
    CHECK_NEAR(c.towards_eye[thin], std::cos(25 * pi / 180), 1e-6);
    CHECK(c.up[thin == 1 ? 2 : 1] > 0.85);
  }
}

void cameras_look_as_they_are_told()
{
  const Camera c = camera({2, 0, 0}, {0, 0, 5});
  check_basis(c);
  CHECK((c.towards_eye - Eigen::Vector3d(1, 0, 0)).norm() < 1e-15);
  CHECK((c.up - Eigen::Vector3d(0, 0, 1)).norm() < 1e-15);
  CHECK((c.right - Eigen::Vector3d(0, 1, 0)).norm() < 1e-15);
  check_basis(c.turned_round());
  check_basis(camera({0, 3, 0}, {0, 1, 0}));
}

void neighbours_have_different_colours()
{
  std::mt19937 random(3);
  std::set<std::pair<std::size_t, std::size_t>> neighbours{{0, 1}, {1, 2}, {0, 2}};
  std::vector<std::array<std::size_t, 3>> faces{{0, 1, 2}, {0, 1, 2}};   // of a sphere: a vertex is put into one
  const std::size_t n = 400;
  for (std::size_t v = 3; v < n; ++v) {
    auto& f = faces[random() % faces.size()];
    const auto [a, b, c] = f;
    for (std::size_t w : {a, b, c}) neighbours.insert({v, w});
    f = {a, b, v};
    faces.push_back({b, c, v});
    faces.push_back({c, a, v});
  }
  neighbours.insert({7, 7});
  for (std::size_t colours : {6, 8}) {
    const std::vector<std::size_t> colour = different_colours(n, colours, neighbours);
    CHECK(std::all_of(neighbours.begin(), neighbours.end(),
                      [&](const auto& p) { return p.first == p.second || colour[p.first] != colour[p.second]; }));
    for (std::size_t c = 0; c < colours; ++c) CHECK(std::count(colour.begin(), colour.end(), c) > 20);
  }
  CHECK(different_colours(0, 8, {}).empty());
}

// ---- Pictures of results

// A cube is a quad mesh with eight simple poles, every side a patch.
void cube_is_drawn_from_memory()
{
  Quad_mesh cube;
  T_mesh t;
  for (int v = 0; v < 8; ++v) {
    cube.points.emplace_back(v & 1, v >> 1 & 1, v >> 2);
    cube.singularities.push_back(v);
    t.nodes.push_back({T_mesh::Node_kind::singularity, Vertex(v), -1, Face(0), {}});
  }
  cube.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  cube.patch = {0, 1, 2, 3, 4, 5};
  const auto drawn = [&](const Picture_options& options) {
    std::ostringstream out;
    write_quads_picture(out, cube, t, options);
    return out.str();
  };
  Picture_options options;
  options.size = 400;
  options.direction = Vector_3(1, 2, 3);
  const Image image = decoded(drawn(options));
  CHECK_EQUAL(std::max(image.width, image.height), 400);
  CHECK(drawn(options) == drawn(options));
  CHECK(count(image, is_red) > 100);                       // poles
  CHECK(count(image, is_blue) == 0);
  CHECK(count(image, is_dark) > 500);                      // edges
  const int centre_x = image.width / 2, centre_y = image.height / 2;
  CHECK(!is_dark(pixel(image, centre_x, centre_y + 60)) && !is_white(pixel(image, centre_x, centre_y + 60)));

  for (T_mesh::Node& node : t.nodes) node.order = 1;       // as if
  const Image zeros = decoded(drawn(options));
  CHECK(count(zeros, [](const auto& c) { return c[2] > 2 * c[0] && c[2] > 150; }) > 100);
  CHECK_EQUAL(count(zeros, is_red), 0);

  options.both_sides = true;
  const Image both = decoded(drawn(options));
  CHECK_EQUAL(both.width, 2 * image.width);
  CHECK_EQUAL(both.height, image.height);
}

const Quartic_test::Program_folder folder;

void check_failure(const std::string& arguments, int status, const std::string& message)
{
  const Outcome o = folder.quartic(arguments);
  CHECK_EQUAL(o.status, status);
  if (!contains(o.err, message)) std::cerr << "quartic " << arguments << " said: " << o.err << '\n';
  CHECK(contains(o.err, message));
}

Image picture(const std::string& path) { return decoded(contents(folder / path)); }

void program_draws_results()
{
  CHECK_EQUAL(folder.quartic("sample chain -g 1 -n 6 -o chain.off").status, 0);
  CHECK_EQUAL(folder.quartic("run chain.off -o results -q --quads 300").status, 0);
  const Outcome o = folder.quartic("render results --size 300");
  CHECK_EQUAL(o.status, 0);
  CHECK(!contains(o.out, "no picture"));
  for (const char* view : {"checkerboard", "tmesh", "quads", "wireframe", "loops"}) {
    const std::string name = std::string("picture_") + view + ".png";
    CHECK(contains(o.out, name));
    const Image image = picture("results/" + name);
    CHECK_EQUAL(std::max(image.width, image.height), 300);
    CHECK(count(image, [](const auto& c) { return !is_white(c); }) > 10000);
    std::set<std::array<int, 3>> colours;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) colours.insert(pixel(image, x, y));
    CHECK(colours.size() > 500);
  }
  CHECK(contents(folder / "results/picture_tmesh.png") != contents(folder / "results/picture_quads.png"));
  // many lines make many changes from pixel to pixel
  const auto changes = [](const Image& image) {
    int sum = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 1; x < image.width; ++x) sum += std::abs(pixel(image, x, y)[1] - pixel(image, x - 1, y)[1]);
    return sum;
  };
  CHECK(changes(picture("results/picture_wireframe.png")) > 3 * changes(picture("results/picture_loops.png")));

  CHECK_EQUAL(folder.quartic("render results -o again --size 300").status, 0);
  CHECK(contents(folder / "again/picture_loops.png") == contents(folder / "results/picture_loops.png"));
  const std::string view = "--view quads --direction -1,0,0.5 --up 0,0,1 --both-sides";
  CHECK_EQUAL(folder.quartic("render results -o other --size 300 " + view).status, 0);
  CHECK(!std::filesystem::exists(folder / "other/picture_loops.png"));
  const Image both = picture("other/picture_quads.png");
  CHECK(both.width > 300);
}

void program_refuses_what_cannot_be_drawn()
{
  check_failure("render nowhere", 2, "there is no folder nowhere");
  check_failure("render results --view sculpture", 1, "view");
  check_failure("render results --direction 0,0,0", 1, "no direction");
  check_failure("render results --direction 1,2", 1, "direction");
  check_failure("render results --size 1", 1, "size");
  const auto spoilt = [](const std::string& file, const std::string& text, const std::string& view,
                         const std::string& why) {
    const std::string whole = contents(folder / "results" / file);
    std::ofstream(folder / ("results/" + file)) << text;
    check_failure("render results -o spoilt --size 50 --view " + view, 2, "results/" + file + ": " + why);
    std::ofstream(folder / ("results/" + file)) << whole;
  };
  const std::string vtp = contents(folder / "results/tmesh.vtp");
  std::string bad_offset = vtp, bad_number = vtp, bad_index = vtp;
  const std::size_t points = vtp.find("ascii\">", vtp.find("<Points>")) + 8,
                    polygons = vtp.find("ascii\">", vtp.find("<Polys>")) + 8,
                    offsets = vtp.find("ascii\">", vtp.find("offsets", polygons)) + 8;
  bad_number.replace(points, 1, "x");
  bad_index.insert(polygons, "999999999 ");
  bad_offset.replace(offsets, 1, "99999999");
  spoilt("tmesh.vtp", bad_number, "tmesh", "something is not a finite number");
  spoilt("tmesh.vtp", bad_index, "tmesh", "a point that does not exist");
  spoilt("tmesh.vtp", bad_offset, "tmesh", "an offset is out of range");
  spoilt("tmesh.vtp", vtp.substr(0, vtp.size() / 2), "tmesh", "this is not VTK's XML");
  spoilt("tmesh.json", R"({"patches": [{"id": -1, "sides": [[{"arc": 0}]]}]})", "tmesh", "a patch is out of range");
  spoilt("tmesh.json", "{\"patches\": 3}", "tmesh", "this is not JSON as a run writes it");
  spoilt("report.json", "{", "quads", "this is not JSON as a run writes it");
  spoilt("quads.obj", "v 0 0 0\nf 1 1 1 1\n", "quads", "a quad is not in a group");
  spoilt("quads.obj", "v 0 0 0\ng patch_0\nf 1 1 1\n", "quads", "a face is not a quad");
  spoilt("quads.obj", "v 0 0 0\ng patch_0\nf 1 1 2 1\n", "quads", "a face refers to what is not there");
  spoilt("quads.obj", "v 0 0 zero\n", "quads", "a coordinate is not a finite number");
  spoilt("flat.obj", "", "checkerboard", "there is no triangle");

  std::filesystem::remove(folder / "results/quads.obj");
  check_failure("render results --view quads", 2, "quads.obj: there is no such file");
  std::filesystem::remove(folder / "results/tmesh.json");
  const Outcome o = folder.quartic("render results -o fewer --size 50");
  CHECK_EQUAL(o.status, 0);
  CHECK(contains(o.out, "no picture of the view quads: results has no quads.obj"));
  CHECK(contains(o.out, "no picture of the view tmesh: results has no tmesh.json"));
  CHECK(std::filesystem::exists(folder / "fewer/picture_loops.png"));
  std::filesystem::create_directory(folder / "empty");
  check_failure("render empty", 2, "holds no results that could be drawn");
}

} // namespace

int main()
{
  balls_cover_their_area();
  tubes_cover_their_area();
  tubes_have_no_joints();
  what_is_nearer_hides_what_is_farther();
  lines_are_seen_on_the_surface_and_not_behind_it();
  checkerboard_changes_where_the_coordinates_say();
  squares_repeat_and_are_as_many_as_promised();
  edges_are_smooth();
  same_scene_same_bytes();
  normals_are_smooth_up_to_sharp_edges();
  automatic_cameras_see_the_broad_side();
  cameras_look_as_they_are_told();
  neighbours_have_different_colours();
  cube_is_drawn_from_memory();
  if (!Quartic_test::environment("QUARTIC_PROGRAM").empty()) {
    program_draws_results();
    program_refuses_what_cannot_be_drawn();
  }
  return Quartic_test::result();
}
