// The report of lines by themselves.
#include <fmt/format.h>

#include <algorithm>

#include "report/moored/line_data.h"
#include "report/page/front_of.h"
#include "report/page/html.h"
#include "report/page/page.h"
#include "report/page/quantity.h"
#include "report/page/sea_words.h"
#include "report/page/sections.h"
#include "report/report.h"
#include "report/static/criteria_section.h"
#include "report/studies/report_data.h"

namespace overbend {
namespace {

using html::fixed;

std::string tiles(const LinesResults& results) {
  std::string out = "<div class=\"tiles\">\n";
  for (const LineResult& line : results.lines) {
    const double most = results.moved ? line.largest_in_time : line.largest_tension;
    const double least = results.moved ? line.least_in_time : line.least_tension;
    out += html::tile(
        "Tension along " + line.name, shown_number(least, "N", 2) + " to " + shown_number(most, "N", 2), forces().unit,
        results.moved ? fmt::format("over time; at rest {} to {}", shown_number(line.least_tension, "N", 2),
                                    shown_number(line.largest_tension, "N", 2))
                      : std::string("at rest"));
  }
  return out + "</div>\n";
}

std::string line_table(const LinesResults& results) {
  html::Table table("Lines at rest",
                    {{"Line", "", true},
                     {"Length", shown_name("m")},
                     {"On bed", shown_name("m")},
                     {"Submerged weight", shown_name("N")},
                     {"Least", shown_name("N")},
                     {"Largest", shown_name("N")},
                     {"Breaking load", "%"},
                     {"Elements", ""},
                     {"Unbalanced", "of weight"}},
                    "dense summary");
  table.groups({{"", 4}, {"Tension", 2}, {"", 3}});
  for (const LineResult& line : results.lines) {
    table.row({line.name, shown_number(line.length, "m", 2), shown_number(line.on_bed, "m", 1),
               shown_number(line.weight, "N", 2), shown_number(line.least_tension, "N", 2),
               shown_number(line.largest_tension, "N", 2), line.utilisation ? fixed(100.0 * *line.utilisation, 1) : "-",
               std::to_string(line.elements), fmt::format("{:.1e}", line.residual)});
  }
  return table.str();
}

std::string end_table(const LinesResults& results) {
  std::vector<html::Head> head = {
      {"Line", "", true},         {"End", "", true},       {"Tension", shown_name("N")},      {"east", shown_name("N")},
      {"north", shown_name("N")}, {"up", shown_name("N")}, {"Declination", shown_name("rad")}};
  std::vector<std::pair<std::string, int>> groups = {{"", 3}, {"Force on the line", 3}, {"", 1}};
  if (results.moved) {
    for (const char* name : {"min", "max", "mean", "std"}) head.push_back({name, shown_name("N")});
    groups.emplace_back("Tension over time", 4);
  }
  html::Table table("Ends of the lines", head, "dense summary");
  table.groups(groups);
  for (const LineResult& line : results.lines) {
    for (const auto& [name, end] : {std::pair{"first", &line.first}, {"second", &line.second}}) {
      std::vector<std::string> cells = {line.name,
                                        name,
                                        shown_number(end->tension, "N", 2),
                                        shown_number(end->force.x(), "N", 2),
                                        shown_number(end->force.y(), "N", 2),
                                        shown_number(end->force.z(), "N", 2),
                                        shown_number(end->declination, "rad", 2)};
      if (results.moved) {
        for (const double value : {end->in_time.min, end->in_time.max, end->in_time.mean, end->in_time.std}) {
          cells.push_back(shown_number(value, "N", 2));
        }
      }
      table.row(cells);
    }
  }
  return table.str() +
         "<p class=\"small\">At rest: tension, components of the force by what holds the end, and declination of the "
         "line below horizontal, positive where it hangs from its end.</p>\n";
}

/// A figure with as many panels as there are parts.
std::string figure_of(const std::string& id, const std::vector<std::string>& parts, int& number,
                      const std::string& caption) {
  std::string out = "<figure>\n";
  for (const std::string& part : parts) {
    out += fmt::format("<div class=\"panel\" data-figure=\"{}\" data-part=\"{}\"></div>\n", id, part);
  }
  return out + fmt::format("<figcaption>Figure {}. {}</figcaption>\n</figure>\n", ++number, html::escape(caption));
}

std::string figures(const LinesResults& results) {
  int number = 0;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < results.lines.size(); ++i) lines.push_back(std::to_string(i));
  std::string out = figure_of("line_shape", lines, number, "Shape at rest, in the vertical plane of the ends");
  out += figure_of("line_tension", lines, number,
                   results.moved ? "Tension along the line: at rest, and its range over time (band)"
                                 : "Tension along the line at rest");
  if (results.moved) {
    out += figure_of("history", {"ends"}, number,
                     "Tension at the ends in time; the build-up is shaded. Values refer to all steps, curves to the "
                     "output steps");
  }
  return out;
}

FrontPage lines_front(const LinesResults& results, const std::optional<Description>& description) {
  FrontPage front = front_of(results.moved ? "Dynamic analysis of lines" : "Static analysis of lines", results.title,
                             description, results.findings);
  front.reach =
      results.moved ? "Maxima of a single run of " + duration_words(duration_of(results)) + "." : "Static state only.";
  front.entries.emplace_back("Lines", std::to_string(results.lines.size()));
  if (results.moved) {
    if (description) front.entries.emplace_back("Sea", sea_words(description->environment.waves));
    front.entries.emplace_back("Duration", duration_words(duration_of(results)) + " after a build-up of " +
                                               duration_words(build_up_of(results)));
    front.entries.emplace_back("Energy drift", fixed(100.0 * results.energy_drift, 4) + " %");
  }
  front.entries.emplace_back("Status", status_words(results.moved ? "completed" : "converged", front.findings.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
  return front;
}

}  // namespace

std::string report_html(const LinesResults& results, const std::string& model_text) {
  const std::optional<Description> description = description_of(model_text);
  const std::string rest =
      criteria_section(results.checks, description) +
      html::section("lines", "Lines", tiles(results) + figures(results) + line_table(results) + end_table(results)) +
      (description ? inputs_section(*description) : "") + assumptions_section(results.assumptions) +
      model_text_section(model_text);
  const FrontPage front = lines_front(results, description);
  return page_without_pipe(results.title + " - analysis of lines", front_page(front, results.checks, rest),
                           report_data(results, description));
}

void write_report(const LinesResults& results, const std::string& model_text, const std::filesystem::path& file) {
  write_page(report_html(results, model_text), file);
}

}  // namespace overbend
