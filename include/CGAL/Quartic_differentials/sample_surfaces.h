// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_SAMPLE_SURFACES_H
#define CGAL_QUARTIC_DIFFERENTIALS_SAMPLE_SURFACES_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

namespace CGAL {
namespace Quartic_differentials {

// Surfaces of every genus for examples, tests and benchmarks, closed unless they are said to have a boundary. All are
// deterministic, oriented outward and free of removed elements.

/// a sphere with three soft bumps: genus 0, with 20 * 4^subdivisions faces.
/// \pre `subdivisions >= 0`. Complexity: linear in the size of the result.
Mesh bumpy_sphere(int subdivisions);

/// the torus of revolution of a circle of radius `r` at distance `R` from the axis: genus 1, n * m vertices,
/// n round the axis and m round the circle. Its period is i r / sqrt(R^2 - r^2), up to SL(2, Z).
/// \pre `0 < r < R`, `n >= 3`, `m >= 3`. Complexity: linear in the size of the result.
Mesh torus(double R, double r, int n, int m);

/// a bent plate with `g` holes in a row: genus `g`.
///
/// The surface is smooth and does not depend on `resolution`, the number of triangle edges across the strip between
/// two holes. Every angle is greater than 20 degrees (measured for genus 0 to 8, not proved).
/// \pre `g >= 0`, `resolution >= 6`. Complexity: O(g^2 resolution^3).
Mesh handle_chain(int g, int resolution);

/// a bent disk with `g` holes on a circle: genus `g`; otherwise as `handle_chain()`.
/// \pre `g >= 0`, `resolution >= 6`. Complexity: O(g^3 resolution^3).
Mesh handle_ring(int g, int resolution);

/// the curve y^2 = x^(2g+2) - 1, exactly: four regular (2g+2)-gons with sides of length 1, front and back of two
/// sheets, where front side k of sheet s is glued to back side k of sheet s if k is even, and of sheet 1-s if k is
/// odd; every polygon is a fan round its centre, `subdivided()` as often as asked.
/// Without subdivision it is a Delta-complex with parallel edges.
/// \pre `g >= 1`, `subdivisions >= 0`. Complexity: linear in the size of the result. Source: METHOD, "Ground truth".
Glued_triangles hyperelliptic(int g, int subdivisions);

/// the curve y^2 = x (x^(2g) - 1), exactly: a regular 4g-gon with sides of length 1, opposite sides glued by a
/// translation; it is a fan round its centre, `subdivided()` as often as asked. Genus 2 is Bolza's curve, from an
/// octagon.
///
/// Triangle k of the fan lies on side k with its edge 1; the only cone, of angle (4g-2) pi, is vertex 0. Over x = 0
/// lies the centre, over infinity the cone, and over the other branch points the midpoints of the sides.
/// \pre `g >= 1`, `subdivisions >= 0`. Complexity: linear in the size of the result. Source: METHOD, "Ground truth".
Glued_triangles regular_polygon(int g, int subdivisions);

/// the L of three unit squares, opposite sides glued by translations: genus 2, one cone of angle 6 pi, vertex 0. Every
/// square is cut along its diagonal in the direction (1, 1) and `subdivided()` as often as asked.
///
/// Square s has the triangles 2s, with edges bottom, right, diagonal, and 2s+1, with edges diagonal, top, left.
/// Square 1 is to the right of square 0, square 2 above it.
/// \pre `subdivisions >= 0`. Complexity: linear in the size of the result. Source: METHOD, "Ground truth".
Glued_triangles l_of_three_squares(int subdivisions);

/// a flat disk of radius 1 with `holes` holes: genus 0, `holes` + 1 boundary curves. The triangles are those of `resolution`
/// rings round the centre that keep clear of the holes, whose borders are jagged therefore.
/// \pre `0 <= holes <= 5`, `resolution >= 12`. Complexity: O(resolution^2).
Mesh plate(int holes, int resolution);

/// the mesh without `count` disks, spread over it: triangles with a corner within `radius` * sqrt(area) along edges of one of
/// `count` vertices are left out, and those that would hang on by a vertex or by one edge only. Every disk leaves a boundary
/// curve.
/// \pre `mesh` is a connected triangle mesh without removed elements, `count >= 1`
/// \throws Unusable_surface_error if the disks meet each other or the boundary, or leave nothing
/// Complexity: `count` shortest-path trees.
Mesh with_disks_cut_out(const Mesh& mesh, int count, double radius);

/// splits every triangle into four at the midpoints of its edges. The surface does not change. Old vertices keep
/// their index; triangle t becomes 4t, ..., 4t+3, the one at its corner c being 4t+c.
/// \pre `s` is glued consistently. Complexity: linear.
Glued_triangles subdivided(const Glued_triangles& s);

/// splits every triangle into four at the midpoints of its edges. The surface does not change. Old vertices keep
/// their index, and the midpoint of edge e follows as number_of_vertices + e.
/// \pre `mesh` is a triangle mesh without removed elements. Complexity: linear.
Mesh subdivided(const Mesh& mesh);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_SAMPLE_SURFACES_H
