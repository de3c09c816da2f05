// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Step 5: every feasible divisor becomes legal in a few steps; the others are refused with their mathematical reason.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <cmath>

using namespace CGAL::Quartic_differentials;

namespace {

// A surface with everything that step 5 needs.
struct Setting
{
  explicit Setting(const Intrinsic_triangulation& input)
    : surface(riemann_surface(input, visitor)), map(surface.delaunay, surface.homology.cochains, surface.forms) {}

  Legal_divisor legalized(const Divisor& d, const Legalization_options& options = {})
  { return legalize_divisor(map, surface.periods, d, options, visitor); }
  Divisor initial(int count = 0) const
  { return curvature_divisor(surface.delaunay, surface.weights, surface.laplacian, count); }

  Visitor         visitor;
  Riemann_surface surface;
  Abel_jacobi_map map;
};

Singularity at(const Intrinsic_triangulation& t, std::size_t face, int order, bool pinned = false)
{
  return {{Face(static_cast<Mesh::size_type>(face % t.number_of_faces())), {0.3, 0.4, 0.3}}, order, pinned};
}

// The condition itself, computed anew from the positions: F in (pi/2) Z^2g.
double defect(const Setting& s, const Divisor& d)
{
  const Eigen::VectorXd f = s.map.residual(d) / (std::acos(-1.0) / 2);
  return f.size() == 0 ? 0 : (f - f.array().round().matrix()).cwiseAbs().maxCoeff();
}

void test_curvature_divisors(const Quartic_test::Named_surface& named)
{
  Setting s(named.surface);
  const int g = named.surface.genus();
  for (Lattice_norm norm : {Lattice_norm::movement, Lattice_norm::paper}) {
    Legalization_options options;
    options.norm = norm;
    const Divisor initial = s.initial();
    CHECK_EQUAL(degree(initial), 8 * g - 8);
    const Legal_divisor legal = s.legalized(initial, options);
    std::cout << named.name << ": " << initial.size() << " singularities, " << legal.history.size() - 1
              << " steps to " << legal.history.back() << std::endl;
    CHECK(legal.history.size() - 1 <= 10);
    CHECK(legal.history.back() <= 1e-12);
    CHECK(defect(s, legal.divisor) < 1e-11);
    CHECK_EQUAL(degree(legal.divisor), 8 * g - 8);
    CHECK(legal.certified);
    for (std::size_t k = 1; k < legal.history.size(); ++k) CHECK(legal.history[k] < legal.history[k - 1]);
  }
}

void test_counts()
{
  const Setting s{Intrinsic_triangulation(handle_chain(2, 6))};
  CHECK_EQUAL(s.initial(12).size(), 12u);
  CHECK_EQUAL(s.initial(13).size(), 14u);   // parity
  CHECK_THROWS(s.initial(6), Infeasible_divisor_error, "at least 8");
  CHECK_THROWS(s.initial(100000), Infeasible_divisor_error, "no room");
}

void test_degree_repair()
{
  const Setting s{Intrinsic_triangulation(handle_chain(3, 6))};
  const Intrinsic_triangulation& t = s.surface.delaunay;
  for (int order : {2, -3}) {
    const Divisor repaired = with_repaired_degree(t, s.surface.weights, {at(t, 10, order)});
    CHECK_EQUAL(degree(repaired), 16);
    CHECK_EQUAL(repaired.front().order, order);
    CHECK_EQUAL(repaired.size(), static_cast<std::size_t>(1 + 16 - order));
  }
}

void test_pinned()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 6))};
  Divisor d = s.initial(16);
  d[0].pinned = d[5].pinned = true;
  const Legal_divisor legal = s.legalized(d);
  CHECK(legal.history.back() <= 1e-12);
  CHECK(legal.moved_by[0] == 0 && legal.moved_by[5] == 0);
  CHECK(legal.divisor[0].location.face == d[0].location.face);
  for (Singularity& p : d) p.pinned = true;
  CHECK_THROWS(s.legalized(d), Infeasible_divisor_error, "control only 0 of the 4");
  d[3].pinned = false;
  CHECK_THROWS(s.legalized(d), Infeasible_divisor_error, "control only 2 of the 4");
  // what is legal already may be pinned altogether
  Divisor legal_one = legal.divisor;
  for (Singularity& p : legal_one) p.pinned = true;
  CHECK_EQUAL(s.legalized(legal_one).history.size(), 1u);
}

void test_refusals()
{
  Setting torus_setting{Intrinsic_triangulation(torus(1, 0.4, 40, 24))};
  const Intrinsic_triangulation& t = torus_setting.surface.delaunay;
  CHECK_THROWS(torus_setting.legalized({at(t, 3, 1), at(t, 900, -1)}), Infeasible_divisor_error, "coincide");
  CHECK_THROWS(torus_setting.legalized({at(t, 3, 1)}), Infeasible_divisor_error, "degree of the divisor is 1");
  CHECK_THROWS(torus_setting.legalized({at(t, 3, 4), at(t, 900, -4)}), Infeasible_divisor_error, "cone angle");
  CHECK_THROWS(torus_setting.legalized({at(t, 3, 0)}), Infeasible_divisor_error, "regular point");
  CHECK_THROWS(torus_setting.legalized({at(t, 3, 1), at(t, 3, 1), at(t, 900, -2)}), Infeasible_divisor_error,
               "too near each other");
  // z1 + z2 = 2 p may be solved only by z1 = z2 = p on the nearest lattice vectors; elsewhere it is legal
  const Legal_divisor split = torus_setting.legalized({at(t, 3, 1), at(t, 500, 1), at(t, 1200, -1), at(t, 1600, -1)});
  CHECK(split.history.back() <= 1e-12);
  // the flat torus
  const Legal_divisor none = torus_setting.legalized({});
  CHECK(none.divisor.empty() && none.history.size() == 1);

  Setting sphere{Intrinsic_triangulation(handle_chain(0, 6))};
  CHECK_THROWS(sphere.legalized({}), Infeasible_divisor_error, "8g-8 = -8");
}

// A singularity at each end of a short geodesic: the distance is that of the plane where the surface is flat.
void test_distances()
{
  Glued_triangles square;   // a flat torus of area 1
  square.triangles = {{0, 0, 0}, {0, 0, 0}};
  square.opposite = {{{{1, 1}, {1, 2}, {1, 0}}}, {{{0, 2}, {0, 0}, {0, 1}}}};
  square.lengths = {{1, 1, std::sqrt(2.0)}, {std::sqrt(2.0), 1, 1}};
  const Intrinsic_triangulation t(subdivided(subdivided(subdivided(square))));
  std::mt19937 random(17);
  Setting s{t};
  for (int trial = 0; trial < 50; ++trial) {
    const Lifted_point p = s.map.lift({Face(static_cast<Mesh::size_type>(random() % t.number_of_faces())), {0.2, 0.5, 0.3}});
    const double distance = Quartic_test::uniform(random, 0.01, 0.3);
    const Lifted_point q = s.map.moved(p, std::polar(distance, Quartic_test::uniform(random, -3, 3)));
    const Nearest_singularities n = nearest_singularities(s.surface.delaunay, {p.location, q.location}, 0.35);
    CHECK_NEAR(n.distance, distance, 1e-9);
  }
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test_curvature_divisors(s);
  for (const auto& s : Quartic_test::real_surfaces({"kitten_18k9", "amphora_20k", "bracket_29k", "buddha_20k"}))
    test_curvature_divisors(s);
  test_counts();
  test_degree_repair();
  test_pinned();
  test_refusals();
  test_distances();
  return Quartic_test::result();
}
