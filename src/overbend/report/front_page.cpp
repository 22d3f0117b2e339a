#include "report/front_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "report/html.h"
#include "report/places.h"
#include "report/sections.h"
#include "report/verdict.h"

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

const char* css_of(VerdictKind kind) {
  constexpr std::array<const char*, 4> kCss = {"passed", "reserved", "exceeded", "open"};
  return kCss[static_cast<std::size_t>(kind)];
}

/// A bar whose whole length is 1.25 of the capacity.
std::string bar(const StaticResults& statics, const CheckRow& row) {
  constexpr double kWhole = 1.25;
  const bool over = row.status == CheckStatus::exceeded;
  const std::string when = row.in_time ? ", t = " + fixed(row.time, 1) + " s" : "";
  return fmt::format(
      "<div class=\"bar{}\"><div class=\"region\">{}</div><div class=\"track\"><div style=\"width:{}%\"></div></div>"
      "<div class=\"value\">{}</div><div class=\"what\">{}, {}; {}{}</div></div>\n",
      over ? " over" : "", escape(region_title(row.region)),
      fixed(100.0 * std::clamp(row.utilisation / kWhole, 0.0, 1.0), 1), fixed(row.utilisation, 3), escape(row.name),
      escape(row.code), escape(place_name(statics, row.s)), when);
}

std::string utilisation_card(const StaticResults& statics, const CheckTable& checks, const std::string& reach) {
  std::string bars;
  for (const CheckRegion region : check_regions()) {
    if (const CheckRow* row = governing_check(checks, region)) bars += bar(statics, *row);
  }
  if (bars.empty()) return "";
  return "<div class=\"card\"><h3>Utilisation, governing check of each region</h3>\n" + bars +
         "<p class=\"small\">The mark on the bar is the full capacity. " + escape(reach) +
         " The formulas have not been compared with the printed standards.</p></div>\n";
}

std::string verdict_section(const FrontPage& page, const StaticResults& statics, const CheckTable& checks) {
  const Verdict verdict = verdict_of(checks, page.warnings);
  return fmt::format(
      "<section id=\"verdict\">\n<div class=\"verdict {}\"><div class=\"words\">{}</div><div class=\"because\">{}"
      "</div></div>\n{}</section>\n",
      css_of(verdict.kind), escape(verdict.words), escape(verdict.because),
      utilisation_card(statics, checks, page.reach));
}

std::string lower(const char* text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::tolower(c); });
  return out;
}

std::string warning_list(const std::vector<WeighedWarning>& warnings) {
  std::string items;
  for (const WeighedWarning& warning : warnings) {
    items += fmt::format("<li class=\"{}\"><b>{}</b> {}</li>\n", lower(word(warning.weight)), word(warning.weight),
                         escape(warning.text));
  }
  return "<ul>\n" + items + "</ul>\n";
}

}  // namespace

std::string warnings_section(const std::vector<WeighedWarning>& warnings) {
  constexpr std::size_t kShown = 6;  // more would push the contents off the first page
  if (warnings.empty()) return "";
  const auto cut = warnings.begin() + static_cast<std::ptrdiff_t>(std::min(warnings.size(), kShown));
  std::string body = warning_list({warnings.begin(), cut});
  if (cut != warnings.end()) {
    body += html::folded(fmt::format("{} more", warnings.end() - cut), warning_list({cut, warnings.end()}));
  }
  return "<section id=\"warnings\" class=\"warnings\">\n<h2>Warnings</h2>\n" + body + "</section>\n";
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
  return "<div class=\"front\">\n" + title_block(page.kind, page.title, page.entries, control_box(page.control)) +
         verdict_section(page, statics, checks) + warnings_section(page.warnings) + contents(rest) +
         "</div>\n<div class=\"sections\">\n" + rest + "</div>\n";
}

}  // namespace overbend
