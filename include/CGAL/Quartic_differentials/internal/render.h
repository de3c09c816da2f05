// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_RENDER_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_RENDER_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/write_png.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

using Colour = Eigen::Array3f;   ///< red, green and blue in [0, 1], as they are shown

/// What is drawn: a surface of triangles, with lines and balls. All sizes are in the units of space.
struct Scene
{
  struct Line
  {
    std::vector<Point_3> points;
    double               width;
    Colour               colour;
    bool                 is_tube;   ///< a shaded tube about the points, otherwise a flat stripe that faces the eye
  };
  struct Ball
  {
    Point_3 centre;
    double  radius;
    Colour  colour;
  };

  std::vector<Point_3>                             points;
  std::vector<std::array<std::size_t, 3>>          triangles;
  std::vector<std::array<Eigen::Vector3d, 3>>      normals;   ///< by triangle, at its corners; of any length
  std::vector<Colour>                              colours;   ///< by triangle, or empty: the texture tells
  std::vector<std::array<Eigen::Vector2d, 3>>      uv;        ///< by triangle, at its corners, if there is a texture
  std::function<Colour(const Eigen::Vector2d& uv)> texture;
  std::vector<Line>                                lines;
  std::vector<Ball>                                balls;
};

/// normals for the corners of triangles, by area from the triangles at that point (points with equal coordinates are
/// one) that meet the corner's own at less than 60 degrees: edges that are sharper stay sharp.
/// Complexity: O(n log n) for bounded valences.
std::vector<std::array<Eigen::Vector3d, 3>> smooth_normals(const std::vector<Point_3>& points,
                                                           const std::vector<std::array<std::size_t, 3>>& triangles);

/// Directions of a picture from infinitely far: an orthonormal basis, right-handed.
struct Camera
{
  Eigen::Vector3d right, up, towards_eye;

  Eigen::Vector3d operator()(const Point_3& p) const
  {
    const Eigen::Vector3d q(p.x(), p.y(), p.z());
    return {right.dot(q), up.dot(q), towards_eye.dot(q)};
  }
  /// what is seen from behind
  Camera turned_round() const { return {-right, up, -towards_eye}; }
};

/// a camera that sees from `towards_eye`, with `up` upward as nearly as possible; any other direction is taken in place
/// of `up` if the two are parallel.
/// \pre `towards_eye` is not 0
Camera camera(const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up);

/// the y axis of space, or the z axis if the view is along y rather than along another axis
Eigen::Vector3d usual_up(const Eigen::Vector3d& towards_eye);

/// a camera for these triangles: it sees along the axis in which they extend least, turned by 25 degrees so that the
/// shape can be read, with the usual direction upward.
/// Complexity: linear.
Camera automatic_camera(const std::vector<Point_3>& points, const std::vector<std::array<std::size_t, 3>>& triangles);

/// draws a scene on white, as large as fits.
///
/// A surface is seen from both its sides. What is nearer hides what is farther; lines and balls are pulled towards the
/// eye, stripes by three radii, tubes by one and balls by a half, so that the surface in which they lie does not hide
/// them. Every pixel is the mean of 4 x 4 points.
/// \param size pixels of the longer side; the other is as the scene asks for
/// \pre the scene is not empty, and `size` > 0
/// Complexity: linear in the primitives and in the pixels they cover.
Image render(const Scene& scene, const Camera& camera, int size);

/// two pictures next to each other. \pre they have the same height
Image side_by_side(const Image& left, const Image& right);

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_RENDER_H
