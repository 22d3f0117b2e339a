/// Nodes along a line, from the anchor (s = 0) to the tensioner (s = total length).
#pragma once

#include <algorithm>
#include <vector>

#include "model/model.h"

namespace overbend {

/// A stretch of the line, by distance from the tensioner [m].
struct LineStretch {
  double from = 0.0, to = 0.0;
};

/// Mesh of a line.
struct LineMesh {
  std::vector<double> s;       ///< Arc lengths of the nodes [m].
  std::vector<double> length;  ///< Unstressed lengths of the elements [m].
  std::vector<int> section;    ///< Sections of the elements.

  int nodes() const { return static_cast<int>(s.size()); }
  int elements() const { return static_cast<int>(length.size()); }
  double total_length() const { return s.back(); }
  /// True if an element only serves as a hinge: far shorter than its neighbours.
  bool joint(std::size_t element) const {
    constexpr double kFar = 0.02;
    if (element == 0 || element + 1 >= length.size()) return false;
    return length[element] < kFar * std::min(length[element - 1], length[element + 1]);
  }
  /// Minimum length of the elements next to a node, except joints [m].
  double min_neighbour_length(int node) const {
    const std::size_t i = static_cast<std::size_t>(node), last = length.size() - 1;
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i, last);
    if (joint(before)) return length[after];
    return joint(after) ? length[before] : std::min(length[before], length[after]);
  }
};

/// Input lengths of the mesh rule.
struct MeshZones {
  double total = 0.0;           ///< Tensioner to anchor [m].
  double last_support = 0.0;    ///< From the tensioner to the end of the supports [m]; 0 in J-lay.
  double touchdown = 0.0;       ///< From the tensioner [m].
  double waterline = 0.0;       ///< From the tensioner; negative when the pipe starts under water [m].
  double top_tension = 0.0;     ///< [N]
  double bottom_tension = 0.0;  ///< [N]
  /// Stretches of the laid line on a shaped seabed with the element length of the touchdown: where contact begins and
  /// ends, and crests.
  std::vector<LineStretch> bed_edges = {};
};

/// Element sizes from the mesh rule [m].
struct MeshSizes {
  double overbend = 0.0, touchdown = 0.0, max_length = 0.0;
  double touchdown_before = 0.0,
         touchdown_after = 0.0;  ///< Extent of the fine zone, towards the tensioner and the anchor.
};

/// Returns the bending length of a line on the seabed, (4 EI/k)^(1/4) [m] (Winkler 1867).
double soil_length(const Model& model, double EI);

/// Applies the mesh rule. Over the supports: a twenty-fifth of the bending length sqrt(EI/T) or four fifths of the
/// minimum distance of two rows of rollers, whichever is less. Around touchdown: a twentieth of sqrt(EI/H) or an eighth
/// of the soil length (4 EI/k)^(1/4). Elsewhere growing by a quarter from element to element up to a quarter of
/// sqrt(EI/H), or up to a length that gives 300 elements in the suspended part if that is more. On a shaped seabed the
/// laid line has elements of at most a quarter of the soil length, and those of touchdown near every edge of contact.
/// Values of `analysis.mesh` take precedence.
MeshSizes mesh_sizes(const Model& model, const MeshZones& zones);

/// Maximum number of elements of a mesh. Beyond it memory and time reach gigabytes and minutes.
inline constexpr long kMaxElements = 50000;

/// Returns the number of elements that build_mesh would make, without making them; stops at ten million.
long count_elements(const Model& model, const MeshZones& zones);

/// Returns a mesh that is fine over the supports, at the waterline, at the tensioner and around touchdown, with nodes
/// on section boundaries.
LineMesh build_mesh(const Model& model, const MeshZones& zones);

}  // namespace overbend
