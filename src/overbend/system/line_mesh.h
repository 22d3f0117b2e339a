/// Nodes along the line, from the anchor (s = 0) to the tensioner (s = total length).
#pragma once

#include <algorithm>
#include <vector>

#include "model/model.h"

namespace overbend {

/// A stretch of the line, by distance from the tensioner [m].
struct LineStretch {
  double from = 0.0, to = 0.0;
};

struct LineMesh {
  std::vector<double> s;       ///< Of the nodes [m].
  std::vector<double> length;  ///< Of the elements [m].
  std::vector<int> section;    ///< Of the elements.

  int nodes() const { return static_cast<int>(s.size()); }
  int elements() const { return static_cast<int>(length.size()); }
  double total_length() const { return s.back(); }
  /// Whether an element is there as a hinge alone: far shorter than those beside it.
  bool joint(std::size_t element) const {
    constexpr double kFar = 0.02;
    if (element == 0 || element + 1 >= length.size()) return false;
    return length[element] < kFar * std::min(length[element - 1], length[element + 1]);
  }
  /// Of the elements beside a node, joints apart [m].
  double shortest_beside(int node) const {
    const std::size_t i = static_cast<std::size_t>(node), last = length.size() - 1;
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i, last);
    if (joint(before)) return length[after];
    return joint(after) ? length[before] : std::min(length[before], length[after]);
  }
};

/// Lengths of the line that the mesh rule needs.
struct MeshZones {
  double total = 0.0;           ///< Tensioner to anchor [m].
  double last_support = 0.0;    ///< From the tensioner to the end of the supports [m]; 0 in J-lay.
  double touchdown = 0.0;       ///< From the tensioner [m].
  double waterline = 0.0;       ///< From the tensioner; negative when the pipe starts under water [m].
  double top_tension = 0.0;     ///< [N]
  double bottom_tension = 0.0;  ///< [N]
  /// Stretches of the laid line on a shaped bed that touchdown's element length serves too: where contact begins and
  /// ends, and crests.
  std::vector<LineStretch> bed_edges = {};
};

/// Element sizes the rule arrives at [m].
struct MeshSizes {
  double overbend = 0.0, touchdown = 0.0, longest = 0.0;
  double touchdown_before = 0.0,
         touchdown_after = 0.0;  ///< Extent of the fine zone, towards the tensioner and the anchor.
};

/// Length over which a line on the bed bends, (4 EI/k)^(1/4) [m] (Winkler 1867).
double soil_length(const Model& model, double EI);

/// The rule. Over the supports: a twenty-fifth of the bending length sqrt(EI/T) or four fifths of the closest distance
/// of two rows of rollers, whichever is less. Around touchdown: a twentieth of sqrt(EI/H) or an eighth of the soil
/// length (4 EI/k)^(1/4). Elsewhere growing by a quarter from element to element up to a quarter of sqrt(EI/H), or what
/// gives 300 elements in the suspended part where that is more. On a shaped bed the laid line has elements of at most a
/// quarter of the soil length, beside every edge of contact those of touchdown. Values of `analysis.mesh` take
/// precedence.
MeshSizes mesh_sizes(const Model& model, const MeshZones& zones);

/// Elements that a mesh may have. Memory and time grow with them: some gigabytes and minutes beyond.
inline constexpr long kMostElements = 50000;

/// Elements that build_mesh would make, counted without making them; stops at ten million.
long count_elements(const Model& model, const MeshZones& zones);

/// Fine over the supports, at the waterline, at the tensioner and around touchdown; nodes on section boundaries.
LineMesh build_mesh(const Model& model, const MeshZones& zones);

}  // namespace overbend
