/// Static results of a stinger on hinges; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/static_results.h"

namespace overbend {

/// A tank; `at_x` and `at_z` are measured from the stern shoe, astern and up.
template <class Row, class Visit>
void visit_stinger_tank(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the tank"}.summary().page(), r.name);
  visit(ResultField{"weight", "N", "Weight with its ballast"}.summary().page(), r.weight);
  visit(ResultField{"buoyancy", "N", "Buoyancy of the part below the water"}.summary().page(), r.buoyancy);
  visit(ResultField{"at_x", "m", "Centre of buoyancy, astern of the stern shoe"}.summary(), r.at_x);
  visit(ResultField{"at_z", "m", "Centre of buoyancy, above the stern shoe"}.summary(), r.at_z);
  visit(ResultField{"submerged", "1", "Fraction of its length below the water"}.summary().page(), r.submerged);
  visit(ResultField{"draught", "m", "Depth of its deeper end below the water"}.summary().page(), r.draught);
}

/// One section on its hinge, without its tanks.
template <class Row, class Visit>
void visit_stinger_section(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the section; empty for a stinger with a single section"}.summary().page(),
        r.name);
  visit(ResultField{"angle", "rad", "Angle about the hinge from the nominal position, positive for tip down"}
            .summary()
            .page(),
        r.angle);
  visit(ResultField{"floats", "1", "1 if the angle follows from equilibrium"}.summary().page(), r.floats);
  visit(ResultField{"hinge", "m", "Hinge", kWorldFrame}.page(), r.hinge_W);
  visit(ResultField{"roller_moment", "N m", "Moment of the pipe on the rollers about the hinge, positive for tip down"}
            .summary()
            .page(),
        r.roller_moment);
  visit(ResultField{"hinge_longitudinal", "N", "Force of the hinge on the section, level astern"}
            .summary("hinge_force/longitudinal")
            .page(),
        r.hinge_longitudinal);
  visit(ResultField{"hinge_vertical", "N", "Force of the hinge on the section, upward"}
            .summary("hinge_force/vertical")
            .page(),
        r.hinge_vertical);
  visit(ResultField{"hinge_force", "N", "Force of the hinge, magnitude"}.summary("hinge_force/magnitude").page(),
        r.hinge_force);
  visit(ResultField{"stop_moment", "N m", "Moment of a stop or a holding device on the section, positive for tip down"}
            .summary()
            .page(),
        r.stop_moment);
  visit(ResultField{"at_stop", "1", "1 if the section is at a stop"}.summary().page(), r.at_stop);
  visit(ResultField{"friction_moment", "N m", "Moment capacity of hinge friction"}.summary(), r.friction_moment);
  visit(ResultField{"angle_up", "rad", "Minimum angle within hinge friction"}.summary().page(), r.angle_up);
  visit(ResultField{"angle_down", "rad", "Maximum angle within hinge friction"}.summary().page(), r.angle_down);
  visit(ResultField{"stiffness", "N m/rad", "Restoring moment about the hinge per angle, including the pipe"}
            .summary()
            .page(),
        r.stiffness);
  visit(ResultField{"natural_period", "s",
                    "Natural period of small rotations about the hinge, without the inertia of the pipe; 0 without "
                    "restoring moment"}
            .summary()
            .page(),
        r.natural_period);
  visit(ResultField{"draught", "m", "Depth of its deepest tank below the water; 0 without tanks"}.summary().page(),
        r.draught);
  visit(ResultField{"tip", "m", "Top of its last roller", kWorldFrame}.page(), r.tip_W);
}

}  // namespace overbend
