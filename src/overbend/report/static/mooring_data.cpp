#include "report/static/mooring_data.h"

#include "report/page/json_number.h"

namespace overbend {
namespace {

Json point(const Vec3& p_W) {
  return {json_number(p_W.x()), json_number(p_W.y()), json_number(p_W.z())};
}

Json points(const std::vector<Vec3>& all) {
  Json out = Json::array();
  for (const Vec3& p_W : all) out.push_back(point(p_W));
  return out;
}

Json or_null(const std::optional<double>& value) {
  return value ? json_number(*value) : Json(nullptr);
}

Json line_data(const MooringLineResult& line) {
  return {{"name", line.name},
          {"tension", json_number(line.fairlead_tension)},
          {"use", or_null(line.utilisation)},
          {"slack", line.slack},
          {"parted", line.parted},
          {"on_bed", json_number(line.on_bed)},
          {"touchdown", json_number(line.touchdown_distance)},
          {"fairlead", point(line.fairlead_W)},
          {"anchor", point(line.anchor_W)},
          {"shape", points(line.shape_W)}};
}

Json shift_data(const MotionStatistics& shift) {
  return {{"min", json_number(shift.whole.min)},
          {"max", json_number(shift.whole.max)},
          {"mean", json_number(shift.whole.mean)},
          {"std", json_number(shift.whole.std)}};
}

Json state_data(const MooredState& state) {
  Json lines = Json::array();
  for (const MooringLineResult& line : state.moorings) lines.push_back(line_data(line));
  return {{"name", state.name},
          {"surge", json_number(state.vessel.surge)},
          {"sway", json_number(state.vessel.sway)},
          {"yaw", json_number(state.vessel.yaw)},
          {"lines", std::move(lines)}};
}

Json numbers(const std::vector<double>& values) {
  Json out = Json::array();
  for (const double value : values) out.push_back(json_number(value));
  return out;
}

Json pipe_data(const PipeAtStep& pipe) {
  return {{"tension", json_number(pipe.top_tension)},
          {"overbend", json_number(pipe.overbend_bending_stress)},
          {"sagbend", json_number(pipe.sagbend_bending_stress)},
          {"clearance", or_null(pipe.stinger_tip_clearance)}};
}

Json step_data(const MoveStep& step) {
  return {{"advance", json_number(step.advance)},
          {"tensions", numbers(step.tensions)},
          {"lengths", numbers(step.lengths)},
          {"pipe", step.pipe ? pipe_data(*step.pipe) : Json(nullptr)}};
}

/// The positions of a pull-ahead; the stages if only these are known.
Json make_steps(const MooringResults& results) {
  Json out = Json::array();
  for (const MoveStep& step : results.steps) out.push_back(step_data(step));
  if (!out.empty() || results.operation != "pull_ahead") return out;
  for (const MooredState& stage : results.stages) {
    MoveStep step;
    step.advance = stage.vessel.surge;
    for (const MooringLineResult& line : stage.moorings) {
      step.tensions.push_back(line.fairlead_tension);
      step.lengths.push_back(line.first_segment_length);
    }
    out.push_back(step_data(step));
  }
  return out;
}

}  // namespace

Json mooring_figure_data(const MooringResults& results, const MooringScene& scene) {
  Json states = Json::array({state_data(results.rest)});
  for (const MooredState& stage : results.stages) states.push_back(state_data(stage));
  Json objects = Json::array();
  for (const SeabedObjectDescription& object : scene.objects) {
    objects.push_back({{"name", object.name}, {"points", points(object.points)}});
  }
  return {{"length", json_number(scene.length)},
          {"beam", json_number(scene.beam)},
          {"heading", json_number(scene.heading)},
          {"water_depth", json_number(scene.water_depth)},
          {"waves_from", numbers(scene.waves_from)},
          {"current_to", or_null(scene.current_to)},
          {"pipe", points(scene.pipe_W)},
          {"touchdown", scene.pipe_W.empty() ? Json(nullptr) : point(scene.touchdown_W)},
          {"objects", std::move(objects)},
          {"operation", results.operation},
          {"steps", make_steps(results)},
          {"states", std::move(states)}};
}

Json vessel_figure_data(const VesselDynamics& vessel) {
  return {{"along", shift_data(vessel.along)},
          {"across", shift_data(vessel.across)},
          {"covariance", json_number(vessel.covariance)},
          {"start_surge", json_number(vessel.start_surge)},
          {"start_sway", json_number(vessel.start_sway)},
          {"start_yaw", json_number(vessel.start_yaw)}};
}

}  // namespace overbend
