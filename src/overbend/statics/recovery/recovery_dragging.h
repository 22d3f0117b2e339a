/// Results of a line dragged along the bed.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills StaticResults::dragging from stations, head and cable recovered before; does nothing for other lines.
void recover_dragging(StaticResults& results, const StaticSystem& system, const LineState& state);

/// Findings on a lifted head, a cable on the bed up to its winch, and a line clear of the bed.
void warn_of_dragging(StaticResults& results);

}  // namespace overbend
