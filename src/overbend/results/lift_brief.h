/// Summary of a stage of a lift, for a row of a table.
#pragma once

#include <algorithm>
#include <optional>

#include "results/lift_results.h"

namespace overbend {

struct LiftBrief {
  std::optional<double> end_height;  ///< Elevation of the first free end above the water [m].
  double moment = 0.0;               ///< Maximum bending moment of all lines [N m].
  double stress = 0.0;               ///< Maximum bending stress of all lines [Pa].
  double davit_tension = 0.0;        ///< Maximum tension of a line attached to another [N].
};

/// Returns the summary of the lines of one stage.
inline LiftBrief in_brief(const LiftResults& lift) {
  LiftBrief brief;
  for (const LiftedLine& line : lift.lines) {
    brief.moment = std::max(brief.moment, line.bending.value);
    brief.stress = std::max(brief.stress, line.bending_stress);
    if (brief.end_height || (!line.first.free && !line.second.free)) continue;
    brief.end_height = (line.first.free ? line.first : line.second).location.place.z();
  }
  for (const LiftedWire& wire : lift.davits) brief.davit_tension = std::max(brief.davit_tension, wire.tension_upper);
  return brief;
}

}  // namespace overbend
