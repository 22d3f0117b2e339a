/// Fields of a pipe dragged along the seabed; see result_field.h.
#pragma once

#include "results/dragging_results.h"
#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_dragging(Row& r, Visit& visit) {
  visit(ResultField{"touchdown_tension", "N", "Effective tension where the pipe first touches the seabed"}
            .csv("touchdown tension")
            .report(),
        r.touchdown_tension);
  visit(ResultField{"pipe_end_tension", "N", "Effective tension where the pipe ends at the head"}
            .csv("pipe end tension")
            .report(),
        r.pipe_end_tension);
  visit(ResultField{"winch_tension", "N", "Effective tension of the cable at the winch"}.csv("winch tension").report(),
        r.winch_tension);
  visit(ResultField{"sagbend_x", "m", "Position of the maximum sagbend moment, astern of the stern shoe"}.report(),
        r.sagbend_x);
  visit(ResultField{"sagbend_from_top", "m", "Arc length of that position from the tensioner"}.report(),
        r.sagbend_from_top);
  visit(ResultField{"winch_inclination", "rad", "Inclination of the cable at the winch, positive dipping astern"}
            .csv("winch inclination")
            .report(),
        r.winch_inclination);
}

template <class Row, class Visit>
void visit_lift_off(Row& r, Visit& visit) {
  visit(ResultField{"x", "m", "Position where the line lifts off the seabed before the winch, astern of the stern shoe"}
            .csv("lift-off")
            .summary()
            .report(),
        r.x);
  visit(ResultField{"z", "m", "Height of its axis there"}.summary().report(), r.z);
  visit(ResultField{"before_winch", "m", "Unstressed length from there to the winch"}
            .summary("arc_length_before_winch")
            .report(),
        r.before_winch);
  visit(ResultField{"cable", "1", "1 if the cable lifts off, 0 for pipe or head"}.report(), r.cable);
}

}  // namespace overbend
