// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/multipatch.h>

#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/Boundary_ways.h>
#include <CGAL/Quartic_differentials/internal/Cubic_basis.h>
#include <CGAL/Quartic_differentials/internal/Distance_sum.h>
#include <CGAL/Quartic_differentials/internal/Input_surface.h>
#include <CGAL/Quartic_differentials/internal/Nearest_boundary_point.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Cubic_basis;
using internal::Input_surface;
// one coordinate by sample or control point, along u and along v
using Coordinate = Eigen::MatrixXd;
using Coordinates = std::array<Coordinate, 3>;

const int intervals = 4;   // of a span, between the samples that are fitted

// along a side, as patches have them
Eigen::VectorXd on_side(const Coordinate& x, int side)
{
  switch (side) {
    case 0:  return x.col(0);
    case 1:  return x.row(x.rows() - 1);
    case 2:  return x.col(x.cols() - 1).reverse();
    default: return x.row(0).reverse();
  }
}

void set_on_side(Coordinate& x, int side, const Eigen::VectorXd& values)
{
  switch (side) {
    case 0:  x.col(0) = values; break;
    case 1:  x.row(x.rows() - 1) = values; break;
    case 2:  x.col(x.cols() - 1) = values.reverse(); break;
    default: x.row(0) = values.reverse();
  }
}

// Least squares along n spans with the first and the last control point given; factorised once.
class Span_fit
{
public:
  explicit Span_fit(std::size_t n) : m_values(intervals * n + 1, n + 3)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < m_values.rows(); ++i) {
      const Cubic_basis b(n, static_cast<double>(i) / intervals);
      for (std::size_t k = 0; k < 4; ++k) entries.emplace_back(i, b.first + k, b.value[k]);
    }
    m_values.setFromTriplets(entries.begin(), entries.end());
    m_inner = m_values.block(1, 1, m_values.rows() - 2, m_values.cols() - 2);
    m_normal_equations.compute(m_inner.transpose() * m_inner);
  }

  // the values of the B-splines, by sample and control point
  const Eigen::SparseMatrix<double>& values() const { return m_values; }

  // by columns: the inner control points that fit the inner samples, where the others are 0
  Eigen::MatrixXd inner(const Eigen::MatrixXd& samples) const
  { return m_normal_equations.solve(m_inner.transpose() * samples); }

  Eigen::VectorXd curve(const Eigen::VectorXd& samples) const
  {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(m_values.cols());
    x[0] = samples[0];
    x[x.size() - 1] = samples[samples.size() - 1];
    const Eigen::VectorXd rest = samples - m_values * x;
    x.segment(1, x.size() - 2) = inner(rest.segment(1, rest.size() - 2));
    return x;
  }

private:
  using Banded = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;

  Eigen::SparseMatrix<double> m_values, m_inner;
  Banded                      m_normal_equations;
};

class Layout_fit
{
public:
  Layout_fit(const Intrinsic_triangulation& input, const Mesh& quads)
    : m_input(input), m_quads(quads), m_layout(quad_layout(quads))
  {
    if (!m_layout.boundary.empty() && !input.has_boundary())
      throw Unusable_surface_error("the quad mesh has a boundary, but not the surface to which splines are fitted");
    for (const Quad_layout::Patch& p : m_layout.patches) {
      m_samples.push_back(samples(p));
      m_control.push_back(zero(p.size[0] + 3, p.size[1] + 3));
    }
    if (!m_layout.boundary.empty()) follow_boundary(input);
    for (const Quad_layout::Interface& i : m_layout.interfaces) fit_sides(i);
    for (const Quad_layout::Side& s : m_layout.boundary) fit_side(s);
    for (std::size_t p = 0; p < m_layout.patches.size(); ++p) fit_inside(p);
  }

  Multipatch multipatch() const
  {
    Multipatch result;
    result.interfaces = m_layout.interfaces;
    result.boundary = m_layout.boundary;
    for (std::size_t p = 0; p < m_layout.patches.size(); ++p) {
      Multipatch::Patch patch{m_layout.patches[p].size, {}, {}};
      const auto& [x, y, z] = m_control[p];
      for (Eigen::Index i = 0; i < x.size(); ++i) patch.control_points.emplace_back(x(i), y(i), z(i));
      for (Halfedge h : m_layout.patches[p].quads) patch.quads.push_back(m_quads.face(h));
      result.patches.push_back(std::move(patch));
    }
    return result;
  }

private:
  static Coordinates zero(std::size_t n_u, std::size_t n_v)
  {
    const Coordinate x = Coordinate::Zero(n_u, n_v);
    return {x, x, x};
  }

  // Vertices stay as they are, so that all patches round them agree; the points between them move to the surface.
  Coordinates samples(const Quad_layout::Patch& patch) const
  {
    const std::vector<Vertex> v = grid_vertices(m_quads, patch);
    const auto [n_u, n_v] = patch.size;
    Coordinates result = zero(intervals * n_u + 1, intervals * n_v + 1);
    Input_surface::Place place = m_input.nearest(m_quads.point(v[0]));
    for (std::size_t j = 0; j <= intervals * n_v; ++j)
      for (std::size_t i = 0; i <= intervals * n_u; ++i) {
        const std::size_t column = std::min(i / intervals, n_u - 1), row = std::min(j / intervals, n_v - 1);
        const Vertex* const corner = &v[row * (n_u + 1) + column];
        const double s = double(i) / intervals - double(column), t = double(j) / intervals - double(row);
        const Point_3 q = between(between(corner[0], corner[1], s), between(corner[n_u + 1], corner[n_u + 2], s), t);
        place = m_input.nearest(q, place);
        const bool is_vertex = i % intervals == 0 && j % intervals == 0;
        for (int k = 0; k < 3; ++k) result[k](i, j) = is_vertex ? q[k] : place.point[k];
      }
    return result;
  }

  Point_3 between(Vertex v, Vertex w, double t) const { return between(m_quads.point(v), m_quads.point(w), t); }
  // exact at both ends
  static Point_3 between(const Point_3& p, const Point_3& q, double t)
  { return {(1 - t) * p.x() + t * q.x(), (1 - t) * p.y() + t * q.y(), (1 - t) * p.z() + t * q.z()}; }

  // On the boundary, the points between two vertices divide the way along the surface's boundary.
  void follow_boundary(const Intrinsic_triangulation& input)
  {
    const internal::Nearest_boundary_point nearest(input);
    const internal::Boundary_ways ways(input);
    for (const Quad_layout::Side& s : m_layout.boundary) {
      std::array<Eigen::VectorXd, 3> x;
      for (int k = 0; k < 3; ++k) x[k] = on_side(m_samples[s.patch][k], s.side);
      const auto vertex = [&](Eigen::Index i) { return nearest(Point_3(x[0][i], x[1][i], x[2][i])); };
      for (Eigen::Index begin = 0; begin + 1 < x[0].size(); begin += intervals) {
        const Surface_point from = vertex(begin);
        const double way = ways.length(from, vertex(begin + intervals));
        for (int i = 1; i < intervals; ++i) {
          const Point_3 p = position_on_input(input, ways.slid(from, way * i / intervals));
          for (int k = 0; k < 3; ++k) x[k][begin + i] = p[k];
        }
      }
      for (int k = 0; k < 3; ++k) set_on_side(m_samples[s.patch][k], s.side, x[k]);
    }
  }

  const Span_fit& fit(std::size_t n) { return m_fits.try_emplace(n, n).first->second; }

  void fit_side(const Quad_layout::Side& s)
  {
    const Span_fit& along = fit(m_layout.patches[s.patch].size[s.side % 2]);
    for (int k = 0; k < 3; ++k)
      set_on_side(m_control[s.patch][k], s.side, along.curve(on_side(m_samples[s.patch][k], s.side)));
  }

  void fit_sides(const Quad_layout::Interface& i)
  {
    fit_side(i.first);
    for (int k = 0; k < 3; ++k) {
      const Eigen::VectorXd x = on_side(m_control[i.first.patch][k], i.first.side);
      set_on_side(m_control[i.second.patch][k], i.second.side, x.reverse());
    }
  }

  void fit_inside(std::size_t p)
  {
    const Span_fit& u = fit(m_layout.patches[p].size[0]);
    const Span_fit& v = fit(m_layout.patches[p].size[1]);
    for (int k = 0; k < 3; ++k) {
      Coordinate& x = m_control[p][k];
      const Coordinate rest = m_samples[p][k] - u.values() * x * v.values().transpose();
      const Coordinate along_u = u.inner(rest.block(1, 1, rest.rows() - 2, rest.cols() - 2));
      x.block(1, 1, x.rows() - 2, x.cols() - 2) = v.inner(along_u.transpose()).transpose();
    }
  }

  const Input_surface             m_input;
  const Mesh&                     m_quads;
  const Quad_layout               m_layout;
  std::vector<Coordinates>        m_samples, m_control;   // by patch
  std::map<std::size_t, Span_fit> m_fits;                 // by number of spans
};

} // namespace

Multipatch multipatch(const Intrinsic_triangulation& input, const Mesh& quads)
{
  return Layout_fit(input, quads).multipatch();
}

std::vector<Point_3> control_points(const Multipatch::Patch& patch, int side)
{
  const std::size_t columns = patch.spans[0] + 3, n = patch.spans[side % 2] + 3, last = patch.control_points.size() - 1;
  std::vector<Point_3> result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t at[] = {i, (i + 1) * columns - 1, last - i, last + 1 - (i + 1) * columns};
    result.push_back(patch.control_points[at[side]]);
  }
  return result;
}

std::string defect(const Multipatch& m)
{
  std::vector<std::array<int, 4>> uses(m.patches.size(), {0, 0, 0, 0});   // by side
  for (std::size_t p = 0; p < m.patches.size(); ++p) {
    const auto [n_u, n_v] = m.patches[p].spans;
    if (n_u == 0 || n_v == 0 || m.patches[p].control_points.size() != (n_u + 3) * (n_v + 3)
        || m.patches[p].quads.size() != n_u * n_v)
      return "the sizes of patch " + std::to_string(p) + " do not fit";
  }
  const auto exists = [&](const Multipatch::Side& s) { return s.patch < m.patches.size() && 0 <= s.side && s.side < 4; };
  for (const Multipatch::Interface& i : m.interfaces) {
    for (const Multipatch::Side& s : {i.first, i.second}) {
      if (!exists(s)) return "an interface has a side that does not exist";
      ++uses[s.patch][s.side];
    }
    const std::vector<Point_3> first = control_points(m.patches[i.first.patch], i.first.side);
    const std::vector<Point_3> second = control_points(m.patches[i.second.patch], i.second.side);
    if (!std::equal(first.begin(), first.end(), second.rbegin(), second.rend()))
      return "patches " + std::to_string(i.first.patch) + " and " + std::to_string(i.second.patch) + " do not meet";
  }
  for (const Multipatch::Side& s : m.boundary) {
    if (!exists(s)) return "the boundary has a side that does not exist";
    ++uses[s.patch][s.side];
  }
  for (std::size_t p = 0; p < m.patches.size(); ++p)
    for (int k = 0; k < 4; ++k)
      if (uses[p][k] != 1)
        return "side " + std::to_string(k) + " of patch " + std::to_string(p) + " is on "
               + std::to_string(uses[p][k]) + " interfaces or parts of the boundary";
  return {};
}

Spline_point evaluate(const Multipatch::Patch& patch, double u, double v)
{
  const Cubic_basis along_u(patch.spans[0], u), along_v(patch.spans[1], v);
  Vector_3 p(0, 0, 0), d_u = p, d_v = p;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector_3 x = patch.control_points[(along_v.first + j) * (patch.spans[0] + 3) + along_u.first + i]
                         - CGAL::ORIGIN;
      p += along_u.value[i] * along_v.value[j] * x;
      d_u += along_u.derivative[i] * along_v.value[j] * x;
      d_v += along_u.value[i] * along_v.derivative[j] * x;
    }
  return {CGAL::ORIGIN + p, d_u, d_v};
}

Multipatch_quality multipatch_quality(const Intrinsic_triangulation& input, const Multipatch& m)
{
  const Input_surface surface(input);
  internal::Distance_sum distances;
  double least_sine = 1, sum_of_sines = 0, points = 0;
  for (const Multipatch::Patch& patch : m.patches) {
    Input_surface::Place place = surface.nearest(patch.control_points[0]);
    for (std::size_t j = 0; j < intervals * patch.spans[1]; ++j)
      for (std::size_t i = 0; i < intervals * patch.spans[0]; ++i) {
        const Spline_point s = evaluate(patch, (double(i) + 0.5) / intervals, (double(j) + 0.5) / intervals);
        place = surface.nearest(s.point, place);
        const Vector_3 normal = CGAL::cross_product(s.along_u, s.along_v);
        const double area = std::sqrt(normal.squared_length());
        const double sine = area / std::sqrt(s.along_u.squared_length() * s.along_v.squared_length());
        const double signed_sine = normal * place.normal < 0 ? -sine : sine;
        distances.add(CGAL::squared_distance(s.point, place.point), area);
        least_sine = std::min(least_sine, signed_sine);
        sum_of_sines += signed_sine;
        ++points;
      }
  }
  return {distances.by_diagonal(input.mesh()), least_sine, sum_of_sines / points};
}

} } // namespace CGAL::Quartic_differentials
