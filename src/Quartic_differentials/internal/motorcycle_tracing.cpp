// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motorcycle_tracing.h"

#include <CGAL/Quartic_differentials/exceptions.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <string>
#include <tuple>

namespace CGAL {
namespace Quartic_differentials {
namespace internal {

namespace {

// Doubled coordinates and times stay below 2^60, translations below 2^61: sums of three fit 64 bits, products 128.
const std::int64_t largest = std::int64_t(1) << 60;
const std::int64_t never   = std::numeric_limits<std::int64_t>::max();

// The order in which what happens at one time is looked at. Those who arrive must be known before anything is decided.
enum class Event_kind { arrival, crossing, head_on, tie };

struct Event
{
  std::int64_t time;
  Event_kind   kind;
  std::size_t  trace;        // who arrives, or is to stop
  std::size_t  other;        // whose track it meets
  std::int64_t other_time;   // when the other was there
  int          turn;         // from the other's direction to the trace's

  friend bool operator<(const Event& a, const Event& b)   // std::priority_queue: the earliest is the greatest
  { return std::tie(a.time, a.kind, a.trace, a.other) > std::tie(b.time, b.kind, b.trace, b.other); }
};

// Where a running trace leaves the face it is in: across `exit`, or through the vertex source(exit).
struct Heading
{
  Ray          ray;               // in the chart of face(exit)
  Halfedge     exit;
  bool         is_vertex;
  std::int64_t arrival;           // time, rounded down
  bool         arrival_is_rounded;
};

// The line of a trace in a face: a singly linked list for every face and each of the two axes.
struct Line
{
  std::size_t trace;
  Ray         ray;
  int         next;
};

// Where a motorcycle starts: in the corner at source(halfedge), in the chart of its face.
struct Start
{
  std::size_t trace;
  Halfedge    halfedge;
  int         direction;
};

// A trace that came to a regular vertex: a singly linked list for every vertex.
struct Passage
{
  std::size_t  trace;
  int          direction;    // in the chart of face(halfedge_from(v))
  std::int64_t time;
  int          next;
};

class Tracer
{
public:
  Tracer(const Quartic_differential& q, Visitor& visitor)
    : m_q(q), m_mesh(q.triangulation), m_charts(q), m_visitor(visitor),
      m_singularity(m_mesh.number_of_vertices(), no_singularity), m_first_line(2 * m_mesh.number_of_faces(), -1),
      m_first_passage(m_mesh.number_of_vertices(), -1)
  {
    for (std::size_t s = 0; s < q.singularities.size(); ++s) m_singularity[q.singularities[s]] = s;
  }

  Traces run()
  {
    check_coordinates();
    for (std::size_t s = 0; s < m_q.singularities.size(); ++s) start_from(s);
    add_closed_walls();
    if (m_q.singularities.empty()) start_across();
    for (const Start& s : m_starts)   // all walls are there now
      enter_at_corner(s.trace, s.halfedge, ray_through(m_charts.corner(s.halfedge), s.direction, 0), 0);
    for (std::size_t n = 0; !m_events.empty(); ++n) {
      if (n % 4096 == 0 && !m_visitor.go_further()) throw Cancelled_error("the T-mesh was cancelled");
      const Event e = m_events.top();
      m_events.pop();
      switch (e.kind) {
        case Event_kind::arrival: arrive(e.trace); break;
        case Event_kind::head_on: meet_head_on(e); break;
        default:                  stop_at_track(e);
      }
    }
    for (std::size_t i = 0; i < m_result.traces.size(); ++i)
      if (running(i)) throw Numerical_error(name(i) + " did not end");
    return std::move(m_result);
  }

private:
  void check_coordinates() const
  {
    for (Grid_vector z : m_q.corner)
      if (z.x < -largest / 2 || z.x > largest / 2 || z.y < -largest / 2 || z.y > largest / 2)
        throw Numerical_error("a coordinate of the quartic differential is beyond 2^59");
  }

  // Start: one trace for every axis direction in the corners round the singularity; along the boundary it is a wall.

  void start_from(std::size_t s)
  {
    const Vertex v = m_q.singularities[s];
    const Halfedge first = m_mesh.halfedge_from(v);
    const std::size_t before = m_result.traces.size();
    const int quarters = m_q.order[v] + (m_mesh.is_border(v) ? 2 : 4);
    Halfedge h = first;
    do {
      int d = 0;   // the rightmost direction in this corner
      while (d < 4 && !(m_charts.corner_holds(h, d) && !m_charts.corner_holds(h, d - 1))) ++d;
      for (; d < 8 && m_charts.corner_holds(h, d); ++d) {
        if (m_mesh.is_border(v) && m_result.traces.size() == before) add_wall(s, first);
        else start(s, h, d & 3);
      }
      h = m_mesh.next_around_source(h);
    } while (h != first && !m_mesh.is_border(h));
    if (m_result.traces.size() - before != static_cast<std::size_t>(quarters))
      throw Numerical_error("the angle at the singularity at vertex " + std::to_string(v.idx()) + " is not "
                            + std::to_string(quarters) + "*90 degrees");
  }

  std::size_t add_trace(const Trace& trace)
  {
    m_result.traces.push_back(trace);
    m_heading.emplace_back();
    m_stopped_in_tie.push_back(false);
    return m_result.traces.size() - 1;
  }

  void start(std::size_t s, Halfedge h, int d) { m_starts.push_back({add_trace({s, {}, never}), h, d}); }

  // Walls: the boundary edges from `first` on, up to the next corner or once round. Whoever comes there stops.

  void add_wall(std::size_t s, Halfedge first)
  {
    const std::size_t i = add_trace({s, {}, 0, true});
    std::int64_t time = 0;
    Halfedge h = first;
    do {
      const Grid_vector begin = m_charts.corner(h), edge = m_charts.corner(m_mesh.next(h)) - begin;
      const int d = edge.y == 0 ? (edge.x > 0 ? 0 : 2) : (edge.y > 0 ? 1 : 3);
      const Ray ray = ray_through(begin, d, time);
      m_result.traces[i].visits.push_back({m_mesh.face(h), ray, time, false});
      add_line(i, m_mesh.face(h), ray);
      if (m_singularity[m_mesh.source(h)] == no_singularity) add_passage(i, m_mesh.source(h), d, time);
      time += along(d, edge);
      if (time > largest) throw Numerical_error("a boundary curve is longer than 2^60 grid units");
      h = m_mesh.next_on_boundary(h);
      m_result.traces[i].end = m_singularity[m_mesh.source(h)];
    } while (h != first && m_result.traces[i].end == no_singularity);
    m_result.traces[i].stop = time;
  }

  void add_closed_walls()
  {
    for (const std::vector<Halfedge>& curve : m_mesh.boundary_curves()) {
      const auto is_corner = [&](Halfedge h) { return m_singularity[m_mesh.source(h)] != no_singularity; };
      if (std::any_of(curve.begin(), curve.end(), is_corner)) continue;
      add_wall(no_singularity, curve.front());
      Trace& wall = m_result.traces.back();
      for (std::size_t k = 0; k < curve.size(); ++k) {   // the second round
        Visit visit = wall.visits[k];
        visit.entry += wall.stop;
        visit.ray.clock += wall.stop;
        wall.visits.push_back(visit);
      }
    }
  }

  // From where the first wall begins, at a right angle.
  void start_across()
  {
    if (m_result.traces.empty()) return;
    const Visit begin = m_result.traces.front().visits.front();
    Halfedge h = m_mesh.boundary_curves().front().front();
    int d = (begin.ray.direction + 1) & 3;
    while (!m_charts.corner_holds(h, d)) {
      d += m_q.transition[m_mesh.prev(h)].rotation;
      h = m_mesh.next_around_source(h);
    }
    start(no_singularity, h, d & 3);
    m_result.meetings.push_back({0, 0, m_result.traces.size() - 1, 0, 1});
  }

  // Run: from face to face.

  void arrive(std::size_t i)
  {
    if (!running(i)) return;
    if (m_heading[i].is_vertex) pass_vertex(i);
    else cross_edge(i);
  }

  void cross_edge(std::size_t i)
  {
    const Halfedge exit = m_heading[i].exit, h = m_mesh.opposite(exit);
    if (m_mesh.is_border(h)) return;   // it is about to stop at the wall
    const Ray ray = carried(i, m_heading[i].ray, exit);
    visit(i, m_mesh.face(h), ray, m_heading[i].arrival, m_heading[i].arrival_is_rounded);
    const std::int64_t apex = ray.side(m_charts.corner(m_mesh.prev(h)));
    if (apex == 0) head_for_vertex(i, m_mesh.prev(h), ray);
    else head_for_edge(i, apex > 0 ? m_mesh.next(h) : m_mesh.prev(h), ray);
  }

  // \pre the ray starts in the corner at source(h), or along h
  void enter_at_corner(std::size_t i, Halfedge h, const Ray& ray, std::int64_t time)
  {
    visit(i, m_mesh.face(h), ray, time, false);
    if (ray.side(m_charts.corner(m_mesh.next(h))) != 0) {
      head_for_edge(i, m_mesh.next(h), ray);
    } else {
      register_line(i, m_mesh.face(m_mesh.opposite(h)), carried(i, ray, h));
      head_for_vertex(i, m_mesh.next(h), ray);
    }
  }

  void visit(std::size_t i, Face f, const Ray& ray, std::int64_t entry, bool entry_is_rounded)
  {
    m_result.traces[i].visits.push_back({f, ray, entry, entry_is_rounded});
    register_line(i, f, ray);
  }

  void head_for_vertex(std::size_t i, Halfedge h, const Ray& ray)
  {
    announce_arrival(i, {ray, h, true, ray.time(m_charts.corner(h)), false});
  }

  // The ray crosses e = (a, b) from a on its right to b on its left, at a + (b - a) s_a / (s_a - s_b).
  void head_for_edge(std::size_t i, Halfedge e, const Ray& ray)
  {
    const Grid_vector a = m_charts.corner(e), b = m_charts.corner(m_mesh.next(e));
    const std::int64_t s_a = ray.side(a), s_b = ray.side(b);
    if (!(s_a < 0 && s_b > 0)) throw Numerical_error(name(i) + " leaves a triangle that is not positively oriented");
    const __int128 numerator = static_cast<__int128>(along(ray.direction, b - a)) * -s_a;
    const __int128 denominator = static_cast<__int128>(s_b) - s_a, remainder = numerator % denominator;
    const __int128 floor = numerator / denominator - (remainder < 0 ? 1 : 0);
    announce_arrival(i, {ray, e, false, ray.time(a) + static_cast<std::int64_t>(floor), remainder != 0});
  }

  void announce_arrival(std::size_t i, const Heading& heading)
  {
    m_heading[i] = heading;
    m_events.push({heading.arrival, Event_kind::arrival, i, i, heading.arrival, 0});
  }

  void pass_vertex(std::size_t i)
  {
    const Halfedge h = m_heading[i].exit;
    const Vertex v = m_mesh.source(h);
    const std::int64_t time = m_heading[i].arrival;
    if (m_singularity[v] != no_singularity)   // the opposite trace from there must have met it
      throw Numerical_error(name(i) + " ran into the singularity at vertex " + std::to_string(v.idx()));
    register_passage(i, v, (m_heading[i].ray.direction + rotation_to_vertex_frame(h)) & 3, time);
    if (m_mesh.is_border(v)) return;   // it is about to stop at the wall

    Ray ray = m_heading[i].ray;
    Halfedge g = h;
    while (!m_charts.corner_holds(g, ray.direction)) {
      ray = carried(i, ray, m_mesh.prev(g));
      g = m_mesh.next_around_source(g);
      if (g == h) throw Numerical_error("the angle at vertex " + std::to_string(v.idx()) + " is not 360 degrees");
    }
    enter_at_corner(i, g, ray, time);
  }

  // Directions in face(h) are turned by this to be directions in face(halfedge_from(source(h))).
  int rotation_to_vertex_frame(Halfedge h) const
  {
    int rotation = 0;
    for (const Halfedge first = m_mesh.halfedge_from(m_mesh.source(h)); h != first; h = m_mesh.next(m_mesh.opposite(h)))
      rotation += m_q.transition[h].rotation;
    return rotation & 3;
  }

  // Meet: every two lines in a face, and every two passages of a vertex, are compared once.

  void register_line(std::size_t i, Face f, const Ray& ray)
  {
    const int same = m_first_line[2 * f.idx() + (ray.direction & 1)];
    const int perpendicular = m_first_line[2 * f.idx() + (~ray.direction & 1)];
    for (int l = perpendicular; l >= 0; l = m_lines[l].next) {
      const Line& other = m_lines[l];
      const Grid_vector z = crossing_point(ray, other.ray);
      if (m_charts.face_holds(f, z))
        announce_meeting(i, ray.time(z), other.trace, other.ray.time(z), other.ray.direction - ray.direction);
    }
    for (int l = same; l >= 0; l = m_lines[l].next) {
      const Line& other = m_lines[l];
      if (other.ray.direction != ray.direction && other.ray.level == -ray.level && other.trace != i)
        announce_head_on(i, other.trace, (ray.clock + other.ray.clock) / 2);   // where the times agree; clocks are even
    }
    add_line(i, f, ray);
  }

  void add_line(std::size_t i, Face f, const Ray& ray)
  {
    int& first = m_first_line[2 * f.idx() + (ray.direction & 1)];
    m_lines.push_back({i, ray, first});
    first = static_cast<int>(m_lines.size()) - 1;
  }

  void register_passage(std::size_t i, Vertex v, int direction, std::int64_t time)
  {
    for (int p = m_first_passage[v]; p >= 0; p = m_passages[p].next) {
      const Passage& other = m_passages[p];
      const int turn = (other.direction - direction) & 3;
      if (turn & 1) announce_meeting(i, time, other.trace, other.time, turn);
      else if (other.time == time) announce_head_on(i, other.trace, time);
    }
    add_passage(i, v, direction, time);
  }

  void add_passage(std::size_t i, Vertex v, int direction, std::int64_t time)
  {
    m_passages.push_back({i, direction, time, m_first_passage[v]});
    m_first_passage[v] = static_cast<int>(m_passages.size()) - 1;
  }

  // The later of two perpendicular traces is to stop; of two at the same time, the one with the greater number.
  void announce_meeting(std::size_t a, std::int64_t time_a, std::size_t b, std::int64_t time_b, int turn_from_a_to_b)
  {
    if (m_result.traces[b].is_wall) return announce_wall(a, time_a, b, time_b, turn_from_a_to_b);
    if (time_a <= 0 || time_b <= 0) return;   // at the singularity they come from
    const Event_kind kind = time_a == time_b ? Event_kind::tie : Event_kind::crossing;
    if (time_a < time_b || (time_a == time_b && a < b))
      m_events.push({time_b, kind, b, a, time_a, turn_from_a_to_b & 3});
    else
      m_events.push({time_a, kind, a, b, time_b, -turn_from_a_to_b & 3});
  }

  void announce_wall(std::size_t i, std::int64_t time, std::size_t wall, std::int64_t wall_time, int turn_to_wall)
  {
    if (time <= 0) return;   // at the corner it comes from
    const Trace& w = m_result.traces[wall];
    if (w.is_closed() && wall_time == w.stop) wall_time = 0;
    m_events.push({time, Event_kind::crossing, i, wall, wall_time, -turn_to_wall & 3});
  }

  void announce_head_on(std::size_t a, std::size_t b, std::int64_t time)
  {
    m_events.push({time, Event_kind::head_on, a, b, time, 2});
  }

  void meet_head_on(const Event& e)
  {
    if (!were_there(e)) return;
    m_result.meetings.push_back({e.other, e.other_time, e.trace, e.time, e.turn});
    if (running(e.trace)) m_result.traces[e.trace].stop = e.time;
    if (running(e.other)) m_result.traces[e.other].stop = e.time;
  }

  // In a tie the other stops as well if the trace was stopped there by a third one: that one then came from the
  // opposite side of the other, or was there before.
  void stop_at_track(const Event& e)
  {
    if (!were_there(e)) return;
    m_result.meetings.push_back({e.other, e.other_time, e.trace, e.time, e.turn});
    const bool tie = e.kind == Event_kind::tie;
    if (running(e.trace)) {
      m_result.traces[e.trace].stop = e.time;
      m_stopped_in_tie[e.trace] = tie;
    } else if (tie && !m_stopped_in_tie[e.trace] && running(e.other)) {
      m_result.traces[e.other].stop = e.other_time;
    }
  }

  // Announced meetings count only if neither of the two was stopped before.
  bool were_there(const Event& e) const
  {
    return m_result.traces[e.trace].stop >= e.time && m_result.traces[e.other].stop >= e.other_time;
  }

  bool running(std::size_t i) const { return m_result.traces[i].stop == never; }

  Ray carried(std::size_t i, const Ray& ray, Halfedge h) const
  {
    const Ray r = ray.seen_through(m_charts.transition(h));
    if (r.clock < -largest || r.clock > largest) throw Numerical_error(name(i) + " runs for longer than 2^60 grid units");
    return r;
  }

  std::string name(std::size_t i) const
  {
    const std::size_t s = m_result.traces[i].singularity;
    if (s == no_singularity) return "trace " + std::to_string(i) + ", from the boundary,";
    const Vertex v = m_q.singularities[s];
    return "trace " + std::to_string(i) + ", from the singularity at vertex " + std::to_string(v.idx()) + ",";
  }

  const Quartic_differential&    m_q;
  const Intrinsic_triangulation& m_mesh;
  const Doubled_charts           m_charts;
  Visitor&                       m_visitor;

  Traces                     m_result;
  std::vector<Heading>       m_heading;          // by trace
  std::vector<char>          m_stopped_in_tie;   // by trace
  std::priority_queue<Event> m_events;
  std::vector<std::size_t>   m_singularity;      // by vertex
  std::vector<Start>         m_starts;
  std::vector<Line>          m_lines;
  std::vector<int>           m_first_line;       // by 2 * face + (0 for horizontal, 1 for vertical)
  std::vector<Passage>       m_passages;
  std::vector<int>           m_first_passage;    // by vertex
};

} // namespace

Traces trace_motorcycles(const Quartic_differential& q, Visitor& visitor) { return Tracer(q, visitor).run(); }

} // namespace internal
} } // namespace CGAL::Quartic_differentials
