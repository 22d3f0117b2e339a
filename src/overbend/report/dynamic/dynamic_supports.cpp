#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "report/dynamic/dynamic_contacts.h"
#include "report/dynamic/dynamic_sections.h"
#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

using html::fixed;

/// "never" and "always" are distinguished from fractions that only round to them.
std::string share(double part) {
  if (part <= 0.0) return "0";
  if (part >= 1.0) return "100";
  return fixed(std::min(std::max(100.0 * part, 0.1), 99.9), 1);
}

/// The boxes that the pipe left, in the order of time; empty where it stayed on all.
std::string left_boxes(const DynamicResults& results) {
  std::vector<std::pair<double, std::string>> left;
  for (const SupportDynamics& box : results.supports) {
    if (box.left_to_port) left.emplace_back(*box.left_to_port, box.name + " to port");
    if (box.left_to_starboard) left.emplace_back(*box.left_to_starboard, box.name + " to starboard");
  }
  if (left.empty()) return "";
  std::stable_sort(left.begin(), left.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (const auto& [time, words] : left) {
    text += (text.empty() ? "" : ", ") + fmt::format("{} at t = {:.1f} s", html::escape(words), time);
  }
  return "<p>The pipe left over their sides: " + text + ".</p>\n";
}

std::string support_table(const DynamicResults& results) {
  html::Table table("Roller boxes over time",
                    {{"Box", "", true},
                     {"On", "", true},
                     {"static", shown_name("N")},
                     {"min", shown_name("N")},
                     {"mean", shown_name("N")},
                     {"99 %", shown_name("N")},
                     {"max", shown_name("N")},
                     {"std", shown_name("N")},
                     {"vertical max", shown_name("N")},
                     {"lateral range", shown_name("N")},
                     {"static", shown_name("m")},
                     {"min", shown_name("m")},
                     {"max", shown_name("m")},
                     {"Contact", "% of time"},
                     {"count", ""},
                     {"largest", shown_name("N")}},
                    "dense boxes");
  table.groups({{"", 2}, {"Reaction on the pipe, resultant", 8}, {"Separation", 3}, {"", 1}, {"Impacts", 2}});
  for (const SupportDynamics& box : results.supports) {
    double impact = 0.0;
    for (const RollerDynamics& r : box.rollers) {
      impact = std::max(impact, r.largest_impact_force);
    }
    table.row({box.name, box.stinger ? "stinger" : "ramp", forces().text(box.static_reaction, 1),
               forces().text(box.reaction.min, 1), forces().text(box.reaction.mean, 1),
               forces().text(box.reaction_over_time.p99, 1), forces().text(box.reaction.max, 1),
               forces().text(box.reaction.std, 1), forces().text(box.vertical.max, 1),
               forces().text(box.lateral.min, 1) + " to " + forces().text(box.lateral.max, 1),
               shown_number(box.static_separation, "m", 4), shown_number(box.separation.min, "m", 4),
               shown_number(box.separation.max, "m", 4), share(box.contact_share), std::to_string(box.impact_count),
               box.impact_count > 0 ? forces().text(impact, 1) : ""},
              box.static_reaction > 0.0 || box.contact_share > 0.0 ? "loaded" : "");
  }
  return table.str() +
         "<p class=\"small\">99 %: 99th percentile over time. Lateral: positive to port. Separation: clear distance "
         "between pipe and roller, the smallest of the box's bottom rollers; negative is penetration due to the "
         "contact stiffness. Contact: any roller of the box "
         "carries.</p>\n" +
         left_boxes(results);
}

std::string roller_table(const DynamicResults& results) {
  html::Table table("",
                    {{"Box", "", true},
                     {"Row", ""},
                     {"Roller", "", true},
                     {"static", shown_name("N")},
                     {"mean", shown_name("N")},
                     {"max", shown_name("N")},
                     {"static", shown_name("m")},
                     {"min", shown_name("m")},
                     {"max", shown_name("m")},
                     {"Contact", "% of time"},
                     {"count", ""},
                     {"approach", shown_name("m/s")},
                     {"force", shown_name("N")},
                     {"impulse", std::string(impulse().name)},
                     {"dent", clearances().unit},
                     {"line load", shown_name("N/m")}},
                    "dense rollers");
  table.groups({{"", 3}, {"Reaction", 3}, {"Separation", 3}, {"", 1}, {"Impacts, largest", 4}, {"Largest force", 2}});
  int count = 0;
  for (const SupportDynamics& box : results.supports) {
    for (const RollerDynamics& r : box.rollers) {
      ++count;
      const bool hit = r.impact_count > 0;
      const bool touched = r.contact_share > 0.0;
      table.row({box.name, std::to_string(r.row + 1), word(r.position), forces().text(r.static_reaction, 2),
                 forces().text(r.reaction.mean, 2), forces().text(r.reaction.max, 2),
                 shown_number(r.static_separation, "m", 4), shown_number(r.separation.min, "m", 4),
                 shown_number(r.separation.max, "m", 4), share(r.contact_share), std::to_string(r.impact_count),
                 hit ? shown_number(r.largest_approach_velocity, "m/s", 3) : "",
                 hit ? forces().text(r.largest_impact_force, 2) : "",
                 hit ? shown_number(r.largest_impulse, impulse(), 1) : "", touched ? dents().text(r.dent_depth, 2) : "",
                 touched ? line_loads().text(r.line_load, 1) : ""},
                touched ? "loaded" : "");
    }
  }
  return html::folded(fmt::format("All {} rollers", count), table.str());
}

html::Table impact_table(const std::string& caption) {
  return html::Table(caption,
                     {{"No.", ""},
                      {"Time", "s"},
                      {"Box", "", true},
                      {"Row", ""},
                      {"Roller", "", true},
                      {"Approach velocity", shown_name("m/s")},
                      {"Peak force", shown_name("N")},
                      {"Duration", "ms"},
                      {"Impulse", std::string(impulse().name)},
                      {"Dent depth", clearances().unit},
                      {"Line load", shown_name("N/m")}},
                     "dense");
}

void impact_row(html::Table& table, const DynamicResults& results, std::size_t index) {
  const Impact& impact = results.hardest_impacts[index];
  const RollerPlace at = find_roller(results, impact.roller);
  table.row({std::to_string(index + 1), fixed(impact.time, 2), at.box != nullptr ? at.box->name : "",
             at.roller != nullptr ? std::to_string(at.roller->row + 1) : "",
             at.roller != nullptr ? word(at.roller->position) : "", shown_number(impact.approach_velocity, "m/s", 3),
             forces().text(impact.peak_force, 2), fixed(impact.duration * 1e3, 2),
             shown_number(impact.impulse, impulse(), 1), dents().text(impact.dent_depth, 3),
             line_loads().text(impact.line_load, 1)});
}

}  // namespace

std::string dynamic_supports_section(const DynamicResults& results) {
  if (results.supports.empty()) {
    return "";
  }
  return html::section("dynamic-supports", "Supports over time", support_table(results));
}

std::string dynamic_rollers_section(const DynamicResults& results) {
  return results.supports.empty()
             ? ""
             : html::section("dynamic-rollers", "Appendix: individual rollers over time", roller_table(results));
}

std::string impacts_section(const StaticResults& statics, const DynamicResults& results) {
  if (statics.supports.empty()) {
    return "";
  }
  constexpr std::size_t kPrinted = 20;
  const std::size_t count = results.hardest_impacts.size();
  if (count == 0) {
    return html::section("impacts", "Impacts", "<p>The pipe never lands on a roller after leaving it.</p>\n");
  }
  const std::size_t first = std::min(count, kPrinted);
  html::Table table = impact_table(first < static_cast<std::size_t>(results.impact_count)
                                       ? fmt::format("The {} hardest of {}", first, results.impact_count)
                                       : "All impacts, hardest first");
  for (std::size_t i = 0; i < first; ++i) {
    impact_row(table, results, i);
  }
  std::string body = table.str();
  if (count > first) {
    html::Table more = impact_table("");
    for (std::size_t i = first; i < count; ++i) {
      impact_row(more, results, i);
    }
    body += html::folded(fmt::format("The next {}", count - first), more.str(), false);
  }
  return html::section("impacts", "Impacts",
                       body +
                           "<p class=\"small\">Duration: from first contact until the pipe leaves the roller or rests "
                           "on it. Dent depth: in bare steel under the peak force, neglecting the coating. Line load: "
                           "peak force over the length of the "
                           "coating under the roller.</p>\n");
}

}  // namespace overbend
