// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Integer lengths of the arcs of T-meshes: against exhaustive search on small ones, unit grids that cost nothing,
// surfaces from the whole pipeline at targets from coarse to fine, every method, damage.

#include "check.h"
#include "exact_charts.h"
#include "run_pipeline.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Length_program.h>
#include <CGAL/Quartic_differentials/internal/zero_complex.h>
#include <CGAL/Quartic_differentials/quantize.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

Visitor quiet;

const Quantization_method methods[] = {Quantization_method::optimal, Quantization_method::incumbent,
                                       Quantization_method::even};

double cost_of(const T_mesh& t, double scale, const std::vector<int>& q)
{
  double sum = 0;
  for (std::size_t a = 0; a < q.size(); ++a) sum += std::pow(q[a] - scale * static_cast<double>(t.arcs[a].length), 2);
  return sum;
}

std::size_t number_of_quads(const T_mesh& t, const std::vector<int>& q)
{
  std::size_t sum = 0;
  for (const T_mesh::Patch& patch : t.patches) {
    std::size_t width = 0, height = 0;
    for (const T_mesh::Side_piece& s : patch.sides[2]) width += q[s.arc];
    for (const T_mesh::Side_piece& s : patch.sides[3]) height += q[s.arc];
    sum += width * height;
  }
  return sum;
}

/// what holds for every result
void check_quantization(const T_mesh& t, const Quantization& q)
{
  CHECK_EQUAL(quantization_defect(t, q.length), "");
  CHECK_EQUAL(number_of_quads(t, q.length), q.number_of_quads);
  const double cost = cost_of(t, q.scale, q.length), rounding = 1e-5 * (1 + cost);
  CHECK_NEAR(cost, q.cost, rounding);
  CHECK(q.lower_bound <= cost + rounding);
  CHECK_EQUAL(q.optimal, cost <= q.lower_bound + 1e-6 * (1 + cost));
  const double miss = std::abs(double(q.number_of_quads) - double(q.target));
  CHECK_EQUAL(q.shortfall.empty(), miss <= 0.05 * double(q.target));
}

/// A surface of unit squares of `side` grid units, without poles of order -3.
Quartic_differential square_tiled(int most_squares, int subdivision, std::int64_t side, std::mt19937& random)
{
  for (;;) {
    const Gluing glued = random_gluing(1 + static_cast<int>(random() % most_squares), random);
    if (!is_connected(glued)) continue;
    Quartic_differential q = exact_differential(subdivided(glued, subdivision), {side, 0}, {0, side});
    if (*std::min_element(q.order.begin(), q.order.end()) <= -3) continue;
    if (q.singularities.empty()) q.singularities.push_back(Vertex(0));
    return q;
  }
}

/// options for quads with sides of so many grid units of the quartic differential
Quantization_options side_of(double grid_units, const Quartic_differential& q)
{
  Quantization_options options;
  options.edge_length = std::ldexp(grid_units, -q.grid_exponent);
  options.surface_units_per_unit = q.surface_units_per_unit;
  return options;
}

// A surface of unit squares is its own quantization: all deviations are 0.
void unit_grids()
{
  std::mt19937 random(1);
  std::set<int> genera;
  for (int done = 0; done < 60; ++done) {
    const std::int64_t side = 1 + random() % 50;
    const Quartic_differential q = square_tiled(12, 4, side, random);
    const T_mesh t = t_mesh(q, quiet);
    const Quantization r = quantize(t, side_of(double(side), q), quiet);
    check_quantization(t, r);
    CHECK_EQUAL(r.number_of_quads, q.triangulation.number_of_faces() / 2);
    CHECK_EQUAL(r.target, r.number_of_quads);
    CHECK_NEAR(r.cost, 0, 1e-12);
    CHECK(r.optimal);
    for (std::size_t a = 0; a < t.arcs.size(); ++a) CHECK_EQUAL(2 * side * r.length[a], t.arcs[a].length);
    // twice as fine, all lengths are breakpoints of the linear program
    Quantization_options even = side_of(double(side) / 2, q);
    even.method = Quantization_method::even;
    const Quantization e = quantize(t, even, quiet);
    check_quantization(t, e);
    CHECK_NEAR(e.cost, 0, 1e-12);
    genera.insert(q.triangulation.genus());
  }
  CHECK(genera.size() > 5);
}

/// calls f for every q <= most with equal opposite sides
void for_all(const T_mesh& t, int most, const std::function<void(const std::vector<int>&)>& f)
{
  std::vector<int> q(t.arcs.size(), 0);
  for (;;) {
    const auto balanced = [&](const T_mesh::Patch& patch) {
      long sum[4] = {0, 0, 0, 0};
      for (int k = 0; k < 4; ++k)
        for (const T_mesh::Side_piece& s : patch.sides[k]) sum[k] += q[s.arc];
      return sum[0] == sum[2] && sum[1] == sum[3];
    };
    if (std::all_of(t.patches.begin(), t.patches.end(), balanced)) f(q);
    std::size_t a = 0;
    while (a < q.size() && q[a] == most) q[a++] = 0;
    if (a == q.size()) return;
    ++q[a];
  }
}

/// A surface whose T-mesh has few arcs: of squares, or a torus of parallelograms with one or two marked points.
Quartic_differential small_surface(bool of_squares, std::mt19937& random)
{
  for (;;) {
    if (of_squares) {
      const Quartic_differential q = square_tiled(8, 1, 1 + random() % 50, random);
      const std::size_t arcs = t_mesh(q, quiet).arcs.size();
      if (4 <= arcs && arcs <= 14) return q;
      continue;
    }
    const int squares = 1 + static_cast<int>(random() % 3);
    const Gluing glued = random_translation_gluing(squares, random);
    if (!is_connected(glued)) continue;
    const auto below = [&](int n) { return static_cast<std::int64_t>(random() % n); };
    const Grid_vector u{10 + below(90), below(9)}, v{below(9), 10 + below(90)};
    Quartic_differential q = exact_differential(glued, u, v);
    if (q.triangulation.genus() != 1) continue;
    const std::size_t marks = 1 + random() % 2;
    for (Vertex v : q.triangulation.vertices())
      if (q.singularities.size() < marks) q.singularities.push_back(v);
    return q;
  }
}

/// The same with boundary: of squares, or of parallelograms with horizontal boundary and one or two marked points.
Quartic_differential small_surface_with_boundary(bool of_squares, std::mt19937& random)
{
  for (;;) {
    const int squares = 1 + static_cast<int>(random() % (of_squares ? 6 : 4));
    Gluing glued = of_squares ? random_gluing(squares, random) : random_translation_gluing(squares, random);
    if (cut_open(glued, uniform(random, 0, 0.6), !of_squares, random) == 0 || !is_connected(glued)) continue;
    const auto below = [&](int n) { return static_cast<std::int64_t>(random() % n); };
    const std::int64_t side = 10 + below(90);
    const Grid_vector v = of_squares ? Grid_vector{0, side} : Grid_vector{below(9), 10 + below(90)};
    Quartic_differential q = exact_differential(glued, {side, 0}, v);
    if (*std::min_element(q.order.begin(), q.order.end()) <= -3) continue;
    const std::size_t marks = q.singularities.size() + (of_squares ? 0 : 1 + random() % 2);
    for (Vertex v : q.triangulation.vertices())
      if (q.singularities.size() < marks && q.order[v] == 0) q.singularities.push_back(v);
    const std::size_t arcs = t_mesh(q, quiet).arcs.size();
    if (4 <= arcs && arcs <= 14) return q;
  }
}

/// in the differential's grid units
double mean_length(const T_mesh& t)
{
  double sum = 0;
  for (const T_mesh::Arc& arc : t.arcs) sum += static_cast<double>(arc.length) / 2;
  return sum / double(t.arcs.size());
}

// The program alone, for lengths that have nothing to do with each other: its bound is the cost, so that no chord is
// used beyond its end, and no other solution nearby is cheaper. The linear program has an integral solution.
void programs()
{
  std::mt19937 random(6);
  std::size_t neighbours = 0;
  for (int done = 0; done < 40; ++done) {
    const T_mesh t = t_mesh(small_surface(done % 2 == 0, random), quiet);
    std::vector<double> x;
    for (std::size_t a = 0; a < t.arcs.size(); ++a) x.push_back(uniform(random, 0, done % 3 == 0 ? 1 : 40));
    const auto cost = [&](const std::vector<int>& q) {
      double sum = 0;
      for (std::size_t a = 0; a < q.size(); ++a) sum += std::pow(q[a] - x[a], 2);
      return sum;
    };
    std::size_t nodes = 100000;
    const auto solution = internal::Length_program(t, x, 1).solve(600, nodes);
    CHECK(solution.has_value());
    if (!solution) continue;
    const double least = cost(solution->q);
    CHECK_NEAR(solution->bound, least, 1e-9 * (1 + least));
    for_all(t, 1, [&](const std::vector<int>& step) {
      for (int sign : {-1, 1}) {
        std::vector<int> q = solution->q;
        for (std::size_t a = 0; a < q.size(); ++a) q[a] += sign * step[a];
        if (*std::min_element(q.begin(), q.end()) < 0) continue;
        CHECK(cost(q) >= least - 1e-9 * (1 + least));
        ++neighbours;
      }
    });
    const auto even = internal::Length_program(t, x, 2).solve(600, nodes);
    CHECK(even.has_value() && cost(even->q) >= least - 1e-9 * (1 + least));
  }
  CHECK(neighbours > 1000);
}

// Every quantization of small T-meshes: the criterion on the zero complex agrees with the surface that is glued, cuts
// that are said to be valid are, and the solver finds nothing cheaper and claims no more than there is.
// \param least_others of cuts that are not said to be valid: with a boundary there is hardly ever no other
void exhaustive_search(const std::string& name, int cases, std::size_t least_others,
                       const std::function<Quartic_differential(int)>& surface)
{
  std::map<std::string, std::size_t> violations;   // by how they begin
  std::size_t valid = 0, broken = 0, valid_cuts = 0, other_cuts = 0, optimal = 0, cheapest = 0, runs = 0;
  for (int done = 0; done < cases; ++done) {
    const Quartic_differential differential = surface(done);
    const T_mesh t = t_mesh(differential, quiet);
    int most = 1;
    while (std::pow(most + 2, t.arcs.size()) < 4e4) ++most;
    std::vector<std::vector<int>> good;
    std::set<std::vector<std::size_t>> cuts;
    for_all(t, most, [&](const std::vector<int>& q) {
      const auto found = internal::separating_cuts(t, q);
      const std::string violation = quantization_defect(t, q);
      CHECK_EQUAL(found.empty(), violation.empty());
      (violation.empty() ? valid : broken) += 1;
      if (violation.empty()) good.push_back(q);
      else ++violations[violation.substr(0, 8)];
      for (const internal::Separating_cut& cut : found) {
        (cut.is_valid ? valid_cuts : other_cuts) += 1;
        if (cut.is_valid) cuts.insert(cut.arcs);
        int sum = 0;
        for (std::size_t a : cut.arcs) sum += q[a];
        CHECK_EQUAL(sum, 0);
      }
    });
    for (const auto& cut : cuts)
      for (const std::vector<int>& q : good)
        CHECK(std::any_of(cut.begin(), cut.end(), [&](std::size_t a) { return q[a] > 0; }));
    for (double quads_an_arc : {0.1, 0.5, 0.8, 1.2, 2.0}) {
      const Quantization r = quantize(t, side_of(mean_length(t) / quads_an_arc, differential), quiet);
      check_quantization(t, r);
      ++runs;
      optimal += r.optimal;
      double least = std::numeric_limits<double>::infinity();
      for (const std::vector<int>& q : good) least = std::min(least, cost_of(t, r.scale, q));
      CHECK(r.lower_bound <= least + 1e-6);
      if (*std::max_element(r.length.begin(), r.length.end()) > most) continue;
      CHECK(r.cost >= least - 1e-6);
      cheapest += r.cost <= least + 1e-6;
    }
  }
  std::cout << "exhaustive search, " << name << ": " << valid << " quantizations and " << broken << " that are none, "
            << valid_cuts << " valid cuts and " << other_cuts << " others; of " << runs << " results " << cheapest
            << " are the cheapest of the small ones, " << optimal << " proved optimal\n";
  CHECK(valid > 1000 && broken > 1000 && valid_cuts > 1000 && other_cuts >= least_others);
  CHECK(optimal > 20 && cheapest > 20);
  for (const char* kind : {"an edge ", "a vertex", "the sing", "parts of"}) CHECK(violations[kind] > 0);
}

// A room with two necks that overlap, one under its ceiling and one on its floor, and a trace that runs between them. If
// both have height 0, no path of arcs joins ceiling and floor, but chords do, from points inside arcs of the boundary.
void overlapping_necks()
{
  std::map<std::pair<int, int>, int> square;   // by lower left corner
  std::vector<std::pair<int, int>> corner;
  for (int x = 0; x < 8; ++x)
    for (int y = 3 <= x && x < 5 ? -5 : -6; y < (x == 0 ? 0 : 2 <= x && x < 4 ? 5 : 6); ++y) {
      square[{x, y}] = static_cast<int>(corner.size());
      corner.emplace_back(x, y);
    }
  Gluing glued(4 * corner.size(), -1);
  for (std::size_t s = 0; s < corner.size(); ++s) {
    const auto [x, y] = corner[s];
    const std::pair<int, int> beside[] = {{x, y - 1}, {x + 1, y}, {x, y + 1}, {x - 1, y}};
    for (int k = 0; k < 4; ++k)
      if (square.count(beside[k]) > 0) glued[4 * s + k] = 4 * square[beside[k]] + (k + 2) % 4;
  }
  const std::int64_t side = 16;
  const T_mesh t = t_mesh(exact_differential(glued, {side, 0}, {0, side}), quiet);
  const auto lengths = [&](const std::map<std::int64_t, int>& new_x, const std::map<std::int64_t, int>& new_y) {
    const auto place = [&](std::size_t n) {
      const auto [x, y] = corner[t.nodes[n].face.idx() / 2];
      const Grid_vector z = t.nodes[n].point;   // the grid's coordinates are doubled
      return std::make_pair(new_x.at(x + z.x / (2 * side)), new_y.at(y + z.y / (2 * side)));
    };
    std::vector<int> q;
    for (const T_mesh::Arc& arc : t.arcs) {
      const auto [x, y] = place(arc.from);
      const auto [u, v] = place(arc.to);
      q.push_back(std::abs(u - x) + std::abs(v - y));
    }
    return q;
  };
  const std::map<std::int64_t, int> columns{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {8, 6}};
  const std::vector<int> one = lengths(columns, {{-6, -1}, {-5, 0}, {0, 0}, {5, 1}, {6, 2}});
  CHECK_EQUAL(quantization_defect(t, one), "");
  CHECK(internal::separating_cuts(t, one).empty());
  const std::vector<int> none = lengths(columns, {{-6, -1}, {-5, 0}, {0, 0}, {5, 0}, {6, 1}});
  CHECK(!quantization_defect(t, none).empty());
  const std::vector<internal::Separating_cut> cuts = internal::separating_cuts(t, none);
  CHECK(!cuts.empty());
  for (const internal::Separating_cut& cut : cuts) CHECK(!cut.is_valid);
}

// Coarse quads on surfaces with many singularities close together, by every method.
void coarse_square_tiled_surfaces()
{
  std::mt19937 random(3);
  std::size_t with_zeros = 0, with_cuts = 0;
  for (int done = 0; done < 60; ++done) {
    const Quartic_differential q = square_tiled(20, 1, 64, random);
    const T_mesh t = t_mesh(q, quiet);
    Quantization_options options = side_of(64 / uniform(random, 0.1, 1.3), q);
    for (Quantization_method method : methods) {
      options.method = method;
      const Quantization r = quantize(t, options, quiet);
      check_quantization(t, r);
      with_zeros += std::count(r.length.begin(), r.length.end(), 0) > 0;
      with_cuts += r.cuts > 0;
      CHECK(r.method == method);
    }
  }
  CHECK(with_zeros > 20);
  CHECK(with_cuts > 60);
}

std::size_t out_of_nodes = 0;   // results of the fallback

// Surfaces from the whole pipeline, down to the coarsest quads.
void check_sample(const std::string& name, Mesh mesh)
{
  const Quartic_differential_result r = run_pipeline(Intrinsic_triangulation(std::move(mesh)));
  CHECK(r.t_mesh.has_value());
  if (!r.t_mesh) return;
  const T_mesh& t = *r.t_mesh;
  Quantization_options options;
  std::size_t coarsest = 0;
  for (std::size_t target : {1, 100, 500, 2000, 5000, 20000}) {
    options.number_of_quads = target;
    const Quantization q = quantize(t, options, quiet);
    check_quantization(t, q);
    CHECK_EQUAL(q.target, target);
    if (target == 1) {
      coarsest = q.number_of_quads;
      CHECK(!q.shortfall.empty());
    }
    CHECK(4 * q.number_of_quads >= 3 * coarsest);
    if (target >= 2000) {
      CHECK_EQUAL(q.shortfall, "");
      CHECK(q.optimal);
    }
    std::cout << name << ": " << target << " quads asked for, " << q.number_of_quads << " reached, " << q.scales
              << " scales, " << q.solves << " programs, " << q.cuts << " cuts, "
              << (q.optimal ? "optimal" : "not proved") << ", " << q.seconds << " s\n";
  }
  // an edge length in the surface's units
  options.surface_units_per_unit = r.traced().surface_units_per_unit;
  options.edge_length = std::sqrt(r.traced().triangulation.area() / 3000);
  const Quantization q = quantize(t, options, quiet);
  check_quantization(t, q);
  CHECK_NEAR(double(q.target), 3000, 0.02 * 3000);
  // a length that no quads can have: singularities are nearer to each other
  options.edge_length *= 1000;
  const Quantization huge = quantize(t, options, quiet);
  check_quantization(t, huge);
  CHECK(huge.shortfall.find("nearest to the edge length") != std::string::npos);
  // the methods that need no luck
  options = {};
  options.number_of_quads = 4000;
  for (Quantization_method method : methods) {
    options.method = method;
    const Quantization m = quantize(t, options, quiet);
    check_quantization(t, m);
    CHECK(m.method == method);
  }
  // the same again, also where the work is limited
  options = {};
  options.number_of_quads = 50;
  options.node_limit = 10;
  const Quantization limited = quantize(t, options, quiet);
  check_quantization(t, limited);
  CHECK(limited.length == quantize(t, options, quiet).length);
  // and where no search is allowed
  options.node_limit = 0;
  for (std::size_t target : {30, 60, 90, 120, 150, 180}) {
    options.number_of_quads = target;
    const Quantization without_search = quantize(t, options, quiet);
    check_quantization(t, without_search);
    out_of_nodes += without_search.method == Quantization_method::even;
  }
  // no time at all
  options = {};
  options.time_limit = 0;
  const Quantization late = quantize(t, options, quiet);
  check_quantization(t, late);
  CHECK(late.method == Quantization_method::even);
}

// A length that is off by one is found, and so is a surface that shrinks.
void damaged_quantizations()
{
  std::mt19937 random(4);
  for (int done = 0; done < 20; ++done) {
    const Quartic_differential q = square_tiled(12, 2, 8, random);
    const T_mesh t = t_mesh(q, quiet);
    const std::vector<int> good = quantize(t, side_of(8, q), quiet).length;
    CHECK_EQUAL(quantization_defect(t, good), "");
    for (std::size_t a = 0; a < good.size(); ++a)
      for (int change : {-1, 1}) {
        std::vector<int> bad = good;
        bad[a] += change;
        // an arc may be on both of two opposite sides of one patch, and on no other: then it has any length
        bool is_on_both = true;
        for (const T_mesh::Patch& patch : t.patches) {
          int sum[4] = {0, 0, 0, 0};
          for (int k = 0; k < 4; ++k)
            for (const T_mesh::Side_piece& s : patch.sides[k]) sum[k] += s.arc == a;
          is_on_both = is_on_both && sum[0] == sum[2] && sum[1] == sum[3];
        }
        if (!is_on_both) CHECK(!quantization_defect(t, bad).empty());
      }
    std::vector<int> twice = good;
    for (int& length : twice) length *= 2;
    CHECK_EQUAL(quantization_defect(t, twice), "");
    CHECK(!quantization_defect(t, std::vector<int>(good.size(), 0)).empty());
    CHECK(!quantization_defect(t, std::vector<int>(good.size() + 1, 1)).empty());
    twice.front() = -1;
    CHECK(!quantization_defect(t, twice).empty());
  }
}

class Impatient : public Visitor
{
public:
  bool go_further() override { return false; }
};

void refused_input()
{
  CHECK_THROWS(quantize({}, {}, quiet), Infeasible_divisor_error, "no T-mesh");
  // one square, neighbouring sides glued: two poles of order -3
  Quartic_differential q = exact_differential({1, 0, 3, 2}, {4, 0}, {0, 4});
  CHECK_THROWS(quantize(t_mesh(q, quiet), {}, quiet), Infeasible_divisor_error, "order -3");
  std::mt19937 random(5);
  const T_mesh t = t_mesh(square_tiled(6, 2, 8, random), quiet);
  Impatient impatient;
  CHECK_THROWS(quantize(t, {}, impatient), Cancelled_error, "cancelled");
}

} // namespace

int main()
{
  unit_grids();
  programs();
  std::mt19937 random(2);
  exhaustive_search("closed", 80, 101, [&](int n) { return small_surface(n % 2 == 0, random); });
  exhaustive_search("with boundary", 160, 0, [&](int n) { return small_surface_with_boundary(n % 2 == 0, random); });
  overlapping_necks();
  coarse_square_tiled_surfaces();
  check_sample("sphere", bumpy_sphere(3));
  check_sample("torus", jittered_torus(40, 20, 0.3, 0.5, 2));
  check_sample("genus 2", handle_chain(2, 8));
  check_sample("genus 3", handle_ring(3, 8));
  std::cout << out_of_nodes << " of 24 coarse quantizations are even where no search is allowed\n";
  CHECK(out_of_nodes > 0);
  damaged_quantizations();
  refused_input();
  return result();
}
