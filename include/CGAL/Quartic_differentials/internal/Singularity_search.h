// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SINGULARITY_SEARCH_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SINGULARITY_SEARCH_H

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/abel_jacobi_map.h>
#include <CGAL/Quartic_differentials/choose_singularities.h>
#include <CGAL/Quartic_differentials/divisor.h>
#include <CGAL/Quartic_differentials/internal/vertex_places.h>

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The moves of the search for singularities of low distortion that ignores the Abel-Jacobi condition. Every move ends
/// in a local minimum. Only in the interior are singularities added; corners are among those that must stay.
class Singularity_search
{
public:
  struct Candidate
  {
    Divisor         divisor;   ///< the first ones are those that must stay
    Eigen::VectorXd u;
    double          energy;    ///< E and the guard

    int count() const { return static_cast<int>(divisor.size()); }
  };

  /// Keeps references to everything.
  /// \param kept number of singularities at the front of every divisor that must stay
  Singularity_search(const Area_distortion& distortion, const Abel_jacobi_map& map, std::size_t kept,
                     const Singularity_choice_options& options, const Distortion_options& descent, Visitor& visitor);

  /// simple singularities are added one by one at extrema of the potential until the degree is 8g - 8 + 4b
  Divisor completed(Divisor divisor) const;
  /// a local minimum near by, roughly
  Candidate relaxed(const Divisor& divisor, int iterations = 40);
  /// with a pole and a zero more, one of the pairs whose addition lowers E most; none if there is no room
  std::optional<Candidate> with_pair(const Candidate& c);
  /// without a simple pole and a simple zero, one of the pairs whose removal raises E least; none if there are no such pairs
  std::optional<Candidate> without_pair(const Candidate& c);
  /// pairs, or single singularities, are put elsewhere as long as that lowers E
  Candidate exchanged(Candidate c, int times);
  /// singularities of the same sign that met are merged, within the allowed orders and if that costs less than a
  /// fifth of what a pair is worth
  Candidate merged(Candidate c);

  /// the best divisor that was met for every count
  const std::map<int, Candidate>& best_by_count() const { return m_best; }

private:
  std::vector<Divisor> additions(const Candidate& c, std::size_t most) const;
  std::vector<Divisor> removals(const Candidate& c, std::size_t most) const;
  std::optional<Candidate> best_relaxed(const std::vector<Divisor>& divisors, double enough);
  std::optional<Candidate> with_one_elsewhere(const Candidate& c);
  std::optional<Candidate> with_another_pair(const Candidate& c);
  std::vector<Vertex> extrema(const Divisor& divisor, const Eigen::VectorXd& w, int sign, int count) const;

  const Area_distortion&            m_distortion;
  const Abel_jacobi_map&            m_map;
  const Intrinsic_triangulation&    m_t;
  std::size_t                       m_kept;
  const Singularity_choice_options& m_options;
  const Distortion_options&         m_descent;
  Visitor&                          m_visitor;
  double                            m_size;
  Taken_vertices                    m_near_boundary;
  std::map<int, Candidate>          m_best;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_SINGULARITY_SEARCH_H
