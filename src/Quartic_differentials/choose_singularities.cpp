// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/choose_singularities.h>
#include <CGAL/Quartic_differentials/direction_field.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/initial_divisor.h>
#include <CGAL/Quartic_differentials/internal/Moving_divisor.h>
#include <CGAL/Quartic_differentials/internal/Singularity_search.h>
#include <CGAL/Quartic_differentials/internal/boundary_walk.h>
#include <CGAL/Quartic_differentials/internal/counted.h>
#include <CGAL/Quartic_differentials/internal/distortion_descent.h>
#include <CGAL/Quartic_differentials/internal/vertex_places.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Moving_divisor;
using internal::Singularity_search;
using Candidate = Singularity_search::Candidate;

const int    patience = 8;             // pairs in a row that may fail to be worth it
const int    patience_where_met = 2;   // the same, if the wanted distortion can be met as it is
const int    lattice_vectors = 4;      // tried
const int    first_iterations = 15;    // of the descent for each of them; the best is continued
const int    exchanges = 20;
const int    most_that_fit = 700;      // disks of diameter 0.04 sqrt(area), about
const double slack = 1.2;              // fewer singularities are worth that factor of the wanted distortion
const double least_gain = 0.01;        // of a pair in the end, part of E
const double exchange_gain = 1.15;     // what exchanges may bring at the most, about
const int    tried_when_missed = 4;    // counts that are legalized when the distortion cannot be met
const double coarse_least_distance = 0.012;   // leaves room for the last Newton steps, times sqrt(area)

// Passes on the question whether to stop, but not the steps of every descent.
class Silent_visitor : public Visitor
{
public:
  explicit Silent_visitor(Visitor& visitor) : m_visitor(visitor) {}
  bool go_further() override { return m_visitor.go_further(); }
private:
  Visitor& m_visitor;
};

// A divisor on the Abel-Jacobi variety.
struct Legal_candidate
{
  Divisor divisor;
  double  distortion;
  double  area_scale_ratio;
};

// The number of singularities that is asked for, or the least possible one.
struct Counts
{
  int least, wanted;   // wanted 0: as many as the distortion asks for
};

// " with b boundary curves", or "".
std::string with_boundary(const Intrinsic_triangulation& t)
{
  const int b = t.number_of_boundary_curves();
  return b == 0 ? "" : " with " + internal::counted(b, "boundary curve");
}

bool only_corners(const Divisor& divisor)
{
  return std::all_of(divisor.begin(), divisor.end(), [](const Singularity& s) { return s.on_boundary; });
}

// In how many directions the singularities may move.
int degrees_of_freedom(const Divisor& divisor)
{
  int n = 0;
  for (const Singularity& s : divisor)
    if (!s.pinned) n += s.on_boundary ? 1 : 2;
  return n;
}

// On a surface with boundary the given corners may be enough, or pairs have to come so that the conditions can be met.
int least_count(const Abel_jacobi_map& map, const Divisor& given, const Legalization_options& legalization)
{
  const Intrinsic_triangulation& t = map.triangulation();
  const int missing = std::abs(required_degree(t) - degree(given)), count = static_cast<int>(given.size()) + missing;
  if (!t.has_boundary()) return count;
  if (missing == 0 && internal::is_legal(map, given, legalization.tolerance)) return count;
  const int lacking = map.dimension() - degrees_of_freedom(given) - 2 * missing;
  return count + 2 * ((std::max(lacking, 0) + 3) / 4);
}

Counts counts(const Abel_jacobi_map& map, const Divisor& given, const Singularity_choice_options& options,
              const Legalization_options& legalization)
{
  const Intrinsic_triangulation& t = map.triangulation();
  const int genus = t.genus(), least = least_count(map, given, legalization);
  if (options.count == 0) return {t.has_boundary() ? least : std::max(least, genus == 1 ? 4 : 1), 0};
  if (options.count < least)
    throw Infeasible_divisor_error("at least " + std::to_string(least) + " simple singularities are needed on a surface "
                                   "of genus " + std::to_string(genus) + with_boundary(t)
                                   + (given.empty() ? "" : " with those given") + ", not "
                                   + std::to_string(options.count));
  if (options.count > most_that_fit)
    throw Infeasible_divisor_error("the surface has no room for " + std::to_string(options.count) + " singularities");
  return {least, options.count + (options.count - least) % 2};
}

// The search on one surface, from the start to the best legal divisor. The first part, which ignores the Abel-Jacobi
// condition, may be left to the search on a coarser surface.
class Search
{
public:
  Search(const Riemann_surface& s, const std::vector<double>& mass, const Divisor& given,
         const Singularity_choice_options& options, const Legalization_options& legalization,
         const Distortion_options& descent, Visitor& visitor)
    : m_surface(s), m_map(s.delaunay, s.homology.cochains, s.forms), m_distortion(s.delaunay, s.laplacian, mass),
      m_given(given), m_options(options), m_legalization(legalization), m_descent(descent), m_visitor(visitor),
      m_silent(visitor),
      m_search(m_distortion, m_map, given.size(), m_options, m_descent, m_silent),
      m_counts(counts(m_map, given, options, legalization)), m_size(std::sqrt(s.delaunay.area()))
  {
  }

  // meets divisors of all counts of interest
  std::vector<Start_of_search> explore()
  {
    std::vector<Start_of_search> explored;
    for (Singularity_start start : starts()) explored.push_back(explore(start));
    return explored;
  }
  // the best divisor that was met for every count, here or else on a coarser surface
  const std::map<int, Candidate>& met() const { return m_met_elsewhere ? *m_met_elsewhere : m_search.best_by_count(); }
  void take_over(std::map<int, Candidate> met) { m_met_elsewhere = std::move(met); }

  // \param starts of the exploration. \pre divisors were met
  Chosen_singularities best(std::vector<Start_of_search> starts)
  {
    Chosen_singularities result;
    result.starts = std::move(starts);
    const std::optional<Legal_candidate> legal = m_counts.wanted != 0 ? with_count(m_counts.wanted) : with_fewest();
    if (!legal && m_refusal.empty())
      throw Infeasible_divisor_error("no singularities were found: the surface has too few vertices at which they could "
                                     "start; subdivide its triangles");
    if (!legal)
      throw Infeasible_divisor_error("no choice of singularities could be moved so that it satisfies the Abel-Jacobi "
                                     "condition: " + m_refusal);
    result.divisor = legal->divisor;
    result.distortion = legal->distortion;
    if (m_options.pareto) result.pareto = pareto(*legal);
    result.searched_vertices = m_surface.delaunay.number_of_vertices();
    result.solves = m_distortion.solves();
    return result;
  }

private:
  std::vector<Singularity_start> starts()
  {
    if (m_options.start != Singularity_start::automatic) return {m_options.start};
    if (only_corners(m_given) && field().size() <= m_options.field_limit)
      return {Singularity_start::field, Singularity_start::pairs};
    return {Singularity_start::pairs};
  }
  const Divisor& field()
  {
    if (!m_field) m_field = direction_field_divisor(m_surface.delaunay, m_surface.weights, m_options.seed, m_given);
    return *m_field;
  }

  Divisor start_divisor(Singularity_start start)
  {
    if (start == Singularity_start::pairs) return m_search.completed(m_given);
    if (start == Singularity_start::field && only_corners(m_given)) {
      Divisor divisor = m_given;
      divisor.insert(divisor.end(), field().begin(), field().end());
      return divisor;
    }
    if (!m_given.empty())
      throw Infeasible_divisor_error("given singularities can only be completed by pairs, not from the field or the "
                                     "curvature");
    if (m_surface.delaunay.has_boundary())
      throw Infeasible_divisor_error("on a surface with boundary singularities are chosen from the field or by pairs, "
                                     "not from the curvature");
    return curvature_divisor(m_surface.delaunay, m_surface.weights, m_surface.laplacian, m_counts.wanted);
  }

  Start_of_search explore(Singularity_start start)
  {
    const Divisor first = start_divisor(start);
    const Eigen::VectorXd u = m_distortion.log_scale(first);
    const Candidate c = m_search.relaxed(first, 100);
    if (m_counts.wanted != 0) adjust_count(c);
    else prune(grown(c, m_options.distortion));
    return {start == Singularity_start::pairs ? "pairs" : start == Singularity_start::field ? "field" : "curvature",
            static_cast<int>(first.size()), m_distortion.energy(u), area_scale_ratio(u, m_distortion.mass())};
  }

  // a divisor that was met, as a local minimum on this surface
  Candidate here(const Candidate& c) { return m_met_elsewhere ? m_search.relaxed(c.divisor) : c; }

  // The triangles of a coarser surface may be too large for so many singularities, and its E too low: pairs are added here
  // to the first count that was good enough there, or else to the one of the best price.
  void explore_further()
  {
    const auto preferred = [&](const auto& a, const auto& b) {
      const bool is_enough = a.second.energy <= m_options.distortion;
      if (is_enough != (b.second.energy <= m_options.distortion)) return is_enough;
      return is_enough ? a.first < b.first : price(a.second) < price(b.second);
    };
    prune(grown(here(std::min_element(met().begin(), met().end(), preferred)->second), m_options.distortion));
    m_met_elsewhere.reset();
  }

  std::optional<Legal_candidate> with_count(int count)
  {
    const auto found = met().find(count);
    if (found == met().end())
      throw Infeasible_divisor_error("the surface has no room for " + std::to_string(count) + " singularities");
    return legal_best(m_search.exchanged(here(found->second), exchanges), lattice_vectors);
  }

  // the fewest singularities that meet the wanted distortion; where none do, those of the best price
  std::optional<Legal_candidate> with_fewest()
  {
    const double goal = slack * m_options.distortion;
    if (std::optional<Legal_candidate> legal = with_fewest(goal, 0)) return with_fewer_pairs(*legal, goal);
    if (m_met_elsewhere) {
      explore_further();
      if (std::optional<Legal_candidate> legal = with_fewest(goal, 0)) return with_fewer_pairs(*legal, goal);
    }
    // exchanges take as long as all else, and are rarely needed
    if (std::optional<Legal_candidate> legal = with_fewest(goal, exchanges)) return with_fewer_pairs(*legal, goal);
    const std::optional<Legal_candidate> legal = with_best_price();
    if (!legal) return std::nullopt;
    return with_fewer_pairs(*legal, std::numeric_limits<double>::infinity());
  }

  // of the counts in ascending order the first that has a legal place which meets the goal, after some exchanges; fewer
  // where zeros can be merged
  std::optional<Legal_candidate> with_fewest(double goal, int times)
  {
    const std::map<int, Candidate> known = met();
    for (const auto& [count, first_met] : known) {
      if (count < m_counts.least || first_met.energy > (times == 0 ? goal : exchange_gain * goal)) continue;
      const Candidate candidate = here(first_met);
      const Candidate c = m_search.exchanged(candidate, times);
      if (c.energy > goal || (times > 0 && c.energy == candidate.energy)) continue;   // or was refused without exchanges
      if (std::optional<Legal_candidate> legal = legal_within(c, goal)) return legal;
    }
    return std::nullopt;
  }

  // with zeros merged where that meets the goal, too
  std::optional<Legal_candidate> legal_within(const Candidate& c, double goal)
  {
    const std::optional<Legal_candidate> legal = legal_best(c, lattice_vectors);
    if (legal && legal->distortion > goal) return std::nullopt;
    const Candidate merged = m_search.merged(c);
    if (merged.count() < c.count()) {
      const std::optional<Legal_candidate> fewer = legal_best(merged, lattice_vectors);
      if (fewer && fewer->distortion <= goal) return fewer;
    }
    return legal;
  }

  // A candidate is not where a lattice vector took it: the search goes on from there. Pairs are taken away as long as they
  // are not worth it and the goal is met.
  Legal_candidate with_fewer_pairs(Legal_candidate best, double goal)
  {
    for (;;) {
      // where the wanted distortion is far away, a pair is to lower E by a hundredth at least
      const double most = price(best) + std::max(0.0, least_gain * best.distortion - m_options.worth);
      const std::optional<Candidate> c = m_search.without_pair(m_search.relaxed(best.divisor));
      if (!c || c->count() < m_counts.least || c->energy > goal || price(*c) > most + m_options.worth) return best;
      tell(*c);
      std::optional<Legal_candidate> fewer = legal_within(*c, goal);
      if (!fewer || price(*fewer) > most) return best;
      best = std::move(*fewer);
    }
  }

  double price(double distortion, const Divisor& divisor) const
  { return distortion + 0.5 * m_options.worth * static_cast<double>(divisor.size()); }
  double price(const Candidate& c) const { return price(c.energy, c.divisor); }
  double price(const Legal_candidate& c) const { return price(c.distortion, c.divisor); }

  std::optional<Legal_candidate> with_best_price()
  {
    std::vector<Candidate> candidates;
    for (const auto& [count, candidate] : met())
      if (count >= m_counts.least) candidates.push_back(candidate);
    std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
      return price(a) < price(b);
    });
    std::optional<Legal_candidate> best;
    int tried = 0;
    for (const Candidate& c : candidates) {
      if (best && tried >= tried_when_missed) break;
      ++tried;
      std::optional<Legal_candidate> legal = legal_best(c, lattice_vectors);
      if (legal && (!best || price(*legal) < price(*best))) best = std::move(legal);
    }
    return best;
  }

  bool is_met() const
  {
    const auto& met = m_search.best_by_count();
    return std::any_of(met.begin(), met.end(), [&](const auto& c) {
      return c.first >= m_counts.least && c.second.energy <= slack * m_options.distortion;
    });
  }

  bool has_room(const Candidate& c) const { return c.count() + 2 <= std::max(m_options.most_singularities, m_counts.least); }

  void adjust_count(Candidate c)
  {
    while (c.count() != m_counts.wanted) {
      std::optional<Candidate> next = c.count() < m_counts.wanted ? m_search.with_pair(c) : m_search.without_pair(c);
      if (!next) return;
      c = std::move(*next);
      tell(c);
    }
  }

  // adds pairs until E is low enough, or some in a row are not worth it
  Candidate grown(Candidate c, double wanted)
  {
    Candidate best = c;
    const int most_failures = is_met() ? patience_where_met : patience;
    int failed = 0;
    while ((c.energy > wanted || c.count() < m_counts.least) && has_room(c)) {
      std::optional<Candidate> more = m_search.with_pair(c);
      if (!more) break;
      c = std::move(*more);
      tell(c);
      const int pairs = (c.count() - best.count()) / 2;
      if (c.energy <= best.energy - m_options.worth * pairs || c.count() <= m_counts.least) {
        best = c;
        failed = 0;
      } else if (++failed > most_failures) {
        break;
      }
    }
    return best;
  }

  // takes pairs away until they are needed, and worth it
  void prune(Candidate c)
  {
    const double enough = exchange_gain * slack * m_options.distortion;
    while (c.count() - 2 >= m_counts.least) {
      std::optional<Candidate> fewer = m_search.without_pair(c);
      if (!fewer) return;
      if (fewer->energy > enough && fewer->energy > c.energy + m_options.worth) return;
      c = std::move(*fewer);
      tell(c);
    }
  }

  // the best local minimum on the Abel-Jacobi variety, of those that belong to the nearest lattice vectors
  std::optional<Legal_candidate> legal_best(const Candidate& c, int vectors)
  {
    const Moving_divisor free(m_map, c.divisor);
    try {
      check_orders(c.divisor, m_surface.delaunay.genus(), m_surface.delaunay.number_of_boundary_curves());
      const std::vector<Eigen::VectorXd> lattice = lattice_vectors_near(free, vectors);
      std::optional<internal::Descent> best;
      const Eigen::VectorXd* best_m = nullptr;
      for (const Eigen::VectorXd& m : lattice) {
        std::optional<internal::Descent> d = descended(free, m, first_iterations);
        if (d && (!best || d->distortion() < best->distortion())) {
          best = std::move(d);
          best_m = &m;
        }
      }
      if (best) best = descended(best->divisor, *best_m, m_descent.iterations);
      if (!best) return std::nullopt;
      return Legal_candidate{best->divisor.divisor(), best->distortion(),
                             area_scale_ratio(best->u, m_distortion.mass())};
    } catch (const Infeasible_divisor_error& e) {   // this divisor has no legal place; another may have one
      m_refusal = e.what();
      return std::nullopt;
    }
  }

  // The nearest ones; only the one it is at, where corners are legal at their places.
  std::vector<Eigen::VectorXd> lattice_vectors_near(const Moving_divisor& d, int vectors)
  {
    if (m_surface.delaunay.has_boundary() && internal::is_legal(m_map, d.divisor(), m_legalization.tolerance))
      return {internal::rounded_to_lattice(d.residual())};
    m_legalization.lattice_vectors = vectors;
    return nearest_lattice_vectors(d, m_surface.periods, m_legalization).vectors;
  }

  std::optional<internal::Descent> descended(Moving_divisor d, const Eigen::VectorXd& m, int iterations)
  {
    std::vector<double> history;
    const internal::Newton_limits limits{m_descent.tolerance, 60, m_descent.longest_step * m_size};
    if (!internal::move_onto_lattice(d, m, limits, history, m_silent)) {
      m_refusal = "no lattice vector near by can be reached";
      return std::nullopt;
    }
    Distortion_options options = m_descent;
    options.iterations = iterations;
    internal::Descent descent = internal::descend(m_distortion, d, m, options, m_silent);
    const std::string reason = collision(m_surface.delaunay, descent.divisor.divisor(), coarse_least_distance);
    if (!reason.empty()) {
      m_refusal = "singularities run into each other: " + reason;
      return std::nullopt;
    }
    return descent;
  }

  // of every count the best that was met, without those more distorted than one of fewer singularities
  std::vector<Pareto_point> pareto(const Legal_candidate& chosen)
  {
    if (m_met_elsewhere)
      for (const auto& [count, candidate] : *m_met_elsewhere) here(candidate);   // so that this surface's table has them all
    grown(m_search.best_by_count().begin()->second, 0.25 * m_options.distortion);
    std::map<int, Pareto_point> points;
    const std::map<int, Candidate> candidates = m_search.best_by_count();
    for (const auto& [count, candidate] : candidates)
      if (count >= m_counts.least)
        if (const std::optional<Legal_candidate> legal = legal_best(candidate, 1))
          points[count] = {count, legal->distortion, legal->area_scale_ratio};
    const int count = static_cast<int>(chosen.divisor.size());
    points[count] = {count, chosen.distortion, chosen.area_scale_ratio};
    std::vector<Pareto_point> front;
    for (const auto& [n, point] : points)
      if (front.empty() || point.distortion < front.back().distortion || n == count) front.push_back(point);
    return front;
  }

  void tell(const Candidate& c)
  {
    std::ostringstream message;
    message << c.count() << " singularities: area distortion " << c.energy << " without the Abel-Jacobi condition";
    m_visitor.progress(message.str());
  }

  const Riemann_surface&     m_surface;
  Abel_jacobi_map            m_map;
  Area_distortion            m_distortion;
  Divisor                    m_given;
  Singularity_choice_options m_options;
  Legalization_options       m_legalization;
  Distortion_options         m_descent;
  Visitor&                   m_visitor;
  Silent_visitor             m_silent;
  Singularity_search         m_search;
  Counts                     m_counts;
  double                     m_size;
  std::optional<std::map<int, Candidate>> m_met_elsewhere;   // on a coarser surface, carried here, not yet relaxed
  std::optional<Divisor>     m_field;
  std::string                m_refusal;
};

// The place on the boundary of another triangulation that has the same boundary edges, by the vertex it has there.
Surface_point same_place_on_boundary(const Intrinsic_triangulation& from, const Surface_point& p,
                                     const Intrinsic_triangulation& to, const std::vector<Vertex>& vertex)
{
  const internal::Boundary_place place = internal::boundary_place(from, p);
  return on_edge(to, to.halfedge_from(vertex[from.source(place.halfedge)]), place.fraction);
}

// Carries a divisor from a coarse surface to the fine one; those that are given and pinned stay exactly where they are,
// and corners on their boundary edges.
Divisor on_fine_surface(const Riemann_surface& fine, const Coarse_surface& coarse, const Divisor& given, Divisor divisor)
{
  for (std::size_t i = 0; i < divisor.size(); ++i) {
    Surface_point& p = divisor[i].location;
    p = i < given.size() && given[i].pinned ? given[i].location
      : divisor[i].on_boundary ? same_place_on_boundary(coarse.triangulation, p, fine.delaunay, coarse.fine_vertex)
      : on_fine_surface(coarse, p, fine.delaunay);
  }
  return divisor;
}

// On the fine surface singularities may be nearer to each other than on the coarse one: the guard drives them apart.
Divisor separated(const Riemann_surface& s, const Divisor& divisor, Distortion_options options, Visitor& visitor)
{
  if (collision(s.delaunay, divisor, coarse_least_distance).empty()) return divisor;
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  const Area_distortion distortion(s.delaunay, s.laplacian, vertex_areas(s.delaunay));
  options.iterations = first_iterations;
  return internal::descend(distortion, Moving_divisor(map, divisor), std::nullopt, options, visitor).divisor.divisor();
}

// Given singularities on the coarse surface: at the nearest of its vertices along edges of the fine one; corners where
// they are.
Divisor on_coarse_surface(const Riemann_surface& fine, const Coarse_surface& coarse, Divisor given)
{
  std::vector<Vertex> coarse_vertex(fine.delaunay.number_of_vertices(), Mesh::null_vertex());
  for (Vertex v : coarse.triangulation.vertices()) coarse_vertex[coarse.fine_vertex[v]] = v;
  for (Singularity& s : given) {
    if (s.on_boundary) {
      s.location = same_place_on_boundary(fine.delaunay, s.location, coarse.triangulation, coarse_vertex);
      continue;
    }
    const Vertex v = internal::nearest_corner(fine.delaunay, s.location);
    internal::visit_nearest_first(fine.delaunay, v, [&](Vertex w, double) {
      if (coarse_vertex[w] == Mesh::null_vertex()) return true;
      s.location = internal::beside(coarse.triangulation, coarse_vertex[w]);
      return false;
    });
  }
  return given;
}

// What is given, if it is legal and distorts areas no more than is wanted: corners of a plate, and no singularities.
std::optional<Chosen_singularities> given_alone(const Riemann_surface& s, const Divisor& given,
                                                const Singularity_choice_options& options, double tolerance)
{
  const Abel_jacobi_map map(s.delaunay, s.homology.cochains, s.forms);
  for (const Singularity& p : given)
    if (p.on_boundary) map.lift_on_boundary(p.location);   // throws where it is not
  if (options.count != 0 || options.pareto || degree(given) != required_degree(s.delaunay)
      || !internal::is_legal(map, given, tolerance))
    return std::nullopt;
  const Area_distortion distortion(s.delaunay, s.laplacian, vertex_areas(s.delaunay));
  const Eigen::VectorXd u = distortion.log_scale(given);
  const double e = distortion.energy(u);
  if (e > options.distortion) return std::nullopt;
  const Start_of_search start{"pairs", static_cast<int>(given.size()), e, area_scale_ratio(u, distortion.mass())};
  return Chosen_singularities{given, e, {start}, {}, s.delaunay.number_of_vertices(), distortion.solves()};
}

// The choice on a surface of moderate size. Where its singularities should be is explored on a coarser one, where the
// thousands of descents take less time; what is found there is a local minimum here after a few steps.
Chosen_singularities chosen_on(const Riemann_surface& s, const std::vector<double>& mass, const Divisor& given,
                               const Singularity_choice_options& options, const Legalization_options& legalization,
                               const Distortion_options& distortion, Visitor& visitor)
{
  Search search(s, mass, given, options, legalization, distortion, visitor);
  if (s.delaunay.number_of_vertices() <= options.explored_vertices) return search.best(search.explore());

  const Coarse_surface coarse = coarsened(s.delaunay, s.homology.cochains, mass, options.explored_vertices);
  const Riemann_surface explored = riemann_surface(coarse);
  Search exploration(explored, coarse.mass, on_coarse_surface(s, coarse, given), options, legalization, distortion,
                     visitor);
  std::vector<Start_of_search> starts = exploration.explore();
  std::map<int, Candidate> met = exploration.met();
  for (auto& [count, candidate] : met) candidate.divisor = on_fine_surface(s, coarse, given, std::move(candidate.divisor));
  search.take_over(std::move(met));
  return search.best(std::move(starts));
}

} // namespace

Chosen_singularities choose_singularities(const Riemann_surface& surface, const Divisor& given,
                                          const Singularity_choice_options& options,
                                          const Legalization_options& legalization,
                                          const Distortion_options& distortion, Visitor& visitor)
{
  if (surface.delaunay.has_boundary())
    if (auto chosen = given_alone(surface, given, options, legalization.tolerance)) return *chosen;
  if (surface.delaunay.number_of_vertices() <= options.coarse_vertices)
    return chosen_on(surface, vertex_areas(surface.delaunay), given, options, legalization, distortion, visitor);

  const Coarse_surface coarse = coarsened(surface.delaunay, surface.homology.cochains, options.coarse_vertices);
  Chosen_singularities chosen = chosen_on(riemann_surface(coarse), coarse.mass, on_coarse_surface(surface, coarse, given),
                                          options, legalization, distortion, visitor);
  chosen.divisor = separated(surface, on_fine_surface(surface, coarse, given, std::move(chosen.divisor)), distortion,
                             visitor);
  return chosen;
}

} } // namespace CGAL::Quartic_differentials
