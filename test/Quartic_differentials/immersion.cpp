// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The immersion of square-tiled surfaces, whose exact flat geometry is known, from perturbed edge lengths.

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/immersion.h>

#include "check.h"
#include "exact_charts.h"
#include "square_tiled_surfaces.h"

#include <algorithm>
#include <map>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

std::vector<double> perturbed(const std::vector<double>& lengths, double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<double> result = lengths;
  for (double& l : result) l *= 1 + uniform(random);
  return result;
}

struct Totals
{
  int                surfaces = 0, self_glued = 0, without_odd_rotation = 0, smallest_order = 0, largest_order = 0;
  double             rotation_error = 0, layout_gap = 0, largest_move = 0;
  std::map<int, int> by_genus;
};

void check_immersion(const Square_tiled_surface& s, const Immersion_options& options, std::mt19937& random,
                     Totals& totals)
{
  const Intrinsic_triangulation& t = s.triangulation;
  Immersion_report report;
  const Quartic_differential q = immersion(t, perturbed(t.lengths(), 1e-13, random), s.singularities, s.order, t.area(),
                                           options, report);
  CHECK_EQUAL(defect(q), "");
  CHECK_EQUAL(report.flipped_triangles, 0u);
  CHECK(report.rotation_error < 1e-10);
  CHECK(report.layout_gap < 1e-10);
  CHECK(report.largest_move < 1e-10 + std::ldexp(30.0, -report.grid_exponent));
  CHECK_NEAR(std::sqrt(static_cast<double>(q.doubled_area()) / 2) * std::ldexp(q.surface_units_per_unit, -q.grid_exponent),
             std::sqrt(t.area()), 1e-9);

  ++totals.surfaces;
  ++totals.by_genus[t.genus()];
  for (Halfedge h : t.halfedges())
    if (t.face(h) == t.face(t.opposite(h))) { ++totals.self_glued; break; }
  const auto is_odd = [](const Transition& x) { return x.rotation % 2 == 1; };
  if (std::none_of(q.transition.begin(), q.transition.end(), is_odd)) ++totals.without_odd_rotation;
  for (int n : s.order) {
    totals.smallest_order = std::min(totals.smallest_order, n);
    totals.largest_order = std::max(totals.largest_order, n);
  }
  totals.rotation_error = std::max(totals.rotation_error, report.rotation_error);
  totals.layout_gap = std::max(totals.layout_gap, report.layout_gap);
  if (report.grid_exponent >= 44) totals.largest_move = std::max(totals.largest_move, report.largest_move);
}

void random_surfaces(std::mt19937& random)
{
  Totals totals;
  for (int i = 0; i < 400; ++i) {
    const int squares = 1 + static_cast<int>(random() % 18);
    const Gluing glued = i % 4 == 0 ? random_translation_gluing(squares, random)
                       : i % 4 == 1 ? random_half_translation_gluing(squares, random) : random_gluing(squares, random);
    if (!is_connected(glued)) continue;
    Square_tiled_surface s = square_tiled_surface(subdivided(glued, 1 + static_cast<int>(random() % 4)));
    flip_randomly(s.triangulation, static_cast<int>(random() % 4) * 50, random);
    check_immersion(s, {i % 2 == 0 ? 0 : 20 + static_cast<int>(random() % 31)}, random, totals);
  }
  std::cout << totals.surfaces << " square-tiled surfaces, " << totals.self_glued << " with self-glued triangles, "
            << totals.without_odd_rotation << " without odd rotation; orders " << totals.smallest_order << " to "
            << totals.largest_order << "; genus:";
  for (const auto& [genus, n] : totals.by_genus) std::cout << ' ' << genus << " (" << n << ')';
  std::cout << "\nrotation error " << totals.rotation_error << " rad, layout gap " << totals.layout_gap
            << ", corners moved by " << totals.largest_move
            << " of the size on grids of 2^-44 and finer" << std::endl;
  CHECK(totals.surfaces > 200);
  CHECK(totals.self_glued > 20);
  CHECK(totals.without_odd_rotation > 20);
  CHECK_EQUAL(totals.smallest_order, -3);
  CHECK(totals.largest_order >= 8);
  for (int genus = 0; genus <= 8; ++genus) CHECK(totals.by_genus[genus] > 0);
}

// two squares glued along their boundaries: four cones of order -2
const Gluing pillow_gluing = {4, 7, 6, 5, 0, 3, 2, 1};

void pillow(std::mt19937& random)
{
  Totals totals;
  const Square_tiled_surface s = square_tiled_surface(subdivided(pillow_gluing, 5));
  CHECK_EQUAL(s.triangulation.genus(), 0);
  CHECK_EQUAL(s.singularities.size(), 4u);
  for (Vertex v : s.singularities) CHECK_EQUAL(s.order[v], -2);
  check_immersion(s, {}, random, totals);
}

// without any cone: all rotations are 0 and closure is automatic
void flat_torus(std::mt19937& random)
{
  Totals totals;
  for (int m = 1; m <= 6; ++m) {
    Square_tiled_surface s = square_tiled_surface(subdivided({2, 3, 0, 1}, m));
    CHECK_EQUAL(s.triangulation.genus(), 1);
    CHECK(s.singularities.empty());
    flip_randomly(s.triangulation, 20, random);
    check_immersion(s, {}, random, totals);
    s.singularities.push_back(Vertex(0));   // a marked regular point
    check_immersion(s, {}, random, totals);
  }
}

Square_tiled_surface some_surface()
{
  std::mt19937 random(7);
  Gluing glued = random_gluing(6, random);
  while (!is_connected(glued)) glued = random_gluing(6, random);
  return square_tiled_surface(subdivided(glued, 3));
}

void inexact_holonomy_is_refused()
{
  const Square_tiled_surface s = some_surface();
  std::mt19937 random(3);
  Immersion_report report;
  CHECK_THROWS(immersion(s.triangulation, perturbed(s.triangulation.lengths(), 1e-4, random), s.singularities, s.order,
                         1, {}, report), Numerical_error, "holonomy");
  CHECK(report.rotation_error > 1e-6);
}

void wrong_orders_are_refused()
{
  const Square_tiled_surface s = some_surface();
  std::vector<int> order = s.order;
  order[s.singularities[0]] += 4;
  order[s.singularities[1]] -= 4;
  Immersion_report report;
  CHECK_THROWS(immersion(s.triangulation, s.triangulation.lengths(), s.singularities, order, 1, {}, report),
               Numerical_error, "does not fit the divisor: the angle at vertex");
}

// A needle that no grid of 2^-20 can hold: the seams stay exact, and the caller is told.
void flipped_triangles_are_reported()
{
  Square_tiled_surface s = square_tiled_surface(subdivided(pillow_gluing, 4));
  s.triangulation.insert({Face(0), {1 - 2e-9, 1e-9, 1e-9}});
  s.order.push_back(0);
  Immersion_report report;
  const Quartic_differential coarse = immersion(s.triangulation, s.triangulation.lengths(), s.singularities, s.order, 1,
                                                {20}, report);
  CHECK(report.flipped_triangles > 0);
  CHECK(report.min_altitude <= 0);
  for (Halfedge h : s.triangulation.halfedges())
    CHECK(coarse.transition[h](coarse.corner[h]) == coarse.corner[s.triangulation.next(s.triangulation.opposite(h))]);
  CHECK(defect(coarse).find("is not positively oriented") != std::string::npos);
  CHECK_THROWS(require_resolved_triangles(report), Numerical_error, "use more or better placed singularities");

  immersion(s.triangulation, s.triangulation.lengths(), s.singularities, s.order, 1, {}, report);
  CHECK_EQUAL(report.flipped_triangles, 0u);   // but the needles' shapes are a matter of rounding
  CHECK_THROWS(require_resolved_triangles(report), Numerical_error, "the smallest triangles");
}

// every field that `defect()` looks at, spoilt
void defects_are_found()
{
  const Square_tiled_surface s = some_surface();
  Immersion_report report;
  const Quartic_differential q = immersion(s.triangulation, s.triangulation.lengths(), s.singularities, s.order, 1, {},
                                           report);
  CHECK_EQUAL(defect(q), "");
  const auto check_defect = [&](const std::string& sentence, auto spoil) {
    Quartic_differential bad = q;
    spoil(bad);
    CHECK(defect(bad).find(sentence) != std::string::npos);
  };
  check_defect("in number", [](auto& b) { b.corner.pop_back(); });
  check_defect("in number", [](auto& b) { b.order.pop_back(); });
  check_defect("beyond", [](auto& b) { b.corner[3].x = std::int64_t(1) << 62; });
  check_defect("transition", [](auto& b) { b.corner[3].x += 1; });
  check_defect("transition", [](auto& b) { b.transition[0].translation.y += 1; });
  check_defect("rotation", [](auto& b) { b.transition[0].rotation = 4; });
  check_defect("oriented", [](auto& b) { for (Grid_vector& z : b.corner) z.x = -z.x; });
  check_defect("degree", [](auto& b) { b.order[b.singularities[0]] += 1; });
  check_defect("do not compose", [](auto& b) { b.order[b.singularities[0]] += 1; b.order[b.singularities[1]] -= 1; });
  check_defect("the angle", [](auto& b) { b.order[b.singularities[0]] += 4; b.order[b.singularities[1]] -= 4; });
  check_defect("twice", [](auto& b) { b.singularities.push_back(b.singularities[0]); });
  check_defect("not listed", [](auto& b) { b.singularities.pop_back(); });
  check_defect("no vertex", [](auto& b) { b.singularities.push_back(Vertex(1000000)); });
}

// chart() agrees across an edge up to the transition
void charts_change_by_transitions()
{
  const Square_tiled_surface s = some_surface();
  Immersion_report report;
  const Quartic_differential q = immersion(s.triangulation, s.triangulation.lengths(), s.singularities, s.order, 1, {},
                                           report);
  const Intrinsic_triangulation& t = q.triangulation;
  for (Halfedge h : t.halfedges()) {
    Surface_point here{t.face(h), {}}, there{t.face(t.opposite(h)), {}};
    here.barycentric[t.corner(h)] = there.barycentric[t.corner(t.next(t.opposite(h)))] = 0.25;
    here.barycentric[t.corner(t.next(h))] = there.barycentric[t.corner(t.opposite(h))] = 0.75;
    const Transition& x = q.transition[h];
    const double unit = std::ldexp(1.0, q.grid_exponent);
    const std::complex<double> translation(x.translation.x / unit, x.translation.y / unit), i(0, 1);
    CHECK(std::abs(std::pow(i, x.rotation) * q.chart(here) + translation - q.chart(there)) < 1e-14);
  }
}

} // namespace

int main()
{
  std::mt19937 random(2026);
  random_surfaces(random);
  pillow(random);
  flat_torus(random);
  inexact_holonomy_is_refused();
  wrong_orders_are_refused();
  flipped_triangles_are_reported();
  defects_are_found();
  charts_change_by_transitions();
  return Quartic_test::result();
}
