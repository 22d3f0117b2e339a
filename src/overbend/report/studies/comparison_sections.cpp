#include "report/studies/comparison_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/quantity.h"

namespace overbend {
namespace {

// The tensioner -----------------------------------------------------------------------------------------------------

std::string tension_statistics_text(const ComparedRun& run) {
  const SummaryStatistics& tension = run.results.tensioner.tension;
  return fmt::format("{}: {} to {}, standard deviation {}", run.label, shown_number(tension.min, "N", 1),
                     shown(tension.max, "N", 1), shown(tension.std, "N", 2));
}

std::string counts_text(const TensionerDynamics& t) {
  const std::string at_limit =
      t.limit_count > 0 ? fmt::format(", and is at its travel limit for {} s", fixed(t.time_at_limit, 1)) : "";
  return fmt::format(", pays out {} and hauls in {} times{}", t.pay_out_count, t.haul_in_count, at_limit);
}

std::vector<std::string> tensioner_sentences(const Comparison& comparison) {
  std::vector<std::string> list;
  for (const ComparedRun& run : comparison.runs) {
    const TensionerDynamics& t = run.results.tensioner;
    const double out = 100.0 * t.time_out_of_range / comparison.duration;
    std::string text =
        fmt::format("{}. It is out of the range {} % of the time", tension_statistics_text(run), fixed(out, 1));
    if (t.mode != "locked") {
      text +=
          fmt::format(", travels up to {}", shown(std::max(std::abs(t.travel.min), std::abs(t.travel.max)), "m", 3));
    }
    if (t.mode == "controlled") text += counts_text(t);
    list.push_back(text + ".");
  }
  return list;
}

// Contact -----------------------------------------------------------------------------------------------------------

/// The box with the maximum force of one roller in a run.
const ComparedBoxes& hardest(const Comparison& comparison, std::size_t run) {
  return *std::max_element(
      comparison.boxes.begin(), comparison.boxes.end(),
      [&](const ComparedBoxes& a, const ComparedBoxes& b) { return a.runs[run].peak_force < b.runs[run].peak_force; });
}

double average_carrying(const Comparison& comparison, std::size_t run) {
  double sum = 0.0;
  for (const ComparedBoxes& box : comparison.boxes) sum += box.runs[run].contact_share;
  return sum;
}

std::string run_text(const Comparison& comparison, std::size_t run) {
  const ComparedBoxes& box = hardest(comparison, run);
  const ComparedBox& compared = box.runs[run];
  return fmt::format(
      "{}: {} of {} boxes are in contact on average. The largest force of one {} on the pipe is {} ({}): a dent of "
      "{} in bare steel, {} on the coating.",
      comparison.runs[run].label, fixed(average_carrying(comparison, run), 1), comparison.boxes.size(),
      comparison.runs[run].name == "gap_springs" ? "spring" : "roller", shown(compared.peak_force, "N", 1), box.name,
      shown(compared.dent_depth, section_length(), 2), shown(compared.line_load, "N/m", 1));
}

/// The box at which the springs' force is below the rollers' by the largest margin (`sign` 1) or above it (-1); null if
/// there is none.
const ComparedBoxes* farthest(const Comparison& comparison, double sign) {
  const auto gap = [&](const ComparedBoxes& box) { return sign * (box.runs[0].peak_force - box.runs[1].peak_force); };
  const auto hardest =
      std::max_element(comparison.boxes.begin(), comparison.boxes.end(),
                       [&](const ComparedBoxes& a, const ComparedBoxes& b) { return gap(a) < gap(b); });
  return gap(*hardest) > 0.0 ? &*hardest : nullptr;
}

std::string against(const ComparedBoxes& box) {
  const ComparedBox &rollers = box.runs[0], &springs = box.runs[1];
  return fmt::format(
      "{}: {} with gap springs compared with {} with rollers, dents of {} and {}, {} and {} on "
      "the coating",
      box.name, shown(springs.peak_force, "N", 1), shown(rollers.peak_force, "N", 1),
      dents().text(springs.dent_depth, 2), shown(rollers.dent_depth, section_length(), 2),
      line_loads().text(springs.line_load, 1), shown(rollers.line_load, "N/m", 1));
}

/// States where a check of dents and coating with gap springs is non-conservative, and where conservative.
std::vector<std::string> meaning(const Comparison& comparison) {
  const auto boxes = static_cast<std::ptrdiff_t>(comparison.boxes.size());
  const auto below = std::count_if(comparison.boxes.begin(), comparison.boxes.end(), [](const ComparedBoxes& box) {
    return box.runs[1].peak_force < box.runs[0].peak_force;
  });
  std::vector<std::string> list;
  if (const ComparedBoxes* missed = farthest(comparison, 1.0)) {
    list.push_back(
        fmt::format("For dents and coating load, gap springs are non-conservative at {} of {} boxes, most at {}.",
                    below, boxes, against(*missed)));
  }
  if (const ComparedBoxes* strict = farthest(comparison, -1.0)) {
    list.push_back(
        fmt::format("They are conservative at {} of {} boxes, most at {}. A spring acts at the middle of its box, "
                    "rollers at their points of contact.",
                    boxes - below, boxes, against(*strict)));
  }
  return list;
}

std::vector<std::string> contact_sentences(const Comparison& comparison) {
  std::vector<std::string> list;
  for (std::size_t run = 0; run < comparison.runs.size(); ++run) list.push_back(run_text(comparison, run));
  const std::vector<std::string> more = meaning(comparison);
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

// Impacts -----------------------------------------------------------------------------------------------------------

double hardest_impact(const DynamicResults& results) {
  return results.hardest_impacts.empty() ? 0.0 : results.hardest_impacts.front().peak_force;
}

std::string impacts_text(const Comparison& comparison, std::size_t run) {
  const DynamicResults& results = comparison.runs[run].results;
  std::string text = fmt::format("{}: {} impacts", comparison.runs[run].label, results.impact_count);
  if (results.impact_count > 0) {
    const Impact& hardest = results.hardest_impacts.front();
    text += fmt::format(", the hardest {} at {} and t = {} s", shown(hardest.peak_force, "N", 1),
                        shown(hardest.approach_velocity, "m/s", 3), fixed(hardest.time, 1));
  }
  const ComparedBox& box = hardest(comparison, run).runs[run];
  return text + fmt::format(". The largest force of one roller on the pipe is {} ({}), {} steps were made in {} s.",
                            shown(box.peak_force, "N", 1), hardest(comparison, run).name, results.run.steps,
                            fixed(results.run.wall_time, 1));
}

/// Formats the change of `value` from the first run to the second.
std::string change_text(const Comparison& comparison, double (*value)(const DynamicResults&)) {
  const double first = value(comparison.runs[0].results), second = value(comparison.runs[1].results);
  if (first == 0.0) return second == 0.0 ? "the same" : "not zero";
  const double change = 100.0 * (second / first - 1.0);
  return fmt::format("{} % {}", fixed(std::abs(change), 1), change < 0.0 ? "less" : "more");
}

std::vector<std::string> impact_sentences(const Comparison& comparison) {
  std::vector<std::string> list = {impacts_text(comparison, 0), impacts_text(comparison, 1)};
  const auto count = [](const DynamicResults& r) { return static_cast<double>(r.impact_count); };
  const auto stress = [](const DynamicResults& r) { return r.overbend.von_mises.over_time.max; };
  const auto sagbend = [](const DynamicResults& r) { return r.sagbend.von_mises.over_time.max; };
  const auto tension = [](const DynamicResults& r) { return r.top_tension.max; };
  list.push_back(fmt::format(
      "Captured against resolved: number of impacts {}, hardest impact {}, maximum von Mises stress in the overbend {} "
      "and in the sagbend {}, maximum tension {}.",
      change_text(comparison, count), change_text(comparison, hardest_impact), change_text(comparison, stress),
      change_text(comparison, sagbend), change_text(comparison, tension)));
  list.push_back(
      "Captured peaks are conservative for a single impact; if the pipe bounces, runs also diverge by chance.");
  return list;
}

std::vector<std::string> summary_sentences(const Comparison& comparison) {
  switch (comparison.of) {
    case ComparisonType::tensioner:
      return tensioner_sentences(comparison);
    case ComparisonType::contact:
      return contact_sentences(comparison);
    case ComparisonType::impacts:
      return impact_sentences(comparison);
  }
  broken_promise("every comparison has findings");
}

}  // namespace

Blocks comparison_section(const Comparison& comparison) {
  return block::section("summary", "Summary", block::list(summary_sentences(comparison)));
}

Blocks boxes_section(const Comparison& comparison) {
  Table table{"", {TableColumn("Box")}, "dense boxes"};
  std::vector<std::pair<std::string, int>> groups = {{"", 1}};
  for (const ComparedRun& run : comparison.runs) {
    table.column({"Contact", ShownUnit{"1", "% of time", 100.0}, 1})
        .column({"static", "N", 1})
        .column({"mean", "N", 1})
        .column({"peak", "N", 1})
        .column({"one roller", "N", 1})
        .column({"dent", section_length(), 2})
        .column({"line load", "N/m", 1});
    groups.emplace_back(run.label, 7);
  }
  table.groups(groups);
  for (const ComparedBoxes& box : comparison.boxes) {
    std::vector<TableCell> cells = {box.name};
    for (const ComparedBox& run : box.runs) {
      cells.insert(cells.end(), {run.contact_share, run.static_reaction, run.mean_reaction, run.peak_reaction,
                                 run.peak_force, run.dent_depth, run.line_load});
    }
    table.row(cells);
  }
  if (table.empty()) return {};
  return block::section(
      "boxes", "Support boxes",
      table + block::remark("Static, mean, peak: resultant of the box. One roller: its largest normal "
                            "force; dent of bare steel and line load on the coating under that "
                            "force."));
}

}  // namespace overbend
