/// Layout of the results of an operation for the page; see page_fields.h.
#pragma once

#include <string>
#include <vector>

#include "report/moored/line_parts.h"
#include "report/stages/hold_points.h"
#include "report/stages/stage_labels.h"
#include "resultfiles/summary/json_fields.h"
#include "results/fields/location_names.h"
#include "results/findings.h"
#include "results/lift_brief.h"
#include "results/sagbend.h"

namespace overbend {

/// Returns the ranges of pull head and cable along the line, as distances from the tensioner [m].
template <class Style>
auto page_line_parts(const Style& style, const StaticResults& lay, double head_length) {
  const LineParts parts = line_parts(lay, head_length).value_or(LineParts{});
  const double top = lay.stations.empty() ? 0.0 : lay.stations.back().s;
  JsonWriter<Style> json(style);
  json["head_from"] = style.number(top - parts.head_to);
  json["head_to"] = style.number(top - parts.head_from);
  json["cable_at_far_end"] = style.flag(parts.cable_at_far_end);
  return style.named("LineParts", json.take());
}

/// Returns the monitored values of a stage that has an equilibrium.
template <class Style>
auto page_stage_values(const Style& style, const StageResult& stage) {
  const StaticResults& lay = *stage.lay;
  const HeadResult head = lay.head.value_or(HeadResult{});
  const std::optional<StageUtilisation> use = find_max_utilisation(stage);
  const bool has_cable = lay.cable.has_value(), has_use = has_cable && lay.cable->utilisation.has_value();
  const bool has_head = lay.head.has_value(), has_boxes = !lay.supports.empty();
  JsonWriter<Style> json(style);
  const auto maybe = [&](bool available, double value) {
    return style.maybe(available, [&] { return style.number(value); });
  };
  json["top_tension"] = maybe(lay.has_pipe(), lay.top_tension);
  json["bottom_tension"] = maybe(lay.has_pipe(), lay.bottom_tension);
  json["head_x"] = maybe(has_head, head.astern);
  json["head_z"] = maybe(has_head, head.p_W.z());
  json["head_clearance"] = maybe(has_head, head.clearance);
  json["cable_tension"] = maybe(has_cable, has_cable ? lay.cable->max_tension : 0.0);
  json["cable_utilisation"] = maybe(has_use, has_use ? *lay.cable->utilisation : 0.0);
  json["sagbend_von_mises"] = maybe(has_sagbend(lay), lay.sagbend.von_mises.value);
  json["sagbend_strain"] = maybe(has_sagbend(lay), lay.sagbend.strain.value);
  json["overbend_strain"] = maybe(lay.overbend.has_value(), lay.overbend ? lay.overbend->strain.value : 0.0);
  json["stinger_tip_clearance"] = maybe(lay.stinger_tip_clearance.has_value(), lay.stinger_tip_clearance.value_or(0.0));
  json["largest_reaction"] = maybe(has_boxes, lay.max_reaction);
  json["largest_reaction_support"] = style.text(lay.max_reaction_support);
  json["lay_back"] = maybe(lay.has_pipe(), lay.lay_back);
  const LiftBrief lift = lay.lift ? in_brief(*lay.lift) : LiftBrief{};
  json["end_height"] = maybe(lift.end_height.has_value(), lift.end_height.value_or(0.0));
  json["largest_moment"] = maybe(lay.lift.has_value(), lift.moment);
  json["largest_bending_stress"] = maybe(lay.lift.has_value(), lift.stress);
  json["davit_tension"] = maybe(lay.lift.has_value(), lift.davit_tension);
  json["utilisation"] = maybe(use.has_value(), use ? use->utilisation : 0.0);
  json["check"] = style.text(use ? use->what : "");
  json["verdict"] = style.text(stage_verdict(stage).headline);
  return style.named("StageValues", json.take());
}

template <class Style>
auto page_stage_failure(const Style& style, const StageFailure& failure) {
  JsonWriter<Style> json(style);
  json["what"] = style.text(failure.what);
  json["where"] = style.text(failure.where);
  json["why"] = style.text(failure.why);
  json["least_tension"] =
      style.maybe(failure.min_tension.has_value(), [&] { return style.number(failure.min_tension.value_or(0.0)); });
  return style.named("StageFailure", json.take());
}

template <class Style>
auto page_stage(const Style& style, const StageResult& stage, double head_length) {
  const std::optional<double> out = stage_progress(stage.stage);
  const std::optional<double>& tension = stage.stage.tension;
  StageResult example;  // provides the types of missing members
  example.lay = StaticResults{};
  JsonWriter<Style> json(style);
  json["name"] = style.text(stage.stage.name);
  json["out"] = style.maybe(out.has_value(), [&] { return style.number(out.value_or(0.0)); });
  json["tension"] = style.maybe(tension.has_value(), [&] { return style.number(tension.value_or(0.0)); });
  json["barge_ahead"] = style.number(stage.barge_ahead);
  json["governing"] = style.text(stage.governing);
  json["values"] =
      style.maybe(stage.lay.has_value(), [&] { return page_stage_values(style, stage.lay ? stage : example); });
  json["parts"] = style.maybe(stage.lay && stage.lay->head, [&] {
    return page_line_parts(style, stage.lay ? *stage.lay : *example.lay, head_length);
  });
  json["failure"] = style.maybe(stage.failure.has_value(),
                                [&] { return page_stage_failure(style, stage.failure.value_or(StageFailure{})); });
  json["findings"] = style.findings(stage.findings);
  return style.named("OperationStage", json.take());
}

template <class Style>
auto page_hold_point(const Style& style, const HoldPoint& point) {
  JsonWriter<Style> json(style);
  json["stage"] = style.count(point.stage);
  json["what"] = style.text(point.what);
  json["out"] = style.maybe(point.out.has_value(), [&] { return style.number(point.out.value_or(0.0)); });
  return style.named("HoldPoint", json.take());
}

/// Returns the table of all stages; the shape of each line is requested separately.
template <class Style>
auto page_operation(const Style& style, const OperationResults& results, double head_length) {
  JsonWriter<Style> json(style);
  json["title"] = style.text(operation_title(results.type));
  json["out_name"] = style.text(progress_name(results.type));
  json["stages"] =
      style.rows(results.stages, [&](const StageResult& stage) { return page_stage(style, stage, head_length); });
  json["hold_points"] =
      style.rows(hold_points(results), [&](const HoldPoint& point) { return page_hold_point(style, point); });
  json["findings"] = style.findings(results.findings);
  return json.take();
}

}  // namespace overbend
