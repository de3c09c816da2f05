// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_BRANCHED_COVER_H
#define CGAL_QUARTIC_DIFFERENTIALS_BRANCHED_COVER_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>

#include <complex>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Hyperelliptic curves y^2 = (x - e_1) ... (x - e_n) as double covers of a triangulated sphere (METHOD, section 4).

/// the point of the unit sphere with the coordinate x: 0, 1, i and infinity go to (0,0,1), (1,0,0), (0,1,0) and
/// (0,0,-1). Seen from outside the orientation is that of the plane. Complex infinity: a part of `x` is infinite.
Point_3 on_sphere(const std::complex<double>& x);

/// a triangulated unit sphere: vertex k is the k-th point, the others make triangles of the size h = 0.4 / 2^level
/// far from the points, and smaller ones near them.
///
/// Round each point lie n rings, symmetric under half a turn about it: ring i has 2i+2 vertices and the radius
/// R (i/n)^3, R being 2/5 of the distance to the next point, and n = 3R/h (at least 3). So triangles at the distance
/// r have a size in proportion to h r^(2/3): on a double cover branched at the point, functions that grow like r^(1/2)
/// are approximated as well as smooth ones, and energies have an error of O(h^2); without grading it is O(h). The
/// rest is a spiral of evenly spread vertices. The triangulation is the convex hull, that is Delaunay on the sphere.
/// \param points of the sphere with the coordinate x, as for `on_sphere()`
/// \pre `0 <= level <= 6`
/// \throws Error if two points are the same or less than 1e-3 apart on the sphere, or one is not a number
/// Complexity: O(n log n) in the n vertices, of which the spiral has at most 91 * 4^level.
Mesh triangulated_sphere(const std::vector<std::complex<double>>& points, int level);

/// the two-sheeted cover of a sphere, branched at the given vertices: genus (number of branch vertices - 2) / 2.
///
/// Triangles f and F + f lie over the face f, in the two sheets, where F is the number of faces; edge e of both is the
/// e-th halfedge of the face. Lengths are those of `sphere`. A vertex v of the cover with v < V, the number of vertices
/// of the sphere, lies over the vertex v; over every other vertex than the branch vertices lies one more.
/// The sheets change places across the edges of a spanning tree that separate an odd number of branch vertices from the
/// rest. (On a sphere any set of edges with these ends, modulo 2, gives the same surface.)
/// \pre `sphere` is a closed triangle mesh of genus 0 without removed elements
/// \throws Error if the branch vertices are fewer than two, odd in number, or not different
/// Complexity: linear.
Glued_triangles branched_cover(const Mesh& sphere, const std::vector<Vertex>& branch_vertices);

/// the hyperelliptic curve with the given branch points, as the cover of `triangulated_sphere(branch_points, level)`.
/// Conformally it tends to the curve when the level grows; cone angles at the branch points are nearly 4 pi.
/// \pre `0 <= level <= 6`
/// \throws Error as the two functions above
Glued_triangles branched_cover(const std::vector<std::complex<double>>& branch_points, int level);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_BRANCHED_COVER_H
