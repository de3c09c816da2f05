// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The JSON files of runs of all kinds are as the schemas of the manual say, and what a schema does not say is noticed:
// a field that it does not name, one that is missing, a value of another type.

#include "check.h"
#include "run_program.h"

#include <nlohmann/json.hpp>

#ifdef QUARTIC_TEST_VALIJSON
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>
#endif

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

using Json = nlohmann::json;

#ifdef QUARTIC_TEST_VALIJSON

namespace {

using Quartic_test::contents;

const Quartic_test::Program_folder folder;

class Schema
{
public:
  explicit Schema(const std::string& name)
    : m_json(Json::parse(contents(Quartic_test::environment("QUARTIC_SCHEMAS") + "/" + name + ".schema.json")))
  {
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(m_json), m_schema);
  }

  const Json& json() const { return m_json; }

  /// empty if the document is as the schema says
  std::string defect(const Json& document) const
  {
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(m_schema, valijson::adapters::NlohmannJsonAdapter(document), &results)) return {};
    std::string text;
    for (valijson::ValidationResults::Error error; results.popError(error); text += error.description + "; ")
      for (const std::string& step : error.context) text += step;
    return text;
  }

private:
  Json             m_json;
  valijson::Schema m_schema;
};

// Every field has a description, every object is closed: else the manual's tables would have gaps.
void check_completeness(const Json& schema, const std::string& place)
{
  if (schema.is_array())
    for (const Json& part : schema) check_completeness(part, place);
  if (!schema.is_object()) return;
  for (const char* fields : {"properties", "patternProperties"})
    if (schema.contains(fields)) {
      CHECK(schema.value("additionalProperties", true) == false);
      for (const auto& [name, field] : schema[fields].items()) {
        const bool is_described = field.contains("description") && !field["description"].get<std::string>().empty();
        if (!is_described) std::cerr << place << '/' << name << " has no description" << std::endl;
        CHECK(is_described);
      }
    }
  for (const auto& [key, part] : schema.items())
    if (key != "allOf") check_completeness(part, place + '/' + key);   // conditions, of fields that are described elsewhere
}

// Fields that may be missing where a run does not have them; the whole parts of a report that a run did not reach too.
const std::set<std::string> optional_fields{
  "reason", "kind", "loops", "handles_and_tunnels", "position", "started_at", "polyline", "pareto", "conformal_distortion",
  "shortfall", "smoothing", "splines", "corners"};

bool may_be_missing(const Json& document, const Json::json_pointer& place, const std::string& field)
{
  if (optional_fields.count(field) != 0) return true;
  if (document.contains("components")) return std::set<std::string>{"edges", "genus", "boundary"}.count(field) != 0;
  if (!place.empty()) return place.back() == "irregular_vertices" || place.back() == "corners";
  const std::set<std::string> always{"failure", "input", "timings", "peak_memory_bytes", "versions"};   // in a report
  return document.contains("status") && always.count(field) == 0;
}

// Places of all parts but for those in the middle of long lists.
void add_places(const Json& part, const Json::json_pointer& place, std::vector<Json::json_pointer>& places)
{
  places.push_back(place);
  if (part.is_object())
    for (const auto& [key, field] : part.items()) add_places(field, place / key, places);
  if (part.is_array())
    for (std::size_t i = 0; i < part.size(); ++i)
      if (i < 2 || i + 1 == part.size()) add_places(part[i], place / i, places);
}

// The document with only the beginnings of long lists: what is changed is then soon found.
Json shortened(const Json& document)
{
  if (!document.is_structured()) return document;
  Json result = document.is_array() ? Json::array() : Json::object();
  if (document.is_object())
    for (const auto& [key, field] : document.items()) result[key] = shortened(field);
  else
    for (const Json& item : document)
      if (result.size() < 8) result.push_back(shortened(item));   // the least number of knots
  return result;
}

void check_mutations(const Schema& schema, const Json& whole)
{
  const Json document = shortened(whole);
  CHECK_EQUAL(schema.defect(document), "");
  std::vector<Json::json_pointer> places;
  add_places(document, Json::json_pointer(), places);
  std::size_t unnoticed = 0;
  const auto must_be_noticed = [&](const Json& changed, const Json::json_pointer& place, const char* change) {
    if (!schema.defect(changed).empty()) return;
    std::cerr << schema.json()["title"] << ": " << place.to_string() << ' ' << change << std::endl;
    ++unnoticed;
  };
  for (const Json::json_pointer& place : places) {
    Json changed = document;
    changed[place] = nullptr;
    must_be_noticed(changed, place, "may be null");
    if (!document[place].is_object()) continue;
    changed = document;
    changed[place]["undocumented"] = 1;
    must_be_noticed(changed, place, "may have another field");
    for (const auto& [field, value] : document[place].items()) {
      if (may_be_missing(document, place, field)) continue;
      changed = document;
      changed[place].erase(field);
      must_be_noticed(changed, place / field, "may be missing");
    }
  }
  CHECK_EQUAL(unnoticed, 0u);
  CHECK(places.size() > 10);
}

void check_document(const std::string& schema_name, const std::string& text)
{
  static std::map<std::string, Schema> schemas;
  const auto [it, is_new] = schemas.try_emplace(schema_name, schema_name);
  if (is_new) check_completeness(it->second.json(), schema_name);
  const Json document = Json::parse(text);
  CHECK_EQUAL(it->second.defect(document), "");
  check_mutations(it->second, document);
}

// \return the report
Json check_run(const std::string& arguments, int status, const std::set<std::string>& files)
{
  CHECK_EQUAL(folder.quartic("run -q --no-html -o run " + arguments).status, status);
  std::set<std::string> there;
  for (const auto& file : std::filesystem::directory_iterator(folder / "run")) {
    if (file.path().extension() != ".json") continue;
    there.insert(file.path().stem().string());
    check_document(file.path().stem().string(), contents(file.path()));
  }
  CHECK(there == files);
  return Json::parse(contents(folder / "run/report.json"));
}

void check_files()
{
  for (const char* sample : {"torus -n 24 -o g1.off", "chain --genus 0 -o g0.off", "chain --genus 2 -o g2.off",
                             "hyperelliptic --genus 2 -o curve.json", "torus -n 24 --noise 0.4 -o noisy.off",
                             "plate --shape L --holes 1 -n 6 -o plate.off", "cut g1.off --disks 2 -o cut.off"})
    CHECK_EQUAL(folder.quartic(std::string("sample ") + sample).status, 0);
  check_document("surface", contents(folder / "curve.json"));
  check_document("report", folder.quartic("info --json g2.off -q").out);
  check_document("report", folder.quartic("info --json --no-loops curve.json -q").out);

  const std::set<std::string> usual{"report", "flat_intrinsic", "tmesh"};
  const Json torus = check_run("g1.off --quads 200 --splines --pareto", 0, {"report", "flat_intrinsic", "tmesh", "splines"});
  CHECK(torus["quad_mesh"].contains("splines") && torus["distortion"].contains("pareto"));
  const Json sphere = check_run("g0.off --precision 128 --edge-length 0.5", 0, usual);
  CHECK(sphere["input"]["genus"] == 0 && sphere["precision"]["bits"] == 128);
  CHECK_EQUAL(check_run("g2.off --count 12", 0, usual)["singularities"].size(), 12u);
  std::filesystem::copy_file(folder / "run/singularities.txt", folder / "own.txt");
  const Json own = check_run("g2.off --singularities own.txt --no-loops --quads 100 --no-smoothing", 0, usual);
  CHECK(!own["homology"].contains("loops") && !own["quad_mesh"].contains("smoothing"));
  const Json plate = check_run("plate.off --quads 100", 0, usual);
  CHECK_EQUAL(plate["corners"].size(), 10u);
  std::map<std::string, int> by_quads;
  for (const Json& c : plate["corners"]) ++by_quads[std::to_string(c["quads"].get<int>())];
  CHECK(plate["quad_mesh"]["corners"] == Json(by_quads));
  const Json cut = check_run("cut.off", 0, usual);
  CHECK(cut["input"]["boundary"] == 2 && !cut["homology"].contains("intersection_matrix"));
  CHECK(!check_run("curve.json", 0, usual)["input"]["embedded"].get<bool>());
  CHECK_EQUAL(check_run("g1.off --singularities own.txt", 2, {"report"})["status"], "failed");

  std::ofstream(folder / "two.off") << "OFF\n8 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n7 0 0\n8 0 0\n9 0 0\n0 0 9\n"
                                       "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 4 5 6\n";   // the triangle has no area
  CHECK_EQUAL(folder.quartic("run -q --no-html -o each --components each two.off").status, 2);
  check_document("components", contents(folder / "each" / "components.json"));
}

} // namespace

int main()
{
  if (Quartic_test::environment("QUARTIC_PROGRAM").empty()) {
    std::cout << "skipped: the environment variable QUARTIC_PROGRAM does not name the program" << std::endl;
    return Quartic_test::skipped;
  }
  check_files();
  return Quartic_test::result();
}

#else

int main()
{
  std::cout << "skipped: valijson was not found (Debian: libvalijson-dev)" << std::endl;
  return Quartic_test::skipped;
}

#endif
