// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The singularities of the smoothest 4-direction field: simple, of degree 8g - 8 on every surface, and where theory or
// another implementation says how many there are, as many.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/direction_field.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

using namespace CGAL::Quartic_differentials;

namespace {

Divisor field_divisor(Intrinsic_triangulation t, unsigned seed)
{
  make_delaunay(t);
  return direction_field_divisor(t, cotangent_weights(t, t.lengths()), seed);
}

bool same(const Singularity& a, const Singularity& b)
{
  return a.location.face == b.location.face && a.location.barycentric == b.location.barycentric && a.order == b.order;
}

// What holds on every surface.
std::size_t test_divisor(const std::string& name, const Intrinsic_triangulation& t, unsigned seed)
{
  const Divisor divisor = field_divisor(t, seed);
  std::cout << name << ": " << divisor.size() << " singularities" << std::endl;
  CHECK_EQUAL(degree(divisor), 8 * t.genus() - 8);
  for (const Singularity& s : divisor) {
    const auto& b = s.location.barycentric;
    CHECK(s.order == 1 || s.order == -1);
    CHECK(!s.pinned);
    CHECK_NEAR(b[0] + b[1] + b[2], 1, 1e-15);
    CHECK(*std::min_element(b.begin(), b.end()) > 0.06);
  }
  bool distinct = true;
  for (std::size_t k = 0; k < divisor.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) distinct = distinct && !same(divisor[k], divisor[l]);
  CHECK(distinct);
  const Divisor again = field_divisor(t, seed);
  CHECK(again.size() == divisor.size() && std::equal(again.begin(), again.end(), divisor.begin(), same));
  return divisor.size();
}

// On the round sphere the smoothest fields are the holomorphic sections of a line bundle of degree 8: the eigenvalue
// has multiplicity 9, and each of its fields has exactly 8 zeros.
void test_spheres()
{
  const Intrinsic_triangulation round(Quartic_test::jittered_sphere(4, 0, 1, 1));
  const Intrinsic_triangulation ellipsoid(Quartic_test::jittered_sphere(4, 0.3, 1.5, 1));
  for (unsigned seed = 0; seed < 10; ++seed) CHECK_EQUAL(test_divisor("round sphere", round, seed), 8u);
  for (unsigned seed = 0; seed < 3; ++seed) CHECK_EQUAL(test_divisor("ellipsoid", ellipsoid, seed), 8u);
}

// With z = exp(iku) f(v) in the frame of the circles u and v, the energy density on the torus of revolution is
// f'^2 / r^2 + (k + 4 sin v)^2 f^2 / (R + r cos v)^2 with f > 0. On a thin torus k = 0 is the least, without a zero.
// On a thick one k = 3 and -3 are, together: their fields superpose, with 6 zeros where both are equally large on the
// outer equator and 6 of the other sign on the inner one.
void test_tori_of_revolution()
{
  for (unsigned seed = 0; seed < 3; ++seed) {
    CHECK_EQUAL(test_divisor("thin torus", Intrinsic_triangulation(torus(1, 0.1, 80, 16)), seed), 0u);
    CHECK_EQUAL(test_divisor("thick torus", Intrinsic_triangulation(torus(1, 0.4, 80, 48)), seed), 12u);
  }
}

// The eigenvalue is 0: there are parallel fields. One vertex, loops only; then finer.
void test_flat_torus()
{
  Glued_triangles square;
  square.triangles = {{0, 0, 0}, {0, 0, 0}};
  square.opposite = {{{{1, 1}, {1, 2}, {1, 0}}}, {{{0, 2}, {0, 0}, {0, 1}}}};
  square.lengths = {{1, 1, std::sqrt(2.0)}, {std::sqrt(2.0), 1, 1}};
  for (int level = 0; level < 4; ++level, square = subdivided(square))
    CHECK_EQUAL(test_divisor("flat torus", Intrinsic_triangulation(square), 1), 0u);
}

// The regular octagon with opposite sides glued: genus 2, one vertex of angle 6 pi, loops only.
Glued_triangles octagon()
{
  Glued_triangles s;
  const auto side = [](int k) {   // triangle i has the corners 0, i + 1, i + 2 of the octagon
    return k == 0 ? std::array<int, 2>{0, 0} : k == 7 ? std::array<int, 2>{5, 2} : std::array<int, 2>{k - 1, 1};
  };
  const auto chord = [](int corners) { return 2 * std::sin(corners * std::acos(-1.0) / 8); };
  for (int i = 0; i < 6; ++i) {
    s.triangles.push_back({0, 0, 0});
    s.opposite.push_back({{{i - 1, 2}, side((i + 5) % 8), {i + 1, 0}}});
    // the same numbers on opposite sides and on both sides of a diagonal
    s.lengths.push_back({chord(std::min(i + 1, 7 - i)), chord(1), chord(std::min(i + 2, 6 - i))});
  }
  s.opposite[0][0] = side(4);
  s.opposite[5][2] = side(3);
  return s;
}

// Coarse triangulations: several singularities in a face.
void test_coarse_surfaces()
{
  Glued_triangles pillow;   // the double of a triangle: four poles on each side
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  pillow.opposite = {{{{1, 2}, {1, 1}, {1, 0}}}, {{{0, 2}, {0, 1}, {0, 0}}}};
  pillow.lengths = {{1, 1, 1}, {1, 1, 1}};
  CHECK_EQUAL(test_divisor("pillow", Intrinsic_triangulation(pillow), 1), 8u);
  for (int level = 0; level < 3; ++level)
    test_divisor("octahedron", Intrinsic_triangulation(Quartic_test::jittered_sphere(level, 0, 1, 1)), 1);
  test_divisor("octagon", Intrinsic_triangulation(octagon()), 1);
  test_divisor("octagon, subdivided", Intrinsic_triangulation(subdivided(octagon())), 1);
  for (int g = 1; g <= 6; ++g)
    for (int level = 0; level < 3; ++level) {
      const Intrinsic_triangulation curve(hyperelliptic(g, level));
      test_divisor("hyperelliptic curve of genus " + std::to_string(g), curve, 1);
    }
}

Mesh scaled(Mesh mesh, double factor)
{
  for (Vertex v : mesh.vertices()) {
    const Point_3 p = mesh.point(v);
    mesh.point(v) = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
  }
  return mesh;
}

void test_scaling()
{
  for (const Mesh& mesh : {Quartic_test::jittered_torus(40, 20, 0.3, 0.5, 2), handle_chain(2, 6), bumpy_sphere(3)}) {
    const std::size_t expected = field_divisor(Intrinsic_triangulation(mesh), 1).size();
    for (double factor : {1e-3, 3., 1e4})
      CHECK_EQUAL(field_divisor(Intrinsic_triangulation(scaled(mesh, factor)), 1).size(), expected);
  }
}

// The counts of another implementation (scipy, ARPACK), whose field is converged to rounding. They do not depend on the
// seed, for the least eigenvalue is simple.
void test_real_surfaces()
{
  const std::vector<std::size_t> expected = {54, 22, 34, 20, 24, 56, 530};
  const auto surfaces = Quartic_test::real_surfaces({"spot_5k8", "kitten_18k9", "rockerarm_20k", "sculpt_7k3",
                                                     "3holes_7k2", "fertility_112k", "buddha_20k"});
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    for (unsigned seed : {0, 1}) CHECK_EQUAL(test_divisor(surfaces[k].name, surfaces[k].surface, seed), expected[k]);
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test_divisor(s.name, s.surface, 0);
  test_spheres();
  test_tori_of_revolution();
  test_flat_torus();
  test_coarse_surfaces();
  test_scaling();
  test_real_surfaces();
  return Quartic_test::result();
}
