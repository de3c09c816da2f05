// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The quality of quad meshes that can be worked out by hand: cubes divided into squares, sheared, blown up, dented.

#include "check.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/quad_quality.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

using Map = std::function<Point_3(const Point_3&)>;

const int    n = 4;              // squares along an edge of the cube
const double side = 1.0 / n;
const double diagonal = std::sqrt(3.0);

Point_3 identity(const Point_3& p) { return p; }

// The unit cube, moved to where `place` takes its points: squares that are cut into triangles, and the squares.
struct Cube
{
  Intrinsic_triangulation input;
  Quad_mesh               quads;

  explicit Cube(const Map& place = identity)
  {
    std::map<std::array<int, 3>, std::size_t> index;
    for (int axis = 0; axis < 3; ++axis)
      for (int end : {0, n})
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            std::array<std::size_t, 4> quad;
            for (int k = 0; k < 4; ++k) {   // counterclockwise at the far end, seen from outside
              std::array<int, 3> p;
              p[axis] = end;
              p[(axis + 1) % 3] = i + (k == 1 || k == 2);
              p[(axis + 2) % 3] = j + (k >= 2);
              const auto [it, is_new] = index.try_emplace(p, quads.points.size());
              if (is_new) quads.points.push_back(place(Point_3(p[0] * side, p[1] * side, p[2] * side)));
              quad[k] = it->second;
            }
            if (end == 0) std::swap(quad[1], quad[3]);
            quads.quads.push_back(quad);
            quads.patch.push_back(2 * axis + (end == n));
          }
    Mesh mesh;
    std::vector<Vertex> vertex;
    for (const Point_3& p : quads.points) vertex.push_back(mesh.add_vertex(p));
    for (const auto& [a, b, c, d] : quads.quads) {
      mesh.add_face(vertex[a], vertex[b], vertex[c]);
      mesh.add_face(vertex[a], vertex[c], vertex[d]);
    }
    input = Intrinsic_triangulation(mesh);
    for (Vertex v : vertex) quads.input_points.push_back(at_vertex(input, v));
  }

  Point_3& at(const Point_3& p)
  {
    for (Point_3& q : quads.points)
      if (q == p) return q;
    throw std::logic_error("no such vertex");
  }
};

const Cube cube;

void squares()
{
  const Quad_quality q = quad_quality(cube.input, cube.quads);
  CHECK(q.scaled_jacobian.least == 1);
  CHECK_NEAR(q.scaled_jacobian.mean, 1, 1e-14);
  CHECK_NEAR(q.angle.least, 90, 1e-13);
  CHECK_NEAR(q.angle.most, 90, 1e-13);
  CHECK_NEAR(q.angle.mean, 90, 1e-12);
  CHECK_NEAR(q.angle_deviation, 0, 1e-13);
  CHECK(q.edge_ratio.least == 1 && q.edge_ratio.mean == 1 && q.edge_ratio.most == 1);
  CHECK(q.edge_length.least == side && q.edge_length.mean == side && q.edge_length.most == side);
  CHECK(q.to_input.rms <= q.to_input.most && q.to_input.most < 1e-15);
  CHECK(q.from_input.rms <= q.from_input.most && q.from_input.most < 1e-15);
  CHECK(q.irregular_vertices == (std::map<std::size_t, std::size_t>{{3, 8}}));
  CHECK_EQUAL(q.patches, 6u);

  Cube five = cube;
  for (std::size_t& patch : five.quads.patch) patch = patch == 0 ? 99 : patch == 1 ? 2 : patch;
  CHECK_EQUAL(quad_quality(five.input, five.quads).patches, 5u);
}

// Two faces become parallelograms with angles of 60 degrees, two rectangles, two stay squares.
void sheared()
{
  const double longer = 2 / std::sqrt(3.0);   // 1 / sin(60 degrees)
  const Cube s([](const Point_3& p) { return Point_3(p.x() + p.y() / std::sqrt(3.0), p.y(), p.z()); });
  const Quad_quality q = quad_quality(s.input, s.quads);
  CHECK_NEAR(q.scaled_jacobian.least, 1 / longer, 1e-14);
  CHECK_NEAR(q.scaled_jacobian.mean, (4 + 2 / longer) / 6, 1e-14);
  CHECK_NEAR(q.angle.least, 60, 1e-12);
  CHECK_NEAR(q.angle.most, 120, 1e-12);
  CHECK_NEAR(q.angle_deviation, 10, 1e-12);
  CHECK_NEAR(q.edge_ratio.least, 1, 1e-14);
  CHECK_NEAR(q.edge_ratio.mean, (2 + 4 * longer) / 6, 1e-14);
  CHECK_NEAR(q.edge_ratio.most, longer, 1e-14);
  CHECK_NEAR(q.edge_length.least, side, 1e-15);
  CHECK_NEAR(q.edge_length.mean, side * (2 + longer) / 3, 1e-14);
  CHECK_NEAR(q.edge_length.most, side * longer, 1e-15);
  CHECK(q.to_input.most < 1e-15 && q.from_input.most < 1e-15);
}

// A quad with a corner drawn in beyond its diagonal.
void dart()
{
  Cube c;
  c.at(Point_3(side, side, 1)) = Point_3(0.45, 0.45, 1);
  const double cosine = -0.02 / 0.0425;   // of the angle between (0.05, -0.2) and (-0.2, 0.05)
  const double angle = std::acos(cosine) * 180 / std::acos(-1.0);
  const Quad_quality q = quad_quality(c.input, c.quads);
  CHECK_NEAR(q.angle.most, 360 - angle, 1e-10);
  CHECK_NEAR(q.scaled_jacobian.least, -std::sqrt(1 - cosine * cosine), 1e-12);
  CHECK(q.to_input.most < 1e-15 && q.from_input.most < 1e-15);   // it is where it was
}

// A vertex of the top moves along it: four edges of 192 change, and every edge counts once.
void edges_count_once()
{
  Cube c;
  c.at(Point_3(side, side, 1)) = Point_3(0.4, 0.3, 1);
  const double changed = std::hypot(0.4, 0.05) + std::hypot(0.1, 0.05) + std::hypot(0.15, 0.3) + std::hypot(0.15, 0.2);
  const Quad_quality q = quad_quality(c.input, c.quads);
  CHECK_NEAR(q.edge_length.mean, (188 * side + changed) / 192, 1e-14);
  CHECK_NEAR(q.edge_length.least, std::hypot(0.1, 0.05), 1e-15);
  CHECK_NEAR(q.edge_length.most, std::hypot(0.4, 0.05), 1e-15);
}

Map scaled(double factor)
{
  return [factor](const Point_3& p) { return Point_3(0.5, 0.5, 0.5) + factor * (p - Point_3(0.5, 0.5, 0.5)); };
}

// Around the cube everything is as far as the faces are; inside, its edges and corners are further from the quads.
void at_a_distance()
{
  const double distance = 0.01;
  Cube around(scaled(1 + 2 * distance)), inside(scaled(1 - 2 * distance));
  around.quads.input_points = inside.quads.input_points = cube.quads.input_points;
  const Quad_quality a = quad_quality(cube.input, around.quads), i = quad_quality(cube.input, inside.quads);
  for (double d : {a.to_input.most, a.to_input.rms, a.from_input.most, a.from_input.rms, i.to_input.most,
                   i.to_input.rms})
    CHECK_NEAR(d, distance / diagonal, 1e-14);
  CHECK_NEAR(i.from_input.most, std::sqrt(3.0) * distance / diagonal, 1e-14);
  CHECK(i.from_input.rms > distance / diagonal && i.from_input.rms < std::sqrt(2.0) * distance / diagonal);

  for (Surface_point& p : around.quads.input_points) p = cube.quads.input_points[0];   // only the search gets longer
  CHECK_NEAR(quad_quality(cube.input, around.quads).to_input.rms, a.to_input.rms, 1e-15);
}

// One vertex of a face is drawn out by h: the bilinear quads are h (1 - s) (1 - t) above it.
void drawn_out()
{
  const auto drawn = [](double h) {
    Cube c;
    c.at(Point_3(0.5, 0.5, 1)) = Point_3(0.5, 0.5, 1 + h);
    return quad_quality(c.input, c.quads);
  };
  const double nearest_sample = 7.0 / 8, squares_of_samples = (1 + 9 + 25 + 49) / 256.0;
  const double h = side / 2;
  const Quad_quality q = drawn(h);
  CHECK_NEAR(q.to_input.most, h * nearest_sample * nearest_sample / diagonal, 1e-14);
  // the triangles at the vertex lie in planes with slopes h / side and h / (2 side)
  CHECK_NEAR(q.from_input.most, h / std::sqrt(1 + 1.25 * (h / side) * (h / side)) / diagonal, 1e-14);
  const double small = 1e-5;   // areas are those of squares, up to the square of this
  const double of_area = 4 * side * side / 6;
  CHECK_NEAR(drawn(small).to_input.rms, small * squares_of_samples * std::sqrt(of_area) / diagonal, 1e-8 * small);
  CHECK_NEAR(drawn(small).from_input.rms, small * std::sqrt(side * side / 6) / diagonal, 1e-8 * small);
}

// A box of 3 x 1 x 1 whose top and bottom are pushed out: only they, 6 of 14 parts of the area, are at a distance.
void weighted_by_area()
{
  const double distance = 0.01, higher = 1 + 2 * distance;
  const Cube box([](const Point_3& p) { return Point_3(3 * p.x(), p.y(), p.z()); });
  Cube pushed([&](const Point_3& p) { return Point_3(3 * p.x(), p.y(), 0.5 + higher * (p.z() - 0.5)); });
  pushed.quads.input_points = box.quads.input_points;
  const Quad_quality q = quad_quality(box.input, pushed.quads);
  CHECK_NEAR(q.to_input.most, distance / std::sqrt(11.0), 1e-14);
  CHECK_NEAR(q.to_input.rms, distance * std::sqrt(6 / (6 + 8 * higher)) / std::sqrt(11.0), 1e-14);
}

} // namespace

int main()
{
  squares();
  sheared();
  dart();
  edges_count_once();
  at_a_distance();
  drawn_out();
  weighted_by_area();
  CHECK_THROWS(quad_quality(Intrinsic_triangulation(hyperelliptic(2, 1)), cube.quads), Unusable_surface_error,
               "the distance of quads needs positions in space");
  return Quartic_test::result();
}
