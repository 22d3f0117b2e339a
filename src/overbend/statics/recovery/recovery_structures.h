/// Results of structures in the pipe.
#pragma once

#include "model/model.h"
#include "results/static_results.h"

namespace overbend {

/// Distance from a node of the station in the element on its other side [m].
inline constexpr double kNodeStationOffset = 1e-3;

/// Returns position, loads and reactions of structures, and the pipe next to their ends. Needs stations and supports of
/// `results`.
std::vector<StructureResult> recover_structures(const Model& model, const StaticResults& results);

}  // namespace overbend
