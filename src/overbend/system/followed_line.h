/// A line of the model in a system: of elements, a wire between bodies, or a wire on a node of another line.
#pragma once

#include <string>

#include "system/assembly.h"

namespace overbend {

/// Position of a model line in a system.
struct FollowedLine {
  std::string name;
  int line = -1;          ///< Index in the system: a line of elements or, with a wire, the line on whose node it is.
  int wire = -1;          ///< Index in the system, or in that line.
  bool reversed = false;  ///< The wire's first end is the line's second.

  bool is_wire() const { return wire >= 0; }
};

/// Returns the number of nodes; a wire has its two ends.
std::size_t node_count(const System& system, const FollowedLine& followed);
/// Returns the pull of a wire at the last evaluated state.
const WirePull& find_wire_pull(const Assembly& assembly, const FollowedLine& wire);
/// Returns the position of a node at the last evaluated state, W [m].
Vec3 node_place(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node);
/// Returns the effective tension there [N]; not negative where only tension elements meet.
double node_tension(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node);
/// Returns the bending moment there; 0 for a wire [N m].
double node_moment(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node);
/// Returns the component along the line of the force that holds an end [N], negative in compression, which a stiff line
/// can carry. Not the signed magnitude of the force: at a clamped end that carries a weight across the line, this would
/// jump in sign with every small compression.
double end_tension(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, LineEnd end);

}  // namespace overbend
