// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/closest_vector.h>
#include <CGAL/Quartic_differentials/internal/Lattice_basis.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <tuple>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 5)
//   W, x    the Gram matrix and the target, exactly as given
//   U       the reduced basis, by columns: m = U (o + k), o the rounded coordinates of x in it
//   y       what is left of the coordinates of x after rounding, in [-1/2, 1/2]
//   R       upper triangular, R^T R = U^T W U up to rounding
//   d(k)    the distance of x and m, which is |R (y - k)| up to rounding

namespace {

using internal::Big_integer;
using internal::Dyadic_numbers;
using internal::Lattice_basis;

const double epsilon = 0x1p-53;

// The target in the reduced basis.
struct Reduced_target
{
  std::vector<std::int64_t> offset;   // o
  Eigen::VectorXd           y;        // every entry with an error below 2^-52
};

// floor(n / 2^bits) for bits >= 0
Big_integer floor_shift(const Big_integer& n, int bits)
{
  if (n >= 0) return n >> bits;
  return -((-n + (Big_integer(1) << bits) - 1) >> bits);
}

std::int64_t checked_int64(const Big_integer& n)
{
  if (n > std::numeric_limits<std::int64_t>::max() || n < std::numeric_limits<std::int64_t>::min())
    throw Numerical_error("the target of a closest vector problem leaves the range of 64-bit integers");
  return static_cast<std::int64_t>(n);
}

Reduced_target reduced(const Lattice_basis& lattice, const Dyadic_numbers& x)
{
  const int n = lattice.dimension(), bits = std::max(0, -x.exponent), up = std::max(0, x.exponent);
  const Big_integer half = bits > 0 ? Big_integer(1) << (bits - 1) : Big_integer(0);
  Reduced_target result{std::vector<std::int64_t>(n), Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    Big_integer sum = 0;    // U^-1 x in units of 2^-bits
    for (int j = 0; j < n; ++j) sum += (x.integer[j] << up) * lattice.dual()(j, i);
    const Big_integer whole = floor_shift(sum + half, bits);
    result.offset[i] = checked_int64(whole);
    result.y[i] = internal::rounded(sum - (whole << bits), -bits);
  }
  return result;
}

// How far a computed |R (y - k)| may be from the true distance d(k), as relative * d(k) + absolute.
struct Rounding
{
  double relative, absolute;

  // no more than d(k)^2 if |R (y - k)|^2 is computed as `squared_distance` or more
  double lowered(double squared_distance) const
  {
    const double distance = std::sqrt(squared_distance) * (1 - relative) - absolute;
    const double own_rounding = 0x1p-48;
    return distance > 0 ? distance * distance * (1 - own_rounding) : 0;
  }
};

// Bounds, with D the diagonal matrix of the column lengths of R, and n the dimension:
// - R^T R = U^T W U + E with |E_ij| <= (n + 5) eps D_i D_j (rounding of the Gram matrix; Higham, Accuracy and Stability
//   of Numerical Algorithms, theorem 10.3), hence a relative error of at most n (n + 5) eps |D R^-1|^2 in d^2,
// - with |y_j - k_j| <= |row j of R^-1| d, the sums in R (y - k) are off by at most
//   (n + 5) eps | |R| (|row j of R^-1|)_j | d,
// - y is off by at most 2^-52 in every entry.
// Every bound is doubled, which covers second order terms and the rounding of the bounds themselves.
Rounding rounding(const Eigen::MatrixXd& R)
{
  const double n = static_cast<double>(R.rows());
  const Eigen::MatrixXd inverse = R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(R.rows(), R.rows()));
  const Eigen::VectorXd row_norms = inverse.rowwise().norm(), lengths = R.colwise().norm();
  const double gram = n * (n + 5) * epsilon * (lengths.asDiagonal() * inverse).squaredNorm();
  const double sums = (n + 5) * epsilon * (R.cwiseAbs() * row_norms).norm();
  const double largest = 1e-3;   // far below it in a reduced basis
  if (!(gram < largest && sums < largest))
    throw Numerical_error("the Gram matrix of a lattice is not positive definite beyond rounding");
  return {2 * (gram + sums), 2 * 0x1p-52 * R.cwiseAbs().rowwise().sum().norm()};
}

// Depth first search in the tree whose level i fixes k_i, nearest children first (Schnorr and Euchner). The cost of a
// node, the squared length of the last entries of R (y - k), is computed by adding squares, so that rounding does not
// let it fall from a node to its children.
class Enumeration
{
public:
  struct Leaf
  {
    double          squared_distance;
    Eigen::VectorXd k;
  };

  // \param limit no node of a larger cost is entered. Without a limit, the search is not stopped before its first leaf.
  Enumeration(const Eigen::MatrixXd& R, const Eigen::VectorXd& y, const Rounding& rounding,
              const Closest_vector_options& options, double limit = std::numeric_limits<double>::infinity())
    : m_R(R), m_y(y), m_rounding(rounding), m_options(options), m_limit(limit), m_k(y.size()), m_v(y.size())
  {
    descend(static_cast<int>(y.size()) - 1, 0);
    forget_far_leaves();
  }

  // all vectors that can be among the wanted ones, rounding considered, if the search is complete
  const std::vector<Leaf>& leaves() const { return m_leaves; }
  bool complete() const { return !m_stopped; }
  std::size_t nodes() const { return m_nodes; }
  // the least cost of a leaf
  double least_found() const { return m_nearest.empty() ? std::numeric_limits<double>::infinity() : m_nearest.front(); }
  // the least cost of the nodes that were not entered, because they cost too much or the search was stopped
  double least_open() const { return m_least_open; }

private:
  void descend(int i, double above)
  {
    if (i < 0) return add_leaf(above);
    const auto right = m_y.size() - 1 - i;
    const double s = m_R.row(i).tail(right).dot(m_v.tail(right));
    const auto cost = [&](double k) { const double z = m_R(i, i) * (m_y[i] - k) + s; return above + z * z; };
    double down = std::floor(m_y[i] + s / m_R(i, i)), up = down + 1;
    double cost_down = cost(down), cost_up = cost(up);
    for (;;) {
      const bool go_up = cost_up < cost_down;
      const double least = go_up ? cost_up : cost_down;
      if (least > m_bound || stopped()) {
        m_least_open = std::min(m_least_open, least);
        return;
      }
      ++m_nodes;
      m_k[i] = go_up ? up : down;
      m_v[i] = m_y[i] - m_k[i];
      descend(i - 1, least);
      if (go_up) cost_up = cost(++up);
      else       cost_down = cost(--down);
    }
  }

  bool stopped()
  {
    m_stopped = m_stopped || (m_nodes >= m_options.max_nodes && (!m_leaves.empty() || std::isfinite(m_limit)));
    return m_stopped;
  }

  void add_leaf(double squared_distance)
  {
    m_leaves.push_back({squared_distance, m_k});
    m_nearest.insert(std::upper_bound(m_nearest.begin(), m_nearest.end(), squared_distance), squared_distance);
    if (m_nearest.size() > m_options.count) m_nearest.pop_back();
    update_bound();
    if (m_leaves.size() >= m_forget_at) {
      forget_far_leaves();
      m_forget_at = 2 * m_leaves.size() + 64;
    }
  }

  // No wanted vector has a larger computed distance: one rounding error for the vectors found, one for those compared
  void update_bound()
  {
    double radius = std::numeric_limits<double>::infinity(), absolute = 2 * m_rounding.absolute;
    if (m_nearest.size() == m_options.count) radius = std::sqrt(m_nearest.back());
    if (std::isfinite(m_options.radius_factor)) {
      radius = std::min(radius, m_options.radius_factor * std::sqrt(m_nearest.front()));
      absolute += m_options.radius_factor * m_rounding.absolute;
    }
    m_bound = std::min(m_limit, std::pow(radius * (1 + 3 * m_rounding.relative) + 2 * absolute, 2));
  }

  void forget_far_leaves()
  {
    m_leaves.erase(std::remove_if(m_leaves.begin(), m_leaves.end(),
                                  [&](const Leaf& leaf) { return leaf.squared_distance > m_bound; }), m_leaves.end());
  }

  const Eigen::MatrixXd&        m_R;
  const Eigen::VectorXd&        m_y;
  const Rounding                m_rounding;
  const Closest_vector_options& m_options;
  const double                  m_limit;
  Eigen::VectorXd               m_k, m_v;    // v = y - k
  std::vector<Leaf>             m_leaves;
  std::vector<double>           m_nearest;   // squared distances of the nearest leaves, at most `count`
  double                        m_bound = m_limit, m_least_open = std::numeric_limits<double>::infinity();
  std::size_t                   m_forget_at = 64, m_nodes = 0;
  bool                          m_stopped = false;
};

// A true lower bound of all d(k)^2 beyond what a stopped search left open, from complete searches of growing radius
// until the nodes are used up. The radii do not depend on `max_nodes`, so that the bound never falls if that rises.
struct Bound_search
{
  double                         squared_distance = 0;
  std::vector<Enumeration::Leaf> leaves;   // vectors nearer than `nearest`, the least that is known, if any were met
  std::size_t                    nodes = 0;

  Bound_search(const Eigen::MatrixXd& R, const Eigen::VectorXd& y, const Rounding& rounding, double nearest,
               std::size_t max_nodes)
  {
    const double growth = 1.25;   // of the squared radius
    double limit = 0.25 * R.diagonal().cwiseAbs2().minCoeff();
    for (bool last = false; !last && leaves.empty() && nodes < max_nodes;) {
      last = limit >= nearest;
      const Closest_vector_options one{1, std::numeric_limits<double>::infinity(), max_nodes - nodes};
      const Enumeration search(R, y, rounding, one, std::min(limit, nearest));
      nodes += search.nodes();
      std::copy_if(search.leaves().begin(), search.leaves().end(), std::back_inserter(leaves),
                   [&](const Enumeration::Leaf& leaf) { return leaf.squared_distance < nearest; });
      const double least = std::min(search.least_open(), search.least_found());
      squared_distance = std::max(squared_distance, rounding.lowered(least));
      limit = std::max(growth * limit, search.least_open());
    }
  }
};

// A vector with its exact squared distance, in units that all vectors share.
struct Candidate
{
  Big_integer               squared_distance;
  std::vector<std::int64_t> m;

  friend bool operator<(const Candidate& a, const Candidate& b)
  { return std::tie(a.squared_distance, a.m) < std::tie(b.squared_distance, b.m); }
};

// The problem in exact arithmetic.
class Exact_problem
{
public:
  Exact_problem(const Lattice_basis& lattice, const Dyadic_numbers& x, const Reduced_target& target)
    : m_lattice(lattice), m_x(x), m_target(target) {}

  std::vector<Candidate> sorted(const std::vector<Enumeration::Leaf>& leaves) const
  {
    std::vector<Candidate> result;
    for (const Enumeration::Leaf& leaf : leaves) result.push_back(candidate(leaf.k));
    std::sort(result.begin(), result.end());
    return result;
  }

  double rounded(const Big_integer& squared_distance) const
  { return internal::rounded(squared_distance, m_lattice.norm_exponent() + 2 * std::min(0, m_x.exponent)); }

  double rounded_down(const Big_integer& squared_distance) const
  { return internal::rounded_down(squared_distance, m_lattice.norm_exponent() + 2 * std::min(0, m_x.exponent)); }

  double gap(const Candidate& best, const Candidate& next) const
  {
    if (next.squared_distance == best.squared_distance) return 0;
    return rounded(next.squared_distance - best.squared_distance)
         / (std::sqrt(rounded(next.squared_distance)) + std::sqrt(rounded(best.squared_distance)));
  }

private:
  Candidate candidate(const Eigen::VectorXd& k) const
  {
    const int n = m_lattice.dimension(), bits = std::max(0, -m_x.exponent), up = std::max(0, m_x.exponent);
    std::vector<std::int64_t> m(n, 0);
    std::vector<Big_integer> difference(n);   // x - m in units of 2^-bits
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const std::int64_t coordinate = internal::checked_sum(m_target.offset[j], static_cast<std::int64_t>(k[j]));
        m[i] = internal::checked_sum(m[i], internal::checked_product(m_lattice.basis()(i, j), coordinate));
      }
      difference[i] = (m_x.integer[i] << up) - (Big_integer(m[i]) << bits);
    }
    return {m_lattice.squared_norm(difference), m};
  }

  const Lattice_basis&  m_lattice;
  const Dyadic_numbers& m_x;
  const Reduced_target& m_target;
};

// whether a <= factor^2 * b, exactly
bool within(const Big_integer& a, double factor, const Big_integer& b)
{
  if (!std::isfinite(factor)) return true;
  const Dyadic_numbers f({factor});
  const Big_integer scaled = f.integer[0] * f.integer[0] * b;
  return f.exponent < 0 ? (a << (-2 * f.exponent)) <= scaled : a <= (scaled << (2 * f.exponent));
}

} // namespace

Closest_vectors closest_vectors(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                                const Closest_vector_options& options)
{
  CGAL_precondition(gram.rows() == gram.cols() && gram.rows() == target.size());
  CGAL_precondition(gram.allFinite() && target.allFinite());
  CGAL_precondition(options.count >= 1 && options.radius_factor >= 1);
  Closest_vectors result;
  const double infinity = std::numeric_limits<double>::infinity();
  if (target.size() == 0) {
    result.vectors.push_back({{}, 0.0});
    result.optimal = true;
    result.gap = infinity;    // there is no other vector
    return result;
  }

  const Lattice_basis lattice(gram);
  const Eigen::MatrixXd R = internal::cholesky_factor(lattice.gram());
  const Dyadic_numbers x(std::vector<double>(target.data(), target.data() + target.size()));
  const Reduced_target reduced_target = reduced(lattice, x);
  const Exact_problem problem(lattice, x, reduced_target);

  const Rounding errors = rounding(R);
  const Enumeration search(R, reduced_target.y, errors, options);
  result.optimal = search.complete();
  result.nodes = search.nodes();
  std::vector<Enumeration::Leaf> leaves = search.leaves();
  if (!result.optimal) {
    const Bound_search bound(R, reduced_target.y, errors, search.least_found(), options.max_nodes);
    leaves.insert(leaves.end(), bound.leaves.begin(), bound.leaves.end());
    result.nodes += bound.nodes;
    result.lower_bound = std::max(errors.lowered(std::min(search.least_open(), search.least_found())),
                                  bound.squared_distance);
  }

  const std::vector<Candidate> found = problem.sorted(leaves);
  for (const Candidate& c : found)
    if (result.vectors.size() < options.count
        && within(c.squared_distance, options.radius_factor, found[0].squared_distance))
      result.vectors.push_back({c.m, problem.rounded(c.squared_distance)});
  result.tie = found.size() > 1 && found[1].squared_distance == found[0].squared_distance;
  const double least = problem.rounded_down(found[0].squared_distance);
  result.lower_bound = result.optimal ? least : std::min(least, result.lower_bound);

  if (!result.optimal) return result;
  if (result.tie || result.vectors.size() > 1) {
    result.gap = problem.gap(found[0], found[1]);
    return result;
  }
  const Closest_vector_options two_nearest{2, infinity, options.max_runner_up_nodes};
  const Enumeration runner_up(R, reduced_target.y, errors, two_nearest);
  result.nodes += runner_up.nodes();
  if (runner_up.complete()) {
    const std::vector<Candidate> nearest = problem.sorted(runner_up.leaves());
    result.gap = problem.gap(nearest[0], nearest[1]);
  }
  return result;
}

void check_closest_vectors(const Closest_vectors& answer, const Eigen::MatrixXd& gram, const Eigen::VectorXd& target,
                           const Closest_vector_options& options)
{
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw Error("the closest vector solver broke its contract: it returned " + what);
  };
  require(!answer.vectors.empty(), "no vector");
  require(answer.vectors.size() <= options.count, std::to_string(answer.vectors.size()) + " vectors where at most "
                                                  + std::to_string(options.count) + " were wanted");
  const double tolerance = 1e-6;   // far above the rounding of a distance that is computed in a reasonable way
  const std::size_t n = target.size();
  const Eigen::MatrixXd W = gram.selfadjointView<Eigen::Lower>(), sizes = W.cwiseAbs();
  std::set<std::vector<std::int64_t>> vectors;
  double last = 0;
  for (const Lattice_vector& v : answer.vectors) {
    require(v.coefficients.size() == n, "a vector of " + std::to_string(v.coefficients.size())
                                        + " coefficients in dimension " + std::to_string(n));
    require(vectors.insert(v.coefficients).second, "the same vector twice");
    require(v.squared_distance >= last, "vectors that are not in the order of their distances");
    last = v.squared_distance;
    Eigen::VectorXd z = target;
    for (std::size_t i = 0; i < n; ++i) z[i] -= static_cast<double>(v.coefficients[i]);
    const double terms = z.cwiseAbs().dot(sizes * z.cwiseAbs());
    require(std::abs(v.squared_distance - z.dot(W * z)) <= tolerance * terms, "a distance that is not its vector's");
  }
  require(answer.lower_bound >= 0 && answer.lower_bound <= answer.vectors[0].squared_distance,
          "a lower bound that its own vector contradicts");
}

} } // namespace CGAL::Quartic_differentials
