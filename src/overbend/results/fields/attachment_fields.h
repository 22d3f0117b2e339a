/// Fields of the attachments of the laid pipe; see result_field.h.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_attached_place(Row& r, Visit& visit) {
  visit(ResultField{"arc_length", "m", "Unstressed length from the tensioner"}.summary(), r.from_top);
  visit(ResultField{"p", "m", "Position of the pipe's axis", kWorldFrame}, r.p_W);
  visit(ResultField{"x", "m", "Distance astern of the stern shoe"}.summary(), r.astern);
  visit(ResultField{"z", "m", "Height above the mean water level"}.summary(), r.p_W.z());
  visit(ResultField{"inclination", "rad", "Inclination of the pipe from horizontal, positive dipping astern"}.summary(),
        r.inclination);
  visit(ResultField{"moment", "N m", "Bending moment of the pipe in the vertical plane, sagging positive"}.summary(),
        r.moment);
  visit(ResultField{"tension_before", "N", "Effective tension of the pipe towards the tensioner"}.summary(),
        r.tension_before);
  visit(ResultField{"tension_after", "N", "Effective tension of the pipe towards the seabed"}.summary(),
        r.tension_after);
  visit(ResultField{"shear_before", "N", "Shear towards the tensioner: force of the far side on the near one, up"}
            .summary(),
        r.shear_before);
  visit(ResultField{"shear_after", "N", "Shear towards the seabed"}.summary(), r.shear_after);
}

/// A clump or a buoy.
template <class Row, class Visit>
void visit_pipe_point(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the clump or buoy"}.summary(), r.name);
  visit_attached_place(r.location, visit);
  visit(ResultField{"force", "N", "Its force on the pipe", kWorldFrame}, r.force);
}

/// A straight wire.
template <class Row, class Visit>
void visit_pipe_wire(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.summary(), r.name);
  visit_attached_place(r.location, visit);
  visit(ResultField{"length", "m", "Unstressed length"}.summary(), r.length);
  visit(ResultField{"tension_upper", "N", "Tension at its upper end; 0 while it is slack"}.summary(), r.tension_upper);
  visit(ResultField{"tension_lower", "N", "Tension at its lower end"}.summary(), r.tension_lower);
  visit(ResultField{"force", "N", "Its force on the pipe", kWorldFrame}, r.force);
  visit(ResultField{"force_astern", "N", "Component of that force astern"}.summary("force_on_pipe/x_astern"),
        r.force_astern);
  visit(ResultField{"force_up", "N", "Component of that force upwards"}.summary("force_on_pipe/z"), r.force.z());
  visit(ResultField{"from_vertical_upper", "rad", "Angle from the vertical at its upper end"}.summary(),
        r.from_vertical_upper);
  visit(ResultField{"from_vertical_lower", "rad", "Angle from the vertical at its lower end"}.summary(),
        r.from_vertical_lower);
  visit(ResultField{"utilisation", "1", "Tension over breaking load"}.summary(), r.utilisation);
  visit(ResultField{"far_end", "m", "Position of its other end", kWorldFrame}, r.far_W);
}

}  // namespace overbend
