/// Rows of a stinger on hinges over time; result_field.h has the idea.
#pragma once

#include "results/fields/result_field.h"
#include "results/stinger_dynamics.h"

namespace overbend {

template <class Row, class Visit>
void visit_stinger_dynamics(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the section"}.summary(), r.name);
  visit_spread(ResultField{"angle", "rad", "Angle from where it is drawn, positive when the tip goes down"}.summary(),
               r.angle, visit);
  visit_spread(ResultField{"hinge_longitudinal", "N", "Force of the hinge on the section, level astern"}.summary(
                   "hinge_force/longitudinal"),
               r.hinge_longitudinal, visit);
  visit_spread(
      ResultField{"hinge_vertical", "N", "Force of the hinge on the section, upwards"}.summary("hinge_force/vertical"),
      r.hinge_vertical, visit);
  visit_spread(
      ResultField{"hinge_force", "N", "Force of the hinge on the section, magnitude"}.summary("hinge_force/magnitude"),
      r.hinge_force, visit);
  visit_spread(
      ResultField{"stop_moment", "N m", "Moment of the stops on the section, positive when it pushes the tip down"}
          .summary(),
      r.stop_moment, visit);
  visit_spread(ResultField{"draught", "m", "Deepest end of its tanks below the surface there"}.summary(), r.draught,
               visit);
  visit(ResultField{"start_angle", "rad", "Angle at the start of the run"}.summary(), r.start_angle);
  visit(ResultField{"fastest", "rad/s", "Largest rate of turning, either way"}.summary(), r.fastest);
  visit(ResultField{"time_at_stop", "s", "Time at a stop"}.summary(), r.time_at_stop);
  visit(ResultField{"stop_hits", "1", "How often it ran into a stop"}.summary(), r.stop_hits);
}

}  // namespace overbend
