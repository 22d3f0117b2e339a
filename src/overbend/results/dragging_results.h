/// A pipe dragged along the seabed between the vessel and a distant winch. SI.
#pragma once

#include <optional>
#include <vector>

#include "results/ground_results.h"

namespace overbend {

/// Last lift-off of the line from the seabed before the winch.
struct LiftOffResult {
  double x = 0.0;             ///< Distance astern of the stern shoe [m].
  double z = 0.0;             ///< Elevation of the axis above the mean water level [m].
  double before_winch = 0.0;  ///< Unstressed length from there to the winch [m].
  bool cable = true;          ///< True if the cable lifts off; false for the pipe or the head.
};

struct DraggingResults {
  double touchdown_tension = 0.0;          ///< Effective tension at the first touchdown of the pipe [N].
  double pipe_end_tension = 0.0;           ///< Effective tension at the end of the pipe at the head [N].
  double winch_tension = 0.0;              ///< At the fixed end of the cable [N].
  double sagbend_x = 0.0;                  ///< Position of the maximum sagbend moment, astern of the stern shoe [m].
  double sagbend_from_top = 0.0;           ///< Arc length of that position from the tensioner [m].
  double winch_inclination = 0.0;          ///< Inclination of the cable at the winch, positive dipping astern [rad].
  std::optional<LiftOffResult> lift_off;   ///< None if the line lies on the seabed up to the winch, or never touches
                                           ///< it.
  std::vector<BedContactResult> contacts;  ///< Seabed contacts of pipe, head and cable, from the vessel astern.
};

}  // namespace overbend
