/// What is told of structures in the pipe.
#pragma once

#include "model/model.h"
#include "results/static_results.h"

namespace overbend {

/// Distance from a node at which the station of the element on its other side stands [m].
inline constexpr double kBesideStep = 1e-3;

/// Where structures lie, what acts in them and on them, and the pipe beside their ends. Stations and supports of
/// `results` are there.
std::vector<StructureResult> recover_structures(const Model& model, const StaticResults& results);

}  // namespace overbend
