// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flat metrics in number types of more digits: their errors, measured again by other formulas in twice as many digits;
// every number of bits the pipeline offers; and the retry where doubles are not enough.

#include "check.h"
#include "named_surfaces.h"
#include "run_pipeline.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/arbitrary_precision.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/precise_cone_metric.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>
#include <CGAL/Quartic_differentials/spoiled_surfaces.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <iostream>

using namespace CGAL::Quartic_differentials;
using Quartic_test::run_pipeline;
namespace mp = boost::multiprecision;
using Digits_50  = mp::number<mp::cpp_bin_float_50::backend_type, mp::et_off>;
using Digits_100 = mp::number<mp::cpp_bin_float_100::backend_type, mp::et_off>;

namespace {

// The largest curvature error of a flat metric, by the law of cosines.
Digits_100 curvature_error(const Intrinsic_triangulation& t, const std::vector<Digits_50>& lengths,
                           const std::vector<int>& order)
{
  const Digits_100 pi = half_turn<Digits_100>();
  std::vector<Digits_100> excess;
  for (Vertex v : t.vertices()) excess.push_back(-(order[v] + 4) * pi / 2);   // of the angles over the cone's
  for (Halfedge h : t.halfedges()) {
    const Digits_100 a(lengths[t.edge(h)]), b(lengths[t.edge(t.prev(h))]), c(lengths[t.edge(t.next(h))]);
    excess[t.source(h)] += acos(Digits_100((a * a + b * b - c * c) / (2 * a * b)));
  }
  return internal::largest(excess);
}

// In a number type of the test's own; nothing of the pipeline but its double results is used.
void test_number_type(const Quartic_test::Named_surface& s)
{
  const Quartic_differential_result r = run_pipeline(s.surface);
  Visitor visitor;
  const Cone_metric& metric = r.metric->metric;
  const Refined_cone_metric& refined = *r.refined_metric;
  const auto m = precise_cone_metric<Digits_50>(s.surface, metric, refined, Digits_50(1e-40), visitor);
  const Digits_100 again = curvature_error(refined.triangulation, m.lengths, metric.order);
  std::cout << s.name << ": error " << m.history.front() << " -> " << m.history.back() << " in " << m.history.size() - 1
            << " steps, transitions " << m.max_transition_error << ", by cosines " << again << std::endl;
  CHECK(m.reached);
  CHECK(m.history.back() < 1e-40);
  CHECK(m.max_transition_error < 1e-40);
  CHECK(again < 1e-40);
  CHECK(m.history.size() <= 7);
  // the metric is the same one, but for the rounding of doubles
  for (Edge e : refined.triangulation.edges())
    CHECK_NEAR(static_cast<double>(m.lengths[e]) / refined.lengths[e], 1, 1e-6);
  CHECK(m.moved.size() == 0 || m.moved.lpNorm<Eigen::Infinity>() < 1e-6 * std::sqrt(s.surface.area()));
}

// The figures that are promised, on real meshes.
void test_real(const Quartic_test::Named_surface& s)
{
  Quartic_differential_options options;
  options.precision = 128;
  const Quartic_differential_result r = run_pipeline(s.surface, options);
  std::cout << s.name << ": curvature " << r.precision->max_curvature_error << ", holonomy "
            << r.precision->max_holonomy_error << ", transitions " << r.precision->max_transition_error << std::endl;
  CHECK(r.precision->max_curvature_error < 1e-30);
  CHECK(r.precision->max_holonomy_error < 1e-30);
  CHECK(r.precision->max_transition_error < 1e-30);
  CHECK_EQUAL(defect(r.refined->differential), "");
}

// A cone that may not move does not, and the others make up for it.
void test_pinned()
{
  const Intrinsic_triangulation input(handle_chain(2, 6));
  Divisor divisor = run_pipeline(input).singularities;
  divisor[0].pinned = divisor[3].pinned = true;
  Quartic_differential_options options;
  options.precision = 128;
  Visitor visitor;
  Quartic_differential_result r;
  quartic_differential(input, divisor, options, visitor, r);
  CHECK(r.precision->max_curvature_error < 1e-30);
  CHECK(r.precision->max_transition_error < 1e-30);
  CHECK_EQUAL(r.metric->moved_by[0], 0.0);
  CHECK_EQUAL(r.metric->moved_by[3], 0.0);
}

// What cannot be done is said: cones that may not move cannot correct the holonomy, and 50 digits do not reach 1e-60.
void test_out_of_reach()
{
  const Intrinsic_triangulation input(handle_chain(2, 6));
  const Quartic_differential_result r = run_pipeline(input);
  const Cone_metric& metric = r.metric->metric;
  Visitor visitor;
  Divisor pinned = r.singularities;
  for (Singularity& s : pinned) s.pinned = true;
  const Integer_cochains cochains = cochains_of_loops(r.surface->homology, input.number_of_edges());
  const Refined_cone_metric refined = refined_cone_metric(input, cochains, pinned, metric);
  CHECK_THROWS(precise_cone_metric<Digits_50>(input, metric, refined, Digits_50(1e-40), visitor), Numerical_error,
               "cannot make the holonomy exact");
  const auto m = precise_cone_metric<Digits_50>(input, metric, *r.refined_metric, Digits_50(1e-60), visitor);
  CHECK(!m.reached);
  CHECK(m.history.back() < 1e-40);
}

void test_bits(const Intrinsic_triangulation& input)
{
  const Quartic_differential_result with_doubles = run_pipeline(input);
  CHECK_EQUAL(with_doubles.precision->bits, 53);
  CHECK(with_doubles.precision->max_curvature_error < 1e-10);
  for (int bits : {64, 100, 256, 1024}) {
    Quartic_differential_options options;
    options.precision = bits;
    const Quartic_differential_result r = run_pipeline(input, options);
    std::cout << bits << " bits: curvature " << r.precision->max_curvature_error << ", holonomy "
              << r.precision->max_holonomy_error << ", layout gap " << r.immersion.layout_gap << std::endl;
    CHECK_EQUAL(r.precision->bits, bits);
    CHECK_EQUAL(r.precision->reason, "");
    CHECK(r.precision->max_curvature_error <= precision_tolerance(bits));
    CHECK(r.precision->max_holonomy_error <= precision_tolerance(bits));
    CHECK(r.precision->max_transition_error <= precision_tolerance(bits));
    CHECK(r.immersion.layout_gap < 1e-15);   // the rounding of the result to doubles
    CHECK_EQUAL(defect(*r.differential), "");
    CHECK_EQUAL(r.t_mesh->patches.size(), with_doubles.t_mesh->patches.size());
  }
}

// Doubles are not enough for needles: the pipeline says so and goes on with more digits.
struct Listener : Visitor
{
  std::string heard;
  void progress(const std::string& message) override { heard += message + '\n'; }
};

void test_retry()
{
  const Intrinsic_triangulation input(stretched(handle_chain(2, 6), 100));
  Listener listener;
  Quartic_differential_result r;
  quartic_differential(input, std::nullopt, {}, listener, r);
  std::cout << "stretched 100:1: " << r.precision->reason << "; with " << r.precision->bits << " bits "
            << r.precision->max_curvature_error << std::endl;
  CHECK(r.refined_metric->precision.max_curvature_error > 1e-9);
  CHECK_EQUAL(r.precision->bits, 128);
  CHECK(r.precision->reason.find("too thin") != std::string::npos);
  CHECK(listener.heard.find("double precision is not enough") != std::string::npos);
  CHECK(r.precision->max_curvature_error < 1e-30);
  CHECK_EQUAL(defect(r.refined->differential), "");
}

// The visitor's word counts here too.
struct Impatient : Visitor
{
  bool impatient = false;
  void step_begins(const std::string& name) override { impatient = name == "immersion"; }
  bool go_further() override { return !impatient; }
};

void test_cancel()
{
  Quartic_differential_options options;
  options.precision = 256;
  Impatient visitor;
  Quartic_differential_result r;
  CHECK_THROWS(quartic_differential(Intrinsic_triangulation(handle_chain(1, 6)), std::nullopt, options, visitor, r),
               Cancelled_error, "more precise");
  CHECK(r.metric.has_value() && !r.differential.has_value());
}

} // namespace

int main()
{
  test_number_type({"jittered sphere", Intrinsic_triangulation(Quartic_test::jittered_sphere(3, 0.3, 1.5, 1))});
  test_number_type({"chain of genus 2", Intrinsic_triangulation(handle_chain(2, 6))});
  test_number_type({"hyperelliptic curve of genus 4", Intrinsic_triangulation(hyperelliptic(4, 2))});
  for (const auto& s : Quartic_test::real_surfaces({"sculpt_7k3", "3holes_7k2", "rockerarm_20k"})) test_real(s);
  test_bits(Intrinsic_triangulation(handle_chain(2, 6)));
  test_pinned();
  test_out_of_reach();
  test_retry();
  test_cancel();
  return Quartic_test::result();
}
