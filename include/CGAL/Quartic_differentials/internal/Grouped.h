// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_GROUPED_H
#define CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_GROUPED_H

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

/// The items 0, ..., n - 1 in groups, in two arrays however many groups there are.
template <class Item>
class Grouped
{
public:
  using Group = CGAL::Iterator_range<typename std::vector<Item>::const_iterator>;

  Grouped() = default;
  /// \param group_of number -> group, below `groups`
  /// Complexity: linear.
  template <class Group_of>
  Grouped(std::size_t groups, std::size_t n, Group_of group_of) : m_begin(groups + 2, 0), m_items(n)
  {
    for (std::size_t i = 0; i < n; ++i) ++m_begin[group_of(i) + 2];
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());   // m_begin[g + 1] is where group g begins,
    for (std::size_t i = 0; i < n; ++i) m_items[m_begin[group_of(i) + 1]++] = Item(i);   // and then where it ends
  }

  /// the items of a group, in increasing order
  Group operator[](std::size_t group) const
  { return {at(m_begin[group]), at(m_begin[group + 1])}; }

private:
  auto at(std::size_t i) const { return m_items.begin() + static_cast<std::ptrdiff_t>(i); }

  std::vector<std::size_t> m_begin;   // of each group in m_items
  std::vector<Item>        m_items;
};

} } } // namespace CGAL::Quartic_differentials::internal

#endif // CGAL_QUARTIC_DIFFERENTIALS_INTERNAL_GROUPED_H
