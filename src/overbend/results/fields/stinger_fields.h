/// A stinger on hinges at rest; result_field.h has the idea.
#pragma once

#include "results/fields/result_field.h"
#include "results/static_results.h"

namespace overbend {

/// A tank; `at_x` and `at_z` count from the stern shoe, astern and up.
template <class Row, class Visit>
void visit_stinger_tank(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the tank"}.summary().page(), r.name);
  visit(ResultField{"weight", "N", "Weight with its ballast"}.summary().page(), r.weight);
  visit(ResultField{"buoyancy", "N", "Buoyancy of the part below the water"}.summary().page(), r.buoyancy);
  visit(ResultField{"at_x", "m", "Where the buoyancy acts, astern of the stern shoe"}.summary(), r.at_x);
  visit(ResultField{"at_z", "m", "Where it acts, above the stern shoe"}.summary(), r.at_z);
  visit(ResultField{"submerged", "1", "Fraction of its length below the water"}.summary().page(), r.submerged);
  visit(ResultField{"draught", "m", "Of its deeper end below the water"}.summary().page(), r.draught);
}

/// One section on its hinge, without its tanks.
template <class Row, class Visit>
void visit_stinger_section(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the section; empty where the stinger is one"}.summary().page(), r.name);
  visit(ResultField{"angle", "rad", "Angle about the hinge, positive when the tip goes down from where it is drawn"}
            .summary()
            .page(),
        r.angle);
  visit(ResultField{"floats", "1", "Whether the forces on it decide the angle"}.summary().page(), r.floats);
  visit(ResultField{"hinge", "m", "Hinge", kWorldFrame}.page(), r.hinge_W);
  visit(ResultField{"roller_moment", "N m",
                    "Of the pipe on the rollers about the hinge, positive when it turns the tip down"}
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
  visit(ResultField{"stop_moment", "N m",
                    "Of a stop, or of what holds the angle, on the section; positive when it turns the tip down"}
            .summary()
            .page(),
        r.stop_moment);
  visit(ResultField{"at_stop", "1", "Whether a stop holds it"}.summary().page(), r.at_stop);
  visit(ResultField{"friction_moment", "N m", "That the hinge bears at most before the section turns"}.summary(),
        r.friction_moment);
  visit(ResultField{"angle_up", "rad", "Least angle at which hinge friction may leave it"}.summary().page(),
        r.angle_up);
  visit(ResultField{"angle_down", "rad", "Largest angle at which hinge friction may leave it"}.summary().page(),
        r.angle_down);
  visit(ResultField{"stiffness", "N m/rad", "Fall of the moment about the hinge with the angle, pipe included"}
            .summary()
            .page(),
        r.stiffness);
  visit(ResultField{"natural_period", "s",
                    "Of small turns about the hinge, without the inertia of the pipe; 0 where nothing brings it back"}
            .summary()
            .page(),
        r.natural_period);
  visit(ResultField{"draught", "m", "Of its deepest tank below the water; 0 without tanks"}.summary().page(),
        r.draught);
  visit(ResultField{"tip", "m", "Top of its last roller", kWorldFrame}.page(), r.tip_W);
}

}  // namespace overbend
