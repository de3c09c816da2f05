// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps 7 and 8 on surfaces with boundary: exact charts whose boundary edges are parallel to axes, and T-meshes whose arcs
// include the boundary.

#include "check.h"
#include "run_pipeline.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/exceptions.h>

using namespace Quartic_test;

// A rectangle of unit squares, each cut along a diagonal, with the lower left corner at the origin.
Mesh rectangle(int width, int height)
{
  Mesh mesh;
  for (int y = 0; y <= height; ++y)
    for (int x = 0; x <= width; ++x) mesh.add_vertex(Point_3(x, y, 0));
  const auto vertex = [&](int x, int y) { return Vertex(static_cast<Mesh::size_type>(y * (width + 1) + x)); };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      mesh.add_face(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1));
      mesh.add_face(vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1));
    }
  return mesh;
}

Singularity corner_at(const Intrinsic_triangulation& t, Vertex v, int quads)
{
  return {on_edge(t, t.halfedge_from(v), 0), quads - 2, true, true};
}

Quartic_differential_result run(const Intrinsic_triangulation& input, const Divisor& divisor)
{
  Visitor visitor;
  Quartic_differential_result result;
  quartic_differential(input, divisor, {}, visitor, result);
  return result;
}

// The differential on two copies of a surface, the second with the charts conj(z), glued along the boundary: a closed
// surface, on which a corner of order n is a singularity of order 2n.
Quartic_differential mirror_double(const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
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
  CHECK_EQUAL(r.refined->flipped_triangles, 0u);
  CHECK_EQUAL(defect(r.refined->differential), "");
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

void test_rectangle()
{
  const Intrinsic_triangulation t(rectangle(6, 4));
  const Divisor corners{corner_at(t, Vertex(0), 1), corner_at(t, Vertex(6), 1), corner_at(t, Vertex(34), 1),
                        corner_at(t, Vertex(28), 1)};
  const Quartic_differential_result r = run(t, corners);
  check_results(t, r);
  CHECK_EQUAL(r.t_mesh->patches.size(), 1u);
  CHECK_EQUAL(r.t_mesh->nodes.size(), 4u);
  CHECK_EQUAL(r.t_mesh->arcs.size(), 4u);
  const T_mesh::Patch& patch = r.t_mesh->patches[0];
  const double ratio = static_cast<double>(patch.width) / static_cast<double>(patch.height);
  CHECK_NEAR(std::max(ratio, 1 / ratio), 1.5, 1e-12);
}

// An annulus is cut across once.
void test_annulus()
{
  const Intrinsic_triangulation t(plate(1, 14));
  const Quartic_differential_result r = run(t, {});
  check_results(t, r);
  CHECK_EQUAL(r.t_mesh->patches.size(), 1u);
  CHECK_EQUAL(r.t_mesh->nodes.size(), 2u);
  CHECK_EQUAL(r.t_mesh->arcs.size(), 3u);
  for (const T_mesh::Node& n : r.t_mesh->nodes) CHECK(n.kind == T_mesh::Node_kind::t_junction);
}

void test_random_divisors(int cases)
{
  std::mt19937 random(2027);
  const std::vector<Surface_with_boundary> surfaces = surfaces_with_boundary();
  const std::vector<std::vector<int>> lists{{}, {1, 1, 1, 1}, {3, 3}, {3}, {1, 1, 3, 3}, {1, 3}, {1, 1, 1, 1, 1, 1}, {4},
                                            {1, 1, 1, 1, 3, 3}, {5, 1}};
  int verified = 0, infeasible = 0, numerical = 0;
  for (int n = 0; n < cases; ++n) {
    const Surface_with_boundary& s = surfaces[n % surfaces.size()];
    Intrinsic_triangulation t = s.surface;
    split_obtuse_at_boundary(t);
    std::vector<std::vector<int>> corners;
    for (int c = 0; c < s.curves; ++c) corners.push_back(lists[random() % lists.size()]);
    const Divisor divisor = random_divisor(t, corners, static_cast<int>(random() % 3), random);
    std::cout << n << ", " << s.name << ", " << divisor.size() << " singularities: " << std::flush;
    try {
      const Quartic_differential_result r = run(t, divisor);
      check_results(t, r);
      std::cout << r.t_mesh->patches.size() << " rectangles, rotations to " << r.immersion.rotation_error << std::endl;
      ++verified;
    } catch (const Infeasible_divisor_error& e) {
      std::cout << e.what() << std::endl;
      ++infeasible;
    } catch (const Numerical_error& e) {
      std::cout << e.what() << std::endl;
      ++numerical;
    }
  }
  std::cout << verified << " verified, " << infeasible << " refused, " << numerical << " not reached" << std::endl;
  CHECK(verified >= cases * 3 / 4);
}

int main()
{
  test_rectangle();
  test_annulus();
  test_random_divisors(33);
  return Quartic_test::result();
}
