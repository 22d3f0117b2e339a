/// Parameters of a continuation in statics.
#pragma once

#include "mechanics/roller_rub.h"

namespace overbend {

/// What a continuation makes easier, set as a whole. The default is the model as it is.
struct Continuation {
  double max_roller_stiffness = 1e300;  ///< Limit of the rollers' normal stiffness [N/m].
  bool side_rollers = true;             ///< Whether side rollers act.
  RollerRub roller_friction = {};       ///< Full friction of the rollers at rest: asked for, no continuation.
  bool friction_by_slip = true;         ///< Friction of rollers in motion follows the slip, else `roller_friction`.
  double max_bed_stiffness = 1e300;     ///< Limit of the bed's stiffness, normal and in friction [N/m2].
  double bed_relief = 1.0;              ///< Factor on the heights of a shaped bed over `bed_level`.
  double bed_level = 0.0;               ///< [m]
  double current = 1.0;                 ///< Factor on the current's speed.
  double yielding = 1.0;                ///< Factor on the plastic moments: 0 is linear steel.
  double attached = 1.0;                ///< Factor on the forces of clumps, buoys and wires on the lines.
  double max_axial_stiffness = 1e300;   ///< Limit of the lines' axial stiffness [N].
};

}  // namespace overbend
