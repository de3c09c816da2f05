// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACES_WITH_BOUNDARY_H
#define CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACES_WITH_BOUNDARY_H

// Surfaces with boundary for the tests, what is computed on them up to the Abel-Jacobi map, and their doubles.

#include "glued_triangles.h"
#include "plates.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/holomorphic_forms.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/laplacian.h>
#include <CGAL/Quartic_differentials/legalize_divisor.h>
#include <CGAL/Quartic_differentials/relative_homology_basis.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>
#include <CGAL/Quartic_differentials/split_obtuse_at_boundary.h>

#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Quartic_test {

using namespace CGAL::Quartic_differentials;

struct Surface_with_boundary
{
  std::string             name;
  int                     genus, curves;
  Intrinsic_triangulation surface;
};

/// every vertex of the boundary, or a part of them, gets a flat triangle between its two boundary edges that is obtuse
/// opposite the new boundary edge, by up to `degrees`: the surface is no longer one in space
inline Intrinsic_triangulation with_obtuse_rim(const Intrinsic_triangulation& t, double degrees, std::mt19937& random)
{
  Glued_triangles s = glued_triangles(t);
  for (const std::vector<Halfedge>& curve : t.boundary_curves())
    for (std::size_t i = 0; i + 1 < curve.size(); i += 2) {
      if (random() % 4 == 0) continue;
      const Halfedge in = curve[i], out = curve[i + 1];
      const int n = static_cast<int>(s.triangles.size());
      const std::array<int, 2> to_in{static_cast<int>(t.face(in).idx()), t.corner(in)};
      const std::array<int, 2> to_out{static_cast<int>(t.face(out).idx()), t.corner(out)};
      const double a = t.length(in), b = t.length(out), angle = uniform(random, 95, degrees) * CGAL_PI / 180;
      const int from = static_cast<int>(t.source(in).idx()), middle = static_cast<int>(t.target(in).idx());
      s.triangles.push_back({middle, from, static_cast<int>(t.target(out).idx())});
      s.opposite.push_back({{to_in, {-1, -1}, to_out}});
      s.lengths.push_back({a, std::sqrt(a * a + b * b - 2 * a * b * std::cos(angle)), b});
      s.opposite[to_in[0]][to_in[1]] = {n, 0};
      s.opposite[to_out[0]][to_out[1]] = {n, 2};
    }
  return Intrinsic_triangulation(s);
}

/// disks with 0 to 4 holes, and closed surfaces of genus 0 to 3 with 1 to 3 disks cut out
inline std::vector<Surface_with_boundary> surfaces_with_boundary()
{
  std::vector<Surface_with_boundary> list;
  for (int holes = 0; holes <= 4; ++holes)
    list.push_back({"plate with " + std::to_string(holes) + " holes", 0, holes + 1,
                    Intrinsic_triangulation(plate(holes, 14))});
  const auto cut = [&](const std::string& name, int genus, const Mesh& mesh, int disks) {
    list.push_back({name + " without " + std::to_string(disks) + " disks", genus, disks,
                    Intrinsic_triangulation(with_disks_cut_out(mesh, disks, 0.1))});
  };
  cut("sphere", 0, bumpy_sphere(3), 3);
  cut("jittered torus", 1, jittered_torus(40, 20, 0.3, 0.5, 2), 1);
  cut("chain of genus 1", 1, handle_chain(1, 6), 2);
  cut("chain of genus 2", 2, handle_chain(2, 6), 1);
  cut("chain of genus 2", 2, handle_chain(2, 6), 3);
  cut("ring of genus 3", 3, handle_ring(3, 6), 2);
  return list;
}

/// pinned corners at vertices, with their numbers of quads
inline Divisor corners_at(const Intrinsic_triangulation& t, const std::vector<std::pair<Vertex, int>>& corners)
{
  Divisor divisor;
  for (const auto& [v, quads] : corners) divisor.push_back({on_edge(t, t.halfedge_from(v), 0), quads - 2, true, true});
  return divisor;
}

/// the same on a plate of squares, where the vertices have integer coordinates
inline Divisor corners_at_points(const Intrinsic_triangulation& t, const std::map<std::pair<int, int>, int>& quads)
{
  std::vector<std::pair<Vertex, int>> corners;
  for (Vertex v : t.vertices()) {
    const Point_3& p = t.mesh().point(v);
    const auto it = quads.find({static_cast<int>(p.x()), static_cast<int>(p.y())});
    if (it != quads.end()) corners.emplace_back(v, it->second);
  }
  return corners_at(t, corners);
}

/// the ten corners of l_with_hole()
inline Divisor corners_of_l(const Intrinsic_triangulation& t)
{
  return corners_at_points(t, {{{0, 0}, 1}, {{12, 0}, 1}, {{12, 6}, 1}, {{6, 6}, 3}, {{6, 12}, 1}, {{0, 12}, 1},
                               {{2, 2}, 3}, {{4, 2}, 3}, {{4, 4}, 3}, {{2, 4}, 3}});
}

/// 6 x 4 unit squares
inline Intrinsic_triangulation sheet_of_squares()
{ return Intrinsic_triangulation(plate_of_squares(6, 4, [](int, int) { return true; })); }
inline Divisor corners_of_sheet(const Intrinsic_triangulation& t)
{ return corners_at_points(t, {{{0, 0}, 1}, {{6, 0}, 1}, {{6, 4}, 1}, {{0, 4}, 1}}); }

/// a surface with boundary up to its Abel-Jacobi map
struct Prepared_surface
{
  Intrinsic_triangulation input;      ///< with the boundary's splits
  std::size_t             splits;
  Relative_homology_basis homology;   ///< paths on the input, cochains on `delaunay`
  Intrinsic_triangulation delaunay;
  std::vector<double>     weights;
  Laplacian_solver        laplacian;
  Harmonic_1_forms        forms;
  Abel_jacobi_map         map;

  explicit Prepared_surface(const Intrinsic_triangulation& t)
    : input(t), splits(split_obtuse_at_boundary(input)), homology(relative_homology_basis(input)),
      delaunay(made_delaunay(input, homology.cochains)), weights(cotangent_weights(delaunay, delaunay.lengths())),
      forms(harmonic_forms()), map(delaunay, homology.cochains, forms) {}
  Prepared_surface(const Prepared_surface&) = delete;

private:
  static Intrinsic_triangulation made_delaunay(Intrinsic_triangulation t, Integer_cochains& cochains)
  {
    make_delaunay(t, cochains);
    return t;
  }
  Harmonic_1_forms harmonic_forms()
  {
    laplacian.factorize(delaunay, weights);
    return harmonic_1_forms(delaunay, homology.cochains, weights, laplacian);
  }
};

/// Two copies of a surface, glued along the boundary. Face f has the mirror image F + f, whose edge 2-k is that of edge k.
struct Mirror_double
{
  Intrinsic_triangulation surface;
  std::vector<Vertex>     image;      ///< by vertex of the surface with boundary: its mirror image, itself on the boundary
  Integer_cochains        cochains;   ///< symmetric
};

inline Mirror_double mirror_double(const Intrinsic_triangulation& t, const Integer_cochains& cochains)
{
  Mirror_double result;
  Glued_triangles s = glued_triangles(t);
  const int n = static_cast<int>(s.triangles.size());
  Mesh::size_type vertices = static_cast<Mesh::size_type>(t.number_of_vertices());
  for (Vertex v : t.vertices()) result.image.push_back(t.is_border(v) ? v : Vertex(vertices++));
  for (int f = 0; f < n; ++f) {
    const auto image = [&](int corner) { return static_cast<int>(result.image[s.triangles[f][corner]].idx()); };
    s.triangles.push_back({image(0), image(2), image(1)});
    s.lengths.push_back({s.lengths[f][2], s.lengths[f][1], s.lengths[f][0]});
    s.opposite.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto [u, e] = s.opposite[f][k];
      if (u >= 0) s.opposite.back()[2 - k] = {n + u, 2 - e};
      else        s.opposite.back()[2 - k] = {f, k};
    }
  }
  for (int f = 0; f < n; ++f)
    for (int k = 0; k < 3; ++k)
      if (s.opposite[f][k][0] < 0) s.opposite[f][k] = {n + f, 2 - k};
  result.surface = Intrinsic_triangulation(s);
  result.cochains = Integer_cochains(result.surface.number_of_edges(), cochains.size());
  for (Face f : t.faces())
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = result.surface.halfedges(f)[k];
      const Halfedge mirrored = result.surface.halfedges(Face(static_cast<Mesh::size_type>(n) + f))[2 - k];
      for (int i = 0; i < cochains.size(); ++i) {
        const int value = cochains(t.halfedges(f)[k], i);
        if (result.surface.halfedge(result.surface.edge(h)) == h) result.cochains.add(h, i, value);
        if (result.surface.halfedge(result.surface.edge(mirrored)) == mirrored) result.cochains.add(mirrored, i, -value);
      }
    }
  return result;
}

/// a place on a boundary curve, at a fraction of its length
inline Surface_point on_curve(const Intrinsic_triangulation& t, const std::vector<Halfedge>& curve, double fraction)
{
  double length = 0;
  for (Halfedge h : curve) length += t.length(h);
  double at = fraction * length;
  for (Halfedge h : curve) {
    if (at <= t.length(h)) return on_edge(t, h, at / t.length(h));
    at -= t.length(h);
  }
  return on_edge(t, curve.back(), 1);
}

/// whether a place is on the boundary without rounding: at a vertex of it, or with a coordinate 0 opposite one of its edges
inline bool is_on_boundary(const Intrinsic_triangulation& t, const Surface_point& p)
{
  if (internal::boundary_place(t, p).halfedge != Mesh::null_halfedge()) return true;
  const auto h = t.halfedges(p.face);
  for (int k = 0; k < 3; ++k)
    if (p.barycentric[k] == 1) return t.is_border(t.source(h[k]));
  return false;
}

/// a divisor of the right degree: on every boundary curve corners with the given numbers of quads (2 is no corner), evenly
/// but for chance, then simple singularities, with `pairs` more of either sign, in places at least `apart` * sqrt(area) from
/// the others where there is room.
inline Divisor random_divisor(const Intrinsic_triangulation& t, const std::vector<std::vector<int>>& corners, int pairs,
                              std::mt19937& random, double apart = 0.06)
{
  Divisor divisor;
  const auto curves = t.boundary_curves();
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const double begin = uniform(random, 0, 1);
    for (std::size_t i = 0; i < corners[c].size(); ++i) {
      const double step = static_cast<double>(i) + uniform(random, -0.2, 0.2);
      const double at = begin + step / static_cast<double>(corners[c].size());
      divisor.push_back({on_curve(t, curves[c], at - std::floor(at)), corners[c][i] - 2, false, true});
    }
  }
  const int missing = 8 * t.genus() - 8 + 4 * static_cast<int>(curves.size()) - degree(divisor);
  std::vector<int> orders(std::abs(missing), missing > 0 ? 1 : -1);
  for (int i = 0; i < pairs; ++i) orders.insert(orders.end(), {1, -1});
  for (int order : orders) {
    divisor.push_back({{}, order, false, false});
    double least = apart;
    for (int n = 0; ; ++n) {
      const double x = uniform(random, 0.05, 0.45), y = uniform(random, 0.05, 0.45);
      const Face f(static_cast<Mesh::size_type>(random() % t.number_of_faces()));
      divisor.back().location = {f, {1 - x - y, x, y}};
      if (collision(t, divisor, least).empty()) break;
      if (n % 20 == 19) least *= 0.9;
    }
  }
  return divisor;
}

/// for every boundary curve the numbers of quads at its corners
inline std::vector<std::vector<int>> random_corners(int curves, std::mt19937& random)
{
  static const std::vector<std::vector<int>> lists{{}, {1, 1, 1, 1}, {3, 3}, {3}, {1, 1, 3, 3}, {1, 3}, {1, 1, 1, 1, 1, 1},
                                                   {4}, {1, 1, 1, 1, 3, 3}, {5, 1}};
  std::vector<std::vector<int>> corners;
  for (int c = 0; c < curves; ++c) corners.push_back(lists[random() % lists.size()]);
  return corners;
}

/// a surface, with the boundary's splits, and a divisor on it
struct Boundary_case
{
  std::string             name;
  Intrinsic_triangulation surface;
  Divisor                 divisor;
};

/// random corners on every boundary curve, and random singularities inside
inline Boundary_case random_case(const Surface_with_boundary& s, std::mt19937& random)
{
  Boundary_case result{s.name, s.surface, {}};
  split_obtuse_at_boundary(result.surface);
  const std::vector<std::vector<int>> corners = random_corners(s.curves, random);
  result.divisor = random_divisor(result.surface, corners, static_cast<int>(random() % 3), random);
  return result;
}

/// How runs end, counted.
struct Outcomes
{
  int reached = 0, infeasible = 0, numerical = 0;

  /// runs a case, which returns whether it came to its end; reasons why not are said
  template <class Case>
  void add(Case run)
  {
    try {
      ++(run() ? reached : numerical);
    } catch (const Infeasible_divisor_error& e) {
      std::cout << e.what() << std::endl;
      ++infeasible;
    } catch (const Numerical_error& e) {
      std::cout << e.what() << std::endl;
      ++numerical;
    }
  }
};

inline std::ostream& operator<<(std::ostream& out, const Outcomes& o)
{ return out << o.reached << " reached, " << o.infeasible << " refused, " << o.numerical << " not reached"; }

} // namespace Quartic_test

#endif // CGAL_QUARTIC_DIFFERENTIALS_TEST_SURFACES_WITH_BOUNDARY_H
