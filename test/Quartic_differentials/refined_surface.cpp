// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The quartic differential on the input's own surface: a subdivision of it, exact on the grid, with the same T-mesh.

#include "check.h"
#include "named_surfaces.h"
#include "run_pipeline.h"

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/spoiled_surfaces.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>

using namespace CGAL::Quartic_differentials;
using Quartic_test::run_pipeline;

namespace {

double distance_from_triangle_plane(const Point_3& p, const Point_3& a, const Point_3& b, const Point_3& c)
{
  const auto n = CGAL::cross_product(b - a, c - a);
  return std::abs((p - a) * n) / std::sqrt(n.squared_length());
}

// Every triangle lies in the face of the input it is said to lie in, and the triangles of a face fill its area.
// \param from_plane times sqrt(area); the planes of needles are uncertain themselves
void check_on_input(const Intrinsic_triangulation& input, const Refined_surface& r, double from_plane)
{
  const Intrinsic_triangulation& t = r.differential.triangulation;
  const double size = std::sqrt(input.area());
  std::vector<double> area(input.number_of_faces(), 0);
  double farthest = 0;
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f), k = input.halfedges(r.input_face[f]);
    area[r.input_face[f]] += four_times_area(t.length(h[0]), t.length(h[1]), t.length(h[2])) / 4;
    for (Halfedge g : h)
      farthest = std::max(farthest, distance_from_triangle_plane(
        t.mesh().point(t.source(g)), input.mesh().point(input.source(k[0])), input.mesh().point(input.source(k[1])),
        input.mesh().point(input.source(k[2]))));
  }
  CHECK(farthest < from_plane * size);
  for (Face f : input.faces()) {
    const auto h = input.halfedges(f);
    const double whole = four_times_area(input.length(h[0]), input.length(h[1]), input.length(h[2])) / 4;
    CHECK_NEAR(area[f], whole, 1e-9 * whole + 1e-12 * size * size);
  }
  for (Vertex v : input.vertices()) CHECK(t.mesh().point(v) == input.mesh().point(v));
}

// Points of the input go to the subdivision and to the plane, and come back; on a common edge two faces agree.
void check_point_maps(const Intrinsic_triangulation& input, const Refined_surface& r)
{
  std::mt19937 random(3);
  const double size = std::sqrt(input.area());
  double worst = 0;
  const auto distance = [&](const Surface_point& p, const Surface_point& q) {
    return std::sqrt(CGAL::squared_distance(position_on_input(input, p), position_on_input(input, q))) / size;
  };
  for (int trial = 0; trial < 500; ++trial) {
    const double a = Quartic_test::uniform(random, 0, 1), b = Quartic_test::uniform(random, 0, 1 - a);
    const Surface_point p{Face(static_cast<Mesh::size_type>(random() % input.number_of_faces())), {a, b, 1 - a - b}};
    const Surface_point q = r.from_input(p);
    CHECK(r.input_face[q.face] == p.face);
    worst = std::max({worst, distance(p, r.to_input(q)), distance(p, r.to_input(r.from_chart(q.face, r.differential.chart(q))))});
  }
  CHECK(worst < 1e-9);

  Mesh mesh = mesh_with_property_maps(r);   // add_property_map() finds what is there; CGAL 5 and 6 agree on its result
  const auto place = mesh.add_property_map<Vertex, Surface_point>("v:input_point").first;
  const auto texture = mesh.add_property_map<Halfedge, CGAL::Simple_cartesian<double>::Point_2>("h:texture").first;
  const auto order = mesh.add_property_map<Vertex, int>("v:singularity_order").first;
  const auto face = mesh.add_property_map<Face, Face>("f:input_face").first;
  int degree = 0;
  for (Vertex v : mesh.vertices()) {
    degree += order[v];
    CHECK_NEAR(std::sqrt(CGAL::squared_distance(position_on_input(input, place[v]), mesh.point(v))) / size, 0, 1e-9);
  }
  CHECK_EQUAL(degree, 8 * input.genus() - 8);
  for (Face f : mesh.faces()) CHECK(face[f] == r.input_face[f]);
  const double unit = std::ldexp(1.0, r.differential.grid_exponent);
  for (Halfedge h : mesh.halfedges()) {
    const Grid_vector z = r.differential.corner[mesh.next(h)];
    CHECK(texture[h].x() * unit == static_cast<double>(z.x) && texture[h].y() * unit == static_cast<double>(z.y));
  }
}

std::multiset<std::pair<std::int64_t, std::int64_t>> rectangles(const T_mesh& t)
{
  std::multiset<std::pair<std::int64_t, std::int64_t>> sizes;
  for (const T_mesh::Patch& p : t.patches) sizes.insert(std::minmax(p.width, p.height));
  return sizes;
}

void test(const Quartic_test::Named_surface& named, double most_faces, bool nasty = false)
{
  const Intrinsic_triangulation& input = named.surface;
  const Quartic_differential_result result = run_pipeline(input);
  const Refined_cone_metric& metric = *result.refined_metric;
  CHECK_EQUAL(metric.refinement.defect(metric.triangulation), "");
  CHECK(result.precision->max_curvature_error < 1e-9);
  CHECK(result.precision->max_transition_error < 1e-9);
  CHECK(metric.precision.max_curvature_error < (nasty ? 1e-6 : 1e-9));
  CHECK_EQUAL(result.refined.has_value(), input.is_embedded());
  if (!result.refined) return;

  const Refined_surface& refined = *result.refined;
  const Intrinsic_triangulation& t = refined.differential.triangulation;
  std::cout << named.name << ": " << input.number_of_faces() << " -> " << t.number_of_faces() << " faces, curvature error "
            << metric.precision.max_curvature_error << " in doubles, " << result.precision->max_curvature_error << " with "
            << result.precision->bits << " bits" << std::endl;
  CHECK_EQUAL(refined.flipped_triangles, 0u);
  CHECK_EQUAL(defect(refined.differential), "");
  CHECK(refined.differential.doubled_area() == result.differential->doubled_area());   // exactly
  CHECK_EQUAL(structural_defect(t), "");
  CHECK(CGAL::is_closed(t.mesh()) && t.mesh().is_valid());
  CHECK_EQUAL(t.genus(), input.genus());
  CHECK(static_cast<double>(t.number_of_faces()) <= most_faces * static_cast<double>(input.number_of_faces()));
  check_on_input(input, refined, nasty ? 1e-8 : 1e-12);
  check_point_maps(input, refined);

  Visitor visitor;
  const T_mesh flat = t_mesh(*result.differential, visitor);
  CHECK_EQUAL(flat.nodes.size(), result.t_mesh->nodes.size());
  CHECK_EQUAL(flat.arcs.size(), result.t_mesh->arcs.size());
  CHECK(rectangles(flat) == rectangles(*result.t_mesh));
}

// The area-weighted mean of sigma_1 / sigma_2 of the map to the plane, minus 1.
double conformal_error(const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  double sum = 0, area = 0;
  for (Face f : t.faces()) {
    const auto z = t.unfolded(f);
    const auto h = t.halfedges(f);
    const auto point = [&](int k) {
      const Grid_vector w = q.corner[h[k]] - q.corner[h[0]];
      return std::complex<double>(static_cast<double>(w.x), static_cast<double>(w.y));
    };
    // w = a z + b conj(z), with the first corner at 0
    const std::complex<double> d = z[1] * std::conj(z[2]) - z[2] * std::conj(z[1]);
    const std::complex<double> a = (point(1) * std::conj(z[2]) - point(2) * std::conj(z[1])) / d;
    const std::complex<double> b = (z[1] * point(2) - z[2] * point(1)) / d;
    const double face_area = std::abs(d.imag()) / 4;
    sum += face_area * 2 * std::abs(b) / (std::abs(a) - std::abs(b));
    area += face_area;
  }
  return sum / area;
}

// The map converges to a conformal one when the input is subdivided.
void test_convergence(const Mesh& coarse)
{
  Quartic_differential_options options;
  options.choice.count = 16;
  options.choice.start = Singularity_start::pairs;
  std::vector<double> error;
  for (const Mesh& mesh : {coarse, subdivided(coarse)})
    error.push_back(conformal_error(run_pipeline(Intrinsic_triangulation(mesh), options).refined->differential));
  std::cout << "sigma_1 / sigma_2 - 1: " << error[0] << " -> " << error[1] << std::endl;
  CHECK(error[0] < 0.1);
  CHECK(error[0] / error[1] > 1.6);
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test(s, 1.7);
  for (const auto& s : Quartic_test::real_surfaces({"spot_5k8", "sculpt_7k3"})) test(s, 1.1);
  for (const auto& s : Quartic_test::real_surfaces({"buddha_20k"})) test(s, 2, true);
  // surfaces made nasty
  const Mesh chain = handle_chain(2, 6);
  const auto nasty = [](const char* name, const Mesh& mesh, double most_faces) {
    test({name, Intrinsic_triangulation(mesh)}, most_faces, true);
  };
  nasty("stretched 100:1", stretched(chain, 100), 12);
  nasty("noise of half an edge", noisy(chain, 0.5, 1), 1.7);
  nasty("slivers", with_slivers(chain, 1e-6, 2), 1.7);
  nasty("a vertex of valence 500", with_hub(chain, 500), 2);
  test_convergence(handle_chain(2, 8));
  return Quartic_test::result();
}
