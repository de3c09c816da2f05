// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CONE_INSERTION_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CONE_INSERTION_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/delaunay_flips.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/holomorphic_forms.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A direction at an inserted cone: the halfedge `reference` leaves it at `angle` in the unfolded frame of the face it
/// was inserted in. Follows its halfedge through Euclidean flips. At a corner the reference is the boundary edge that leaves
/// it, with the surface on the left, at angle 0.
struct Cone_frame
{
  int      singularity;   ///< its number in the divisor
  Halfedge reference;
  double   angle;
};

class Cone_frames
{
public:
  void add(const Cone_frame& f) { m_frames.push_back(f); }
  const std::vector<Cone_frame>& frames() const { return m_frames; }
  /// turns the reference counterclockwise past an edge that is about to be flipped away
  void before_flip(const Intrinsic_triangulation& t, const Edge_flip& flip);
private:
  std::vector<Cone_frame> m_frames;
};

/// A piece of a face that was split by insertions, with the places of its corners in the frame of the whole face.
struct Face_piece
{
  Face                                face;
  std::array<std::complex<double>, 3> corner;
  std::array<int, 3>                  name;     ///< k: corner k of the whole face; 3 + i: the i-th point of the inserter
};

/// Where the corners of pieces are, as long as they are not flipped. Rides along.
///
/// Near an edge a point makes a needle, and rounded lengths know its altitude h only up to eps / h. By its place, its
/// distance from what is across the edge is right up to eps. (METHOD, step 6)
class Piece_places
{
public:
  explicit Piece_places(std::map<Face, std::array<std::complex<double>, 3>> corners) : m_corners(std::move(corners)) {}

  /// the length of the other diagonal of the two faces at h
  double diagonal(const Intrinsic_triangulation& t, Halfedge h) const;
  void before_flip(const Intrinsic_triangulation& t, const Edge_flip& flip);

private:
  std::map<Face, std::array<std::complex<double>, 3>> m_corners;
};

/// Inserts points in the faces of a triangulation, also several in one face.
class Point_inserter
{
public:
  /// Keeps a reference to t.
  explicit Point_inserter(const Intrinsic_triangulation& t);

  struct Inserted
  {
    Intrinsic_triangulation::Insertion insertion;
    double                             angle;   ///< the direction of spoke[0] in the frame of the face of t
    std::array<int, 3>                 end;     ///< where the spokes end, named as in `Face_piece`
  };
  /// \param p in a face of t
  Inserted insert(const Surface_point& p);
  struct Inserted_on_boundary
  {
    Intrinsic_triangulation::Boundary_split split;
    std::array<int, 3>                      end;   ///< where split.first, split.second and split.spoke end, named as in
                                                   ///< `Face_piece`
  };
  /// \param p on a boundary edge of its face of t, but not at a vertex
  Inserted_on_boundary insert_on_boundary(const Surface_point& p);

  /// t with the points
  const Intrinsic_triangulation& triangulation() const & { return m_split; }
  Intrinsic_triangulation        triangulation() &&      { return std::move(m_split); }
  /// by face of the triangulation: the face of t it is part of
  const std::vector<Face>& original_faces() const { return m_original; }

  /// the places of the pieces' corners
  Piece_places places() const;

private:
  std::vector<Face_piece>& pieces(Face f);

  const Intrinsic_triangulation&          m_t;
  Intrinsic_triangulation                 m_split;
  int                                     m_inserted = 0;
  std::vector<Face>                       m_original;
  std::map<Face, std::vector<Face_piece>> m_pieces;   // of the faces of t that were split
};

/// `make_delaunay()` of the triangulation of a `Point_inserter`: where a place is known it is preferred to lengths.
template <class... Riders>
std::size_t make_delaunay_by_places(Intrinsic_triangulation& t, Piece_places places, Riders&... riders)
{
  return flip_to_delaunay(t, false, [&](Edge e) { return t.length(e); }, [&](Halfedge h) { return places.diagonal(t, h); },
                          places, riders...);
}

/// The triangulation with the cones of a divisor as vertices, intrinsic Delaunay again.
struct Inserted_cones
{
  Intrinsic_triangulation triangulation;
  Integer_cochains        cochains;
  std::vector<Vertex>     cones;    ///< by singularity
  std::vector<char>       frozen;   ///< by singularity: pinned, or at a vertex that was there before
  Cone_frames             frames;   ///< of the cones that are not frozen
};

/// \throws Infeasible_divisor_error if two singularities take the same vertex, or one that is no corner a boundary vertex
Inserted_cones insert_cones(const Intrinsic_triangulation& t, const Integer_cochains& cochains, const Divisor& divisor);

/// the vertex within 1e-4 of the length of an adjacent edge of the face, or null
Vertex vertex_at(const Intrinsic_triangulation& t, const Surface_point& p);
/// the vertex that a singularity takes: of a corner the end within 1e-4 of the length of its boundary edge, or null
Vertex vertex_at(const Intrinsic_triangulation& t, const Singularity& s);

/// lambda: the derivatives of the logarithms of the edge lengths by the positions of the cones, sparse rows by edge.
/// Rides along Ptolemy flips. (METHOD, step 6)
class Length_derivatives
{
public:
  using Row = std::vector<std::pair<int, Eigen::Vector2d>>;   ///< (singularity, derivative by x and y), sorted

  Length_derivatives() = default;
  /// moving a cone p by delta changes the length of its spokes only: lambda_e = -<e, delta> / l_e, e the unit direction;
  /// a corner moves along the boundary, which is the direction x
  Length_derivatives(const Intrinsic_triangulation& t, const Cone_frames& frames);

  const Row& operator[](Edge e) const { return m_row[e]; }
  void before_flip(const Intrinsic_triangulation& t, const Edge_flip& flip);
private:
  std::vector<Row> m_row;
};

/// the derivative of the turning numbers T by the positions of the cones where the curvatures are held: 2g rows, columns
/// (x, y) of the frame of a singularity's face; zero where it is frozen. (METHOD, step 6)
/// \param angles of the metric; \param omega harmonic in it, in the classes of the loops
Eigen::MatrixXd turning_derivative(const Intrinsic_triangulation& t, const std::vector<double>& angles,
                                   const Length_derivatives& lambda, std::size_t cones, const Harmonic_1_forms& omega);

/// the change of the curvatures by displacements of the cones (x, y by singularity) where the scales are held
Eigen::VectorXd curvature_change(const Intrinsic_triangulation& t, const std::vector<double>& angles,
                                 const Length_derivatives& lambda, const Eigen::VectorXd& displacement);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_CONE_INSERTION_H
