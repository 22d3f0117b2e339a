#include "report/front_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "report/html.h"
#include "report/places.h"
#include "report/sections.h"

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
std::string bar(const UtilisationBar& one) {
  constexpr double kWhole = 1.25;
  return fmt::format(
      "<div class=\"bar{}\"><div class=\"region\">{}</div><div class=\"track\"><div style=\"width:{}%\"></div></div>"
      "<div class=\"value\">{}</div><div class=\"what\">{}</div></div>\n",
      one.utilisation > 1.0 ? " over" : "", escape(one.title),
      fixed(100.0 * std::clamp(one.utilisation / kWhole, 0.0, 1.0), 1), fixed(one.utilisation, 3), escape(one.what));
}

UtilisationBar bar_of(const StaticResults& statics, const CheckRow& row) {
  const std::string when = row.in_time ? ", t = " + fixed(row.time, 1) + " s" : "";
  return {region_title(row.region), row.utilisation,
          fmt::format("{}, {}; {}{}", row.name, row.code, place_name(statics, row.s), when)};
}

std::string card(const std::string& heading, const std::vector<UtilisationBar>& bars, const std::string& note) {
  if (bars.empty()) return "";
  std::string all;
  for (const UtilisationBar& one : bars) all += bar(one);
  return "<div class=\"card\"><h3>" + escape(heading) + "</h3>\n" + all + "<p class=\"small\">" + escape(note) +
         "</p></div>\n";
}

std::string utilisation_card(const StaticResults& statics, const CheckTable& checks, const FrontPage& page) {
  std::vector<UtilisationBar> bars;
  for (const CheckRegion region : check_regions()) {
    if (const CheckRow* row = governing_check(checks, region)) bars.push_back(bar_of(statics, *row));
  }
  bars.insert(bars.end(), page.more.begin(), page.more.end());
  return card("Utilisation, governing check of each region", bars,
              "The mark on the bar is the full capacity. " + page.reach +
                  " The formulas have not been compared with the printed standards.");
}

std::string verdict_section(const Verdict& verdict, const std::string& utilisations) {
  return fmt::format(
      "<section id=\"verdict\">\n<div class=\"verdict {}\"><div class=\"words\">{}</div><div class=\"because\">{}"
      "</div></div>\n{}</section>\n",
      css_of(verdict.kind), escape(verdict.words), escape(verdict.because), utilisations);
}

std::string laid_out(const FrontPage& page, const std::string& verdict, const std::string& rest) {
  return "<div class=\"front\">\n" + title_block(page.kind, page.title, page.entries, control_box(page.control)) +
         verdict + warnings_section(page.warnings) + contents(rest) + "</div>\n<div class=\"sections\">\n" + rest +
         "</div>\n";
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
  return laid_out(page, verdict_section(verdict_of(checks, page.warnings), utilisation_card(statics, checks, page)),
                  rest);
}

std::string front_page(const FrontPage& page, const Verdict& verdict, const std::string& note,
                       const std::string& rest) {
  return laid_out(page, verdict_section(verdict, card("Utilisation", page.more, page.reach + " " + note)), rest);
}

}  // namespace overbend
