#include "resultfiles/summary/lift_json.h"

namespace overbend {
namespace {

void put_place(const LinePlace& place, Json& json) {
  json["arc_length"] = place.arc_length;
  json["x"] = place.place.x();
  json["y"] = place.place.y();
  json["z"] = place.place.z();
}

Json end_json(const LiftedEnd& end) {
  Json json = {{"x", end.location.place.x()}, {"y", end.location.place.y()}, {"z", end.location.place.z()}};
  json["inclination"] = end.location.inclination;
  json["tension"] = end.tension;
  if (end.free) return json;
  json["horizontal_force"] = end.horizontal_force;
  json["vertical_force"] = end.vertical_force;
  return json;
}

Json moment_json(const MomentPlace& moment) {
  Json json = {{"value", moment.value}};
  put_place(moment.location, json);
  return json;
}

Json line_json(const LiftedLine& line) {
  Json json;
  json["first_end"] = end_json(line.first);
  json["second_end"] = end_json(line.second);
  if (!line.second.free) json["held_end"] = json["second_end"];
  if (line.second.free && !line.first.free) json["held_end"] = json["first_end"];
  json["largest_sagging_moment"] = moment_json(line.sagging);
  json["largest_hogging_moment"] = moment_json(line.hogging);
  json["largest_bending_moment"] = moment_json(line.bending);
  json["largest_bending_moment"]["kind"] = line.sagging.value >= line.hogging.value ? "sagging" : "hogging";
  json["largest_bending_stress"] = line.bending_stress;
  json["largest_von_mises"] = line.von_mises;
  json["largest_tension"] = line.max_tension;
  json["least_tension"] = line.min_tension;
  json["on_bed"] = Json::array();
  for (const BedStretch& stretch : line.on_bed) {
    json["on_bed"].push_back({{"arc_length_from", stretch.from}, {"arc_length_to", stretch.to}});
  }
  if (line.lift_off) {
    put_place(*line.lift_off, json["lift_off"]);
    json["lift_off"]["inclination"] = line.lift_off->inclination;
  }
  json["suspended_length"] = line.suspended_length;
  json["water_crossings"] = line.water_crossings;
  return json;
}

Json wire_json(const LiftedWire& wire) {
  Json json;
  json["on"] = wire.on;
  json["length"] = wire.length;
  json["tension"] = wire.tension_upper;
  json["tension_upper"] = wire.tension_upper;
  json["tension_lower"] = wire.tension_lower;
  json["force_on_pipe"] = {{"x", wire.force.x()}, {"y", wire.force.y()}, {"z", wire.force.z()}};
  json["from_vertical_upper"] = wire.from_vertical_upper;
  json["from_vertical_lower"] = wire.from_vertical_lower;
  if (wire.utilisation) json["utilisation"] = *wire.utilisation;
  Json& attachment_json = json["attachment"];
  put_place(wire.location, attachment_json);
  attachment_json["inclination"] = wire.location.inclination;
  attachment_json["moment"] = wire.moment;
  attachment_json["tension_before"] = wire.tension_before;
  attachment_json["tension_after"] = wire.tension_after;
  attachment_json["shear_before"] = wire.shear_before;
  attachment_json["shear_after"] = wire.shear_after;
  return json;
}

}  // namespace

Json lift_json(const LiftResults& lift) {
  Json json;
  json["lines"] = Json::object();
  json["davits"] = Json::object();
  for (const LiftedLine& line : lift.lines) json["lines"][line.name] = line_json(line);
  for (const LiftedWire& wire : lift.davits) json["davits"][wire.name] = wire_json(wire);
  if (lift.gap) {
    json["gap"] = {{"dx", lift.gap->dx}, {"dy", lift.gap->dy}, {"dz", lift.gap->dz}, {"angle", lift.gap->angle}};
  }
  if (lift.join) {
    put_place(lift.join->location, json["join"]);
    json["join"]["inclination"] = lift.join->location.inclination;
    json["join"]["tension"] = lift.join->tension;
    json["join"]["shear"] = lift.join->shear;
    json["join"]["moment"] = lift.join->moment;
  }
  json["residual"] = lift.residual;
  return json;
}

}  // namespace overbend
