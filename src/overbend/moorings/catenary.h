/// Elastic catenary of a mooring line between its fairlead and its anchor (Jonkman 2007, section 2.6.2, for one piece;
/// here for any pieces, weights and buoys, with bed, friction and the part out of the water).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "base/vec.h"
#include "moorings/catenary_geometry.h"

namespace overbend {

enum class CatenaryError { none, too_short, below_bed, no_shape };

/// Static solution of a line. Forces of the line on its ends, in its vertical plane.
struct CatenarySolution {
  CatenaryError error = CatenaryError::none;
  bool slack = false;          ///< The line is so slack that it has no horizontal tension.
  double pull = 0.0;           ///< Horizontal force on the fairlead towards the anchor [N].
  double sink = 0.0;           ///< Vertical force on the fairlead, downwards [N].
  double anchor_pull = 0.0;    ///< Horizontal force on the anchor towards the fairlead [N].
  double anchor_uplift = 0.0;  ///< Vertical force on the anchor, upwards; 0 where the line lies on the bed in front of
                               ///< it [N].
  double anchor_rise = 0.0;    ///< Vertical part of the tension at the anchor, upwards, also of a line that lies on a
                               ///< slope [N].
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< d(pull, sink)/d(distance, height of the fairlead) [N/m].
  Eigen::Vector2d by_length = Eigen::Vector2d::Zero();  ///< d(pull, sink)/d(length of the first piece) [N/m].
  CatenaryGeometry trace;

  double tension() const { return std::hypot(pull, sink); }                       ///< At the fairlead [N].
  double anchor_tension() const { return std::hypot(anchor_pull, anchor_rise); }  ///< Along the line [N].
};

/// Solves the line with its anchor at a horizontal distance from the fairlead [m]. `near`: solution of a neighbouring
/// case, for a warm start. Errors are returned in the solution.
CatenarySolution solve_catenary(const CatenaryLine& line, const CatenarySite& site, double distance,
                                const CatenarySolution* near = nullptr);

/// Sets the length of the first piece so that the horizontal force at the fairlead is `pull` [N]. Returns the solution,
/// with its error if no length >= 0 gives that force.
CatenarySolution set_length_for_pull(CatenaryLine& line, const CatenarySite& site, double distance, double pull);

/// Same for the tension at the fairlead [N].
CatenarySolution set_length_for_tension(CatenaryLine& line, const CatenarySite& site, double distance, double tension);

/// Point of a line in its vertical plane.
struct CatenaryPlace {
  double x = 0.0, z = 0.0;            ///< Distance from the fairlead towards the anchor, and height over mean water
                                      ///< level [m].
  double along = 1.0, upwards = 0.0;  ///< Their derivatives with respect to unstressed length: direction times stretch
                                      ///< [-].
  bool lies = false;                  ///< True if the point lies on the bed.
};

/// Returns the point at an unstressed length from the fairlead [m]. The tension of a part on the bed, and with it its
/// stretch, falls by bed friction until none is left.
CatenaryPlace catenary_place(const CatenaryLine& line, const CatenarySolution& solution, double length);

/// Returns points of the line in its plane (x from the fairlead, z) from the fairlead to the anchor. `count`: number of
/// points per suspended span.
std::vector<Eigen::Vector2d> catenary_shape(const CatenaryLine& line, const CatenarySolution& solution, int count);

}  // namespace overbend
