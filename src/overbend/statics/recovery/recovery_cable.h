/// What is told of a cable in the line, of the head it is joined to and of the anchor it may be pinned to.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills StaticResults::head, cable and far_anchor from stations and forces recovered before; nothing where no cable is
/// in the line.
void recover_cable(StaticResults& results, const StaticSystem& system, const LineState& state);

}  // namespace overbend
