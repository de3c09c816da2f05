// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The verification accepts a valid output folder, and rejects every way of spoiling it that is tried here.

#include <CGAL/Quartic_differentials/IO/write_flat_intrinsic.h>
#include <CGAL/Quartic_differentials/IO/write_quads.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/immersion.h>
#include <CGAL/Quartic_differentials/pipeline.h>
#include <CGAL/Quartic_differentials/quad_mesh.h>
#include <CGAL/Quartic_differentials/quantize.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>
#include <CGAL/Quartic_differentials/t_mesh.h>

#include "check.h"
#include "square_tiled_surfaces.h"
#include "verified_output.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

Quartic_differential immersed(const Square_tiled_surface& s)
{
  Immersion_report report;
  return immersion(s.triangulation, s.triangulation.lengths(), s.singularities, s.order, s.triangulation.area(), {},
                   report);
}

// the same differential on a surface with made-up positions in space, so that there are polylines
Quartic_differential embedded(Quartic_differential q)
{
  std::mt19937 random(17);
  Mesh mesh = q.triangulation.mesh();
  for (Vertex v : mesh.vertices())
    mesh.point(v) = Point_3(std::ldexp(random(), -32), std::ldexp(random(), -32), std::ldexp(random(), -32));
  q.triangulation = Intrinsic_triangulation(mesh);
  return q;
}

Output output_of(const Quartic_differential& q)
{
  Output output;
  std::ostringstream flat, tmesh;
  write_flat_intrinsic_json(flat, q);
  output.flat = json::parse(flat.str());
  if (!q.singularities.empty()) {
    Visitor visitor;
    write_t_mesh_json(tmesh, t_mesh(q, visitor), q, "flat_intrinsic");
    output.tmesh = json::parse(tmesh.str());
  }
  output.report["input"]["genus"] = q.triangulation.genus();
  output.report["singularities"] = json::array();
  for (Vertex v : q.singularities) output.report["singularities"].push_back({{"order", q.order[v]}});
  return output;
}

Output valid_output()
{
  std::mt19937 random(11);
  Gluing glued = random_gluing(5, random);
  while (!is_connected(glued)) glued = random_gluing(5, random);
  return output_of(embedded(immersed(square_tiled_surface(subdivided(glued, 2)))));
}

void valid_outputs_pass()
{
  std::mt19937 random(5);
  int verified = 0;
  for (int i = 0; i < 40; ++i) {
    const Gluing glued = random_gluing(1 + i % 9, random);
    if (!is_connected(glued)) continue;
    Square_tiled_surface s = square_tiled_surface(subdivided(glued, 1 + i % 3));
    flip_randomly(s.triangulation, 30, random);
    if (s.singularities.empty()) continue;
    const Quartic_differential q = immersed(s);
    const auto checks = output_of(i % 2 == 0 ? q : embedded(q)).verified();
    CHECK(all_hold(checks));
    for (const Verification& c : checks)
      if (!c.ok) std::cerr << c.what << std::endl;
    ++verified;
  }
  CHECK(verified > 20);
}

void flat_torus_needs_no_tmesh()
{
  const Output torus = output_of(immersed(square_tiled_surface(subdivided({2, 3, 0, 1}, 3))));
  torus.verified();
  std::filesystem::remove(Output::folder() + "/tmesh.json");
  CHECK(all_hold(verify_outputs(Output::folder())));
}

void spoilt_outputs_fail()
{
  const Output valid = valid_output();
  CHECK(all_hold(valid.verified()));
  const auto check_fails = [&](const std::string& sentence, const std::function<void(Output&)>& spoil) {
    Output spoilt = valid;
    spoil(spoilt);
    const auto checks = spoilt.verified();
    CHECK(!all_hold(checks));
    CHECK(fails_with(checks, sentence));
    if (!fails_with(checks, sentence)) std::cerr << "expected to fail with: " << sentence << std::endl;
  };
  const std::int64_t huge = std::numeric_limits<std::int64_t>::max();

  // flat_intrinsic.json
  check_fails("flipped or degenerate", [](Output& o) {
    auto& t = o.flat["uv"][0];
    std::swap(t[0], t[2]);
    std::swap(t[1], t[3]);
  });
  const auto move_a_corner = [](Output& o) {   // not along a side or a diagonal of a square: the area changes
    o.flat["uv"][3][0] = o.flat["uv"][3][0].get<std::int64_t>() + 1;
    o.flat["uv"][3][1] = o.flat["uv"][3][1].get<std::int64_t>() + 7;
  };
  check_fails("exact rotation", move_a_corner);
  check_fails("tmesh: patch areas", move_a_corner);
  check_fails("gluing", [](Output& o) { std::swap(o.flat["opposite"][0][0], o.flat["opposite"][0][1]); });
  check_fails("gluing", [](Output& o) { o.flat["opposite"][2][1] = {2, 1}; });
  check_fails("gluing", [](Output& o) {
    auto& t = o.flat["triangles"];
    const auto differs = std::find_if(t.begin(), t.end(), [&](const json& f) { return f[0] != t[0][0]; });
    t[0][0] = (*differs)[0];
  });
  check_fails("one circle", [](Output& o) {   // two vertices with the same name
    for (auto& f : o.flat["triangles"])
      for (auto& v : f)
        if (v == 1) v = 0;
  });
  check_fails("one component", [](Output& o) {   // two copies of the surface
    const std::size_t n = o.flat["triangles"].size();
    for (const char* key : {"triangles", "uv", "opposite"})
      for (std::size_t t = 0; t < n; ++t) {
        json copy = o.flat[key][t];
        if (key == std::string("opposite")) for (auto& glued : copy) glued[0] = glued[0].get<std::size_t>() + n;
        o.flat[key].push_back(copy);
      }
  });
  check_fails("flat_intrinsic.json: triangle 4", [](Output& o) { o.flat["triangles"][4] = {0, 1}; });
  check_fails("vertex of triangle 4 is out of range", [](Output& o) { o.flat["triangles"][4][0] = -1; });
  check_fails("not an integer", [](Output& o) { o.flat["uv"][4][0] = 0.5; });
  check_fails("not an integer", [](Output& o) { o.flat["uv"][4][0] = "0"; });
  check_fails("not an integer", [](Output& o) { o.flat["uv"][4][0] = 1e300; });
  check_fails("out of range", [&](Output& o) { o.flat["uv"][4][0] = huge; });
  check_fails("out of range", [&](Output& o) { o.flat["uv"][4][0] = std::numeric_limits<std::int64_t>::min(); });
  check_fails("out of range", [&](Output& o) { o.flat["uv"][4][0] = std::numeric_limits<std::uint64_t>::max(); });
  check_fails("out of range", [&](Output& o) { o.flat["opposite"][4][0][0] = huge; });
  check_fails("out of range", [](Output& o) { o.flat["opposite"][4][0][1] = 3; });
  check_fails("out of range", [](Output& o) { o.flat["grid_exponent"] = 1000000; });
  check_fails("\"uv\" is missing", [](Output& o) { o.flat.erase("uv"); });
  check_fails("uv does not have", [](Output& o) { o.flat["uv"].erase(0); });
  check_fails("\"grid_exponent\" is missing", [](Output& o) { o.flat = json::array({1, 2}); });
  check_fails("closed surface", [](Output& o) {
    for (const char* key : {"triangles", "uv", "opposite"}) o.flat[key] = json::array();
  });
  check_fails("three finite numbers", [](Output& o) { o.flat["vertices"] = {{0, 0, "z"}}; });

  // report.json
  check_fails("orders match the report", [](Output& o) { o.report["singularities"].erase(0); });
  check_fails("Euler characteristic", [](Output& o) { o.report["input"]["genus"] = 17; });
  check_fails("8g-8", [](Output& o) { o.report["input"]["genus"] = 17; });
  check_fails("report.json: \"genus\" is missing", [](Output& o) { o.report["input"] = 3; });
  check_fails("out of range", [](Output& o) { o.report["input"]["genus"] = -1; });

  // tmesh.json
  check_fails("used once forward", [](Output& o) { o.tmesh["patches"].erase(0); });
  check_fails("patch areas", [](Output& o) { o.tmesh["patches"].erase(0); });
  const auto increase = [](json& number) { number = number.get<std::int64_t>() + 1; };
  check_fails("exact rectangles", [&](Output& o) { increase(o.tmesh["arcs"][0]["length"]); });
  check_fails("positive length", [](Output& o) { o.tmesh["arcs"][0]["length"] = 0; });
  check_fails("exact rectangles", [&](Output& o) { for (auto& a : o.tmesh["arcs"]) a["length"] = huge; });
  check_fails("exact rectangles", [&](Output& o) { increase(o.tmesh["patches"][0]["width"]); });
  check_fails("patch areas", [](Output& o) { o.tmesh["grid_exponent"] = 44; });
  check_fails("close up", [](Output& o) { auto& s = o.tmesh["patches"][0]["sides"]; std::swap(s[0], s[2]); });
  check_fails("used once forward", [](Output& o) {
    auto& forward = o.tmesh["patches"][0]["sides"][0][0]["forward"];
    forward = !forward.get<bool>();
  });
  check_fails("V-E+F", [](Output& o) {
    auto node = o.tmesh["nodes"][0];
    node["id"] = 100000;
    o.tmesh["nodes"].push_back(node);
  });
  check_fails("one node for every", [](Output& o) { o.tmesh["nodes"][0]["order"] = 7; });
  check_fails("kind of every node", [](Output& o) { o.tmesh["nodes"].back()["kind"] = "corner"; });
  check_fails("\"polyline\" is missing", [](Output& o) { o.tmesh["arcs"][0].erase("polyline"); });
  check_fails("no two points", [](Output& o) { o.tmesh["arcs"][0]["polyline"] = {{0, 0, 0}}; });
  check_fails("polylines end", [](Output& o) { o.tmesh["nodes"][1]["position"] = {1, 1, 0}; });
  check_fails("is not unique", [](Output& o) { o.tmesh["nodes"][1]["id"] = 0; });
  check_fails("does not exist", [](Output& o) { o.tmesh["arcs"][0]["from"] = 100000; });
  check_fails("does not exist", [](Output& o) { o.tmesh["patches"][0]["sides"][0][0]["arc"] = 100000; });
  check_fails("side of a patch is empty", [](Output& o) { o.tmesh["patches"][0]["sides"][0] = json::array(); });
  check_fails("4 entries", [](Output& o) { o.tmesh["patches"][0]["sides"].erase(0); });
  check_fails("true or false", [](Output& o) { o.tmesh["patches"][0]["sides"][0][0]["forward"] = 1; });
  check_fails("neither", [](Output& o) { o.tmesh["surface"] = "sphere"; });
  check_fails("not an integer", [](Output& o) { o.tmesh["arcs"][0]["length"] = 1e30; });
  check_fails("tmesh.json: \"id\" is missing", [](Output& o) { o.tmesh["arcs"] = {nullptr}; });
}

// files that are missing, cut off, empty, binary or nested too deeply
void malformed_files_fail()
{
  const Output valid = valid_output();
  for (const std::string name : {"flat_intrinsic.json", "tmesh.json", "report.json"}) {
    const std::string text = valid.file(name).dump();
    const std::vector<std::string> texts = {"", "{", "null", "[]", "\xff\xfe\0x", std::string(1000000, '['), text + "}",
                                            text.substr(0, text.size() / 2), text.substr(0, text.size() - 1)};
    for (const std::string& bad : texts) {
      valid.verified();
      Output::write(name, bad);
      CHECK(fails_with(verify_outputs(Output::folder()), name + ": "));
    }
    valid.verified();
    std::filesystem::remove(Output::folder() + "/" + name);
    CHECK(fails_with(verify_outputs(Output::folder()), name + ": the file cannot be opened"));
  }
  CHECK(!all_hold(verify_outputs(Output::folder() + "/no/such/folder")));
}

// one byte at a time: no crash, whatever the verdict
void random_bytes_do_no_harm()
{
  const Output valid = valid_output();
  std::mt19937 random(1);
  for (const std::string name : {"flat_intrinsic.json", "tmesh.json", "report.json"}) {
    const std::string text = valid.file(name).dump();
    valid.verified();
    for (int i = 0; i < 300; ++i) {
      std::string bad = text;
      bad[random() % bad.size()] = "0123456789[]{},:\"-.eE "[random() % 22];
      Output::write(name, bad);
      CHECK(!verify_outputs(Output::folder()).empty());
    }
  }
}

// Every texture coordinate of the obj reads back to the identical double, and the corners differ by exact rotations.
void obj_is_exact()
{
  const Quartic_differential q = embedded(immersed(square_tiled_surface(subdivided({4, 7, 6, 5, 0, 3, 2, 1}, 3))));
  const Intrinsic_triangulation& t = q.triangulation;
  write_flat_obj(Output::folder(), "flat_intrinsic", q);

  std::ifstream in(Output::folder() + "/flat_intrinsic.obj");
  std::vector<std::string> u, v;
  std::size_t positions = 0, f = 0;
  for (std::string line; std::getline(in, line); ) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") ++positions;
    if (key == "vt") { u.emplace_back(); v.emplace_back(); words >> u.back() >> v.back(); }
    if (key != "f") continue;
    for (Halfedge h : t.halfedges(Face(static_cast<Mesh::size_type>(f)))) {
      std::size_t vertex = 0, texture = 0;
      char slash = 0;
      words >> vertex >> slash >> texture;
      CHECK_EQUAL(vertex, t.source(h).idx() + 1u);
      CHECK(texture >= 1 && texture <= u.size());
      CHECK(std::strtod(u[texture - 1].c_str(), nullptr) == std::ldexp(q.corner[h].x, -q.grid_exponent));
      CHECK(std::strtod(v[texture - 1].c_str(), nullptr) == std::ldexp(q.corner[h].y, -q.grid_exponent));
    }
    ++f;
  }
  CHECK_EQUAL(positions, t.number_of_vertices());
  CHECK_EQUAL(f, t.number_of_faces());
  CHECK(u.size() < t.number_of_halfedges() / 2);   // corners share texture vertices away from seams
  for (const char* name : {"flat_intrinsic.mtl", "flat_intrinsic.png"})
    CHECK(std::filesystem::file_size(Output::folder() + "/" + name) > 50);
}

// the line of a texture vertex whose vertex has others too: an edge at it has different ones on its two sides
std::size_t line_on_seam(const Lines& lines)
{
  std::vector<std::size_t> line_of_texture{0};   // numbers begin at 1
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].compare(0, 3, "vt ") == 0) line_of_texture.push_back(i);
  std::map<std::size_t, std::size_t> texture_of;   // by vertex
  for (const std::string& line : lines) {
    if (line.compare(0, 2, "f ") != 0) continue;
    std::istringstream words(line.substr(2));
    std::size_t vertex, texture;
    for (char slash; words >> vertex >> slash >> texture; )
      if (texture_of.emplace(vertex, texture).first->second != texture) return line_of_texture[texture];
  }
  throw std::logic_error("no seam");
}

// The results on a surface in space, spoilt one line of flat.obj at a time.
void flat_obj_is_checked()
{
  const Intrinsic_triangulation input(handle_chain(2, 6));
  Visitor visitor;
  Quartic_differential_result result;
  quartic_differential(input, std::nullopt, {}, visitor, result);
  Output output = output_of(*result.differential);
  std::ostringstream tmesh;
  write_t_mesh_json(tmesh, *result.t_mesh, result.traced(), "input");
  output.tmesh = json::parse(tmesh.str());
  output.verified();
  CHECK(fails_with(verify_outputs(Output::folder(), &input), "flat.obj: the file cannot be opened"));
  write_flat_obj(Output::folder(), "flat", result.refined->differential);
  CHECK(all_hold(verify_outputs(Output::folder(), &input)));
  CHECK(all_hold(verify_outputs(Output::folder())));
  const Intrinsic_triangulation other(handle_chain(2, 8));
  CHECK(fails_with(verify_outputs(Output::folder(), &other), "vertices of the input are missing or have moved"));

  const Lines lines = lines_of("flat.obj");
  const auto last = [&](const std::string& key) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].compare(0, key.size(), key) == 0) found = i;
    return found;
  };
  const auto spoilt = [&](std::size_t line, const std::string& text, const std::string& sentence) {
    Lines bad = lines;
    bad[line] = text;
    Output::write("flat.obj", joined(bad));
    const auto checks = verify_outputs(Output::folder(), &input);
    CHECK(fails_with(checks, sentence));
    if (!fails_with(checks, sentence)) std::cerr << "instead of " << text << ": " << sentence << std::endl;
  };
  const std::size_t f = last("f "), v = last("v "), vt = last("vt "), seam = line_on_seam(lines), first_v = 3;
  CHECK(lines[first_v].compare(0, 2, "v ") == 0);
  std::istringstream words(lines[f].substr(2));
  std::string a, b, c;
  words >> a >> b >> c;
  spoilt(f, "", "flat.obj: every edge is shared by two triangles");
  spoilt(f, "f " + b + ' ' + a + ' ' + c, "flat.obj: every edge is shared by two triangles");
  spoilt(f, "f " + a + ' ' + b, "flat.obj: a face is not a triangle");
  spoilt(f, lines[f] + ' ' + a, "flat.obj: a face is not a triangle");
  spoilt(f, "f 1 2 3", "flat.obj: a corner of a face has no texture vertex");
  spoilt(f, "f 99999999/1 2/2 3/3", "flat.obj: a face refers to what is not there");
  spoilt(vt, "vt 0.1 0.2", "flat.obj: a texture coordinate is not on the grid");
  spoilt(vt, "vt nan 0", "flat.obj: a texture coordinate is not a finite number");
  std::istringstream numbers(lines[seam].substr(3));
  double x = 0, y = 0;
  numbers >> x >> y;
  std::ostringstream moved;   // along the grid, and too little to turn a triangle over
  moved << std::setprecision(17) << "vt " << x + std::ldexp(1.0, -20) << ' ' << y;
  spoilt(seam, moved.str(), "are not an exact rotation");
  spoilt(v, "v 100 0 0", "flat.obj: lies on the input");
  spoilt(v, "v 100 zero 0", "flat.obj: a coordinate is not a finite number");
  spoilt(first_v, "v 0 0 0", "1 of " + std::to_string(input.number_of_vertices()) + " vertices of the input");
  Output::write("flat.obj", "");
  CHECK(fails_with(verify_outputs(Output::folder(), &input), "flat.obj: there is no triangle"));
  std::filesystem::remove(Output::folder() + "/flat.obj");
}

bool is_kind(const std::string& line, const char* key) { return line.compare(0, 2, key) == 0; }

// the line that is the n-th of its kind
std::string& line(Lines& lines, const char* key, std::size_t n)
{
  for (std::string& l : lines)
    if (is_kind(l, key) && n-- == 0) return l;
  throw std::logic_error("no such line");
}

// the vertices of a quad's line
std::vector<std::size_t> quad_of(const std::string& line)
{
  std::istringstream words(line.substr(1));
  std::vector<std::size_t> quad(4);
  for (std::size_t& v : quad) words >> v;
  return quad;
}

std::string quad_line(const std::vector<std::size_t>& quad)
{
  std::string line = "f";
  for (std::size_t v : quad) line += ' ' + std::to_string(v);
  return line;
}

// Replaces every vertex of all quads.
void rename(Lines& lines, const std::function<std::size_t(std::size_t)>& name)
{
  for (std::string& l : lines) {
    if (!is_kind(l, "f ")) continue;
    std::vector<std::size_t> quad = quad_of(l);
    for (std::size_t& v : quad) v = name(v);
    l = quad_line(quad);
  }
}

// The quads of a surface of genus 2, spoilt in every way.
void quads_obj_is_checked()
{
  const Intrinsic_triangulation input(handle_chain(2, 6));
  Visitor visitor;
  Quartic_differential_result result;
  quartic_differential(input, std::nullopt, {}, visitor, result);
  Quantization_options options;
  options.number_of_quads = 400;
  const Quad_mesh m = quad_mesh(*result.t_mesh, quantize(*result.t_mesh, options, visitor).length, *result.refined);
  Output valid = output_of(*result.differential);
  std::ostringstream tmesh, quads;
  write_t_mesh_json(tmesh, *result.t_mesh, result.traced(), "input");
  write_quads_obj(quads, m);
  valid.tmesh = json::parse(tmesh.str());
  const std::size_t patches = std::set<std::size_t>(m.patch.begin(), m.patch.end()).size();
  valid.report["quad_mesh"] = {{"quads", m.quads.size()}, {"vertices", m.points.size()}, {"patches", patches},
                               {"scaled_jacobian", {{"min", scaled_jacobian(m).least}}}};
  write_flat_obj(Output::folder(), "flat", result.refined->differential);
  std::filesystem::remove(Output::folder() + "/quads.obj");
  CHECK(fails_with(valid.verified(), "quads.obj: the file cannot be opened"));
  Output::write("quads.obj", quads.str());
  CHECK(all_hold(valid.verified()));
  CHECK(all_hold(verify_outputs(Output::folder(), &input)));
  const Lines lines = lines_of("quads.obj");

  const auto check_fails = [&](const std::string& sentence, const std::function<void(Output&, Lines&)>& spoil) {
    Output output = valid;
    Lines bad = lines;
    spoil(output, bad);
    Output::write("quads.obj", joined(bad));
    output.verified();
    const auto checks = verify_outputs(Output::folder(), &input);
    CHECK(fails_with(checks, sentence));
    if (!fails_with(checks, sentence)) std::cerr << "expected to fail with: " << sentence << std::endl;
  };
  const auto are_quads = [](const std::string& a, const std::string& b)
  { return is_kind(a, "f ") && is_kind(b, "f "); };
  const auto two_of_a_patch = [&](Lines& l) { return std::adjacent_find(l.begin(), l.end(), are_quads); };
  using Change = std::function<void(std::vector<std::size_t>&)>;
  const auto change_quad = [&](const std::string& sentence, const Change& change) {
    check_fails(sentence, [&](Output&, Lines& l) {
      std::string& first = *two_of_a_patch(l);
      std::vector<std::size_t> quad = quad_of(first);
      change(quad);
      first = quad_line(quad);
    });
  };
  const std::size_t n = m.points.size();

  change_quad("edge is shared by two quads", [](auto& quad) { std::swap(quad[1], quad[2]); });
  change_quad("edge is shared by two quads", [](auto& quad) { std::reverse(quad.begin(), quad.end()); });
  change_quad("are a regular grid", [](auto& quad) { std::rotate(quad.begin(), quad.begin() + 1, quad.end()); });
  change_quad("has a vertex twice", [](auto& quad) { quad[2] = quad[0]; });
  change_quad("a face is not a quad", [](auto& quad) { quad.push_back(1); });
  change_quad("a face is not a quad", [](auto& quad) { quad.pop_back(); });
  change_quad("refers to what is not there", [](auto& quad) { quad[0] = 0; });
  change_quad("refers to what is not there", [&](auto& quad) { quad[0] = n + 1; });
  for (const char* sentence : {"edge is shared by two quads", "vertices, as in the report"})
    check_fails(sentence, [](Output&, Lines& l) { line(l, "f ", 20).clear(); });
  check_fails("edge is shared by two quads", [](Output&, Lines& l) { l.push_back(line(l, "f ", 20)); });
  check_fails("one component", [&](Output&, Lines& l) {   // two copies
    Lines copy = l;
    rename(copy, [&](std::size_t v) { return v + n; });
    l.insert(l.end(), copy.begin(), copy.end());
  });
  check_fails("one circle", [&](Output&, Lines& l) {   // two vertices that have no neighbour in common become one
    std::vector<std::size_t> near(1, 1);
    for (int ring = 0; ring < 3; ++ring) {
      std::vector<std::size_t> more = near;
      for (const auto& quad : m.quads)
        if (std::any_of(quad.begin(), quad.end(), [&](std::size_t v) {
              return std::count(near.begin(), near.end(), v + 1) > 0;
            }))
          for (std::size_t v : quad) more.push_back(v + 1);
      near = more;
    }
    std::size_t far = 1;
    while (std::count(near.begin(), near.end(), far) > 0) ++far;
    rename(l, [&](std::size_t v) { return v == far ? 1 : v; });
  });
  check_fails("quads.obj: Euler characteristic", [](Output& o, Lines&) { o.report["input"]["genus"] = 17; });
  check_fails("quads.obj: Euler characteristic", [](Output&, Lines& l) { l.insert(l.begin(), "v 0 0 0"); });
  check_fails("irregular vertices are exactly", [](Output& o, Lines&) { o.report["singularities"].erase(0); });
  check_fails("irregular vertices are exactly", [](Output&, Lines& l) { l.push_back("v 0 0 0"); });   // it has no quad
  check_fails("vertices, as in the report", [](Output&, Lines& l) { l.push_back("v 0 0 0"); });
  for (const char* key : {"quads", "vertices"})
    check_fails("vertices, as in the report", [&](Output& o, Lines&) {
      o.report["quad_mesh"][key] = o.report["quad_mesh"][key].get<int>() + 1;
    });

  check_fails("groups are patches", [](Output&, Lines& l) { line(l, "g ", 2) = "g patch_99999"; });
  check_fails("patches have quads, as many", [](Output&, Lines& l) { line(l, "g ", 2) = line(l, "g ", 1); });
  check_fails("are a regular grid", [&](Output&, Lines& l) {   // the last quad of a patch goes to the next
    const auto next = std::find_if(two_of_a_patch(l), l.end(), [](const std::string& s) { return is_kind(s, "g "); });
    std::iter_swap(next, next - 1);
  });
  check_fails("are a regular grid", [&](Output&, Lines& l) {   // two quads in the wrong order
    const auto first = two_of_a_patch(l);
    std::iter_swap(first, first + 1);
  });
  for (const char* name : {"g", "g ", "g patch_", "g patch_-1", "g patch_ 1", "g patch_1x", "g patch_12345678901",
                           "g patch_18446744073709551616", "g 1", "o x"})
    check_fails("quads.obj: a ", [&](Output&, Lines& l) { line(l, "g ", 2) = name; });
  check_fails("a quad is not in a group", [](Output&, Lines& l) { line(l, "g ", 0).clear(); });
  check_fails("neither a vertex, nor a group, nor a quad", [](Output&, Lines& l) { l.push_back("l 1 2"); });

  check_fails("vertices lie on the input", [](Output&, Lines& l) { line(l, "v ", 5) = "v 100 0 0"; });
  check_fails("vertices lie on the input", [&](Output&, Lines& l) {   // by a hundred millionth of its size
    const Point_3& p = m.points[5];
    std::ostringstream moved;
    moved.precision(17);
    moved << "v " << p.x() * (1 + 1e-7) << ' ' << p.y() * (1 + 1e-7) << ' ' << p.z() * (1 + 1e-7);
    line(l, "v ", 5) = moved.str();
  });
  check_fails("a coordinate is not a finite number", [](Output&, Lines& l) { line(l, "v ", 5) = "v 0 nan 0"; });
  check_fails("a coordinate is not a finite number", [](Output&, Lines& l) { line(l, "v ", 5) = "v 0 0"; });
  check_fails("three coordinates", [](Output&, Lines& l) { line(l, "v ", 5) += " 0"; });
  check_fails("least scaled Jacobian", [](Output&, Lines& l) { std::swap(line(l, "v ", 5), line(l, "v ", 100)); });
  check_fails("least scaled Jacobian", [](Output& o, Lines&) {
    auto& least = o.report["quad_mesh"]["scaled_jacobian"]["min"];
    least = least.get<double>() + 1e-11;
  });
  check_fails("the report says that there are quads", [](Output& o, Lines&) { o.report.erase("quad_mesh"); });
  check_fails("report.json: \"quads\" is missing", [](Output& o, Lines&) { o.report["quad_mesh"] = nullptr; });
  check_fails("min is not a number", [](Output& o, Lines&) {
    o.report["quad_mesh"]["scaled_jacobian"]["min"] = nullptr;
  });
  check_fails("quad_mesh.quads is out of range", [](Output& o, Lines&) { o.report["quad_mesh"]["quads"] = -1; });

  valid.verified();
  const std::string text = quads.str();
  std::mt19937 random(3);
  std::string noise(10000, ' ');
  for (char& c : noise) c = static_cast<char>(random());
  for (const std::string& bad : {std::string(), noise, text + noise, text.substr(0, text.size() / 2),
                                 text.substr(0, text.size() - 1), text + std::string(3, '\0') + "\n"}) {
    Output::write("quads.obj", bad);
    CHECK(fails_with(verify_outputs(Output::folder(), &input), "quads.obj: "));
  }
  for (int i = 0; i < 200; ++i) {   // one byte at a time: no crash, whatever the verdict
    std::string bad = text;
    bad[random() % bad.size()] = "0123456789 \nvfg-.e"[random() % 18];
    Output::write("quads.obj", bad);
    CHECK(!verify_outputs(Output::folder()).empty());
  }
  for (const char* name : {"quads.obj", "flat.obj"}) std::filesystem::remove(Output::folder() + "/" + name);
}

} // namespace

int main()
{
  valid_outputs_pass();
  flat_torus_needs_no_tmesh();
  spoilt_outputs_fail();
  malformed_files_fail();
  random_bytes_do_no_harm();
  obj_is_exact();
  flat_obj_is_checked();
  quads_obj_is_checked();
  std::filesystem::remove_all(Output::folder());
  return Quartic_test::result();
}
