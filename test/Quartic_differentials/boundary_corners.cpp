// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Corners of the boundary: found where it turns sharply and nowhere else, read from files and written to them.

#include "check.h"
#include "plates.h"
#include "surfaces_with_boundary.h"

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/IO/singularities.h>
#include <CGAL/Quartic_differentials/boundary_corners.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>

#include <sstream>

using namespace Quartic_test;

namespace {

const double pi = CGAL_PI;

// What is true of all corners, and their number.
std::size_t number_of_corners(const std::string& name, const Intrinsic_triangulation& t)
{
  const Divisor corners = boundary_corners(t);
  std::cout << name << ": " << corners.size() << " corners" << std::endl;
  for (const Singularity& s : corners) {
    CHECK(s.on_boundary && s.pinned && s.order >= -1 && s.order != 0);
    CHECK(internal::boundary_place(t, s.location).halfedge != Mesh::null_halfedge());
    CHECK_EQUAL(*std::max_element(s.location.barycentric.begin(), s.location.barycentric.end()), 1);   // at a vertex
  }
  return corners.size();
}

// There are corners with m quads at all these places, and no others.
void check_corners(const std::string& name, const Intrinsic_triangulation& t,
                   const std::vector<std::pair<std::complex<double>, int>>& expected, double tolerance)
{
  CHECK_EQUAL(number_of_corners(name, t), expected.size());
  const Divisor corners = boundary_corners(t);
  for (const auto& [place, quads] : expected) {
    const Point_3 wanted = in_space(place);
    CHECK_EQUAL(std::count_if(corners.begin(), corners.end(), [&, m = quads](const Singularity& s) {
      const double d = CGAL::squared_distance(position_on_input(t, s.location), wanted);
      return s.order == m - 2 && d <= tolerance * tolerance;
    }), 1);
  }
}

std::vector<std::pair<std::complex<double>, int>> rectangle_corners(double a, double b)
{ return {{{a, b}, 1}, {{-a, b}, 1}, {{-a, -b}, 1}, {{a, -b}, 1}}; }

// ---- where the boundary turns

void test_polygons()
{
  for (int n : {4, 8, 100})
    for (double b : {1., 0.2, 0.01})   // also long strips
      check_corners("rectangle", Intrinsic_triangulation(star_shaped(rectangle(1, b, 0, n), 2)),
                    rectangle_corners(1, b), 0);
  check_corners("two triangles", Intrinsic_triangulation(plate_of_squares(1, 1, [](int, int) { return true; })),
                {{{0, 0}, 1}, {{1, 0}, 1}, {{0, 1}, 1}, {{1, 1}, 1}}, 0);
  check_corners("L with a hole", Intrinsic_triangulation(l_with_hole()),
                {{{0, 0}, 1}, {{12, 0}, 1}, {{12, 6}, 1}, {{6, 6}, 3}, {{6, 12}, 1}, {{0, 12}, 1},
                 {{2, 2}, 3}, {{4, 2}, 3}, {{2, 4}, 3}, {{4, 4}, 3}}, 0);
  for (int k = 3; k <= 9; ++k)   // a regular polygon: its corners turn by 360 / k degrees
    CHECK_EQUAL(number_of_corners("polygon", Intrinsic_triangulation(star_shaped(circle(k, [](int) { return 1; }), 2))),
                k <= 5 ? static_cast<std::size_t>(k) : 0u);
}

// Any angle at one vertex, beyond a full turn too; with two right angles at the ends of the arc.
void test_angles()
{
  for (const auto& [degrees, quads] : std::vector<std::pair<double, int>>{
         {30, 1}, {60, 1}, {110, 1}, {115, 0}, {180, 0}, {240, 0}, {250, 3}, {270, 3}, {310, 3}, {320, 4}, {360, 4},
         {400, 4}, {450, 5}}) {
    const Intrinsic_triangulation t(sector(degrees * pi / 180, 6, static_cast<int>(degrees)));
    const Divisor corners = boundary_corners(t);
    CHECK_EQUAL(corners.size(), quads == 0 ? 2u : 3u);
    int at_tip = 0;
    for (const Singularity& s : corners) {
      const auto k = std::max_element(s.location.barycentric.begin(), s.location.barycentric.end());
      const Vertex v = t.source(t.halfedges(s.location.face)[k - s.location.barycentric.begin()]);
      if (v == Vertex(0)) at_tip = s.order + 2;
      else                CHECK_EQUAL(s.order, -1);
    }
    CHECK_EQUAL(at_tip, quads);
  }
}

// Smooth curves have none, however fine or coarse they are; a fillet is one if it is short.
void test_smooth()
{
  for (int n : {12, 24, 60, 300, 2000}) {
    Polygon ellipse = circle(n, [](int) { return 1; });
    CHECK_EQUAL(number_of_corners("circle", Intrinsic_triangulation(star_shaped(ellipse, 3))), 0u);
    for (std::complex<double>& z : ellipse) z = {z.real(), 0.5 * z.imag()};
    CHECK_EQUAL(number_of_corners("ellipse", Intrinsic_triangulation(star_shaped(ellipse, 3))), 0u);
  }
  for (double radius : {0.01, 0.05, 0.1})   // of a perimeter of almost 6
    check_corners("fillets", Intrinsic_triangulation(star_shaped(rectangle(1, 0.5, radius, 100), 3)),
                  rectangle_corners(1 - 0.3 * radius, 0.5 - 0.3 * radius), 0.15 * radius);
  for (double radius : {0.3, 0.4})
    CHECK_EQUAL(number_of_corners("large fillets", Intrinsic_triangulation(star_shaped(rectangle(1, 0.5, radius, 100), 3))),
                0u);
}

// Noise and jags of the size of an edge make no corners, and hide none.
void test_noise()
{
  std::mt19937 random(2026);
  for (int n : {60, 120, 400}) {
    const double edge = 2 * pi / n;
    const auto noisy = [&](int) { return 1 + 0.3 * edge * uniform(random, -1, 1); };
    CHECK_EQUAL(number_of_corners("noisy circle", Intrinsic_triangulation(star_shaped(circle(n, noisy), 3))), 0u);
    const auto jagged = [&](int k) { return 1 + (k % 2 ? 0.4 : -0.4) * edge; };
    CHECK_EQUAL(number_of_corners("jagged circle", Intrinsic_triangulation(star_shaped(circle(n, jagged), 3))), 0u);
    Polygon rough = rectangle(1, 0.5, 0, n);
    const double side = 6. / n;
    for (std::complex<double>& z : rough) z *= 1 + 0.2 * side * uniform(random, -1, 1);
    check_corners("rough rectangle", Intrinsic_triangulation(star_shaped(rough, 3)), rectangle_corners(1, 0.5),
                  2 * side);
  }
  for (int holes = 0; holes <= 4; ++holes)
    CHECK_EQUAL(number_of_corners("plate with " + std::to_string(holes) + " jagged holes",
                                  Intrinsic_triangulation(plate(holes, 40))), 0u);
  for (const Surface_with_boundary& s : surfaces_with_boundary())   // coarse: holes of 15 to 31 edges have some
    CHECK(number_of_corners(s.name, s.surface) <= 2 * static_cast<std::size_t>(s.curves));
}

// On the Delaunay triangulation, whose boundary is split, they are the same.
void test_triangulations()
{
  const Intrinsic_triangulation input(star_shaped(rectangle(1, 0.3, 0, 40), 7));
  const Prepared_surface p(input);
  CHECK(p.splits > 0);
  const Divisor before = boundary_corners(p.input), after = boundary_corners(p.delaunay);
  CHECK_EQUAL(before.size(), 4u);
  CHECK_EQUAL(after.size(), 4u);
  for (std::size_t k = 0; k < after.size(); ++k) {
    const auto a = internal::boundary_place(p.input, before[k].location);
    const auto b = internal::boundary_place(p.delaunay, after[k].location);
    CHECK(a.halfedge == b.halfedge && a.fraction == b.fraction);
  }
}

// ---- files

Divisor read(const std::string& text, const Intrinsic_triangulation& t)
{
  std::istringstream in(text);
  return read_corners(in, t);
}

void test_files()
{
  const Intrinsic_triangulation t(l_with_hole());   // area 104
  const Divisor d = read("# corners\n0 0 0 1 pinned\n\n 6.1 6.2 0.1 3 # slides\n3 2.3 0 3\n", t);
  CHECK_EQUAL(d.size(), 3u);
  CHECK(d[0].pinned && !d[1].pinned && d[0].on_boundary && d[1].on_boundary);
  CHECK(d[0].order == -1 && d[1].order == 1 && d[2].order == 1);
  CHECK(position_on_input(t, d[0].location) == Point_3(0, 0, 0));
  CHECK(position_on_input(t, d[1].location) == Point_3(6, 6.2, 0));
  CHECK(position_on_input(t, d[2].location) == Point_3(3, 2, 0));

  Divisor mixed = boundary_corners(t);
  mixed.push_back({{Face(5), {0.2, 0.3, 0.5}}, 1, false, false});
  mixed.push_back({on_edge(t, internal::boundary_place(t, mixed[0].location).halfedge, 1 / 3.), 2, false, true});
  std::ostringstream corners, singularities;
  write_corners(corners, mixed, t);
  write_singularities(singularities, mixed, t);
  std::istringstream inner(singularities.str());
  CHECK_EQUAL(read_singularities(inner, t).size(), 1u);
  const Divisor again = read(corners.str(), t);
  CHECK_EQUAL(again.size(), mixed.size() - 1);
  for (std::size_t k = 0; k < again.size(); ++k) {
    const Singularity& s = mixed[k < 10 ? k : 11];
    CHECK(again[k].order == s.order && again[k].pinned == s.pinned && again[k].on_boundary);
    const Point_3 there = position_on_input(t, s.location);
    CHECK_NEAR(CGAL::squared_distance(position_on_input(t, again[k].location), there), 0, 1e-28);
  }
}

void test_refusals()
{
  const Intrinsic_triangulation t(l_with_hole());
  CHECK_THROWS(read("0 0 0 1\n0 1 0 2\n", t), Infeasible_divisor_error, "line 2 of the corners: where two quads meet");
  CHECK_THROWS(read("0 0 0 0", t), Infeasible_divisor_error, "at least one quad must meet at a corner, not 0");
  CHECK_THROWS(read("0 0 0", t), Infeasible_divisor_error, "line 1 of the corners: expected 'x y z m [pinned]'");
  CHECK_THROWS(read("0 0 0 1 pined", t), Infeasible_divisor_error, "after the m, not 'pined'");
  CHECK_THROWS(read("0 0 0 1 pinned 3", t), Infeasible_divisor_error, "'3' is one word too many");
  CHECK_THROWS(read("1 5 0 3", t), Infeasible_divisor_error, "the point is not on the boundary");
  CHECK_THROWS(read("0 0 0.6 1", t), Infeasible_divisor_error, "at most 0.05");
  CHECK_EQUAL(read("0 0 0.5 1", t).size(), 1u);
  CHECK_THROWS(read("0 0 0 1", Intrinsic_triangulation(bumpy_sphere(1))), Infeasible_divisor_error, "is closed");
  const Intrinsic_triangulation flat(glued_triangles(t));
  CHECK_THROWS(read("0 0 0 1", flat), Infeasible_divisor_error, "corners are given by points in space");
}

} // namespace

int main()
{
  test_polygons();
  test_angles();
  test_smooth();
  test_noise();
  test_triangulations();
  test_files();
  test_refusals();
  return Quartic_test::result();
}
