// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/Refinement_cells.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/cone_insertion.h>
#include <CGAL/Quartic_differentials/internal/flat_metric_errors.h>
#include <CGAL/Quartic_differentials/internal/flip_towards_input.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/refined_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using Complex = std::complex<double>;
using internal::moved_inside;
const double inside = 1e-9;   // the least barycentric coordinate of a cone in its face of the input

Complex in_units(Grid_vector z, int grid_exponent)
{
  return {std::ldexp(static_cast<double>(z.x), -grid_exponent), std::ldexp(static_cast<double>(z.y), -grid_exponent)};
}

// barycentric coordinates as a point of the plane in which the triangle is 0, 1, i
Complex affine(const std::array<double, 3>& b) { return {b[1], b[2]}; }

// the barycentric coordinates of a point in the plane of a triangle in space
std::array<double, 3> barycentric_in_space(const Point_3& p, const Point_3& a, const Point_3& b, const Point_3& c)
{
  const auto n = CGAL::cross_product(b - a, c - a);
  const double area = n.squared_length();
  const double b1 = CGAL::cross_product(p - a, c - a) * n / area, b2 = CGAL::cross_product(b - a, p - a) * n / area;
  return {1 - b1 - b2, b1, b2};
}

// Fills in where the corners are on the input.
void place_corners_on_input(const Intrinsic_triangulation& input, Refined_surface& r)
{
  const Intrinsic_triangulation& t = r.differential.triangulation;
  r.input_corner.resize(t.number_of_halfedges());
  r.faces_in = {input.number_of_faces(), t.number_of_faces(), [&](std::size_t f) { return r.input_face[f]; }};
  for (Face f : t.faces()) {
    const auto k = input.halfedges(r.input_face[f]);
    const auto corner = [&](int c) { return input.mesh().point(input.source(k[c])); };
    for (Halfedge h : t.halfedges(f)) {
      Surface_point p{r.input_face[f], barycentric_in_space(t.mesh().point(t.source(h)), corner(0), corner(1), corner(2))};
      r.input_corner[h] = moved_inside(p, 0).barycentric;
    }
  }
}

// A corner that was inserted on the boundary is on its boundary edge without rounding: the opposite coordinate is 0.
void put_corners_on_boundary(const Intrinsic_triangulation& input, Refined_surface& r)
{
  const Intrinsic_triangulation& t = r.differential.triangulation;
  for (Vertex v : r.differential.singularities) {
    if (v.idx() < input.number_of_vertices() || !t.is_border(v)) continue;
    const auto k = input.halfedges(r.input_face[t.face(t.halfedge_from(v))]);   // that of all faces round v
    std::array<double, 3>& place = r.input_corner[t.halfedge_from(v)];
    int opposite = -1;
    for (int c = 0; c < 3; ++c)
      if (input.is_border(input.opposite(k[(c + 1) % 3])) && (opposite < 0 || place[c] < place[opposite])) opposite = c;
    place[opposite] = 0;
    place = moved_inside({{}, place}, 0).barycentric;
    for (const internal::Star_corner& c : internal::star(t, v)) r.input_corner[c.halfedge] = place;
  }
}

// Numbers the vertices of the refinement: those of C, then the crossings edge by edge.
class Refined_vertices
{
public:
  Refined_vertices(const Intrinsic_triangulation& c, const Common_refinement& r) : m_c(c)
  {
    m_first.reserve(c.number_of_edges());
    std::size_t next = c.number_of_vertices();
    for (Edge e : c.edges()) {
      m_first.push_back(next);
      next += r.crossings(e).size();
    }
  }
  std::size_t operator()(const Cell_corner& k) const
  { return k.crossing.is_none() ? m_c.source(k.c).idx() : (*this)(k.crossing); }
  std::size_t operator()(Crossing_id x) const { return m_first[x.edge] + x.rank; }

private:
  const Intrinsic_triangulation& m_c;
  std::vector<std::size_t>       m_first;
};

// The positions along a C edge of its crossings, between 0 and 1, moved apart to a least gap where they are nearer.
std::vector<double> positions_along(const std::vector<Crossing>& crossings, double least_gap)
{
  std::vector<double> t;
  for (const Crossing& x : crossings) t.push_back(x.position_on_c());
  const double n = static_cast<double>(t.size()), gap = std::min(least_gap, 0.5 / (n + 1));
  for (std::size_t i = 0; i < t.size(); ++i)
    t[i] = std::max(t[i], (i == 0 ? 0 : t[i - 1]) + gap);
  for (std::size_t i = t.size(); i-- > 0;)
    t[i] = std::min(t[i], (i + 1 == t.size() ? 1 : t[i + 1]) - gap);
  return t;
}

Grid_vector on_segment(Grid_vector a, Grid_vector b, double t)
{
  return {a.x + std::llround(t * static_cast<double>(b.x - a.x)), a.y + std::llround(t * static_cast<double>(b.y - a.y))};
}

double length(Grid_vector v) { return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y)); }

// The smallest altitude of a triangle on the grid, negative if it is turned over.
double altitude(Grid_vector a, Grid_vector b, Grid_vector c)
{
  return static_cast<double>(doubled_area(a, b, c)) / std::max({length(b - a), length(c - b), length(a - c), 1.0});
}

// The grid points of the crossings, edge by edge, in the chart of the face of the edge's first halfedge.
std::vector<Grid_vector> crossing_points(const Common_refinement& refinement, const Quartic_differential& flat)
{
  const Intrinsic_triangulation& c = flat.triangulation;
  const double separation = 32;   // grid units, of the altitudes of the triangles between neighbouring points
  std::vector<Grid_vector> points;
  points.reserve(refinement.number_of_crossings());
  for (Edge e : c.edges()) {
    const std::vector<Crossing>& crossings = refinement.crossings(e);
    if (crossings.empty()) continue;
    const Halfedge h = c.halfedge(e), o = c.opposite(h);
    const auto apex_distance = [&](Halfedge k) {
      return altitude(flat.corner[k], flat.corner[c.next(k)], flat.corner[c.prev(k)]);
    };
    const double least_gap = separation / std::max(std::min(apex_distance(h), apex_distance(o)), 1.0);
    const Grid_vector begin = flat.corner[h], end = flat.corner[c.next(h)];
    for (double t : positions_along(crossings, least_gap)) points.push_back(on_segment(begin, end, t));
  }
  return points;
}

// Where a crossing in the flat metric is on its A edge in space.
Point_3 place_on_input(const Intrinsic_triangulation& a, const std::vector<double>& u, const Crossing& x)
{
  const Halfedge h = first_halfedge(x.a);
  const Vertex m = a.source(h), n = a.target(h);
  const double ratio = std::exp(u[n] - u[m]);   // only this matters
  const double s = x.sigma[1] * ratio / (x.sigma[0] + x.sigma[1] * ratio);
  const Point_3 &p = a.mesh().point(m), &q = a.mesh().point(n);
  return p + s * (q - p);
}

// The flat surface with the lengths its edges have in the plane, in grid units.
Quartic_differential in_the_plane(Quartic_differential flat)
{
  std::vector<double> lengths;
  lengths.reserve(flat.triangulation.number_of_edges());
  for (Edge e : flat.triangulation.edges()) {
    const Halfedge h = flat.triangulation.halfedge(e);
    lengths.push_back(length(flat.corner[flat.triangulation.next(h)] - flat.corner[h]));
  }
  flat.triangulation.set_lengths(std::move(lengths));
  return flat;
}

// Cuts polygons into triangles, from the corner pair that leaves the largest least altitude; polygons of cells have at
// most six corners.
class Polygon_cutter
{
public:
  using Triangle = std::array<std::size_t, 3>;   // numbers of corners

  // those of the last polygon are overwritten
  const std::vector<Triangle>& triangles(const std::vector<Grid_vector>& corner)
  {
    m_left.resize(corner.size());
    std::iota(m_left.begin(), m_left.end(), std::size_t(0));
    m_triangles.clear();
    while (m_left.size() > 3) {
      const std::size_t k = best_ear(corner), n = m_left.size();
      m_triangles.push_back({m_left[(k + n - 1) % n], m_left[k], m_left[(k + 1) % n]});
      m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(k));
    }
    m_triangles.push_back({m_left[0], m_left[1], m_left[2]});
    return m_triangles;
  }

private:
  static double altitude_at(const std::vector<Grid_vector>& corner, const std::vector<std::size_t>& left, std::size_t k)
  {
    const std::size_t n = left.size();
    return altitude(corner[left[(k + n - 1) % n]], corner[left[k]], corner[left[(k + 1) % n]]);
  }
  // the ear whose removal leaves the best worst ear, itself included
  std::size_t best_ear(const std::vector<Grid_vector>& corner)
  {
    std::size_t best = 0;
    double best_value = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < m_left.size(); ++k) {
      m_rest = m_left;
      m_rest.erase(m_rest.begin() + static_cast<std::ptrdiff_t>(k));
      double value = altitude_at(corner, m_left, k);
      if (m_rest.size() == 3) value = std::min(value, altitude_at(corner, m_rest, 0));
      if (value > best_value) { best_value = value; best = k; }
    }
    return best;
  }

  std::vector<std::size_t> m_left, m_rest;   // corners not cut off yet; the same without an ear
  std::vector<Triangle>    m_triangles;
};

// whether the side of a cell that starts on the C halfedge h runs along it to the next corner
bool lies_along(const Intrinsic_triangulation& c, Halfedge h, const Cell_corner& next)
{
  return next.crossing.is_none() ? next.c == c.next(h) : next.c == h;
}

using Inserted = std::pair<internal::Construction::Cone, internal::Cone_frame>;

Inserted inserted_cone(const Singularity& s, std::size_t i, internal::Point_inserter& inserter, Integer_cochains& cochains)
{
  const Surface_point p = moved_inside(s.location, inside);
  const auto [insertion, angle, end] = inserter.insert(p);
  const Intrinsic_triangulation& t = inserter.triangulation();
  cochains.after_insertion(t, insertion);
  const auto& spoke = insertion.spoke;
  return {{i, p, false, insertion.vertex, {t.edge(spoke[0]), t.edge(spoke[1]), t.edge(spoke[2])}, end},
          {static_cast<int>(i), spoke[0], angle}};
}

Inserted inserted_corner(const Singularity& s, std::size_t i, internal::Point_inserter& inserter, Integer_cochains& cochains)
{
  const auto [split, end] = inserter.insert_on_boundary(s.location);
  const Intrinsic_triangulation& t = inserter.triangulation();
  cochains.after_boundary_split(t, split);
  return {{i, s.location, true, split.vertex, {t.edge(split.first), t.edge(split.second), t.edge(split.spoke)}, end},
          {static_cast<int>(i), split.second, 0.0}};
}

} // namespace

Refined_cone_metric refined_cone_metric(const Intrinsic_triangulation& input, const Integer_cochains& cochains,
                                        const Divisor& divisor, const Cone_metric& metric)
{
  Refined_cone_metric r;
  r.cochains = cochains;
  internal::Point_inserter inserter(input);
  internal::Cone_frames frames;
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    if (metric.cones[i].idx() < input.number_of_vertices()) continue;
    const auto [cone, frame] = divisor[i].on_boundary ? inserted_corner(divisor[i], i, inserter, r.cochains)
                                                      : inserted_cone(divisor[i], i, inserter, r.cochains);
    r.construction.cones.push_back(cone);
    if (!divisor[i].pinned) frames.add(frame);
  }
  r.input_face = inserter.original_faces();
  const internal::Piece_places places = inserter.places();
  Intrinsic_triangulation a = std::move(inserter).triangulation();
  for (const auto& c : r.construction.cones)
    if (input.is_embedded()) a.set_point(c.vertex, position_on_input(input, c.location));
  r.triangulation = a;
  r.refinement = Common_refinement(std::move(a));
  make_delaunay_by_places(r.triangulation, places, r.refinement, r.cochains, frames, r.construction.flips);
  r.derivatives = internal::Length_derivatives(r.triangulation, frames);
  make_ideal_delaunay(r.triangulation, metric.u, r.refinement, r.cochains, r.derivatives, r.construction.flips);
  r.lengths.reserve(r.triangulation.number_of_edges());
  for (Edge e : r.triangulation.edges()) {
    const Halfedge h = r.triangulation.halfedge(e);
    r.lengths.push_back(r.triangulation.length(e) * std::exp(0.5 * (metric.u[r.triangulation.source(h)]
                                                                   + metric.u[r.triangulation.target(h)])));
  }
  auto errors = internal::flat_metric_errors(r.triangulation, r.cochains, metric.order, r.lengths);
  r.precision.max_curvature_error = internal::largest(errors.curvature);
  r.precision.max_holonomy_error = internal::largest(errors.turning);
  r.precision.max_transition_error = internal::max_transition_error(r.triangulation, errors.angles);
  r.precision.curvature_error = std::move(errors.curvature);
  r.precision.turning_error = std::move(errors.turning);
  return r;
}

Refined_surface refined_surface(const Intrinsic_triangulation& input, const Refined_cone_metric& metric,
                                const std::vector<double>& u, const Quartic_differential& delaunay)
{
  internal::require_embedded(input, "the refined surface");
  Common_refinement refinement = metric.refinement;
  Quartic_differential flat = in_the_plane(delaunay);
  refinement.rescale(flat.triangulation, u);
  internal::flip_towards_input(refinement, flat);

  const Intrinsic_triangulation &c = flat.triangulation, &a = refinement.input();
  const Refined_vertices vertex(c, refinement);
  const std::vector<Grid_vector> points = crossing_points(refinement, flat);
  const auto grid_point = [&](const Cell_corner& k) {
    if (k.crossing.is_none()) return flat.corner[k.c];
    const Grid_vector z = points[vertex(k) - c.number_of_vertices()];
    return is_first_of_its_edge(k.c) ? z : flat.transition[c.opposite(k.c)](z);
  };
  const Refinement_cells cells(refinement, c);
  const std::size_t faces = cells.corners().size() - 2 * cells.cells().size();
  const std::size_t edges = a.number_of_edges() + points.size() + faces - a.number_of_faces();   // Euler's formula

  Refined_surface result;
  Quartic_differential& q = result.differential;
  result.input_face.reserve(faces);
  q.corner.resize(2 * edges);
  q.transition.resize(2 * edges);
  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(a.number_of_vertices() + points.size()), static_cast<Mesh::size_type>(edges),
               static_cast<Mesh::size_type>(faces));
  for (Vertex v : a.vertices()) mesh.add_vertex(a.mesh().point(v));
  for (Edge e : c.edges())
    for (const Crossing& x : refinement.crossings(e)) mesh.add_vertex(place_on_input(a, u, x));

  Polygon_cutter cut;
  std::vector<Grid_vector> polygon;
  for (const Refinement_cell& cell : cells.cells()) {
    const Cell_corner* corner = cells.corners().data() + cell.first_corner;
    const std::size_t n = cell.last_corner - cell.first_corner;
    polygon.clear();
    for (std::size_t i = 0; i < n; ++i) polygon.push_back(grid_point(corner[i]));
    for (const auto& triangle : cut.triangles(polygon)) {
      std::array<Vertex, 3> v;
      for (int k = 0; k < 3; ++k) v[k] = Vertex(static_cast<Mesh::size_type>(vertex(corner[triangle[k]])));
      const Face f = mesh.add_face(v[0], v[1], v[2]);
      if (f == Mesh::null_face()) throw Numerical_error("the refined surface is not a manifold");
      Halfedge h = mesh.halfedge(v[0], v[1]);
      mesh.set_halfedge(f, h);
      for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
        const std::size_t i = triangle[k], j = triangle[(k + 1) % 3];
        q.corner[h] = polygon[i];
        if (j == (i + 1) % n && lies_along(c, corner[i].c, corner[j])) q.transition[h] = flat.transition[corner[i].c];
      }
      result.flipped_triangles += doubled_area(polygon[triangle[0]], polygon[triangle[1]], polygon[triangle[2]]) <= 0;
      result.input_face.push_back(metric.input_face[cell.a_face]);
    }
  }

  q.triangulation = Intrinsic_triangulation(std::move(mesh));
  q.grid_exponent = flat.grid_exponent;
  q.surface_units_per_unit = flat.surface_units_per_unit;
  q.singularities = flat.singularities;
  q.order = flat.order;
  q.order.resize(q.triangulation.number_of_vertices(), 0);
  place_corners_on_input(input, result);
  put_corners_on_boundary(input, result);
  return result;
}

Surface_point Refined_surface::from_input(const Surface_point& p) const
{
  Surface_point best;
  double best_depth = -std::numeric_limits<double>::infinity();
  for (Face f : faces_in[p.face]) {
    std::array<Complex, 3> corner;
    const auto h = differential.triangulation.halfedges(f);
    for (int k = 0; k < 3; ++k) corner[k] = affine(input_corner[h[k]]);
    const std::array<double, 3> b = internal::barycentric(corner, affine(p.barycentric));
    const double depth = *std::min_element(b.begin(), b.end());
    if (depth <= best_depth) continue;
    best_depth = depth;
    best = {f, b};
  }
  return moved_inside(best, 0);
}

Surface_point Refined_surface::to_input(const Surface_point& p) const
{
  Surface_point q{input_face[p.face], {0, 0, 0}};
  const auto h = differential.triangulation.halfedges(p.face);
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) q.barycentric[c] += p.barycentric[k] * input_corner[h[k]][c];
  return q;
}

Surface_point Refined_surface::from_chart(Face f, Complex z) const
{
  std::array<Complex, 3> corner;
  const auto h = differential.triangulation.halfedges(f);
  for (int k = 0; k < 3; ++k) corner[k] = in_units(differential.corner[h[k]], differential.grid_exponent);
  return moved_inside({f, internal::barycentric(corner, z)}, 0);
}

Mesh mesh_with_property_maps(const Refined_surface& refined)
{
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  const Quartic_differential& q = refined.differential;
  Mesh mesh = q.triangulation.mesh();
  auto texture = mesh.add_property_map<Halfedge, Point_2>("h:texture").first;
  auto face = mesh.add_property_map<Face, Face>("f:input_face").first;
  auto place = mesh.add_property_map<Vertex, Surface_point>("v:input_point").first;
  auto order = mesh.add_property_map<Vertex, int>("v:singularity_order", 0).first;
  for (Halfedge h : mesh.halfedges()) {
    if (mesh.is_border(h)) continue;
    const Complex z = in_units(q.corner[mesh.next(h)], q.grid_exponent);
    texture[h] = Point_2(z.real(), z.imag());
    place[mesh.source(h)] = {refined.input_face[mesh.face(h)], refined.input_corner[h]};
  }
  for (Face f : mesh.faces()) face[f] = refined.input_face[f];
  for (Vertex v : mesh.vertices()) order[v] = q.order[v];
  return mesh;
}

} } // namespace CGAL::Quartic_differentials
