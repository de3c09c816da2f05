// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <Eigen/Dense>

#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;
const double pi = CGAL_PI;

// d^T W omega at every vertex: the flux of the form out of it.
Harmonic_1_forms::Row_matrix divergence(const Intrinsic_triangulation& t, const std::vector<double>& weights,
                                        const Harmonic_1_forms::Row_matrix& by_edge)
{
  Harmonic_1_forms::Row_matrix flux = Harmonic_1_forms::Row_matrix::Zero(t.number_of_vertices(), by_edge.cols());
  for (Edge e : t.edges()) {
    const auto form = by_edge.row(e);
    if (form.isZero(0)) continue;   // as cochains are almost everywhere
    const Halfedge h = t.halfedge(e);
    flux.row(t.source(h)) -= weights[e] * form;
    flux.row(t.target(h)) += weights[e] * form;
  }
  return flux;
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

int vertex_index(const Intrinsic_triangulation& t, const Signed_form& form, Vertex v)
{
  int changes = 0;
  const Halfedge first = t.halfedge_from(v);
  Halfedge h = first;
  do {
    const Halfedge n = t.next_around_source(h);
    changes += form.is_positive(h) != form.is_positive(n);
    h = n;
  } while (h != first);
  return 1 - changes / 2;
}

int face_index(const Intrinsic_triangulation& t, const Signed_form& form, Face f)
{
  int changes = 0;
  for (Halfedge h : t.halfedges(f)) changes += form.is_positive(h) != form.is_positive(t.next(h));
  return 1 - changes / 2;
}

Complex gradient(const Intrinsic_triangulation& t, const Signed_form& form, Face f)
{
  const auto h = t.halfedges(f);
  const auto z = t.unfolded(f);
  const double gx = form(h[0]) / z[1].real();
  return {gx, (-form(h[2]) - gx * z[2].real()) / z[2].imag()};
}

// The zero of a + b z fitted to the form re + i im in the faces round v, z the flattened 1-ring (angles scaled to 2 pi).
Surface_point refined_zero(const Intrinsic_triangulation& t, const Signed_form& re, const Signed_form& im, Vertex v)
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
  forms.by_edge = cochains.values().cast<double>();
  forms.potential = laplacian.solve(-divergence(t, weights, forms.by_edge));
  Harmonic_1_forms::Row_matrix weighted(forms.by_edge.rows(), forms.by_edge.cols());
  for (Edge e : t.edges()) {
    const Halfedge h = t.halfedge(e);
    forms.by_edge.row(e) += forms.potential.row(t.target(h)) - forms.potential.row(t.source(h));
    weighted.row(e) = weights[e] * forms.by_edge.row(e);
  }
  forms.dirichlet = forms.by_edge.transpose() * weighted;
  forms.dirichlet = (0.5 * (forms.dirichlet + forms.dirichlet.transpose())).eval();
  forms.residual = forms.size() == 0 ? 0 : divergence(t, weights, forms.by_edge).cwiseAbs().maxCoeff();
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
  const Signed_form re(forms, coefficients), im(forms, star * coefficients);
  std::vector<Holomorphic_zero> zeros;
  for (Vertex v : t.vertices()) {
    const int index = vertex_index(t, re, v);
    if (index == 0) continue;
    const Halfedge h = t.halfedge_from(v);
    Surface_point p{t.face(h), {0, 0, 0}};
    p.barycentric[t.corner(h)] = 1;
    if (index == -1) p = refined_zero(t, re, im, v);
    zeros.push_back({v, -index, p});
  }
  for (Face f : t.faces())
    if (const int index = face_index(t, re, f); index != 0)
      zeros.push_back({Mesh::null_vertex(), -index, {f, {1 / 3., 1 / 3., 1 / 3.}}});
  return zeros;
}

} } // namespace CGAL::Quartic_differentials
