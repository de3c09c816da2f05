// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/internal/different_colours.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/shared_array_property_map.hpp>   // which the next one forgets
#include <boost/graph/smallest_last_ordering.hpp>

#include <tuple>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

Graph graph_of(std::size_t size, const std::set<std::pair<std::size_t, std::size_t>>& neighbours)
{
  Graph graph(size);
  for (const auto& [i, j] : neighbours)
    if (i < j || (j < i && neighbours.count({j, i}) == 0)) add_edge(i, j, graph);
  return graph;
}

} // namespace

std::vector<std::size_t> different_colours(std::size_t size, std::size_t colours,
                                           const std::set<std::pair<std::size_t, std::size_t>>& neighbours)
{
  if (size == 0) return {};                                // the ordering expects a vertex
  const Graph graph = graph_of(size, neighbours);
  std::vector<std::size_t> colour(size, colours), uses(colours, 0);
  for (std::size_t i : boost::smallest_last_vertex_ordering(graph)) {
    std::vector<char> taken(colours + 1, false);
    for (auto [it, end] = boost::adjacent_vertices(i, graph); it != end; ++it) taken[colour[*it]] = true;
    std::size_t best = 0;
    for (std::size_t c = 1; c < colours; ++c)
      if (std::tie(taken[c], uses[c]) < std::tie(taken[best], uses[best])) best = c;
    colour[i] = best;
    ++uses[best];
  }
  return colour;
}

} } } // namespace CGAL::Quartic_differentials::internal
