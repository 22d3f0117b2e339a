/// Nodes put into a line and taken out of it in mid-run: splitting and merging elements, new ones beyond an end, old
/// ones dropped. Whatever a line holds by node or by element follows here, constants of `Line` and memories of
/// `LineState` alike.
///
/// Between steps alone, at committed states. An assembly and a stepper of the system have to be made anew afterwards:
/// their sizes are those of the lines. These functions allocate.
#pragma once

#include <array>

#include "mechanics/element_constants.h"
#include "system/line.h"
#include "system/state.h"

namespace overbend {

/// The six unknowns of a node (place [m], tangent [-]; W) with their rates.
struct NodeMotion {
  std::array<double, 6> q{}, v{}, acc{}, alg{};
};

NodeMotion node_motion(const LineState& state, int node);

/// How the unstressed length of an element grows where it is fed at its upper end: the machine's speed [m/s] and
/// acceleration [m/s2].
struct LengthRate {
  double rate = 0.0, acceleration = 0.0;
};

/// Motion of the material at `share` (0 to 1) of an element, on the element's own cubic, and on the cubics of its
/// velocities and accelerations. Where the element grows by `length_rate` at its upper end, the point that stays with
/// the material: its rates have in them that shares of the length move through the element.
NodeMotion motion_within(const Line& line, const LineState& state, int element, double share,
                         const LengthRate& length_rate = {});

/// Puts a node at `share` of an element. The shape, the field of velocities and so momentum and kinetic energy stay as
/// they are to rounding; strain energy to the element's own error. The bed's stretch is interpolated, steel that has
/// yielded keeps the memory of its nearest point, contacts stay at their places.
void split_element(Line& line, LineState& state, int element, double share, const LengthRate& length_rate = {});

/// Takes out an inner node: the two elements beside it become one, of the lower one's section, with both their lengths.
/// For elements of one kind, where the line is all but straight: what the node stood apart from the cubic through its
/// neighbours is lost. No clump or buoy may be there.
void merge_elements(Line& line, LineState& state, int node);

/// What an element is made of.
struct ElementKind {
  int section = 0;
  ElementConstants constants;
  const BendingLaw* law = nullptr;  ///< Null for linear steel.
};

/// Puts an unbent element of unstressed length `length` [m] beyond the last end, up to a new node. The end's attachment
/// holds the new node from then on.
void append_element(Line& line, LineState& state, const NodeMotion& node, double length, const ElementKind& kind);

/// Takes out the element at an end with the node that was the end. Contacts that it had are forgotten.
void drop_element(Line& line, LineState& state, LineEnd end);

}  // namespace overbend
