// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// T-meshes of surfaces glued from parallelograms: every invariant on hundreds of random ones, hand counts on small ones.

#include "check.h"
#include "exact_charts.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

using Kind = T_mesh::Node_kind;

std::size_t number_of(const T_mesh& t, Kind kind)
{
  return std::count_if(t.nodes.begin(), t.nodes.end(), [&](const T_mesh::Node& n) { return n.kind == kind; });
}

/// the patches' shapes, whichever side comes first
std::multiset<std::pair<std::int64_t, std::int64_t>> shapes(const T_mesh& t)
{
  std::multiset<std::pair<std::int64_t, std::int64_t>> result;
  for (const T_mesh::Patch& p : t.patches) result.insert(std::minmax(p.width, p.height));
  return result;
}

T_mesh traced(const Quartic_differential& q)
{
  Visitor quiet;
  return t_mesh(q, quiet);
}

/// every invariant, and Euler's formula for the number of patches
T_mesh check_t_mesh(const Quartic_differential& q)
{
  CHECK_EQUAL(defect(q), "");
  T_mesh t;
  try { t = traced(q); } catch (const Error& e) { CHECK_EQUAL(std::string(e.what()), ""); return t; }
  CHECK_EQUAL(defect(t, q), "");
  const long cones = static_cast<long>(q.singularities.size()), genus = q.triangulation.genus();
  if (number_of(t, Kind::meeting) == 0 && number_of(t, Kind::crossing) == 0)
    CHECK_EQUAL(static_cast<long>(t.patches.size()), 3 * cones + 6 * genus - 6);
  CHECK_EQUAL(2 * static_cast<long>(t.patches.size()),
              2 * (2 * genus - 2 + cones + static_cast<long>(number_of(t, Kind::crossing)))
                + static_cast<long>(number_of(t, Kind::t_junction)));
  return t;
}

/// marks a regular vertex as a singularity of order 0 if there is no other
void mark_one_vertex(Quartic_differential& q)
{
  if (q.singularities.empty()) q.singularities.push_back(Vertex(0));
}

// All trajectories run through vertices, meet head on, tie.
void random_square_tiled_surfaces()
{
  std::mt19937 random(20260101);
  const int sizes[] = {1, 2, 3, 4, 5, 6, 8, 12, 20, 40}, flips[] = {0, 0, 5, 30, 100};
  std::set<int> genera;
  std::size_t self_glued = 0, meetings = 0, crossings = 0;
  for (int done = 0; done < 600;) {
    const Gluing glued = random_gluing(sizes[random() % 10], random);
    if (!is_connected(glued)) continue;
    const std::int64_t side = 1 + random() % 64;
    Quartic_differential q = exact_differential(glued, {side, 0}, {0, side});
    mark_one_vertex(q);
    flip_exactly(q, flips[random() % 5], 50 * side, random);
    const T_mesh t = check_t_mesh(q);
    genera.insert(q.triangulation.genus());
    meetings += number_of(t, Kind::meeting);
    crossings += number_of(t, Kind::crossing);
    const Intrinsic_triangulation& m = q.triangulation;
    self_glued += std::any_of(m.halfedges().begin(), m.halfedges().end(),
                              [&](Halfedge h) { return m.face(h) == m.face(m.opposite(h)); });
    ++done;
  }
  CHECK_EQUAL(*genera.begin(), 0);
  CHECK(*genera.rbegin() >= 18);
  CHECK(self_glued > 100);
  CHECK(meetings > 100);
  std::cout << "square-tiled: genus up to " << *genera.rbegin() << ", " << self_glued << " self-glued, " << meetings
            << " meetings, " << crossings << " crossings\n";
}

// Trajectories in general position: the result must not depend on the triangulation.
void random_parallelograms()
{
  std::mt19937 random(7);
  for (int done = 0; done < 200;) {
    const Gluing glued = random_half_translation_gluing(1 + random() % 12, random);
    if (!is_connected(glued)) continue;
    const std::int64_t size = std::int64_t(1) << (8 + random() % 24);
    const auto coordinate = [&] { return static_cast<std::int64_t>(random() % size) - size / 4; };
    const Grid_vector u{coordinate(), coordinate()}, v{coordinate(), coordinate()};
    if (doubled_area({0, 0}, u, v) <= size * size / 16) continue;
    Quartic_differential q = exact_differential(glued, u, v);
    mark_one_vertex(q);
    const T_mesh before = check_t_mesh(q);
    flip_exactly(q, 60, 50 * size, random);
    const T_mesh after = check_t_mesh(q);
    if (number_of(before, Kind::meeting) + number_of(before, Kind::crossing) == 0)
      CHECK(shapes(before) == shapes(after));
    ++done;
  }
}

void check_counts(const T_mesh& t, std::size_t singularities, std::size_t meetings, std::size_t t_junctions,
                  std::size_t arcs, std::size_t patches)
{
  CHECK_EQUAL(number_of(t, Kind::singularity), singularities);
  CHECK_EQUAL(number_of(t, Kind::meeting), meetings);
  CHECK_EQUAL(number_of(t, Kind::t_junction), t_junctions);
  CHECK_EQUAL(number_of(t, Kind::crossing), std::size_t(0));
  CHECK_EQUAL(t.arcs.size(), arcs);
  CHECK_EQUAL(t.patches.size(), patches);
}

// Two squares glued along their boundaries: traces run along the sides and meet in their middles.
void pillow()
{
  const Quartic_differential q = exact_differential({4, 7, 6, 5, 0, 3, 2, 1}, {5, 0}, {0, 5});
  CHECK_EQUAL(q.singularities.size(), std::size_t(4));
  const T_mesh t = check_t_mesh(q);
  check_counts(t, 4, 4, 0, 8, 2);
  CHECK((shapes(t) == std::multiset<std::pair<std::int64_t, std::int64_t>>{{10, 10}, {10, 10}}));
  for (const T_mesh::Arc& arc : t.arcs) CHECK_EQUAL(arc.length, 5);
}

// A square torus with a marked point: two closed trajectories.
void square_torus()
{
  Quartic_differential q = exact_differential({2, 3, 0, 1}, {3, 0}, {0, 3});
  mark_one_vertex(q);
  const T_mesh t = check_t_mesh(q);
  check_counts(t, 1, 2, 0, 4, 1);
  CHECK_EQUAL(t.patches[0].width, 6);
  CHECK_EQUAL(t.patches[0].height, 6);
}

// The torus with lattice (12, 0), (5, 30): the horizontal trajectory is closed; the vertical ones end on it.
void sheared_torus()
{
  Quartic_differential q = exact_differential({2, 3, 0, 1}, {12, 0}, {5, 30});
  mark_one_vertex(q);
  const T_mesh t = check_t_mesh(q);
  check_counts(t, 1, 1, 2, 6, 2);
  CHECK((shapes(t) == std::multiset<std::pair<std::int64_t, std::int64_t>>{{10, 60}, {14, 60}}));
}

// Three squares in the form of an L, opposite sides glued: genus 2, one zero of order 8.
void l_of_squares()
{
  // square 1 is right of square 0, square 2 above it
  const Gluing glued{10, 7, 8, 5, 6, 3, 4, 1, 2, 11, 0, 9};
  const Quartic_differential q = exact_differential(glued, {4, 0}, {0, 4});
  CHECK_EQUAL(q.triangulation.genus(), 2);
  CHECK_EQUAL(q.singularities.size(), std::size_t(1));
  CHECK_EQUAL(q.order[q.singularities[0]], 8);
  check_counts(check_t_mesh(q), 1, 6, 0, 12, 3);
}

// Every kind of damage is found.
void damaged_t_meshes()
{
  Quartic_differential q = exact_differential({2, 3, 0, 1}, {12, 0}, {5, 30});
  mark_one_vertex(q);
  const T_mesh good = traced(q);
  CHECK_EQUAL(defect(good, q), "");
  const std::vector<std::function<void(T_mesh&)>> damages = {
    [](T_mesh& t) { ++t.grid_exponent; },
    [](T_mesh& t) { t.nodes[0].order = 1; },
    [](T_mesh& t) { t.nodes[0].kind = Kind::crossing; },
    [](T_mesh& t) { t.nodes[0].vertex = Mesh::null_vertex(); },
    [](T_mesh& t) { t.nodes[1].kind = t.nodes[1].kind == Kind::meeting ? Kind::t_junction : Kind::meeting; },
    [](T_mesh& t) { t.nodes[1].order = 1; },
    [](T_mesh& t) { t.nodes[1].point.x += 1; },
    [](T_mesh& t) { t.nodes[1].face = Mesh::null_face(); },
    [](T_mesh& t) { t.nodes.push_back(t.nodes[0]); },
    [](T_mesh& t) { t.nodes.push_back(t.nodes[1]); },
    [](T_mesh& t) { t.arcs[0].length += 1; },
    [](T_mesh& t) { t.arcs[0].length = 0; },
    [](T_mesh& t) { t.arcs[0].to = t.nodes.size(); },
    [](T_mesh& t) { std::swap(t.arcs[0].from, t.arcs[0].to); },
    [](T_mesh& t) { t.arcs[0].path.clear(); },
    [](T_mesh& t) { t.arcs[0].path[0].from.y += 1; },
    [](T_mesh& t) { t.arcs[0].path[0].direction ^= 2; },
    [](T_mesh& t) { t.arcs[0].path[0].face = Mesh::null_face(); },
    [](T_mesh& t) { t.arcs[1].path.pop_back(); },
    [](T_mesh& t) { t.arcs.pop_back(); },
    [](T_mesh& t) { t.patches[0].width += 2; },
    [](T_mesh& t) { std::swap(t.patches[0].width, t.patches[0].height); },
    [](T_mesh& t) { t.patches[0].sides[1].clear(); },
    [](T_mesh& t) { t.patches[0].sides[1][0].arc = t.arcs.size(); },
    [](T_mesh& t) { t.patches[0].sides[1][0].forward ^= true; },
    [](T_mesh& t) { std::swap(t.patches[0].sides[1], t.patches[0].sides[3]); },
    [](T_mesh& t) { t.patches.pop_back(); },
    [](T_mesh& t) { t.patches.push_back(t.patches[0]); },
  };
  for (std::size_t k = 0; k < damages.size(); ++k) {
    T_mesh bad = good;
    damages[k](bad);
    if (defect(bad, q).empty()) std::cerr << "damage " << k << " was not found\n";
    CHECK(!defect(bad, q).empty());
  }
}

void refused_input()
{
  Quartic_differential q = exact_differential({2, 3, 0, 1}, {12, 0}, {5, 30});
  CHECK_THROWS(traced(q), Infeasible_divisor_error, "no singularity");
  const std::int64_t huge = std::int64_t(1) << 60;
  Quartic_differential far = exact_differential({2, 3, 0, 1}, {huge, 0}, {0, huge});
  mark_one_vertex(far);
  CHECK_THROWS(traced(far), Numerical_error, "beyond 2^59");
  // the trajectories of this torus wind about 2^29 times before they end: too long for 64 bits
  const std::int64_t wide = std::int64_t(1) << 58;
  Quartic_differential winding = exact_differential({2, 3, 0, 1}, {wide, 1}, {-1, wide});
  mark_one_vertex(winding);
  CHECK_THROWS(traced(winding), Numerical_error, "2^60");
}

class Impatient : public Visitor
{
public:
  bool go_further() override { return false; }
};

void cancelled_run()
{
  const Quartic_differential q = exact_differential({4, 7, 6, 5, 0, 3, 2, 1}, {5, 0}, {0, 5});
  Impatient visitor;
  CHECK_THROWS(t_mesh(q, visitor), Cancelled_error, "cancelled");
}

} // namespace

int main()
{
  pillow();
  square_torus();
  sheared_torus();
  l_of_squares();
  random_square_tiled_surfaces();
  random_parallelograms();
  damaged_t_meshes();
  refused_input();
  cancelled_run();
  return result();
}
