#include "model/description/operation_names.h"
#include "resultfiles/lines/bodies_files.h"
#include "resultfiles/stages/dragging_json.h"
#include "resultfiles/stages/operation_writer.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/static/passage_json.h"
#include "resultfiles/summary/lift_json.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "results/findings.h"
#include "results/governing_stage.h"

namespace overbend {
namespace {

/// Inputs that were not given are omitted instead of null.
void drop_nulls(Json& json) {
  for (auto member = json.begin(); member != json.end();) member = member->is_null() ? json.erase(member) : ++member;
}

const char* operation_status(const OperationResults& results) {
  const auto stands = [](const StageResult& stage) { return stage.lay.has_value(); };
  const auto standing = std::count_if(results.stages.begin(), results.stages.end(), stands);
  if (standing == 0) return "failed";
  return standing == static_cast<std::ptrdiff_t>(results.stages.size()) ? "converged" : "some stages failed";
}

/// Check with the maximum utilisation over the stages, with the name of its stage; null if none was judged.
Json worst_json(const SummaryStyle& style, const OperationResults& results) {
  const StageResult* stage = find_governing_stage(results);
  if (stage == nullptr) return nullptr;
  Json json = summary_check(style, *find_governing_check(stage->lay->checks));
  json["stage"] = stage->stage.name;
  return json;
}

/// Section of the pipe, common to all stages; empty if no stage has an equilibrium.
Json derived_json(const SummaryStyle& style, const OperationResults& results) {
  for (const StageResult& stage : results.stages) {
    if (!stage.lay || stage.lay->sections.empty()) continue;
    return make_object(style, [&](auto& visitor) { visit_section(stage.lay->sections.front(), visitor); });
  }
  return Json::object();
}

}  // namespace

Json stage_summary_json(const StageResult& stage) {
  const SummaryStyle style;
  Json json = make_object(style, [&](auto& visitor) { visit_lay_stage(stage.stage, visitor); });
  drop_nulls(json);
  json["status"] = stage.lay ? "converged" : "failed";
  json.update(make_object(style, [&](auto& visitor) { visit_stage_result(stage, visitor); }));
  json["verdict"] = verdict_json(stage_verdict(stage));
  if (stage.failure) {
    json["failure"] = make_object(style, [&](auto& visitor) { visit_stage_failure(*stage.failure, visitor); });
  }
  if (stage.lay && stage.lay->lift) {
    json.update(lift_json(*stage.lay->lift));
    if (!stage.lay->bodies.empty()) json["bodies"] = bodies_json(stage.lay->bodies);
    json["checks"] = summary_checks(style, stage.lay->checks);
    json["lift_findings"] = findings_json(stage.lay->findings);
  } else if (stage.lay) {
    json.update(static_part(style, *stage.lay));
    json["lay_warnings"] = messages(stage.lay->findings);
    json["lay_findings"] = findings_json(stage.lay->findings);
    json["checks"] = summary_checks(style, stage.lay->checks);
    if (stage.lay->dragging) json.update(dragging_json(*stage.lay, json));
  }
  return json;
}

Json operation_summary_json(const OperationResults& results) {
  const SummaryStyle style;
  JsonWriter json(style);
  json["status"] = operation_status(results);
  visit_operation_heading(results, json);
  json["units"] = "SI: m, N, Pa, rad, s; angles from horizontal";
  json["frame"] = kWorldFrame;
  json["derived"] = derived_json(style, results);
  json["verdict"] = verdict_json(operation_verdict(results));
  json["checks"] = Json{{"worst", worst_json(style, results)}};
  Json& operation = json["operation"];
  operation["type"] = operation_name(results.type);
  operation["wall_time"] = results.wall_time;
  if (const std::optional<PassageResults> passage = find_passage_maxima(results)) {
    operation["passage"] = passage_json(*passage);
  }
  operation["stages"] = style.rows(results.stages, [&](const StageResult& stage) { return stage_summary_json(stage); });
  return json.take();
}

std::string operation_summary(const OperationResults& results) {
  return summary_text(operation_summary_json(results));
}

}  // namespace overbend
