// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files as they go wrong, given to the program in every format that can hold them. What is harmless is read; the rest
// ends with exit status 2 and one sentence, in less than a second of computing, and nothing is left behind.

#include "check.h"
#include "run_program.h"
#include "surface_files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <string>

#include <sys/stat.h>

namespace fs = std::filesystem;

using namespace Quartic_test;

namespace {

const Program_folder folder;

void write(const std::string& name, const std::string& contents)
{
  std::ofstream(folder / name, std::ios::binary) << contents;
}

// ---- The two outcomes

void check_read(const std::string& kind, const std::string& file, int genus)
{
  const Outcome o = folder.quartic("info --json -q --no-loops " + file);
  if (o.status != 0) std::cerr << kind << ", " << file << ": status " << o.status << ", " << o.err << std::endl;
  CHECK_EQUAL(o.status, 0);
  if (o.status == 0) CHECK(nlohmann::json::parse(o.out)["input"]["genus"] == genus);
}

bool is_one_sentence(const std::string& text)
{
  return text.rfind("quartic: ", 0) == 0 && text.size() > 20 && text.size() < 600 && text.back() == '\n'
      && std::none_of(text.begin(), text.end() - 1, [](unsigned char c) { return c < ' ' || c == 127; });
}

#ifdef QUARTIC_SANITIZE
const double most_seconds = 10;
#else
const double most_seconds = 1;
#endif

// \param may_be_read whether the file may also be that of a small surface with boundary, on which there is no room for
//        singularities: then there is a report
void check_refused(const std::string& kind, const std::string& file, bool may_be_read = false)
{
  const std::set<std::string> before = folder.names();
  const Outcome o = folder.quartic("run " + file + " -o results -q");
  const bool leaves_nothing = folder.names() == before || (may_be_read && contains(o.err, "has no room for"));
  const bool good = leaves_nothing && o.status == 2 && is_one_sentence(o.err) && o.out.empty() && o.cpu_seconds < most_seconds;
  if (!good)
    std::cerr << kind << ", " << file << ": status " << o.status << ", " << o.cpu_seconds << " s, " << o.err.substr(0, 500)
              << (leaves_nothing ? "" : ", leaves files behind") << std::endl;
  CHECK(good);
}

void read_as(const std::string& format, const std::string& kind, const std::string& contents, int genus = 0)
{
  write("surface." + format, contents);
  check_read(kind, "surface." + format, genus);
}

void refused_as(const std::string& format, const std::string& kind, const std::string& contents, bool may_be_read = false)
{
  write("surface." + format, contents);
  check_refused(kind, "surface." + format, may_be_read);
}

// ---- Surfaces that are no surfaces, in all formats

const Soup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
const Soup cube{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

// both surfaces, the second moved along x
Soup together(Soup s, const Soup& other, double shift)
{
  const int n = static_cast<int>(s.points.size());
  for (auto p : other.points) s.points.push_back({p[0] + shift, p[1], p[2]});
  for (auto f : other.faces) {
    for (int& v : f) v += n;
    s.faces.push_back(f);
  }
  return s;
}

Soup scaled(Soup s, double factor)
{
  for (auto& p : s.points)
    for (double& x : p) x *= factor;
  return s;
}

template <class Change>
Soup changed(Soup s, Change change)
{
  change(s);
  return s;
}

// a strip of n quads round an axis, turned by half a turn: one-sided, with one boundary
Soup moebius_strip(int n)
{
  Soup s;
  for (int i = 0; i < n; ++i)
    for (double w : {-0.3, 0.3}) {
      const double a = 2 * std::acos(-1.0) * i / n;
      s.points.push_back({(1 + w * std::cos(a / 2)) * std::cos(a), (1 + w * std::cos(a / 2)) * std::sin(a), w * std::sin(a / 2)});
    }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    s.faces.push_back({a, c, b});
    s.faces.push_back({b, c, d});
  }
  return s;
}

// six vertices, every two of them joined: the projective plane, closed and one-sided
const Soup projective_plane{{{0, 0, 1}, {1, 0, 0}, {0.3, 1, 0}, {-0.8, 0.6, 0}, {-0.8, -0.6, 0.1}, {0.3, -1, 0}},
  {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}}};

void check_broken_surfaces()
{
  const double huge = 1e300, tiny = 1e-300, no_number = std::nan(""), infinite = HUGE_VAL;
  const std::vector<std::pair<std::string, Soup>> kinds{
    {"no face", changed(tetrahedron, [](Soup& s) { s.faces.clear(); })},
    {"no vertex", {}},
    {"edge with three faces", changed(tetrahedron, [](Soup& s) { s.points.push_back({1, 1, 1}); s.faces.push_back({0, 1, 4}); })},
    {"bow-tie", changed(together(tetrahedron, scaled(tetrahedron, -1), 0), [](Soup& s) {
      for (auto& f : s.faces)
        for (int& v : f) v = v == 4 ? 0 : v;
    })},
    {"edge with four faces", changed(together(tetrahedron, scaled(tetrahedron, -1), 0), [](Soup& s) {
      for (auto& f : s.faces)
        for (int& v : f) v = v == 4 ? 0 : v == 5 ? 1 : v;
    })},
    {"Moebius strip", moebius_strip(9)},
    {"projective plane", projective_plane},
    {"two components", together(tetrahedron, tetrahedron, 3)},
    {"face twice", changed(tetrahedron, [](Soup& s) { s.faces.push_back(s.faces[0]); })},
    {"all faces twice", changed(tetrahedron, [](Soup& s) { s.faces.insert(s.faces.end(), s.faces.begin(), s.faces.end()); })},
    {"face from both sides", changed(tetrahedron, [](Soup& s) { s.faces = {{0, 1, 2}, {0, 2, 1}}; })},
    {"face with a vertex twice", changed(tetrahedron, [](Soup& s) { s.faces[0][2] = s.faces[0][1]; })},
    {"face turned round", changed(tetrahedron, [](Soup& s) { std::swap(s.faces[0][0], s.faces[0][1]); })},
    {"flat face", changed(tetrahedron, [](Soup& s) { s.points[2] = {0.5, 0, 0}; })},
    {"all points equal", scaled(tetrahedron, 0)},
    {"all points on a line", changed(tetrahedron, [](Soup& s) { for (auto& p : s.points) p = {p[0] + 2 * p[1] + 3 * p[2], 0, 0}; })},
    {"coordinates of 1e300", scaled(tetrahedron, huge)},
    {"coordinates of 1e-300", scaled(tetrahedron, tiny)},
    {"coordinates of 1e60", scaled(tetrahedron, 1e60)},   // doubles, but products of four are not
    {"coordinates of 1e-80", scaled(tetrahedron, 1e-80)},
    {"coordinates of 1 and 1e300", changed(tetrahedron, [=](Soup& s) { s.points[2][0] = huge; })},
    {"a coordinate that is no number", changed(tetrahedron, [=](Soup& s) { s.points[1][1] = no_number; })},
    {"an infinite coordinate", changed(tetrahedron, [=](Soup& s) { s.points[1][2] = infinite; })},
  };
  for (const auto& [kind, soup] : kinds)
    for (const std::string& format : all_formats) refused_as(extension(format), format + ", " + kind, written(format, soup));

  for (const std::string format : {"off", "obj", "ply", "binary ply"}) {   // what the others cannot say
    const auto refused = [&](const std::string& kind, int face, int corner, int vertex) {
      refused_as(extension(format), format + ", " + kind,
                 written(format, changed(tetrahedron, [=](Soup& s) { s.faces[face][corner] = vertex; })));
    };
    refused("index one too large", 1, 2, 4);
    refused("index far too large", 2, 0, 2000000000);
    refused("negative index", 0, 1, -2000000000);
    refused_as(extension(format), format + ", face with two corners",
               written(format, changed(tetrahedron, [](Soup& s) { s.faces[0].pop_back(); })));
    refused_as(extension(format), format + ", polygon with a vertex twice",
               written(format, changed(cube, [](Soup& s) { s.faces[0] = {0, 3, 0, 1}; })));
  }
}

void check_harmless_surfaces()
{
  for (const std::string& format : all_formats) {
    read_as(extension(format), format + ", as it should be", written(format, tetrahedron));
    read_as(extension(format), format + ", inside-out",
            written(format, changed(tetrahedron, [](Soup& s) { for (auto& f : s.faces) std::swap(f[0], f[1]); })));
    read_as(extension(format), format + ", coordinates of 1e30", written(format, scaled(tetrahedron, 1e30)));
    read_as(extension(format), format + ", coordinates of 1e-30", written(format, scaled(tetrahedron, 1e-30)));
    read_as(extension(format), format + ", vertices of its own for every face", written(format, separate_faces(tetrahedron)));
    if (contains(format, "stl")) continue;
    read_as(extension(format), format + ", polygons", written(format, cube));
    read_as(extension(format), format + ", unused vertices", written(format, changed(tetrahedron, [](Soup& s) {
      s.points.push_back({5, 5, 5});
      s.points.push_back({5, 5, 5});
    })));
    read_as(extension(format), format + ", polygons that are not flat", written(format, changed(cube, [](Soup& s) { s.points[6] = {1.2, 1.3, 1.4}; })));
  }
}

// ---- Broken bytes, in all formats

std::string noise(std::size_t size, unsigned seed)
{
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& c : bytes) c = static_cast<char>(random());
  return bytes;
}

void check_broken_bytes()
{
  for (const std::string& format : all_formats) {
    const std::string good = written(format, tetrahedron), name = extension(format);
    refused_as(name, format + ", empty", "");
    refused_as(name, format + ", one byte", good.substr(0, 1));
    refused_as(name, format + ", blanks", std::string(5000, ' '));
    refused_as(name, format + ", zeros", std::string(5000, '\0'));
    refused_as(name, format + ", noise", noise(5000, 1));
    refused_as(name, format + ", noise behind the beginning", good.substr(0, good.size() / 3) + noise(5000, 2));
    refused_as(name, format + ", a line of five million letters", good.substr(0, good.size() / 3) + std::string(5000000, 'x'));
    for (int part = 1; part < 8; ++part)   // nothing in OBJ tells how long it should be
      refused_as(name, format + ", cut off at " + std::to_string(part) + "/8", good.substr(0, good.size() * part / 8),
                 name == "obj");
    if (contains(format, "binary")) continue;
    refused_as(name, format + ", a page of the web", "<!DOCTYPE html>\n<html><body>404 not found</body></html>\n");
    read_as(name, format + ", line ends of Windows", replaced_everywhere(good, "\n", "\r\n"));
    read_as(name, format + ", blank lines at the end", good + "\n\n \t\n");
  }
}

// ---- What only one format can say

void check_off()
{
  const std::string good = written("off", tetrahedron);
  const auto with = [&](const std::string& counts) { return replaced(good, "4 4 0", counts); };
  for (const std::string counts : {"1000000000 4 0", "4 1000000000 0", "-4 4 0", "4 -4 0", "99999999999999999999 4 0", "4", "",
                                   "four four 0", "5 4 0", "4 5 0"})
    refused_as("off", "counts '" + counts + "'", with(counts));
  refused_as("off", "two thousand million corners", replaced(good, "3 0 2 1", "2000000000 0 2 1"));
  refused_as("off", "a negative number of corners", replaced(good, "3 0 2 1", "-3 0 2 1"));
  refused_as("off", "no corner", replaced(good, "3 0 2 1", "0"));
  refused_as("off", "decimal commas", replaced(good, "\n1 0 0", "\n1,0 0,0 0,0"));
  refused_as("off", "another format's contents", written("obj", tetrahedron));
  refused_as("off", "four dimensions", "4" + good);
  refused_as("off", "binary in name only", replaced(good, "OFF", "OFF BINARY"));
  read_as("off", "comments", "# a comment\n" + replaced(good, "\n1 0 0", " # one\n# another\n1 0 0"));
  for (const std::string announced : {"ST", "C", "N", "STC", "STN", "CN", "STCN"}) {
    read_as("off", announced + " announced, but not there", announced + good);
    read_as("off", announced + " announced, one number there", announced + replaced(good, "\n1 0 0", "\n1 0 0 7"));
  }
  read_as("off", "colours of faces", replaced(good, "3 0 2 1", "3 0 2 1 255 0 0"));
}

void check_obj()
{
  const std::string good = written("obj", tetrahedron);
  read_as("obj", "names of materials elsewhere", "mtllib ../../elsewhere.mtl /etc/passwd\no ../../name\ng a 'b' \"c\" $(touch here)\n"
          "usemtl ../x\ns off\n" + good);
  read_as("obj", "textures and normals", "vt 0 0\nvn 0 0 1\n" + replaced(good, "f 1 3 2", "f 1/1/1 3/1/1 2/1/1"));
  read_as("obj", "normals alone", "vn 0 0 1\n" + replaced(good, "f 1 3 2", "f 1//1 3//1 2//1"));
  read_as("obj", "indices from the end", replaced(good, "f 1 3 2", "f -4 -2 -3"));
  read_as("obj", "comments", "# a comment\n" + good);
  refused_as("obj", "index 0", replaced(good, "f 1 3 2", "f 0 3 2"));
  refused_as("obj", "an index too far from the end", replaced(good, "f 1 3 2", "f -5 -2 -3"));
  refused_as("obj", "words for numbers", replaced(good, "v 1 0 0", "v one zero zero"));
  refused_as("obj", "two coordinates", replaced(good, "v 1 0 0", "v 1 0"));
}

void check_ply()
{
  const std::string good = written("ply", tetrahedron), binary = written("binary ply", tetrahedron);
  for (const std::string& file : {good, binary}) {
    refused_as("ply", "1000000000 vertices", replaced(file, "vertex 4", "vertex 1000000000"));
    refused_as("ply", "1000000000 faces", replaced(file, "face 4", "face 1000000000"));
    refused_as("ply", "18446744073709551615 faces", replaced(file, "face 4", "face 18446744073709551615"));
    refused_as("ply", "-4 vertices", replaced(file, "vertex 4", "vertex -4"));
    refused_as("ply", "no x", replaced(file, "property double x\n", ""));
    refused_as("ply", "an unknown type", replaced(file, "double y", "quadruple y"));
    refused_as("ply", "an unknown format", replaced(file, "format ", "format EBCDIC_"));
    refused_as("ply", "no end of the header", replaced(file, "end_header", "header_end"));
    refused_as("ply", "a list with a broken length", replaced(file, "list uchar", "list float"));
    refused_as("ply", "an element without properties", replaced(file, "end_header", "element nothing 1000000000\nend_header"));
    refused_as("ply", "control characters in the header", replaced(file, "property double x", "property \x1b[2J\adouble x"));
    read_as("ply", "comments", replaced(file, "element vertex", "comment ../../name\nobj_info x\nelement vertex"));
  }
  refused_as("ply", "256 corners", replaced(good, "3 0 2 1", "256 0 2 1"));
  refused_as("ply", "-3 corners", replaced(good, "3 0 2 1", "-3 0 2 1"));
  read_as("ply", "big end first", written("big-endian ply", tetrahedron));
}

void check_stl()
{
  const std::string good = written("stl", tetrahedron), binary = written("binary stl", tetrahedron);
  const auto counted = [&](unsigned n) {
    std::string file = binary;
    for (int i = 0; i < 4; ++i) file[80 + i] = static_cast<char>(n >> 8 * i);
    return file;
  };
  for (unsigned n : {0u, 3u, 5u, 1000000000u, 4294967295u}) refused_as("stl", std::to_string(n) + " faces announced", counted(n));
  refused_as("stl", "a corner is missing", replaced(good, "vertex 1 0 0\n", ""));
  refused_as("stl", "words for numbers", replaced(good, "vertex 1 0 0", "vertex one 0 0"));
  refused_as("stl", "a face that does not end", replaced(good, "endfacet\n", ""));
  read_as("stl", "normals that are wrong", replaced_everywhere(good, "normal 0 0 0", "normal 7 nan 7"));
}

void check_json()
{
  const std::string good = R"({"triangles":[[0,0,0],[0,0,0]],"opposite":[[[1,0],[1,1],[1,2]],[[0,0],[0,1],[0,2]]],)"
                           R"("lengths":[[1,1,1],[1,1,1]]})";
  read_as("json", "one vertex", good, 1);
  read_as("json", "more members, blanks", replaced(replaced_everywhere(good, ",", " ,\r\n "), "{", "{\"file\":\"../../x\","), 1);
  const auto refused = [&](const std::string& kind, const std::string& from, const std::string& to) {
    refused_as("json", kind, replaced(good, from, to));
  };
  const int deep = 2000000;
  const std::string nest = std::string(deep, '[') + std::string(deep, ']');
  refused_as("json", "empty", "");
  refused_as("json", "blanks", "   \n");
  refused_as("json", "noise", noise(3000, 4));
  refused_as("json", "a list", "[1, 2, 3]");
  refused_as("json", "a number", "5");
  refused_as("json", "only brackets", std::string(deep, '['));
  refused_as("json", "a nest", nest);
  refused("a nest for a length", "[[1,1,1]", "[[" + nest + ",1,1]");
  refused("a nest for a vertex", "[[0,0,0]", "[[" + nest + ",0,0]");
  refused("a text of a million letters for a length", "[[1,1,1]", "[[\"" + std::string(1000000, 'x') + "\",1,1]");
  refused("a text with line ends for a length", "[[1,1,1]", "[[\"a\\nb\\u001b\",1,1]");
  refused("no triangles", "triangles", "squares");
  refused("no gluing", "opposite", "adjacent");
  refused("no lengths", "lengths", "angles");
  refused("lists of different lengths", ",[1,1,1]]", "]");
  refused("two corners", "[[0,0,0]", "[[0,0]");
  refused("an index too large", "[[0,0,0]", "[[0,0,6]");
  refused("a huge index", "[[0,0,0]", "[[0,0,1e300]");
  refused("a negative index", "[[0,0,0]", "[[0,0,-1]");
  refused("an index that is a fraction", "[[0,0,0]", "[[0,0,0.5]");
  refused("glued to a triangle that is not there", "[[[1,0]", "[[[2,0]");
  refused("glued to an edge that is not there", "[[[1,0]", "[[[1,3]");
  refused("glued to itself", "[[[1,0]", "[[[0,0]");
  refused("glued on one side only", "[[[1,0]", "[[[1,1]");
  refused("lengths that differ", "[[1,1,1]", "[[2,1,1]");
  refused("a length of 0", "[[1,1,1],[1,1,1]]", "[[0,1,1],[0,1,1]]");
  refused("a negative length", "[[1,1,1],[1,1,1]]", "[[-1,1,1],[-1,1,1]]");
  refused("lengths that make no triangle", "[[1,1,1],[1,1,1]]", "[[3,1,1],[3,1,1]]");
  refused("lengths of 1e300", "[[1,1,1],[1,1,1]]", "[[1e300,1e300,1e300],[1e300,1e300,1e300]]");
  refused("lengths of 1e-300", "[[1,1,1],[1,1,1]]", "[[1e-300,1e-300,1e-300],[1e-300,1e-300,1e-300]]");
  refused("lengths of 1e60", "[[1,1,1],[1,1,1]]", "[[1e60,1e60,1e60],[1e60,1e60,1e60]]");
  refused("a length beyond all numbers", "[[1,1,1]", "[[1e999,1,1]");
  refused("a length that is no number", "[[1,1,1]", "[[NaN,1,1]");
  for (int part = 1; part < 8; ++part)
    refused_as("json", "cut off at " + std::to_string(part) + "/8", good.substr(0, good.size() * part / 8));
}

// ---- What is no file

void check_no_files()
{
  fs::create_directory(folder / "folder.off");
  fs::create_symlink("nowhere.off", folder / "dangling.off");
  fs::create_symlink("loop.off", folder / "loop.off");
  CHECK_EQUAL(mkfifo((folder / "pipe.off").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", folder / "zeros.off");
  write("surface.xyz", written("off", tetrahedron));
  write("surface", written("off", tetrahedron));
  for (const char* file : {"folder.off", "dangling.off", "loop.off", "pipe.off", "zeros.off", "missing.off", "surface.xyz", "surface",
                           ".", "/", "surface.off/surface.off", "$(printf '%3000s' .off)"})
    check_refused("no file", file);
  write("SURFACE.OFF", written("off", tetrahedron));
  check_read("capital letters", "SURFACE.OFF", 0);
  write("-o", "");
  write("-q.off", written("off", tetrahedron));
  check_read("a name like an option", "-- -q.off", 0);
  write("a 'name'\nof two lines.off", written("off", tetrahedron));
  check_read("a name of two lines", "a*lines.off", 0);
  write("a 'name'\nof two lines.off", "");
  check_refused("a name of two lines", "a*lines.off");
}

} // namespace

int main()
{
  if (Quartic_test::environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  check_harmless_surfaces();
  check_broken_surfaces();
  check_broken_bytes();
  check_off();
  check_obj();
  check_ply();
  check_stl();
  check_json();
  check_no_files();
  return Quartic_test::result();
}
