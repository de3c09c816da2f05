// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "distortion.h"

#include <CGAL/Quartic_differentials/laplacian.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace CGAL::Quartic_differentials;

namespace {

// sigma_1 / sigma_2 of the map of a triangle to the plane, given both sets of lengths
double conformal_distortion(const std::array<double, 3>& l, const std::array<double, 3>& flat)
{
  // x = (sigma_1^2 + sigma_2^2) / (2 sigma_1 sigma_2) = Sum_k cot_k flat_k^2 / (4 flat area)
  double energy = 0;
  for (int k = 0; k < 3; ++k) energy += twice_scalar_product(l[k], l[(k + 1) % 3], l[(k + 2) % 3]) * flat[k] * flat[k];
  const double areas = four_times_area(l[0], l[1], l[2]) * four_times_area(flat[0], flat[1], flat[2]);
  const double x = std::max(1.0, energy / areas);
  return x + std::sqrt(x * x - 1);
}

} // namespace

Area_samples conformal_distortion(const Quartic_differential& q)
{
  const Intrinsic_triangulation& t = q.triangulation;
  Area_samples samples{Eigen::VectorXd(t.number_of_faces()), Eigen::VectorXd(t.number_of_faces())};
  for (Face f : t.faces()) {
    const auto h = t.halfedges(f);
    std::array<double, 3> l, flat;
    for (int k = 0; k < 3; ++k) {
      const Grid_vector d = q.corner[h[(k + 1) % 3]] - q.corner[h[k]];
      l[k] = t.length(h[k]);
      flat[k] = std::hypot(static_cast<double>(d.x), static_cast<double>(d.y));
    }
    samples.value[f.idx()] = conformal_distortion(l, flat);
    samples.area[f.idx()] = four_times_area(l[0], l[1], l[2]) / 4;
  }
  return samples;
}

Area_samples log_scale(const Intrinsic_triangulation& input, const std::vector<double>& u)
{
  const std::vector<double> areas = vertex_areas(input);
  const auto n = static_cast<Eigen::Index>(areas.size());
  return {Eigen::Map<const Eigen::VectorXd>(u.data(), n), Eigen::Map<const Eigen::VectorXd>(areas.data(), n)};
}
