// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coarsening: topology and cohomology classes stay exactly, the conformal structure nearly: period matrices, and
// energies of log scale factors.

#include "check.h"
#include "named_surfaces.h"

#include <CGAL/Quartic_differentials/coarse_surface.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/homology_basis.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/period_matrix.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace CGAL::Quartic_differentials;

namespace {

const double pi = CGAL_PI;

struct Fine_surface
{
  explicit Fine_surface(const Intrinsic_triangulation& input)
    : triangulation(input), cochains(homology_basis(input).cochains) { make_delaunay(triangulation, cochains); }

  Coarse_surface coarsened(std::size_t vertices) const
  { return CGAL::Quartic_differentials::coarsened(triangulation, cochains, vertices); }

  Intrinsic_triangulation triangulation;
  Integer_cochains        cochains;
};

// What is to be preserved.
class Conformal_structure
{
public:
  Conformal_structure(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                      const std::vector<double>& mass)
    : m_mass(Eigen::Map<const Eigen::VectorXd>(mass.data(), mass.size()))
  {
    const std::vector<double> weights = cotangent_weights(t, t.lengths());
    m_laplacian.factorize(t, weights);
    const Harmonic_1_forms forms = harmonic_1_forms(t, cochains, weights, m_laplacian);
    m_dirichlet = forms.dirichlet;
    m_pi = period_matrix(forms).pi;
    const std::vector<double> k = curvatures(t, corner_angles(t, t.lengths()));
    m_curvature = Eigen::Map<const Eigen::VectorXd>(k.data(), k.size());
  }

  const Eigen::MatrixXcd& periods() const { return m_pi; }
  const Eigen::MatrixXd&  dirichlet() const { return m_dirichlet; }
  const Eigen::VectorXd&  curvature() const { return m_curvature; }

  // the mean square of u with L u = -k and mean 0
  double energy(const Eigen::VectorXd& k) const
  {
    Eigen::VectorXd u = m_laplacian.solve(-k).col(0);
    u.array() -= m_mass.dot(u) / m_mass.sum();
    return m_mass.dot(u.cwiseAbs2()) / m_mass.sum();
  }

private:
  Eigen::VectorXd  m_mass, m_curvature;
  Laplacian_solver m_laplacian;
  Eigen::MatrixXd  m_dirichlet;
  Eigen::MatrixXcd m_pi;
};

template <class Matrix>
double largest(const Matrix& m) { return m.size() == 0 ? 0 : m.cwiseAbs().maxCoeff(); }

bool is_closed(const Intrinsic_triangulation& t, const Integer_cochains& cochains, Face f)
{
  const auto h = t.halfedges(f);
  return (cochains.row(h[0]) + cochains.row(h[1]) + cochains.row(h[2])).isZero();
}

void test_validity(const Fine_surface& fine, const Coarse_surface& coarse)
{
  const Intrinsic_triangulation& t = coarse.triangulation;
  CHECK_EQUAL(structural_defect(t), "");
  CHECK_EQUAL(t.genus(), fine.triangulation.genus());
  CHECK(intersection_numbers(t, coarse.cochains) == intersection_numbers(fine.triangulation, fine.cochains));
  CHECK(std::all_of(t.faces().begin(), t.faces().end(), [&](Face f) { return is_closed(t, coarse.cochains, f); }));
  Intrinsic_triangulation copy = t;
  CHECK_EQUAL(make_delaunay(copy), 0u);

  CHECK_EQUAL(coarse.mass.size(), t.number_of_vertices());
  CHECK(*std::min_element(coarse.mass.begin(), coarse.mass.end()) > 0);
  const double area = fine.triangulation.area();
  CHECK_NEAR(std::accumulate(coarse.mass.begin(), coarse.mass.end(), 0.0), area, 1e-12 * area);

  CHECK_EQUAL(coarse.fine_vertex.size(), t.number_of_vertices());
  std::vector<Vertex> sorted = coarse.fine_vertex;
  std::sort(sorted.begin(), sorted.end());
  CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
  CHECK(sorted.back().idx() < fine.triangulation.number_of_vertices());
}

bool equal(const Coarse_surface& a, const Coarse_surface& b)
{
  return a.triangulation.lengths() == b.triangulation.lengths() && a.cochains.values() == b.cochains.values()
      && a.mass == b.mass && a.fine_vertex == b.fine_vertex
      && std::equal(a.removed.begin(), a.removed.end(), b.removed.begin(), b.removed.end(),
                    [](const Removed_vertex& v, const Removed_vertex& w) {
           return v.vertex == w.vertex && v.corner == w.corner && v.barycentric == w.barycentric;
         });
}

// The curvatures of cones, of total `turns` quarter turns, at the same places of both surfaces.
std::pair<Eigen::VectorXd, Eigen::VectorXd> cones(std::size_t fine_size, const Coarse_surface& coarse, int turns,
                                                  unsigned seed)
{
  Eigen::VectorXd on_fine = Eigen::VectorXd::Zero(fine_size), on_coarse = Eigen::VectorXd::Zero(coarse.mass.size());
  std::mt19937 random(seed);
  for (int i = 0; i < 8 + std::abs(turns); ++i) {
    const int sign = i < 8 ? (i % 2 == 0 ? 1 : -1) : (turns > 0 ? 1 : -1);
    const std::size_t v = random() % coarse.mass.size();
    on_coarse[v] += sign * pi / 2;
    on_fine[coarse.fine_vertex[v].idx()] += sign * pi / 2;
  }
  return {on_fine, on_coarse};
}

struct Bounds { double periods, dirichlet, charges, metric; };   // relative errors

void test_conformal_structure(const std::string& name, const Fine_surface& fine, const Coarse_surface& coarse,
                              const Bounds& bounds)
{
  const std::size_t n = fine.triangulation.number_of_vertices();
  const int genus = fine.triangulation.genus();
  const Conformal_structure a(fine.triangulation, fine.cochains, vertex_areas(fine.triangulation));
  const Conformal_structure b(coarse.triangulation, coarse.cochains, coarse.mass);
  Bounds error{0, 0, 0, 0};
  if (genus > 0) {
    error.periods = largest(b.periods() - a.periods()) / largest(a.periods());
    error.dirichlet = largest(b.dirichlet() - a.dirichlet()) / largest(a.dirichlet());
  }
  for (unsigned seed = 0; seed < 5; ++seed) {
    // log scale factors: the Green's functions of charges of total 0, and a flat metric with cones, to first order
    const auto [fine_charges, coarse_charges] = cones(n, coarse, 0, seed);
    error.charges = std::max(error.charges, std::abs(b.energy(coarse_charges) / a.energy(fine_charges) - 1));
    const auto [fine_cones, coarse_cones] = cones(n, coarse, 8 - 8 * genus, seed);
    error.metric = std::max(error.metric, std::abs(b.energy(coarse_cones - b.curvature())
                                                   / a.energy(fine_cones - a.curvature()) - 1));
  }
  std::cout << name << ", " << n << " to " << coarse.mass.size() << " vertices: relative errors " << error.periods
            << " of periods, " << error.dirichlet << " of Dirichlet products, " << error.charges << " and "
            << error.metric << " of energies" << std::endl;
  CHECK(error.periods <= bounds.periods);
  CHECK(error.dirichlet <= bounds.dirichlet);
  CHECK(error.charges <= bounds.charges);
  CHECK(error.metric <= bounds.metric);
}

void test_surface(const Quartic_test::Named_surface& named, std::size_t vertices, const Bounds& bounds)
{
  const Fine_surface fine(named.surface);
  const Coarse_surface coarse = fine.coarsened(vertices);
  CHECK_EQUAL(coarse.mass.size(), std::min(vertices, fine.triangulation.number_of_vertices()));
  test_validity(fine, coarse);
  test_conformal_structure(named.name, fine, coarse, bounds);
  CHECK(equal(coarse, fine.coarsened(vertices)));
}

// A vertex comes to lie beside itself.
void test_points_at_vertices(const Quartic_test::Named_surface& named)
{
  const Fine_surface fine(named.surface);
  const Coarse_surface coarse = fine.coarsened(named.surface.number_of_vertices() / 4);
  for (Vertex v : coarse.triangulation.vertices()) {
    const Surface_point q = on_fine_surface(coarse, at_vertex(coarse.triangulation, v), fine.triangulation);
    const auto h = fine.triangulation.halfedges(q.face);
    const auto most = std::max_element(q.barycentric.begin(), q.barycentric.end()) - q.barycentric.begin();
    CHECK(fine.triangulation.source(h[most]) == coarse.fine_vertex[v] && q.barycentric[most] > 0.9);
  }
}

// as far as it goes
void test_fewest_vertices(const Quartic_test::Named_surface& named)
{
  const Fine_surface fine(named.surface);
  const Coarse_surface coarse = fine.coarsened(1);
  std::cout << named.name << ": at least " << coarse.mass.size() << " vertices are left" << std::endl;
  CHECK(coarse.mass.size() <= 6u + 2u * named.surface.genus());
  test_validity(fine, coarse);
}

void test_small_surface()
{
  const Fine_surface fine{Intrinsic_triangulation(handle_chain(2, 6))};
  const std::size_t n = fine.triangulation.number_of_vertices();
  std::vector<Vertex> all(fine.triangulation.vertices().begin(), fine.triangulation.vertices().end());
  for (std::size_t vertices : {n, n + 1, 10 * n})
    CHECK(equal(fine.coarsened(vertices),
                {fine.triangulation, fine.cochains, vertex_areas(fine.triangulation), all, {}}));
}

// On a flat torus nothing is lost but vertices: linear functions are harmonic on every triangulation.
void test_flat_torus()
{
  Glued_triangles square;
  square.triangles = {{0, 0, 0}, {0, 0, 0}};
  square.opposite = {{{{1, 1}, {1, 2}, {1, 0}}}, {{{0, 2}, {0, 0}, {0, 1}}}};
  square.lengths = {{1, 1, std::sqrt(2.0)}, {std::sqrt(2.0), 1, 1}};
  const Fine_surface one_vertex{Intrinsic_triangulation(square)};
  CHECK_EQUAL(one_vertex.coarsened(0).mass.size(), 1u);   // has loops only

  const Fine_surface fine{Intrinsic_triangulation(subdivided(subdivided(subdivided(square))))};
  const Conformal_structure before(fine.triangulation, fine.cochains, vertex_areas(fine.triangulation));
  for (std::size_t vertices : {40, 20, 10}) {
    const Coarse_surface coarse = fine.coarsened(vertices);
    CHECK_EQUAL(coarse.mass.size(), vertices);
    test_validity(fine, coarse);
    CHECK_NEAR(coarse.triangulation.area(), 1, 1e-12);
    const Conformal_structure after(coarse.triangulation, coarse.cochains, coarse.mass);
    CHECK_NEAR(largest(after.periods() - before.periods()), 0, 1e-12);
    CHECK_NEAR(largest(after.curvature()), 0, 1e-11);
  }
}

// A flat torus of n x n squares, each cut in two; vertex i + n j is at (i, j) / n.
Glued_triangles grid_torus(int n)
{
  Glued_triangles g;
  const double side = 1.0 / n, diagonal = std::sqrt(2.0) / n;
  const auto vertex = [n](int i, int j) { return (i + n) % n + n * ((j + n) % n); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      g.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      g.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      g.opposite.push_back({{{2 * vertex(i, j - 1) + 1, 1}, {2 * vertex(i + 1, j) + 1, 2}, {2 * vertex(i, j) + 1, 0}}});
      g.opposite.push_back({{{2 * vertex(i, j), 2}, {2 * vertex(i, j + 1), 0}, {2 * vertex(i - 1, j), 1}}});
      g.lengths.push_back({side, side, diagonal});
      g.lengths.push_back({diagonal, side, side});
    }
  return g;
}

// The way from one place on the grid torus to another, the shortest.
std::complex<double> way(std::complex<double> from, std::complex<double> to)
{
  const std::complex<double> z = to - from;
  return {z.real() - std::round(z.real()), z.imag() - std::round(z.imag())};
}

// The place of a point of a face of which the corners are these vertices of the grid torus.
std::complex<double> place(const std::array<Vertex, 3>& corner, const std::array<double, 3>& barycentric, int n)
{
  std::array<std::complex<double>, 3> at;
  for (int k = 0; k < 3; ++k)
    at[k] = std::complex<double>(static_cast<int>(corner[k].idx()) % n, static_cast<int>(corner[k].idx()) / n) / double(n);
  return at[0] + barycentric[1] * way(at[0], at[1]) + barycentric[2] * way(at[0], at[2]);
}

// Points of a coarse flat torus come to lie near the place where they were: on average at less than half the distance of
// the nearest corner of their face.
void test_points(std::mt19937& random)
{
  const int n = 12;
  const Fine_surface fine{Intrinsic_triangulation(grid_torus(n))};
  const Coarse_surface coarse = fine.coarsened(30);
  CHECK_EQUAL(coarse.removed.size(), std::size_t(n * n - 30));
  double to_itself = 0, to_corners = 0;
  for (Face f : coarse.triangulation.faces()) {
    const double a = Quartic_test::uniform(random, 0, 1), b = Quartic_test::uniform(random, 0, 1 - a);
    const Surface_point p{f, {a, b, 1 - a - b}}, q = on_fine_surface(coarse, p, fine.triangulation);
    std::array<Vertex, 3> from, to;
    for (int k = 0; k < 3; ++k) {
      from[k] = coarse.fine_vertex[coarse.triangulation.source(coarse.triangulation.halfedges(f)[k])];
      to[k] = fine.triangulation.source(fine.triangulation.halfedges(q.face)[k]);
    }
    const std::complex<double> at = place(from, p.barycentric, n);
    to_itself += std::abs(way(at, place(to, q.barycentric, n)));
    to_corners += std::min({std::abs(way(at, place(from, {1, 0, 0}, n))), std::abs(way(at, place(from, {0, 1, 0}, n))),
                            std::abs(way(at, place(from, {0, 0, 1}, n)))});
    CHECK(*std::min_element(q.barycentric.begin(), q.barycentric.end()) > 0.04);
  }
  std::cout << "carried to a flat torus: " << to_itself / to_corners << " of the distance to corners" << std::endl;
  CHECK(to_itself < 0.5 * to_corners);
}

// A regular tetrahedron becomes two copies of its base, and its fourth vertex goes to the others in equal parts.
void test_tetrahedron()
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point_3(1, 1, 1)), b = mesh.add_vertex(Point_3(-1, -1, 1)),
               c = mesh.add_vertex(Point_3(-1, 1, -1)), d = mesh.add_vertex(Point_3(1, -1, -1));
  mesh.add_face(a, c, b);
  mesh.add_face(a, b, d);
  mesh.add_face(b, c, d);
  mesh.add_face(c, a, d);
  const Fine_surface fine{Intrinsic_triangulation(mesh)};
  const Coarse_surface coarse = fine.coarsened(1);
  CHECK_EQUAL(coarse.mass.size(), 3u);
  test_validity(fine, coarse);
  for (double m : coarse.mass) CHECK_NEAR(m, fine.triangulation.area() / 3, 1e-12);
  for (double l : coarse.triangulation.lengths()) CHECK_NEAR(l, std::sqrt(8.0), 1e-12);
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) {
    const std::size_t n = s.surface.number_of_vertices();
    test_surface(s, n / 2, {0.003, 0.02, 0.06, 0.05});
    test_surface(s, n / 4, {0.006, 0.03, 0.2, 0.15});   // point charges are coarse at some 200 vertices
    test_points_at_vertices(s);
    test_fewest_vertices(s);
  }
  for (const auto& s : Quartic_test::real_surfaces({"rockerarm_20k", "buddha_20k", "neptune_30k", "bracket_29k",
                                                    "fertility_112k"})) {
    test_surface(s, 10000, {0.004, 0.02, 0.01, 0.01});
    test_surface(s, 5000, {0.008, 0.05, 0.02, 0.02});
  }
  test_small_surface();
  test_flat_torus();
  std::mt19937 random(4);
  test_points(random);
  test_tetrahedron();
  return Quartic_test::result();
}
