/// Results of clumps, buoys and wires on the pipe.
#pragma once

#include <optional>
#include <vector>

#include "results/static_results.h"
#include "statics/equations/static_system.h"
#include "system/cut_forces.h"

namespace overbend {

/// Force of clumps, buoys and wires on a node, or on all nodes, W [N]. The system is evaluated at the state.
Vec3 attached_force(const StaticSystem& system, const LineState& state, std::optional<int> node = {});

/// True if any of them is fixed to this node.
bool holds_something(const StaticSystem& system, int node);

/// Adds results of attachments. `cuts`: section forces at the nodes. The system is evaluated at the state.
void recover_attachments(StaticResults& results, const StaticSystem& system, const LineState& state,
                         const std::vector<CutForces>& cuts);

/// Warns of wires that are slack or beyond their breaking load.
void warn_of_attachments(StaticResults& results);

}  // namespace overbend
