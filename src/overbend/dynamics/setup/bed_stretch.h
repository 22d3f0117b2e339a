/// The bed's friction under a line that statics left at rest.
#pragma once

#include "system/line.h"
#include "system/state.h"

namespace overbend {

/// Stretches the friction of the bed under every point of a line as statics holds it there, so that a run begins in
/// balance.
void stretch_bed(const Line& line, LineState& state);

}  // namespace overbend
