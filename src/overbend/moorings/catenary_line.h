/// Mooring line of a catenary: pieces of constant properties from the fairlead to the anchor, with weights and buoys
/// between them.
#pragma once

#include <vector>

#include "model/description/line_description.h"

namespace overbend {

struct CatenaryPiece {
  double length = 0.0;            ///< Unstressed [m].
  double weight_in_air = 0.0;     ///< [N/m]
  double weight_submerged = 0.0;  ///< Negative: buoyant [N/m].
  double EA = 0.0;                ///< [N]
  double friction = 0.0;          ///< Friction coefficient along the line on the bed [-].
};

/// Clump weight or buoy at the end of a piece. A buoy loses buoyancy where it pierces the water surface.
struct CatenaryPoint {
  std::size_t behind = 0;  ///< Index of the piece that ends here.
  double pull_up = 0.0;    ///< Buoyancy minus weight in water; negative for a clump weight [N].
  double buoyancy = 0.0;   ///< Part of `pull_up` that a buoy loses out of the water [N].
  double height = 0.0;     ///< Height of a cylindrical buoy, or diameter of a spherical one [m].
  double tether = 0.0;     ///< Height of a buoy's centre above the line, or of a clump weight below it [m].
  BuoyShape shape = BuoyShape::sphere;

  /// True for a clump weight below the line, which the bed carries where the line is lower than the tether length.
  bool is_suspended_below() const { return buoyancy <= 0.0 && tether > 0.0; }
};

struct CatenaryLine {
  std::vector<CatenaryPiece> pieces;  ///< From the fairlead.
  std::vector<CatenaryPoint> points;  ///< In the order of the pieces.
  double first_segment_rest = 0.0;    ///< Length of the first segment behind the first piece [m].

  /// Unstressed length of all pieces [m].
  double length() const;
  /// Unstressed length of the first segment, which a winch pays out and hauls in [m].
  double first_segment() const { return pieces.front().length + first_segment_rest; }
  /// Sets the length of the first segment [m]. The first piece takes the change, as buoys and weights move with the
  /// line.
  void set_first_segment(double segment) { pieces.front().length = segment - first_segment_rest; }
};

/// Returns pieces and points of the description; the first piece has length 0 where none is given (it then carries no
/// points). `bed_friction`: coefficient of types that give none [-]. `gravity`: turns the mass of buoys into weight
/// [m/s2].
CatenaryLine catenary_line(const std::vector<LineSegmentDescription>& segments,
                           const std::vector<LinePointDescription>& points, double bed_friction, double gravity);

}  // namespace overbend
