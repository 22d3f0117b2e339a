/// Results of a cable in the line, its head and its anchor.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills StaticResults::head, cable and far_anchor from the stations and forces recovered before; does nothing if the
/// line contains no cable.
void recover_cable(StaticResults& results, const StaticSystem& system, const LineState& state);

}  // namespace overbend
