#include "report/comparison_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html.h"

namespace overbend {
namespace {

using html::fixed;

// The tensioner -----------------------------------------------------------------------------------------------------

std::string tension_words(const ComparedRun& run) {
  const Spread& tension = run.results.tensioner.tension;
  return fmt::format("{}: {} to {} kN, standard deviation {} kN", run.words, fixed(tension.min / 1e3, 1),
                     fixed(tension.max / 1e3, 1), fixed(tension.std / 1e3, 2));
}

std::string work_words(const TensionerDynamics& t, double duration) {
  const double travel = std::max(std::abs(t.travel.min), std::abs(t.travel.max));
  return fmt::format(
      ". It is out of its range {} % of the time, moves up to {} m, pays out {} and hauls in {} times{}",
      fixed(100.0 * t.time_out_of_range / duration, 1), fixed(travel, 3), t.pay_out_count, t.haul_in_count,
      t.limit_count > 0 ? fmt::format(", and stands {} s at the end of its travel", fixed(t.time_at_limit, 1)) : "");
}

std::vector<std::string> tensioner_findings(const Comparison& comparison) {
  std::vector<std::string> list;
  for (const ComparedRun& run : comparison.runs) {
    const TensionerDynamics& t = run.results.tensioner;
    std::string words = tension_words(run);
    if (run.name == "off") {
      words += fmt::format(". It is out of the range {} % of the time",
                           fixed(100.0 * t.time_out_of_range / comparison.duration, 1));
    } else {
      words += work_words(t, comparison.duration);
    }
    list.push_back(words + ".");
  }
  return list;
}

// Contact -----------------------------------------------------------------------------------------------------------

/// Of a run: the box that is pressed hardest at one roller.
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

std::string run_words(const Comparison& comparison, std::size_t run) {
  const ComparedBoxes& box = hardest(comparison, run);
  const ComparedBox& most = box.runs[run];
  return fmt::format(
      "{}: {} of {} boxes carry on average. The largest force of one {} on the pipe is {} kN ({}): a dent of {} mm in "
      "bare steel, {} kN/m on the coating.",
      comparison.runs[run].words, fixed(average_carrying(comparison, run), 1), comparison.boxes.size(),
      comparison.runs[run].name == "gap_springs" ? "spring" : "roller", fixed(most.peak_force / 1e3, 1), box.name,
      fixed(most.dent_depth * 1e3, 2), fixed(most.line_load / 1e3, 1));
}

/// What a check of dents and coating with gap springs would miss, or be too strict about.
std::string meaning(const Comparison& comparison) {
  const double rollers = hardest(comparison, 0).runs[0].peak_force;
  const double springs = hardest(comparison, 1).runs[1].peak_force;
  if (rollers <= 0.0 || springs <= 0.0) return "";
  const double less = 100.0 * (1.0 - springs / rollers);
  if (std::abs(less) < 2.0) {
    return "The largest forces are the same within 2 %: dents and loads on the coating can be judged with either.";
  }
  return fmt::format(
      "For dents and coating: gap springs put the largest force {} % {} than rollers do, so that a check with them is "
      "{}. "
      "A gap spring takes the whole reaction of a box at one point, whereas the rows share it unevenly; dent and line "
      "load of a spring are those of one roller under that force.",
      fixed(std::abs(less), 0), less > 0.0 ? "lower" : "higher",
      less > 0.0 ? "on the unsafe side" : "on the safe side");
}

std::vector<std::string> contact_findings(const Comparison& comparison) {
  std::vector<std::string> list;
  for (std::size_t run = 0; run < comparison.runs.size(); ++run) list.push_back(run_words(comparison, run));
  if (const std::string words = comparison.runs.size() == 2 ? meaning(comparison) : ""; !words.empty()) {
    list.push_back(words);
  }
  return list;
}

std::vector<std::string> box_cells(const ComparedBox& box) {
  return {fixed(100.0 * box.contact_share, 1), fixed(box.static_reaction / 1e3, 1), fixed(box.mean_reaction / 1e3, 1),
          fixed(box.peak_reaction / 1e3, 1),   fixed(box.peak_force / 1e3, 1),      fixed(box.dent_depth * 1e3, 2),
          fixed(box.line_load / 1e3, 1)};
}

}  // namespace

std::string findings_section(const Comparison& comparison) {
  return html::section("findings", "Findings",
                       html::list(comparison.of == ComparisonOf::tensioner ? tensioner_findings(comparison)
                                                                           : contact_findings(comparison)));
}

std::string boxes_section(const Comparison& comparison) {
  if (comparison.boxes.empty()) return "";
  std::vector<html::Head> head = {{"Box", "", true}};
  std::vector<std::pair<std::string, int>> groups = {{"", 1}};
  for (const ComparedRun& run : comparison.runs) {
    head.insert(head.end(), {{"Contact", "% of time"},
                             {"static", "kN"},
                             {"mean", "kN"},
                             {"peak", "kN"},
                             {"one roller", "kN"},
                             {"dent", "mm"},
                             {"line load", "kN/m"}});
    groups.emplace_back(run.words, 7);
  }
  html::Table table("", head, "dense boxes");
  table.groups(groups);
  for (const ComparedBoxes& box : comparison.boxes) {
    std::vector<std::string> cells = {box.name};
    for (const ComparedBox& run : box.runs) {
      const std::vector<std::string> more = box_cells(run);
      cells.insert(cells.end(), more.begin(), more.end());
    }
    table.row(cells);
  }
  return html::section(
      "boxes", "Support boxes",
      table.str() +
          "<p class=\"small\">Static, mean, peak: resultant of the box. One roller: its largest normal "
          "force; dent of bare steel and line load on the coating under that force.</p>\n");
}

}  // namespace overbend
