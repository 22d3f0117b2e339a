/// Parameters of a continuation in statics.
#pragma once

#include "mechanics/mobilised_friction.h"

namespace overbend {

/// Modification of the model during a continuation, set as a whole. The default is the unmodified model.
struct Continuation {
  double max_roller_stiffness = 1e300;  ///< Limit of the rollers' normal stiffness [N/m].
  bool side_rollers = true;             ///< True if side rollers act.
  /// Full friction of the rollers at rest, if requested; not a continuation parameter.
  MobilisedFriction roller_friction = {};
  /// True: friction of rollers in motion follows the slip, else `roller_friction`.
  bool friction_by_slip = true;
  double max_bed_stiffness = 1e300;    ///< Limit of the seabed stiffness, normal and in friction [N/m2].
  double bed_relief = 1.0;             ///< Factor on the heights of a shaped seabed above `bed_level`.
  double bed_level = 0.0;              ///< [m]
  double current = 1.0;                ///< Factor on the current speed.
  double yielding = 1.0;               ///< Factor on the plastic moments: 0 is linear steel.
  double attached = 1.0;               ///< Factor on the forces of clumps, buoys and wires on the lines.
  double max_axial_stiffness = 1e300;  ///< Limit of the lines' axial stiffness [N].
};

}  // namespace overbend
