// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/cone_insertion.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

using Complex = std::complex<double>;

// the third corner of a triangle with the given corners, with the k-th one at 0 and the next on the positive real axis
Complex apex_over(const std::array<Complex, 3>& corner, int k)
{
  const Complex side = corner[(k + 1) % 3] - corner[k];
  return (corner[(k + 2) % 3] - corner[k]) * std::conj(side) / std::abs(side);
}

// the angle at source(h) in face(h)
double angle_at_source(const Intrinsic_triangulation& t, Halfedge h)
{
  const double out = t.length(h), in = t.length(t.prev(h)), across = t.length(t.next(h));
  return std::atan2(four_times_area(out, in, across), twice_scalar_product(across, out, in));
}

// The piece that holds z, with the barycentric coordinates of z in it.
std::pair<std::size_t, std::array<double, 3>> piece_at(const std::vector<Face_piece>& pieces, Complex z)
{
  std::size_t best = 0;
  std::array<double, 3> best_b{};
  double best_least = -1e300;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::array<double, 3> b = barycentric(pieces[k].corner, z);
    const double least = *std::min_element(b.begin(), b.end());
    if (least > best_least) { best_least = least; best = k; best_b = b; }
  }
  return {best, best_b};
}

// The piece whose corners, from source(h), are given; a face numbers its corners from its own first halfedge.
Face_piece piece_with(const Intrinsic_triangulation& t, Halfedge h, const std::array<Complex, 3>& corner,
                      const std::array<int, 3>& name)
{
  Face_piece piece{t.face(h), {}, {}};
  for (int k = 0; k < 3; ++k) {
    piece.corner[(t.corner(h) + k) % 3] = corner[k];
    piece.name[(t.corner(h) + k) % 3] = name[k];
  }
  return piece;
}

// The piece, and its side, that holds the point at the given fraction of a boundary edge from `from` to `to`.
std::pair<std::size_t, Halfedge> piece_on_boundary(const Intrinsic_triangulation& t, const std::vector<Face_piece>& pieces,
                                                   Complex from, Complex to, double fraction)
{
  const double on_line = 1e-9;   // the pieces' corners on the edge are rounded
  std::pair<std::size_t, Halfedge> best{0, Mesh::null_halfedge()};
  double best_inside = -1e300;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (Halfedge h : t.halfedges(pieces[k].face)) {
      const int c = t.corner(h);
      const Complex begin = (pieces[k].corner[c] - from) / (to - from);
      const Complex end = (pieces[k].corner[(c + 1) % 3] - from) / (to - from);
      if (!t.is_border(t.opposite(h)) || std::abs(begin.imag()) > on_line || std::abs(end.imag()) > on_line) continue;
      const double inside = std::min(fraction - begin.real(), end.real() - fraction);
      if (inside > best_inside) {
        best_inside = inside;
        best = {k, h};
      }
    }
  return best;
}

} // namespace

double Piece_places::diagonal(const Intrinsic_triangulation& t, Halfedge h) const
{
  const Halfedge o = t.opposite(h);
  const auto own = m_corners.find(t.face(h)), other = m_corners.find(t.face(o));
  if (own == m_corners.end() && other == m_corners.end()) return other_diagonal(t, h, euclidean_diagonal<double>);
  const auto apex = [&](Halfedge k, auto place) {
    return apex_over(place == m_corners.end() ? t.unfolded(t.face(k)) : place->second, t.corner(k));
  };
  return std::abs(apex(h, own) + apex(o, other) - t.length(h));
}

void Piece_places::before_flip(const Intrinsic_triangulation& t, const Edge_flip& flip)
{
  m_corners.erase(t.face(flip.ij));
  m_corners.erase(t.face(flip.ji));
}

void Cone_frames::before_flip(const Intrinsic_triangulation& t, const Edge_flip& flip)
{
  for (Cone_frame& f : m_frames)
    if (f.reference == flip.ij || f.reference == flip.ji) {
      f.angle += angle_at_source(t, f.reference);
      f.reference = t.next_around_source(f.reference);
    }
}

Vertex vertex_at(const Intrinsic_triangulation& t, const Surface_point& p)
{
  const auto corner = t.unfolded(p.face);
  const auto h = t.halfedges(p.face);
  const Complex z = point_in_frame(corner, p.barycentric);
  for (int k = 0; k < 3; ++k)
    if (std::abs(z - corner[k]) < 1e-4 * std::min(t.length(h[k]), t.length(h[(k + 2) % 3]))) return t.source(h[k]);
  return Mesh::null_vertex();
}

Vertex vertex_at(const Intrinsic_triangulation& t, const Singularity& s)
{
  if (!s.on_boundary) return vertex_at(t, s.location);
  const Boundary_place place = boundary_place(t, s.location);
  if (place.fraction < 1e-4) return t.source(place.halfedge);
  return place.fraction > 1 - 1e-4 ? t.target(place.halfedge) : Mesh::null_vertex();
}

Point_inserter::Point_inserter(const Intrinsic_triangulation& t) : m_t(t), m_split(t)
{
  m_original.assign(t.faces().begin(), t.faces().end());
}

Point_inserter::Inserted Point_inserter::insert(const Surface_point& p)
{
  std::vector<Face_piece>& pieces = this->pieces(p.face);
  const Complex z = point_in_frame(m_t.unfolded(p.face), p.barycentric);
  const auto [k, b] = piece_at(pieces, z);
  const Face_piece whole = pieces[k];
  const auto insertion = m_split.insert({whole.face, b});
  m_original.resize(m_split.number_of_faces(), p.face);
  pieces.erase(pieces.begin() + k);
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3;   // the rim halfedge runs from v_c to v_next
    pieces.push_back(piece_with(m_split, insertion.rim[c], {whole.corner[c], whole.corner[next], z},
                                {whole.name[c], whole.name[next], 3 + m_inserted}));
  }
  ++m_inserted;
  return {insertion, std::arg(whole.corner[0] - z), whole.name};
}

Point_inserter::Inserted_on_boundary Point_inserter::insert_on_boundary(const Surface_point& p)
{
  const auto frame = m_t.unfolded(p.face);
  std::vector<Face_piece>& pieces = this->pieces(p.face);
  const auto [side, fraction] = boundary_place(m_t, p);
  const int along = m_t.corner(side);
  const auto [k, h] = piece_on_boundary(m_split, pieces, frame[along], frame[(along + 1) % 3], fraction);
  const Face_piece whole = pieces[k];
  const int a = m_split.corner(h), b = (a + 1) % 3, c = (a + 2) % 3;
  const Complex z = point_in_frame(frame, p.barycentric);
  const double at = std::abs(z - whole.corner[a]) / std::abs(whole.corner[b] - whole.corner[a]);
  const auto split = m_split.split_boundary_edge(h, at);
  m_original.resize(m_split.number_of_faces(), p.face);
  const int name = 3 + m_inserted++;
  pieces[k] = piece_with(m_split, split.first, {whole.corner[a], z, whole.corner[c]}, {whole.name[a], name, whole.name[c]});
  pieces.push_back(piece_with(m_split, split.second, {z, whole.corner[b], whole.corner[c]},
                              {name, whole.name[b], whole.name[c]}));
  return {split, {whole.name[a], whole.name[b], whole.name[c]}};
}

std::vector<Face_piece>& Point_inserter::pieces(Face f)
{
  return m_pieces.try_emplace(f, 1, Face_piece{f, m_t.unfolded(f), {0, 1, 2}}).first->second;
}

Piece_places Point_inserter::places() const
{
  std::map<Face, std::array<Complex, 3>> corners;
  for (const auto& [face, pieces] : m_pieces)
    for (const Face_piece& piece : pieces) corners.emplace(piece.face, piece.corner);
  return Piece_places(std::move(corners));
}

Inserted_cones insert_cones(const Intrinsic_triangulation& t, const Integer_cochains& cochains, const Divisor& divisor)
{
  Inserted_cones result{{}, cochains, {}, {}, {}};
  Point_inserter inserter(t);
  std::map<Vertex, std::size_t> taken;
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    const Surface_point& p = divisor[i].location;
    if (const Vertex v = vertex_at(t, divisor[i]); v != Mesh::null_vertex()) {
      if (t.is_border(v) && !divisor[i].on_boundary)
        throw Infeasible_divisor_error("singularity " + std::to_string(i + 1) + " is on the boundary, but not marked as a "
                                       "corner");
      const auto [other, is_new] = taken.emplace(v, i);
      if (!is_new) throw Infeasible_divisor_error("singularities " + std::to_string(other->second + 1) + " and "
                                                  + std::to_string(i + 1) + " are at the same vertex");
      result.cones.push_back(v);
      result.frozen.push_back(true);
      continue;
    }
    if (divisor[i].on_boundary) {
      const auto split = inserter.insert_on_boundary(p).split;
      result.cochains.after_boundary_split(inserter.triangulation(), split);
      result.cones.push_back(split.vertex);
      result.frozen.push_back(divisor[i].pinned);
      if (!divisor[i].pinned) result.frames.add({static_cast<int>(i), split.second, 0.0});
      continue;
    }
    const Point_inserter::Inserted inserted = inserter.insert(p);
    const Intrinsic_triangulation::Insertion& insertion = inserted.insertion;
    result.cochains.after_insertion(inserter.triangulation(), insertion);
    result.cones.push_back(insertion.vertex);
    result.frozen.push_back(divisor[i].pinned);
    if (!divisor[i].pinned) result.frames.add({static_cast<int>(i), insertion.spoke[0], inserted.angle});
  }
  const Piece_places places = inserter.places();
  result.triangulation = std::move(inserter).triangulation();
  make_delaunay_by_places(result.triangulation, places, result.cochains, result.frames);
  return result;
}

Length_derivatives::Length_derivatives(const Intrinsic_triangulation& t, const Cone_frames& frames)
  : m_row(t.number_of_edges())
{
  for (const Cone_frame& frame : frames.frames()) {
    const bool slides = t.is_border(t.source(frame.reference));
    double angle = frame.angle;
    Halfedge h = frame.reference;
    do {
      const Eigen::Vector2d derivative = -Eigen::Vector2d(std::cos(angle), slides ? 0.0 : std::sin(angle)) / t.length(h);
      Row& row = m_row[t.edge(h)];
      if (!row.empty() && row.back().first == frame.singularity) row.back().second += derivative;   // a loop at the cone
      else row.emplace_back(frame.singularity, derivative);
      if (!t.is_border(h)) angle += angle_at_source(t, h);
      h = t.next_around_source(h);
    } while (h != frame.reference);
  }
}

void Length_derivatives::before_flip(const Intrinsic_triangulation& t, const Edge_flip& f)
{
  const double a = t.length(f.jk) * t.length(f.il), b = t.length(f.ki) * t.length(f.lj);
  const std::pair<Halfedge, double> terms[] = {{f.ij, -1}, {f.jk, a / (a + b)}, {f.il, a / (a + b)},
                                               {f.ki, b / (a + b)}, {f.lj, b / (a + b)}};
  Row sum;
  for (const auto& [h, factor] : terms)
    for (const auto& [i, derivative] : m_row[t.edge(h)]) {
      const auto at = std::lower_bound(sum.begin(), sum.end(), i, [](const auto& entry, int k) { return entry.first < k; });
      if (at != sum.end() && at->first == i) at->second += factor * derivative;
      else sum.emplace(at, i, factor * derivative);
    }
  m_row[f.edge] = std::move(sum);
}

// dT_k = Sum_f omega_k(h0) dtheta_1 - omega_k(h2) dtheta_2 with omega harmonic in the flat metric, and
// dtheta_i = (cot theta_j + cot theta_k) lambda_jk - cot theta_j lambda_ij - cot theta_k lambda_ik (METHOD, step 6).
Eigen::MatrixXd turning_derivative(const Intrinsic_triangulation& t, const std::vector<double>& angles,
                                   const Length_derivatives& lambda, std::size_t cones, const Harmonic_1_forms& omega)
{
  Eigen::MatrixXd j = Eigen::MatrixXd::Zero(omega.size(), 2 * cones);
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    if (lambda[t.edge(h[0])].empty() && lambda[t.edge(h[1])].empty() && lambda[t.edge(h[2])].empty()) continue;
    const double c[3] = {1 / std::tan(angles[h[0]]), 1 / std::tan(angles[h[1]]), 1 / std::tan(angles[h[2]])};
    const double dtheta_1[3] = {-c[0], -c[2], c[2] + c[0]}, dtheta_2[3] = {c[0] + c[1], -c[1], -c[0]};
    const Eigen::VectorXd omega_0 = omega.row(h[0]), omega_2 = omega.row(h[2]);
    for (int k = 0; k < 3; ++k)
      for (const auto& [i, derivative] : lambda[t.edge(h[k])])
        j.middleCols(2 * i, 2) += (omega_0 * dtheta_1[k] - omega_2 * dtheta_2[k]) * derivative.transpose();
  }
  return j;
}

Eigen::VectorXd curvature_change(const Intrinsic_triangulation& t, const std::vector<double>& angles,
                                 const Length_derivatives& lambda, const Eigen::VectorXd& displacement)
{
  Eigen::VectorXd change = Eigen::VectorXd::Zero(t.number_of_vertices());
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    double dlog[3] = {0, 0, 0}, cot[3];
    for (int k = 0; k < 3; ++k)
      for (const auto& [i, derivative] : lambda[t.edge(h[k])]) dlog[k] += derivative.dot(displacement.segment<2>(2 * i));
    if (dlog[0] == 0 && dlog[1] == 0 && dlog[2] == 0) continue;
    for (int k = 0; k < 3; ++k) cot[k] = 1 / std::tan(angles[h[k]]);
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      change[t.source(h[k])] -= (cot[i] + cot[j]) * dlog[i] - cot[i] * dlog[k] - cot[j] * dlog[j];   // dtheta at source(h_k)
    }
  }
  return change;
}

} } } // namespace CGAL::Quartic_differentials::internal
