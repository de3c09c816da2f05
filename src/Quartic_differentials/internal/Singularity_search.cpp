// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/Singularity_search.h>
#include <CGAL/Quartic_differentials/internal/distortion_descent.h>
#include <CGAL/Quartic_differentials/internal/near_pairs.h>
#include <CGAL/Quartic_differentials/internal/vertex_places.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

using Candidate = Singularity_search::Candidate;

const double quarter_turn = CGAL_PI / 2;
// distances, times sqrt(area)
const double from_singularities = 0.04;   // of a new one
const double between_extrema    = 0.12;   // of the places looked at for a new one
const double merge_distance     = 0.05;
const int    extrema_of_each_sign = 3;
const std::size_t additions_tried = 2, removals_tried = 3;
const std::size_t moves_tried = 3;
const double worth_moving = 1e-3;   // part of E that a move has to gain
const double rough = 1e-3;          // as `Distortion_options::enough`

struct Pair_change
{
  double      change;   // of E
  std::size_t first, second;
  bool operator<(const Pair_change& other) const { return change < other.change; }
};

std::vector<Pair_change> first_few(std::vector<Pair_change> changes, std::size_t most)
{
  const std::size_t n = std::min(most, changes.size());
  std::partial_sort(changes.begin(), changes.begin() + n, changes.end());
  changes.resize(n);
  return changes;
}

} // namespace

Singularity_search::Singularity_search(const Area_distortion& distortion, const Abel_jacobi_map& map, std::size_t kept,
                                       const Singularity_choice_options& options, const Distortion_options& descent,
                                       Visitor& visitor)
  : m_distortion(distortion), m_map(map), m_t(distortion.triangulation()), m_kept(kept), m_options(options),
    m_descent(descent), m_visitor(visitor), m_size(std::sqrt(m_t.area())),
    m_near_boundary(near_boundary(m_t))
{}

// The vertices where sign * w is least, apart from each other, from the singularities and from the boundary.
std::vector<Vertex> Singularity_search::extrema(const Divisor& divisor, const Eigen::VectorXd& w, int sign,
                                                int count) const
{
  Taken_vertices taken = m_near_boundary;
  for (const Singularity& s : divisor) taken.take(nearest_corner(m_t, s.location), from_singularities * m_size);
  std::vector<Vertex> found;
  while (static_cast<int>(found.size()) < count) {
    Vertex best = Mesh::null_vertex();
    for (Vertex v : m_t.vertices())
      if (!taken[v] && (best == Mesh::null_vertex() || sign * w[v] < sign * w[best])) best = v;
    if (best == Mesh::null_vertex()) break;
    found.push_back(best);
    taken.take(best, between_extrema * m_size);
  }
  return found;
}

Divisor Singularity_search::completed(Divisor divisor) const
{
  const int missing = required_degree(m_t) - degree(divisor), order = missing > 0 ? 1 : -1;
  for (int k = 0; k < std::abs(missing); ++k) {
    const Eigen::VectorXd w = m_distortion.potential(m_distortion.log_scale(divisor));
    const std::vector<Vertex> place = extrema(divisor, w, -order, 1);   // poles at minima, zeros at maxima
    if (place.empty())
      throw Infeasible_divisor_error("the surface has no room for " + std::to_string(std::abs(missing))
                                     + " more singularities: the vertices at which they start are too few or too near "
                                     "each other; use fewer, or subdivide the triangles");
    divisor.push_back({beside(m_t, place.front()), order, false});
  }
  return divisor;
}

Candidate Singularity_search::relaxed(const Divisor& divisor, int iterations)
{
  Distortion_options options = m_descent;
  options.iterations = iterations;
  options.enough = rough;
  Descent descent = descend(m_distortion, Moving_divisor(m_map, divisor), std::nullopt, options, m_visitor);
  Candidate c{descent.divisor.divisor(), std::move(descent.u), descent.history.back().objective};
  const auto [best, is_new] = m_best.emplace(c.count(), c);
  if (!is_new && c.energy < best->second.energy) best->second = c;
  return c;
}

// The best of the first few, which are relaxed until one is good enough.
std::optional<Candidate> Singularity_search::best_relaxed(const std::vector<Divisor>& divisors, double enough)
{
  std::optional<Candidate> best;
  for (const Divisor& divisor : divisors) {
    Candidate tried = relaxed(divisor);
    if (!best || tried.energy < best->energy) best = std::move(tried);
    if (best->energy < enough) break;
  }
  return best;
}

// With a pole and a zero more: of all pairs of extrema of the potential those that change E best, the best one first.
std::vector<Divisor> Singularity_search::additions(const Candidate& c, std::size_t most) const
{
  const Eigen::VectorXd w = m_distortion.potential(c.u);
  const std::vector<Vertex> poles = extrema(c.divisor, w, +1, extrema_of_each_sign);
  const std::vector<Vertex> zeros = extrema(c.divisor, w, -1, extrema_of_each_sign);
  Divisor added;
  for (Vertex v : poles) added.push_back({beside(m_t, v), -1, false});
  for (Vertex v : zeros) added.push_back({beside(m_t, v), +1, false});
  const Charge_changes changes(m_distortion, c.u, m_distortion.greens_functions(locations(added)));
  std::vector<Pair_change> pairs;
  for (std::size_t p = 0; p < poles.size(); ++p)
    for (std::size_t z = poles.size(); z < added.size(); ++z)
      if (poles[p] != zeros[z - poles.size()])
        pairs.push_back({changes.of_pair(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(z), quarter_turn), p, z});
  std::vector<Divisor> divisors;
  for (const Pair_change& pair : first_few(std::move(pairs), most)) {
    divisors.push_back(c.divisor);
    divisors.back().push_back(added[pair.first]);
    divisors.back().push_back(added[pair.second]);
  }
  return divisors;
}

// Without a simple pole and a simple zero: of all such pairs those that change E best, the best one first.
std::vector<Divisor> Singularity_search::removals(const Candidate& c, std::size_t most) const
{
  Divisor removable;
  std::vector<std::size_t> index;
  for (std::size_t i = m_kept; i < c.divisor.size(); ++i)
    if (std::abs(c.divisor[i].order) == 1) {
      removable.push_back(c.divisor[i]);
      index.push_back(i);
    }
  const Charge_changes changes(m_distortion, c.u, m_distortion.greens_functions(locations(removable)));
  std::vector<Pair_change> pairs;
  for (std::size_t p = 0; p < removable.size(); ++p)
    for (std::size_t z = 0; z < removable.size(); ++z)
      if (removable[p].order == -1 && removable[z].order == 1)
        pairs.push_back({changes.of_pair(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(z), -quarter_turn),
                         index[p], index[z]});
  std::vector<Divisor> divisors;
  for (const Pair_change& pair : first_few(std::move(pairs), most)) {
    divisors.push_back(c.divisor);
    divisors.back().erase(divisors.back().begin() + std::max(pair.first, pair.second));
    divisors.back().erase(divisors.back().begin() + std::min(pair.first, pair.second));
  }
  return divisors;
}

std::optional<Candidate> Singularity_search::with_pair(const Candidate& c)
{
  return best_relaxed(additions(c, additions_tried), c.energy - m_options.worth);
}

std::optional<Candidate> Singularity_search::without_pair(const Candidate& c)
{
  return best_relaxed(removals(c, removals_tried), c.energy + m_options.worth);
}

// Moves one simple singularity to a far place: of all such moves the ones that change E best are tried.
std::optional<Candidate> Singularity_search::with_one_elsewhere(const Candidate& c)
{
  const Eigen::VectorXd w = m_distortion.potential(c.u);
  Divisor divisor = c.divisor;
  for (int order : {-1, 1})
    for (Vertex v : extrema(c.divisor, w, -order, extrema_of_each_sign))
      divisor.push_back({beside(m_t, v), order, false});
  const Charge_changes changes(m_distortion, c.u, m_distortion.greens_functions(locations(divisor)));
  std::vector<Pair_change> moves;
  for (std::size_t i = m_kept; i < c.divisor.size(); ++i)
    for (std::size_t k = c.divisor.size(); k < divisor.size(); ++k)
      if (divisor[i].order == divisor[k].order)
        moves.push_back({changes.of_pair(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i),
                                         -divisor[i].order * quarter_turn), i, k});
  for (const Pair_change& move : first_few(std::move(moves), moves_tried)) {
    Divisor moved = c.divisor;
    moved[move.first].location = divisor[move.second].location;
    Candidate tried = relaxed(moved);
    if (tried.energy < (1 - worth_moving) * c.energy) return tried;
  }
  return std::nullopt;
}

std::optional<Candidate> Singularity_search::with_another_pair(const Candidate& c)
{
  for (const Divisor& more : additions(c, additions_tried)) {
    std::optional<Candidate> again = without_pair(relaxed(more));
    if (again && again->energy < (1 - worth_moving) * c.energy) return again;
  }
  return std::nullopt;
}

Candidate Singularity_search::exchanged(Candidate c, int times)
{
  for (int k = 0; k < times; ++k) {
    std::optional<Candidate> better = with_another_pair(c);
    if (!better) better = with_one_elsewhere(c);
    if (!better) break;
    c = std::move(*better);
  }
  return c;
}

Candidate Singularity_search::merged(Candidate c)
{
  std::set<std::pair<std::size_t, std::size_t>> refused;
  for (;;) {
    double nearest = std::numeric_limits<double>::infinity();
    std::pair<std::size_t, std::size_t> pair;
    std::complex<double> middle;   // from the first of them
    visit_near_pairs(m_t, locations(c.divisor), merge_distance * m_size,
                     [&](std::size_t i, std::size_t k, std::complex<double> way) {
      const int a = c.divisor[i].order, b = c.divisor[k].order;
      if (i > k || i < m_kept || (a > 0) != (b > 0) || a + b < m_options.least_order || a + b > m_options.most_order
          || refused.count({i, k}) || std::abs(way) >= nearest)
        return;
      nearest = std::abs(way);
      pair = {i, k};
      middle = 0.5 * way;
    });
    if (!std::isfinite(nearest)) return c;
    Divisor divisor = c.divisor;
    Singularity& s = divisor[pair.first];
    s.order += divisor[pair.second].order;
    s.location = walk(m_t, s.location, middle, [](const Surface_point&, const Surface_point&) {}).point;
    divisor.erase(divisor.begin() + pair.second);
    Candidate tried = relaxed(divisor);
    if (tried.energy < c.energy + 0.05 * m_options.worth) {
      c = std::move(tried);
      refused.clear();
    } else {
      refused.insert(pair);
    }
  }
}

} } } // namespace CGAL::Quartic_differentials::internal
