/// Constrained directions of a node's unknowns at a guide or an anchor.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {

/// Unit vectors in which a position or a tangent is constrained; at most three.
struct HeldVectors {
  std::array<Vec3, 3> direction = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  int count = 0;

  const Vec3* begin() const { return direction.data(); }
  const Vec3* end() const { return direction.data() + count; }
};

/// Constrained directions of a node.
struct HeldDirections {
  HeldVectors position, tangent;
};

/// Returns the constraint of all three directions.
HeldVectors all_directions();
/// Returns two unit vectors perpendicular to a direction and to each other.
HeldVectors across(const Vec3& direction);

/// Removes the constrained directions of `node` from the residual (six per node) and, unless null, from the blocks of
/// `tangent`: their increments become zero.
void hold_node(int node, const HeldDirections& held, std::vector<double>& residual, BlockTridiagonal* tangent);

}  // namespace overbend
