// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/direction_field.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <random>
#include <string>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;
const double pi = CGAL_PI;
const double shift = 1e-3;        // of the eigenvalues, times 4 pi / area: flat tori have the eigenvalue 0
const double tolerance = 1e-12;   // residual relative to the eigenvector, which is tiny on large parts of some surfaces
const int max_iterations = 60;

// m, the number of quads at every vertex of the boundary, 4 in the interior
std::vector<int> quads_at_vertices(const Intrinsic_triangulation& t, const Divisor& corners)
{
  std::vector<int> quads;
  for (Vertex v : t.vertices()) quads.push_back(t.is_border(v) ? 2 : 4);
  for (const Singularity& s : corners) {
    const auto [h, fraction] = internal::boundary_place(t, s.location);
    quads[fraction <= 0.5 ? t.source(h) : t.target(h)] += s.order;
  }
  return quads;
}

// phi and beta, by halfedge
struct Rescaled_angles
{
  Rescaled_angles(const Intrinsic_triangulation& t, const std::vector<int>& quads)
    : direction(t.number_of_halfedges()), corner(t.number_of_halfedges())
  {
    for (Vertex v : t.vertices()) {
      const std::vector<internal::Star_corner> star = internal::star(t, v);
      const double sum = quads[v] * (pi / 2), scale = sum / star.back().end_angle;
      for (const internal::Star_corner& c : star) {
        direction[c.halfedge] = scale * c.begin_angle;
        corner[c.halfedge] = scale * (c.end_angle - c.begin_angle);
      }
      if (t.is_border(v)) direction[t.next_around_source(star.back().halfedge)] = sum;
    }
  }
  // rho(h); the half turn between the directions at both ends of h is none for 4-direction fields
  double transport(const Intrinsic_triangulation& t, Halfedge h) const
  { return 4 * (direction[t.opposite(h)] - direction[h]); }

  std::vector<double> direction, corner;
};

// Lower triangle of C + diagonal as a real matrix: rows 2v and 2v + 1 are the real and imaginary part at vertex v.
Eigen::SparseMatrix<double> lower_connection_laplacian(const Intrinsic_triangulation& t,
                                                       const std::vector<double>& weights,
                                                       const Rescaled_angles& angles, Eigen::VectorXd diagonal)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * t.number_of_edges() + diagonal.size());
  for (Edge e : t.edges()) {
    Halfedge h = t.halfedge(e);
    if (t.target(h) < t.source(h)) h = t.opposite(h);
    const int i = 2 * static_cast<int>(t.source(h).idx()), j = 2 * static_cast<int>(t.target(h).idx());
    const Complex c = weights[e] * std::polar(1.0, angles.transport(t, h));
    for (int k : {0, 1}) {
      diagonal[i + k] += weights[e];
      diagonal[j + k] += weights[e];
      if (i == j) {   // both directions of a loop: -(c + conj(c))
        diagonal[i + k] -= 2 * c.real();
      } else {        // z -> -c z
        entries.emplace_back(j + k, i + k, -c.real());
        entries.emplace_back(j + k, i + 1 - k, k == 0 ? c.imag() : -c.imag());
      }
    }
  }
  for (int k = 0; k < diagonal.size(); ++k) entries.emplace_back(k, k, diagonal[k]);
  Eigen::SparseMatrix<double> c(diagonal.size(), diagonal.size());
  c.setFromTriplets(entries.begin(), entries.end());
  return c;
}

// uniform in [-1, 1], the same numbers with every standard library
Eigen::VectorXd random_vector(Eigen::Index size, unsigned seed)
{
  std::mt19937 random(seed);
  Eigen::VectorXd x(size);
  for (Eigen::Index k = 0; k < size; ++k) x[k] = random() / 2147483648.0 - 1;
  return x;
}

double norm(const Eigen::VectorXd& mass, const Eigen::VectorXd& x) { return std::sqrt(x.dot(mass.cwiseProduct(x))); }

// The smoothest z that is 1 on the boundary: (C + shift M) z = 0 in the interior.
Eigen::VectorXcd field_along_boundary(const Intrinsic_triangulation& t, const Eigen::SparseMatrix<double>& lower)
{
  Eigen::VectorXcd z(t.number_of_vertices());
  Eigen::VectorXd known = Eigen::VectorXd::Zero(lower.rows());
  std::vector<int> unknown(lower.rows(), -1);   // rows of the system, by row of `lower`
  int rows = 0;
  for (Vertex v : t.vertices()) {
    if (t.is_border(v)) known[2 * v.idx()] = 1;
    else for (int k : {0, 1}) unknown[2 * v.idx() + k] = rows++;
  }
  if (rows == 0) return Eigen::VectorXcd::Ones(z.size());
  Eigen::VectorXd right_hand_side = Eigen::VectorXd::Zero(rows);
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < lower.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator e(lower, k); e; ++e) {
      const int i = unknown[e.row()], j = unknown[e.col()];
      if (i >= 0 && j >= 0) entries.emplace_back(i, j, e.value());
      else if (i >= 0) right_hand_side[i] -= e.value() * known[e.col()];
      else if (j >= 0) right_hand_side[j] -= e.value() * known[e.row()];
    }
  Eigen::SparseMatrix<double> interior(rows, rows);
  interior.setFromTriplets(entries.begin(), entries.end());
  Symmetric_factorization factorization;
  factorization.factorize(interior);
  const Eigen::VectorXd x = factorization.solve(right_hand_side);
  const auto value = [&](int row) { return unknown[row] < 0 ? known[row] : x[unknown[row]]; };
  for (int v = 0; v < z.size(); ++v) z[v] = {value(2 * v), value(2 * v + 1)};
  return z;
}

// z. On a closed surface by Lanczos's method on the inverse of C + shift M. Inverse iteration is too slow, for the
// least eigenvalues are close together: on a round sphere they are one eigenvalue with nine eigenvectors. Without
// convergence the field is less smooth, but its singularities are as good a divisor.
Eigen::VectorXcd smoothest_field(const Intrinsic_triangulation& t, const std::vector<double>& weights,
                                 const Rescaled_angles& angles, unsigned seed)
{
  const std::vector<double> area = vertex_areas(t);
  Eigen::VectorXd mass(2 * area.size());
  for (Eigen::Index k = 0; k < mass.size(); ++k) mass[k] = area[k / 2];
  const Eigen::SparseMatrix<double> lower
    = lower_connection_laplacian(t, weights, angles, shift * 4 * pi / t.area() * mass);
  if (t.has_boundary()) return field_along_boundary(t, lower);
  Symmetric_factorization shifted;
  shifted.factorize(lower);

  Eigen::MatrixXd basis(mass.size(), max_iterations);   // orthonormal with respect to M
  Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(max_iterations, max_iterations);   // lower triangle
  Eigen::VectorXd next = random_vector(mass.size(), seed), z;
  for (int k = 0; k < max_iterations; ++k) {
    basis.col(k) = next / norm(mass, next);
    const auto known = basis.leftCols(k + 1);
    next = shifted.solve(mass.cwiseProduct(basis.col(k)));
    for (int pass = 0; pass < 2; ++pass) {   // once does not make it orthogonal up to rounding
      const Eigen::VectorXd part = known.transpose() * mass.cwiseProduct(next);
      next -= known * part;
      projected.row(k).head(k + 1) += part.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(projected.topLeftCorner(k + 1, k + 1));
    z = known * ritz.eigenvectors().col(k);
    const double residual = norm(mass, next) * std::abs(ritz.eigenvectors()(k, k));
    if (residual <= tolerance * ritz.eigenvalues()[k]) break;
  }
  return Eigen::Map<const Eigen::VectorXcd>(reinterpret_cast<const Complex*>(z.data()), area.size());
}

// dl, by halfedge, decided on the even halfedge of every edge so that it is antisymmetric even at half turns
std::vector<double> rotations(const Intrinsic_triangulation& t, const Rescaled_angles& angles,
                              const Eigen::VectorXcd& z)
{
  std::vector<double> rotation(t.number_of_halfedges());
  for (Edge e : t.edges()) {
    const Halfedge h = t.halfedge(e);
    const double turn = std::arg(z[t.target(h)]) - std::arg(z[t.source(h)]) - angles.transport(t, h);
    rotation[h] = std::remainder(turn, 2 * pi);
    rotation[t.opposite(h)] = -rotation[h];
  }
  return rotation;
}

int order_in_face(const Intrinsic_triangulation& t, const Rescaled_angles& angles, const std::vector<double>& rotation,
                  Face f)
{
  double turn = -4 * pi;
  for (Halfedge h : t.halfedges(f)) turn += rotation[h] + 4 * angles.corner[h];
  const double index = turn / (2 * pi);
  if (!(std::abs(index - std::round(index)) < 1e-6))
    throw Numerical_error("the index of a direction field in a face is no integer: the triangulation is degenerate");
  return -static_cast<int>(std::round(index));
}

// The k-th of n places in a face: its centroid; near its corners (0.6, 0.2, 0.2); n > 3 on the ellipse through these.
Surface_point place_in_face(Face f, int k, int n)
{
  const double radius = n == 1 ? 0 : 4 / 15.;
  Surface_point p{f, {}};
  for (int c = 0; c < 3; ++c)
    p.barycentric[c] = 1 / 3. + radius * std::cos(2 * pi * (static_cast<double>(k) / std::max(n, 3) - c / 3.));
  return p;
}

} // namespace

Divisor direction_field_divisor(const Intrinsic_triangulation& t, const std::vector<double>& weights, unsigned seed,
                                const Divisor& corners)
{
  const Rescaled_angles angles(t, quads_at_vertices(t, corners));
  const std::vector<double> rotation = rotations(t, angles, smoothest_field(t, weights, angles, seed));
  Divisor divisor;
  for (Face f : t.faces()) {
    const int order = order_in_face(t, angles, rotation, f), n = std::abs(order);
    for (int k = 0; k < n; ++k) divisor.push_back({place_in_face(f, k, n), order > 0 ? 1 : -1, false});
  }
  const int wanted = required_degree(t) - degree(corners);
  if (degree(divisor) != wanted)
    throw Numerical_error("the singularities of a direction field have degree " + std::to_string(degree(divisor))
                          + " instead of " + std::to_string(wanted) + ": the triangulation is degenerate");
  return divisor;
}

} } // namespace CGAL::Quartic_differentials
