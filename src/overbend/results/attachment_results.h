/// Attachments of the laid pipe: clumps, buoys and wires, and the pipe at them. SI; frame W.
#pragma once

#include <optional>
#include <string>

#include "base/vec.h"

namespace overbend {

/// State of the pipe at an attachment; before: on the side of the tensioner, after: on the side of the seabed.
struct AttachedPlace {
  double from_top = 0.0;                             ///< Unstressed length from the tensioner [m].
  double astern = 0.0;                               ///< Distance astern of the stern shoe [m].
  Vec3 p_W = Vec3::Zero();                           ///< [m]
  double inclination = 0.0;                          ///< Positive dipping astern [rad].
  double moment = 0.0;                               ///< Sagging positive [N m].
  double tension_before = 0.0, tension_after = 0.0;  ///< Effective [N].
  double shear_before = 0.0, shear_after = 0.0;      ///< Force of the seabed side on the tensioner side, up [N].
};

/// A clump or a buoy.
struct PipePointResult {
  std::string name;
  AttachedPlace location;
  Vec3 force = Vec3::Zero();  ///< On the pipe [N].
};

/// A straight wire.
struct PipeWireResult {
  std::string name;
  AttachedPlace location;
  double length = 0.0;                                          ///< Unstressed [m].
  double tension_upper = 0.0, tension_lower = 0.0;              ///< 0 while it is slack [N].
  double from_vertical_upper = 0.0, from_vertical_lower = 0.0;  ///< [rad]
  Vec3 force = Vec3::Zero();                                    ///< On the pipe [N].
  double force_astern = 0.0;                                    ///< Component of the force astern [N].
  std::optional<double> utilisation;                            ///< Maximum tension over breaking load.
  Vec3 far_W = Vec3::Zero();                                    ///< Other end of the wire [m].
};

}  // namespace overbend
