/// The stages of a pull along the seabed in summary.json.
#pragma once

#include "base/json.h"
#include "results/static_results.h"

namespace overbend {

/// Returns the members of a stage whose line is dragged along the seabed; they replace those of the same names of other
/// lays: tensions along the line, and positions by x astern of the stern shoe and arc length from the tensioner.
/// `departure_angle` is that at the tensioner, `departure_angle_last_roller` that behind the last support.
Json dragging_json(const StaticResults& lay, const Json& stage);

}  // namespace overbend
