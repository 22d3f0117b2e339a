/// Fields of the pipe on its route and of the effect of friction; see result_field.h.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_route(Row& r, Visit& visit) {
  visit(ResultField{"radius", "m", "Minimum radius of the route in plan behind touchdown; 0 for a straight route"}
            .summary()
            .page()
            .report(),
        r.radius);
  visit(ResultField{"least_radius", "m",
                    "Minimum stable radius for the bottom tension and lateral friction, H / (mu w); 0 without friction"}
            .summary()
            .page()
            .report(),
        r.min_stable_radius);
  visit(ResultField{"holds", "1", "1 if the route is straight or its radius at least that"}.summary().page().report(),
        r.holds);
  visit(ResultField{"largest_offset", "m", "Maximum offset of the pipe on the seabed from its route, positive to port"}
            .summary()
            .page()
            .report(),
        r.max_offset);
  visit(ResultField{"offset_x", "m", "Position of that offset, astern of the stern shoe"}.summary().page().report(),
        r.offset_x);
  visit(ResultField{"slid_length", "m", "Length of the pipe that has slid sideways"}.summary().page().report(),
        r.slid_length);
  visit(
      ResultField{"laid_offset", "m", "Offset of touchdown from the route, positive to port"}.summary().page().report(),
      r.laid_offset);
  visit(ResultField{"side_load_bed", "N", "Lateral load of the pipe on the seabed, positive to port"}
            .summary()
            .page()
            .report(),
        r.side_load_bed);
  visit(ResultField{"side_load_supports", "N", "Lateral load of the pipe on rollers and tensioner, positive to port"}
            .summary()
            .page()
            .report(),
        r.side_load_supports);
}

/// One limit case of roller or seabed friction.
template <class Row, class Visit>
void visit_friction_case(Row& r, Visit& visit) {
  visit(ResultField{"name", "1",
                    "frictionless; lay, haul: full friction of the rollers along the pipe as it is paid out or "
                    "hauled in; port, starboard: full friction across, against motion to that side; pulled across: "
                    "laid straight on its route, then pulled aside"}
            .summary()
            .page()
            .report(),
        r.name);
  visit(ResultField{"top_tension", "N", "Effective tension at the tensioner"}.summary().page().report(), r.top_tension);
  visit(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}.summary().page().report(),
        r.bottom_tension);
  visit(ResultField{"lay_back", "m", "Horizontal distance from stern shoe to touchdown"}.summary().page().report(),
        r.lay_back);
  visit(ResultField{"tip_side", "m", "Pipe at the last row of the stinger, to port of the vessel's axis"}
            .summary()
            .page()
            .report(),
        r.tip_side);
  visit(ResultField{"off_roller", "m", "Distance beyond the face of a loaded roller of the last box; 0 on the face"}
            .summary()
            .page()
            .report(),
        r.off_roller);
  visit(ResultField{"overbend_stress", "Pa", "Largest von Mises stress of the overbend"}.summary().page().report(),
        r.overbend_stress);
  visit(ResultField{"sagbend_stress", "Pa", "Largest von Mises stress of the sagbend"}.summary().page().report(),
        r.sagbend_stress);
  visit(ResultField{"largest_reaction", "N", "Maximum reaction of a roller"}.summary().page().report(), r.max_reaction);
}

}  // namespace overbend
