/// Places of nodes along a line whose elements are short in some stretches and grow away from them: the part that the
/// meshes of pipes and cables share.
#pragma once

#include <algorithm>
#include <vector>

namespace overbend {

/// Element length may grow by this per unit of distance from a fine stretch.
inline constexpr double kMeshGrowth = 0.25;

/// A stretch with a wanted element length, by distance from the line's end where the mesh begins [m].
struct FineStretch {
  double from, to, size;
};

/// Where nodes are wanted, in distances from the end where the mesh begins.
struct MeshPlan {
  std::vector<FineStretch> fine;
  std::vector<double> fixed;  ///< Rising; a node on each, the last is the line's other end.
  double longest = 0.0;       ///< Element [m].
};

/// Element length wanted at distance `u` [m].
double wanted_size(const MeshPlan& plan, double u);

/// Lengths of elements from `from` on until they reach `to`, each handed to `take`; false from it ends the walk.
template <class Take>
void walk(const MeshPlan& plan, double from, double to, Take take) {
  double at = from;
  while (at < to - 1e-9) {
    const double first = wanted_size(plan, at);
    const double step = std::min(first, wanted_size(plan, at + 0.5 * first));
    if (!take(step)) return;
    at += step;
  }
}

/// Distances of all nodes from the end where the mesh begins, 0 first: steps follow the wanted size and are stretched
/// to end on the fixed places.
std::vector<double> graded_nodes(const MeshPlan& plan);

}  // namespace overbend
