/// Fields of bodies connected to lines; see result_field.h.
#pragma once

#include "results/body_results.h"
#include "results/fields/result_field.h"

namespace overbend {

/// Offset of a body from its nominal pose.
template <class Row, class Visit>
void visit_body_shift(Row& r, Visit& visit) {
  visit(ResultField{"surge", "m", "Forward offset from the nominal pose"}.summary(), r.surge);
  visit(ResultField{"sway", "m", "Offset to port from the nominal pose"}.summary(), r.sway);
  visit(ResultField{"heave", "m", "Upward offset from the nominal pose"}.summary(), r.heave);
  visit(ResultField{"roll", "rad", "Starboard down, from the nominal pose"}.summary(), r.roll);
  visit(ResultField{"pitch", "rad", "Bow down, from the nominal pose"}.summary(), r.pitch);
  visit(ResultField{"yaw", "rad", "Bow to port, from the nominal pose"}.summary(), r.yaw);
}

/// Static results of a body: a row of static.bodies.
template <class Row, class Visit>
void visit_body(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the body"}.summary(), r.name);
  visit(ResultField{"floats", "1", "1 if lines and water determine its pose, 0 if it is prescribed"}.summary(),
        r.floats);
  visit(ResultField{"place", "m", "Position of its origin, midship on its water line", kWorldFrame}.summary(), r.place);
  visit(ResultField{"heading", "rad", "Azimuth of its bow, clockwise from north"}.summary(), r.heading);
  visit_body_shift(r, visit);
  visit(ResultField{"force", "N", "Resultant force of all lines on the body", kWorldFrame}.summary(), r.force);
  visit(ResultField{"moment", "N m", "Resultant moment of all lines on the body, about its origin", kWorldFrame}
            .summary(),
        r.moment);
}

/// Results of a body over time: a row of dynamic.bodies.
template <class Row, class Visit>
void visit_body_in_time(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the body"}.summary(), r.name);
  visit_spread(ResultField{"surge", "m", "Forward offset from the nominal pose"}.summary("surge/*"), r.surge, visit);
  visit_spread(ResultField{"sway", "m", "Offset to port from the nominal pose"}.summary("sway/*"), r.sway, visit);
  visit_spread(ResultField{"heave", "m", "Upward offset from the nominal pose"}.summary("heave/*"), r.heave, visit);
  visit_spread(ResultField{"roll", "rad", "Starboard down, from the nominal pose"}.summary("roll/*"), r.roll, visit);
  visit_spread(ResultField{"pitch", "rad", "Bow down, from the nominal pose"}.summary("pitch/*"), r.pitch, visit);
  visit_spread(ResultField{"yaw", "rad", "Bow to port, from the nominal pose"}.summary("yaw/*"), r.yaw, visit);
  visit_spread(ResultField{"pull", "N", "Horizontal force of all lines on the body"}.summary("pull/*"), r.pull, visit);
}

}  // namespace overbend
