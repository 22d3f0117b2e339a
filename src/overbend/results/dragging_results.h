/// A pipe dragged along the bed between the vessel and a winch at a distance. SI.
#pragma once

#include <optional>
#include <vector>

#include "results/ground_results.h"

namespace overbend {

/// Where the line leaves the bed for the last time before the winch.
struct LiftOffResult {
  double x = 0.0;             ///< Astern of the stern shoe [m].
  double z = 0.0;             ///< Of the axis, above the water [m].
  double before_winch = 0.0;  ///< Unstressed length from there to the winch [m].
  bool cable = true;          ///< Whether it is the cable that leaves it; else pipe or head.
};

struct DraggingResults {
  double touchdown_tension = 0.0;          ///< Effective, where the pipe first touches the bed [N].
  double pipe_end_tension = 0.0;           ///< Where the pipe ends at the head [N].
  double winch_tension = 0.0;              ///< At the fixed end of the cable [N].
  double sagbend_x = 0.0;                  ///< Of the largest moment of the sagbend, astern of the stern shoe [m].
  double sagbend_from_top = 0.0;           ///< Its arc length from the tensioner [m].
  double winch_inclination = 0.0;          ///< Of the cable there, positive dipping astern [rad].
  std::optional<LiftOffResult> lift_off;   ///< None where the line lies down to the winch, or nowhere.
  std::vector<BedContactResult> contacts;  ///< With the bed, of pipe, head and cable, from the vessel astern.
};

}  // namespace overbend
