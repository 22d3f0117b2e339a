/// A stage of a lift: lines that are pipe, what hangs on them, welds; result_field.h has the idea.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_line_place(Row& r, Visit& visit) {
  visit(ResultField{"arc_length", "m", "Unstressed length from the line's first end"}, r.arc_length);
  visit(ResultField{"position", "m", "Of the axis", kWorldFrame}, r.place);
  visit(ResultField{"inclination", "rad", "Of the axis going towards the second end, positive downwards"},
        r.inclination);
}

/// A node of a line that bends.
template <class Row, class Visit>
void visit_lifted_node(Row& r, Visit& visit) {
  visit_line_place(r.at, visit);
  visit(ResultField{"segment", "1", "Segment of the line, from 0; two nodes at a place are the two sides of it"},
        r.segment);
  visit(ResultField{"tension", "N", "Effective tension"}, r.tension);
  visit(ResultField{"shear", "N", "Force of the side of the second end on the other, square to the axis, up"}, r.shear);
  visit(ResultField{"sagging_moment", "N m", "Bending moment in the vertical plane, sagging positive"}, r.sagging);
  visit(ResultField{"sideways_moment", "N m", "Bending moment square to that"}, r.sideways);
  visit(ResultField{"bending_stress", "Pa", "Largest bending stress of the steel"}, r.stress);
  visit(ResultField{"yield_stress", "Pa", "Yield stress of the steel"}, r.yield_stress);
  visit(ResultField{"von_mises", "Pa", "Largest von Mises stress of the steel"}, r.von_mises);
  visit(ResultField{"strain", "1", "Largest longitudinal strain at the outer fibre"}, r.strain);
}

/// An end of such a line, its place apart.
template <class Row, class Visit>
void visit_lifted_end(Row& r, Visit& visit) {
  visit(ResultField{"free", "1", "1 where nothing holds it"}, r.free);
  visit(ResultField{"tension", "N", "Effective tension there"}, r.tension);
  visit(ResultField{"horizontal_force", "N", "With which it is pulled outwards"}, r.horizontal_force);
  visit(ResultField{"vertical_force", "N", "With which it is held up"}, r.vertical_force);
}

/// What is told of such a line as a whole.
template <class Row, class Visit>
void visit_lifted_line(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}, r.name);
  visit(ResultField{"largest_bending_stress", "Pa", "Largest bending stress of the steel"}, r.bending_stress);
  visit(ResultField{"largest_von_mises", "Pa", "Largest von Mises stress of the steel"}, r.von_mises);
  visit(ResultField{"largest_tension", "N", "Largest effective tension"}, r.largest_tension);
  visit(ResultField{"least_tension", "N", "Least effective tension"}, r.least_tension);
  visit(ResultField{"suspended_length", "m", "Length that the bed does not bear"}, r.suspended_length);
}

/// A line that hangs on another, the place of its attachment apart.
template <class Row, class Visit>
void visit_lifted_wire(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}, r.name);
  visit(ResultField{"on", "1", "Name of the line that it is on"}, r.on);
  visit(ResultField{"length", "m", "Unstressed length"}, r.length);
  visit(ResultField{"tension_upper", "N", "Tension at its upper end"}, r.tension_upper);
  visit(ResultField{"tension_lower", "N", "Tension at its lower end"}, r.tension_lower);
  visit(ResultField{"force_on_pipe", "N", "Its force on the line that it is on", kWorldFrame}, r.force);
  visit(ResultField{"from_vertical_upper", "rad", "Angle from the vertical at its upper end"}, r.from_vertical_upper);
  visit(ResultField{"from_vertical_lower", "rad", "Angle from the vertical at its lower end"}, r.from_vertical_lower);
  visit(ResultField{"utilisation", "1", "Tension at the upper end over the breaking load"}, r.utilisation);
  visit(ResultField{"moment", "N m", "Of the other line there, sagging positive"}, r.moment);
  visit(ResultField{"tension_before", "N", "Of the other line, towards its first end"}, r.tension_before);
  visit(ResultField{"tension_after", "N", "Of the other line, towards its second end"}, r.tension_after);
  visit(ResultField{"shear_before", "N", "Of the other line, towards its first end"}, r.shear_before);
  visit(ResultField{"shear_after", "N", "Of the other line, towards its second end"}, r.shear_after);
}

template <class Row, class Visit>
void visit_weld_gap(Row& r, Visit& visit) {
  visit(ResultField{"dx", "m", "Second end less first, x"}, r.dx);
  visit(ResultField{"dy", "m", "Second end less first, y"}, r.dy);
  visit(ResultField{"dz", "m", "Second end less first, z"}, r.dz);
  visit(ResultField{"angle", "rad",
                    "By which the direction turns from the first line to the second, positive like "
                    "sagging"},
        r.angle);
}

template <class Row, class Visit>
void visit_weld(Row& r, Visit& visit) {
  visit(ResultField{"tension", "N", "Force of the second line on the first along the first's axis"}, r.tension);
  visit(ResultField{"shear", "N", "Square to it, up"}, r.shear);
  visit(ResultField{"moment", "N m", "Bending moment at the weld, sagging positive"}, r.moment);
}

}  // namespace overbend
