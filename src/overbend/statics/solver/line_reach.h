/// Lines that are too short for the distance between their attachments, at any position of the lines that carry them.
#pragma once

#include <optional>

#include "statics/solver/linked_lines.h"

namespace overbend {

/// Returns a failure for the first line that cannot reach in a position: its length, stretched to three times its
/// breaking load (by half if none is given), plus the straight pipe to which it is attached, is less than the distance
/// between the held ends. nullopt if all can. A line of infinite length always reaches. The key of the failure is that
/// of the line.
std::optional<StaticFailure> reach_failure(const Model& model, const LiftPosition& position);

}  // namespace overbend
