/// A line dragged along the bed, as results have it.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills StaticResults::dragging from stations, head and cable recovered before; nothing of lines that are not dragged.
void recover_dragging(StaticResults& results, const StaticSystem& system, const LineState& state);

/// Findings on how the line lies: a lifted head, a cable that lies down to its winch, nothing on the bed.
void warn_of_dragging(StaticResults& results);

}  // namespace overbend
