// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_CONE_METRIC_H
#define CGAL_QUARTIC_DIFFERENTIALS_CONE_METRIC_H

#include <CGAL/Quartic_differentials/Integer_cochains.h>
#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/Visitor.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/laplacian.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 6; paper, section 4.6)
//   l_ij      edge lengths of the triangulation with the cones inserted
//   u_i       log scale factors: the flat metric has lengths exp((u_i + u_j) / 2) l_ij
//   K_i       curvatures; the target is -n pi/2 at a cone or corner of order n and 0 elsewhere; dK = L du
//   lambda    derivatives of log l by the positions of the cones, carried through flips
//   T_k       turning of the loop gamma_k, modulo 2 pi; the holonomy is exact where T_k is a multiple of pi/2

/// Tolerances and limits of `cone_metric()` and `exact_cone_metric()`.
struct Cone_metric_options
{
  double curvature_tolerance = 0;      ///< max |K - target|, radians; 0: 1e-11 + 1e-15 V
  int    newton_iterations   = 60;
  double holonomy_tolerance  = 1e-11;  ///< aimed at on the basis loops, radians
  double accepted_holonomy   = 1e-10;  ///< accepted on the basis loops and on every edge, radians
  int    outer_iterations    = 12;
  double least_distance      = 0.01;   ///< between singularities, and half of it to the boundary, times sqrt(area)
};

/// How a discrete Ricci flow went.
struct Flow_report
{
  int                 newton_iterations = 0;     ///< until the tolerance was reached
  int                 polishing_steps = 0;       ///< past the tolerance, with the last factorisation
  std::size_t         flips = 0;
  double              max_curvature_error = 0;   ///< radians
  double              tolerance = 0;
  std::vector<double> history;                   ///< max curvature error before the first and after every step
  bool reached() const { return max_curvature_error <= tolerance; }
  /// whether rounding may be what keeps it from the tolerance: near enough to go on with its holonomy
  bool is_near() const { return reached() || max_curvature_error <= 1e-6; }
};

/// How exact a flat metric is, and with how many digits it was computed.
struct Precision_report
{
  int                 bits = 53;                 ///< binary digits; 53 are a double's
  std::string         reason;                    ///< why more were taken than were asked for, or ""
  std::vector<double> curvature_error;           ///< by vertex: K - target [radians]
  std::vector<double> turning_error;             ///< by basis loop: T minus the nearest multiple of pi/2 [radians]
  double              max_curvature_error = 0;   ///< [radians]
  double              max_holonomy_error = 0;    ///< over the basis loops [radians]
  double              max_transition_error = 0;  ///< over all edges of a frame propagated over all faces [radians]
  std::vector<double> history;                   ///< the greater of the first two maxima, before and after every step
};

/// A flat metric with cone singularities, discretely conformal to a triangulated surface.
struct Cone_metric
{
  Intrinsic_triangulation triangulation;  ///< Delaunay in the flat metric, with unscaled lengths l
  Integer_cochains        cochains;       ///< the canonical homology basis, carried along
  std::vector<Vertex>     cones;          ///< by singularity
  std::vector<int>        order;          ///< by vertex
  std::vector<double>     u;              ///< by vertex: log of the scale of lengths
  std::vector<double>     lengths;        ///< by edge, in the flat metric
  std::vector<double>     angles;         ///< by halfedge, at its source, in the flat metric
  Flow_report             flow;
};

/// computes the flat metric with the cones of a divisor by Newton's method on the discrete Ricci energy, which is
/// convex; the triangulation is kept Delaunay by Ptolemy flips.
///
/// Every cone is inserted as a vertex in its face (within 1e-4 of an edge length of a vertex it takes the vertex), every
/// corner on its boundary edge. Always returns: whether the tolerance was reached stands in `flow`.
///
/// Boundary edges are not flipped, so on a surface with boundary a step may break a triangle inequality: it is shortened.
/// That this is enough is measured, not proved, for triangulations without obtuse angles opposite boundary edges
/// (`split_obtuse_at_boundary()`).
/// \param t Delaunay triangulation; \param cochains its homology basis, relative to the boundary if there is one
/// \param warm_start the same divisor's metric for nearby positions, or null
/// \param factorized the factorised Laplacian of `t`, or null: it spares the first step's factorisation, and its order of
///        elimination is used again
/// \throws Infeasible_divisor_error if two singularities take the same vertex
/// Complexity: one sparse factorisation a Newton step.
Cone_metric cone_metric(const Intrinsic_triangulation& t, const Integer_cochains& cochains, const Divisor& divisor,
                        const Cone_metric* warm_start, const Cone_metric_options& options, Visitor& visitor,
                        const Laplacian_solver* factorized = nullptr);

/// A cone metric whose holonomy is exact, and how it was reached.
struct Exact_cone_metric
{
  Cone_metric         metric;
  Divisor             divisor;              ///< final positions
  std::vector<double> moved_by;             ///< length of the way of each singularity, surface units
  Flow_report         first_flow;           ///< of the divisor as it came
  Eigen::VectorXd     turning;              ///< T of the basis loops, radians
  std::vector<double> history;              ///< max deviation of T from multiples of pi/2, before and after every step
  double              max_holonomy_error;   ///< over the basis loops, radians
  double              max_transition_error; ///< over all edges of a cross frame propagated over all faces, and the
                                            ///< directions of boundary edges in it, radians
  bool                reached = false;      ///< everything within `accepted_holonomy`
};

/// moves the cones until the holonomy of the discrete flat metric is exact: Newton's method on the positions.
///
/// The first metric is only as good as the linear theory; two or three steps reach rounding. (METHOD, step 6: past the
/// paper, which accepts 0.1 to 0.3 degrees.) Always returns: see `reached`.
/// \param factorized as in `cone_metric()`
/// \throws Colliding_singularities_error if singularities run into each other
/// Complexity: a warm-started flow and 2g back-substitutions a step.
Exact_cone_metric exact_cone_metric(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                    const Divisor& divisor, const Cone_metric_options& options, Visitor& visitor,
                                    const Laplacian_solver* factorized = nullptr);

/// the derivative of the turning numbers of `metric` by the positions of the cones, two columns (x, y in the unfolded
/// frame of its face of `t`) a singularity, of a corner (along the boundary, 0); zero where a cone sits at a vertex of `t`
/// or is pinned.
Eigen::MatrixXd holonomy_jacobian(const Intrinsic_triangulation& t, const Integer_cochains& cochains,
                                  const Divisor& divisor, const Cone_metric_options& options, Visitor& visitor);

/// the deviation from the nearest multiple of pi/2, in [-pi/4, pi/4]
double quarter_turn_defect(double angle);

/// propagates a frame over a spanning tree of the faces and returns the largest deviation of the rotation across any
/// edge, and of the angle between any two boundary edges in this frame, from a multiple of pi/2. [radians]
double max_transition_error(const Intrinsic_triangulation& t, const std::vector<double>& angles);

} } // namespace CGAL::Quartic_differentials

#endif // CGAL_QUARTIC_DIFFERENTIALS_CONE_METRIC_H
