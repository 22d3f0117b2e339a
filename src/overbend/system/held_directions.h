/// Directions of a node's unknowns that a guide or an anchor holds.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {

/// Unit vectors in which a position or a tangent is held; at most three.
struct HeldVectors {
  std::array<Vec3, 3> direction = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  int count = 0;

  const Vec3* begin() const { return direction.data(); }
  const Vec3* end() const { return direction.data() + count; }
};

struct HeldDirections {
  HeldVectors position, tangent;
};

/// Nothing moves.
HeldVectors all_directions();
/// Two unit vectors across a direction and each other.
HeldVectors across(const Vec3& direction);

/// Removes the held directions of `node` from the residual (six per node) and, where `tangent` is not null, from its
/// blocks: their increments come out as zero.
void hold_node(int node, const HeldDirections& held, std::vector<double>& residual, BlockTridiagonal* tangent);

}  // namespace overbend
