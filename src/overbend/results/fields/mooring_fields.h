/// Fields of the static results of hull and moorings; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/mooring_results.h"

namespace overbend {

template <class Row, class Visit>
void visit_vessel_offset(Row& r, Visit& visit) {
  visit(ResultField{"surge", "m", "Shift of midship forward from the nominal position"}.summary(), r.surge);
  visit(ResultField{"sway", "m", "Shift to port"}.summary(), r.sway);
  visit(ResultField{"heave", "m", "Shift upwards"}.summary(), r.heave);
  visit(ResultField{"roll", "rad", "Starboard down, from the nominal pose"}.summary(), r.roll);
  visit(ResultField{"pitch", "rad", "Bow down, from the nominal pose"}.summary(), r.pitch);
  visit(ResultField{"yaw", "rad", "Bow to port, from the nominal pose"}.summary(), r.yaw);
}

template <class Row, class Visit>
void visit_mooring_line(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.csv("line").summary().shown(0), r.name);
  visit(ResultField{"length", "m", "Unstressed length"}.csv("length").summary().shown(2), r.length);
  visit(
      ResultField{"first_segment_length", "m", "Unstressed length of the first segment"}.csv("first segment").summary(),
      r.first_segment_length);
  visit(ResultField{"fairlead_tension", "N", "Tension at the fairlead"}
            .csv("fairlead tension")
            .summary()
            .shown(1, "Tension"),
        r.fairlead_tension);
  visit(ResultField{"horizontal", "N", "Horizontal component of the tension at the fairlead"}
            .csv("horizontal")
            .summary()
            .shown(1),
        r.horizontal);
  visit(ResultField{"declination", "rad", "Angle of the line below horizontal at the fairlead"}
            .csv("declination")
            .summary()
            .shown(2),
        r.declination);
  visit(ResultField{"anchor_tension", "N", "Tension at the anchor"}.csv("anchor tension").summary().shown(1, "Anchor"),
        r.anchor_tension);
  visit(ResultField{"anchor_uplift", "N", "Vertical force on the anchor"}.csv("uplift").summary(), r.anchor_uplift);
  visit(ResultField{"uplift_angle", "rad", "Angle of the line above horizontal at the anchor"}
            .csv("uplift angle")
            .summary()
            .shown(2),
        r.uplift_angle);
  visit(ResultField{"suspended_length", "m", "Unstressed length from the fairlead to touchdown"}
            .csv("suspended")
            .summary()
            .shown(1),
        r.suspended_length);
  visit(ResultField{"touchdown_distance", "m", "Horizontal distance from the fairlead to touchdown"}
            .csv("touchdown distance")
            .summary(),
        r.touchdown_distance);
  visit(ResultField{"on_bed", "m", "Unstressed length on the seabed"}.csv("on bed").summary().shown(1), r.on_bed);
  visit(
      ResultField{"horizontal_distance", "m", "Horizontal distance from fairlead to anchor"}.csv("distance").summary(),
      r.horizontal_distance);
  visit(ResultField{"azimuth", "rad", "Azimuth of the anchor from the fairlead, clockwise from north"}
            .csv("azimuth")
            .summary()
            .shown(1),
        r.azimuth);
  visit(ResultField{"slack", "1", "1 if there is no horizontal tension"}.summary(), r.slack);
  visit(ResultField{"parted", "1", "1 if the line has parted"}.summary(), r.parted);
  visit(ResultField{"fairlead", "m", "Fairlead", kWorldFrame}.summary(), r.fairlead_W);
  visit(ResultField{"anchor", "m", "Anchor", kWorldFrame}.summary(), r.anchor_W);
}

/// Fields that exist only if the model gives a breaking load, a holding power or objects on the seabed.
template <class Row, class Visit>
void visit_mooring_use(Row& r, Visit& visit) {
  visit(ResultField{"utilisation", "1", "Tension over the minimum breaking load"}.summary().shown(3, "Utilisation"),
        r.utilisation);
  visit(ResultField{"anchor_utilisation", "1", "Tension at the anchor over its holding power"}.summary().shown(
            3, "Anchor utilisation"),
        r.anchor_utilisation);
  visit(ResultField{"clearance", "m", "Minimum distance to the objects on the seabed"}.summary().shown(1, "Clearance"),
        r.clearance);
}

template <class Row, class Visit>
void visit_winch_move(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.summary(), r.name);
  visit(ResultField{"first_segment_before", "m", "Unstressed length before the move"}.summary(), r.before);
  visit(ResultField{"first_segment_after", "m", "Unstressed length after it"}.summary(), r.after);
  visit(ResultField{"fairlead_tension_before", "N", "Tension before the move"}.summary(), r.tension_before);
  visit(ResultField{"fairlead_tension_after", "N", "Tension after it"}.summary(), r.tension_after);
}

}  // namespace overbend
