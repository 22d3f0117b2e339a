#include "report/page/front_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>
#include <utility>

#include "report/page/calculation_sheet.h"
#include "report/page/html.h"
#include "report/page/places.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

using html::escape;
using html::fixed;

/// The box that a document carries: all of its cells as soon as one is filled, so that the others can be by hand.
std::string control_box(const ReportDescription& control) {
  const std::array<std::pair<const char*, std::string>, 6> cells = {{{"Client", control.client},
                                                                     {"Project", control.project},
                                                                     {"Document", control.document},
                                                                     {"Revision", control.revision},
                                                                     {"Prepared", control.prepared},
                                                                     {"Checked", control.checked}}};
  std::string out;
  bool any = false;
  for (const auto& [name, value] : cells) {
    any = any || !value.empty();
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, value.empty() ? "&nbsp;" : escape(value));
  }
  return any ? "<dl class=\"control\">" + out + "</dl>\n" : "";
}

std::string upper_first(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

const char* css_of(VerdictKind kind) {
  constexpr std::array<const char*, 4> kCss = {"passed", "reserved", "exceeded", "open"};
  return kCss[static_cast<std::size_t>(kind)];
}

/// A bar whose whole length is 1.25 of the capacity.
std::string bar(const Utilisation& one) {
  constexpr double kWhole = 1.25;
  return fmt::format(
      "<div class=\"bar{}\"><div class=\"region\">{}</div><div class=\"track\"><div style=\"width:{}%\"></div></div>"
      "<div class=\"value\">{}</div><div class=\"what\">{}</div></div>\n",
      one.utilisation > 1.0 ? " over" : "", escape(one.title),
      fixed(100.0 * std::clamp(one.utilisation / kWhole, 0.0, 1.0), 1), fixed(one.utilisation, 3), escape(one.what));
}

Utilisation bar_of(const StaticResults& statics, const CheckRow& row) {
  const std::string when = row.in_time ? ", t = " + fixed(row.time, 1) + " s" : "";
  return {region_title(row.region), row.utilisation,
          fmt::format("{}, {}; {}{}", row.name, row.code, place_name(statics, row), when)};
}

/// Without bars what the verdict is of.
std::string card(const std::string& heading, const std::vector<Utilisation>& bars, const std::string& note,
                 const std::string& reach) {
  if (bars.empty()) return "<p class=\"small\">" + escape(reach) + "</p>\n";
  std::string all;
  for (const Utilisation& one : bars) all += bar(one);
  return "<div class=\"card\"><h3>" + escape(heading) + "</h3>\n" + all + "<p class=\"small\">" + escape(note) +
         "</p></div>\n";
}

/// Of rows on lines, anchors and cables: they have names of their own.
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

/// Without the rows on lines, anchors and cables, which have bars of their own.
CheckTable without_lines(CheckTable checks) {
  std::erase_if(checks.rows, [](const CheckRow& row) { return !line_title(row).empty(); });
  return checks;
}

std::string utilisation_card(const StaticResults& statics, const CheckTable& checks, const FrontPage& page) {
  constexpr const char* kCapacity = "The mark on the bar is the full capacity, with its safety factor. ";
  std::vector<Utilisation> bars;
  const CheckTable others = without_lines(checks);
  for (const CheckRegion region : check_regions()) {
    if (const CheckRow* row = governing_check(others, region)) bars.push_back(bar_of(statics, *row));
  }
  add_line_bars(checks, bars);
  return card("Utilisation, governing check of each region", bars, kCapacity + page.reach + " " + kBasisOfChecks,
              page.reach);
}

std::string verdict_section(const Verdict& verdict, const std::string& utilisations) {
  return fmt::format(
      "<section id=\"verdict\">\n<div class=\"verdict {}\"><div class=\"words\">{}</div><div class=\"because\">{}"
      "</div></div>\n{}</section>\n",
      css_of(verdict.kind), escape(verdict.words), escape(verdict.because), utilisations);
}

/// "BGL-OB-001, rev. B"; empty where neither is given.
std::string document_number(const ReportDescription& control) {
  if (control.revision.empty()) return control.document;
  return control.document + (control.document.empty() ? "" : ", ") + "rev. " + control.revision;
}

std::string laid_out(const FrontPage& page, const std::string& verdict, const std::string& rest) {
  return "<div class=\"front\">\n" +
         title_block(page.kind, page.title, page.entries, control_box(page.control), document_number(page.control)) +
         verdict + findings_section(page.findings) + contents(rest) + "</div>\n<div class=\"sections\">\n" + rest +
         "</div>\n";
}

/// A message on a file begins with its name, which stays as it is written.
std::string sentence(const Finding& finding) {
  const bool of_file = finding.code == FindingCode::unusual_input || finding.code == FindingCode::unused_input;
  return of_file ? finding.message : upper_first(finding.message);
}

std::string finding_list(std::span<const Finding> findings) {
  std::string items;
  for (const Finding& finding : findings) {
    const std::string severity = name(finding.severity());
    items += fmt::format("<li class=\"{}\"><b>{}</b> {} <span class=\"code\">{}</span></li>\n", severity,
                         upper_first(severity), escape(sentence(finding)), kind(finding.code).name);
  }
  return "<ul>\n" + items + "</ul>\n";
}

}  // namespace

std::string findings_section(const Findings& findings) {
  constexpr std::size_t kShown = 6;  // more would push the contents off the first page
  if (findings.empty()) return "";
  const Findings sorted = sorted_by_severity(findings);
  const std::size_t shown = std::min(sorted.size(), kShown);
  const std::span<const Finding> all(sorted);
  std::string body = finding_list(all.first(shown));
  if (shown < sorted.size()) {
    body += html::folded(fmt::format("{} more", sorted.size() - shown), finding_list(all.subspan(shown)));
  }
  return "<section id=\"findings\" class=\"findings\">\n<h2>Findings</h2>\n" + body + "</section>\n";
}

std::string contents(const std::string& sections) {
  constexpr const char* kSection = "<section id=\"";
  constexpr const char* kHeading = "<h2>";
  std::string items;
  for (std::size_t at = sections.find(kSection); at != std::string::npos; at = sections.find(kSection, at + 1)) {
    const std::size_t id = at + std::string(kSection).size();
    const std::size_t heading = sections.find(kHeading, id) + std::string(kHeading).size();
    items += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", sections.substr(id, sections.find('"', id) - id),
                         sections.substr(heading, sections.find("</h2>", heading) - heading));
  }
  return "<nav id=\"contents\">\n<h2>Contents</h2>\n<ol>\n" + items + "</ol>\n</nav>\n";
}

std::string front_page(const FrontPage& page, const StaticResults& statics, const CheckTable& checks,
                       const std::string& rest) {
  return laid_out(page, verdict_section(make_verdict(checks, page.findings), utilisation_card(statics, checks, page)),
                  rest);
}

std::string front_page(const FrontPage& page, const Verdict& verdict, const std::vector<Utilisation>& bars,
                       const std::string& note, const std::string& rest) {
  return laid_out(page, verdict_section(verdict, card("Utilisation", bars, note + page.reach, page.reach)), rest);
}

}  // namespace overbend
