// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/immersion.h>
#include <CGAL/Quartic_differentials/exceptions.h>
#include <CGAL/Quartic_differentials/internal/cut_to_disk.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace CGAL {
namespace Quartic_differentials {

// Notation (METHOD, step 7)
//   s, s'   a side of the boundary polygon of the cut surface, and its mate
//   k_s     the rotation i^k of the change of charts across s, from the face on the left of s to the one at s'
//   d_s     the vector along s; d_s' = -i^k_s d_s
//   A       the side of each pair that is computed; the other one is its image
//   r_s     the direction of a side on the boundary of the surface: d_s = L_s i^r_s with an integer L_s

namespace {

using Complex      = std::complex<double>;
using Cut_disk     = internal::Cut_disk;
using Layout       = internal::Layout;
using Grid_vectors = std::vector<Grid_vector>;

const double pi = CGAL_PI;
const double largest_rotation_error = 1e-6;

// ---- The layout in floating point numbers

// moves the centre to 0 and scales to a largest coordinate of 1
void normalise(std::vector<Complex>& position)
{
  Complex sum = 0;
  for (Complex z : position) sum += z;
  const Complex centre = sum / static_cast<double>(position.size());
  double size = 0;
  for (Complex z : position)
    size = std::max({size, std::abs(z.real() - centre.real()), std::abs(z.imag() - centre.imag())});
  for (Complex& z : position) z = (z - centre) / size;
}

double layout_gap(const Intrinsic_triangulation& t, const Cut_disk& disk, const std::vector<Complex>& position)
{
  double gap = 0;
  for (Halfedge h : t.halfedges())
    if (!disk.is_cut[t.edge(h)]) gap = std::max(gap, std::abs(position[h] - position[t.next(t.opposite(h))]));
  return gap;
}

// A vertex of the disk sits where the face with its shortest halfedge put it: small triangles keep their shape.
std::vector<Complex> positions_of_copies(const Intrinsic_triangulation& t, const std::vector<double>& lengths,
                                         const Cut_disk& disk, const std::vector<Complex>& position)
{
  std::vector<Complex> result(disk.number_of_copies);
  std::vector<double> shortest(disk.number_of_copies, std::numeric_limits<double>::infinity());
  for (Halfedge h : t.halfedges()) {
    if (t.is_border(h)) continue;
    const std::size_t c = disk.copy[h];
    if (lengths[t.edge(h)] >= shortest[c]) continue;
    shortest[c] = lengths[t.edge(h)];
    result[c] = position[h];
  }
  return result;
}

// k_s of every side, r_s on the boundary of the surface; `error` becomes the worst deviation of an edge from it [radians]
std::vector<int> rotations(const Intrinsic_triangulation& t, const Cut_disk& disk, const std::vector<Complex>& direction,
                           double& error)
{
  const auto turn = [&](Halfedge h) {
    return std::arg(t.is_border(t.opposite(h)) ? direction[h] : -direction[t.opposite(h)] / direction[h]);
  };
  std::vector<int> result;
  for (const Cut_disk::Side& s : disk.sides) {
    const double k = std::round(turn(disk.boundary[s.first]) / (pi / 2));
    for (std::size_t i = s.first; i < s.first + s.size; ++i)
      error = std::max(error, std::abs(std::remainder(turn(disk.boundary[i]) - k * (pi / 2), 2 * pi)));
    result.push_back(static_cast<int>(k) & 3);
  }
  return result;
}

// the component of v along i^k
double along(int k, Complex v)
{
  switch (k) {
    case 0:  return v.real();
    case 1:  return v.imag();
    case 2:  return -v.real();
    default: return -v.imag();
  }
}

// ---- Exact seams

Grid_vector rounded(Complex z) { return {std::llround(z.real()), std::llround(z.imag())}; }

Complex to_complex(Grid_vector v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

// (1 - i^k) v
Grid_vector times_one_minus_rotation(Grid_vector v, int k) { return v - rotated(v, k); }

// v / (1 - i^k). \pre k is not 0, and 1 - i^k divides v
Grid_vector divided_by_one_minus_rotation(Grid_vector v, int k)
{
  const Grid_vector product = times_one_minus_rotation(v, -k);   // by the conjugate
  const std::int64_t norm = k == 2 ? 4 : 2;
  CGAL_assertion(product.x % norm == 0 && product.y % norm == 0);
  return {product.x / norm, product.y / norm};
}

// Spreads the residual r of the closure equation over the segments of `pool` by length: d_s -= q_s with
// sum of (1 - i^k_s) q_s = r. What remains for the last one divides: 1 - i^k divides 1 - i^l if k is odd, and where
// every k is even, r is a sum of multiples of 2.
void spread(Grid_vector r, const std::vector<std::size_t>& pool, const std::vector<int>& k, Grid_vectors& d)
{
  double length = 0;
  for (std::size_t s : pool) length += std::abs(to_complex(d[s]));
  for (std::size_t s : pool) {
    const double own = std::abs(to_complex(d[s]));
    const Complex one_minus_rotation = to_complex(times_one_minus_rotation({1, 0}, k[s]));
    const Grid_vector q = s == pool.back() ? divided_by_one_minus_rotation(r, k[s])
                                           : rounded(to_complex(r) * (own / length) / one_minus_rotation);
    d[s] = d[s] - q;
    r = r - times_one_minus_rotation(q, k[s]);
    length -= own;
  }
}

// The same over the sides of `pool` on the boundary of the surface, which are parallel: d_s -= q_s, the sum of q_s is r.
void spread_along(Grid_vector r, const std::vector<std::size_t>& pool, Grid_vectors& d)
{
  double length = 0;
  for (std::size_t s : pool) length += std::abs(to_complex(d[s]));
  for (std::size_t s : pool) {
    const double own = std::abs(to_complex(d[s]));
    const Grid_vector q = s == pool.back() ? r : rounded(to_complex(r) * (own / length));
    d[s] = d[s] - q;
    r = r - q;
    length -= own;
  }
}

// The sides by what they can do about the closure equation.
struct Pools
{
  std::vector<std::size_t> odd, half_turn;         // A sides with k_s odd, and k_s = 2
  std::vector<std::size_t> horizontal, vertical;   // sides on the boundary

  const std::vector<std::size_t>& seams() const { return odd.empty() ? half_turn : odd; }
};

// What the seams take of the residual r: all of it, or with boundary only the component that has no side there. To an odd
// k belong multiples of 1 - i, whose components have the same parity, which the other component is made to have.
Grid_vector share_of_seams(Grid_vector r, const Pools& pools)
{
  const bool has_x = !pools.horizontal.empty(), has_y = !pools.vertical.empty();
  if (has_x && has_y) return {};
  if (has_x) return {pools.odd.empty() ? 0 : r.y & 1, r.y};
  if (has_y) return {r.x, pools.odd.empty() ? 0 : r.x & 1};
  return r;
}

// The vectors d_s of all sides on the grid, exactly mated and exactly closed: the sum of (1 - i^k_s) d_s over the A sides
// and of L_s i^r_s over those on the boundary is 0. If there is no boundary and every k is 0 the sum vanishes term by
// term and nothing is spread.
Grid_vectors closed_polygon(const Cut_disk& disk, const std::vector<int>& k, const std::vector<Complex>& z,
                            Grid_vector& residual)
{
  Grid_vectors d(disk.sides.size());
  Pools pools;
  residual = {};
  for (std::size_t s = 0; s < d.size(); ++s) {
    const Complex begin = z[disk.sides[s].first], end = z[disk.sides[disk.next_side(s)].first];
    if (disk.is_border(s)) {
      d[s] = rotated({std::llround(along(k[s], end - begin)), 0}, k[s]);
      residual = residual + d[s];
      (k[s] % 2 == 0 ? pools.horizontal : pools.vertical).push_back(s);
    } else if (s < disk.sides[s].mate) {
      d[s] = rounded(end) - rounded(begin);
      residual = residual + times_one_minus_rotation(d[s], k[s]);
      if (k[s] % 2 == 1) pools.odd.push_back(s);
      if (k[s] == 2) pools.half_turn.push_back(s);
    }
  }
  const Grid_vector by_seams = share_of_seams(residual, pools), by_boundary = residual - by_seams;
  spread(by_seams, pools.seams(), k, d);
  spread_along({by_boundary.x, 0}, pools.horizontal, d);
  spread_along({0, by_boundary.y}, pools.vertical, d);
  for (std::size_t s = 0; s < d.size(); ++s)
    if (s < disk.sides[s].mate) d[disk.sides[s].mate] = Grid_vector{} - rotated(d[s], k[s]);
  return d;
}

// The vertices of a side on the boundary of the surface lie on the line through its ends, in direction i^r.
void snap_border_side(const Cut_disk& disk, std::size_t s, int r, const std::vector<Complex>& z, Grid_vectors& point)
{
  const Cut_disk::Side& side = disk.sides[s];
  const std::size_t end = disk.sides[disk.next_side(s)].first;
  const double length = along(r, z[end] - z[side.first]), snapped = along(r, to_complex(point[end] - point[side.first]));
  for (std::size_t i = side.first + 1; i < side.first + side.size; ++i)
    point[i] = point[side.first] + rotated({std::llround(along(r, z[i] - z[side.first]) / length * snapped), 0}, r);
}

// The vertices of side A follow the moves of its ends, in proportion to the distance from them.
void snap_side(const Intrinsic_triangulation& t, const std::vector<double>& lengths, const Cut_disk& disk,
               std::size_t s, const std::vector<Complex>& z, Grid_vectors& point)
{
  const Cut_disk::Side& side = disk.sides[s];
  const std::size_t end = disk.sides[disk.next_side(s)].first;
  const Complex move_begin = to_complex(point[side.first]) - z[side.first], move_end = to_complex(point[end]) - z[end];
  double length = 0, along = 0;
  for (std::size_t i = side.first; i < side.first + side.size; ++i) length += lengths[t.edge(disk.boundary[i])];
  for (std::size_t i = side.first + 1; i < side.first + side.size; ++i) {
    along += lengths[t.edge(disk.boundary[i - 1])];
    point[i] = rounded(z[i] + move_begin + (along / length) * (move_end - move_begin));
  }
}

struct Snapped
{
  Grid_vectors            point;        // by vertex of the disk
  std::vector<Transition> transition;   // by side of the disk
};

Snapped snap(const Intrinsic_triangulation& t, const std::vector<double>& lengths, const Cut_disk& disk,
             const std::vector<int>& k, const std::vector<Complex>& z, Grid_vector& residual)
{
  Snapped result{Grid_vectors(z.size()), std::vector<Transition>(disk.sides.size())};
  Grid_vectors& point = result.point;
  for (std::size_t c = disk.boundary.size(); c < z.size(); ++c) point[c] = rounded(z[c]);

  const Grid_vectors d = closed_polygon(disk, k, z, residual);
  Grid_vector node = rounded(z[0]);
  for (std::size_t s = 0; s < d.size(); ++s) {
    point[disk.sides[s].first] = node;
    node = node + d[s];
  }
  CGAL_assertion(node == point[0]);

  for (std::size_t s = 0; s < d.size(); ++s) {
    const Cut_disk::Side &a = disk.sides[s], &b = disk.sides[a.mate];
    if (disk.is_border(s)) snap_border_side(disk, s, k[s], z, point);
    if (s >= a.mate) continue;
    snap_side(t, lengths, disk, s, z, point);
    const Grid_vector image_of_begin = point[disk.sides[disk.next_side(a.mate)].first];
    const Transition to_mate{k[s], image_of_begin - rotated(point[a.first], k[s])};
    for (std::size_t i = 1; i < b.size; ++i) point[b.first + i] = to_mate(point[a.first + a.size - i]);
    result.transition[s] = to_mate;
    result.transition[a.mate] = to_mate.inverse();
  }
  return result;
}

// ---- The quartic differential and its report

Quartic_differential on_grid(const Intrinsic_triangulation& t, const std::vector<double>& lengths, const Cut_disk& disk,
                             const std::vector<int>& k, const std::vector<Complex>& position, int grid_exponent,
                             Immersion_report& report)
{
  const double unit = std::ldexp(1.0, grid_exponent);
  std::vector<Complex> z = positions_of_copies(t, lengths, disk, position);
  for (Complex& w : z) w *= unit;
  const Snapped snapped = snap(t, lengths, disk, k, z, report.closure_residual);

  Quartic_differential q;
  q.grid_exponent = grid_exponent;
  q.corner.resize(t.number_of_halfedges());
  q.transition.resize(t.number_of_halfedges());
  report.grid_exponent = grid_exponent;
  report.largest_move = 0;
  for (Halfedge h : t.halfedges()) {
    if (t.is_border(h)) continue;
    q.corner[h] = snapped.point[disk.copy[h]];
    report.largest_move = std::max(report.largest_move, std::abs(to_complex(q.corner[h]) / unit - position[h]));
  }
  for (std::size_t s = 0; s < disk.sides.size(); ++s)
    for (std::size_t i = 0; i < disk.sides[s].size; ++i)
      q.transition[disk.boundary[disk.sides[s].first + i]] = snapped.transition[s];
  return q;
}

void measure_triangles(const Intrinsic_triangulation& t, const Grid_vectors& corner, Immersion_report& report)
{
  report.flipped_triangles = 0;
  report.min_altitude = std::numeric_limits<double>::infinity();
  for (Face f : t.faces()) {
    const auto [h0, h1, h2] = t.halfedges(f);
    const __int128 area = doubled_area(corner[h0], corner[h1], corner[h2]);
    if (area <= 0) ++report.flipped_triangles;
    const double longest = std::max({std::abs(to_complex(corner[h1] - corner[h0])),
                                     std::abs(to_complex(corner[h2] - corner[h1])),
                                     std::abs(to_complex(corner[h0] - corner[h2]))});
    report.min_altitude = std::min(report.min_altitude, longest > 0 ? static_cast<double>(area) / longest : 0);
  }
}

// Coarse grids first: they leave traces more room in 64 bits. Beyond 2^-50 the layout has no digits left.
std::vector<int> grid_exponents_to_try(const Immersion_options& options)
{
  if (options.grid_exponent != 0) return {options.grid_exponent};
  return {44, 46, 48, 50};
}

void require_exact_holonomy(double rotation_error)
{
  if (rotation_error <= largest_rotation_error) return;
  std::ostringstream s;
  s << "the holonomy of the flat metric is not a multiple of 90 degrees: a seam is off by " << rotation_error << " radians";
  throw Numerical_error(s.str());
}

} // namespace

namespace internal {

Cut_disk cut_at_cones(const Intrinsic_triangulation& t, const std::vector<double>& flat_lengths,
                      const std::vector<Vertex>& singularities)
{
  std::vector<char> is_cone(t.number_of_vertices(), false);
  for (Vertex v : singularities) is_cone[v] = true;
  return cut_to_disk(t, flat_lengths, is_cone);
}

Quartic_differential immersion_of_layout(const Intrinsic_triangulation& t, const std::vector<double>& flat_lengths,
                                         const Cut_disk& disk, Layout plane, const std::vector<Vertex>& singularities,
                                         const std::vector<int>& order, double surface_area,
                                         const Immersion_options& options, Immersion_report& report)
{
  CGAL_precondition(options.grid_exponent == 0 || (options.grid_exponent >= 20 && options.grid_exponent <= 50));
  CGAL_precondition(flat_lengths.size() == t.number_of_edges() && order.size() == t.number_of_vertices());
  report = {};
  for (std::size_t s = 0; s < disk.sides.size(); ++s) {
    if (s >= disk.sides[s].mate) continue;
    report.cut_edges += disk.sides[s].size;
    ++report.segments;
  }
  normalise(plane.position);
  report.layout_gap = layout_gap(t, disk, plane.position);
  const std::vector<int> k = rotations(t, disk, plane.direction, report.rotation_error);
  require_exact_holonomy(report.rotation_error);

  Quartic_differential q;
  for (int exponent : grid_exponents_to_try(options)) {
    q = on_grid(t, flat_lengths, disk, k, plane.position, exponent, report);
    measure_triangles(t, q.corner, report);
    if (report.flipped_triangles == 0) break;
  }
  q.triangulation = t;
  q.order = order;
  q.singularities = singularities;
  const double unit = std::ldexp(1.0, q.grid_exponent);
  q.surface_units_per_unit = unit * std::sqrt(2 * surface_area / static_cast<double>(q.doubled_area()));

  const std::string violation = report.flipped_triangles == 0 ? defect(q) : std::string();
  if (!violation.empty()) throw Numerical_error("the flat metric does not fit the divisor: " + violation);
  return q;
}

} // namespace internal

std::string unresolved_triangles(const Immersion_report& report)
{
  const double moved = std::ldexp(std::max(report.largest_move, report.layout_gap), report.grid_exponent);   // grid units
  if (report.flipped_triangles == 0 && report.min_altitude >= 100 * moved) return {};
  std::ostringstream s;
  if (report.flipped_triangles > 0) s << report.flipped_triangles << " triangles";
  else s << "the smallest triangles";
  s << " of the flat metric are too small for a grid of 2^-" << report.grid_exponent
    << " of its size (the smallest altitude is " << report.min_altitude << " grid units, the layout is accurate to " << moved
    << ")";
  return s.str();
}

void require_resolved_triangles(const Immersion_report& report)
{
  const std::string reason = unresolved_triangles(report);
  if (!reason.empty())
    throw Numerical_error(reason + ": the scale factors vary too much; use more or better placed singularities");
}

} } // namespace CGAL::Quartic_differentials
