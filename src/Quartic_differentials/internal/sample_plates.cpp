// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The bent plates with holes of sample_surfaces.h, as zero sets of a smooth function.

#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double pi = CGAL_PI;

// A plate with holes:  f(x,y,z) = (z - b(x,y))^2 - t(x,y) D(x,y),  solid where f < 0.
//   D  smooth minimum of the distances (in effect) to the rim and to the holes
//   t  a slight taper and b a slight bend, so that no symmetry makes curvature extrema tie
// f = 0 is a smooth surface because D has no critical point at its zeros.
class Plate
{
public:
  // holes of radius 1 at the given centres; the rim has distance `rim` from the segment |x| <= half_length, y = 0
  Plate(std::vector<std::array<double, 2>> holes, double half_length, double rim)
    : m_holes(std::move(holes)), m_half_length(half_length), m_rim(rim) {}

  double reach_x() const { return m_half_length + m_rim + 0.5; }
  double reach_y() const { return m_rim + 0.5; }
  double reach_z() const { return std::sqrt(m_rim) + 0.5; }
  double bend(double x, double y) const { return 0.15 * (x * x + y * y) / (m_half_length + m_rim); }

  struct Value { double f; Vector_3 gradient; };

  Value operator()(const Point_3& p) const
  {
    const double x = p.x(), y = p.y();
    Soft_minimum d;
    // the rim: (R^2 - e^2 - y^2) / 2R, where e(x) is x beyond the segment, and odd and smooth
    const double e = soft_excess(x) - soft_excess(-x);
    const double de = slope(x) + slope(-x);
    d.add((m_rim * m_rim - e * e - y * y) / (2 * m_rim), -e * de / m_rim, -y / m_rim);
    for (const auto& [cx, cy] : m_holes)
      d.add(((x - cx) * (x - cx) + (y - cy) * (y - cy) - 1) / 2, x - cx, y - cy);

    const double scale = m_half_length + m_rim;
    const double taper = 1 + 0.2 * x / scale + 0.1 * y / scale;
    const double height = p.z() - bend(x, y);
    const double distance = d.value();
    return {height * height - taper * distance,
            Vector_3(-2 * height * 0.3 * x / scale - taper * d.dx() - 0.2 / scale * distance,
                     -2 * height * 0.3 * y / scale - taper * d.dy() - 0.1 / scale * distance,
                     2 * height)};
  }

  // the nearby point of the surface
  Point_3 project(Point_3 p) const
  {
    for (int i = 0; i < 4; ++i) {
      const Value v = (*this)(p);
      p = p - v.f / v.gradient.squared_length() * v.gradient;
    }
    return p;
  }

private:
  // -k log sum exp(-d/k), with the derivative that goes with it
  struct Soft_minimum
  {
    static constexpr double k = 0.25;
    double sum = 0, sum_dx = 0, sum_dy = 0;
    void add(double d, double dx, double dy)
    {
      const double w = std::exp(-d / k);
      sum += w; sum_dx += w * dx; sum_dy += w * dy;
    }
    double value() const { return -k * std::log(sum); }
    double dx() const { return sum_dx / sum; }
    double dy() const { return sum_dy / sum; }
  };

  double soft_excess(double x) const { return std::log1p(std::exp(x - m_half_length)); }
  double slope(double x) const { return 1 / (1 + std::exp(m_half_length - x)); }

  std::vector<std::array<double, 2>> m_holes;
  double m_half_length, m_rim;
};

// A box of cubes whose nodes are known to lie inside or outside; (i, j, k) runs over nodes and, by the lowest node, cubes.
class Grid
{
public:
  Grid(const Plate& plate, double spacing)
    : m_h(spacing), m_low(-plate.reach_x(), -plate.reach_y(), -plate.reach_z())
  {
    const double top = plate.reach_z() + plate.bend(plate.reach_x(), plate.reach_y());
    m_n = {nodes(2 * plate.reach_x()), nodes(2 * plate.reach_y()), nodes(top + plate.reach_z())};
    m_inside.resize(static_cast<std::size_t>(m_n[0]) * m_n[1] * m_n[2]);
    for (int i = 0; i < m_n[0]; ++i)
      for (int j = 0; j < m_n[1]; ++j)
        for (int k = 0; k < m_n[2]; ++k) m_inside[index(i, j, k)] = plate(point(i, j, k)).f < 0;
    while (fill_a_corner_of_alternating_squares()) {}
  }

  const std::array<int, 3>& size() const { return m_n; }
  std::size_t index(int i, int j, int k) const { return (static_cast<std::size_t>(i) * m_n[1] + j) * m_n[2] + k; }
  bool inside(int i, int j, int k) const { return m_inside[index(i, j, k)]; }
  Point_3 point(double i, double j, double k) const { return m_low + m_h * Vector_3(i, j, k); }

private:
  int nodes(double width) const { return static_cast<int>(std::ceil(width / m_h)) + 1; }

  // At a saddle the corners of a grid square may be in, out, in, out: the net would have an edge with four faces.
  bool fill_a_corner_of_alternating_squares()
  {
    bool filled = false;
    const std::array<std::size_t, 3> step{index(1, 0, 0), index(0, 1, 0), index(0, 0, 1)};
    for (int i = 0; i + 1 < m_n[0]; ++i)
      for (int j = 0; j + 1 < m_n[1]; ++j)
        for (int k = 0; k + 1 < m_n[2]; ++k)
          for (int axis = 0; axis < 3; ++axis) {
            const std::size_t n = index(i, j, k), a = step[(axis + 1) % 3], b = step[(axis + 2) % 3];
            if (m_inside[n] != m_inside[n + a + b] || m_inside[n + a] != m_inside[n + b]
                || m_inside[n] == m_inside[n + a]) continue;
            m_inside[m_inside[n] ? n + a : n] = true;
            filled = true;
          }
    return filled;
  }

  double             m_h;
  Point_3            m_low;
  std::array<int, 3> m_n;
  std::vector<bool>  m_inside;
};

// Surface nets: a vertex in every cube that the surface meets, a quadrilateral across every grid edge that it crosses.
Mesh surface_net(const Grid& grid)
{
  Mesh mesh;
  const auto [ni, nj, nk] = grid.size();
  std::vector<Vertex> vertex_of_cube(static_cast<std::size_t>(ni) * nj * nk);
  for (int i = 0; i + 1 < ni; ++i)
    for (int j = 0; j + 1 < nj; ++j)
      for (int k = 0; k + 1 < nk; ++k) {
        int inside = 0;
        for (int c = 0; c < 8; ++c) inside += grid.inside(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
        if (inside == 0 || inside == 8) continue;
        vertex_of_cube[grid.index(i, j, k)] = mesh.add_vertex(grid.point(i + 0.5, j + 0.5, k + 0.5));
      }
  for (int i = 1; i + 1 < ni; ++i)
    for (int j = 1; j + 1 < nj; ++j)
      for (int k = 1; k + 1 < nk; ++k)
        for (int axis = 0; axis < 3; ++axis) {
          const std::array<int, 3> a{axis == 0, axis == 1, axis == 2};             // along the grid edge
          const std::array<int, 3> b{a[2], a[0], a[1]}, c{a[1], a[2], a[0]};       // the other two, b x c = a
          const bool from = grid.inside(i, j, k), to = grid.inside(i + a[0], j + a[1], k + a[2]);
          if (from == to) continue;
          const auto cube = [&](int s, int t) {
            return vertex_of_cube[grid.index(i - s * b[0] - t * c[0], j - s * b[1] - t * c[1], k - s * b[2] - t * c[2])];
          };
          std::array<Vertex, 4> quad{cube(1, 1), cube(0, 1), cube(0, 0), cube(1, 0)};   // seen from the end of a
          if (to) std::swap(quad[1], quad[3]);
          mesh.add_face(quad[0], quad[1], quad[2]);
          mesh.add_face(quad[0], quad[2], quad[3]);
        }
  return mesh;
}

// Moves every vertex to the mean of its neighbours and back to the surface.
void relax(Mesh& mesh, const Plate& plate)
{
  std::vector<Vector_3> sum(mesh.number_of_vertices(), Vector_3(0, 0, 0));
  for (Halfedge h : mesh.halfedges()) sum[mesh.target(h)] = sum[mesh.target(h)] + (mesh.point(mesh.source(h)) - CGAL::ORIGIN);
  for (Vertex v : mesh.vertices())
    mesh.point(v) = plate.project(CGAL::ORIGIN + sum[v] / static_cast<double>(mesh.degree(v)));
}

// Flips, once through, the edges that bring the valences round them nearer to 6; never to a parallel edge.
void even_out_valences(Mesh& mesh)
{
  for (Edge e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e), o = mesh.opposite(h);
    const Vertex i = mesh.source(h), j = mesh.target(h), k = mesh.target(mesh.next(h)), l = mesh.target(mesh.next(o));
    const auto degree = [&](Vertex v) { return static_cast<int>(mesh.degree(v)); };
    // the sum of (degree - 6)^2 changes by 2 (d_k + d_l - d_i - d_j) + 4
    if (degree(i) + degree(j) - degree(k) - degree(l) > 2 && mesh.halfedge(k, l) == Mesh::null_halfedge())
      CGAL::Euler::flip_edge(h, mesh);
  }
}

// the strip between neighbouring holes is 2 wide
Mesh mesh_of(const Plate& plate, int resolution)
{
  Mesh mesh = surface_net(Grid(plate, 2.0 / resolution));
  for (int round = 0; round < 20; ++round) {
    even_out_valences(mesh);
    relax(mesh, plate);
  }
  return mesh;
}

} // namespace

Mesh handle_chain(int g, int resolution)
{
  CGAL_precondition(g >= 0 && resolution >= 6);
  std::vector<std::array<double, 2>> holes;
  for (int i = 0; i < g; ++i) holes.push_back({4.0 * i - 2.0 * (g - 1), 0.0});
  return mesh_of(Plate(holes, g < 2 ? 0.0 : 2.0 * (g - 1), 3), resolution);
}

Mesh handle_ring(int g, int resolution)
{
  CGAL_precondition(g >= 0 && resolution >= 6);
  const double radius = g < 2 ? 0 : 2 / std::sin(pi / g);
  std::vector<std::array<double, 2>> holes;
  for (int i = 0; i < g; ++i) holes.push_back({radius * std::cos(2 * pi * i / g), radius * std::sin(2 * pi * i / g)});
  return mesh_of(Plate(holes, 0, radius + 3), resolution);
}

} } // namespace CGAL::Quartic_differentials
