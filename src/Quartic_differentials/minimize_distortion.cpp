// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/Moving_divisor.h>
#include <CGAL/Quartic_differentials/internal/distortion_descent.h>
#include <CGAL/Quartic_differentials/internal/surface_walk.h>
#include <CGAL/Quartic_differentials/minimize_distortion.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

namespace {

const double vertex_share = 0.98;   // a singularity with a larger barycentric coordinate is at a vertex
const double inwards = 0.05;        // of the way to the centroid
const int    attempts = 3;

// Displacements, in the faces' frames, of the singularities at vertices towards the centroids of their faces; corners
// stay.
Eigen::VectorXd away_from_vertices(const Intrinsic_triangulation& t, const Divisor& divisor)
{
  Eigen::VectorXd step = Eigen::VectorXd::Zero(2 * divisor.size());
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    const auto& b = divisor[i].location.barycentric;
    if (divisor[i].on_boundary || *std::max_element(b.begin(), b.end()) <= vertex_share) continue;
    const auto corner = t.unfolded(divisor[i].location.face);
    const std::complex<double> way = inwards * ((corner[0] + corner[1] + corner[2]) / 3.0
                                                - internal::point_in_frame(corner, b));
    step.segment<2>(2 * i) << way.real(), way.imag();
  }
  return step;
}

// E has kinks at vertices, which attract singularities; but a cone very near a vertex makes needles in the flat metric.
void move_off_vertices(const Intrinsic_triangulation& t, internal::Moving_divisor& d, const Eigen::VectorXd& m,
                       const internal::Newton_limits& limits, Visitor& visitor)
{
  for (int k = 0; k < attempts; ++k) {
    const Eigen::VectorXd step = d.in_transported_frames(away_from_vertices(t, d.divisor()));
    if (step.isZero(0)) break;
    internal::Moving_divisor moved = d;
    std::vector<double> history;
    moved.move(step);
    if (m.size() > 0 && !internal::move_onto_lattice(moved, m, limits, history, visitor)) break;
    d = std::move(moved);
  }
}

} // namespace

Optimal_divisor minimize_distortion(const Area_distortion& distortion, const Abel_jacobi_map& map,
                                    const Period_matrix& periods, const Divisor& divisor,
                                    const Legalization_options& legalization, const Distortion_options& options,
                                    Visitor& visitor)
{
  Optimal_divisor optimal;
  optimal.legal = legalize_divisor(map, periods, divisor, legalization, visitor);
  Legal_divisor& legal = optimal.legal;
  // the points are lifted anew, on sheet 0: there m differs by integers from the vector that was found
  const internal::Moving_divisor start(map, legal.divisor);
  const Eigen::VectorXd m = internal::rounded_to_lattice(start.residual());
  internal::Descent descent = internal::descend(distortion, start, m, options, visitor);

  const Intrinsic_triangulation& t = map.triangulation();
  const internal::Newton_limits limits{legalization.tolerance, legalization.iterations,
                                       options.longest_step * std::sqrt(t.area())};
  move_off_vertices(t, descent.divisor, m, limits, visitor);
  std::vector<double> polishing;
  if (m.size() > 0) internal::move_onto_lattice(descent.divisor, m, limits, polishing, visitor);
  const Eigen::VectorXd u = distortion.log_scale(descent.divisor.divisor());

  optimal.history = std::move(descent.history);
  optimal.distortion = distortion.energy(u);
  optimal.area_scale_before = area_scale_ratio(distortion.log_scale(legal.divisor), distortion.mass());
  optimal.area_scale_after = area_scale_ratio(u, distortion.mass());
  legal.divisor = descent.divisor.divisor();
  for (std::size_t i = 0; i < divisor.size(); ++i) legal.moved_by[i] += descent.divisor.moved_by()[i];
  legal.nearest = m;
  legal.residual = descent.divisor.residual() - 0.5 * CGAL_PI * m;
  return optimal;
}

} } // namespace CGAL::Quartic_differentials
