#include "report/page/front_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "report/page/calculation_sheet.h"
#include "report/page/json_number.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

/// Document control: all cells as soon as one is filled, so that the others can be filled in by hand. Null if all are
/// empty.
Json control_box(const ReportDescription& control) {
  const std::array<std::pair<const char*, std::string>, 6> cells = {{{"Client", control.client},
                                                                     {"Project", control.project},
                                                                     {"Document", control.document},
                                                                     {"Revision", control.revision},
                                                                     {"Prepared", control.prepared},
                                                                     {"Checked", control.checked}}};
  Json box = Json::array();
  for (const auto& [name, value] : cells) box.push_back({name, value});
  const bool filled = ranges::any_of(cells, [](const auto& cell) { return !cell.second.empty(); });
  return filled ? box : Json();
}

std::string upper_first(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

Utilisation make_bar(const StaticResults& statics, const CheckRow& row) {
  const std::string when = row.in_time ? ", t = " + fixed(row.time, 1) + " s" : "";
  return {region_title(row.region), row.utilisation,
          fmt::format("{}, {}; {}{}", row.name, row.code, location_name(statics, row), when)};
}

/// Without bars, `reach` states the scope of the verdict.
Json utilisation_json(const std::string& heading, const std::vector<Utilisation>& bars, const std::string& note,
                      const std::string& reach) {
  Json list = Json::array();
  for (const Utilisation& bar : bars) {
    list.push_back({{"title", bar.title}, {"utilisation", json_number(bar.utilisation)}, {"what", bar.what}});
  }
  return {{"heading", heading}, {"bars", list}, {"note", bars.empty() ? reach : note}};
}

/// Title of a row on lines, anchors or cables, which have names.
std::string line_title(const CheckRow& row) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 5> kTitles = {
      {{"mooring_load", "Mooring lines"},
       {"mooring_working_load", "Working load"},
       {"anchor_load", "Anchors"},
       {"cable_load", "Cable"},
       {"line_load", "Lines"}}};
  for (const auto& [id, title] : kTitles) {
    if (row.id == id) return title;
  }
  return "";
}

/// A bar for each governing and judged check on lines, anchors and cables.
void add_line_bars(const CheckTable& checks, std::vector<Utilisation>& bars) {
  for (const CheckRow& row : checks.rows) {
    const std::string title = line_title(row);
    if (!title.empty() && row.governing && row.judged()) bars.push_back({title, row.utilisation, row.remark});
  }
}

/// Without the rows on lines, anchors and cables, which have separate bars.
CheckTable without_lines(CheckTable checks) {
  std::erase_if(checks.rows, [](const CheckRow& row) { return !line_title(row).empty(); });
  return checks;
}

Json region_utilisations(const StaticResults& statics, const CheckTable& checks, const FrontPage& page) {
  constexpr const char* kCapacity = "The mark on the bar is the full capacity, with its safety factor. ";
  std::vector<Utilisation> bars;
  const CheckTable others = without_lines(checks);
  for (const CheckRegion region : check_regions()) {
    if (const CheckRow* row = governing_check(others, region)) bars.push_back(make_bar(statics, *row));
  }
  add_line_bars(checks, bars);
  return utilisation_json("Utilisation, governing check of each region", bars,
                          kCapacity + page.reach + " " + kBasisOfChecks, page.reach);
}

/// A message on a file begins with the file name, whose case is kept.
std::string sentence(const Finding& finding) {
  const bool of_file = finding.code == FindingCode::unusual_input || finding.code == FindingCode::unused_input;
  return of_file ? finding.message : upper_first(finding.message);
}

Json sentences_json(const Findings& findings) {
  Json list = Json::array();
  for (const Finding& finding : sorted_by_severity(findings)) {
    list.push_back(
        {{"severity", name(finding.severity())}, {"text", sentence(finding)}, {"code", kind(finding.code).name}});
  }
  return list;
}

}  // namespace

Json front_page(const FrontPage& page) {
  Json front = {{"kind", page.kind}, {"title", page.title}, {"entries", Json::array()}};
  for (const auto& [name, value] : page.entries) front["entries"].push_back({name, value});
  if (Json box = control_box(page.control); !box.is_null()) front["control"] = std::move(box);
  front["findings"] = sentences_json(page.findings);
  return front;
}

Json front_page(const FrontPage& page, const StaticResults& statics, const CheckTable& checks) {
  Json front = front_page(page);
  front["verdict"] = verdict_json(make_verdict(checks, page.findings));
  front["utilisation"] = region_utilisations(statics, checks, page);
  return front;
}

Json front_page(const FrontPage& page, const Verdict& verdict, const std::vector<Utilisation>& bars,
                const std::string& note) {
  Json front = front_page(page);
  front["verdict"] = verdict_json(verdict);
  front["utilisation"] = utilisation_json("Utilisation", bars, note + page.reach, page.reach);
  return front;
}

}  // namespace overbend
