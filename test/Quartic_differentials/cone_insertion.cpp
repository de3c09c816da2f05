// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points inserted very near an edge are where they were put, against distances in 50 digits.

#include "check.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/internal/cone_insertion.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>

using namespace CGAL::Quartic_differentials;

namespace {

using Many_digits = boost::multiprecision::cpp_bin_float_50;

// A place in the plane in which the source of a halfedge is at 0 and its target on the positive real axis.
struct Place { Many_digits x, y; };

// the third corner of face(h)
Place third_corner(const Intrinsic_triangulation& t, Halfedge h)
{
  const Many_digits e = t.length(h), after = t.length(t.next(h)), before = t.length(t.prev(h));
  return {twice_scalar_product(after, e, before) / (2 * e), four_times_area(e, after, before) / (2 * e)};
}

// The distance of the point with coordinates b, from source(h) on, in face(h) from the third corner of the face across h.
Many_digits distance_across(const Intrinsic_triangulation& t, Halfedge h, const std::array<double, 3>& b)
{
  const Place own = third_corner(t, h), other = third_corner(t, t.opposite(h));
  const Many_digits e = t.length(h), sum = Many_digits(b[0]) + b[1] + b[2];
  const Many_digits x = (b[1] * e + b[2] * own.x) / sum, y = b[2] * own.y / sum;
  const Many_digits dx = e - other.x - x, dy = -other.y - y;
  return sqrt(dx * dx + dy * dy);
}

// the edge between two vertices, or none
Edge edge_between(const Intrinsic_triangulation& t, Vertex v, Vertex w)
{
  Halfedge h = t.halfedge_from(v);
  const Halfedge end = h;
  do {
    if (t.target(h) == w) return t.edge(h);
    h = t.next_around_source(h);
  } while (h != end);
  return Edge();
}

// Relative errors of the edge that leads from a point near an edge to the other side: as it is, and from lengths alone.
struct Errors { double flipped = 0, from_lengths = 0; };

// Inserts a point near the edge h.
Errors errors_of_distance(const Intrinsic_triangulation& t, Halfedge h, double along, double from_edge)
{
  const int k = t.corner(h);
  const std::array<double, 3> b{(1 - along) * (1 - from_edge), along * (1 - from_edge), from_edge};   // from source(h) on
  Surface_point p{t.face(h)};
  for (int c = 0; c < 3; ++c) p.barycentric[(k + c) % 3] = b[c];
  internal::Point_inserter inserter(t);
  const Vertex v = inserter.insert(p).insertion.vertex;
  Intrinsic_triangulation flipped = inserter.triangulation();
  internal::make_delaunay_by_places(flipped, inserter.places());
  CHECK_EQUAL(structural_defect(flipped), "");
  const Edge across = edge_between(flipped, v, t.target(t.next(t.opposite(h))));
  CHECK(across.is_valid());
  const Many_digits distance = distance_across(t, h, b);
  const auto error = [&](double length) { return std::abs(static_cast<double>(length / distance - 1)); };
  return {error(flipped.length(across)), error(internal::other_diagonal(inserter.triangulation(), h, euclidean_diagonal<double>))};
}

} // namespace

int main()
{
  Intrinsic_triangulation t(Quartic_test::jittered_torus(40, 20, 0.3, 0.5, 2));
  make_delaunay(t);   // what is flipped then is flipped because of the point
  std::mt19937 random(5);
  for (double from_edge : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    Errors worst;
    for (int n = 0; n < 200; ++n) {
      const Halfedge h(static_cast<Mesh::size_type>(random() % t.number_of_halfedges()));
      const Errors e = errors_of_distance(t, h, Quartic_test::uniform(random, 0.2, 0.8), from_edge);
      worst = {std::max(worst.flipped, e.flipped), std::max(worst.from_lengths, e.from_lengths)};
    }
    std::cout << "at " << from_edge << " from an edge: relative error " << worst.flipped << ", from lengths "
              << worst.from_lengths << std::endl;
    CHECK(worst.flipped < 1e-14);
    CHECK(from_edge > 1e-3 || worst.from_lengths > 100 * worst.flipped);   // what the places are for
  }
  return Quartic_test::result();
}
