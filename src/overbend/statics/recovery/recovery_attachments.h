/// What is told of clumps, buoys and wires on the pipe.
#pragma once

#include <optional>
#include <vector>

#include "results/static_results.h"
#include "statics/equations/static_system.h"
#include "system/cut_forces.h"

namespace overbend {

/// Force of clumps, buoys and wires on a node, or on all of them, W [N]. The system stands evaluated at the state.
Vec3 attached_force(const StaticSystem& system, const LineState& state, std::optional<int> node = {});

/// Whether any is fixed to this node.
bool holds_something(const StaticSystem& system, int node);

/// `cuts` at the nodes. The system stands evaluated at the state.
void recover_attachments(StaticResults& results, const StaticSystem& system, const LineState& state,
                         const std::vector<CutForces>& cuts);

/// Wires that are slack or beyond their breaking load.
void warn_of_attachments(StaticResults& results);

}  // namespace overbend
