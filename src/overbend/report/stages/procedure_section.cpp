#include "report/stages/procedure_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "checks/mooring_rows.h"
#include "report/page/quantity.h"
#include "report/stages/hold_points.h"
#include "report/stages/stage_columns.h"
#include "report/stages/stage_labels.h"
#include "report/stages/stages_section.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

std::optional<double> stage_tension(const StageResult& stage) {
  if (stage.stage.tension) return stage.stage.tension;
  return stage.lay ? std::optional(stage.lay->top_tension) : std::nullopt;
}

/// Upper limit of the tension: the cable's breaking load over its safety factor, times the utilisation limit of the
/// operation.
std::optional<double> cable_limit(const std::optional<Description>& description) {
  if (!description) return std::nullopt;
  const LayOperationDescription& lay = description->operation.lay;
  if (!lay.cable || !lay.cable->breaking_load) return std::nullopt;
  const double factor = cable_safety_factor(description->checks.safety_factors).value;
  return *lay.cable->breaking_load / factor * (lay.program ? lay.program->limits.utilisation : 1.0);
}

std::string hold_text(const HoldPoint& point, const std::string& progress) {
  std::string text = point.what;
  if (point.out) text += fmt::format(" (at {} {})", progress, shown(*point.out, "m", 1));
  return text;
}

/// Reason to pause before the step, or why it is infeasible.
std::string remarks(const OperationResults& results, const std::vector<HoldPoint>& points, std::size_t stage) {
  if (results.stages[stage].failure) return "INFEASIBLE as planned, see below";
  std::string progress = progress_name(results.type);
  progress[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(progress[0])));
  std::string text;
  for (const HoldPoint& point : points) {
    if (point.stage == stage) text += (text.empty() ? "HOLD before: " : "; ") + hold_text(point, progress);
  }
  const std::string& governing = results.stages[stage].governing;
  if (!governing.empty()) text += (text.empty() ? "Tension set by " : "; tension set by ") + governing;
  return text;
}

/// Minimum tension found for the limits of the stage.
std::optional<double> min_tension(const StageResult& stage) {
  if (stage.failure && stage.failure->min_tension) return stage.failure->min_tension;
  return stage.governing.empty() ? std::nullopt : stage_tension(stage);
}

Table step_table(const OperationResults& results, const std::optional<Description>& description) {
  using Lay = const StaticResults&;
  const std::vector<HoldPoint> points = hold_points(results);
  const std::optional<double> limit = cable_limit(description);
  StageTable table(results, all_stages(results));
  const auto stage = [&](std::size_t i) -> const StageResult& { return results.stages[i]; };
  table.add("", TableColumn("Step"), [&](std::size_t i) { return stage_title(results, i); });
  table.add("", {progress_name(results.type), "m", 1}, [&](std::size_t i) { return stage_progress(stage(i).stage); });
  table.add("Tension", {"hold", "N", 1}, [&](std::size_t i) { return stage_tension(stage(i)); });
  table.add("Tension", {"not below", "N", 1}, [&](std::size_t i) { return min_tension(stage(i)); });
  table.add("Tension", {"not above", "N", 1},
            [&](Lay lay) { return lay.cable && !lay.dragging ? limit : std::nullopt; });
  table.add("Winch", {"pull", "N", 1},
            [](Lay lay) { return lay.dragging ? lay.dragging->winch_tension : TableCell(); });
  table.add("Winch", {"not above", "N", 1}, [&](Lay lay) { return lay.dragging ? limit : std::nullopt; });
  table.add("Winch", {"cable out", "m", 1}, [](Lay lay) { return lay.dragging ? lay.cable->length : TableCell(); });
  table.add("", {"Barge ahead", "m", 1},
            [&](std::size_t i) { return stage(i).lay ? stage(i).barge_ahead : TableCell(); });
  table.add("Head", {"depth", "m", 1}, [](Lay lay) { return lay.head ? -lay.head->p_W.z() : TableCell(); });
  table.add("Head", {"astern", "m", 1}, [](Lay lay) { return lay.head ? lay.head->astern : TableCell(); });
  table.add("Head", {"over bed", "m", 1}, [](Lay lay) { return lay.head ? lay.head->clearance : TableCell(); });
  table.add("Watch", {"tip clearance", "m", 2}, [](Lay lay) { return lay.stinger_tip_clearance; });
  table.add("Watch", {"roller load", "N", 1},
            [](Lay lay) { return lay.max_reaction_support.empty() ? TableCell() : lay.max_reaction; });
  table.add("Watch", TableColumn("at"), [](Lay lay) { return lay.max_reaction_support; });
  table.add("", {"Utilisation", "", 2}, [&](std::size_t i) {
    const std::optional<StageUtilisation> use = find_max_utilisation(stage(i));
    return use ? use->utilisation : TableCell();
  });
  table.add("", TableColumn("Hold points and remarks"), [&](std::size_t i) { return remarks(results, points, i); });
  return table.table("", "dense procedure");
}

/// "3", "3 and 4", "3 to 7, 9".
std::string numbers(const std::vector<std::size_t>& stages) {
  std::string text;
  for (std::size_t i = 0; i < stages.size();) {
    std::size_t end = i;
    while (end + 1 < stages.size() && stages[end + 1] == stages[end] + 1) ++end;
    text += (text.empty() ? "" : ", ") + std::to_string(stages[i] + 1);
    if (end > i) text += (end == i + 1 ? " and " : " to ") + std::to_string(stages[end] + 1);
    i = end + 1;
  }
  return text;
}

/// Adds the steps that the analysis advises against.
void add_steps_to_avoid(const OperationResults& results, std::vector<std::string>& reasons) {
  std::vector<std::size_t> exceeded;
  for (const std::size_t i : all_stages(results)) {
    if (results.stages[i].failure) reasons.push_back(failure_text(results, i) + " Stop at the step before.");
    const std::optional<StageUtilisation> use = find_max_utilisation(results.stages[i]);
    if (use && use->utilisation > 1.0) exceeded.push_back(i);
  }
  if (!exceeded.empty()) {
    reasons.push_back(
        fmt::format("Step{} {}: a check is exceeded even at the given tension. Do not carry out as planned.",
                    exceeded.size() > 1 ? "s" : "", numbers(exceeded)));
  }
}

/// Adds the limits of the operation, as given in the model.
void add_limits(const StageLimits& limits, std::vector<std::string>& reasons) {
  if (limits.tip_clearance) {
    reasons.push_back(fmt::format("Clearance at the stinger tip below {}.", shown(*limits.tip_clearance, "m", 2)));
  }
  if (limits.roller_load) {
    reasons.push_back(fmt::format("Load of a roller above {}.", shown(*limits.roller_load, "N", 1)));
  }
  if (limits.sagbend_strain) {
    reasons.push_back(fmt::format("Tension below \"not below\": the strain of the sagbend exceeds {} %.",
                                  strains().text(*limits.sagbend_strain, 3)));
  }
  if (limits.sagbend_stress) {
    reasons.push_back(fmt::format("Tension below \"not below\": the stress of the sagbend exceeds {}.",
                                  stresses().text(*limits.sagbend_stress, 0)));
  }
}

Blocks abort_list(const OperationResults& results, const std::optional<Description>& description) {
  std::vector<std::string> reasons;
  add_steps_to_avoid(results, reasons);
  if (const std::optional<double> limit = cable_limit(description)) {
    const SafetyFactor factor = cable_safety_factor(description->checks.safety_factors);
    reasons.push_back(fmt::format(
        "Tension of the cable above {}: its breaking load of {} over a safety factor of {:.3g} ({}){}.",
        shown(*limit, "N", 1), shown(*description->operation.lay.cable->breaking_load, "N", 1), factor.value,
        factor.source, description->operation.lay.program ? ", times the utilisation that the model allows" : ""));
  }
  if (description && description->operation.lay.program) {
    add_limits(description->operation.lay.program->limits, reasons);
  }
  reasons.emplace_back("Tension, length paid out or vessel position cannot be brought to the values of the step.");
  return block::subheading("Stop and hold if") + block::list(reasons);
}

/// Fields to be filled in by hand if the model does not give their values.
Blocks signatures(const std::optional<Description>& description) {
  const ReportDescription control = description ? description->report : ReportDescription{};
  return block::entry_frame({{"Document", control.document},
                             {"Revision", control.revision},
                             {"Prepared", control.prepared},
                             {"Checked", control.checked},
                             {"Accepted on board", ""},
                             {"Date and time", ""}});
}

}  // namespace

Blocks procedure_section(const OperationResults& results, const std::optional<Description>& description) {
  const StaticResults* lay = first_lay(results);
  if (lay == nullptr) return {};
  const std::string subject = fmt::format(
      "{}: {}. {}, water depth {}, pipe {} over the coating.", operation_title(results.type), results.title,
      lay->vessel_name, shown(lay->water_depth, "m", 1), shown(lay->pipe_outer_diameter, section_length(), 0));
  return block::section(
      "procedure", "Procedure sheet",
      block::paragraph(subject) + signatures(description) + step_table(results, description) +
          block::remark(
              "Static values at the end of each step, without vessel motions. Astern: of the stern shoe; barge "
              "ahead: from its position at step 1. Not below: minimum tension found for the limits; not above: "
              "breaking load of the cable over its safety factor, times the utilisation that the model allows. "
              "Hold before: pause, compare length, tension and position with the sheet, then continue.") +
          abort_list(results, description));
}

}  // namespace overbend
