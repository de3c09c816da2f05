// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// splines.xml, .json and .vtu of closed surfaces of random patches, and tmesh.tsp of surfaces through the pipeline,
// read back: numbers are the same, neighbours agree by what the files say alone, and damage to a file is noticed.

#include "check.h"
#include "run_pipeline.h"

#include <CGAL/Quartic_differentials/IO/write_multipatch.h>
#include <CGAL/Quartic_differentials/IO/write_t_mesh.h>
#include <CGAL/Quartic_differentials/IO/write_t_spline.h>
#include <CGAL/Quartic_differentials/sample_surfaces.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

const double tolerance = 1e-12;   // all coordinates are less than 1

// Surfaces: patches with random control points, equal where the sides of an interface meet

std::size_t control_points_on_side(const Multipatch::Patch& patch, int side)
{
  return patch.spans[static_cast<std::size_t>(side % 2)] + 3;
}

/// number of the control point k along a side
std::size_t index_on_side(const Multipatch::Patch& patch, int side, std::size_t k)
{
  const std::size_t w = patch.spans[0] + 3, h = patch.spans[1] + 3;
  switch (side) {
    case 0:  return k;
    case 1:  return k * w + w - 1;
    case 2:  return (h - 1) * w + w - 1 - k;
    default: return (h - 1 - k) * w;
  }
}

/// sets control points, the same for those that interfaces join, and numbers of quads
void fill(Multipatch& m, std::mt19937& random)
{
  std::vector<std::size_t> first{0};
  for (const Multipatch::Patch& p : m.patches) first.push_back(first.back() + (p.spans[0] + 3) * (p.spans[1] + 3));
  std::vector<std::size_t> joined(first.back());
  std::iota(joined.begin(), joined.end(), 0);
  const auto root = [&](std::size_t k) {
    while (joined[k] != k) k = joined[k];
    return k;
  };
  for (const Multipatch::Interface& i : m.interfaces) {
    const Multipatch::Patch &p = m.patches[i.first.patch], &q = m.patches[i.second.patch];
    const std::size_t n = control_points_on_side(p, i.first.side);
    for (std::size_t k = 0; k < n; ++k)
      joined[root(first[i.first.patch] + index_on_side(p, i.first.side, k))] =
        root(first[i.second.patch] + index_on_side(q, i.second.side, n - 1 - k));
  }
  std::vector<Point_3> points;
  const auto coordinate = [&] { return random() / 4294967296.0; };
  for (std::size_t k = 0; k < joined.size(); ++k) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  std::size_t quads = 0;
  for (std::size_t p = 0; p < m.patches.size(); ++p) {
    for (std::size_t k = first[p]; k < first[p + 1]; ++k) m.patches[p].control_points.push_back(points[root(k)]);
    m.patches[p].quads.resize(m.patches[p].spans[0] * m.patches[p].spans[1]);
    std::iota(m.patches[p].quads.begin(), m.patches[p].quads.end(), quads);
    std::shuffle(m.patches[p].quads.begin(), m.patches[p].quads.end(), random);
    quads += m.patches[p].quads.size();
  }
}

/// the faces of a box of any numbers of quads; every patch begins at any of its corners
Multipatch box(std::mt19937& random)
{
  // corners counterclockwise from outside; bit k of a corner is its coordinate k
  static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::array<std::size_t, 3> size;
  for (std::size_t& n : size) n = 1 + random() % 4;
  const auto quads_along = [&](int a, int b) { return (a ^ b) == 1 ? size[0] : (a ^ b) == 2 ? size[1] : size[2]; };
  Multipatch m;
  std::map<std::pair<int, int>, Multipatch::Side> sides;   // by corners from and to
  for (std::size_t p = 0; p < 6; ++p) {
    const unsigned begin = random() % 4;
    const auto corner = [&](int k) { return faces[p][(begin + k) % 4]; };
    m.patches.push_back({{quads_along(corner(0), corner(1)), quads_along(corner(1), corner(2))}, {}, {}});
    for (int side = 0; side < 4; ++side) sides[{corner(side), corner(side + 1)}] = {p, side};
  }
  for (const auto& [corners, side] : sides) {
    const Multipatch::Side opposite = sides.at({corners.second, corners.first});
    if (corners.first < corners.second)
      m.interfaces.push_back(random() % 2 == 0 ? Multipatch::Interface{side, opposite}
                                               : Multipatch::Interface{opposite, side});
  }
  fill(m, random);
  return m;
}

/// a patch of 4 x 3 quads glued to itself
Multipatch torus_of_one_patch(std::mt19937& random)
{
  Multipatch m;
  m.patches.push_back({{4, 3}, {}, {}});
  m.interfaces = {{{0, 0}, {0, 2}}, {{0, 3}, {0, 1}}};
  fill(m, random);
  return m;
}

// What the readers make of a file

struct Spline
{
  std::array<int, 2>                 degree;
  std::array<std::vector<double>, 2> knots;
  std::vector<Point_3>               coefficients;   // direction 0 runs faster
};

struct Seam
{
  std::array<std::size_t, 2> patch;
  std::array<int, 2>         constant;      // the direction that does not vary, by side
  std::array<bool, 2>        at_end;        // whether its parameter is at its end, by side
  bool                       same_way;      // whether the other parameters run the same way
};

struct File
{
  std::vector<Spline> patches;
  std::vector<Seam>   seams;
};

Point_3 between(const Point_3& p, const Point_3& q, double t)
{
  return Point_3((1 - t) * p.x() + t * q.x(), (1 - t) * p.y() + t * q.y(), (1 - t) * p.z() + t * q.z());
}

double distance(const Point_3& p, const Point_3& q) { return std::sqrt((p - q).squared_length()); }

/// de Boor's algorithm, for any knots
Point_3 curve_point(const std::vector<double>& knots, int degree, const std::vector<Point_3>& coefficients, double t)
{
  std::size_t span = static_cast<std::size_t>(degree);
  while (span + 1 < coefficients.size() && knots[span + 1] <= t) ++span;
  std::vector<Point_3> d(coefficients.begin() + span - degree, coefficients.begin() + span + 1);
  for (int r = 1; r <= degree; ++r)
    for (int j = degree; j >= r; --j) {
      const double from = knots[span - degree + j], to = knots[span + 1 + j - r];
      d[j] = between(d[j - 1], d[j], (t - from) / (to - from));
    }
  return d.back();
}

Point_3 surface_point(const Spline& s, const std::array<double, 2>& t)
{
  const std::size_t width = s.knots[0].size() - s.degree[0] - 1;
  std::vector<Point_3> along;
  for (auto row = s.coefficients.begin(); row != s.coefficients.end(); row += width)
    along.push_back(curve_point(s.knots[0], s.degree[0], {row, row + width}, t[0]));
  return curve_point(s.knots[1], s.degree[1], along, t[1]);
}

/// the largest distance between points of two sides that a seam joins
double gap(const File& file)
{
  double result = 0;
  const int samples = 64;
  for (const Seam& seam : file.seams)
    for (int k = 0; k <= samples; ++k) {
      std::array<Point_3, 2> point;
      for (std::size_t s = 0; s < 2; ++s) {
        const Spline& spline = file.patches.at(seam.patch[s]);
        const int across = seam.constant[s], along = 1 - across;
        const double fraction = (s == 0 || seam.same_way ? k : samples - k) / double(samples);
        std::array<double, 2> t;
        t[across] = seam.at_end[s] ? spline.knots[across].back() : spline.knots[across][0];
        t[along] = spline.knots[along][0] + fraction * (spline.knots[along].back() - spline.knots[along][0]);
        point[s] = surface_point(spline, t);
      }
      result = std::max(result, distance(point[0], point[1]));
    }
  return result;
}

/// every side of every patch is that of one seam
bool is_closed(const File& file)
{
  std::set<std::array<std::size_t, 3>> sides;
  for (const Seam& seam : file.seams)
    for (std::size_t s = 0; s < 2; ++s)
      sides.insert({seam.patch[s], std::size_t(seam.constant[s]), std::size_t(seam.at_end[s])});
  return sides.size() == 4 * file.patches.size() && 2 * file.seams.size() == sides.size();
}

bool is_sound(const File& file) { return is_closed(file) && gap(file) <= tolerance; }

void check_same(const File& file, const Multipatch& m)
{
  static const std::array<int, 4>  constant{1, 0, 1, 0};
  static const std::array<bool, 4> at_end{false, true, true, false};
  CHECK_EQUAL(file.patches.size(), m.patches.size());
  for (std::size_t p = 0; p < m.patches.size(); ++p) {
    const Spline& s = file.patches[p];
    CHECK(s.coefficients == m.patches[p].control_points);
    for (std::size_t d = 0; d < 2; ++d) {
      std::vector<double> knots(3, 0);
      for (std::size_t k = 0; k <= m.patches[p].spans[d]; ++k) knots.push_back(double(k));
      knots.insert(knots.end(), 3, double(m.patches[p].spans[d]));
      CHECK(s.knots[d] == knots);
      CHECK_EQUAL(s.degree[d], 3);
    }
  }
  CHECK_EQUAL(file.seams.size(), m.interfaces.size());
  for (std::size_t i = 0; i < m.interfaces.size(); ++i) {
    const std::array<Multipatch::Side, 2> sides{m.interfaces[i].first, m.interfaces[i].second};
    for (std::size_t s = 0; s < 2; ++s) {
      CHECK_EQUAL(file.seams[i].patch[s], sides[s].patch);
      CHECK_EQUAL(file.seams[i].constant[s], constant[sides[s].side]);
      CHECK_EQUAL(file.seams[i].at_end[s], at_end[sides[s].side]);
    }
  }
}

// Readers

template <class Number>
std::vector<Number> numbers(const std::string& text)
{
  std::istringstream in(text);
  std::vector<Number> result;
  for (std::string word; in >> word;) {
    if constexpr (std::is_integral<Number>::value) result.push_back(static_cast<Number>(std::stoll(word)));
    else result.push_back(std::stod(word));
  }
  return result;
}

std::vector<Point_3> points(const std::string& text)
{
  const std::vector<double> x = numbers<double>(text);
  std::vector<Point_3> result;
  for (std::size_t k = 0; k + 2 < x.size(); k += 3) result.emplace_back(x[k], x[k + 1], x[k + 2]);
  return result;
}

boost::property_tree::ptree parsed_xml(const std::string& text)
{
  std::istringstream in(text);
  boost::property_tree::ptree tree;
  read_xml(in, tree);
  return tree;
}

/// By G+Smo's rules: patches by id in a range; an interface is patch, side, patch, side, direction map, orientations;
/// of side n the direction (n - 1) / 2 is constant, at its end if n is even.
File read_gismo(const std::string& text)
{
  const boost::property_tree::ptree root = parsed_xml(text).get_child("xml");
  std::map<int, const boost::property_tree::ptree*> geometries;
  for (const auto& [tag, node] : root)
    if (tag == "Geometry" && node.get<std::string>("<xmlattr>.type") == "TensorBSpline2")
      geometries[node.get<int>("<xmlattr>.id")] = &node;
  const boost::property_tree::ptree& multipatch = root.get_child("MultiPatch");
  CHECK_EQUAL(multipatch.get<int>("<xmlattr>.parDim"), 2);
  CHECK_EQUAL(multipatch.get<std::string>("patches.<xmlattr>.type"), "id_range");
  CHECK(multipatch.count("boundary") == 0);
  const std::vector<int> range = numbers<int>(multipatch.get<std::string>("patches"));
  File result;
  for (int id = range.at(0); id <= range.at(1); ++id) {
    const boost::property_tree::ptree& geometry = *geometries.at(id);
    CHECK_EQUAL(geometry.get<int>("coefs.<xmlattr>.geoDim"), 3);
    Spline spline;
    spline.coefficients = points(geometry.get<std::string>("coefs"));
    std::size_t d = 0;
    for (const auto& [tag, basis] : geometry.get_child("Basis"))
      if (tag == "Basis") {
        CHECK_EQUAL(basis.get<std::size_t>("<xmlattr>.index"), d);
        spline.degree.at(d) = basis.get<int>("KnotVector.<xmlattr>.degree");
        spline.knots.at(d++) = numbers<double>(basis.get<std::string>("KnotVector"));
      }
    result.patches.push_back(std::move(spline));
  }
  const std::vector<int> n = numbers<int>(multipatch.get<std::string>("interfaces"));
  for (std::size_t k = 0; k < n.size(); k += 8) {
    Seam seam{{std::size_t(n[k] - range[0]), std::size_t(n[k + 2] - range[0])},
              {(n[k + 1] - 1) / 2, (n[k + 3] - 1) / 2}, {n[k + 1] % 2 == 0, n[k + 3] % 2 == 0}, false};
    const int across = seam.constant[0], along = 1 - across;
    CHECK_EQUAL(n[k + 4 + across], seam.constant[1]);
    CHECK_EQUAL(n[k + 4 + along], 1 - seam.constant[1]);
    CHECK_EQUAL(n[k + 6 + across], int(seam.at_end[0] == seam.at_end[1]));
    seam.same_way = n[k + 6 + along] == 1;
    result.seams.push_back(seam);
  }
  return result;
}

File read_json(const std::string& text, std::vector<std::vector<std::size_t>>& quads)
{
  const nlohmann::json json = nlohmann::json::parse(text);
  File result;
  for (const nlohmann::json& patch : json["patches"]) {
    Spline spline;
    spline.degree.fill(json["degree"].get<int>());
    for (std::size_t d = 0; d < 2; ++d) {
      spline.knots[d] = patch["knots"][d].get<std::vector<double>>();
      CHECK_EQUAL(spline.knots[d].size(), patch["spans"][d].get<std::size_t>() + 2 * spline.degree[d] + 1);
    }
    for (const nlohmann::json& p : patch["control_points"]) spline.coefficients.emplace_back(p[0], p[1], p[2]);
    result.patches.push_back(std::move(spline));
    quads.push_back(patch["quads"].get<std::vector<std::size_t>>());
  }
  for (const nlohmann::json& i : json["interfaces"]) {
    Seam seam;
    for (std::size_t s = 0; s < 2; ++s) {
      const int side = i["sides"][s];
      seam.patch[s] = i["patches"][s];
      seam.constant[s] = 1 - side % 2;
      seam.at_end[s] = side == 1 || side == 2;
    }
    seam.same_way = !i["reversed"].get<bool>();
    result.seams.push_back(seam);
  }
  return result;
}

struct Bezier_cells
{
  std::vector<Point_3>     points;
  std::vector<std::size_t> corners, offsets, types, patch, quad;
};

Bezier_cells read_vtu(const std::string& text)
{
  const boost::property_tree::ptree piece = parsed_xml(text).get_child("VTKFile.UnstructuredGrid.Piece");
  std::map<std::string, std::vector<std::size_t>> arrays;
  for (const char* part : {"Cells", "CellData"})
    for (const auto& [tag, node] : piece.get_child(part))
      if (tag == "DataArray") arrays[node.get<std::string>("<xmlattr>.Name")] = numbers<std::size_t>(node.data());
  Bezier_cells result{points(piece.get<std::string>("Points.DataArray")), arrays.at("connectivity"),
                      arrays.at("offsets"), arrays.at("types"), arrays.at("patch"), arrays.at("quad")};
  CHECK_EQUAL(result.points.size(), piece.get<std::size_t>("<xmlattr>.NumberOfPoints"));
  CHECK_EQUAL(result.types.size(), piece.get<std::size_t>("<xmlattr>.NumberOfCells"));
  return result;
}

// Bezier cells

Point_3 bezier_point(std::array<Point_3, 4> p, double t)
{
  for (int r = 3; r > 0; --r)
    for (int j = 0; j < r; ++j) p[j] = between(p[j], p[j + 1], t);
  return p[0];
}

/// the point of a cell whose points are in VTK's order: corners, edges bottom, right, top, left, interior
Point_3 bezier_point(const Bezier_cells& cells, std::size_t cell, double s, double t)
{
  static const int number[4][4] = {{0, 4, 5, 1}, {10, 12, 13, 6}, {11, 14, 15, 7}, {3, 8, 9, 2}};   // by row and column
  std::array<Point_3, 4> column;
  for (int j = 0; j < 4; ++j) {
    std::array<Point_3, 4> row;
    for (int i = 0; i < 4; ++i) row[i] = cells.points.at(cells.corners[16 * cell + number[j][i]]);
    column[j] = bezier_point(row, s);
  }
  return bezier_point(column, t);
}

/// the largest distance between the cells and the splines
double distance(const Bezier_cells& cells, const File& file, const Multipatch& m)
{
  double result = 0;
  for (std::size_t c = 0; c < cells.types.size(); ++c) {
    const Multipatch::Patch& patch = m.patches.at(cells.patch[c]);
    const std::size_t k = std::find(patch.quads.begin(), patch.quads.end(), cells.quad[c]) - patch.quads.begin();
    const double i = double(k % patch.spans[0]), j = double(k / patch.spans[0]);
    for (double s = 0; s <= 1; s += 0.125)
      for (double t = 0; t <= 1; t += 0.125)
        result = std::max(result, distance(bezier_point(cells, c, s, t),
                                           surface_point(file.patches.at(cells.patch[c]), {i + s, j + t})));
  }
  return result;
}

std::size_t number_of_distinct(const std::vector<Point_3>& points)
{
  std::set<std::array<double, 3>> distinct;
  for (const Point_3& p : points) distinct.insert({p.x(), p.y(), p.z()});
  return distinct.size();
}

/// inside patches and interfaces, and at corners
std::size_t number_of_bezier_points(const Multipatch& m)
{
  std::size_t result = 0;
  std::vector<Point_3> corners;
  for (const Multipatch::Patch& p : m.patches) {
    result += (3 * p.spans[0] - 1) * (3 * p.spans[1] - 1);
    for (int side = 0; side < 4; ++side) corners.push_back(p.control_points[index_on_side(p, side, 0)]);
  }
  for (const Multipatch::Interface& i : m.interfaces)
    result += 3 * m.patches[i.first.patch].spans[static_cast<std::size_t>(i.first.side % 2)] - 1;
  return result + number_of_distinct(corners);
}

// Damage

/// the text with `inserted` behind the first `key`
std::string with_inserted(std::string text, const std::string& key, const std::string& inserted)
{
  return text.insert(text.find(key) + key.size(), inserted);
}

std::string with_replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

/// the file, with the orientation along the first interface turned round
std::string turned_round(const std::string& xml)
{
  const std::size_t begin = xml.find("<interfaces>\n") + 13, end = xml.find('\n', begin);
  std::vector<int> n = numbers<int>(xml.substr(begin, end - begin));
  const int along = 1 - (n[1] - 1) / 2;
  n[6 + along] = 1 - n[6 + along];
  std::string line;
  for (int x : n) line += std::to_string(x) + ' ';
  return xml.substr(0, begin) + line + xml.substr(end);
}

// Checks

template <class Write, class... More>
std::string written(Write write, const More&... what)
{
  std::ostringstream out;
  write(out, what...);
  return out.str();
}

void check_gismo(const Multipatch& m)
{
  const std::string text = written(write_multipatch_xml, m);
  const File file = read_gismo(text);
  check_same(file, m);
  CHECK(is_sound(file));
  CHECK(!is_sound(read_gismo(with_inserted(text, "<coefs geoDim=\"3\">\n", "7"))));
  CHECK(!is_sound(read_gismo(turned_round(text))));
}

void check_json(const Multipatch& m)
{
  const std::string text = written(write_multipatch_json, m);
  std::vector<std::vector<std::size_t>> quads, ignored;
  const File file = read_json(text, quads);
  check_same(file, m);
  CHECK(is_sound(file));
  for (std::size_t p = 0; p < m.patches.size(); ++p) CHECK(quads[p] == m.patches[p].quads);
  CHECK(!is_sound(read_json(with_inserted(text, "\"control_points\":[\n[", "7"), ignored)));
  const bool reversed = text.find("true") < text.find("false");
  CHECK(!is_sound(read_json(with_replaced(text, reversed ? "true" : "false", reversed ? "false" : "true"), ignored)));
}

void check_vtu(const Multipatch& m)
{
  const std::string text = written(write_multipatch_vtu, m);
  const Bezier_cells cells = read_vtu(text);
  std::vector<std::size_t> patch, quad;
  for (std::size_t p = 0; p < m.patches.size(); ++p) {
    patch.insert(patch.end(), m.patches[p].quads.size(), p);
    quad.insert(quad.end(), m.patches[p].quads.begin(), m.patches[p].quads.end());
  }
  CHECK(cells.patch == patch);
  CHECK(cells.quad == quad);
  CHECK(cells.types == std::vector<std::size_t>(quad.size(), 77));
  CHECK_EQUAL(cells.corners.size(), 16 * quad.size());
  for (std::size_t c = 0; c < cells.offsets.size(); ++c) CHECK_EQUAL(cells.offsets[c], 16 * (c + 1));
  CHECK_EQUAL(number_of_distinct(cells.points), number_of_bezier_points(m));   // the same on both sides of interfaces
  const File file = read_gismo(written(write_multipatch_xml, m));
  CHECK(distance(cells, file, m) <= tolerance);
  const Bezier_cells damaged = read_vtu(with_inserted(text, "NumberOfComponents=\"3\" format=\"ascii\">\n", "7"));
  CHECK(distance(damaged, file, m) > tolerance);
}

void spline_surfaces()
{
  std::mt19937 random(5);
  std::set<std::pair<int, int>> pairs;
  for (int k = 0; k < 20; ++k) {
    const Multipatch m = k == 0 ? torus_of_one_patch(random) : box(random);
    for (const Multipatch::Interface& i : m.interfaces) pairs.emplace(i.first.side, i.second.side);
    check_gismo(m);
    check_json(m);
    check_vtu(m);
  }
  CHECK_EQUAL(pairs.size(), 16u);   // any side has been glued to any side
}

// T-splines

struct T_spline
{
  struct Vertex { std::size_t id; Point_3 place; int valence; std::string kind; };
  struct Edge { std::size_t id, from, to; std::int64_t interval; };
  using Side = std::vector<std::pair<std::size_t, int>>;   // edges and ways
  struct Face { std::size_t id; std::int64_t width, height; std::vector<Side> sides; };

  int                 unit = 0;
  std::vector<long>   counts;
  std::vector<Vertex> vertices;
  std::vector<Edge>   edges;
  std::vector<Face>   faces;
};

T_spline read_t_spline(const std::string& text)
{
  T_spline result;
  std::istringstream file(text);
  for (std::string line, key; std::getline(file, line);) {
    std::istringstream in(line);
    in >> key;
    if (key == "unit") in >> result.unit;
    else if (key == "counts") {
      result.counts.resize(3);
      for (long& n : result.counts) in >> n;
    }
    else if (key == "v") {
      T_spline::Vertex v;
      std::string x, y, z;
      in >> v.id >> x >> y >> z >> v.valence >> v.kind;
      v.place = Point_3(std::stod(x), std::stod(y), std::stod(z));
      result.vertices.push_back(v);
    }
    else if (key == "e") {
      T_spline::Edge e;
      in >> e.id >> e.from >> e.to >> e.interval;
      result.edges.push_back(e);
    }
    else if (key == "f") {
      T_spline::Face f;
      in >> f.id >> f.width >> f.height;
      result.faces.push_back(f);
    }
    else if (key == "s") {
      T_spline::Side side;
      std::size_t edge;
      for (int way; in >> edge >> way;) side.emplace_back(edge, way);
      result.faces.back().sides.push_back(side);
    }
    else CHECK_EQUAL(line.substr(0, 1), "#");
  }
  return result;
}

/// why it is not a closed surface where edges are used once in either way, faces close and opposite sides are equal; ""
/// if it is
std::string fault(const T_spline& t, long euler_characteristic)
{
  const long v = t.vertices.size(), e = t.edges.size(), f = t.faces.size();
  if (t.counts != std::vector<long>{v, e, f}) return "counts";
  if (v - e + f != euler_characteristic) return "Euler characteristic";
  std::vector<int> valence(t.vertices.size(), 0);
  for (const T_spline::Edge& e : t.edges) {
    ++valence.at(e.from);
    ++valence.at(e.to);
    if (e.interval <= 0) return "knot interval";
  }
  for (std::size_t v = 0; v < t.vertices.size(); ++v) {
    const std::string& kind = t.vertices[v].kind;
    const int expected = kind == "meeting" ? 2 : kind == "t_junction" ? 3 : kind == "crossing" ? 4 : valence[v];
    if (t.vertices[v].valence != valence[v] || valence[v] != expected) return "valence";
  }
  std::set<std::pair<std::size_t, int>> used;
  for (const T_spline::Face& f : t.faces)
    for (const auto& side : f.sides)
      for (const auto& use : side)
        if (!used.insert(use).second) return "use of edges";
  if (used.size() != 2 * t.edges.size()) return "use of edges";
  for (const T_spline::Face& f : t.faces) {
    if (f.sides.size() != 4) return "sides";
    std::vector<std::size_t> from, to;
    std::array<std::int64_t, 4> sum{};
    for (std::size_t s = 0; s < 4; ++s)
      for (const auto& [edge, way] : f.sides[s]) {
        const T_spline::Edge& e = t.edges.at(edge);
        from.push_back(way == 1 ? e.from : e.to);
        to.push_back(way == 1 ? e.to : e.from);
        sum[s] += e.interval;
      }
    std::rotate(from.begin(), from.begin() + 1, from.end());
    if (from != to) return "open face";
    if (sum != std::array<std::int64_t, 4>{f.width, f.height, f.width, f.height}) return "opposite sides";
  }
  return "";
}

void check_same(const T_spline& file, const T_mesh& t, const Quartic_differential& q)
{
  const nlohmann::json json = nlohmann::json::parse(written(write_t_mesh_json, t, q, std::string("input")));
  CHECK_EQUAL(file.unit, t.grid_exponent);
  CHECK_EQUAL(file.vertices.size(), t.nodes.size());
  for (std::size_t n = 0; n < t.nodes.size(); ++n) {
    const nlohmann::json &node = json["nodes"][n], &p = node["position"];
    CHECK_EQUAL(file.vertices[n].id, n);
    CHECK_EQUAL(file.vertices[n].kind, node["kind"].get<std::string>());
    CHECK(file.vertices[n].place == Point_3(p[0], p[1], p[2]));
    if (!t.nodes[n].is_singularity()) continue;
    CHECK(file.vertices[n].place == q.triangulation.mesh().point(t.nodes[n].vertex));
    CHECK_EQUAL(file.vertices[n].valence, t.nodes[n].order + 4);
  }
  CHECK_EQUAL(file.edges.size(), t.arcs.size());
  for (std::size_t a = 0; a < t.arcs.size(); ++a) {
    CHECK_EQUAL(file.edges[a].id, a);
    CHECK_EQUAL(file.edges[a].from, t.arcs[a].from);
    CHECK_EQUAL(file.edges[a].to, t.arcs[a].to);
    CHECK_EQUAL(file.edges[a].interval, t.arcs[a].length);
  }
  CHECK_EQUAL(file.faces.size(), t.patches.size());
  for (std::size_t p = 0; p < t.patches.size(); ++p) {
    CHECK_EQUAL(file.faces[p].id, p);
    CHECK_EQUAL(file.faces[p].sides.size(), 4u);
    for (std::size_t s = 0; s < 4; ++s) {
      T_spline::Side side;
      for (const T_mesh::Side_piece& piece : t.patches[p].sides[s])
        side.emplace_back(piece.arc, piece.forward ? 1 : -1);
      CHECK(file.faces[p].sides[s] == side);
    }
  }
}

void check_t_spline(const Mesh& mesh, int genus)
{
  const Quartic_differential_result r = run_pipeline(Intrinsic_triangulation(mesh));
  const std::string text = written(write_t_spline, *r.t_mesh, r.traced());
  const T_spline file = read_t_spline(text);
  const long euler_characteristic = 2 - 2 * genus;
  check_same(file, *r.t_mesh, r.traced());
  CHECK_EQUAL(fault(file, euler_characteristic), "");

  const auto damaged = [&](const std::string& from, const std::string& to) {
    return fault(read_t_spline(with_replaced(text, from, to)), euler_characteristic);
  };
  const T_spline::Edge& e = file.edges[0];
  const std::string ends = "\ne 0 " + std::to_string(e.from) + ' ' + std::to_string(e.to) + ' ';
  CHECK_EQUAL(damaged(ends + std::to_string(e.interval), ends + std::to_string(e.interval + 1)), "opposite sides");
  CHECK_EQUAL(damaged(" -1\n", " 1\n"), "use of edges");
  CHECK_EQUAL(damaged(" t_junction\n", " crossing\n"), "valence");
  CHECK_EQUAL(damaged("\ncounts ", "\ncounts 1"), "counts");
  CHECK_EQUAL(fault(file, euler_characteristic - 2), "Euler characteristic");
  T_spline turned = file;
  for (T_spline::Edge& edge : turned.edges) std::swap(edge.from, edge.to);
  CHECK_EQUAL(fault(turned, euler_characteristic), "open face");
}

void t_splines()
{
  check_t_spline(bumpy_sphere(2), 0);
  check_t_spline(torus(2, 1, 24, 12), 1);
  check_t_spline(handle_chain(2, 6), 2);
}

void t_spline_without_positions()
{
  const Quartic_differential_result r = run_pipeline(Intrinsic_triangulation(l_of_three_squares(2)));
  CHECK_THROWS(written(write_t_spline, *r.t_mesh, r.traced()), Unusable_surface_error, "tmesh.tsp needs positions");
}

} // namespace

int main()
{
  spline_surfaces();
  t_splines();
  t_spline_without_positions();
  return result();
}
