#include "report/stages/stages_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "report/page/figure_list.h"
#include "report/page/quantity.h"
#include "report/stages/hold_points.h"
#include "report/stages/stage_columns.h"
#include "report/stages/stage_labels.h"
#include "results/fields/location_names.h"
#include "results/fields/result_field.h"
#include "results/findings.h"
#include "results/sagbend.h"
#include "results/verdict.h"

namespace overbend {
namespace {

using Lay = const StaticResults&;

const char* const kLook = "dense summary";

StageTable stage_rows(const OperationResults& results, const std::vector<std::size_t>& stages) {
  StageTable table(results, stages);
  const auto stage = [&](std::size_t i) -> const LayStageDescription& { return results.stages[i].stage; };
  table.add("", TableColumn("Stage"), [&](std::size_t i) { return stage_title(results, i); });
  table.add("", {progress_name(results.type), "m", 2}, [&](std::size_t i) { return stage_progress(stage(i)); });
  table.add("Tank", {"empty", "N", 1}, [&](std::size_t i) { return stage(i).tank_weight; });
  table.add("Tank", {"flooded", kPercent, 1}, [&](std::size_t i) { return stage(i).tank_ballast; });
  return table;
}

/// Empty cell in an operation without vessel motion.
TableCell barge_ahead(const OperationResults& results, std::size_t stage) {
  const bool moves =
      ranges::any_of(results.stages, [](const StageResult& result) { return std::abs(result.barge_ahead) > 5e-3; });
  return moves && results.stages[stage].lay ? results.stages[stage].barge_ahead : TableCell();
}

Table line_table(const OperationResults& results) {
  StageTable table = stage_rows(results, all_stages(results));
  const ShownUnit strain = shown_unit("strain", "1");
  table.add("", {"Barge ahead", "m", 2}, [&](std::size_t i) { return barge_ahead(results, i); });
  table.add("Stinger", {"angle", "rad", 2},
            [](Lay lay) { return lay.stinger.empty() ? TableCell() : lay.stinger.front().angle; });
  table.add("Stinger", {"hinge", "N", 1},
            [](Lay lay) { return lay.stinger.empty() ? TableCell() : lay.stinger.front().hinge_force; });
  table.add("Tension", {"top", "N", 1}, [](Lay lay) { return lay.top_tension; });
  table.add("Tension", {"bottom", "N", 1}, [](Lay lay) { return lay.bottom_tension; });
  table.add("Overbend", {"stress", "Pa", 1},
            [](Lay lay) { return lay.overbend ? lay.overbend->von_mises.value : TableCell(); });
  table.add("Overbend", {"strain", strain, 4},
            [](Lay lay) { return lay.overbend ? lay.overbend->strain.value : TableCell(); });
  table.add("Sagbend", {"stress", "Pa", 1},
            [](Lay lay) { return has_sagbend(lay) ? lay.sagbend.von_mises.value : TableCell(); });
  table.add("Sagbend", {"strain", strain, 4},
            [](Lay lay) { return has_sagbend(lay) ? lay.sagbend.strain.value : TableCell(); });
  table.add("", {"Tip clearance", "m", 3}, [](Lay lay) { return lay.stinger_tip_clearance; });
  table.add("Largest roller load", {"", "N", 1},
            [](Lay lay) { return lay.max_reaction_support.empty() ? TableCell() : lay.max_reaction; });
  table.add("Largest roller load", TableColumn("at"), [](Lay lay) { return lay.max_reaction_support; });
  table.add("", {"Lay-back", "m", 1}, [](Lay lay) { return lay.lay_back; });
  table.add("", {"Largest utilisation", "", 3}, [&](std::size_t i) {
    const std::optional<StageUtilisation> use = find_max_utilisation(results.stages[i]);
    return use ? use->utilisation : TableCell();
  });
  return table.table("The line, stage by stage", kLook);
}

Table head_table(const OperationResults& results) {
  std::vector<std::size_t> rows = all_stages(results);
  std::erase_if(rows, [&](std::size_t i) { return !results.stages[i].lay || !results.stages[i].lay->head; });
  StageTable table = stage_rows(results, rows);
  table.add("Head", {"X", "m", 2}, [](Lay lay) { return lay.head->astern; });
  table.add("Head", {"Z", "m", 2}, [](Lay lay) { return lay.head->p_W.z(); });
  table.add("Head", {"inclination", "rad", 2}, [](Lay lay) { return lay.head->inclination; });
  table.add("Head", {"over the bed", "m", 2}, [](Lay lay) { return lay.head->clearance; });
  table.add("Cable", {"at the head", "N", 1}, [](Lay lay) { return lay.head->tension; });
  table.add("Cable", {"inclination there", "rad", 2}, [](Lay lay) { return lay.head->cable_inclination; });
  table.add("Cable", {"largest", "N", 1}, [](Lay lay) { return lay.cable ? lay.cable->max_tension : TableCell(); });
  table.add("Cable", {"of breaking load", kPercent, 1},
            [](Lay lay) { return lay.cable ? lay.cable->utilisation : TableCell(); });
  table.add("Cable", {"inclination at the winch", "rad", 2},
            [](Lay lay) { return lay.cable && !lay.far_anchor ? lay.cable->winch_inclination : TableCell(); });
  table.add("Cable", {"out", "m", 2}, [](Lay lay) { return lay.dragging ? lay.cable->length : TableCell(); });
  table.add("Cable", {"leaves the bed at X", "m", 1},
            [](Lay lay) { return lay.dragging && lay.dragging->lift_off ? lay.dragging->lift_off->x : TableCell(); });
  table.add("Cable", {"at the winch", "N", 1},
            [](Lay lay) { return lay.dragging ? lay.dragging->winch_tension : TableCell(); });
  table.add("Line", {"least tension", "N", 1},
            [](Lay lay) { return lay.dragging ? lay.min_effective_tension.value : TableCell(); });
  const char* const far = drags_along_bed(results.type) ? "Winch" : "Anchor";
  table.add(far, {"astern", "m", 2}, [](Lay lay) { return lay.far_anchor ? lay.far_anchor->distance : TableCell(); });
  table.add(far, {"horizontal", "N", 1},
            [](Lay lay) { return lay.far_anchor ? lay.far_anchor->horizontal : TableCell(); });
  table.add(far, {"uplift", "N", 1}, [](Lay lay) { return lay.far_anchor ? lay.far_anchor->uplift : TableCell(); });
  return table.table("Head and cable, stage by stage", kLook, false);
}

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
      {"stages",
       "The line at all stages, seen from port; pipe as a line, head as a bar, cable dashed",
       {"whole", "supports", "ground"}},
      {"stage_curves", "Results over the stages; the dashed line is a limit", {"curves"}, true},
  };
  return kFigures;
}

Blocks figures(const OperationResults& results) {
  const auto has_supports = [](const StageResult& stage) { return stage.lay && !stage.lay->supports.empty(); };
  const auto moved = [](const StageResult& stage) { return std::abs(stage.barge_ahead) > 0.5; };
  const auto stands = [](const StageResult& stage) { return stage.lay.has_value(); };
  return figure_list(all_figures(), [&](const Figure&, const std::string& part) {
    if (part == "supports") return ranges::any_of(results.stages, has_supports);
    return part == "ground" ? ranges::any_of(results.stages, moved) : ranges::any_of(results.stages, stands);
  });
}

std::string check_cell(const StaticResults& lay, CheckRegion region) {
  const CheckRow* row = governing_check(lay.checks, region);
  if (row == nullptr) return "";
  return fmt::format("{} {}{}", fixed(row->utilisation, 3), row->name, row->line.empty() ? "" : ", " + row->line);
}

/// Reasons why stages are infeasible, and the tension that would make them feasible.
Blocks failed_list(const OperationResults& results) {
  std::vector<std::string> items;
  for (const std::size_t i : all_stages(results)) {
    if (results.stages[i].failure) items.push_back(failure_text(results, i));
  }
  if (items.empty()) return {};
  return block::subheading("Infeasible stages") + block::list(items);
}

Blocks stage_checks(const OperationResults& results, std::size_t stage) {
  const StaticResults& lay = *results.stages[stage].lay;
  Table table{"",
              {TableColumn("Region"),
               TableColumn("Check"),
               TableColumn("Code"),
               {"Utilisation", "", 3},
               TableColumn("Place"),
               {"Along the line", "m", 1},
               TableColumn("Status")},
              "checks"};
  for (const CheckRegion region : check_regions()) {
    for (const CheckRow& row : lay.checks.rows) {
      if (row.region != region || !row.governing) continue;
      const std::string status = word(row.status);
      table.row({region_title(region), row.name, row.clause.empty() ? row.code : row.code + ", " + row.clause,
                 row.judged() ? row.utilisation : TableCell(), location_name(lay, row), along_pipe(lay, row),
                 row.remark.empty() ? status : status + ": " + row.remark},
                row.status == CheckStatus::exceeded ? RowMark::over : RowMark::none);
    }
  }
  return block::folded("Checks of stage " + stage_title(results, stage), table, false);
}

}  // namespace

Blocks stages_section(const OperationResults& results) {
  return block::section(
      "stages", "Stages",
      failed_list(results) + figures(results) + line_table(results) + head_table(results) +
          block::remark("Red: no equilibrium, or a utilisation above 1. X: horizontal, astern of the stern shoe; "
                        "Z: above the mean water level; inclinations from horizontal, positive dipping astern. "
                        "Stresses are von Mises stresses, strains longitudinal. Barge ahead: from its position at "
                        "the first stage. Largest utilisation: of the governing code checks and of the cable's "
                        "breaking load."));
}

Blocks stage_checks_section(const OperationResults& results) {
  const auto has_checks = [](const StageResult& stage) { return stage.lay && !stage.lay->checks.rows.empty(); };
  if (ranges::none_of(results.stages, has_checks)) return {};
  Blocks folded;
  for (const std::size_t i : all_stages(results)) {
    if (has_checks(results.stages[i])) folded += stage_checks(results, i);
  }
  StageTable table(results, all_stages(results));
  table.add("", TableColumn("Stage"), [&](std::size_t i) { return stage_title(results, i); });
  table.add("", TableColumn("Verdict"), [&](std::size_t i) { return stage_verdict(results.stages[i]).headline; });
  for (const CheckRegion region : check_regions()) {
    table.add("Utilisation and governing check", TableColumn(region_title(region)),
              [&](Lay lay) { return check_cell(lay, region); });
  }
  return block::section("stage-checks", "Code checks of the stages",
                        table.table("Governing check of each region", "checks stages") + folded);
}

std::string failure_text(const OperationResults& results, std::size_t stage) {
  const StageFailure& failure = *results.stages[stage].failure;
  std::string text = fmt::format("Stage {} is infeasible: {}", stage_title(results, stage), failure.what);
  if (!failure.where.empty()) text += ", " + failure.where;
  if (!failure.why.empty()) text += ": " + failure.why;
  if (text.back() != '.') text += ".";
  if (failure.min_tension) {
    text += fmt::format(" It is feasible with a top tension of {} or more.", shown(*failure.min_tension, "N", 1));
  }
  return text;
}

}  // namespace overbend
