/// A line of the model where a system has it: made of elements, a wire between bodies, or a wire on a node of another.
#pragma once

#include <string>

#include "system/assembly.h"

namespace overbend {

struct FollowedLine {
  std::string name;
  int line = -1;          ///< Of the system: of elements, or, with a wire, that on whose node it is.
  int wire = -1;          ///< Of the system, or of that line.
  bool reversed = false;  ///< A wire's first end is the line's second.

  bool is_wire() const { return wire >= 0; }
};

/// Its nodes; a wire has its two ends.
std::size_t node_count(const System& system, const FollowedLine& followed);
/// Pull of a wire, at the state evaluated last.
const WirePull& pull_of(const Assembly& assembly, const FollowedLine& wire);
/// Place of a node at the state evaluated last, W [m].
Vec3 node_place(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node);
/// Effective tension there; where only elements that pull meet never below zero [N].
double node_tension(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node);
/// Bending moment there; of a wire none [N m].
double node_moment(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, std::size_t node);
/// The part along the line of the force that holds an end, negative where it pushes: a line that is stiff bears some
/// compression. Not the force's size with a sign: at a clamped end that bears a weight across the line, it would leap
/// from one side of zero to the other with every small push [N].
double end_tension(const Assembly& assembly, const SystemState& state, const FollowedLine& followed, LineEnd end);

}  // namespace overbend
