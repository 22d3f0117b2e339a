/// Rows of boxes: positions on an arc of constant radius, frame S.
#pragma once

#include "model/description/stinger_description.h"

namespace overbend {

/// Point of the underside of the pipe at a box, and direction of the arc there.
struct BoxPlace {
  double x = 0.0, z = 0.0;  ///< Frame S: x astern, z up [m].
  double incline = 0.0;     ///< Positive when it dips astern [rad].
};

/// Returns the point `distance` [m] further astern along an arc that bends down with `radius` [m]. The chord direction
/// is midway between the tangents at its ends, which avoids cancellation at large radii.
BoxPlace along_arc(const BoxPlace& from, double radius, double distance);

/// Returns box number `index`, from 0, of a row.
BoxPlace box_of_row(const BoxRowDescription& row, double radius, int index);

}  // namespace overbend
