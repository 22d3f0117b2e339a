/// Graded node positions along a line: short elements in some stretches that grow away from them; shared by the meshes
/// of pipes and cables.
#pragma once

#include <algorithm>
#include <vector>

namespace overbend {

/// Growth of the element length per unit of distance from a fine stretch.
inline constexpr double kMeshGrowth = 0.25;

/// A stretch with a maximum element length, by distance from the line end where the mesh begins [m].
struct FineStretch {
  double from, to, size;
};

/// Required element lengths and nodes, in distances from the end where the mesh begins.
struct MeshPlan {
  std::vector<FineStretch> fine;
  std::vector<double> fixed;  ///< Ascending; a node at each, the last is the line's other end.
  double max_length = 0.0;    ///< Maximum element length [m].
};

/// Returns the required element length at distance `u` [m].
double element_size_at(const MeshPlan& plan, double u);

/// Calls `take` with the lengths of elements from `from` until they reach `to`; stops if it returns false.
template <class Take>
void walk(const MeshPlan& plan, double from, double to, Take take) {
  double position = from;
  while (position < to - 1e-9) {
    const double first = element_size_at(plan, position);
    const double step = std::min(first, element_size_at(plan, position + 0.5 * first));
    if (!take(step)) return;
    position += step;
  }
}

/// Returns the distances of all nodes from the end where the mesh begins, 0 first: steps follow the required size and
/// are scaled to end at the fixed positions.
std::vector<double> graded_nodes(const MeshPlan& plan);

}  // namespace overbend
