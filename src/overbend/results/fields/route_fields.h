/// How the pipe lies on its route, and what friction decides; result_field.h has the idea.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_route(Row& r, Visit& visit) {
  visit(ResultField{"radius", "m", "Smallest radius of the route in plan behind touchdown; 0 where it is straight"}
            .summary()
            .page()
            .report(),
        r.radius);
  visit(ResultField{"least_radius", "m",
                    "Least radius that bottom tension and lateral friction hold, H / (mu w); 0 without friction"}
            .summary()
            .page()
            .report(),
        r.least_radius);
  visit(
      ResultField{"holds", "1", "1 where the route is straight or its radius at least that"}.summary().page().report(),
      r.holds);
  visit(ResultField{"largest_offset", "m", "Largest of the pipe on the bed from its route, to port positive"}
            .summary()
            .page()
            .report(),
        r.largest_offset);
  visit(ResultField{"offset_x", "m", "Where that is, astern of the stern shoe"}.summary().page().report(), r.offset_x);
  visit(ResultField{"slid_length", "m", "Length of the pipe that has slid sideways"}.summary().page().report(),
        r.slid_length);
  visit(ResultField{"laid_offset", "m", "Touchdown from the route, to port positive"}.summary().page().report(),
        r.laid_offset);
  visit(ResultField{"side_load_bed", "N", "Of the pipe on the bed, to port positive"}.summary().page().report(),
        r.side_load_bed);
  visit(ResultField{"side_load_supports", "N", "Of the pipe on rollers and tensioner, to port positive"}
            .summary()
            .page()
            .report(),
        r.side_load_supports);
}

/// One answer to how rollers, or the bed, hold the pipe by friction.
template <class Row, class Visit>
void visit_friction_case(Row& r, Visit& visit) {
  visit(ResultField{"name", "1",
                    "frictionless; lay, haul: full friction of the rollers along the pipe as it is paid out or hauled "
                    "in; port, starboard: full friction across, against a way to that side; pulled across: laid "
                    "straight on its route, then pulled aside"}
            .summary()
            .page()
            .report(),
        r.name);
  visit(ResultField{"top_tension", "N", "Effective tension at the tensioner"}.summary().page().report(), r.top_tension);
  visit(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}.summary().page().report(),
        r.bottom_tension);
  visit(ResultField{"lay_back", "m", "Horizontal distance from stern shoe to touchdown"}.summary().page().report(),
        r.lay_back);
  visit(ResultField{"tip_side", "m", "Pipe at the last row of the stinger, to port of the barge's axis"}
            .summary()
            .page()
            .report(),
        r.tip_side);
  visit(ResultField{"off_roller", "m", "How far it runs off a roller that bears it at the last box; 0 on it"}
            .summary()
            .page()
            .report(),
        r.off_roller);
  visit(ResultField{"overbend_stress", "Pa", "Largest von Mises stress of the overbend"}.summary().page().report(),
        r.overbend_stress);
  visit(ResultField{"sagbend_stress", "Pa", "Largest von Mises stress of the sagbend"}.summary().page().report(),
        r.sagbend_stress);
  visit(ResultField{"largest_reaction", "N", "Largest of a roller"}.summary().page().report(), r.largest_reaction);
}

}  // namespace overbend
