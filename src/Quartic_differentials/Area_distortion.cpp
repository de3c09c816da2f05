// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;
const double pi = CGAL_PI;

// adds q b(p)
template <class Column>
void add_charge(const Intrinsic_triangulation& t, const Surface_point& p, double q, Column b)
{
  const auto h = t.halfedges(p.face);
  for (int c = 0; c < 3; ++c) b[t.source(h[c])] += q * p.barycentric[c];
}

} // namespace

Area_distortion::Area_distortion(const Intrinsic_triangulation& t, const Laplacian_solver& laplacian,
                                 const std::vector<double>& mass)
  : m_t(t), m_laplacian(laplacian), m_mass(Eigen::Map<const Eigen::VectorXd>(mass.data(), mass.size())),
    m_area(m_mass.sum())
{
  const std::vector<double> k = curvatures(t, corner_angles(t, t.lengths()));
  m_curvature = Eigen::Map<const Eigen::VectorXd>(k.data(), k.size());
}

// Solves for every column, with its sum taken away evenly over the area, and with M-weighted mean 0.
Eigen::MatrixXd Area_distortion::solve(Eigen::MatrixXd b) const
{
  m_solves += b.cols();
  for (Eigen::Index k = 0; k < b.cols(); ++k) b.col(k) -= (b.col(k).sum() / m_area) * m_mass;
  Eigen::MatrixXd x = m_laplacian.solve(b);
  for (Eigen::Index k = 0; k < x.cols(); ++k) x.col(k).array() -= x.col(k).dot(m_mass) / m_area;
  return x;
}

Eigen::VectorXd Area_distortion::log_scale(const Divisor& divisor) const
{
  Eigen::VectorXd b = -m_curvature;
  for (const Singularity& s : divisor) add_charge<Eigen::VectorXd&>(m_t, s.location, -s.order * pi / 2, b);
  return solve(b);
}

Eigen::VectorXd Area_distortion::potential(const Eigen::VectorXd& u) const { return solve(m_mass.cwiseProduct(u)); }

Complex Area_distortion::face_gradient(Face f, const Eigen::VectorXd& w) const
{
  const auto h = m_t.halfedges(f);
  const auto z = m_t.unfolded(f);   // z[0] = 0, z[1] real
  const double d1 = w[m_t.source(h[1])] - w[m_t.source(h[0])], d2 = w[m_t.source(h[2])] - w[m_t.source(h[0])];
  const double x = d1 / z[1].real();
  return {x, (d2 - x * z[2].real()) / z[2].imag()};
}

Eigen::VectorXd Area_distortion::gradient(const Divisor& divisor, const Eigen::VectorXd& w) const
{
  Eigen::VectorXd gradient(2 * divisor.size());
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    const Surface_point& p = divisor[i].location;
    Complex g;
    if (divisor[i].on_boundary) {
      const Halfedge h = internal::boundary_place(m_t, p).halfedge;
      g = (w[m_t.target(h)] - w[m_t.source(h)]) / m_t.length(h);
    } else {
      g = face_gradient(p.face, w);
    }
    g *= -pi * divisor[i].order / m_area;
    gradient.segment<2>(2 * i) << g.real(), g.imag();
  }
  return gradient;
}

// `share` times the mean of grad w round the source of h, weighted by area, in the unfolded frame of the face of h or
// along the boundary. In polar coordinates of total angle 2 pi whose axis is the star's first edge; on the boundary the
// angle is pi, and the mean that with the mirror image.
Complex Area_distortion::vertex_gradient(Halfedge h, double share, const Eigen::VectorXd& w, bool along_boundary) const
{
  const Vertex v = m_t.source(h);
  const bool is_border = m_t.is_border(v);
  const std::vector<internal::Star_corner> star = internal::star(m_t, v);
  const double scale = (is_border ? pi : 2 * pi) / star.back().end_angle;
  Complex sum = 0, to_face = 1;
  double area = 0;
  for (const internal::Star_corner& k : star) {
    const Complex to_polar = std::polar(1.0, scale * k.begin_angle - k.frame_angle);
    const Face f = m_t.face(k.halfedge);
    const auto z = m_t.unfolded(f);
    const double weight = z[1].real() * z[2].imag();
    sum += weight * to_polar * face_gradient(f, w);
    area += weight;
    if (k.halfedge == h) to_face = std::conj(to_polar);
  }
  if (is_border) sum = sum.real();
  if (along_boundary) to_face = 1;
  return share * to_face * sum / area;
}

Eigen::VectorXd Area_distortion::recovered_gradient(const Divisor& divisor, const Eigen::VectorXd& w) const
{
  Eigen::VectorXd gradient(2 * divisor.size());
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    Complex g = 0;
    const auto h = m_t.halfedges(divisor[i].location.face);
    for (int c = 0; c < 3; ++c) {
      const double b = divisor[i].location.barycentric[c];
      if (!divisor[i].on_boundary || b != 0) g += vertex_gradient(h[c], b, w, divisor[i].on_boundary);
    }
    g *= -pi * divisor[i].order / m_area;
    gradient.segment<2>(2 * i) << g.real(), g.imag();
  }
  return gradient;
}

Eigen::MatrixXd Area_distortion::greens_functions(const std::vector<Surface_point>& points) const
{
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(m_mass.size(), points.size());
  for (std::size_t a = 0; a < points.size(); ++a) add_charge(m_t, points[a], 1, b.col(a));
  return solve(std::move(b));
}

Charge_changes::Charge_changes(const Area_distortion& distortion, const Eigen::VectorXd& u, const Eigen::MatrixXd& greens)
  : m_area(distortion.mass().sum())
{
  const Eigen::MatrixXd weighted = distortion.mass().asDiagonal() * greens;
  m_linear = weighted.transpose() * u;
  m_quadratic = weighted.transpose() * greens;
}

double Charge_changes::of_pair(Eigen::Index a, Eigen::Index b, double qa) const
{
  return (2 * qa * (m_linear[a] - m_linear[b])
          + qa * qa * (m_quadratic(a, a) + m_quadratic(b, b) - 2 * m_quadratic(a, b))) / m_area;
}

double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double share)
{
  std::vector<Eigen::Index> order(values.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return values[a] < values[b]; });
  const double wanted = share * weights.sum();
  double sum = 0;
  for (Eigen::Index k : order)
    if ((sum += weights[k]) >= wanted) return values[k];
  return values[order.back()];
}

double area_scale_ratio(const Eigen::VectorXd& u, const Eigen::VectorXd& mass)
{
  return std::exp(2 * (weighted_quantile(u, mass, 0.99) - weighted_quantile(u, mass, 0.01)));
}

} } // namespace CGAL::Quartic_differentials
