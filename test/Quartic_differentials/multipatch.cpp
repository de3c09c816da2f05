// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The layout of quad meshes, known ones and those of samples, and the splines on its patches: they meet bit by bit, are
// exact on flat faces, and converge to smooth surfaces with the fourth power of the spans.

#include "check.h"
#include "run_pipeline.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/multipatch.h>
#include <CGAL/Quartic_differentials/quads.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>


#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using Quartic_test::run_pipeline;

namespace {

const double pi = 3.14159265358979323846;

/// the surface of a box a x b x c of unit cubes, in squares
Mesh box(int a, int b, int c)
{
  Mesh mesh;
  std::map<std::array<int, 3>, Vertex> vertices;
  const std::array<int, 3> size{a, b, c};
  const auto vertex = [&](std::array<int, 3> p) {
    auto [at, is_new] = vertices.try_emplace(p);
    if (is_new) at->second = mesh.add_vertex(Point_3(p[0], p[1], p[2]));
    return at->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int end = 0; end < 2; ++end) {
      const int first = (axis + 2 - end) % 3, second = (axis + 1 + end) % 3;   // counterclockwise from outside
      for (int i = 0; i < size[first]; ++i)
        for (int j = 0; j < size[second]; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> p{};
            p[axis] = end * size[axis];
            p[first] = i + di;
            p[second] = j + dj;
            return vertex(p);
          };
          mesh.add_face(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
        }
    }
  return mesh;
}

Mesh triangulated(const Mesh& quads)
{
  Mesh result;
  for (Vertex v : quads.vertices()) result.add_vertex(quads.point(v));
  for (Face f : quads.faces()) {
    std::vector<Vertex> p;
    for (Vertex v : vertices_around_face(quads.halfedge(f), quads)) p.push_back(v);
    result.add_face(p[0], p[1], p[2]);
    result.add_face(p[0], p[2], p[3]);
  }
  return result;
}

/// a torus of n x m quads; after m steps across, the columns are `shift` further
Mesh quad_torus(double R, double r, int n, int m, int shift)
{
  Mesh mesh;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const double v = 2 * pi * j / m, u = 2 * pi * (i + double(shift) * j / m) / n, d = R + r * std::cos(v);
      mesh.add_vertex(Point_3(d * std::cos(u), d * std::sin(u), r * std::sin(v)));
    }
  const auto vertex = [&](int i, int j) {
    const int turn = j == m ? shift : 0;
    return Vertex(static_cast<Mesh::size_type>(j % m * n + (i + turn) % n));
  };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  return mesh;
}

/// what holds for every layout
Quad_layout checked_layout(const Mesh& quads)
{
  const Quad_layout layout = quad_layout(quads);
  std::vector<int> patches_of(quads.number_of_faces(), 0), sides_at(quads.number_of_edges(), 0);
  for (const Quad_layout::Patch& p : layout.patches) {
    CHECK_EQUAL(p.quads.size(), p.size[0] * p.size[1]);
    for (Halfedge h : p.quads) ++patches_of[quads.face(h)];
    const std::vector<Vertex> v = grid_vertices(quads, p);
    const std::size_t width = p.size[0] + 1;
    for (std::size_t j = 0; j < p.size[1]; ++j)
      for (std::size_t i = 0; i < p.size[0]; ++i) {
        Halfedge h = p.quads[j * p.size[0] + i];
        for (std::size_t at : {j * width + i, j * width + i + 1, (j + 1) * width + i + 1, (j + 1) * width + i}) {
          CHECK(quads.source(h) == v[at]);
          h = quads.next(h);
        }
      }
    for (std::size_t j = 1; j < p.size[1]; ++j)
      for (std::size_t i = 1; i < p.size[0]; ++i) CHECK_EQUAL(quads.degree(v[j * width + i]), 4u);
  }
  CHECK(std::all_of(patches_of.begin(), patches_of.end(), [](int n) { return n == 1; }));
  CHECK_EQUAL(layout.interfaces.size(), 2 * layout.patches.size());
  return layout;
}

/// what holds for every multi-patch
Multipatch checked_multipatch(const Intrinsic_triangulation& input, const Mesh& quads)
{
  checked_layout(quads);
  const Multipatch m = multipatch(input, quads);
  CHECK_EQUAL(defect(m), "");
  std::set<std::size_t> faces;
  for (const Multipatch::Patch& p : m.patches) {
    faces.insert(p.quads.begin(), p.quads.end());
    for (int k = 0; k < 4; ++k) {   // corners are vertices of the quads
      const Point_3 corner = control_points(p, k).front();
      const std::size_t columns = p.spans[0], quad[] = {0, columns - 1, p.quads.size() - 1, p.quads.size() - columns};
      const auto around = vertices_around_face(quads.halfedge(Face(p.quads[quad[k]])), quads);
      CHECK(std::any_of(around.begin(), around.end(), [&](Vertex v) { return quads.point(v) == corner; }));
    }
  }
  CHECK_EQUAL(faces.size(), quads.number_of_faces());
  for (const Multipatch::Interface& i : m.interfaces) {
    const auto on_side = [&](const Multipatch::Side& s, double t) {
      const Multipatch::Patch& p = m.patches[s.patch];
      const double n_u = double(p.spans[0]), n_v = double(p.spans[1]);
      switch (s.side) {
        case 0:  return evaluate(p, t * n_u, 0);
        case 1:  return evaluate(p, n_u, t * n_v);
        case 2:  return evaluate(p, (1 - t) * n_u, n_v);
        default: return evaluate(p, 0, (1 - t) * n_v);
      }
    };
    for (double t : {0., 0.125, 0.5, 0.75, 1.})
      CHECK(CGAL::squared_distance(on_side(i.first, t).point, on_side(i.second, 1 - t).point) < 1e-26);
  }
  return m;
}

void boxes()
{
  const Mesh quads = box(2, 3, 5);
  CHECK(quads.is_valid() && CGAL::is_closed(quads));
  const Quad_layout layout = checked_layout(quads);
  std::multiset<std::size_t> sizes;
  for (const Quad_layout::Patch& p : layout.patches) sizes.insert(p.quads.size());
  CHECK(sizes == (std::multiset<std::size_t>{6, 6, 10, 10, 15, 15}));

  const Intrinsic_triangulation input(triangulated(quads));
  const Multipatch m = checked_multipatch(input, quads);
  const Multipatch_quality q = multipatch_quality(input, m);
  CHECK(q.distance.most < 1e-14);
  CHECK_NEAR(q.least_sine, 1, 1e-12);
  CHECK_NEAR(q.mean_sine, 1, 1e-12);
}

std::array<std::size_t, 2> sorted(std::array<std::size_t, 2> size)
{
  std::sort(size.begin(), size.end());
  return size;
}

void tori()
{
  const Quad_layout straight = checked_layout(quad_torus(3, 1, 8, 5, 0));
  CHECK_EQUAL(straight.patches.size(), 1u);
  CHECK(sorted(straight.patches[0].size) == (std::array<std::size_t, 2>{5, 8}));
  // the line across meets the line along in every second vertex
  const Quad_layout shifted = checked_layout(quad_torus(3, 1, 8, 5, 2));
  CHECK_EQUAL(shifted.patches.size(), 4u);
  for (const Quad_layout::Patch& p : shifted.patches) CHECK(sorted(p.size) == (std::array<std::size_t, 2>{2, 5}));
}

// The error on a torus falls with the fourth power of the spans; the input is so fine that it does not matter.
void order_of_convergence()
{
  const double R = 3, r = 1;
  const Intrinsic_triangulation input(triangulated(quad_torus(R, r, 720, 360, 0)));
  std::vector<double> errors;
  for (int n : {6, 12}) {
    const Multipatch m = checked_multipatch(input, quad_torus(R, r, 3 * n, n, 0));
    double error = 0;
    for (const Multipatch::Patch& p : m.patches)
      for (double u = 0.1; u < double(p.spans[0]); u += 0.25)
        for (double v = 0.1; v < double(p.spans[1]); v += 0.25) {
          const Point_3 x = evaluate(p, u, v).point;
          error = std::max(error, std::abs(std::hypot(std::hypot(x.x(), x.y()) - R, x.z()) - r));
        }
    errors.push_back(error);
    const Multipatch_quality q = multipatch_quality(input, m);
    CHECK(8 * q.distance.most < error + 2e-4 && q.distance.rms <= q.distance.most);   // the input's own error is 1e-4
    CHECK(q.least_sine > 0.95);
  }
  std::cout << "a torus: errors " << errors[0] << ", " << errors[1] << ", order " << std::log2(errors[0] / errors[1])
            << '\n';
  CHECK(std::log2(errors[0] / errors[1]) > 3.5);
}

void derivatives()
{
  const Multipatch m = multipatch(Intrinsic_triangulation(torus(3, 1, 40, 24)), quad_torus(3, 1, 9, 7, 0));
  const Multipatch::Patch& p = m.patches.front();
  const double h = 1e-5;
  for (double u : {0.3, 1.7, 4.2, 6.6})
    for (double v : {0.4, 2.5, 5.7}) {
      const Spline_point s = evaluate(p, u, v);
      const Vector_3 d_u = (evaluate(p, u + h, v).point - evaluate(p, u - h, v).point) / (2 * h);
      const Vector_3 d_v = (evaluate(p, u, v + h).point - evaluate(p, u, v - h).point) / (2 * h);
      CHECK((s.along_u - d_u).squared_length() < 1e-16 * s.along_u.squared_length());
      CHECK((s.along_v - d_v).squared_length() < 1e-16 * s.along_v.squared_length());
    }
  CHECK(evaluate(p, double(p.spans[0]), double(p.spans[1])).point == p.control_points.back());
  CHECK(evaluate(p, 0, 0).point == p.control_points.front());
}

// Blocks of quads are patches, or several are one.
void samples()
{
  const std::vector<std::pair<std::string, Mesh>> surfaces{
    {"sphere", bumpy_sphere(3)}, {"torus", torus(2, 0.7, 36, 24)}, {"chain", handle_chain(2, 6)},
    {"ring", handle_ring(3, 8)}};
  for (const auto& [name, mesh] : surfaces) {
    const Intrinsic_triangulation input(mesh);
    Quartic_differential_options options;
    options.quads.emplace();
    options.quads->quantization.number_of_quads = 3000;
    options.quads->splines = true;
    const Quartic_differential_result r = run_pipeline(input, options);
    const Quads& quads = *r.quads;
    const std::size_t k = quads.quantization.block_size;
    CHECK(k > 1);
    for (int q : quads.quantization.length) CHECK_EQUAL(q % static_cast<int>(k), 0);
    CHECK_EQUAL(quantization_defect(*r.t_mesh, quads.quantization.length), "");
    CHECK_EQUAL(quads.quantization.number_of_quads, quads.mesh.quads.size());
    CHECK_NEAR(double(quads.mesh.quads.size()), 3000, 300);
    CHECK(quads.splines->patches.size() * k * k <= quads.mesh.quads.size());
    for (const Multipatch::Patch& p : quads.splines->patches) CHECK(p.spans[0] % k == 0 && p.spans[1] % k == 0);
    const Multipatch again = checked_multipatch(input, surface_mesh(quads.mesh, *r.t_mesh));
    CHECK(again.patches.front().control_points == quads.splines->patches.front().control_points);
    const Multipatch_quality& q = *quads.splines_quality;
    std::cout << name << ": " << quads.splines->patches.size() << " patches, " << quads.mesh.quads.size()
              << " quads; distance at most " << q.distance.most << ", rms " << q.distance.rms << "; least sine "
              << q.least_sine << '\n';
    CHECK(q.distance.rms < 1e-3 && q.distance.most < 1e-2);
    CHECK(q.least_sine > 0);
  }
}

void damage_is_found()
{
  const Mesh quads = box(1, 2, 3);
  const Multipatch m = multipatch(Intrinsic_triangulation(triangulated(quads)), quads);
  const auto defect_after = [&](const std::function<void(Multipatch&)>& damage) {
    Multipatch damaged = m;
    damage(damaged);
    return defect(damaged);
  };
  const auto says = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
  CHECK(says(defect_after([](Multipatch& d) { d.patches[2].control_points[0] = Point_3(1, 2, 3); }), "do not meet"));
  CHECK(says(defect_after([](Multipatch& d) { d.interfaces.pop_back(); }), "is on 0 interfaces"));
  CHECK(says(defect_after([](Multipatch& d) { d.interfaces[0] = d.interfaces[1]; }), "interfaces"));
  CHECK(says(defect_after([](Multipatch& d) { d.interfaces[0].first.patch = 6; }), "does not exist"));
  CHECK(says(defect_after([](Multipatch& d) { ++d.patches[1].spans[0]; }), "patch 1 do not fit"));
}

void refusals()
{
  const Intrinsic_triangulation input(torus(3, 1, 12, 8));
  CHECK_THROWS(multipatch(input, triangulated(box(1, 1, 1))), Unusable_surface_error, "has 3 corners");
  CHECK_THROWS(multipatch(input, Mesh()), Unusable_surface_error, "no faces");
  Mesh open;
  const Vertex a = open.add_vertex(Point_3(0, 0, 0)), b = open.add_vertex(Point_3(1, 0, 0)),
               c = open.add_vertex(Point_3(1, 1, 0)), d = open.add_vertex(Point_3(0, 1, 0));
  open.add_face(a, b, c, d);
  CHECK_THROWS(multipatch(input, open), Unusable_surface_error, "boundary");
  Mesh two = box(1, 1, 1);
  two += quad_torus(3, 1, 8, 5, 0);
  CHECK_THROWS(quad_layout(two), Unusable_surface_error, "not connected");
  CHECK_THROWS(multipatch(Intrinsic_triangulation(hyperelliptic(2, 0)), box(1, 1, 1)), Unusable_surface_error,
               "edge lengths alone");
  Quartic_differential_options options;
  options.quads.emplace();
  CHECK_THROWS(run_pipeline(Intrinsic_triangulation(hyperelliptic(2, 0)), options), Unusable_surface_error,
               "edge lengths alone");
}

} // namespace

int main()
{
  boxes();
  tori();
  order_of_convergence();
  derivatives();
  samples();
  damage_is_found();
  refusals();
  return Quartic_test::result();
}
