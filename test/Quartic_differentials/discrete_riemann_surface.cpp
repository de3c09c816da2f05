// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps 1 to 5 as an application calls them, on meshes of its own type.

#include "check.h"
#include "hyperelliptic_periods.h"
#include "period_comparison.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>
#include <CGAL/discrete_riemann_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <random>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace QD = CGAL::Quartic_differentials;
using Quartic_test::Complex;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

template <class TriangleMesh>
TriangleMesh as(const QD::Mesh& mesh)
{
  TriangleMesh copy;
  CGAL::copy_face_graph(mesh, copy);
  return copy;
}

template <class TriangleMesh>
Eigen::RowVectorXcd integral(const QD::Holomorphic_1_form_map<TriangleMesh>& forms,
                             const std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>& walk)
{
  Eigen::RowVectorXcd sum = Eigen::RowVectorXcd::Zero(forms.surface.genus());
  for (auto h : walk) sum += get(forms, h);
  return sum;
}

// closed walks, normalised closed forms, and their periods along the very walks
template <class TriangleMesh>
QD::Period_matrix test_steps_1_to_3(const TriangleMesh& mesh, int genus)
{
  const auto forms = QD::holomorphic_1_form_basis(mesh);
  const auto basis = QD::canonical_homology_basis(mesh);
  const QD::Period_matrix periods = QD::period_matrix(mesh);
  CHECK_EQUAL(forms.surface.genus(), genus);
  CHECK_EQUAL(static_cast<int>(basis.loops.size()), 2 * genus);
  CHECK(basis.certified && basis.reason.empty());
  CHECK((forms.surface.period_matrix().pi - periods.pi).isZero(0));
  CHECK(forms.surface.canonical_homology_basis().loops == basis.loops);
  for (int k = 0; k < 2 * genus; ++k) {
    const auto& loop = basis.loops[k];
    for (std::size_t i = 0; i < loop.size(); ++i)
      CHECK(target(loop[i], mesh) == source(loop[(i + 1) % loop.size()], mesh));
    const Eigen::RowVectorXcd expected = k < genus ? Eigen::RowVectorXcd(Eigen::RowVectorXcd::Unit(genus, k))
                                                   : Eigen::RowVectorXcd(periods.pi.row(k - genus));
    CHECK((integral(forms, loop) - expected).cwiseAbs().maxCoeff() < 1e-9);
  }
  double curl = 0, opposite_sum = 0;
  for (auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    if (genus == 0) break;
    curl = std::max(curl, integral(forms, {h, next(h, mesh), prev(h, mesh)}).cwiseAbs().maxCoeff());
    opposite_sum = std::max(opposite_sum, (get(forms, h) + get(forms, opposite(h, mesh))).cwiseAbs().maxCoeff());
  }
  CHECK(curl < 1e-12);
  CHECK(opposite_sum < 1e-14);
  return periods;
}

void test_mesh_types()
{
  for (int genus = 0; genus <= 2; ++genus) {
    const QD::Mesh sample = QD::handle_chain(genus, 6);
    const QD::Period_matrix first = test_steps_1_to_3(as<Surface_mesh>(sample), genus);
    const QD::Period_matrix second = test_steps_1_to_3(as<Polyhedron>(sample), genus);
    CHECK((first.pi - second.pi).isZero(0));
  }
}

// indices with gaps: elements that were removed but not collected
void test_garbage()
{
  const QD::Mesh sample = QD::torus(2, 1, 20, 12);
  Surface_mesh mesh;
  for (int i = 0; i < 5; ++i) mesh.add_vertex(Kernel::Point_3(i, i * i, 7));
  mesh.add_face(Surface_mesh::Vertex_index(0), Surface_mesh::Vertex_index(1), Surface_mesh::Vertex_index(2));
  std::vector<Surface_mesh::Vertex_index> vertex;
  for (auto v : sample.vertices()) {
    const auto& p = sample.point(v);
    vertex.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z())));
  }
  for (auto f : sample.faces()) {
    std::vector<Surface_mesh::Vertex_index> corners;
    for (auto v : vertices_around_face(sample.halfedge(f), sample)) corners.push_back(vertex[v]);
    mesh.add_face(corners);
  }
  CGAL::Euler::remove_face(mesh.halfedge(Surface_mesh::Face_index(0)), mesh);
  for (auto v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  CHECK(mesh.has_garbage());
  CHECK((test_steps_1_to_3(mesh, 1).pi - test_steps_1_to_3(as<Surface_mesh>(sample), 1).pi).norm() < 1e-12);
}

void test_refused_meshes()
{
  const auto refused = [](const Surface_mesh& mesh, const std::string& reason) {
    CHECK_THROWS(QD::canonical_homology_basis(mesh), QD::Unusable_surface_error, reason);
  };
  using V = Surface_mesh::Vertex_index;
  using P = Kernel::Point_3;
  refused(Surface_mesh(), "no triangle");
  Surface_mesh triangle;
  for (const P& p : {P(0, 0, 0), P(1, 0, 0), P(0, 1, 0)}) triangle.add_vertex(p);
  triangle.add_face(V(0), V(1), V(2));
  refused(triangle, "boundary");
  Surface_mesh cube;
  CGAL::make_hexahedron(P(0, 0, 0), P(1, 0, 0), P(1, 1, 0), P(0, 1, 0), P(0, 1, 1), P(0, 0, 1), P(1, 0, 1), P(1, 1, 1),
                        cube);
  refused(cube, "not a triangle");
  Surface_mesh flat, two;
  CGAL::make_tetrahedron(P(0, 0, 0), P(1, 0, 0), P(2, 0, 0), P(0, 1, 0), flat);
  refused(flat, "has no area");
  for (double x : {0, 5})
    CGAL::make_tetrahedron(P(x, 0, 0), P(x + 1, 0, 0), P(x, 1, 0), P(x, 0, 1), two);
  refused(two, "not connected");
}

// a Delta-complex with parallel edges, which no points could describe
void test_edge_lengths()
{
  const QD::Intrinsic_triangulation curve(QD::hyperelliptic(2, 0));
  const auto lengths = boost::make_function_property_map<QD::Edge>([&](QD::Edge e) { return curve.length(e); });
  const QD::Period_matrix periods = QD::period_matrix(curve.mesh(), QD::parameters::edge_length_map(lengths));
  CHECK(Quartic_test::distance_modulo_symplectic(periods.pi, Quartic_test::hyperelliptic_periods(2), 0.4) < 1e-12);
  const auto basis = QD::canonical_homology_basis(curve.mesh(), QD::parameters::edge_length_map(lengths));
  CHECK(!basis.certified);
  CHECK(basis.reason.find("edge lengths alone") != std::string::npos);

  const auto wrong = boost::make_function_property_map<QD::Edge>([](QD::Edge e) { return e.idx() == 0 ? 9.0 : 1.0; });
  CHECK_THROWS(QD::period_matrix(curve.mesh(), QD::parameters::edge_length_map(wrong)), QD::Unusable_surface_error,
               "triangle inequality");
}

// the image of q - p is the integral of the forms from p to q, modulo the lattice
void test_abel_jacobi_map(const Surface_mesh& mesh)
{
  const QD::Discrete_riemann_surface<Surface_mesh> surface(mesh);
  const auto forms = surface.holomorphic_1_form_basis();
  const Eigen::MatrixXcd pi = surface.period_matrix().pi;
  std::mt19937 random(4);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<Surface_mesh::Halfedge_index> walk;
    const Surface_mesh::Vertex_index p(static_cast<unsigned>(random() % mesh.number_of_vertices()));
    for (auto h = mesh.halfedge(p); walk.size() < 200;) {   // steps from p = target(h)
      for (unsigned turns = random() % 4; turns > 0; --turns) h = mesh.opposite(mesh.next(h));
      h = mesh.next(h);
      walk.push_back(h);
    }
    const auto q = mesh.target(walk.back());
    const Eigen::VectorXcd z = integral(forms, walk).transpose();
    const Eigen::VectorXd t = pi.imag().inverse() * z.imag(), s = z.real() - pi.real() * t;
    const QD::Jacobian_point image = surface.abel_jacobi_map(
      {{PMP::locate_vertex<double>(q, mesh), 1}, {PMP::locate_vertex<double>(p, mesh), -1}});
    const auto off_lattice = [](const Eigen::VectorXd& x) { return (x.array() - x.array().round()).abs().maxCoeff(); };
    CHECK(off_lattice(image.s - s) < 1e-6);   // points on vertices are moved by 1e-9
    CHECK(off_lattice(image.t - t) < 1e-6);
    CHECK(image.distance_from_origin() <= 0.5);
    CHECK((image.image - image.s.cast<Complex>() - pi * image.t.cast<Complex>()).norm() < 1e-12);
  }
  CHECK_THROWS(QD::abel_jacobi_map(mesh, {{PMP::locate_vertex<double>(Surface_mesh::Vertex_index(0), mesh), 1}}),
               QD::Infeasible_divisor_error, "degree of the divisor is 1");
}

void test_legalization()
{
  const Surface_mesh mesh = as<Surface_mesh>(QD::torus(2, 1, 30, 16));
  QD::Mesh_divisor<Surface_mesh> divisor;
  for (unsigned i = 0; i < 6; ++i)
    divisor.push_back({PMP::locate_vertex<double>(Surface_mesh::Vertex_index(i * 77), mesh), i % 2 == 0 ? 1 : -1,
                       i == 3});
  QD::Legalization_options options;
  options.norm = QD::Lattice_norm::paper;
  CHECK(QD::abel_jacobi_map(mesh, divisor).distance_from_origin() > 1e-3);
  const auto by_movement = QD::legalize_divisor(mesh, divisor);
  const auto by_paper = QD::legalize_divisor(mesh, divisor, QD::parameters::legalization_options(options));
  for (const auto& legal : {by_movement, by_paper}) {
    CHECK_EQUAL(legal.size(), divisor.size());
    for (std::size_t i = 0; i < divisor.size(); ++i) {
      CHECK_EQUAL(legal[i].order, divisor[i].order);
      const double moved = std::sqrt(CGAL::squared_distance(PMP::construct_point(legal[i].location, mesh),
                                                            PMP::construct_point(divisor[i].location, mesh)));
      CHECK(divisor[i].pinned ? moved < 1e-7 : moved > 1e-4);
    }
  }
  divisor.pop_back();
  CHECK_THROWS(QD::legalize_divisor(mesh, divisor), QD::Infeasible_divisor_error, "degree");
}

} // namespace

int main()
{
  test_mesh_types();
  test_garbage();
  test_refused_meshes();
  test_edge_lengths();
  test_abel_jacobi_map(as<Surface_mesh>(QD::torus(2, 1, 20, 12)));
  test_abel_jacobi_map(as<Surface_mesh>(QD::handle_chain(2, 6)));
  test_abel_jacobi_map(as<Surface_mesh>(Quartic_test::jittered_torus(24, 30, 0.2, 4, 3)));   // many flips
  test_legalization();
  return Quartic_test::result();
}
