/// Changes of a line's mesh during a run: splitting and merging elements, adding elements beyond an end, dropping
/// elements. All data by node or element follow, constants of `Line` and memories of `LineState`.
/// || Only between steps, at accepted states. Assembly and stepper of the system must be rebuilt afterwards, as their
/// sizes are those of the lines. These functions allocate.
#pragma once

#include <array>

#include "mechanics/element_constants.h"
#include "system/line.h"
#include "system/state.h"

namespace overbend {

/// The six unknowns of a node (position [m], tangent [-]; W) with their rates.
struct NodeMotion {
  std::array<double, 6> q{}, v{}, acc{}, algorithmic_acceleration{};
};

/// Returns the motion of a node.
NodeMotion node_motion(const LineState& state, int node);

/// Growth of the unstressed length of an element that is fed at its upper end: speed [m/s] and acceleration [m/s2] of
/// the machine.
struct LengthRate {
  double rate = 0.0, acceleration = 0.0;
};

/// Returns the motion of the material at `share` (0 to 1) of an element, on the element's cubic and the cubics of its
/// velocities and accelerations. If the element grows by `length_rate` at its upper end, the point stays with the
/// material: its rates include the motion of the shares through the element.
NodeMotion motion_within(const Line& line, const LineState& state, int element, double share,
                         const LengthRate& length_rate = {});

/// Inserts a node at `share` of an element. The shape and the velocity field, and so momentum and kinetic energy, are
/// preserved to rounding; strain energy to the element's own error. The stretch of the seabed friction is interpolated,
/// plastic memory is taken from the nearest point, contacts stay at their positions.
void split_element(Line& line, LineState& state, int element, double share, const LengthRate& length_rate = {});

/// Removes an inner node: its two elements become one, of the lower one's section, with their total length. For
/// elements of one kind where the line is nearly straight: the deviation of the node from the cubic through its
/// neighbours is lost. No clump or buoy may be there.
void merge_elements(Line& line, LineState& state, int node);

/// Section and constants of an element.
struct ElementKind {
  int section = 0;
  ElementConstants constants;
  const BendingLaw* law = nullptr;  ///< Null for linear steel.
};

/// Adds an unbent element of unstressed length `length` [m] beyond the last end, up to a new node, which the end's
/// attachment holds from then on.
void append_element(Line& line, LineState& state, const NodeMotion& node, double length, const ElementKind& kind);

/// Removes the element at an end with the end node. Its contacts are dropped.
void drop_element(Line& line, LineState& state, LineEnd end);

}  // namespace overbend
