// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page.h"

#include "page_files.h"

#include <filesystem>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

namespace {

std::string html_escaped(const std::string& text)
{
  std::string result;
  for (char c : text)
    switch (c) {
      case '<':  result += "&lt;"; break;
      case '>':  result += "&gt;"; break;
      case '&':  result += "&amp;"; break;
      case '"':  result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default:   result += c;
    }
  return result;
}

// JSON in which no tag begins or ends: "<" is left in strings only, and JSON has another form for it there
void write_json(std::ostream& out, const Json& json)
{
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::size_t begin = 0;
  for (std::size_t at; (at = text.find('<', begin)) != std::string::npos; begin = at + 1)
    out << std::string_view(text).substr(begin, at - begin) << "\\u003c";
  out << std::string_view(text).substr(begin);
}

std::string banner(const std::string& failure)
{
  if (failure.empty()) return {};
  return "<section class=\"failure\" role=\"alert\"><h2>This run did not reach its end</h2><p>" + html_escaped(failure)
       + "</p><p class=\"note\">What was computed before is shown below.</p></section>";
}

} // namespace

void write_page(std::ostream& out, const Run_facts& facts, const Json& model, const Json& report)
{
  const Json run = {{"command", facts.command}, {"folder", facts.folder}};
  const std::map<std::string_view, std::function<void()>> places{
    {"title",   [&] { out << html_escaped(std::filesystem::path(facts.mesh).filename().string()); }},
    {"style",   [&] { out << Page_files::style; }},
    {"failure", [&] { out << banner(facts.failure); }},
    {"run",     [&] { write_json(out, run); }},
    {"report",  [&] { write_json(out, report); }},
    {"model",   [&] { write_json(out, model); }},
    {"three",   [&] { out << Page_files::three; }},
    {"scripts", [&] { out << Page_files::scripts; }}};
  std::string_view rest = Page_files::html;
  for (std::size_t open; (open = rest.find("{{")) != std::string_view::npos; ) {
    const std::size_t close = rest.find("}}", open);
    out << rest.substr(0, open);
    places.at(rest.substr(open + 2, close - open - 2))();
    rest.remove_prefix(close + 2);
  }
  out << rest;
}
