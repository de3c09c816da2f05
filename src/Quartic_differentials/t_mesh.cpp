// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/t_mesh.h>

#include "internal/motorcycle_tracing.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <algorithm>
#include <string>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Meeting;
using internal::Trace;
using internal::Traces;
using internal::Visit;
using internal::no_singularity;

const std::size_t none = static_cast<std::size_t>(-1);

// A trace at a node that is no singularity. Directions at a node are in the frame of its first passage.
struct Passage
{
  std::size_t  trace;
  std::int64_t time;
  std::size_t  node      = none;
  int          direction = 0;

  friend bool operator<(const Passage& a, const Passage& b)
  { return std::make_pair(a.trace, a.time) < std::make_pair(b.trace, b.time); }
  friend bool operator==(const Passage& a, const Passage& b) { return a.trace == b.trace && a.time == b.time; }
};

// An end of an arc: 2a is the one at arcs[a].from, 2a + 1 the one at arcs[a].to. As a directed arc, it leaves its node.
struct Half_arc
{
  std::size_t node;
  int         arm;    // the number of the arm at a singularity, elsewhere a direction
};

// Builds nodes, arcs and patches, in this order, from the traces.
class T_mesh_builder
{
public:
  T_mesh_builder(const Quartic_differential& q, const Traces& traces) : m_q(q), m_traces(traces) {}

  T_mesh build()
  {
    m_result.grid_exponent = m_q.grid_exponent + 1;
    add_singularities();
    collect_passages();
    add_meeting_points();
    add_arcs();
    set_kinds();
    add_patches();
    return std::move(m_result);
  }

private:
  void add_singularities()
  {
    std::size_t trace = 0;
    for (Vertex v : m_q.singularities) {
      const Halfedge h = m_q.triangulation.halfedge_from(v);
      const bool is_corner = m_q.triangulation.is_border(v);
      m_result.nodes.push_back({is_corner ? T_mesh::Node_kind::corner : T_mesh::Node_kind::singularity, v, m_q.order[v],
                                m_q.triangulation.face(h), m_q.corner[h] + m_q.corner[h]});
      m_first_trace.push_back(trace);
      trace += m_q.order[v] + (is_corner ? 2 : 4);
    }
  }

  void collect_passages()
  {
    for (std::size_t i = 0; i < m_traces.traces.size(); ++i)
      if (!m_traces.traces[i].is_wall) m_passages.push_back({i, m_traces.traces[i].stop});
    for (const Meeting& m : m_traces.meetings) {
      m_passages.push_back({m.first, m.first_time});
      m_passages.push_back({m.second, m.second_time});
    }
    std::sort(m_passages.begin(), m_passages.end());
    m_passages.erase(std::unique(m_passages.begin(), m_passages.end()), m_passages.end());
  }

  // The nodes are the classes of passages under the meetings; the turns must agree however a passage is reached.
  void add_meeting_points()
  {
    std::vector<std::vector<std::pair<std::size_t, int>>> met(m_passages.size());   // with the turn towards it
    for (const Meeting& m : m_traces.meetings) {
      const std::size_t a = passage(m.first, m.first_time), b = passage(m.second, m.second_time);
      met[a].emplace_back(b, m.turn);
      met[b].emplace_back(a, -m.turn);
    }
    for (std::size_t first = 0; first < m_passages.size(); ++first) {
      if (m_passages[first].node != none) continue;
      const std::size_t node = m_result.nodes.size();
      m_result.nodes.push_back({T_mesh::Node_kind::meeting, Mesh::null_vertex(), 0, Mesh::null_face(), {}});
      m_passages[first].node = node;
      std::vector<std::size_t> reached{first};
      for (std::size_t k = 0; k < reached.size(); ++k)
        for (const auto& [next, turn] : met[reached[k]]) {
          const int direction = (m_passages[reached[k]].direction + turn) & 3;
          if (m_passages[next].node == none) {
            m_passages[next].node = node;
            m_passages[next].direction = direction;
            reached.push_back(next);
          } else if (m_passages[next].node != node || m_passages[next].direction != direction) {
            throw Numerical_error("traces meet at contradicting angles at node " + std::to_string(node));
          }
        }
    }
    m_arms.assign(m_result.nodes.size() - m_q.singularities.size(), {none, none, none, none});
  }

  std::size_t passage(std::size_t trace, std::int64_t time) const
  {
    return std::lower_bound(m_passages.begin(), m_passages.end(), Passage{trace, time}) - m_passages.begin();
  }

  // The passages of a trace, in their order, cut it into arcs. One that starts at no singularity starts at the first of
  // them; walls go on to their corner, or once round to the first passage.
  void add_arcs()
  {
    std::size_t p = 0;
    for (std::size_t i = 0; i < m_traces.traces.size(); ++i) {
      const Trace& trace = m_traces.traces[i];
      m_first_arc.push_back(m_result.arcs.size());
      if (trace.singularity == no_singularity && (p == m_passages.size() || m_passages[p].trace != i))
        throw Numerical_error("no trace comes to a boundary curve without corners");
      const Passage first = trace.singularity == no_singularity ? m_passages[p++] : Passage{i, 0};
      Half_arc from = trace.singularity == no_singularity
        ? Half_arc{first.node, first.direction}
        : Half_arc{trace.singularity, static_cast<int>(i - m_first_trace[trace.singularity])};
      std::int64_t begin = first.time;
      std::size_t visit = 0;
      for (; p < m_passages.size() && m_passages[p].trace == i; ++p) {
        const Passage& end = m_passages[p];
        add_arc(trace, visit, from, {end.node, end.direction ^ 2}, begin, end.time);
        from = {end.node, end.direction};
        begin = end.time;
      }
      if (trace.is_closed())
        add_arc(trace, visit, from, {first.node, first.direction ^ 2}, begin, first.time + trace.stop);
      else if (trace.is_wall)
        add_arc(trace, visit, from, {trace.end, m_result.nodes[trace.end].order + 2}, begin, trace.stop);
    }
  }

  void add_arc(const Trace& trace, std::size_t& visit, Half_arc from, Half_arc to, std::int64_t begin, std::int64_t end)
  {
    T_mesh::Arc arc{from.node, to.node, end - begin, {}, trace.is_wall};
    // the arc's part in a visit is not a single point if entry < end and the next entry > begin
    while (visit + 1 < trace.visits.size() && leaves_by(trace, visit, begin)) ++visit;
    for (std::size_t k = visit; k < trace.visits.size() && trace.visits[k].entry < end; ++k) {
      const Visit& v = trace.visits[k];
      const std::int64_t exit = k + 1 < trace.visits.size() ? trace.visits[k + 1].entry : end;
      arc.path.push_back({v.face, v.ray.direction, v.ray.at(std::max(begin, v.entry)), v.ray.at(std::min(end, exit))});
    }
    T_mesh::Node& node = m_result.nodes[to.node];
    if (node.face == Mesh::null_face()) {
      node.face = arc.path.back().face;
      node.point = arc.path.back().to;
    }
    set_arm(from, 2 * m_result.arcs.size());
    set_arm(to, 2 * m_result.arcs.size() + 1);
    m_result.arcs.push_back(std::move(arc));
  }

  // whether the trace is out of the face of a visit at the given time or earlier
  static bool leaves_by(const Trace& trace, std::size_t visit, std::int64_t time)
  {
    const Visit& next = trace.visits[visit + 1];
    return next.entry < time || (next.entry == time && !next.entry_is_rounded);
  }

  void set_arm(const Half_arc& end, std::size_t half_arc)
  {
    m_half_arcs.push_back(end);
    if (end.node < m_q.singularities.size()) return;
    std::size_t& arm = m_arms[end.node - m_q.singularities.size()][end.arm];
    if (arm != none) throw Numerical_error("two arcs leave node " + std::to_string(end.node) + " in one direction");
    arm = half_arc;
  }

  void set_kinds()
  {
    for (std::size_t k = 0; k < m_arms.size(); ++k) {
      const auto arms = 4 - std::count(m_arms[k].begin(), m_arms[k].end(), none);
      m_result.nodes[m_q.singularities.size() + k].kind = arms == 2 ? T_mesh::Node_kind::meeting
                                                        : arms == 3 ? T_mesh::Node_kind::t_junction
                                                                    : T_mesh::Node_kind::crossing;
    }
  }

  struct Step
  {
    std::size_t half_arc;
    bool        after_corner;
  };

  static int number_of_arms(const T_mesh::Node& singularity)
  { return singularity.order + (singularity.kind == T_mesh::Node_kind::corner ? 3 : 4); }

  // The next directed arc of the patch on the left: the first one clockwise from the way back.
  Step next_on_patch(std::size_t half_arc) const
  {
    const auto [node, back] = m_half_arcs[half_arc ^ 1];
    const std::size_t singularities = m_q.singularities.size();
    if (node < singularities) {
      const int arms = number_of_arms(m_result.nodes[node]);
      return {2 * m_first_arc[m_first_trace[node] + (back + arms - 1) % arms], true};
    }
    for (int k = 1; k <= 2; ++k) {
      const std::size_t next = m_arms[node - singularities][(back - k) & 3];
      if (next != none) return {next, k == 1};
    }
    throw Numerical_error("the patch at node " + std::to_string(node) + " has a reflex corner");
  }

  void add_patches()
  {
    std::vector<char> used(m_half_arcs.size(), false);
    for (std::size_t first = 0; first < m_half_arcs.size(); ++first) {
      if (used[first] || (first % 2 == 1 && m_result.arcs[first / 2].on_boundary)) continue;
      std::vector<Step> boundary;
      Step step{first, false};
      do {
        used[step.half_arc] = true;
        step = next_on_patch(step.half_arc);
        boundary.push_back(step);
      } while (!used[step.half_arc]);
      add_patch(std::move(boundary));
    }
  }

  void add_patch(std::vector<Step> boundary)
  {
    const auto after_corner = [](const Step& s) { return s.after_corner; };
    if (std::count_if(boundary.begin(), boundary.end(), after_corner) != 4)
      throw Numerical_error("patch " + std::to_string(m_result.patches.size()) + " does not have four corners");
    std::rotate(boundary.begin(), std::find_if(boundary.begin(), boundary.end(), after_corner), boundary.end());
    T_mesh::Patch patch{};
    std::array<std::int64_t, 4> length{};
    int side = -1;
    for (const Step& s : boundary) {
      if (s.after_corner) ++side;
      patch.sides[side].push_back({s.half_arc / 2, s.half_arc % 2 == 0});
      length[side] += m_result.arcs[s.half_arc / 2].length;
    }
    patch.width = length[0];
    patch.height = length[1];
    m_result.patches.push_back(std::move(patch));
  }

  const Quartic_differential& m_q;
  const Traces&               m_traces;
  T_mesh                      m_result;

  std::vector<std::size_t>                m_first_trace;   // by singularity
  std::vector<std::size_t>                m_first_arc;     // by trace
  std::vector<Passage>                    m_passages;      // sorted by trace, then time
  std::vector<Half_arc>                   m_half_arcs;
  std::vector<std::array<std::size_t, 4>> m_arms;          // by other node: half arcs leaving to the four directions
};

} // namespace

T_mesh t_mesh(const Quartic_differential& q, Visitor& visitor)
{
  if (q.singularities.empty() && !q.triangulation.has_boundary())
    throw Infeasible_divisor_error("there is no singularity from which a T-mesh could start");
  const Traces traces = internal::trace_motorcycles(q, visitor);
  T_mesh result = T_mesh_builder(q, traces).build();
  const std::string violation = defect(result, q);
  if (!violation.empty()) throw Numerical_error("the T-mesh is not valid: " + violation);
  visitor.progress("T-mesh: " + std::to_string(result.nodes.size()) + " nodes, " + std::to_string(result.arcs.size())
                   + " arcs, " + std::to_string(result.patches.size()) + " patches");
  return result;
}

} } // namespace CGAL::Quartic_differentials
