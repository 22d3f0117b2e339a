/// A stage of a lift in a few numbers, for a row of a table.
#pragma once

#include <algorithm>
#include <optional>

#include "results/lift_results.h"

namespace overbend {

struct LiftBrief {
  std::optional<double> end_height;  ///< Of the first free end, over the water [m].
  double moment = 0.0;               ///< Largest bending moment of any line [N m].
  double stress = 0.0;               ///< Largest bending stress [Pa].
  double davit_tension = 0.0;        ///< Largest of a line on another [N].
};

inline LiftBrief in_brief(const LiftResults& lift) {
  LiftBrief brief;
  for (const LiftedLine& line : lift.lines) {
    brief.moment = std::max(brief.moment, line.bending.value);
    brief.stress = std::max(brief.stress, line.bending_stress);
    if (brief.end_height || (!line.first.free && !line.second.free)) continue;
    brief.end_height = (line.first.free ? line.first : line.second).at.place.z();
  }
  for (const LiftedWire& wire : lift.davits) brief.davit_tension = std::max(brief.davit_tension, wire.tension_upper);
  return brief;
}

}  // namespace overbend
