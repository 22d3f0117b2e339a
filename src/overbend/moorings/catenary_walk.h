/// Walks along a hanging line: closed forms for each stretch of constant weight (elastic catenary; Irvine, Cable
/// Structures, 1981, chapter 1), with the weight changing where the line passes the water surface.
#pragma once

#include "moorings/catenary_line.h"
#include "moorings/dual.h"

namespace overbend {

/// A place on a line in its vertical plane. The tension there has the horizontal part `pull` and, of the part of the
/// line on the anchor's side, the vertical part `sink` (downwards positive).
struct CatenaryState {
  Dual x;              ///< Horizontal distance from the fairlead towards the anchor [m].
  Dual z;              ///< Height over mean water level [m].
  Dual pull, sink;     ///< [N]
  bool above = false;  ///< Out of the water.
};

/// Goes along `length` of constant weight [N/m] in one step, whatever is on the way.
void hang(CatenaryState& at, const Dual& length, double weight, double EA);

/// Unstressed length until a hanging line first comes to the level z + rise, 0 where it does not within `limit` [m].
double length_to_level(const CatenaryState& at, double rise, double weight, double EA, double limit);

/// The next stretch of at most `length` with one weight: to the water surface if that is passed. Returns its length.
struct CatenaryStretch {
  Dual length;
  double weight = 0.0;      ///< [N/m]
  bool to_surface = false;  ///< It ends at the water surface.
};
CatenaryStretch next_stretch(const CatenaryState& at, const Dual& length, const CatenaryPiece& piece);

/// Lift of a point less its weight, the line being at `z` and the bed under it at `bed` [N].
Dual pull_up(const CatenaryPoint& point, const Dual& z, const Dual& bed);

}  // namespace overbend
