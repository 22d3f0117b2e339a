#include "report/page/page.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <utility>
#include <vector>

#include "base/shown_unit.h"
#include "report/page/assets.h"
#include "report/page/html.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

std::string script(std::string_view text) {
  return "<script>\n" + std::string(text) + "\n</script>\n";
}

std::string head(const std::string& title) {
  return "<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>" +
         html::escape(title) + "</title>\n<style>\n" + std::string(report_asset("style")) + "</style>\n</head>\n";
}

/// What the figures show SI values in.
std::string units() {
  Json all = Json::object();
  const auto put = [&](std::string_view si, const ShownUnit& unit) {
    all[std::string(si)] = {{"name", unit.name}, {"factor", unit.factor}, {"more", unit.more}};
  };
  for (const ShownUnit& unit : shown_units(units_in_use())) put(unit.si, unit);
  put("section", section_length());
  return "<script type=\"application/json\" id=\"shown-units\">" + html::escape_json(all.dump()) + "</script>\n";
}

std::string scripts(const std::string& data, const std::vector<const char*>& names) {
  std::string out = "<script type=\"application/json\" id=\"results-data\">" + html::escape_json(data) + "</script>\n";
  out += units();
  for (const char* name : names) out += script(report_asset(name));
  return out;
}

std::string page_of(const std::string& title, const std::string& body, const std::string& all_scripts) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + head(title) + "<body>\n<main>\n" + body + "</main>\n" + all_scripts +
         "</body>\n</html>\n";
}

/// Text as a string of CSS within HTML.
std::string css_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const bool plain = c != '"' && c != '\\' && c != '<' && c != '&' && static_cast<unsigned char>(c) >= 0x20;
    out += plain ? std::string(1, c) : fmt::format("\\{:x} ", static_cast<unsigned char>(c));
  }
  return out + "\"";
}

/// Scripts in their order, by the object of the data that they draw; "" for all pages.
using ScriptsOfObject = std::pair<const char*, std::vector<const char*>>;
const std::vector<ScriptsOfObject>& object_scripts() {
  static const std::vector<ScriptsOfObject> kScripts = {
      {"", {"d3", "data", "chart"}},
      {"stations", {"along", "diagrams", "envelopes", "checks", "fatigue"}},
      {"", {"in_time", "histories"}},
      {"stations", {"bars", "contacts"}},
      {"", {"moorings"}},
      {"lines", {"lines"}},
      {"", {"seek"}},
      {"stations", {"compared_tensioner", "compared_contact", "side_view", "painter", "scene"}},
      {"", {"main"}}};
  return kScripts;
}

}  // namespace

std::string page_margins(const PageMargins& margins) {
  constexpr const char* kLook = "font: 8pt Arial, \"Liberation Sans\", sans-serif; color: #5b6b7a;";
  const auto box = [&](const char* place, const std::string& text) {
    return fmt::format("@{} {{ content: {}; {} }} ", place, css_string(text), kLook);
  };
  return "<style>@page { " + box("top-left", margins.document.empty() ? margins.title : margins.document) +
         box("top-right", margins.document.empty() ? margins.kind : margins.title) +
         box("bottom-left", margins.kind + ", " + margins.written) + "}</style>\n";
}

std::string whole_page(const std::string& title, const std::string& body, const Json& data) {
  std::vector<const char*> names;
  for (const auto& [object, scripts] : object_scripts()) {
    if (*object == '\0' || data.contains(object)) names.insert(names.end(), scripts.begin(), scripts.end());
  }
  return page_of(title, body, scripts(json_text(data), names));
}

std::string operation_page(const std::string& title, const std::string& body, const Json& data) {
  std::vector<const char*> names = {"d3", "data", "chart", "stages"};
  if (data.contains("seek")) names.emplace_back("seek");
  names.emplace_back("main");
  return page_of(title, body, scripts(json_text(data), names));
}

std::string lay_table_frame(const std::string& title, const std::string& body, const std::string& data) {
  return page_of(title, body, scripts(data, {"d3", "data", "chart", "lay_table", "main"}));
}

std::string overlay_frame(const std::string& title, const std::string& body, const std::string& data) {
  return page_of(title, body, scripts(data, {"d3", "data", "chart", "overlay", "main"}));
}

std::string study_frame(const std::string& title, const std::string& body, const std::string& data) {
  return page_of(title, body, scripts(data, {"d3", "data", "chart", "study", "operability", "main"}));
}

void write_page(const std::string& page, const std::filesystem::path& file) {
  replace_file(file, page);
}

std::string written_now() {
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
}

}  // namespace overbend
