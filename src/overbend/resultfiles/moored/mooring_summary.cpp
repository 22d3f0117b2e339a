#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "results/fields/moored_fields.h"
#include "results/fields/mooring_fields.h"
#include "results/fields/move_fields.h"

namespace overbend {
namespace {

/// A 6 x 6 matrix, null without values.
Json square(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  Json rows = Json::array();
  for (std::size_t i = 0; i < values.size(); i += 6) {
    rows.push_back(std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(i),
                                       values.begin() + static_cast<std::ptrdiff_t>(i) + 6));
  }
  return rows;
}

Json vessel_json(const SummaryStyle& style, const VesselResult& vessel) {
  JsonWriter json(style);
  visit_vessel_offset(vessel, json);
  json["natural_periods"] = Json::array();
  for (const PeriodResult& period : vessel.natural_periods) {
    json["natural_periods"].push_back(Json{{"mode", period.mode}, {"period", period.period}});
  }
  json["stiffness"] = square(vessel.stiffness);
  return json.take();
}

Json line_json(const SummaryStyle& style, const MooringLineResult& line) {
  JsonWriter json(style);
  visit_mooring_line(line, json);
  json["length_on_bed"] = line.on_bed;
  visit_mooring_use(line, json);
  if (line.clearance) json["nearest_object"] = line.nearest_object;
  return json.take();
}

Json state_json(const SummaryStyle& style, const MooredState& state) {
  Json json;
  json["vessel"] = vessel_json(style, state.vessel);
  json["moorings"] = style.rows(state.moorings, [&](const MooringLineResult& line) { return line_json(style, line); });
  json["mooring_force"] = state.mooring_force.empty() ? Json(nullptr) : Json(state.mooring_force);
  json["mooring_stiffness"] = square(state.mooring_stiffness);
  if (!state.thrust.empty()) {
    json["thrust"] = Json{{"surge", state.thrust[0]}, {"sway", state.thrust[1]}, {"yaw", state.thrust[2]}};
  }
  json["balance"] = Json{{"force_residual", state.residual}};
  json["iterations"] = state.iterations;
  return json;
}

Json stage_json(const SummaryStyle& style, const MooredState& state) {
  Json json;
  json["name"] = state.name;
  json.update(state_json(style, state));
  json["winch_lengths"] = Json::object();
  for (const MooringLineResult& line : state.moorings) json["winch_lengths"][line.name] = line.first_segment_length;
  return json;
}

/// A position of a pull-ahead.
Json step_json(const SummaryStyle& style, const MooringResults& results, const MoveStep& step) {
  JsonWriter json(style);
  visit_move_step(step, json);
  json["vessel"] = make_object(style, [&](auto& vessel) { visit_vessel_offset(step.vessel, vessel); });
  for (std::size_t i = 0; i < step.lengths.size(); ++i) {
    const std::string& name = results.rest.moorings[i].name;
    json["winch_lengths"][name] = step.lengths[i];
    json["fairlead_tensions"][name] = step.tensions[i];
  }
  if (step.pipe) {
    json["pipe"] = make_object(style, [&](auto& pipe) { visit_pipe_at_step(*step.pipe, pipe); });
    const std::optional<double>& clearance = step.pipe->stinger_tip_clearance;
    json["pipe"]["stinger_tip_clearance"] = clearance ? Json(*clearance) : Json(nullptr);
  }
  json["balance"] = Json{{"force_residual", step.residual}};
  return json.take();
}

/// Winch operations, with the positions of the pull-ahead.
Json winches_json(const SummaryStyle& style, const MooringResults& results) {
  Json json;
  json["lines"] = style.rows(results.winches, [&](const WinchMove& move) {
    Json line = make_object(style, [&](auto& visitor) { visit_winch_move(move, visitor); });
    line["winch"] = move.after - move.before;
    return line;
  });
  if (results.operation != "pull_ahead") return json;
  json["distance"] = results.distance;
  json["steps"] = style.rows(results.steps, [&](const MoveStep& step) { return step_json(style, results, step); });
  return json;
}

void add_operation(const SummaryStyle& style, const MooringResults& results, Json& json) {
  if (!results.operation.empty()) {
    json["operation"]["type"] = results.operation;
    json["operation"]["stages"] =
        style.rows(results.stages, [&](const MooredState& stage) { return stage_json(style, stage); });
  }
  if (results.operation == "anchor_plan") {
    json["operation"]["anchors"] = style.rows(results.anchors, [&](const AnchorDue& due) {
      return make_object(style, [&](auto& visitor) { visit_anchor_due(due, visitor); });
    });
  }
  if (!results.winches.empty() || !results.steps.empty()) {
    json["operation"][results.operation] = winches_json(style, results);
  }
}

Json hull_json(const SummaryStyle& style, const HullResults& hull) {
  JsonWriter json(style);
  visit_hull(hull, json);
  visit_steady_loads(hull, json);
  json["radiation"] = style.rows(hull.entries, [&](const RadiationEntryResult& entry) {
    return make_object(style, [&](auto& visitor) { visit_radiation_entry(entry, visitor); });
  });
  json["fit"] = style.rows(hull.groups, [&](const RadiationGroupResult& group) {
    return make_object(style, [&](auto& visitor) { visit_radiation_group(group, visitor); });
  });
  json["damping"] = style.rows(hull.damping, [&](const ModeDampingResult& mode) {
    return make_object(style, [&](auto& visitor) { visit_mode_damping(mode, visitor); });
  });
  return json.take();
}

Json line_in_time(const SummaryStyle& style, const MooringLineDynamics& line) {
  JsonWriter json(style);
  visit_mooring_dynamics(line, json);
  json["events"] = style.rows(line.events, [&](const MooringEvent& event) {
    return make_object(style, [&](auto& visitor) { visit_mooring_event(event, visitor); });
  });
  return json.take();
}

}  // namespace

void add_hull(const HullResults& hull, Json& summary) {
  summary["static"]["hull"] = hull_json(SummaryStyle{}, hull);
}

void add_moored_dynamics(const DynamicResults& results, Json& summary) {
  const SummaryStyle style;
  Json& dynamic = summary["dynamic"];
  if (results.vessel) {
    dynamic["vessel"] = make_object(style, [&](auto& visitor) { visit_vessel_dynamics(*results.vessel, visitor); });
  }
  if (!results.thrust.empty()) {
    dynamic["thrust"] = style.rows(results.thrust, [&](const ThrustDynamics& thrust) {
      return make_object(style, [&](auto& visitor) { visit_thrust_dynamics(thrust, visitor); });
    });
  }
  if (results.moorings.empty()) return;
  dynamic["moorings"] =
      style.rows(results.moorings, [&](const MooringLineDynamics& line) { return line_in_time(style, line); });
}

void add_moorings(const MooringResults& results, Json& summary) {
  const SummaryStyle style;
  const Json rest = state_json(style, results.rest);
  for (const auto& [key, value] : rest.items()) {
    if (Json& statics = summary["static"]; !statics.contains(key)) statics[key] = value;
  }
  add_operation(style, results, summary);
}

}  // namespace overbend
