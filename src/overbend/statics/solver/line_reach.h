/// Lines that are too short for what holds them, wherever the lines they are on could go.
#pragma once

#include <optional>

#include "statics/solver/linked_lines.h"

namespace overbend {

/// The first line that cannot reach in a position: its length, stretched to three times its breaking load (by half
/// where none is given), and the pipe it is on, straight, are shorter than the distance between the places that hold
/// them. None where all can. A line whose length is infinite always can. The key is that of the line.
std::optional<StaticFailure> reach_failure(const Model& model, const LiftPosition& position);

}  // namespace overbend
