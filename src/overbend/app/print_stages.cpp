#include "app/print_stages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "app/print_checks.h"
#include "base/shown_unit.h"
#include "base/text.h"
#include "model/description/operation_names.h"
#include "model/lay_stage.h"
#include "results/findings.h"
#include "results/lift_brief.h"
#include "results/result_enum_names.h"
#include "results/sagbend.h"

namespace overbend {
namespace {

/// Returns the payout or progress of the line [m].
std::optional<double> progress(const LayStageDescription& stage) {
  for (const auto& distance : {stage.cable_out, stage.pipe_out, stage.passed, stage.ahead}) {
    if (distance) return distance;
  }
  return std::nullopt;
}

const char* progress_heading(OperationType type) {
  if (type == OperationType::ballast) return "tank";
  if (type == OperationType::start_up || drags_along_bed(type)) return "pipe out";
  if (type == OperationType::move) return "ahead";
  return type == OperationType::passage ? "passed" : "cable out";
}

std::string cell(const std::optional<double>& value, const ShownUnit& unit, int digits, int width) {
  return fmt::format("{:>{}}", value ? shown_number(*value, unit, digits) : "-", width);
}

/// Returns the contents of the stinger tank at a ballast stage.
std::string tank_label(const LayStageDescription& stage) {
  std::string text = stage.tank_weight ? shown(*stage.tank_weight, "N", 0) : "";
  if (stage.tank_ballast) text += fmt::format("{}{:.1f} %", text.empty() ? "" : " ", *stage.tank_ballast * 1e2);
  return text;
}

std::string begin(const LayStageDescription& stage) {
  const bool tank = stage.tank_weight || stage.tank_ballast;
  const std::string gone =
      tank ? fmt::format("{:>11}", tank_label(stage)) : cell(progress(stage), shown_unit("m"), 1, 11);
  return fmt::format("  {:<20}{}", for_display(stage.name, 19), gone);
}

/// Returns the governing check and the verdict of the stage.
std::string governing_check_text(const StageResult& stage) {
  const CheckRow* worst = find_governing_check(stage.lay->checks);
  if (worst == nullptr) return "-";
  const std::string line = worst->line.empty() ? "" : ", line \"" + for_display(worst->line) + "\"";
  return fmt::format("{:.2f} {}{}: {}", worst->utilisation, worst->name, line, word(stage_verdict(stage).kind));
}

/// Returns a line for a stage of a lift: height of the free end, loads of pipe and davits.
std::string lift_line(const StageResult& stage) {
  const LiftBrief lift = in_brief(*stage.lay->lift);
  return fmt::format("  {:<26}", for_display(stage.stage.name, 25)) + cell(lift.end_height, shown_unit("m"), 2, 11) +
         cell(lift.moment, shown_unit("N m"), 1, 12) + cell(lift.stress, shown_unit("Pa"), 1, 10) +
         cell(lift.davit_tension, shown_unit("N"), 1, 12) + "  " + governing_check_text(stage) + "\n";
}

std::string lift_heads() {
  return fmt::format("  {:<26}{:>11}{:>12}{:>10}{:>12}  {}\n  {:<26}{:>11}{:>12}{:>10}{:>12}\n", "stage", "free end, z",
                     "moment", "stress", "davit", "max. utilisation", "", shown_name("m"), shown_name("N m"),
                     shown_name("Pa"), shown_name("N"));
}

std::string planned_values(const std::vector<LineValue>& values, const char* unit) {
  std::string text;
  for (const LineValue& value : values) {
    text += (text.empty() ? "" : ", ") + for_display(value.line) + " " + shown_digits(value.value, unit, 5);
  }
  return text;
}

std::string offset_label(const std::string& body, const VesselOffset& offset) {
  return fmt::format("{} {} ahead, {} to port, {} clockwise", body, shown(offset.x, "m", 2), shown(offset.y, "m", 2),
                     shown(offset.heading, "rad", 2));
}

/// Returns the prescribed lengths, tensions and positions of every stage of a lift.
std::string planned_lift(const Description& description) {
  std::string lines = "\nStages of the operation lift\n";
  int number = 0;
  for (const LayStageDescription& stage : description.operation.lay.stages) {
    ++number;
    std::vector<std::string> parts;
    if (!stage.lengths.empty()) parts.push_back(planned_values(stage.lengths, "m"));
    if (!stage.tensions.empty()) parts.push_back(planned_values(stage.tensions, "N"));
    if (stage.vessel) parts.push_back(offset_label("vessel", *stage.vessel));
    for (const BodyOffset& body : stage.bodies) parts.push_back(offset_label(for_display(body.body), body.offset));
    if (stage.join) parts.push_back("weld " + stage.join->first + " to " + stage.join->second);
    const std::string name = stage.name.empty() ? "stage " + std::to_string(number) : stage.name;
    lines += fmt::format("  {:<26}{}\n", for_display(name, 25), fmt::join(parts, "; "));
  }
  return lines;
}

/// Returns the column headings of a bottom pull: winch tension, cable, sagbend, minimum tension of the line.
std::string dragged_heads() {
  const auto row = [](const auto&... cells) {
    return fmt::format("  {:<20}{:>11}{:>10}{:>12}{:>10}{:>10}{:>11}  {}\n", cells...);
  };
  return row("stage", "pipe out", "tension", "at winch", "cable out", "sagbend", "min.", "max. utilisation") +
         row("", shown_name("m"), shown_name("N"), shown_name("N"), shown_name("m"), shown_name("Pa"), shown_name("N"),
             "");
}

std::string dragged_cells(const StaticResults& lay) {
  const std::optional<double> sagbend = has_sagbend(lay) ? std::optional(lay.sagbend.von_mises.value) : std::nullopt;
  return cell(lay.dragging->winch_tension, shown_unit("N"), 1, 12) + cell(lay.cable->length, shown_unit("m"), 1, 10) +
         cell(sagbend, shown_unit("Pa"), 1, 10) + cell(lay.min_effective_tension.value, shown_unit("N"), 1, 11);
}

std::string found_cells(const StageResult& stage) {
  const StaticResults& lay = *stage.lay;
  if (lay.dragging) return dragged_cells(lay);
  const std::optional<double> depth = lay.head ? std::optional(-lay.head->p_W.z()) : std::nullopt;
  const bool tank = stage.stage.tank_weight || stage.stage.tank_ballast;
  const auto of_sagbend = [&](double value) { return has_sagbend(lay) ? std::optional(value) : std::nullopt; };
  return (tank && !lay.stinger.empty() ? cell(lay.stinger.front().angle, shown_unit("rad"), 2, 12)
                                       : cell(depth, shown_unit("m"), 1, 12)) +
         cell(of_sagbend(lay.sagbend.von_mises.value), shown_unit("Pa"), 1, 10) +
         cell(of_sagbend(lay.sagbend.strain.value), shown_unit("strain", "1"), 3, 10) +
         cell(lay.stinger_tip_clearance, shown_unit("m"), 2, 11);
}

}  // namespace

std::string stage_heads(OperationType type) {
  if (type == OperationType::lift) return lift_heads();
  if (drags_along_bed(type)) return dragged_heads();
  const bool ballast = type == OperationType::ballast;
  return fmt::format("  {:<20}{:>11}{:>10}{:>12}{:>10}{:>10}{:>11}  {}\n  {:<20}{:>11}{:>10}{:>12}{:>10}{:>10}{:>11}\n",
                     "stage", progress_heading(type), "tension", ballast ? "stinger" : "head depth", "sagbend",
                     "strain", "clearance", "max. utilisation", "", ballast ? "" : shown_name("m"), shown_name("N"),
                     shown_name(ballast ? "rad" : "m"), shown_name("Pa"), "%", shown_name("m"));
}

std::string stage_line(const StageResult& stage) {
  std::string line = begin(stage.stage);
  if (!stage.lay) {
    const StageFailure none{"no equilibrium", "", "", {}};
    const StageFailure& failure = stage.failure ? *stage.failure : none;
    line += cell(stage.stage.tension, shown_unit("N"), 1, 10) + "  " + failure.what;
    if (!failure.where.empty()) line += " (" + failure.where + ")";
    if (!failure.why.empty()) line += ": " + failure.why;
    if (failure.min_tension) line += "; feasible with " + shown(*failure.min_tension, "N", 1);
    return line + "\n";
  }
  if (stage.lay->lift) return lift_line(stage);
  line +=
      cell(stage.lay->top_tension, shown_unit("N"), 1, 10) + found_cells(stage) + "  " + governing_check_text(stage);
  if (!stage.governing.empty()) line += ", tension governed by " + stage.governing;
  return line + "\n";
}

std::string planned_stages(const Description& description) {
  const OperationType type = description.operation.type;
  if (!is_lay_operation(type)) return "";
  if (type == OperationType::lift) return planned_lift(description);
  std::string lines = fmt::format("\nStages of the operation {}\n  {:<20}{:>11}{:>10}\n  {:<20}{:>11}{:>10}\n",
                                  operation_name(type), "stage", progress_heading(type), "tension", "",
                                  type == OperationType::ballast ? "" : shown_name("m"), shown_name("N"));
  const StageTension* program =
      description.operation.lay.program ? &description.operation.lay.program->tension : nullptr;
  for (const LayStageDescription& stage : lay_stages(description)) {
    lines += begin(stage);
    if (stage.tension) {
      lines += cell(stage.tension, shown_unit("N"), 1, 10);
    } else if (stage.bottom_tension) {
      lines += "  for " + shown(*stage.bottom_tension, "N", 1) + " at touchdown";
    } else {
      lines += program != nullptr && *program == StageTension::seek ? "  to be found" : "  from the anchor's distance";
    }
    lines += "\n";
  }
  return lines;
}

int count_solved(const OperationResults& results) {
  return static_cast<int>(std::count_if(results.stages.begin(), results.stages.end(),
                                        [](const StageResult& stage) { return stage.lay.has_value(); }));
}

ExitCode strict_code(const OperationResults& results, bool strict) {
  const int failed = static_cast<int>(results.stages.size()) - count_solved(results);
  if (!strict || failed == 0) return strict_code(operation_checks(results), operation_findings(results), strict);
  std::cerr << fmt::format("overbend: {} of {} stages have no equilibrium\n", failed, results.stages.size());
  return kCheckExceeded;
}

}  // namespace overbend
