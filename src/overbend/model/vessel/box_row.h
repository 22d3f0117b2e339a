/// Boxes told as a row: places on an arc of constant radius, frame S.
#pragma once

#include "model/description/stinger_description.h"

namespace overbend {

/// Where the underside of the pipe rests at a box, and the direction of the arc there.
struct BoxPlace {
  double x = 0.0, z = 0.0;  ///< Frame S: x astern, z up [m].
  double incline = 0.0;     ///< Positive when it dips astern [rad].
};

/// The place `distance` further astern along an arc [m] that bends down with `radius` [m]: the chord lies midway
/// between the tangents at its ends, and so does not lose digits where the radius is large.
BoxPlace along_arc(const BoxPlace& from, double radius, double distance);

/// Box number `index`, from 0, of a row.
BoxPlace box_of_row(const BoxRowDescription& row, double radius, int index);

}  // namespace overbend
