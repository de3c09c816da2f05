// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Generated surfaces of genus 0 to 12, good and bad, closed and with boundary, with random singularities and options,
// through the program: every run ends in time with results that are verified, with a mathematical reason, or, seldom,
// says that a computation did not reach its tolerance; never with a crash or a wrong result. A table in Markdown goes to
// the standard output.
//
// robustness [SEED [FIRST [LAST]]]: a case depends on SEED and its number alone, so that each can be run again.

#include "check.h"
#include "run_program.h"
#include "test_surfaces.h"

#include <CGAL/Quartic_differentials/IO/read_surface.h>
#include <CGAL/Quartic_differentials/exceptions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

using namespace CGAL::Quartic_differentials;
using namespace Quartic_test;

namespace {

const int    most_genus = 12;
const int    closed_cases = 200;           // those that follow have a boundary
const double seconds_allowed = 600;        // by the clock, also where the machine is busy: a run that hangs
const double numerical_failures_allowed = 0.05;   // of all runs

const Program_folder folder;

// ---- A random case

class Dice
{
public:
  explicit Dice(unsigned seed) : m_random(seed) {}
  int    between(int a, int b) { return a + static_cast<int>(m_random() % static_cast<unsigned>(b - a + 1)); }
  double between(double a, double b) { return uniform(m_random, a, b); }
  bool   chance(double p) { return between(0.0, 1.0) < p; }
  double power_of_ten(double a, double b) { return std::pow(10, between(a, b)); }
  template <class T> const T& one_of(const std::vector<T>& list) { return list[m_random() % list.size()]; }

private:
  std::mt19937 m_random;
};

struct Case
{
  int         genus;
  std::string file, sample, divisor, options;   // the last two: lines of the file of singularities, or none
  std::string cut;                              // options with which disks are cut out; none on closed surfaces

  bool has_boundary() const { return !cut.empty() || sample.rfind("plate", 0) == 0; }
  /// the commands that make the file, each with its arguments
  std::vector<std::string> commands() const
  {
    if (cut.empty()) return {"sample " + sample + " -o " + file};
    return {"sample " + sample + " -o closed.off", "sample cut closed.off" + cut + " -o " + file};
  }
};

std::string spoilt(Dice& dice)
{
  std::ostringstream options;
  if (dice.chance(0.4)) options << " --noise " << dice.between(0.02, 0.4);
  if (dice.chance(0.25)) options << " --slivers " << dice.power_of_ten(-5, -0.5);
  if (dice.chance(0.25)) options << " --stretch " << dice.power_of_ten(-1, 1);
  if (dice.chance(0.2)) options << " --hub " << dice.between(3, 200);
  options << " --seed " << dice.between(1, 1000000);
  return options.str();
}

// a surface of this genus, of any kind that there is
Case random_surface(int genus, Dice& dice)
{
  const std::string g = std::to_string(genus);
  if (genus >= 1 && dice.chance(0.2)) {
    const bool polygon = dice.chance(0.5);
    const int subdivisions = dice.between(genus == 1 ? 1 : 0, 3);
    return {genus, "surface.json",
            (polygon ? "polygon -g " : "hyperelliptic -g ") + g + " -s " + std::to_string(subdivisions), "", "", ""};
  }
  Case c{genus, "surface." + dice.one_of<std::string>({"off", "off", "off", "obj", "ply", "stl"}), "", "", "", ""};
  if (genus == 0 && dice.chance(0.6)) c.sample = "sphere -s " + std::to_string(dice.between(1, 4));
  else if (genus == 1 && dice.chance(0.6)) c.sample = "torus -n " + std::to_string(dice.between(6, 60));
  else c.sample = (dice.chance(0.6) ? "chain -g " : "ring -g ") + g + " -n " + std::to_string(dice.between(6, genus < 4 ? 9 : 6));
  if (dice.chance(0.6)) c.sample += spoilt(dice);
  return c;
}

// a plate, or a surface with disks cut out, or with more than half of it cut off
Case random_surface_with_boundary(int number, Dice& dice)
{
  Case c = random_surface(number % 5, dice);
  while (c.file == "surface.json") c = random_surface(number % 5, dice);
  if (dice.chance(0.2)) {
    c.genus = 0;
    c.sample = "plate --shape " + dice.one_of<std::string>({"round", "rectangle", "L"}) + " --holes "
             + std::to_string(dice.between(0, 4)) + " -n " + std::to_string(dice.between(12, 30)) + spoilt(dice);
    if (dice.chance(0.3)) c.sample += " --obtuse-boundary " + std::to_string(dice.between(100, 179));
    return c;
  }
  std::ostringstream options;
  if (dice.chance(0.8)) options << " --disks " << dice.between(1, 4) << " --radius " << dice.between(0.03, 0.12);
  else options << " --plane " << dice.between(-1.0, 1.0) << ',' << dice.between(-1.0, 1.0) << ",1";
  options << " --seed " << dice.between(1, 1000000);
  if (dice.chance(0.3)) options << " --obtuse-boundary " << dice.between(100, 179);
  c.cut = options.str();
  return c;
}

std::string random_options_with_boundary(Dice& dice)
{
  std::ostringstream options;
  if (dice.chance(0.3)) options << " --corners none";
  if (dice.chance(0.3)) options << " --count " << dice.between(2, 60);
  else if (dice.chance(0.4)) options << " --distortion " << dice.power_of_ten(-2.2, 0);
  if (dice.chance(0.1)) options << " --no-optimize";
  if (dice.chance(0.1)) options << " --start " << dice.one_of<std::string>({"curvature", "field", "pairs"});
  if (dice.chance(0.1)) options << " --norm " << dice.one_of<std::string>({"movement", "paper", "invariant"});
  if (dice.chance(0.05)) options << " --abel-jacobi zeros";
  if (dice.chance(0.1)) options << " --intrinsic";
  if (dice.chance(0.05)) options << " --precision " << dice.between(64, 160);
  if (dice.chance(0.5)) options << " --quads " << dice.between(1, 3000);
  if (dice.chance(0.2)) options << " --splines";
  if (!dice.chance(0.3)) options << " --no-html";
  return options.str();
}

// Orders mostly of 1 and -1, but also from -3 to 8; several at one place; pinned; degree 8g - 8, unless it is wrong.
std::string random_divisor(const Intrinsic_triangulation& t, Dice& dice)
{
  std::ostringstream lines;
  Point_3 place;
  lines.precision(17);
  int degree = 0;
  const bool together = dice.chance(0.1);
  const double pinned = dice.chance(0.3) ? 0.3 : 0;
  const auto add = [&](int order) {
    const Face f(static_cast<Mesh::size_type>(dice.between(0, static_cast<int>(t.number_of_faces()) - 1)));
    const auto h = t.halfedges(f);
    const auto corner = [&](int k) { return t.mesh().point(t.source(h[k])); };
    const double x = dice.between(0.0, 0.5), y = dice.between(0.0, 0.5);
    if (!together || degree == 0 || dice.chance(0.5))
      place = dice.chance(0.3) ? corner(0) : CGAL::barycenter(corner(0), 1 - x - y, corner(1), x, corner(2), y);
    lines << place << ' ' << order << (dice.chance(pinned) ? " pinned\n" : "\n");
    degree += order;
  };
  const int wanted = 8 * t.genus() - 8;
  if (t.genus() > 1 && dice.chance(0.05)) {
    add(wanted);                                  // one for all
    return lines.str();
  }
  for (int n = dice.between(2, 16); n > 0; --n) {
    const int order = dice.chance(0.3) ? dice.between(-3, 8) : dice.between(0, 1) == 0 ? -1 : 1;
    if (order != 0) add(order);
  }
  if (dice.chance(0.08)) return lines.str();      // of any degree
  while (degree < wanted) add(std::min(wanted - degree, dice.between(1, 3)));
  while (degree > wanted) add(-std::min(degree - wanted, dice.between(1, 2)));
  return lines.str();
}

std::string random_options(bool chosen, bool in_space, Dice& dice)
{
  std::ostringstream options;
  if (chosen && dice.chance(0.3)) options << " --count " << dice.between(2, 60);
  else if (chosen && dice.chance(0.4)) options << " --distortion " << dice.power_of_ten(-2.5, 0);
  if (chosen && dice.chance(0.1)) options << " --no-optimize";
  if (chosen && dice.chance(0.1)) options << " --start " << dice.one_of<std::string>({"curvature", "field", "pairs"});
  if (!chosen && dice.chance(0.2)) options << " --optimize";
  if (!chosen && dice.chance(0.1)) options << " --repair-degree";
  if (dice.chance(0.2)) options << " --norm " << dice.one_of<std::string>({"movement", "paper", "invariant"});
  if (dice.chance(0.1)) options << " --abel-jacobi zeros";
  if (dice.chance(0.1)) options << " --no-loops";
  if (dice.chance(0.1)) options << " --intrinsic";
  if (dice.chance(0.03)) options << " --precision " << dice.between(64, 160);
  if (in_space && dice.chance(0.35)) options << " --quads " << dice.between(1, 3000);
  if (in_space && dice.chance(0.1)) options << " --splines";
  if (!dice.chance(0.3)) options << " --no-html";
  return options.str();
}

Case random_case(unsigned seed, int number)
{
  std::seed_seq mixed{seed, static_cast<unsigned>(number)};
  std::vector<unsigned> own(1);
  mixed.generate(own.begin(), own.end());
  Dice dice(own[0]);
  const bool is_closed = number < closed_cases;
  Case c = is_closed ? random_surface(number % (most_genus + 1), dice) : random_surface_with_boundary(number, dice);
  for (const std::string& command : c.commands()) {
    const Outcome made = folder.quartic(command);
    if (!is_closed && made.status == 2) c.file.clear();   // disks that meet, or nothing left: said by `sample`
    else CHECK_EQUAL(made.status, 0);
  }
  if (!is_closed) {
    c.options = random_options_with_boundary(dice);
    return c;
  }
  const bool in_space = c.file != "surface.json";
  const bool chosen = !in_space || dice.chance(0.35);
  if (!chosen) {
    std::vector<std::string> notes;
    try {
      c.divisor = random_divisor(read_surface((folder / c.file).string(), notes), dice);
    } catch (const Unusable_surface_error&) {   // spoilt too much: the program will say so
    }
  }
  c.options = random_options(chosen, in_space, dice);
  return c;
}

// ---- Its outcome

struct Result
{
  int         status, genus;
  std::string sentence, how;
  double      cpu_seconds;
  bool        has_boundary;
};

bool is_one_sentence(const std::string& text)
{
  return text.rfind("quartic: ", 0) == 0 && std::count(text.begin(), text.end(), '\n') == 1 && !contains(text, "std::")
      && !contains(text, "vector") && !contains(text, "exception");
}

bool nothing_is_half_written()
{
  if (!fs::exists(folder / "results")) return true;
  for (const fs::directory_entry& file : fs::directory_iterator(folder / "results"))
    if (file.path().extension() == ".part" || (file.path().extension() == ".json" && !nlohmann::json::accept(contents(file.path()))))
      return false;
  return true;
}

// Prints the lines of checks that failed. A coarse or spoilt surface is mapped as conformally as it allows, and no better.
bool all_hold(const std::string& checks)
{
  bool hold = true;
  std::istringstream lines(checks);
  for (std::string line; std::getline(lines, line); )
    if (line.rfind("FAIL", 0) == 0 && !contains(line, "conformal")) {
      std::cerr << line << std::endl;
      hold = false;
    }
  return hold;
}

// by the program, and by the independent check where that is there and knows the format; it knows no boundary
bool is_verified(const Case& c)
{
  const Outcome o = folder.quartic("verify " + c.file + " results");
  bool holds = all_hold(o.out) && o.status == 0;
  const std::string script = environment("QUARTIC_VERIFY_OUTPUTS"), format = fs::path(c.file).extension();
  if (script.empty() || c.has_boundary() || (format != ".off" && format != ".obj")) return holds;
  const auto unless_there = [](const char* file, const char* option) { return fs::exists(folder / "results" / file) ? "" : option; };
  const int status = std::system(("cd '" + (folder / "").string() + "' && '" + script + "' " + c.file + " results "
    + unless_there("quads.obj", "--no-quads ") + unless_there("tmesh.json", "--no-tmesh ") + ">checks.txt 2>&1").c_str());
  const std::string checks = contents(folder / "checks.txt");
  const bool came_to_its_end = WIFEXITED(status) && WEXITSTATUS(status) <= 1 && !contains(checks, "Traceback");
  if (!came_to_its_end) std::cerr << checks << std::endl;
  return came_to_its_end && all_hold(checks) && holds;
}

Result run(unsigned seed, int number)
{
  fs::remove_all(folder / "results");
  const Case c = random_case(seed, number);
  if (c.file.empty()) return {2, c.genus, "quartic: `sample` found no place to cut\n", "", 0, true};
  std::string arguments = "run " + c.file + " -o results -q" + c.options;
  if (!c.divisor.empty()) {
    std::ofstream(folder / "singularities.txt") << c.divisor;
    arguments += " --singularities singularities.txt";
  }
  const Outcome o = folder.quartic(arguments, "timeout -k 10 " + std::to_string(seconds_allowed));
  std::string how;
  for (const std::string& command : c.commands()) how += "quartic " + command + " && ";
  const Result r{o.status, c.genus, o.err, how + "quartic " + arguments, o.cpu_seconds, c.has_boundary()};
  const bool good = o.status == 0 ? o.err.empty() && is_verified(c)
                                  : (o.status == 2 || o.status == 3) && is_one_sentence(o.err);
  if (!good || !nothing_is_half_written())
    std::cerr << "case " << number << " of seed " << seed << ": " << r.how << "\nstatus " << o.status << ", " << o.err << std::endl;
  CHECK(good);
  CHECK(nothing_is_half_written());
  return r;
}

// ---- The table

// the sentence with # for every number, so that the same reasons are counted together
std::string reason(const std::string& sentence)
{
  std::string text;
  for (char c : sentence.substr(std::min<std::size_t>(9, sentence.size()))) {
    if (c == '\n') break;
    const bool digit = contains("0123456789", std::string(1, c));
    if (!digit) text += c;
    else if (text.empty() || text.back() != '#') text += '#';
  }
  return text;
}

double quantile(std::vector<double> values, double part)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void print_table(const std::vector<Result>& results)
{
  std::cout << "\n| genus | runs | verified | refused | tolerance not reached | median time [s] | longest [s] |\n"
            << "|---:|---:|---:|---:|---:|---:|---:|\n" << std::fixed << std::setprecision(1);
  const auto row = [&](const std::string& name, auto belongs) {
    std::map<int, int> count;
    std::vector<double> times;
    for (const Result& r : results)
      if (belongs(r)) {
        ++count[r.status];
        times.push_back(r.cpu_seconds);
      }
    std::cout << "| " << name << " | " << times.size() << " | " << count[0] << " | " << count[2] << " | " << count[3] << " | "
              << quantile(times, 0.5) << " | " << quantile(times, 1) << " |\n";
  };
  for (int g = 0; g <= most_genus; ++g)
    row(std::to_string(g), [g](const Result& r) { return !r.has_boundary && r.genus == g; });
  for (int g = 0; g < 5; ++g)
    row(std::to_string(g) + ", with boundary", [g](const Result& r) { return r.has_boundary && r.genus == g; });
  row("all", [](const Result&) { return true; });

  std::map<std::pair<int, std::string>, int> reasons;
  for (const Result& r : results)
    if (r.status != 0) ++reasons[{r.status, reason(r.sentence)}];
  std::cout << "\n| status | runs | reason |\n|---:|---:|---|\n";
  for (const auto& [status_and_reason, n] : reasons)
    std::cout << "| " << status_and_reason.first << " | " << n << " | " << status_and_reason.second << " |\n";
}

} // namespace

int main(int argc, char** argv)
{
  if (environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  const auto argument = [&](int i, int otherwise) { return i < argc ? std::atoi(argv[i]) : otherwise; };
  const unsigned seed = static_cast<unsigned>(argument(1, 1));
  const int first = argument(2, 0), last = argument(3, argc > 2 ? first : closed_cases + 99);
  std::vector<Result> results;
  for (int i = first; i <= last; ++i) {
    results.push_back(run(seed, i));
    std::cerr << i << ": status " << results.back().status << ", " << results.back().cpu_seconds << " s, genus "
              << results.back().genus << std::endl;
    if (results.back().status == 3) std::cout << "    case " << i << ": " << results.back().how << "\n    " << results.back().sentence;
  }
  const auto numerical = std::count_if(results.begin(), results.end(), [](const Result& r) { return r.status == 3; });
  CHECK(static_cast<double>(numerical) <= 1 + numerical_failures_allowed * static_cast<double>(results.size()));
  print_table(results);
  return Quartic_test::result();
}
