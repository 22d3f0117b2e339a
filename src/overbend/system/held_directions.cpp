#include "system/held_directions.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Removes the component along `d` from three consecutive rows of a block.
void project_rows(double* block, int first_row, const Vec3& d) {
  for (int c = 0; c < kRowWidth; ++c) {
    double part = 0.0;
    for (int r = 0; r < 3; ++r) {
      part += d(r) * block[(first_row + r) * kRowWidth + c];
    }
    for (int r = 0; r < 3; ++r) {
      block[(first_row + r) * kRowWidth + c] -= d(r) * part;
    }
  }
}

void project_columns(double* block, int first_column, const Vec3& d) {
  for (int r = 0; r < kNodeDofs; ++r) {
    double* row = block + r * kRowWidth + first_column;
    const double part = d(0) * row[0] + d(1) * row[1] + d(2) * row[2];
    for (int c = 0; c < 3; ++c) {
      row[c] -= d(c) * part;
    }
  }
}

double max_diagonal(const double* block) {
  double max_value = 0.0;
  for (int i = 0; i < kNodeDofs; ++i) {
    max_value = std::max(max_value, std::abs(block[i * kRowWidth + i]));
  }
  return max_value;
}

/// Blocks with the equations of a node; neighbours are null at the ends.
struct NodeBlocks {
  double *diag, *upper, *lower, *upper_before, *lower_before;
};

NodeBlocks make_node_blocks(BlockTridiagonal& k, int node) {
  const bool first = node == 0;
  const bool last = node == k.nodes() - 1;
  return {k.diag(node), last ? nullptr : k.upper(node), last ? nullptr : k.lower(node),
          first ? nullptr : k.upper(node - 1), first ? nullptr : k.lower(node - 1)};
}

void hold_direction(const NodeBlocks& blocks, int first_dof, const Vec3& d) {
  const double scale = max_diagonal(blocks.diag);
  project_rows(blocks.diag, first_dof, d);
  project_columns(blocks.diag, first_dof, d);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      blocks.diag[(first_dof + r) * kRowWidth + first_dof + c] += scale * d(r) * d(c);
    }
  }
  if (blocks.upper != nullptr) {
    project_rows(blocks.upper, first_dof, d);
    project_columns(blocks.lower, first_dof, d);
  }
  if (blocks.upper_before != nullptr) {
    project_columns(blocks.upper_before, first_dof, d);
    project_rows(blocks.lower_before, first_dof, d);
  }
}

void remove_component(double* v, const Vec3& d) {
  const double part = d(0) * v[0] + d(1) * v[1] + d(2) * v[2];
  for (int i = 0; i < 3; ++i) {
    v[i] -= d(i) * part;
  }
}

}  // namespace

HeldVectors all_directions() {
  return {{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, 3};
}

HeldVectors across(const Vec3& direction) {
  const Vec3 side = direction.unitOrthogonal();
  return {{side, direction.cross(side), Vec3::Zero()}, 2};
}

void hold_node(int node, const HeldDirections& held, std::vector<double>& residual, BlockTridiagonal* tangent) {
  const auto apply = [&](const HeldVectors& directions, int first_dof) {
    for (const Vec3& d : directions) {
      remove_component(residual.data() + 6 * node + first_dof, d);
      if (tangent != nullptr) {
        hold_direction(make_node_blocks(*tangent, node), first_dof, d);
      }
    }
  };
  apply(held.position, 0);
  apply(held.tangent, 3);
}

}  // namespace overbend
