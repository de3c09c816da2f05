// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page_model.h"

#include "base64.h"
#include "distortion.h"

#include <CGAL/Quartic_differentials/Area_distortion.h>
#include <CGAL/Quartic_differentials/Common_refinement.h>
#include <CGAL/Quartic_differentials/internal/Patch_locator.h>
#include <CGAL/Quartic_differentials/patch_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;

namespace {

using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
using Index = std::uint32_t;

const char* type_name(float) { return "Float32Array"; }
const char* type_name(Index) { return "Uint32Array"; }

template <class T>
Json typed_array(const std::vector<T>& v)
{
  return {{"type", type_name(T())}, {"length", v.size()}, {"base64", base64(v.data(), v.size() * sizeof(T))}};
}

void append(std::vector<float>& numbers, const Point_3& p)
{
  for (int k = 0; k < 3; ++k) numbers.push_back(static_cast<float>(p[k]));
}

// ---- The surface

// Triangles with a place in a patch at every corner; corners of one patch that are one point are shared.
class Shown_surface
{
public:
  Index add_point(const Point_3& p)
  {
    append(m_points, p);
    m_first_corner.push_back(none);
    return static_cast<Index>(m_first_corner.size() - 1);
  }

  Index corner(Index point, std::size_t patch, const Point_2& uv)
  {
    const auto u = static_cast<float>(uv.x()), v = static_cast<float>(uv.y());
    for (Index c = m_first_corner[point]; c != none; c = m_next_corner[c])
      if (m_patch[c] == patch && m_uv[2 * c] == u && m_uv[2 * c + 1] == v) return c;
    const auto c = static_cast<Index>(m_point.size());
    m_point.push_back(point);
    m_patch.push_back(static_cast<Index>(patch));
    m_uv.push_back(u);
    m_uv.push_back(v);
    m_next_corner.push_back(m_first_corner[point]);
    return m_first_corner[point] = c;
  }

  void add_triangle(Index a, Index b, Index c) { m_triangles.insert(m_triangles.end(), {a, b, c}); }
  void add_edge(Index a, Index b) { m_edges.insert(m_edges.end(), {a, b}); }
  void add_piece_of_arc(Index a, Index b) { m_arcs.insert(m_arcs.end(), {a, b}); }

  Json json(bool has_charts) const
  {
    Json corner = {{"point", typed_array(m_point)}};
    if (has_charts) corner.update({{"uv", typed_array(m_uv)}, {"patch", typed_array(m_patch)}});
    return {{"points", typed_array(m_points)}, {"corner", corner}, {"triangles", typed_array(m_triangles)},
            {"edges", typed_array(m_edges)}, {"arcs", typed_array(m_arcs)}};
  }

private:
  static constexpr Index none = static_cast<Index>(-1);

  std::vector<float> m_points, m_uv;
  std::vector<Index> m_point, m_patch, m_triangles, m_edges, m_arcs;
  std::vector<Index> m_first_corner, m_next_corner;   // lists of the corners at a point
};

// The triangles of a mesh; texture and patch are functions of a halfedge (at its target) and of a face.
template <class Texture, class Patch>
void add_mesh(Shown_surface& s, const Mesh& mesh, Texture texture, Patch patch)
{
  for (Vertex v : mesh.vertices()) s.add_point(mesh.point(v));
  for (Face f : mesh.faces()) {
    std::array<Index, 3> c;
    Halfedge h = mesh.halfedge(f);
    for (Index& corner : c) {
      corner = s.corner(mesh.target(h), patch(f), texture(h));
      h = mesh.next(h);
    }
    s.add_triangle(c[0], c[1], c[2]);
  }
}

// The input's vertices are the first of every surface that refines it.
void add_edges(Shown_surface& s, const Intrinsic_triangulation& input)
{
  for (Edge e : input.edges()) s.add_edge(input.source(first_halfedge(e)), input.target(first_halfedge(e)));
}

Json surface_cut_along_arcs(const Intrinsic_triangulation& input, const T_mesh& t, const Refined_surface& refined)
{
  Shown_surface s;
  Mesh mesh = patch_mesh(t, refined);
  const auto texture = mesh.add_property_map<Halfedge, Point_2>("h:texture").first;   // they are there
  const auto patch = mesh.add_property_map<Face, std::uint32_t>("f:patch").first;
  const auto arc = mesh.add_property_map<Edge, std::uint32_t>("e:arc").first;
  add_mesh(s, mesh, [&](Halfedge h) { return texture[h]; }, [&](Face f) { return patch[f]; });
  for (Edge e : mesh.edges())
    if (arc[e] != no_arc) s.add_piece_of_arc(mesh.vertex(e, 0), mesh.vertex(e, 1));
  add_edges(s, input);
  return s.json(true);
}

Json surface_with_charts(const Intrinsic_triangulation& input, const Refined_surface& refined)
{
  Shown_surface s;
  const Quartic_differential& q = refined.differential;
  const double unit = std::ldexp(1.0, -q.grid_exponent);
  add_mesh(s, q.triangulation.mesh(), [&](Halfedge h) {
    const Grid_vector z = q.corner[q.triangulation.next(h)];
    return Point_2(unit * static_cast<double>(z.x), unit * static_cast<double>(z.y));
  }, [](Face) { return 0; });
  add_edges(s, input);
  return s.json(true);
}

Json surface_alone(const Intrinsic_triangulation& input)
{
  Shown_surface s;
  add_mesh(s, input.mesh(), [](Halfedge) { return Point_2(0, 0); }, [](Face) { return 0; });
  add_edges(s, input);
  return s.json(false);
}

// Every patch as a regular grid.
class Patch_grids
{
public:
  Patch_grids(const T_mesh& t, const Quartic_differential& q, std::size_t triangles)
    : m_q(q), m_locator(t, q), m_unit(std::ldexp(1.0, -t.grid_exponent))
  {
    double area = 0;
    for (const T_mesh::Patch& p : t.patches) area += static_cast<double>(p.width) * static_cast<double>(p.height);
    m_spacing = std::sqrt(2 * area / static_cast<double>(triangles));
    for (std::size_t p = 0; p < t.patches.size(); ++p) add_patch(p, t.patches[p]);
  }

  Json json() const
  {
    Json surface = m_surface.json(true);
    surface["reduced_from"] = m_q.triangulation.number_of_faces();
    return surface;
  }

private:
  std::int64_t steps(std::int64_t length) const
  { return std::max<std::int64_t>(1, std::llround(static_cast<double>(length) / m_spacing)); }

  static std::int64_t step(std::int64_t length, std::int64_t i, std::int64_t n)
  { return static_cast<std::int64_t>(static_cast<__int128>(length) * i / n); }

  Index corner(std::size_t p, Grid_vector z)
  {
    const Index point = m_surface.add_point(position_on_input(m_q.triangulation, m_locator.locate(p, z)));
    // every point has one corner, of the same index
    m_surface.corner(point, p, Point_2(m_unit * static_cast<double>(z.x), m_unit * static_cast<double>(z.y)));
    return point;
  }

  void add_patch(std::size_t p, const T_mesh::Patch& patch)
  {
    const std::int64_t n = steps(patch.width), m = steps(patch.height);
    std::vector<Index> grid;   // row by row
    for (std::int64_t j = 0; j <= m; ++j)
      for (std::int64_t i = 0; i <= n; ++i)
        grid.push_back(corner(p, {step(patch.width, i, n), step(patch.height, j, m)}));
    const auto at = [&](std::int64_t i, std::int64_t j) { return grid[static_cast<std::size_t>(j * (n + 1) + i)]; };
    for (std::int64_t j = 0; j < m; ++j)
      for (std::int64_t i = 0; i < n; ++i) {
        m_surface.add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        m_surface.add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    // arcs from both their sides, whose points differ
    for (std::int64_t i = 0; i < n; ++i)
      for (std::int64_t j : {std::int64_t(0), m}) m_surface.add_piece_of_arc(at(i, j), at(i + 1, j));
    for (std::int64_t j = 0; j < m; ++j)
      for (std::int64_t i : {std::int64_t(0), n}) m_surface.add_piece_of_arc(at(i, j), at(i, j + 1));
  }

  const Quartic_differential&   m_q;
  const internal::Patch_locator m_locator;
  double                        m_unit, m_spacing;
  Shown_surface                 m_surface;
};

Json surface_model(const Intrinsic_triangulation& input, const Quartic_differential_result& r,
                   std::size_t most_triangles)
{
  if (!r.refined || r.refined->flipped_triangles > 0) return surface_alone(input);
  if (!r.t_mesh) return surface_with_charts(input, *r.refined);
  const Quartic_differential& q = r.refined->differential;
  if (q.triangulation.number_of_faces() > most_triangles) return Patch_grids(*r.t_mesh, q, most_triangles).json();
  return surface_cut_along_arcs(input, *r.t_mesh, *r.refined);
}

// ---- The T-mesh

// Where an arc runs: along side `side` of `patch`, from the place `begin` on it.
struct Use_of_arc
{
  std::size_t  patch;
  int          side;
  std::int64_t begin;
};

// Lays the patches out side by side, beginning with the first: always across the longest arc on the rim.
class Layout
{
public:
  explicit Layout(const T_mesh& t) : m_t(t), m_uses(t.arcs.size()), m_place(t.patches.size())
  {
    for_each_use([&](std::size_t arc, const Use_of_arc& use) { m_uses[arc].push_back(use); });
    std::priority_queue<Step> rim;
    reach(0, Transition(), rim);
    while (!rim.empty()) {
      const auto [length, arc, from, to] = rim.top();
      rim.pop();
      if (m_place[m_uses[arc][to].patch]) continue;
      reach(m_uses[arc][to].patch, across(arc, to, from).then(*m_place[m_uses[arc][from].patch]), rim);
    }
  }

  const Transition& operator[](std::size_t patch) const { return *m_place[patch]; }

private:
  using Step = std::tuple<std::int64_t, std::size_t, int, int>;   // length, arc, uses from and to

  template <class Action>
  void for_each_use(Action action) const
  {
    for (std::size_t p = 0; p < m_t.patches.size(); ++p)
      for (int k = 0; k < 4; ++k) {
        std::int64_t begin = 0;
        for (const T_mesh::Side_piece& piece : m_t.patches[p].sides[k]) {
          action(piece.arc, Use_of_arc{p, k, begin});
          begin += m_t.arcs[piece.arc].length;
        }
      }
  }

  void reach(std::size_t patch, const Transition& place, std::priority_queue<Step>& rim)
  {
    m_place[patch] = place;
    for (const auto& side : m_t.patches[patch].sides)
      for (const T_mesh::Side_piece& piece : side)
        for (int from = 0; m_uses[piece.arc].size() == 2 && from < 2; ++from)
          if (m_uses[piece.arc][from].patch == patch)
            rim.emplace(m_t.arcs[piece.arc].length, piece.arc, from, 1 - from);
  }

  // from one patch at an arc to the other: its two uses run against one another
  Transition across(std::size_t arc, int from, int to) const
  {
    const Use_of_arc &a = m_uses[arc][from], &b = m_uses[arc][to];
    const int rotation = (b.side - a.side + 2) & 3;
    const Grid_vector begin = m_t.patches[a.patch].on_side(a.side, a.begin);
    const Grid_vector same = m_t.patches[b.patch].on_side(b.side, b.begin + m_t.arcs[arc].length);
    return {rotation, same - rotated(begin, rotation)};
  }

  const T_mesh&                           m_t;
  std::vector<std::vector<Use_of_arc>>    m_uses;    // by arc: two, or one on the boundary
  std::vector<std::optional<Transition>>  m_place;   // by patch: to the plane
};

Json t_mesh_model(const T_mesh& t)
{
  const auto units = [&](std::int64_t x) { return std::ldexp(static_cast<double>(x), -t.grid_exponent); };
  Json order = Json::array(), arcs = Json::array(), patches = Json::array();
  for (const T_mesh::Node& n : t.nodes) order.push_back(n.is_singularity() ? Json(n.order) : Json());
  for (const T_mesh::Arc& a : t.arcs) arcs.push_back({a.from, a.to, units(a.length)});
  const Layout layout(t);
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    const T_mesh::Patch& patch = t.patches[p];
    Json sides = Json::array();
    for (const auto& side : patch.sides) {
      Json pieces = Json::array();
      for (const T_mesh::Side_piece& piece : side) pieces.push_back({{"arc", piece.arc}, {"forward", piece.forward}});
      sides.push_back(pieces);
    }
    const Transition& place = layout[p];
    patches.push_back({{"width", units(patch.width)}, {"height", units(patch.height)}, {"sides", sides},
                       {"pattern", {place.rotation, units(place.translation.x), units(place.translation.y)}}});
  }
  return {{"order", order}, {"arcs", arcs}, {"patches", patches}};
}

// ---- Loops and quads

Json loops_model(const Intrinsic_triangulation& input, const Handle_tunnel_loops& loops)
{
  Json list = Json::array();
  for (int k = 0; k < static_cast<int>(loops.loops.size()); ++k) {
    std::vector<float> points;
    for (Halfedge h : loops.loops[k].walk) append(points, input.mesh().point(input.source(h)));
    list.push_back({{"name", loop_name(k, input.genus())}, {"kind", loop_kind(loops, k)},
                    {"points", typed_array(points)}});
  }
  return list;
}

Json quads_model(const Quad_mesh& m)
{
  std::vector<float> points;
  std::vector<Index> quads, patch;
  for (const Point_3& p : m.points) append(points, p);
  for (const auto& quad : m.quads)
    for (std::size_t v : quad) quads.push_back(static_cast<Index>(v));
  for (std::size_t p : m.patch) patch.push_back(static_cast<Index>(p));
  return {{"points", typed_array(points)}, {"quads", typed_array(quads)}, {"patch", typed_array(patch)}};
}

// ---- Histograms

// The share of the area in bins of equal width; values beyond the ends are in the first and the last bin.
Json histogram(const Area_samples& samples, double from, double to)
{
  const int bins = 48;
  std::vector<double> share(bins, 0.0);
  const double total = samples.area.sum(), width = std::max(to - from, 1e-12);   // not 0
  for (Eigen::Index k = 0; k < samples.value.size(); ++k) {
    const int bin = static_cast<int>(std::clamp((samples.value[k] - from) / width * bins, 0.0, bins - 1.0));
    share[static_cast<std::size_t>(bin)] += samples.area[k] / total;
  }
  return {{"from", from}, {"to", from + width}, {"share", share}};
}

Json histograms(const Intrinsic_triangulation& input, const Quartic_differential_result& r)
{
  Json result;
  Area_samples scale = log_scale(input, r.metric->metric.u);
  scale.value = 2 * (scale.value.array() - scale.mean());   // of areas
  result["log_area_scale"] = histogram(scale, weighted_quantile(scale.value, scale.area, 0.001),
                                       weighted_quantile(scale.value, scale.area, 0.999));
  if (r.refined) {
    Area_samples distortion = conformal_distortion(r.refined->differential);
    distortion.value = distortion.value.array().log();
    result["log_conformal_distortion"] = histogram(distortion, 0,
                                                   weighted_quantile(distortion.value, distortion.area, 0.99));
  }
  return result;
}

} // namespace

Json page_model(const Intrinsic_triangulation& input, const Quartic_differential_result& r, std::size_t most_triangles)
{
  Json model = Json::object();
  if (input.is_embedded()) {
    model["surface"] = surface_model(input, r, most_triangles);
    if (r.surface && r.surface->loops) model["loops"] = loops_model(input, *r.surface->loops);
  }
  if (r.t_mesh) model["tmesh"] = t_mesh_model(*r.t_mesh);
  if (r.quads) model["quads"] = quads_model(r.quads->mesh);
  if (r.metric) model["histograms"] = histograms(input, r);
  return model;
}
