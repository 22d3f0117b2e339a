#include "resultfiles/stages/dragging_json.h"

#include "resultfiles/summary/summary_fields.h"
#include "results/fields/dragging_fields.h"

namespace overbend {
namespace {

Json tensions(const StaticResults& lay) {
  return {{"tensioner", lay.top_tension},
          {"touchdown", lay.dragging->touchdown_tension},
          {"pipe_end", lay.dragging->pipe_end_tension},
          {"head", lay.head->tension},
          {"winch", lay.dragging->winch_tension}};
}

/// Adds the maximum moment of a region to the existing members.
Json with_moment(Json members, const StaticResults& lay, const RegionResult& region) {
  members["moment"] = region.bending_moment.value;
  members["stress"] = region.bending_stress.value;
  members["x"] = region.bending_moment.astern;
  members["arc_length"] = lay.total_length - region.bending_moment.s;
  return members;
}

Json sagbend(Json members, const StaticResults& lay) {
  members = with_moment(std::move(members), lay, lay.sagbend);
  members["x"] = lay.dragging->sagbend_x;
  members["arc_length"] = lay.dragging->sagbend_from_top;
  return members;
}

Json touchdown(Json members, const StaticResults& lay) {
  members["x"] = lay.touchdown.astern;
  members["arc_length"] = lay.length_top_to_touchdown;
  return members;
}

Json lift_off(const DraggingResults& dragging) {
  if (!dragging.lift_off) return nullptr;
  Json json = make_object(SummaryStyle{}, [&](auto& members) { visit_lift_off(*dragging.lift_off, members); });
  json["of"] = dragging.lift_off->cable ? "wire" : "pipe or head";
  return json;
}

}  // namespace

Json dragging_json(const StaticResults& lay, const Json& stage) {
  const SummaryStyle style;
  const DraggingResults& dragging = *lay.dragging;
  Json head = stage.at("head");
  head["wire_inclination"] = lay.head->cable_inclination;
  Json json = {{"wire_out", lay.cable->length},
               {"tension", tensions(lay)},
               {"wire_largest_tension", lay.cable->max_tension},
               {"wire_utilisation", lay.cable->utilisation ? Json(*lay.cable->utilisation) : Json(nullptr)},
               {"least_tension", lay.min_effective_tension.value},
               {"departure_angle", lay.top_inclination},
               {"touchdown", touchdown(stage.at("touchdown"), lay)},
               {"head", std::move(head)},
               {"sagbend", sagbend(stage.at("sagbend"), lay)},
               {"lift_off", lift_off(dragging)},
               {"winch", {{"inclination", dragging.winch_inclination}}}};
  json["contacts"] = style.rows(dragging.contacts, [&](const BedContactResult& contact) {
    return make_object(style, [&](auto& members) { visit_bed_contact(contact, members); });
  });
  if (lay.overbend) json["overbend"] = with_moment(stage.at("overbend"), lay, *lay.overbend);
  if (!lay.supports.empty()) json["departure_angle_last_roller"] = lay.departure_angle;
  return json;
}

}  // namespace overbend
