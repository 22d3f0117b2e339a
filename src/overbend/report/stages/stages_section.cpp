#include "report/stages/stages_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/figure_list.h"
#include "report/page/html.h"
#include "report/page/places.h"
#include "report/page/quantity.h"
#include "report/stages/hold_points.h"
#include "report/stages/stage_columns.h"
#include "report/stages/stage_words.h"
#include "results/fields/result_field.h"
#include "results/findings.h"
#include "results/sagbend.h"
#include "results/verdict.h"

namespace overbend {
namespace {

using html::fixed;
using html::Head;

std::vector<StageColumn> first_columns(const OperationResults& results) {
  return {{"", {"Stage", "", true}, [&](std::size_t i) { return stage_title(results, i); }},
          {"",
           {progress_name(results.type), shown_name("m")},
           [&](std::size_t i) {
             const std::optional<double> out = progress_of(results.stages[i].stage);
             return out ? shown_number(*out, "m", 2) : std::string();
           }},
          {"Tank",
           {"empty", shown_name("N")},
           [&](std::size_t i) {
             const std::optional<double>& weight = results.stages[i].stage.tank_weight;
             return weight ? shown_number(*weight, "N", 1) : std::string();
           }},
          {"Tank", {"flooded", "%"}, [&](std::size_t i) {
             const std::optional<double>& ballast = results.stages[i].stage.tank_ballast;
             return ballast ? fixed(100.0 * *ballast, 1) : std::string();
           }}};
}

std::string barge_ahead(const OperationResults& results, std::size_t stage) {
  const bool moves = std::any_of(results.stages.begin(), results.stages.end(),
                                 [](const StageResult& one) { return std::abs(one.barge_ahead) > 5e-3; });
  return moves && results.stages[stage].lay ? shown_number(results.stages[stage].barge_ahead, "m", 2) : "";
}

std::string line_table(const OperationResults& results) {
  std::vector<StageColumn> columns = first_columns(results);
  const auto add = [&](const char* group, Head head, LayText text) {
    columns.push_back({group, std::move(head), of_lay(results, std::move(text))});
  };
  columns.push_back({"", {"Barge ahead", shown_name("m")}, [&](std::size_t i) { return barge_ahead(results, i); }});
  add("Stinger", {"angle", shown_name("rad")}, [](const StaticResults& lay) {
    return lay.stinger.empty() ? "" : shown_number(lay.stinger.front().angle, "rad", 2);
  });
  add("Stinger", {"hinge", shown_name("N")}, [](const StaticResults& lay) {
    return lay.stinger.empty() ? "" : shown_number(lay.stinger.front().hinge_force, "N", 1);
  });
  add("Tension", {"top", shown_name("N")},
      [](const StaticResults& lay) { return shown_number(lay.top_tension, "N", 1); });
  add("Tension", {"bottom", shown_name("N")},
      [](const StaticResults& lay) { return shown_number(lay.bottom_tension, "N", 1); });
  add("Overbend", {"stress", shown_name("Pa")},
      [](const StaticResults& lay) { return lay.overbend ? stresses().text(lay.overbend->von_mises.value, 1) : ""; });
  add("Overbend", {"strain", "%"},
      [](const StaticResults& lay) { return lay.overbend ? strains().text(lay.overbend->strain.value, 4) : ""; });
  add("Sagbend", {"stress", shown_name("Pa")},
      [](const StaticResults& lay) { return has_sagbend(lay) ? stresses().text(lay.sagbend.von_mises.value, 1) : ""; });
  add("Sagbend", {"strain", "%"},
      [](const StaticResults& lay) { return has_sagbend(lay) ? strains().text(lay.sagbend.strain.value, 4) : ""; });
  add("", {"Tip clearance", shown_name("m")}, [](const StaticResults& lay) {
    return lay.stinger_tip_clearance ? shown_number(*lay.stinger_tip_clearance, "m", 3) : "";
  });
  add("Largest roller load", {"", shown_name("N")}, [](const StaticResults& lay) {
    return lay.largest_reaction_support.empty() ? "" : shown_number(lay.largest_reaction, "N", 1);
  });
  add("Largest roller load", {"at", "", true}, [](const StaticResults& lay) { return lay.largest_reaction_support; });
  add("", {"Lay-back", shown_name("m")}, [](const StaticResults& lay) { return shown_number(lay.lay_back, "m", 1); });
  columns.push_back({"", {"Largest utilisation", ""}, [&](std::size_t i) {
                       const std::optional<StageUse> use = largest_use(results.stages[i]);
                       return use ? fixed(use->utilisation, 3) : "";
                     }});
  return stage_rows_table("The line, stage by stage", columns, all_stages(results), "dense summary",
                          [&](std::size_t i) { return stage_css(results.stages[i]); });
}

std::string head_table(const OperationResults& results) {
  std::vector<std::size_t> rows;
  for (const std::size_t i : all_stages(results)) {
    if (results.stages[i].lay && results.stages[i].lay->head) rows.push_back(i);
  }
  if (rows.empty()) return "";
  std::vector<StageColumn> columns = first_columns(results);
  const auto add = [&](const char* group, Head head, LayText text) {
    columns.push_back({group, std::move(head), of_lay(results, std::move(text))});
  };
  add("Head", {"X", shown_name("m")}, [](const StaticResults& lay) { return shown_number(lay.head->astern, "m", 2); });
  add("Head", {"Z", shown_name("m")}, [](const StaticResults& lay) { return shown_number(lay.head->p_W.z(), "m", 2); });
  add("Head", {"inclination", shown_name("rad")},
      [](const StaticResults& lay) { return shown_number(lay.head->inclination, "rad", 2); });
  add("Head", {"over the bed", shown_name("m")},
      [](const StaticResults& lay) { return shown_number(lay.head->clearance, "m", 2); });
  add("Cable", {"at the head", shown_name("N")},
      [](const StaticResults& lay) { return shown_number(lay.head->tension, "N", 1); });
  add("Cable", {"inclination there", shown_name("rad")},
      [](const StaticResults& lay) { return shown_number(lay.head->cable_inclination, "rad", 2); });
  add("Cable", {"largest", shown_name("N")},
      [](const StaticResults& lay) { return lay.cable ? shown_number(lay.cable->largest_tension, "N", 1) : ""; });
  add("Cable", {"of breaking load", "%"}, [](const StaticResults& lay) {
    return lay.cable && lay.cable->utilisation ? fixed(100.0 * *lay.cable->utilisation, 1) : "";
  });
  add("Cable", {"inclination at the winch", shown_name("rad")}, [](const StaticResults& lay) {
    return lay.cable && !lay.far_anchor ? shown_number(lay.cable->winch_inclination, "rad", 2) : "";
  });
  add("Cable", {"out", shown_name("m")},
      [](const StaticResults& lay) { return lay.dragging ? shown_number(lay.cable->length, "m", 2) : ""; });
  add("Cable", {"leaves the bed at X", shown_name("m")}, [](const StaticResults& lay) {
    return lay.dragging && lay.dragging->lift_off ? shown_number(lay.dragging->lift_off->x, "m", 1) : "";
  });
  add("Cable", {"at the winch", shown_name("N")},
      [](const StaticResults& lay) { return lay.dragging ? shown_number(lay.dragging->winch_tension, "N", 1) : ""; });
  add("Line", {"least tension", shown_name("N")},
      [](const StaticResults& lay) { return lay.dragging ? shown_number(lay.smallest_tension.value, "N", 1) : ""; });
  const char* const far = drags_along_bed(results.type) ? "Winch" : "Anchor";
  add(far, {"astern", shown_name("m")},
      [](const StaticResults& lay) { return lay.far_anchor ? shown_number(lay.far_anchor->distance, "m", 2) : ""; });
  add(far, {"horizontal", shown_name("N")},
      [](const StaticResults& lay) { return lay.far_anchor ? shown_number(lay.far_anchor->horizontal, "N", 1) : ""; });
  add(far, {"uplift", shown_name("N")},
      [](const StaticResults& lay) { return lay.far_anchor ? shown_number(lay.far_anchor->uplift, "N", 1) : ""; });
  return stage_rows_table("Head and cable, stage by stage", columns, rows, "dense summary",
                          [](std::size_t) { return ""; });
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

std::string figures(const OperationResults& results, int& number) {
  const auto has_supports = [](const StageResult& one) { return one.lay && !one.lay->supports.empty(); };
  const auto moved = [](const StageResult& one) { return std::abs(one.barge_ahead) > 0.5; };
  const auto any = [&](const auto& what) { return std::any_of(results.stages.begin(), results.stages.end(), what); };
  return figure_list(
      all_figures(),
      [&](const Figure&, const std::string& part) {
        if (part == "supports") return any(has_supports);
        return part == "ground" ? any(moved) : any([](const StageResult& one) { return one.lay.has_value(); });
      },
      number);
}

std::string check_cell(const StageResult& stage, CheckRegion region) {
  const CheckRow* row = stage.lay ? governing_check(stage.lay->checks, region) : nullptr;
  if (row == nullptr) return "";
  return fmt::format("{} {}{}", fixed(row->utilisation, 3), row->name, row->line.empty() ? "" : ", " + row->line);
}

/// Why stages cannot be, and what tension would do.
std::string failed_list(const OperationResults& results) {
  std::vector<std::string> items;
  for (const std::size_t i : all_stages(results)) {
    if (results.stages[i].failure) items.push_back(failure_words(results, i));
  }
  return items.empty() ? "" : "<h3>Stages that cannot be</h3>\n" + html::list(items);
}

std::string checks_of(const OperationResults& results, std::size_t stage) {
  const StaticResults& lay = *results.stages[stage].lay;
  html::Table table("",
                    {{"Region", "", true},
                     {"Check", "", true},
                     {"Code", "", true},
                     {"Utilisation", ""},
                     {"Place", "", true},
                     {"Along the line", shown_name("m")},
                     {"Status", "", true}},
                    "checks");
  for (const CheckRegion region : check_regions()) {
    for (const CheckRow& row : lay.checks.rows) {
      if (row.region != region || !row.governing) continue;
      table.row(
          {region_title(region), row.name, row.clause.empty() ? row.code : row.code + ", " + row.clause,
           row.judged() ? fixed(row.utilisation, 3) : "", place_name(lay, row), along_pipe(lay, row),
           row.remark.empty() ? std::string(word(row.status)) : std::string(word(row.status)) + ": " + row.remark},
          row.status == CheckStatus::exceeded ? "over" : "");
    }
  }
  return html::folded("Checks of stage " + stage_title(results, stage), table.str(), false);
}

}  // namespace

std::string stages_section(const OperationResults& results, int& number) {
  return html::section("stages", "Stages",
                       "<noscript><p>The figures are drawn by scripts, which are disabled in this browser. The tables "
                       "contain the same results.</p></noscript>\n" +
                           failed_list(results) + figures(results, number) + line_table(results) + head_table(results) +
                           "<p class=\"small\">Red: no equilibrium, or a utilisation above 1. X: horizontal, astern of "
                           "the stern shoe; Z: above the mean water level; inclinations from horizontal, positive "
                           "dipping astern. Stresses are von Mises stresses, strains longitudinal. Barge ahead: from "
                           "its place at the first stage. Largest utilisation: of the governing code checks and of "
                           "the cable's breaking load.</p>\n");
}

std::string stage_checks_section(const OperationResults& results) {
  std::vector<StageColumn> columns = {
      {"", {"Stage", "", true}, [&](std::size_t i) { return stage_title(results, i); }}};
  columns.push_back({"", {"Verdict", "", true}, [&](std::size_t i) { return stage_verdict(results.stages[i]).words; }});
  bool any = false;
  for (const CheckRegion region : check_regions()) {
    columns.push_back({"Utilisation and governing check", {region_title(region), "", true}, [&, region](std::size_t i) {
                         return check_cell(results.stages[i], region);
                       }});
  }
  std::string folded;
  for (const std::size_t i : all_stages(results)) {
    if (!results.stages[i].lay || results.stages[i].lay->checks.rows.empty()) continue;
    any = true;
    folded += checks_of(results, i);
  }
  if (!any) return "";
  return html::section("stage-checks", "Code checks of the stages",
                       stage_rows_table("Governing check of each region", columns, all_stages(results), "checks stages",
                                        [&](std::size_t i) { return stage_css(results.stages[i]); }) +
                           folded);
}

std::string failure_words(const OperationResults& results, std::size_t stage) {
  const StageFailure& failure = *results.stages[stage].failure;
  std::string text = fmt::format("Stage {} cannot be: {}", stage_title(results, stage), failure.what);
  if (!failure.where.empty()) text += ", " + failure.where;
  if (!failure.why.empty()) text += ": " + failure.why;
  if (text.back() != '.') text += ".";
  if (failure.least_tension) {
    text += fmt::format(" It can be with a tension of {} or more at the top.", shown(*failure.least_tension, "N", 1));
  }
  return text;
}

}  // namespace overbend
