#include "report/moored/lines_section.h"

#include <fmt/format.h>

#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

using html::fixed;

std::string tiles(const std::vector<LineResult>& lines, const DynamicResults* dynamics) {
  std::string out = "<div class=\"tiles\">\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LineResult& line = lines[i];
    const double most = dynamics != nullptr ? dynamics->lines[i].largest_tension : line.largest_tension;
    const double least = dynamics != nullptr ? dynamics->lines[i].least_tension : line.least_tension;
    out += html::tile(
        "Tension along " + line.name, shown_number(least, "N", 2) + " to " + shown_number(most, "N", 2), forces().unit,
        dynamics != nullptr ? fmt::format("over time; at rest {} to {}", shown_number(line.least_tension, "N", 2),
                                          shown_number(line.largest_tension, "N", 2))
                            : std::string("at rest"));
  }
  return out + "</div>\n";
}

std::string line_table(const std::vector<LineResult>& lines) {
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
  for (const LineResult& line : lines) {
    table.row({line.name, shown_number(line.length, "m", 2), shown_number(line.on_bed, "m", 1),
               shown_number(line.weight, "N", 2), shown_number(line.least_tension, "N", 2),
               shown_number(line.largest_tension, "N", 2), line.utilisation ? fixed(100.0 * *line.utilisation, 1) : "-",
               std::to_string(line.elements), fmt::format("{:.1e}", line.residual)});
  }
  return table.str();
}

std::string end_table(const std::vector<LineResult>& lines, const DynamicResults* dynamics) {
  std::vector<html::Head> head = {
      {"Line", "", true},         {"End", "", true},       {"Tension", shown_name("N")},      {"east", shown_name("N")},
      {"north", shown_name("N")}, {"up", shown_name("N")}, {"Declination", shown_name("rad")}};
  std::vector<std::pair<std::string, int>> groups = {{"", 3}, {"Force on the line", 3}, {"", 1}};
  if (dynamics != nullptr) {
    for (const char* name : {"min", "max", "mean", "std"}) head.push_back({name, shown_name("N")});
    groups.emplace_back("Tension over time", 4);
  }
  html::Table table("Ends of the lines", head, "dense summary");
  table.groups(groups);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto add = [&](const char* name, const LineEndResult& end, const Spread* in_time) {
      std::vector<std::string> cells = {lines[i].name,
                                        name,
                                        shown_number(end.tension, "N", 2),
                                        shown_number(end.force.x(), "N", 2),
                                        shown_number(end.force.y(), "N", 2),
                                        shown_number(end.force.z(), "N", 2),
                                        shown_number(end.declination, "rad", 2)};
      if (in_time != nullptr) {
        for (const double value : {in_time->min, in_time->max, in_time->mean, in_time->std}) {
          cells.push_back(shown_number(value, "N", 2));
        }
      }
      table.row(cells);
    };
    const LineDynamics* const moved = dynamics != nullptr ? &dynamics->lines[i] : nullptr;
    add("first", lines[i].first, moved != nullptr ? &moved->first_tension : nullptr);
    add("second", lines[i].second, moved != nullptr ? &moved->second_tension : nullptr);
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

std::string figures(std::size_t count, bool moved, int& number) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < count; ++i) lines.push_back(std::to_string(i));
  std::string out = figure_of("line_shape", lines, number, "Shape at rest, in the vertical plane of the ends");
  out += figure_of(
      "line_tension", lines, number,
      moved ? "Tension along the line: at rest, and its range over time (band)" : "Tension along the line at rest");
  if (moved) {
    out += figure_of("history", {"ends"}, number,
                     "Tension at the ends in time; the build-up is shaded. Values refer to all steps, curves to the "
                     "output steps");
  }
  return out;
}

}  // namespace

std::string lines_section(const StaticResults& statics, const DynamicResults* dynamics, int& figure) {
  const std::vector<LineResult>& lines = statics.lines;
  if (lines.empty()) return "";
  const std::string drawn = figures(lines.size(), dynamics != nullptr, figure);
  return html::section("lines", "Lines",
                       tiles(lines, dynamics) + drawn + line_table(lines) + end_table(lines, dynamics));
}

}  // namespace overbend
