/// Elastic catenary of a mooring line between its fairlead and its anchor (Jonkman 2007, section 2.6.2, for one piece;
/// here for any pieces, weights and buoys, with bed, friction and the part out of the water).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "base/vec.h"
#include "moorings/catenary_trace.h"

namespace overbend {

enum class CatenaryFault { none, too_short, below_bed, no_shape };

/// A line at rest. Forces are those of the line on its ends, in its vertical plane.
struct CatenarySolution {
  CatenaryFault fault = CatenaryFault::none;
  bool slack = false;          ///< It lies so loosely that nothing pulls horizontally.
  double pull = 0.0;           ///< Horizontal force on the fairlead towards the anchor [N].
  double sink = 0.0;           ///< Vertical force on the fairlead, downwards [N].
  double anchor_pull = 0.0;    ///< Horizontal force on the anchor towards the fairlead [N].
  double anchor_uplift = 0.0;  ///< Vertical force on the anchor, upwards; 0 where the line lies before it [N].
  double anchor_rise = 0.0;  ///< Vertical part of the tension there, upwards, also of a line that lies on a slope [N].
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< d(pull, sink)/d(distance, height of the fairlead) [N/m].
  Eigen::Vector2d by_length = Eigen::Vector2d::Zero();  ///< d(pull, sink)/d(length of the first piece) [N/m].
  CatenaryTrace trace;

  double tension() const { return std::hypot(pull, sink); }                       ///< At the fairlead [N].
  double anchor_tension() const { return std::hypot(anchor_pull, anchor_rise); }  ///< Along the line [N].
};

/// The line with its anchor at a horizontal distance from the fairlead [m]. `near`: a solution of a case close by.
CatenarySolution solve_catenary(const CatenaryLine& line, const CatenarySite& site, double distance,
                                const CatenarySolution* near = nullptr);

/// Sets the first piece's length so that the horizontal pull at the fairlead is `pull` [N]; the solution, with its
/// fault where no length of at least 0 does it.
CatenarySolution set_length_for_pull(CatenaryLine& line, const CatenarySite& site, double distance, double pull);

/// The same for the tension at the fairlead [N].
CatenarySolution set_length_for_tension(CatenaryLine& line, const CatenarySite& site, double distance, double tension);

/// A line where it has come to from the fairlead, in its vertical plane.
struct CatenaryPlace {
  double x = 0.0, z = 0.0;            ///< From the fairlead towards the anchor, over mean water level [m].
  double along = 1.0, upwards = 0.0;  ///< Their derivatives by the unstressed length: direction times stretch [-].
  bool lies = false;                  ///< On the bed.
};

/// The line at an unstressed length from the fairlead [m]. What lies on the bed stretches by a tension that falls by
/// the bed's friction, until none is left.
CatenaryPlace catenary_place(const CatenaryLine& line, const CatenarySolution& solution, double length);

/// Points of the line in its plane, x from the fairlead and z, from the fairlead to the anchor. `count`: of hanging
/// spans each.
std::vector<Eigen::Vector2d> catenary_shape(const CatenaryLine& line, const CatenarySolution& solution, int count);

}  // namespace overbend
