// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// report.html: one file that asks for no other, says what report.json says, shows the surface of flat.obj and the
// patches of tmesh.json, and works in a browser, where there is one.

#include "check.h"
#include "run_program.h"
#include "typed_arrays.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

using Json = nlohmann::json;
using Quartic_test::Outcome;
using Quartic_test::contains;
using Quartic_test::contents;
using Quartic_test::Point;
using Quartic_test::doubled_area;
using Quartic_test::floats;
using Quartic_test::indices;
using Quartic_test::points;

const Quartic_test::Program_folder folder;

// the text between two others, from the first occurrence
std::string between(const std::string& text, const std::string& open, const std::string& close)
{
  const std::size_t begin = text.find(open);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find(close, begin + open.size());
  return text.substr(begin + open.size(), end - begin - open.size());
}

// the JSON that a page holds under a name
Json embedded(const std::string& page, const std::string& id)
{
  return Json::parse(between(page, "<script type=\"application/json\" id=\"" + id + "\">", "</script>"));
}

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

std::string without_scripts(std::string page)
{
  for (std::size_t begin = 0; (begin = page.find("<script", begin)) != std::string::npos; ++begin) {
    const std::size_t open = page.find('>', begin) + 1;
    page.erase(open, page.find("</script>", open) - open);
  }
  return page;
}

// No script, style or picture comes from elsewhere; what scripts may ask for, the policy forbids.
void check_stands_alone(const std::string& page)
{
  const std::string markup = without_scripts(page);
  for (const char* loading : {" src=", "url(", "@import", "<iframe", "<object", "<embed", "<base", "<form"})
    CHECK(!contains(markup, loading));
  CHECK_EQUAL(count(markup, "href="), count(markup, "href=\"data:,\""));
  CHECK(contains(markup, "http-equiv=\"Content-Security-Policy\""));
  CHECK(contains(markup, "content=\"default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                         "img-src data:\""));
  CHECK(count(page, "</script>") > 3 && count(markup, "<script") == count(page, "</script>"));
  CHECK(page.size() < 6'000'000);
}

std::vector<Point> vertices_of_obj(const fs::path& path)
{
  std::ifstream in(path);
  std::vector<Point> result;
  std::string line, word;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    double x, y, z;
    if (words >> word && word == "v" && words >> x >> y >> z)
      result.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  }
  return result;
}

// i^k (u + iv) + x + iy
std::array<double, 2> moved(const Json& pattern, double u, double v)
{
  const int k = pattern[0];
  const double rotated[4][2] = {{u, v}, {-v, u}, {-u, -v}, {v, -u}};
  return {rotated[k][0] + pattern[1].get<double>(), rotated[k][1] + pattern[2].get<double>()};
}

// The patches are laid out side by side across all but the least possible number of arcs: on those, both sides agree.
void check_layout(const Json& surface, const Json& t_mesh)
{
  const Json& patches = t_mesh["patches"];
  const Json& corner = surface["corner"];
  const std::vector<std::uint32_t> point = indices(corner["point"]), patch = indices(corner["patch"]);
  const std::vector<float> uv = floats(corner["uv"]);
  std::map<std::uint32_t, std::vector<std::uint32_t>> corners_at;
  for (std::uint32_t c = 0; c < point.size(); ++c) corners_at[point[c]].push_back(c);
  std::set<std::pair<std::uint32_t, std::uint32_t>> joined;   // patches that agree at some piece of an arc
  const std::vector<std::uint32_t> arcs = indices(surface["arcs"]);
  const auto place = [&](std::uint32_t c) { return moved(patches[patch[c]]["pattern"], uv[2 * c], uv[2 * c + 1]); };
  const auto same = [&](std::uint32_t c, std::uint32_t d) {
    const auto a = place(c), b = place(d);
    return std::abs(a[0] - b[0]) < 1e-4 && std::abs(a[1] - b[1]) < 1e-4;   // float's rounding; patches are larger
  };
  for (std::size_t k = 0; k < arcs.size(); k += 2)
    for (std::uint32_t c : corners_at[arcs[k]])
      for (std::uint32_t d : corners_at[arcs[k]])
        for (std::uint32_t e : corners_at[arcs[k + 1]])
          for (std::uint32_t f : corners_at[arcs[k + 1]])
            if (patch[c] < patch[d] && patch[e] == patch[c] && patch[f] == patch[d] && same(c, d) && same(e, f))
              joined.emplace(patch[c], patch[d]);
  std::vector<std::size_t> root(patches.size());
  for (std::size_t p = 0; p < root.size(); ++p) root[p] = p;
  const auto find = [&](std::size_t p) { while (root[p] != p) p = root[p]; return p; };
  for (const auto& [p, q] : joined) root[find(p)] = find(q);
  for (std::size_t p = 0; p < root.size(); ++p) CHECK_EQUAL(find(p), find(0));
}

void check_surface(const Json& model, const std::string& results)
{
  const Json& surface = model["surface"];
  const std::vector<Point> shown = points(floats(surface["points"]));
  const std::vector<Point> flat = vertices_of_obj(folder / results / "flat.obj");
  CHECK(flat.size() > 100 && shown.size() >= flat.size());
  CHECK(std::equal(flat.begin(), flat.end(), shown.begin()));   // the same doubles, rounded
  const Json& corner = surface["corner"];
  const std::vector<std::uint32_t> point = indices(corner["point"]), patch = indices(corner["patch"]);
  const std::vector<float> uv = floats(corner["uv"]);
  CHECK_EQUAL(patch.size(), point.size());
  CHECK_EQUAL(uv.size(), 2 * point.size());
  CHECK(*std::max_element(point.begin(), point.end()) == shown.size() - 1);

  const Json& patches = model["tmesh"]["patches"];
  for (std::size_t c = 0; c < patch.size(); ++c) {
    const float width = patches[patch[c]]["width"], height = patches[patch[c]]["height"];
    const float u = uv[2 * c], v = uv[2 * c + 1];
    CHECK(u >= 0 && u <= width && v >= 0 && v <= height);
  }
  const std::vector<std::uint32_t> triangles = indices(surface["triangles"]);
  std::vector<double> area(patches.size(), 0.0);
  bool positive = true, in_one_patch = true;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const std::uint32_t a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
    in_one_patch = in_one_patch && patch[a] == patch[b] && patch[b] == patch[c];
    positive = positive && doubled_area(uv, a, b, c) > -1e-6;
    area[patch[a]] += doubled_area(uv, a, b, c) / 2;
  }
  CHECK(positive && in_one_patch);
  for (std::size_t p = 0; p < patches.size(); ++p)   // its triangles fill the rectangle
    CHECK_NEAR(area[p] / (patches[p]["width"].get<double>() * patches[p]["height"].get<double>()), 1, 1e-3);

  const Json t_mesh = Json::parse(contents(folder / results / "tmesh.json"));
  CHECK_EQUAL(patches.size(), t_mesh["patches"].size());
  const double unit = std::ldexp(1.0, -t_mesh["grid_exponent"].get<int>());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    CHECK(patches[p]["sides"] == t_mesh["patches"][p]["sides"]);
    CHECK_EQUAL(patches[p]["width"].get<double>(), unit * t_mesh["patches"][p]["width"].get<double>());
  }
  const Json report = Json::parse(contents(folder / results / "report.json"));
  CHECK_EQUAL(indices(surface["edges"]).size(), 2 * report["input"]["edges"].get<std::size_t>());
  check_layout(surface, model["tmesh"]);
}

void check_quads(const Json& model, const std::string& results)
{
  const std::vector<Point> shown = points(floats(model["quads"]["points"]));
  const std::vector<Point> written = vertices_of_obj(folder / results / "quads.obj");
  CHECK(!shown.empty() && shown == written);
  CHECK_EQUAL(indices(model["quads"]["quads"]).size(), 4 * indices(model["quads"]["patch"]).size());
}

void check_histograms(const Json& model)
{
  for (const char* name : {"log_conformal_distortion", "log_area_scale"}) {
    double sum = 0;
    for (const Json& share : model["histograms"][name]["share"]) sum += share.get<double>();
    CHECK_NEAR(sum, 1, 1e-9);
  }
}

void check_complete_run()
{
  CHECK_EQUAL(folder.quartic("sample chain -g 2 -n 6 -o chain.off").status, 0);
  CHECK_EQUAL(folder.quartic("run chain.off -o results --quads 500 -q").status, 0);
  const std::string page = contents(folder / "results" / "report.html");
  check_stands_alone(page);
  CHECK(embedded(page, "report") == Json::parse(contents(folder / "results" / "report.json")));
  CHECK(embedded(page, "run")["command"] == "quartic run chain.off -o results --quads 500 -q");
  const Json model = embedded(page, "model");
  check_surface(model, "results");
  check_quads(model, "results");
  check_histograms(model);
  CHECK_EQUAL(model["loops"].size(), std::size_t(4));
  CHECK(!contains(page, "class=\"failure\""));

  CHECK_EQUAL(folder.quartic("run chain.off -o results -q --no-html").status, 0);   // and the old one is gone
  CHECK(!fs::exists(folder / "results" / "report.html"));
  CHECK(fs::exists(folder / "results" / "report.json"));
}

// A name that is HTML and script is text on the page.
void check_names()
{
  const std::string name = "a'b\"<img src=x onerror=alert(1)>&lt;.off";
  fs::copy_file(folder / "chain.off", folder / name);
  const std::string quoted = "'a'\\''b\"<img src=x onerror=alert(1)>&lt;.off'";
  CHECK_EQUAL(folder.quartic("run " + quoted + " -o 'odd </script> names' -q").status, 0);
  const std::string page = contents(folder / "odd </script> names" / "report.html");
  CHECK(!page.empty() && !contains(without_scripts(page), "<img") && !contains(page, "</script> names"));
  CHECK(contains(page, "<h1>a&#39;b&quot;&lt;img src=x onerror=alert(1)&gt;&amp;lt;.off</h1>"));
  CHECK(embedded(page, "report")["input"]["mesh"] == name);
  CHECK(embedded(page, "run")["folder"] == "odd </script> names");
  const std::string command = embedded(page, "run")["command"];   // does it again, in a shell
  CHECK(command.rfind("quartic run ", 0) == 0);
  fs::remove_all(folder / "odd </script> names");
  CHECK_EQUAL(folder.quartic(command.substr(std::strlen("quartic "))).status, 0);
  CHECK(fs::exists(folder / "odd </script> names" / "report.html"));
}

// Runs that end before the T-mesh: what there is, and why.
void check_failed_run()
{
  std::ofstream(folder / "too_few.txt") << "0 0 0 1\n";
  const Outcome o = folder.quartic("run chain.off -o failed -q --singularities too_few.txt");
  CHECK_EQUAL(o.status, 2);
  const std::string page = contents(folder / "failed" / "report.html");
  check_stands_alone(page);
  const Json report = embedded(page, "report");
  CHECK(report == Json::parse(contents(folder / "failed" / "report.json")));
  CHECK(report["status"] == "failed");
  const std::string banner = between(page, "class=\"failure\"", "</section>");
  CHECK(contains(banner, "degree"));
  CHECK(page.find("class=\"failure\"") < page.find("id=\"model-section\""));
  const Json model = embedded(page, "model");
  CHECK(model.contains("surface") && !model["surface"]["corner"].contains("uv") && !model.contains("tmesh"));

  CHECK_EQUAL(folder.quartic("sample l -s 1 -o l.json").status, 0);   // no positions in space
  CHECK_EQUAL(folder.quartic("run l.json -o glued -q").status, 0);
  const std::string glued = contents(folder / "glued" / "report.html");
  check_stands_alone(glued);
  CHECK(!embedded(glued, "model").contains("surface") && embedded(glued, "model").contains("tmesh"));
}

// ---- In a browser

// Chromium's arguments; WebGL is computed by the processor.
struct Visit
{
  std::string verdict, errors;
};

Visit visit(const std::string& results, const std::string& options)
{
  const fs::path dom = folder / "dom.html", log = folder / "chromium.log", profile = folder / "profile";
  const std::string command = "chromium --headless --no-sandbox --disable-gpu-sandbox --virtual-time-budget=20000 "
    "--enable-logging=stderr --window-size=1280,900 --user-data-dir='" + profile.string() + "' " + options
    + " --dump-dom 'file://" + (folder / results / "report.html").string() + "#selftest' >'" + dom.string()
    + "' 2>'" + log.string() + "'";
  if (std::system(command.c_str()) != 0) std::cerr << "chromium failed\n";
  std::string errors, line;
  for (std::ifstream in(log); std::getline(in, line); )
    if (contains(line, "CONSOLE")) errors += line + '\n';
  return {between(contents(dom), "<pre id=\"selftest\">", "</pre>"), errors};
}

void check_in_browser()
{
  const std::string webgl = "--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader";
  CHECK_EQUAL(folder.quartic("run chain.off -o results --quads 500 --splines -q").status, 0);

  const bool turns = contains(contents(folder / "results" / "report.html"), "OrbitControls");   // three.js was there
  const Visit complete = visit("results", webgl);
  CHECK_EQUAL(complete.errors, "");
  const Json verdict = Json::parse(complete.verdict, nullptr, false);
  CHECK(verdict.is_object());
  if (!verdict.is_object()) return;
  CHECK(verdict["webgl"] == turns && verdict["overflow"] == false && verdict["sections"] >= 7);
  if (turns) {
    CHECK(verdict["drawn"] > 1000);
    for (const char* layer : {"checkerboard", "patches", "arcs", "singularities", "loops_a", "loops_b", "quads",
                              "wireframe"}) {
      CHECK(verdict["layers"][layer]["changed"] > 50);
      CHECK(verdict["layers"][layer]["restored"] == true);
    }
  }
  for (const char* results : {"failed", "glued"}) {
    const Visit partial = visit(results, webgl);
    CHECK_EQUAL(partial.errors, "");
    CHECK(contains(partial.verdict, "sections"));
  }
  const Visit flat = visit("results", "--disable-3d-apis");
  CHECK_EQUAL(flat.errors, "");
  CHECK(contains(flat.verdict, "\"webgl\":false") && contains(flat.verdict, "\"picture\":true"));
}

int main()
{
  if (Quartic_test::environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the program 'quartic' was not built" << std::endl;
    return Quartic_test::skipped;
  }
  check_complete_run();
  check_names();
  check_failed_run();
  if (std::system("command -v chromium >/dev/null 2>&1") == 0) check_in_browser();
  else std::cout << "not looked at in a browser: chromium was not found" << std::endl;
  return Quartic_test::result();
}
