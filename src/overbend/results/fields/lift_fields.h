/// Fields of a stage of a lift: pipe lines, their attachments, welds; see result_field.h.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_line_place(Row& r, Visit& visit) {
  visit(ResultField{"arc_length", "m", "Unstressed length from the line's first end"}, r.arc_length);
  visit(ResultField{"position", "m", "Position of the axis", kWorldFrame}, r.place);
  visit(ResultField{"inclination", "rad", "Inclination of the axis towards the second end, positive downwards"},
        r.inclination);
}

/// A node of a line with bending stiffness.
template <class Row, class Visit>
void visit_lifted_node(Row& r, Visit& visit) {
  visit_line_place(r.location, visit);
  visit(ResultField{"segment", "1", "Segment of the line, from 0; two nodes at one position are its two sides"},
        r.segment);
  visit(ResultField{"tension", "N", "Effective tension"}, r.tension);
  visit(ResultField{"shear", "N", "Force of the side of the second end on the other, normal to the axis, up"}, r.shear);
  visit(ResultField{"sagging_moment", "N m", "Bending moment in the vertical plane, sagging positive"}, r.sagging);
  visit(ResultField{"sideways_moment", "N m", "Bending moment normal to that plane"}, r.sideways);
  visit(ResultField{"bending_stress", "Pa", "Largest bending stress of the steel"}, r.stress);
  visit(ResultField{"yield_stress", "Pa", "Yield stress of the steel"}, r.yield_stress);
  visit(ResultField{"von_mises", "Pa", "Largest von Mises stress of the steel"}, r.von_mises);
  visit(ResultField{"strain", "1", "Largest longitudinal strain at the outer fibre"}, r.strain);
}

/// An end of such a line, without its position.
template <class Row, class Visit>
void visit_lifted_end(Row& r, Visit& visit) {
  visit(ResultField{"free", "1", "1 if the end is free"}, r.free);
  visit(ResultField{"tension", "N", "Effective tension there"}, r.tension);
  visit(ResultField{"horizontal_force", "N", "Outward horizontal force on the end"}, r.horizontal_force);
  visit(ResultField{"vertical_force", "N", "Upward vertical force on the end"}, r.vertical_force);
}

/// Values of such a line as a whole.
template <class Row, class Visit>
void visit_lifted_line(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}, r.name);
  visit(ResultField{"largest_bending_stress", "Pa", "Largest bending stress of the steel"}, r.bending_stress);
  visit(ResultField{"largest_von_mises", "Pa", "Largest von Mises stress of the steel"}, r.von_mises);
  visit(ResultField{"largest_tension", "N", "Largest effective tension"}, r.max_tension);
  visit(ResultField{"least_tension", "N", "Minimum effective tension"}, r.min_tension);
  visit(ResultField{"suspended_length", "m", "Length without seabed contact"}, r.suspended_length);
}

/// A line attached to another, without the position of the attachment.
template <class Row, class Visit>
void visit_lifted_wire(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}, r.name);
  visit(ResultField{"on", "1", "Name of the line that it is attached to"}, r.on);
  visit(ResultField{"length", "m", "Unstressed length"}, r.length);
  visit(ResultField{"tension_upper", "N", "Tension at its upper end"}, r.tension_upper);
  visit(ResultField{"tension_lower", "N", "Tension at its lower end"}, r.tension_lower);
  visit(ResultField{"force_on_pipe", "N", "Its force on the line that it is attached to", kWorldFrame}, r.force);
  visit(ResultField{"from_vertical_upper", "rad", "Angle from the vertical at its upper end"}, r.from_vertical_upper);
  visit(ResultField{"from_vertical_lower", "rad", "Angle from the vertical at its lower end"}, r.from_vertical_lower);
  visit(ResultField{"utilisation", "1", "Tension at the upper end over the breaking load"}, r.utilisation);
  visit(ResultField{"moment", "N m", "Bending moment of the other line at the attachment, sagging positive"}, r.moment);
  visit(ResultField{"tension_before", "N", "In the other line, on the side of its first end"}, r.tension_before);
  visit(ResultField{"tension_after", "N", "In the other line, on the side of its second end"}, r.tension_after);
  visit(ResultField{"shear_before", "N", "In the other line, on the side of its first end"}, r.shear_before);
  visit(ResultField{"shear_after", "N", "In the other line, on the side of its second end"}, r.shear_after);
}

template <class Row, class Visit>
void visit_weld_gap(Row& r, Visit& visit) {
  visit(ResultField{"dx", "m", "Second end minus first, x"}, r.dx);
  visit(ResultField{"dy", "m", "Second end minus first, y"}, r.dy);
  visit(ResultField{"dz", "m", "Second end minus first, z"}, r.dz);
  visit(ResultField{"angle", "rad", "Change of direction from the first line to the second, positive for sagging"},
        r.angle);
}

template <class Row, class Visit>
void visit_weld(Row& r, Visit& visit) {
  visit(ResultField{"tension", "N", "Force of the second line on the first along the first's axis"}, r.tension);
  visit(ResultField{"shear", "N", "Normal to that axis, up"}, r.shear);
  visit(ResultField{"moment", "N m", "Bending moment at the weld, sagging positive"}, r.moment);
}

}  // namespace overbend
