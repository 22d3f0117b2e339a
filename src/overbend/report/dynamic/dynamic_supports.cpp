#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/ranges.h"
#include "report/dynamic/dynamic_contacts.h"
#include "report/dynamic/dynamic_sections.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

/// "never" and "always" are distinguished from fractions that only round to them.
std::string share(double part) {
  if (part <= 0.0) return "0";
  if (part >= 1.0) return "100";
  return fixed(std::min(std::max(100.0 * part, 0.1), 99.9), 1);
}

/// The boxes that the pipe left, in the order of time; empty if there are none.
Blocks left_boxes(const DynamicResults& results) {
  std::vector<std::pair<double, std::string>> left;
  for (const SupportDynamics& box : results.supports) {
    if (box.left_to_port) left.emplace_back(*box.left_to_port, box.name + ", to port");
    if (box.left_to_starboard) left.emplace_back(*box.left_to_starboard, box.name + ", to starboard");
  }
  if (left.empty()) return {};
  ranges::stable_sort(left, {}, &std::pair<double, std::string>::first);
  std::string text;
  for (const auto& [time, side] : left) {
    text += (text.empty() ? "" : ", ") + fmt::format("{} at t = {:.1f} s", side, time);
  }
  return block::paragraph("The pipe left these boxes: " + text + ".");
}

Blocks support_table(const DynamicResults& results) {
  Table table{"Roller boxes over time",
              {TableColumn("Box"),
               TableColumn("On"),
               {"static", "N", 1},
               {"min", "N", 1},
               {"mean", "N", 1},
               {"99 %", "N", 1},
               {"max", "N", 1},
               {"std", "N", 1},
               {"vertical max", "N", 1},
               TableColumn::texts("lateral range", shown_name("N")),
               {"static", "m", 4},
               {"min", "m", 4},
               {"max", "m", 4},
               TableColumn::texts("Contact", "% of time"),
               {"count", "", 0},
               {"largest", "N", 1}},
              "dense boxes"};
  table.groups({{"", 2}, {"Reaction on the pipe, resultant", 8}, {"Separation", 3}, {"", 1}, {"Impacts", 2}});
  for (const SupportDynamics& box : results.supports) {
    double impact = 0.0;
    for (const RollerDynamics& r : box.rollers) impact = std::max(impact, r.max_impact_force);
    table.row({box.name, box.stinger ? "stinger" : "ramp", box.static_reaction, box.reaction.min, box.reaction.mean,
               box.reaction_over_time.p99, box.reaction.max, box.reaction.std, box.vertical.max,
               forces().text(box.lateral.min, 1) + " to " + forces().text(box.lateral.max, 1), box.static_separation,
               box.separation.min, box.separation.max, share(box.contact_share), box.impact_count,
               box.impact_count > 0 ? TableCell(impact) : TableCell()},
              box.static_reaction > 0.0 || box.contact_share > 0.0 ? RowMark::loaded : RowMark::none);
  }
  return Blocks(table) +
         block::remark(
             "99 %: 99th percentile over time. Lateral: positive to port. Separation: clear distance between pipe "
             "and roller, the smallest of the box's bottom rollers; negative is penetration due to the contact "
             "stiffness. Contact: share of time with any roller of the box in contact.") +
         left_boxes(results);
}

Blocks roller_table(const DynamicResults& results) {
  Table table{"",
              {TableColumn("Box"),
               {"Row", "", 0},
               TableColumn("Roller"),
               {"static", "N", 2},
               {"mean", "N", 2},
               {"max", "N", 2},
               {"static", "m", 4},
               {"min", "m", 4},
               {"max", "m", 4},
               TableColumn::texts("Contact", "% of time"),
               {"count", "", 0},
               {"approach", "m/s", 3},
               {"force", "N", 2},
               {"impulse", impulse(), 1},
               {"dent", section_length(), 2},
               {"line load", "N/m", 1}},
              "dense rollers"};
  table.groups({{"", 3}, {"Reaction", 3}, {"Separation", 3}, {"", 1}, {"Impacts, largest", 4}, {"Largest force", 2}});
  for (const SupportDynamics& box : results.supports) {
    for (const RollerDynamics& r : box.rollers) {
      const bool touched = r.contact_share > 0.0;
      const auto of_impact = [&](double value) { return r.impact_count > 0 ? TableCell(value) : TableCell(); };
      const auto of_touch = [&](double value) { return touched ? TableCell(value) : TableCell(); };
      table.row({box.name, r.row + 1, word(r.position), r.static_reaction, r.reaction.mean, r.reaction.max,
                 r.static_separation, r.separation.min, r.separation.max, share(r.contact_share), r.impact_count,
                 of_impact(r.max_approach_velocity), of_impact(r.max_impact_force), of_impact(r.max_impulse),
                 of_touch(r.dent_depth), of_touch(r.line_load)},
                touched ? RowMark::loaded : RowMark::none);
    }
  }
  return block::folded(fmt::format("All {} rollers", table.rows.size()), table);
}

/// The impacts from index `first` to `last`, exclusive.
Table impact_table(const std::string& title, const DynamicResults& results, std::size_t first, std::size_t last) {
  Table table{title,
              {{"No.", "", 0},
               {"Time", "s", 2},
               TableColumn("Box"),
               {"Row", "", 0},
               TableColumn("Roller"),
               {"Approach velocity", "m/s", 3},
               {"Peak force", "N", 2},
               {"Duration", "ms", 2},
               {"Impulse", impulse(), 1},
               {"Dent depth", section_length(), 3},
               {"Line load", "N/m", 1}},
              "dense"};
  for (std::size_t i = first; i < last; ++i) {
    const Impact& impact = results.hardest_impacts[i];
    const RollerPlace place = find_roller(results, impact.roller);
    std::vector<TableCell> cells = {i + 1, impact.time, "", "", ""};
    if (place.roller != nullptr) {
      cells = {i + 1, impact.time, place.box->name, place.roller->row + 1, word(place.roller->position)};
    }
    cells.insert(cells.end(), {impact.approach_velocity, impact.peak_force, 1e3 * impact.duration, impact.impulse,
                               impact.dent_depth, impact.line_load});
    table.row(cells);
  }
  return table;
}

}  // namespace

Blocks dynamic_supports_section(const DynamicResults& results) {
  if (results.supports.empty()) return {};
  return block::section("dynamic-supports", "Supports over time", support_table(results));
}

Blocks dynamic_rollers_section(const DynamicResults& results) {
  return block::section("dynamic-rollers", "Appendix: individual rollers over time", roller_table(results));
}

Blocks impacts_section(const StaticResults& statics, const DynamicResults& results) {
  if (statics.supports.empty()) return {};
  const std::size_t count = results.hardest_impacts.size(), first = std::min<std::size_t>(count, 20);
  if (count == 0) {
    return block::section("impacts", "Impacts", block::paragraph("The pipe never lands on a roller after leaving it."));
  }
  const std::string title = first < static_cast<std::size_t>(results.impact_count)
                                ? fmt::format("The {} hardest of {}", first, results.impact_count)
                                : "All impacts, hardest first";
  return block::section(
      "impacts", "Impacts",
      impact_table(title, results, 0, first) +
          block::folded(fmt::format("The next {}", count - first), impact_table("", results, first, count), false) +
          block::remark(
              "Duration: from first contact until the pipe leaves the roller or rests on it. Dent depth: in bare steel "
              "under the peak force, neglecting the coating. Line load: peak force over the length of the coating "
              "under the roller."));
}

}  // namespace overbend
