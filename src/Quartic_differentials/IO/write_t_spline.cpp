// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_t_spline.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>
#include <CGAL/Quartic_differentials/internal/require_embedded.h>
#include <CGAL/Quartic_differentials/internal/t_mesh_nodes.h>

#include <ostream>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Text_writer;

const char* const description = R"(# The T-mesh of a surface, from which a T-spline can be made.
#
# Lines that begin with # are comments. All others are, in this order:
#
#   unit K                      one unit of the knot intervals is 2^-K units of the flat metric
#   counts V E F                numbers of vertices, edges and faces; V - E + F = 2 - 2 genus
#   v ID X Y Z VALENCE KIND     a vertex, V times: place in space, number of edge ends there, and one of
#                                 singularity  an extraordinary point of any valence, corner of as many faces
#                                 t_junction   valence 3: the corner of two faces, in the middle of a side of the third
#                                 crossing     valence 4: the corner of four faces
#                                 meeting      valence 2: in the middle of a side of both faces
#   e ID FROM TO INTERVAL       an edge, E times: its vertices, and its knot interval, an exact positive integer that
#                               needs 64 bits
#   f ID WIDTH HEIGHT           a face, F times: a rectangle, with the sums of knot intervals on its sides; then
#   s EDGE WAY [EDGE WAY ..]    its four sides counterclockwise, seen from outside; each begins and ends at a corner of
#                               the face. WAY is 1 if the edge runs FROM-TO along the side, -1 if TO-FROM. Sides 0 and
#                               2 have WIDTH, 1 and 3 have HEIGHT.
#
# IDs count from 0 in the order of the lines. Every edge lies on two sides, once in each way. Edges may be loops, and a
# face may meet itself. T-junctions that face one another across a face at the same place are not joined. Between two
# vertices an edge is a curve on the surface: tmesh.json has its polyline.
#
# Compared with TSM, the text format of T-Splines for Rhino and of Fusion (#TS0200; it has no public specification, but
# files and parsers are public): there too the mesh is vertices, edges with knot intervals and faces, T-junctions are
# vertices of valence 3, and opposite sides have equal sums. TSM joins them by half-edges (lines l: previous, next,
# opposite, vertex, face, edge), here faces list their edges. TSM's knot intervals are decimal numbers, here they are
# integers. TSM has control points (lines 0g) with weights, degree, end conditions and creases; here are places on the
# surface, and to choose control points is left to the reader. No program reads this file as TSM.
)";

const char* const description_of_boundary = R"(#
# This surface has a boundary, B closed curves of edges: V - E + F = 2 - 2 genus - B. Every edge of the boundary lies on
# one side only, FROM-TO, with the face on its left. Vertices there are
#   t_junction                  valence 3, as above, but without the third face
#   corner                      an extraordinary point of any valence, corner of one face fewer
)";

// by vertex: how many ends of edges are there
std::vector<int> valences(const T_mesh& t)
{
  std::vector<int> result(t.nodes.size(), 0);
  for (const T_mesh::Arc& arc : t.arcs) {
    ++result[arc.from];
    ++result[arc.to];
  }
  return result;
}

void write_vertices(Text_writer& out, const T_mesh& t, const Quartic_differential& q)
{
  const std::vector<int> valence = valences(t);
  for (std::size_t n = 0; n < t.nodes.size(); ++n) {
    const Point_3 p = internal::position(q, t.nodes[n]);
    out << "v " << n << ' ';
    internal::write_point(out, p, ' ');
    out << ' ' << valence[n] << ' ' << internal::name(t.nodes[n].kind) << '\n';
  }
}

void write_edges(Text_writer& out, const T_mesh& t)
{
  for (std::size_t a = 0; a < t.arcs.size(); ++a)
    out << "e " << a << ' ' << t.arcs[a].from << ' ' << t.arcs[a].to << ' ' << t.arcs[a].length << '\n';
}

void write_faces(Text_writer& out, const T_mesh& t)
{
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    out << "f " << p << ' ' << t.patches[p].width << ' ' << t.patches[p].height << '\n';
    for (const std::vector<T_mesh::Side_piece>& side : t.patches[p].sides) {
      out << 's';
      for (const T_mesh::Side_piece& piece : side) out << ' ' << piece.arc << ' ' << (piece.forward ? 1 : -1);
      out << '\n';
    }
  }
}

} // namespace

void write_t_spline(std::ostream& stream, const T_mesh& t, const Quartic_differential& q)
{
  internal::require_embedded(q.triangulation, "tmesh.tsp");
  Text_writer out(stream);
  out << description;
  if (q.triangulation.has_boundary()) out << description_of_boundary;
  out << "unit " << t.grid_exponent << "\ncounts " << t.nodes.size() << ' ' << t.arcs.size() << ' '
      << t.patches.size() << '\n';
  write_vertices(out, t, q);
  write_edges(out, t);
  write_faces(out, t);
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
