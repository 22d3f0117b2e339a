/// Advances along a suspended line: closed forms for each stretch of constant weight (elastic catenary; Irvine, Cable
/// Structures, 1981, chapter 1); the weight changes where the line crosses the water surface.
#pragma once

#include "moorings/catenary_line.h"
#include "moorings/dual.h"

namespace overbend {

/// State at a point of a line in its vertical plane. The tension has the horizontal part `pull` and the vertical part
/// `sink`, that of the part on the anchor's side (positive downwards).
struct CatenaryState {
  Dual x;              ///< Horizontal distance from the fairlead towards the anchor [m].
  Dual z;              ///< Height over mean water level [m].
  Dual pull, sink;     ///< [N]
  bool above = false;  ///< Above the water surface.
};

/// Advances along `length` of constant weight [N/m] in one step, without regard to the bed or the water surface.
void advance_catenary(CatenaryState& state, const Dual& length, double weight, double EA);

/// Unstressed length at which a suspended line first reaches the level z + rise; 0 if it does not within `limit` [m].
double length_to_level(const CatenaryState& state, double rise, double weight, double EA, double limit);

/// Returns the next stretch of constant weight, at most `length` long; it ends at the water surface if that is crossed.
struct CatenaryStretch {
  Dual length;
  double weight = 0.0;      ///< [N/m]
  bool to_surface = false;  ///< It ends at the water surface.
};
CatenaryStretch next_stretch(const CatenaryState& state, const Dual& length, const CatenaryPiece& piece);

/// Buoyancy minus weight of a point, with the line at `z` and the bed below it at `bed` [N].
Dual pull_up(const CatenaryPoint& point, const Dual& z, const Dual& bed);

}  // namespace overbend
