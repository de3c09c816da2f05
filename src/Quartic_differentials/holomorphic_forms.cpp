// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;
const double pi = CGAL_PI;

using Row_matrix = Harmonic_1_forms::Row_matrix;

// d^T W eta at every vertex: the flux of the cochains out of it. They are 0 almost everywhere.
Row_matrix divergence(const Intrinsic_triangulation& t, const std::vector<double>& weights,
                      const Integer_cochains& cochains)
{
  Row_matrix flux = Row_matrix::Zero(t.number_of_vertices(), cochains.size());
  for (Edge e : t.edges()) {
    const auto eta = cochains.values().row(e);
    if (eta.isZero()) continue;
    const Halfedge h = t.halfedge(e);
    flux.row(t.source(h)) -= weights[e] * eta.cast<double>();
    flux.row(t.target(h)) += weights[e] * eta.cast<double>();
  }
  return flux;
}

// omega = eta + dg on every edge, and what follows from it, in one pass over the edges: all are large
void add_forms(const Intrinsic_triangulation& t, const Integer_cochains& cochains, const std::vector<double>& weights,
               Harmonic_1_forms& forms)
{
  const int n = cochains.size();
  const Eigen::Index edges = static_cast<Eigen::Index>(t.number_of_edges()), most = 512;
  Row_matrix flux = Row_matrix::Zero(t.number_of_vertices(), n), weighted(most, n);
  forms.by_edge.resize(edges, n);
  forms.dirichlet = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index first = 0; first < edges; first += most) {
    const Eigen::Index size = std::min(most, edges - first);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Edge e(static_cast<Mesh::size_type>(first + i));
      const Halfedge h = t.halfedge(e);
      const auto eta = cochains.values().row(e);
      const auto g_source = forms.potential.row(t.source(h)), g_target = forms.potential.row(t.target(h));
      auto omega = forms.by_edge.row(e), w_omega = weighted.row(i);
      auto out = flux.row(t.source(h)), in = flux.row(t.target(h));
      for (int k = 0; k < n; ++k) {
        omega[k] = eta[k] + (g_target[k] - g_source[k]);
        w_omega[k] = weights[e] * omega[k];
        out[k] -= w_omega[k];
        in[k] += w_omega[k];
      }
    }
    forms.dirichlet.noalias() += forms.by_edge.middleRows(first, size).transpose() * weighted.topRows(size);
  }
  forms.dirichlet = (0.5 * (forms.dirichlet + forms.dirichlet.transpose())).eval();
  forms.residual = n == 0 ? 0 : flux.cwiseAbs().maxCoeff();
}

// A closed 1-form by halfedge with the sign of its values decided everywhere: an exact zero is positive on the even
// halfedge of its edge, so that the form keeps its antisymmetry.
class Signed_form
{
public:
  Signed_form(const Harmonic_1_forms& forms, const Eigen::VectorXd& coefficients) : m_value(forms.by_edge * coefficients) {}
  double operator()(Halfedge h) const { return h.idx() % 2 == 0 ? m_value[h.idx() / 2] : -m_value[h.idx() / 2]; }
  bool is_positive(Halfedge h) const
  {
    const double x = (*this)(h);
    return x > 0 || (x == 0 && h.idx() % 2 == 0);
  }
private:
  Eigen::VectorXd m_value;
};

// The index of the form at every vertex, 1 - (sign changes round it)/2. Round the source of h the opposite of prev(h) comes
// next: the sign changes where h and prev(h) have the same.
std::vector<int> vertex_indices(const Intrinsic_triangulation& t, const Signed_form& form)
{
  std::vector<int> index(t.number_of_vertices(), 0);   // the number of changes, first
  for (Face f : t.faces())
    for (Halfedge h : t.halfedges(f)) index[t.source(h)] += form.is_positive(h) == form.is_positive(t.prev(h));
  for (int& i : index) i = 1 - i / 2;
  return index;
}

int face_index(const Intrinsic_triangulation& t, const Signed_form& form, Face f)
{
  int changes = 0;
  for (Halfedge h : t.halfedges(f)) changes += form.is_positive(h) != form.is_positive(t.next(h));
  return 1 - changes / 2;
}

template <class Form>
Complex gradient(const Intrinsic_triangulation& t, const Form& form, Face f)
{
  const auto h = t.halfedges(f);
  const auto z = t.unfolded(f);
  const double gx = form(h[0]) / z[1].real();
  return {gx, (-form(h[2]) - gx * z[2].real()) / z[2].imag()};
}

// The zero of a + b z fitted to the form re + i im in the faces round v, z the flattened 1-ring (angles scaled to 2 pi).
template <class Form>
Surface_point refined_zero(const Intrinsic_triangulation& t, const Signed_form& re, const Form& im, Vertex v)
{
  const std::vector<internal::Star_corner> star = internal::star(t, v);
  const double scale = 2 * pi / star.back().end_angle;
  Eigen::MatrixX2cd a(star.size(), 2);
  Eigen::VectorXcd b(star.size());
  for (std::size_t i = 0; i < star.size(); ++i) {
    const internal::Star_corner& c = star[i];
    const Face f = t.face(c.halfedge);
    // the form is h dz in the face's frame: Re(h dz) = re, Im(h dz) = im
    const Complex h = 0.5 * (std::conj(gradient(t, re, f)) + Complex(0, 1) * std::conj(gradient(t, im, f)));
    const double middle = 0.5 * (c.begin_angle + c.end_angle);
    const double rotation = scale * middle - (c.frame_angle + 0.5 * (c.end_angle - c.begin_angle));
    const Complex centroid = (std::polar(t.length(c.halfedge), scale * c.begin_angle)
                            + std::polar(t.length(t.prev(c.halfedge)), scale * c.end_angle)) / 3.0;
    a.row(i) << 1.0, centroid;
    b[i] = h * std::polar(1.0, -rotation);
  }
  const Eigen::Vector2cd fit = a.colPivHouseholderQr().solve(b);
  Complex zero = -fit[0] / fit[1];
  const double farthest = 3 * t.length(star.front().halfedge);
  if (!(std::abs(zero) <= farthest)) zero = std::isfinite(std::abs(zero)) ? zero / std::abs(zero) * farthest : 0.0;

  double angle = std::arg(zero) / scale;
  if (angle < 0) angle += star.back().end_angle;
  return internal::walk_from_vertex(t, star, angle, std::abs(zero));
}

} // namespace

Harmonic_1_forms harmonic_1_forms(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                  const std::vector<double>& weights, const Laplacian_solver& laplacian)
{
  Harmonic_1_forms forms;
  forms.potential = laplacian.solve(-divergence(t, weights, cochains));
  add_forms(t, cochains, weights, forms);
  return forms;
}

Eigen::RowVectorXcd gradients(const Intrinsic_triangulation& t, const Harmonic_1_forms& forms, Face f)
{
  const auto h = t.halfedges(f);
  const auto z = t.unfolded(f);
  const Eigen::RowVectorXd gx = forms.row(h[0]) / z[1].real();
  const Eigen::RowVectorXd gy = (-forms.row(h[2]) - gx * z[2].real()) / z[2].imag();
  return gx.cast<Complex>() + Complex(0, 1) * gy.cast<Complex>();
}

std::vector<Holomorphic_zero> zeros_of_holomorphic_form(const Intrinsic_triangulation& t, const Harmonic_1_forms& forms,
                                                        const Eigen::VectorXd& coefficients, const Eigen::MatrixXd& star)
{
  const Signed_form re(forms, coefficients);
  const Eigen::VectorXd conjugate = star * coefficients;
  const auto im = [&](Halfedge h) -> double { return forms.row(h) * conjugate; };   // needed round zeros only
  std::vector<Holomorphic_zero> zeros;
  const std::vector<int> indices = vertex_indices(t, re);
  for (Vertex v : t.vertices()) {
    const int index = indices[v];
    if (index == 0) continue;
    zeros.push_back({v, -index, index == -1 ? refined_zero(t, re, im, v) : at_vertex(t, v)});
  }
  for (Face f : t.faces())
    if (const int index = face_index(t, re, f); index != 0)
      zeros.push_back({Mesh::null_vertex(), -index, {f, {1 / 3., 1 / 3., 1 / 3.}}});
  return zeros;
}

} } // namespace CGAL::Quartic_differentials
