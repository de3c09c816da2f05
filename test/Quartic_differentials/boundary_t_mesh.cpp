// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps 7 and 8 on surfaces with boundary: exact charts whose boundary edges are parallel to axes, and T-meshes whose arcs
// include the boundary.

#include "check.h"
#include "run_pipeline.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/internal/boundary_walk.h>

using namespace Quartic_test;

// The differential on two copies of a surface, the second with the charts conj(z), glued along the boundary: a closed
// surface, on which a corner of order n is a singularity of order 2n.
Quartic_differential mirror_double(const Quartic_differential& q)
{
  Intrinsic_triangulation t = q.triangulation;
  std::vector<double> lengths;   // in the plane: those of the triangulation need not satisfy triangle inequalities
  for (Edge e : t.edges()) {
    const Halfedge h = t.is_border(t.halfedge(e)) ? t.opposite(t.halfedge(e)) : t.halfedge(e);
    const Grid_vector along = q.corner[t.next(h)] - q.corner[h];
    lengths.push_back(std::hypot(static_cast<double>(along.x), static_cast<double>(along.y)));
  }
  t.set_lengths(lengths);
  const Mirror_double twice = mirror_double(t, Integer_cochains(t.number_of_edges(), 0));
  const auto conj = [](Grid_vector z) { return Grid_vector{z.x, -z.y}; };
  Quartic_differential d;
  d.triangulation = twice.surface;
  d.grid_exponent = q.grid_exponent;
  d.corner.resize(d.triangulation.number_of_halfedges());
  d.transition.resize(d.triangulation.number_of_halfedges());
  d.order.resize(d.triangulation.number_of_vertices());
  for (Face f : t.faces())
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = t.halfedges(f)[k];
      const Face image(static_cast<Mesh::size_type>(t.number_of_faces() + f.idx()));
      const Halfedge here = d.triangulation.halfedges(f)[k], there = d.triangulation.halfedges(image)[2 - k];
      d.corner[here] = q.corner[h];
      d.corner[there] = conj(q.corner[t.next(h)]);
      const Transition& across = q.transition[h];
      if (!t.is_border(t.opposite(h))) {
        d.transition[here] = across;
        d.transition[there] = {(4 - across.rotation) & 3, conj(across.translation)};
        continue;
      }
      const Grid_vector z = q.corner[h];
      const bool horizontal = z.y == q.corner[t.next(h)].y;
      d.transition[here] = horizontal ? Transition{0, {0, -2 * z.y}} : Transition{2, {2 * z.x, 0}};
      d.transition[there] = d.transition[here].inverse();
    }
  for (Vertex v : t.vertices()) {
    d.order[v] = t.is_border(v) ? 2 * q.order[v] : q.order[v];
    d.order[twice.image[v]] = d.order[v];
  }
  for (Vertex v : d.triangulation.vertices())
    if (d.order[v] != 0) d.singularities.push_back(v);
  return d;
}

// Every invariant of the results, and the counts of corners by hand.
void check_results(const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  CHECK(r.metric->reached || r.precision->bits > 53);
  CHECK(r.immersion.rotation_error <= 1e-10);
  CHECK_EQUAL(defect(*r.differential), "");
  CHECK_EQUAL(r.refined.has_value(), input.is_embedded());
  if (r.refined) {
    CHECK_EQUAL(r.refined->flipped_triangles, 0u);
    CHECK_EQUAL(defect(r.refined->differential), "");
  }
  CHECK_EQUAL(defect(*r.t_mesh, r.traced()), "");
  if (const Quartic_differential twice = mirror_double(r.traced()); !twice.singularities.empty()) {
    CHECK_EQUAL(defect(twice), "");
    Visitor visitor;
    CHECK_EQUAL(defect(t_mesh(twice, visitor), twice), "");
  }
  CHECK_EQUAL(r.t_mesh->euler_characteristic(), 2l - 2 * input.genus() - input.number_of_boundary_curves());
  std::size_t corners = 0, expected = 0;
  for (const T_mesh::Node& n : r.t_mesh->nodes) corners += n.kind == T_mesh::Node_kind::corner;
  for (const Singularity& s : r.singularities) expected += s.on_boundary;
  CHECK_EQUAL(corners, expected);
}

double longer_to_shorter_side(const T_mesh::Patch& patch)
{
  const double ratio = static_cast<double>(patch.width) / static_cast<double>(patch.height);
  return std::max(ratio, 1 / ratio);
}

void test_rectangle()
{
  const Intrinsic_triangulation t = sheet_of_squares();
  const Quartic_differential_result r = run_pipeline(t, corners_of_sheet(t));
  check_results(t, r);
  CHECK_EQUAL(r.t_mesh->patches.size(), 1u);
  CHECK_EQUAL(r.t_mesh->nodes.size(), 4u);
  CHECK_EQUAL(r.t_mesh->arcs.size(), 4u);
  CHECK_NEAR(longer_to_shorter_side(r.t_mesh->patches[0]), 1.5, 1e-12);
}

// An annulus is cut across once.
void test_annulus()
{
  const Intrinsic_triangulation t(plate(1, 14));
  const Quartic_differential_result r = run_pipeline(t, Divisor());
  check_results(t, r);
  CHECK_EQUAL(r.t_mesh->patches.size(), 1u);
  CHECK_EQUAL(r.t_mesh->nodes.size(), 2u);
  CHECK_EQUAL(r.t_mesh->arcs.size(), 3u);
  for (const T_mesh::Node& n : r.t_mesh->nodes) CHECK(n.kind == T_mesh::Node_kind::t_junction);
}

// A prism of squares, where the trace across it ends in the vertex with which the other wall begins: faces are added so
// that the first boundary edges are (0,0)(1,0) and (0,1)(3,1).
void test_prism()
{
  Mesh mesh;
  for (int z : {0, 1})
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) mesh.add_vertex(Point_3(x, y, z));
  const auto vertex = [](int column, int z) { return Vertex(static_cast<Mesh::size_type>(column % 4 + 4 * z)); };
  const auto add_lower = [&](int c) { mesh.add_face(vertex(c, 0), vertex(c + 1, 0), vertex(c + 1, 1)); };
  const auto add_upper = [&](int c) { mesh.add_face(vertex(c, 0), vertex(c + 1, 1), vertex(c, 1)); };
  add_lower(0);
  add_upper(3);
  for (int c = 0; c < 4; ++c) {
    if (c != 0) add_lower(c);
    if (c != 3) add_upper(c);
  }
  const Intrinsic_triangulation t(mesh);
  CHECK(t.source(t.boundary_curves()[0].front()) == vertex(0, 0));
  CHECK(t.source(t.boundary_curves()[1].front()) == vertex(0, 1));
  const Quartic_differential_result r = run_pipeline(t, Divisor());
  check_results(t, r);
  CHECK_EQUAL(r.t_mesh->nodes.size(), 2u);
  CHECK_EQUAL(r.t_mesh->arcs.size(), 3u);
  CHECK_NEAR(longer_to_shorter_side(r.t_mesh->patches[0]), 4, 1e-12);
}

// What is wrong at the boundary is noticed.
void test_defects()
{
  const Intrinsic_triangulation t = sheet_of_squares();
  std::mt19937 random(8);
  const Quartic_differential_result r = run_pipeline(t, random_divisor(t, {{1, 1, 1, 1, 1, 3}}, 1, random));
  const Quartic_differential& q = r.traced();
  const T_mesh& good = *r.t_mesh;
  CHECK_EQUAL(defect(good, q), "");
  const auto spoilt = [&](auto spoil, const std::string& expected) {
    T_mesh bad = good;
    spoil(bad);
    const std::string violation = defect(bad, q);
    CHECK(violation.find(expected) != std::string::npos);
    if (violation.find(expected) == std::string::npos) std::cout << "'" << violation << "' instead of " << expected << '\n';
  };
  const auto first = [&](bool on_boundary) {
    return std::find_if(good.arcs.begin(), good.arcs.end(), [&](const T_mesh::Arc& a) { return a.on_boundary == on_boundary; })
         - good.arcs.begin();
  };
  spoilt([&](T_mesh& m) { m.arcs[first(true)].on_boundary = false; }, "is not used once in each direction");
  spoilt([&](T_mesh& m) { m.arcs[first(false)].on_boundary = true; }, "leaves the boundary");
  spoilt([&](T_mesh& m) {
    for (T_mesh::Node& n : m.nodes)
      if (n.kind == T_mesh::Node_kind::corner) n.kind = T_mesh::Node_kind::singularity;
  }, "no corner on the boundary");
  spoilt([&](T_mesh& m) {
    for (T_mesh::Node& n : m.nodes)
      if (n.kind == T_mesh::Node_kind::singularity) n.kind = T_mesh::Node_kind::corner;
  }, "is a corner inside the surface");
  Quartic_differential leaning = q;
  const Halfedge h = q.triangulation.boundary_curves().front().front();
  for (Halfedge g : q.triangulation.halfedges())
    if (!q.triangulation.is_border(g) && q.triangulation.source(g) == q.triangulation.source(h)) {
      ++leaning.corner[g].x;
      ++leaning.corner[g].y;
    }
  CHECK(!defect(leaning).empty());
  Quartic_differential wrong_order = q;
  for (Vertex v : q.singularities)
    if (q.triangulation.is_border(v)) wrong_order.order[v] += 1;
  CHECK(defect(wrong_order).find("the degree is") != std::string::npos);
  Quartic_differential exchanged = q;   // a corner and another vertex of the boundary
  Vertex corner = q.singularities.front(), straight = Mesh::null_vertex();
  for (Vertex v : q.singularities)
    if (q.triangulation.is_border(v)) corner = v;
  for (Vertex v : q.triangulation.vertices())
    if (q.triangulation.is_border(v) && q.order[v] == 0) straight = v;
  std::swap(exchanged.order[corner], exchanged.order[straight]);
  std::replace(exchanged.singularities.begin(), exchanged.singularities.end(), corner, straight);
  CHECK(defect(exchanged).find("of the boundary is") != std::string::npos);
}

// In numbers of 128 binary digits, where corners slide along their edges too.
void test_precision()
{
  std::mt19937 random(5);
  for (const Surface_with_boundary& s : surfaces_with_boundary()) {
    if (s.curves > 3) continue;
    Intrinsic_triangulation t = s.surface;
    split_obtuse_at_boundary(t);
    std::vector<std::vector<int>> corners(s.curves, {1, 1, 1, 1});
    const Divisor divisor = random_divisor(t, corners, 1, random);
    Quartic_differential_options options;
    options.precision = 128;
    const Quartic_differential_result r = run_pipeline(t, divisor, options);
    check_results(t, r);
    CHECK_EQUAL(r.precision->bits, 128);
    CHECK(r.precision->max_curvature_error <= 1e-29);
    CHECK(r.precision->max_transition_error <= 1e-29);
    for (std::size_t i = 0; i < divisor.size(); ++i)
      CHECK(!divisor[i].on_boundary
            || internal::boundary_place(t, r.singularities[i].location).halfedge != Mesh::null_halfedge());
  }
}

void test_random_divisors(int cases)
{
  std::mt19937 random(2027);
  const std::vector<Surface_with_boundary> surfaces = surfaces_with_boundary();
  Outcomes outcomes;
  for (int n = 0; n < cases; ++n) {
    Surface_with_boundary s = surfaces[n % surfaces.size()];
    const bool obtuse = n % 4 == 3;
    if (obtuse) s.surface = with_obtuse_rim(s.surface, 179, random);
    const Boundary_case c = random_case(s, random);
    std::cout << n << ", " << c.name << (obtuse ? ", obtuse rim, " : ", ") << c.divisor.size() << " singularities: "
              << std::flush;
    outcomes.add([&] {
      const Quartic_differential_result r = run_pipeline(c.surface, c.divisor);
      check_results(c.surface, r);
      std::cout << r.t_mesh->patches.size() << " rectangles, rotations to " << r.immersion.rotation_error << std::endl;
      return true;
    });
  }
  std::cout << outcomes << std::endl;
  CHECK(outcomes.reached >= cases * 9 / 10);
  CHECK_EQUAL(outcomes.numerical, 0);
}

int main()
{
  test_rectangle();
  test_annulus();
  test_prism();
  test_defects();
  test_precision();
  test_random_divisors(100);
  return Quartic_test::result();
}
