/// Directions of a node's unknowns that a guide or an anchor holds.
#pragma once

#include <vector>

#include "base/vec.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {

/// Unit vectors in which position and tangent of a node are held.
struct HeldDirections {
  std::vector<Vec3> position, tangent;
};

/// Two unit vectors across a direction and each other.
std::vector<Vec3> across(const Vec3& direction);

/// Removes the held directions of `node` from the residual (six per node) and, where `tangent` is not null, from its
/// blocks: their increments come out as zero.
void hold_node(int node, const HeldDirections& held, std::vector<double>& residual, BlockTridiagonal* tangent);

}  // namespace overbend
