/// A mooring line as a catenary sees it: pieces of constant properties from the fairlead to the anchor, with weights
/// and buoys between them.
#pragma once

#include <vector>

#include "model/description/line_description.h"

namespace overbend {

struct CatenaryPiece {
  double length = 0.0;            ///< Unstressed [m].
  double weight_in_air = 0.0;     ///< [N/m]
  double weight_submerged = 0.0;  ///< Below zero floats up [N/m].
  double EA = 0.0;                ///< [N]
  double friction = 0.0;          ///< On the bed, along the line [-].
};

/// A clump weight or a buoy at the end of a piece. A buoy loses buoyancy where it pierces the surface.
struct CatenaryPoint {
  std::size_t behind = 0;  ///< Index of the piece that ends here.
  double pull_up = 0.0;    ///< Buoyancy less weight under water; a clump's is negative [N].
  double buoyancy = 0.0;   ///< The part of it that a buoy loses out of the water [N].
  double height = 0.0;     ///< Of the buoy: that of the cylinder or the diameter of the sphere [m].
  double tether = 0.0;     ///< A buoy's middle is that much above the line, a clump that much under it [m].
  BuoyShape shape = BuoyShape::sphere;

  /// A clump under the line, which the bed carries where the line is lower than the tether is long.
  bool hangs_under() const { return buoyancy <= 0.0 && tether > 0.0; }
};

struct CatenaryLine {
  std::vector<CatenaryPiece> pieces;  ///< From the fairlead.
  std::vector<CatenaryPoint> points;  ///< In the order of the pieces.
  double first_segment_rest = 0.0;    ///< Of the first segment, what lies behind the first piece [m].

  /// Unstressed, all pieces [m].
  double length() const;
  /// Unstressed, of the first segment: what a winch pays out and hauls in [m].
  double first_segment() const { return pieces.front().length + first_segment_rest; }
  /// Sets it; buoys and weights ride with the line, so the first piece takes the change.
  void set_first_segment(double segment) { pieces.front().length = segment - first_segment_rest; }
};

/// Pieces and points of the description; the first piece has length 0 where it is not given (it carries
/// no points then). `bed_friction`: of types
/// that say nothing [-]. `gravity` turns the mass of buoys into weight [m/s2].
CatenaryLine catenary_line(const std::vector<LineSegmentDescription>& segments,
                           const std::vector<LinePointDescription>& points, double bed_friction, double gravity);

}  // namespace overbend
