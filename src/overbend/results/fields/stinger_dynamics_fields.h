/// Fields of a stinger on hinges over time; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/stinger_dynamics.h"

namespace overbend {

template <class Row, class Visit>
void visit_stinger_dynamics(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the section"}.summary(), r.name);
  visit_spread(ResultField{"angle", "rad", "Angle from the nominal position, positive for tip down"}.summary(), r.angle,
               visit);
  visit_spread(ResultField{"hinge_longitudinal", "N", "Force of the hinge on the section, level astern"}.summary(
                   "hinge_force/longitudinal"),
               r.hinge_longitudinal, visit);
  visit_spread(
      ResultField{"hinge_vertical", "N", "Force of the hinge on the section, upwards"}.summary("hinge_force/vertical"),
      r.hinge_vertical, visit);
  visit_spread(
      ResultField{"hinge_force", "N", "Force of the hinge on the section, magnitude"}.summary("hinge_force/magnitude"),
      r.hinge_force, visit);
  visit_spread(ResultField{"stop_moment", "N m", "Moment of the stops on the section, positive for tip down"}.summary(),
               r.stop_moment, visit);
  visit_spread(
      ResultField{"draught", "m", "Depth of the deepest end of its tanks below the local water surface"}.summary(),
      r.draught, visit);
  visit(ResultField{"start_angle", "rad", "Angle at the start of the run"}.summary(), r.start_angle);
  visit(ResultField{"fastest", "rad/s", "Maximum rate of rotation in either direction"}.summary(), r.fastest);
  visit(ResultField{"time_at_stop", "s", "Time at a stop"}.summary(), r.time_at_stop);
  visit(ResultField{"stop_hits", "1", "Number of impacts on a stop"}.summary(), r.stop_hits);
}

}  // namespace overbend
