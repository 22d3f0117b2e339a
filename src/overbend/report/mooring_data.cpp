#include "report/mooring_data.h"

#include "report/json_number.h"

namespace overbend {
namespace {

using nlohmann::json;

json point(const Vec3& p_W) {
  return {json_number(p_W.x()), json_number(p_W.y()), json_number(p_W.z())};
}

json points(const std::vector<Vec3>& all) {
  json out = json::array();
  for (const Vec3& p_W : all) out.push_back(point(p_W));
  return out;
}

json or_null(const std::optional<double>& value) {
  return value ? json_number(*value) : json(nullptr);
}

json line_data(const MooringLineResult& line) {
  return {{"name", line.name},
          {"tension", json_number(line.fairlead_tension)},
          {"use", or_null(line.utilisation)},
          {"length", json_number(line.first_segment_length)},
          {"slack", line.slack},
          {"parted", line.parted},
          {"on_bed", json_number(line.on_bed)},
          {"touchdown", json_number(line.touchdown_distance)},
          {"fairlead", point(line.fairlead_W)},
          {"anchor", point(line.anchor_W)},
          {"shape", points(line.shape_W)}};
}

json shift_data(const MotionSpread& shift) {
  return {{"min", json_number(shift.whole.min)},
          {"max", json_number(shift.whole.max)},
          {"mean", json_number(shift.whole.mean)},
          {"std", json_number(shift.whole.std)}};
}

json state_data(const MooredState& state) {
  json lines = json::array();
  for (const MooringLineResult& line : state.moorings) lines.push_back(line_data(line));
  return {{"name", state.name},
          {"surge", json_number(state.vessel.surge)},
          {"sway", json_number(state.vessel.sway)},
          {"yaw", json_number(state.vessel.yaw)},
          {"lines", std::move(lines)}};
}

}  // namespace

json mooring_figure_data(const MooringResults& results, const MooringScene& scene) {
  json states = json::array({state_data(results.rest)});
  for (const MooredState& stage : results.stages) states.push_back(state_data(stage));
  json objects = json::array();
  for (const SeabedObjectDescription& object : scene.objects) {
    objects.push_back({{"name", object.name}, {"points", points(object.points)}});
  }
  return {{"length", json_number(scene.length)},
          {"beam", json_number(scene.beam)},
          {"heading", json_number(scene.heading)},
          {"water_depth", json_number(scene.water_depth)},
          {"waves_from", or_null(scene.waves_from)},
          {"current_to", or_null(scene.current_to)},
          {"pipe", points(scene.pipe_W)},
          {"touchdown", scene.pipe_W.empty() ? json(nullptr) : point(scene.touchdown_W)},
          {"objects", std::move(objects)},
          {"operation", results.operation},
          {"distance", json_number(results.distance)},
          {"states", std::move(states)}};
}

json vessel_figure_data(const VesselDynamics& vessel) {
  return {{"along", shift_data(vessel.along)},
          {"across", shift_data(vessel.across)},
          {"covariance", json_number(vessel.covariance)},
          {"start_surge", json_number(vessel.start_surge)},
          {"start_sway", json_number(vessel.start_sway)},
          {"start_yaw", json_number(vessel.start_yaw)}};
}

}  // namespace overbend
