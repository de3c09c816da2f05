// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUARTIC_DISTORTION_H
#define QUARTIC_DISTORTION_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Quartic_differential.h>

#include <Eigen/Core>

#include <vector>

/// Values of a quantity over the surface, with the area that each stands for.
struct Area_samples
{
  Eigen::VectorXd value, area;

  double mean() const { return value.dot(area) / area.sum(); }
};

/// sigma_1 / sigma_2 of the map of every triangle of `q` to the plane, at least 1
Area_samples conformal_distortion(const CGAL::Quartic_differentials::Quartic_differential& q);

/// the log u of the scale of lengths at the vertices of the input
/// \param u by vertex; the input's come first
Area_samples log_scale(const CGAL::Quartic_differentials::Intrinsic_triangulation& input, const std::vector<double>& u);

#endif // QUARTIC_DISTORTION_H
