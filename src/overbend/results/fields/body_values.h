/// The values of bodies that lines are on; result_field.h has the idea.
#pragma once

#include "results/body_results.h"
#include "results/fields/result_field.h"

namespace overbend {

/// Where a body lies from as drawn.
template <class Row, class Visit>
void visit_body_shift(Row& r, Visit& visit) {
  visit(ResultField{"surge", "m", "Forward, from as drawn"}.summary(), r.surge);
  visit(ResultField{"sway", "m", "To port, from as drawn"}.summary(), r.sway);
  visit(ResultField{"heave", "m", "Up, from as drawn"}.summary(), r.heave);
  visit(ResultField{"roll", "rad", "Starboard down, from as drawn"}.summary(), r.roll);
  visit(ResultField{"pitch", "rad", "Bow down, from as drawn"}.summary(), r.pitch);
  visit(ResultField{"yaw", "rad", "Bow to port, from as drawn"}.summary(), r.yaw);
}

/// A body at rest: a row of static.bodies.
template <class Row, class Visit>
void visit_body(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the body"}.summary(), r.name);
  visit(ResultField{"floats", "1", "Whether it lies where lines and water let it"}.summary(), r.floats);
  visit(ResultField{"place", "m", "Of its origin, midship on its water line", kWorldFrame}.summary(), r.place);
  visit(ResultField{"heading", "rad", "Azimuth of its bow, clockwise from north"}.summary(), r.heading);
  visit_body_shift(r, visit);
  visit(ResultField{"force", "N", "Force of all lines on it", kWorldFrame}.summary(), r.force);
  visit(ResultField{"moment", "N m", "Moment of all lines on it, about its origin", kWorldFrame}.summary(), r.moment);
}

/// A body over time: a row of dynamic.bodies.
template <class Row, class Visit>
void visit_body_in_time(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the body"}.summary(), r.name);
  visit_spread(ResultField{"surge", "m", "Forward, from as drawn"}.summary("surge/*"), r.surge, visit);
  visit_spread(ResultField{"sway", "m", "To port, from as drawn"}.summary("sway/*"), r.sway, visit);
  visit_spread(ResultField{"heave", "m", "Up, from as drawn"}.summary("heave/*"), r.heave, visit);
  visit_spread(ResultField{"roll", "rad", "Starboard down, from as drawn"}.summary("roll/*"), r.roll, visit);
  visit_spread(ResultField{"pitch", "rad", "Bow down, from as drawn"}.summary("pitch/*"), r.pitch, visit);
  visit_spread(ResultField{"yaw", "rad", "Bow to port, from as drawn"}.summary("yaw/*"), r.yaw, visit);
  visit_spread(ResultField{"pull", "N", "Horizontal force of all lines on it"}.summary("pull/*"), r.pull, visit);
}

}  // namespace overbend
