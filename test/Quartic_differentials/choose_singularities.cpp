// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Singularities chosen for a wanted distortion or a count: few, legal, deterministic, and those that are given stay.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/choose_singularities.h>
#include <CGAL/Quartic_differentials/cone_metric.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/Singularity_search.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace CGAL::Quartic_differentials;

namespace {

struct Setting
{
  explicit Setting(const Intrinsic_triangulation& input)
    : surface(riemann_surface(input, visitor)), map(surface.delaunay, surface.homology.cochains, surface.forms),
      distortion(surface.delaunay, surface.laplacian, vertex_areas(surface.delaunay)) {}

  Chosen_singularities chosen(const Singularity_choice_options& options = {}, const Divisor& given = {})
  { return choose_singularities(surface, given, options, {}, {}, visitor); }
  double energy(const Divisor& d) const { return distortion.energy(distortion.log_scale(d)); }
  Optimal_divisor optimal(const Divisor& d)
  { return minimize_distortion(distortion, map, surface.periods, d, {}, {}, visitor); }

  Visitor         visitor;
  Riemann_surface surface;
  Abel_jacobi_map map;
  Area_distortion distortion;
};

bool same(const Divisor& a, const Divisor& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Singularity& p, const Singularity& q) {
    return p.location.face == q.location.face && p.location.barycentric == q.location.barycentric && p.order == q.order;
  });
}

// The curvature extrema that used to be the default, legalized, are worse than what is chosen, at the same count.
void test_default(const Quartic_test::Named_surface& named)
{
  Setting s(named.surface);
  const int g = named.surface.genus();
  const Chosen_singularities c = s.chosen();
  std::cout << named.name << ": " << c.divisor.size() << " singularities, distortion " << c.distortion << ", "
            << c.solves << " solves" << std::endl;
  CHECK_EQUAL(degree(c.divisor), 8 * g - 8);
  CHECK_NEAR(c.distortion, s.energy(c.divisor), 1e-9);
  CHECK(c.distortion <= 0.012);
  for (const Singularity& p : c.divisor) CHECK(p.order == -1 || p.order == 1 || p.order == 2);
  const Optimal_divisor o = s.optimal(c.divisor);
  CHECK(o.history.front().distortion <= c.distortion * 1.001);   // legal already
  CHECK(o.legal.history.size() <= 3);
  CHECK(o.distortion <= c.distortion * 1.001);
  if (g <= 1) CHECK(same(c.divisor, s.chosen().divisor));   // deterministic
}

void test_counts()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 8))};
  Singularity_choice_options options;
  double before = 1e300;
  for (int count : {8, 12, 15, 20}) {
    options.count = count;
    const Chosen_singularities c = s.chosen(options);
    CHECK_EQUAL(c.divisor.size(), static_cast<std::size_t>(count + count % 2));   // parity
    CHECK_EQUAL(degree(c.divisor), 8);
    CHECK(c.distortion < before);
    before = c.distortion;
  }
  options.count = 7;
  CHECK_THROWS(s.chosen(options), Infeasible_divisor_error, "at least 8");
  Setting torus_setting{Intrinsic_triangulation(torus(1, 0.4, 40, 24))};
  options.count = 2;   // a zero and a pole that would have to coincide
  CHECK_THROWS(torus_setting.chosen(options), Infeasible_divisor_error, "coincide");
  options.count = 4000;
  CHECK_THROWS(torus_setting.chosen(options), Infeasible_divisor_error, "no room");
}

void test_starts()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 8))};
  for (Singularity_start start : {Singularity_start::pairs, Singularity_start::field, Singularity_start::curvature}) {
    Singularity_choice_options options;
    options.start = start;
    const Chosen_singularities c = s.chosen(options);
    CHECK_EQUAL(c.starts.size(), 1u);
    CHECK(c.distortion <= 0.012);
    CHECK(c.starts[0].distortion > c.distortion);
    CHECK(c.starts[0].area_scale_ratio > 1);
    options.count = 16;
    CHECK_EQUAL(s.chosen(options).divisor.size(), 16u);
  }
  CHECK_EQUAL(s.chosen().starts.size(), 2u);
  Singularity_choice_options no_field;
  no_field.field_limit = 0;
  CHECK_EQUAL(s.chosen(no_field).starts.size(), 1u);
}

void test_given()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 8))};
  const Intrinsic_triangulation& t = s.surface.delaunay;
  Divisor given{{{Face(50), {0.3, 0.3, 0.4}}, 2, true}, {{Face(500), {0.2, 0.5, 0.3}}, -2, false}};
  for (std::size_t coarse : {std::size_t(100000), t.number_of_vertices() / 2}) {
    Singularity_choice_options options;
    options.count = 20;
    options.coarse_vertices = coarse;
    options.explored_vertices = coarse / 2;
    const Chosen_singularities c = s.chosen(options, given);
    CHECK_EQUAL(c.divisor.size(), 20u);
    CHECK_EQUAL(degree(c.divisor), 8);
    CHECK(c.divisor[0].order == 2 && c.divisor[0].pinned && c.divisor[1].order == -2);
    CHECK(c.divisor[0].location.face == given[0].location.face);
    CHECK(c.divisor[0].location.barycentric == given[0].location.barycentric);
    const Optimal_divisor o = s.optimal(c.divisor);
    CHECK(o.legal.divisor[0].location.barycentric == given[0].location.barycentric);
  }
  Singularity_choice_options field;
  field.start = Singularity_start::field;
  CHECK_THROWS(s.chosen(field, given), Infeasible_divisor_error, "only be completed by pairs");
}

// Explored on one coarsening, chosen on another, polished on the surface: nearly as good as found on the surface itself.
void test_coarse()
{
  Setting s{Intrinsic_triangulation(handle_chain(3, 12))};
  Singularity_choice_options options;
  options.count = 24;
  const Chosen_singularities fine = s.chosen(options);
  options.coarse_vertices = s.surface.delaunay.number_of_vertices() / 2;
  options.explored_vertices = options.coarse_vertices / 2;
  const Chosen_singularities coarse = s.chosen(options);
  CHECK(coarse.searched_vertices <= options.coarse_vertices);
  const double polished = s.optimal(coarse.divisor).distortion;
  std::cout << "on the surface " << fine.distortion << ", on a coarsening " << coarse.distortion << ", polished "
            << polished << std::endl;
  CHECK(polished < 1.3 * fine.distortion);
  CHECK_NEAR(polished, coarse.distortion, 0.08 * coarse.distortion);
}

// What was explored on far too few vertices is no choice yet: the search goes on where it meets the wanted distortion.
void test_exploration_too_coarse()
{
  Setting s{Intrinsic_triangulation(handle_chain(3, 12))};
  Singularity_choice_options options;
  for (std::size_t explored : {40, 80, 200}) {
    options.explored_vertices = explored;
    const Chosen_singularities c = s.chosen(options);
    std::cout << "explored on " << explored << " vertices: " << c.divisor.size() << " singularities, distortion "
              << c.distortion << std::endl;
    CHECK(c.distortion <= 0.012);
    CHECK_EQUAL(c.searched_vertices, s.surface.delaunay.number_of_vertices());
    CHECK_NEAR(c.distortion, s.energy(c.divisor), 1e-9);
  }
}

void test_pareto()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 8))};
  Singularity_choice_options options;
  options.pareto = true;
  for (std::size_t explored : {options.explored_vertices, s.surface.delaunay.number_of_vertices() / 2}) {
    options.explored_vertices = explored;
    const Chosen_singularities c = s.chosen(options);
    CHECK(c.pareto.size() >= 5);
    for (std::size_t k = 1; k < c.pareto.size(); ++k) CHECK(c.pareto[k].count > c.pareto[k - 1].count);
    CHECK(c.pareto.front().distortion > c.pareto.back().distortion);
    CHECK(c.pareto.front().area_scale_ratio > c.pareto.back().area_scale_ratio);
  }
}

// The moves of the search, with singularities that met: an opposite pair annihilates, two zeros become one of order 2,
// two poles stay two poles unless poles of order 2 are allowed.
void test_meetings()
{
  Setting s{Intrinsic_triangulation(handle_chain(2, 8))};
  const double size = std::sqrt(s.surface.delaunay.area());
  Singularity_choice_options options;
  const Distortion_options descent;
  internal::Singularity_search search(s.distortion, s.map, 0, options, descent, s.visitor);
  const auto candidate = [&](const Divisor& d) {
    const Eigen::VectorXd u = s.distortion.log_scale(d);
    return internal::Singularity_search::Candidate{d, u, s.distortion.energy(u)};
  };
  options.count = 16;
  const Divisor base = s.chosen(options).divisor;
  const auto beside = [&](const Surface_point& p, double distance) {
    return s.map.moved(s.map.lift(p), std::polar(distance * size, 0.7)).location;
  };

  Divisor with_pair = base;
  with_pair.push_back({beside(base[0].location, 0.1), -1, false});
  with_pair.push_back({beside(with_pair.back().location, 0.005), +1, false});
  const auto annihilated = search.without_pair(candidate(with_pair));
  CHECK(annihilated && annihilated->count() == 16);
  CHECK(annihilated->energy <= s.energy(base) * 1.02);

  const auto merged_order = [&](int sign, int least_order) {
    options.least_order = least_order;
    Divisor d = base;   // the first of that sign gets a twin that it almost meets
    const auto first = std::find_if(base.begin(), base.end(), [&](const Singularity& p) { return p.order == sign; });
    CHECK(first != base.end());
    d.push_back({beside(first->location, 0.002), sign, false});
    const auto two = candidate(d);
    // the objective counts the guard of the two points
    auto c = two;
    c.energy += 0.1;
    const auto merged = search.merged(c);
    return std::make_pair(merged.count() - two.count(),
                          std::count_if(merged.divisor.begin(), merged.divisor.end(),
                                        [&](const Singularity& q) { return q.order == 2 * sign; }));
  };
  CHECK(merged_order(+1, -1) == std::make_pair(-1, std::ptrdiff_t(1)));
  CHECK(merged_order(-1, -1) == std::make_pair(0, std::ptrdiff_t(0)));
  CHECK(merged_order(-1, -2) == std::make_pair(-1, std::ptrdiff_t(1)));
}

} // namespace

int main()
{
  test_meetings();
  for (const auto& s : Quartic_test::sample_surfaces()) test_default(s);
  test_counts();
  test_starts();
  test_given();
  test_coarse();
  test_exploration_too_coarse();
  test_pareto();
  return Quartic_test::result();
}
