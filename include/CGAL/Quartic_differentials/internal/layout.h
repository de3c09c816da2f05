// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LAYOUT_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LAYOUT_H

#include <CGAL/Quartic_differentials/Intrinsic_triangulation.h>
#include <CGAL/Quartic_differentials/internal/cut_to_disk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// A flat surface, cut to a disk, in the plane.
struct Layout
{
  std::vector<std::complex<double>> position;    ///< by halfedge: of its source in the disk
  std::vector<std::complex<double>> direction;   ///< by halfedge: unit vector along it
};

/// The order in which faces are laid out: breadth first, but a face across a shorter edge before one across an edge 16
/// times as long: so the paths to faces are short, and the gaps of the layout appear between large triangles, not inside
/// a region of small ones.
class Layout_queue
{
public:
  bool empty() const { return m_queue.empty(); }
  void push(Halfedge h, double length)
  { m_queue.push({static_cast<int>(std::floor(std::log2(length) / 4)), m_pushed++, h}); }
  Halfedge pop()
  {
    const Halfedge h = m_queue.top().h;
    m_queue.pop();
    return h;
  }

private:
  struct Entry
  {
    int         scale;    // smaller ones are more urgent, then smaller numbers
    std::size_t number;
    Halfedge    h;
    bool operator<(const Entry& e) const { return std::tie(scale, number) > std::tie(e.scale, e.number); }
  };
  std::priority_queue<Entry> m_queue;
  std::size_t                m_pushed = 0;
};

/// the product of two complex numbers
template <class FT>
std::array<FT, 2> complex_product(const std::array<FT, 2>& x, const std::array<FT, 2>& y)
{
  return {FT(x[0] * y[0] - x[1] * y[1]), FT(x[0] * y[1] + x[1] * y[0])};
}

/// the unit number by which the direction turns from the side of length b to the side of length c of a triangle, a
/// opposite of the corner between them: minus the cosine of its angle, and the sine.
template <class FT>
std::array<FT, 2> exterior_turn(const FT& a, const FT& b, const FT& c)
{
  using std::sqrt;
  const FT x = twice_scalar_product(a, b, c), y = four_times_area(a, b, c);   // both times 2 b c
  const FT norm = sqrt(FT(x * x + y * y));
  return {FT(-x / norm), FT(y / norm)};
}

/// a halfedge to begin a layout with: the first one along the boundary, or that of the first face
inline Halfedge first_in_layout(const Intrinsic_triangulation& t)
{
  for (Halfedge h : t.halfedges())
    if (t.is_border(h)) return t.opposite(h);
  return t.halfedge(*t.faces().begin());
}

/// unfolds a flat surface, face by face, in the number type of its lengths. The first boundary edge, if there is one, is
/// parallel to the first axis.
/// \param rounded the lengths, as doubles
/// Complexity: O(n log n).
template <class FT>
Layout layout(const Intrinsic_triangulation& t, const std::vector<FT>& lengths, const std::vector<double>& rounded,
              const Cut_disk& disk)
{
  using std::sqrt;
  using Vector = std::array<FT, 2>;
  Layout_queue queue;
  std::vector<char> placed(t.number_of_faces(), false);
  std::vector<Vector> position(t.number_of_halfedges()), direction(t.number_of_halfedges());
  const auto place = [&](Halfedge h, Vector z, Vector e) {
    placed[t.face(h)] = true;
    for (int k = 0; k < 3; ++k) {
      position[h] = z;
      direction[h] = e;
      const FT &l = lengths[t.edge(h)], &next = lengths[t.edge(t.next(h))], &last = lengths[t.edge(t.prev(h))];
      if (!disk.is_cut[t.edge(h)]) queue.push(h, rounded[t.edge(h)]);
      for (int x = 0; x < 2; ++x) z[x] += l * e[x];
      e = complex_product(e, exterior_turn(last, l, next));
      const FT norm = sqrt(FT(e[0] * e[0] + e[1] * e[1]));
      for (FT& x : e) x /= norm;
      h = t.next(h);
    }
  };
  place(first_in_layout(t), {FT(0), FT(0)}, {FT(1), FT(0)});
  while (!queue.empty()) {
    const Halfedge h = queue.pop(), o = t.opposite(h);
    if (!placed[t.face(o)]) place(o, position[t.next(h)], {FT(-direction[h][0]), FT(-direction[h][1])});
  }
  Layout result;
  const auto to_double = [](const Vector& v) {
    return std::complex<double>(static_cast<double>(v[0]), static_cast<double>(v[1]));
  };
  for (const Vector& v : position) result.position.push_back(to_double(v));
  for (const Vector& v : direction) result.direction.push_back(to_double(v));
  return result;
}

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_LAYOUT_H
