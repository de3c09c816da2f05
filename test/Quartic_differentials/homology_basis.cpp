// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Intersection numbers are integers, computed in three ways, and no flip or insertion changes them.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/homology_basis.h>

#include <Eigen/Dense>

using namespace CGAL::Quartic_differentials;

namespace {

bool is_closed(const Intrinsic_triangulation& t, const Integer_cochains& eta)
{
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    if (!(eta.row(h[0]) + eta.row(h[1]) + eta.row(h[2])).isZero()) return false;
  }
  return true;
}

bool is_closed_walk(const Intrinsic_triangulation& t, const std::vector<Halfedge>& loop)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (t.face(t.opposite(loop[i])) != t.face(loop[(i + 1) % loop.size()])) return false;
  return !loop.empty();
}

void test(const Quartic_test::Named_surface& named)
{
  std::cout << named.name << std::endl;
  Intrinsic_triangulation t = named.surface;
  const int g = t.genus();
  Homology_basis basis = homology_basis(t);
  CHECK_EQUAL(static_cast<int>(basis.loops.size()), 2 * g);
  for (const auto& loop : basis.loops) CHECK(is_closed_walk(t, loop));
  CHECK(is_closed(t, basis.cochains));
  CHECK_EQUAL(basis.intersection_matrix, symplectic_unit(g));
  CHECK_EQUAL(intersection_numbers(t, basis.cochains), symplectic_unit(g));   // by the wedge product
  CHECK_NEAR(std::abs(basis.combination.cast<double>().determinant()), 1, 1e-6);

  const Homology_basis again = homology_basis(named.surface);
  CHECK_EQUAL(again.combination, basis.combination);   // deterministic
  CHECK_EQUAL(again.cochains.values(), basis.cochains.values());

  // flips
  make_delaunay(t, basis.cochains);
  CHECK_EQUAL(structural_defect(t), "");
  CHECK(is_closed(t, basis.cochains));
  CHECK_EQUAL(intersection_numbers(t, basis.cochains), symplectic_unit(g));
  // insertions
  for (int k = 0; k < 10; ++k) {
    const Face f(static_cast<Mesh::size_type>(k * 97 % t.number_of_faces()));
    basis.cochains.after_insertion(t, t.insert({f, {0.2, 0.3, 0.5}}));
  }
  CHECK_EQUAL(structural_defect(t), "");
  CHECK(is_closed(t, basis.cochains));
  CHECK_EQUAL(intersection_numbers(t, basis.cochains), symplectic_unit(g));
  CHECK_NEAR(t.area() / named.surface.area(), 1, 1e-12);
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test(s);
  for (int g : {1, 2, 3}) test({"polygons of genus " + std::to_string(g), Intrinsic_triangulation(hyperelliptic(g, 0))});
  for (const auto& s : Quartic_test::real_surfaces({"spot_5k8", "3holes_7k2", "buddha_20k", "casting_10k"})) test(s);
  return Quartic_test::result();
}
