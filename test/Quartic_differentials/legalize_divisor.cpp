// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Step 5: every feasible divisor becomes legal in a few steps; the others are refused with their mathematical reason.

#include "check.h"
#include "named_surfaces.h"
#include "period_comparison.h"

#include <CGAL/Quartic_differentials/closest_vector.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/Lattice_basis.h>
#include <CGAL/Quartic_differentials/pipeline.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#ifdef QUARTIC_TEST_FPLLL
#include <fplll.h>
#endif

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
  for (Lattice_norm norm : {Lattice_norm::movement, Lattice_norm::paper, Lattice_norm::invariant}) {
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

// a product of elementary integer matrices that keep the symplectic unit
Eigen::MatrixXd random_symplectic(std::mt19937& random, int g, int steps)
{
  Eigen::MatrixXd u = Eigen::MatrixXd::Identity(2 * g, 2 * g);
  for (int s = 0; s < steps; ++s) {
    Eigen::MatrixXd e = Eigen::MatrixXd::Identity(2 * g, 2 * g);
    const int i = random() % g, j = random() % g;
    const double q = random() % 2 ? 1 : -1;
    switch (random() % 3) {
    case 0: e(i, g + j) = e(j, g + i) = q; break;       // a_i + q b_j, a_j + q b_i
    case 1: e(g + i, j) = e(g + j, i) = q; break;       // b_i + q a_j, b_j + q a_i
    default: if (i != j) { e(i, j) = q; e(g + j, g + i) = -q; }   // a_i + q a_j, b_j - q b_i
    }
    u = e * u;
  }
  return u;
}

// A change U of the canonical basis takes F to U F and the Dirichlet products S to U S U^T. The invariant norm's
// nearest vectors go with it at the same distances; the paper's do not.
void test_invariant_norm()
{
  std::mt19937 random(23);
  int paper_changed = 0, changes = 0;
  for (int g : {1, 2, 3, 4}) {
    const Setting s{g == 1 ? Intrinsic_triangulation(handle_chain(1, 6))
                           : Intrinsic_triangulation(hyperelliptic(g, 2))};
    const Eigen::MatrixXcd& pi = s.surface.periods.pi;
    const Eigen::MatrixXd S = Quartic_test::gram_of_periods(pi), W = lattice_gram(Lattice_norm::invariant, {}, pi);
    const double size = W.cwiseAbs().maxCoeff();
    const Eigen::MatrixXd J = symplectic_unit(g).cast<double>();
    CHECK_NEAR((W * S - Eigen::MatrixXd::Identity(2 * g, 2 * g)).cwiseAbs().maxCoeff(), 0, 1e-11 * size);
    CHECK_NEAR((W - J * S * J.transpose()).cwiseAbs().maxCoeff(), 0, 1e-11 * size);
    // the definition: z* Y^-1 z with z = -q + Pi p
    Eigen::VectorXd x(2 * g);
    for (int k = 0; k < 2 * g; ++k) x[k] = Quartic_test::uniform(random, -2, 2);
    const Eigen::VectorXcd z = pi * x.head(g) - x.tail(g);
    CHECK_NEAR(x.dot(W * x), (z.adjoint() * pi.imag().inverse() * z).real()(0), 1e-11 * size);
    CHECK_NEAR(x.dot(lattice_gram(Lattice_norm::paper, {}, pi) * x), z.squaredNorm(), 1e-11 * size);

    for (int repeat = 0; repeat < 20; ++repeat) {
      const Eigen::MatrixXd u = random_symplectic(random, g, 4);
      CHECK((u * J * u.transpose() - J).cwiseAbs().maxCoeff() == 0);
      const Eigen::MatrixXcd changed = Quartic_test::periods_of_gram(u * S * u.transpose());
      const auto nearest = [&](Lattice_norm norm, const Eigen::MatrixXcd& periods, const Eigen::VectorXd& target) {
        return closest_vectors(lattice_gram(norm, {}, periods), target, {4});
      };
      const Closest_vectors before = nearest(Lattice_norm::invariant, pi, x);
      const Closest_vectors after = nearest(Lattice_norm::invariant, changed, u * x);
      for (int k = 0; k < 4; ++k)
        CHECK_NEAR(before.vectors[k].squared_distance, after.vectors[k].squared_distance, 1e-7);
      if (*before.gap > 1e-6)
        for (int k = 0; k < 2 * g; ++k) {
          double coefficient = 0;
          for (int l = 0; l < 2 * g; ++l) coefficient += u(k, l) * before.vectors[0].coefficients[l];
          CHECK_EQUAL(coefficient, after.vectors[0].coefficients[k]);
        }
      ++changes;
      paper_changed += std::abs(nearest(Lattice_norm::paper, pi, x).vectors[0].squared_distance
                                - nearest(Lattice_norm::paper, changed, u * x).vectors[0].squared_distance) > 1e-3;
    }
  }
  std::cout << "the paper's norm changed with " << paper_changed << " of " << changes << " bases" << std::endl;
  CHECK(paper_changed > changes / 2);
}

double squared_distance(const Eigen::MatrixXd& gram, const Eigen::VectorXd& x, const Eigen::VectorXd& m)
{
  return (x - m).dot(gram * (x - m));
}

Lattice_vector lattice_vector(const Eigen::MatrixXd& gram, const Eigen::VectorXd& x, const Eigen::VectorXd& m)
{
  Lattice_vector v;
  for (double c : m) v.coefficients.push_back(std::lround(c));
  v.squared_distance = squared_distance(gram, x, m);
  return v;
}

// A model of ClosestVectorSolver: all integer points of a box that contains the wanted ones, in doubles.
struct Exhaustive_search
{
  int* calls;

  Closest_vectors operator()(const Eigen::MatrixXd& gram, const Eigen::VectorXd& x,
                             const Closest_vector_options& options) const
  {
    ++*calls;
    const Eigen::VectorXd rounded = x.array().round();
    // the wanted vectors are within `radius_factor` times the least distance, which is at most that of `rounded`
    const Eigen::VectorXd reach = options.radius_factor * std::sqrt(squared_distance(gram, x, rounded))
                                * gram.inverse().diagonal().cwiseSqrt();
    const Eigen::VectorXd low = (x - reach).array().ceil(), high = (x + reach).array().floor();
    Closest_vectors result;
    Eigen::VectorXd m = low;
    for (Eigen::Index i = 0; i < m.size();) {
      if (i == 0) result.vectors.push_back(lattice_vector(gram, x, m));
      if (++m[i] <= high[i]) { i = 0; continue; }
      m[i] = low[i];
      ++i;
    }
    std::sort(result.vectors.begin(), result.vectors.end(), [](const Lattice_vector& a, const Lattice_vector& b)
              { return a.squared_distance < b.squared_distance; });
    const double most = options.radius_factor * options.radius_factor * result.vectors[0].squared_distance;
    while (result.vectors.size() > options.count || result.vectors.back().squared_distance > most)
      result.vectors.pop_back();
    result.optimal = true;
    return result;
  }
};

// A model that proves nothing: Babai's nearest plane in a reduced basis.
struct Nearest_plane
{
  Closest_vectors operator()(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                             const Closest_vector_options&) const
  {
    const internal::Lattice_basis lattice(gram);
    const Eigen::MatrixXd r = Eigen::LLT<Eigen::MatrixXd>(lattice.gram()).matrixU();
    const Eigen::VectorXd x = lattice.dual().cast<double>().transpose() * target;
    Eigen::VectorXd m = x;
    for (Eigen::Index i = x.size() - 1; i >= 0; --i) {
      const Eigen::Index right = x.size() - 1 - i;
      m[i] = std::round(x[i] + r.row(i).tail(right).dot(x.tail(right) - m.tail(right)) / r(i, i));
    }
    Closest_vectors result;
    result.vectors.push_back(lattice_vector(gram, target, lattice.basis().cast<double>() * m));
    return result;
  }
};

#ifdef QUARTIC_TEST_FPLLL
// A model by fplll, on the Cholesky factor in integers of 30 bits.
struct Fplll_search
{
  Closest_vectors operator()(const Eigen::MatrixXd& gram, const Eigen::VectorXd& x, const Closest_vector_options&) const
  {
    const int n = static_cast<int>(x.size());
    const Eigen::MatrixXd b = Eigen::LLT<Eigen::MatrixXd>(gram).matrixU();
    const double scale = std::ldexp(1.0, 30) / b.cwiseAbs().maxCoeff();
    const Eigen::VectorXd target = scale * b * x;
    fplll::ZZ_mat<mpz_t> basis(n, n);   // by rows
    std::vector<fplll::Z_NR<mpz_t>> t(n), solution;
    for (int i = 0; i < n; ++i) {
      t[i] = std::lround(target[i]);
      for (int j = 0; j < n; ++j) basis(i, j) = std::lround(scale * b(j, i));
    }
    fplll::lll_reduction(basis);
    if (fplll::closest_vector(basis, t, solution, fplll::CVPM_FAST) != 0) throw Numerical_error("fplll gives up");
    Eigen::VectorXd nearest = Eigen::VectorXd::Zero(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) nearest[j] += solution[i].get_d() * basis(i, j).get_d();
    const Eigen::VectorXd m = b.triangularView<Eigen::Upper>().solve(nearest / scale).array().round();
    Closest_vectors result;
    result.vectors.push_back(lattice_vector(gram, x, m));
    result.optimal = true;   // not proved in the sense of the concept, but this is a test
    return result;
  }
};
#endif

void test_solvers()
{
  for (int g : {2, 3}) {
    Setting s{Intrinsic_triangulation(handle_chain(g, 6))};
    const Divisor initial = s.initial();
    for (Lattice_norm norm : {Lattice_norm::movement, Lattice_norm::invariant}) {
      Legalization_options options;
      options.norm = norm;
      const Legal_divisor certified = s.legalized(initial, options);
      const auto same = [&](const Legal_divisor& other) {
        CHECK(other.nearest == certified.nearest);
        CHECK_EQUAL(other.tried, certified.tried);
        for (std::size_t i = 0; i < initial.size(); ++i) {
          CHECK(other.divisor[i].location.face == certified.divisor[i].location.face);
          CHECK_EQUAL(other.moved_by[i], certified.moved_by[i]);
        }
      };
      int calls = 0;
      options.solver = Exhaustive_search{&calls};
      const Legal_divisor exhaustive = s.legalized(initial, options);
      CHECK(exhaustive.certified);
      CHECK_EQUAL(calls, 1);
      same(exhaustive);
#ifdef QUARTIC_TEST_FPLLL
      if (certified.tried == 1) {
        options.solver = Fplll_search();
        same(s.legalized(initial, options));
      }
#endif
      options.solver = Nearest_plane();
      const Legal_divisor babai = s.legalized(initial, options);
      CHECK(!babai.certified);
      CHECK(babai.history.back() <= 1e-12);
      CHECK(defect(s, babai.divisor) < 1e-11);
    }

    Legalization_options broken;
    broken.solver = nullptr;
    CHECK_THROWS(s.legalized(initial, broken), Error, "no closest vector solver");
    broken.solver = [](const auto&, const auto&, const auto&) { return Closest_vectors(); };
    CHECK_THROWS(s.legalized(initial, broken), Error, "no vector");
    broken.solver = [](const auto& gram, const auto& x, const auto& wanted) {
      Closest_vectors answer = closest_vectors(gram, x, wanted);
      answer.vectors[0].coefficients[0] += 1;
      return answer;
    };
    CHECK_THROWS(s.legalized(initial, broken), Error, "not its vector's");
  }
}

} // namespace

int main()
{
  for (const auto& s : Quartic_test::sample_surfaces()) test_curvature_divisors(s);
  for (const auto& s : Quartic_test::real_surfaces({"kitten_18k9", "amphora_20k", "bracket_29k", "buddha_20k"}))
    test_curvature_divisors(s);
  test_invariant_norm();
  test_solvers();
  test_counts();
  test_degree_repair();
  test_pinned();
  test_refusals();
  test_distances();
  return Quartic_test::result();
}
