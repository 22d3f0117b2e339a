/// Mooring lines of a vessel: anchors, fairleads, lengths and forces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/mooring_description.h"
#include "model/site/seabed_surface.h"
#include "moorings/catenary.h"

namespace overbend {

/// Line between its fairlead and its anchor.
struct MooredLine {
  std::string name;
  Vec3 fairlead_V = Vec3::Zero();  ///< [m]
  Vec3 anchor_W = Vec3::Zero();    ///< On the seabed [m].
  CatenaryLine line;
  std::optional<double> breaking_load;  ///< Minimum over its segments [N].
  std::optional<double> holding;        ///< Holding capacity of its anchor [N].
  std::optional<double> drum;           ///< Length that fits on its winch drum [m].
  bool parted = false;
};

struct MooringSpread {
  std::vector<MooredLine> lines;
  SeabedSurface bed;
};

/// Error message that names the line; nullopt if there is no error.
using MooringError = std::optional<std::string>;

/// Pose of the hull: reference point midship at the water line, and axes.
struct HullPlace {
  Vec3 p_W = Vec3::Zero();  ///< [m]
  Mat3 R_WV = Mat3::Identity();
};

/// Lines, anchors and lengths as described, with the hull in its nominal pose at the origin with axes `drawn`
/// (vessel_axes). Where a tension is given, the length of the first segment follows from it in that pose.
struct SpreadOutcome {
  MooringSpread spread;
  MooringError error;
};
SpreadOutcome build_spread(const MooringsDescription& moorings, const SeabedSurface& bed, const Mat3& drawn);

/// Site of a line with its fairlead at a position [m].
CatenarySite line_site(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W);

/// Horizontal distance and direction from a fairlead to the anchor.
struct LineDirection {
  double distance = 0.0;             ///< [m]
  Vec3 direction_W = Vec3::UnitX();  ///< Horizontal unit vector.
};
LineDirection line_direction(const MooredLine& line, const Vec3& fairlead_W);

/// Force of a line on its fairlead.
struct LinePull {
  CatenarySolution solution;
  Vec3 force_W = Vec3::Zero();    ///< [N]
  Mat3 stiffness = Mat3::Zero();  ///< Minus d(force)/d(fairlead position), W [N/m].
};
/// `near`: solution of a neighbouring position, for a warm start.
LinePull line_pull(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W,
                   const CatenarySolution* near);

/// Force and moment of all lines about the hull's reference point, axes W, and their stiffness: minus d(force,
/// moment)/d(shift, rotation vector), not symmetric where the moment is not zero.
struct MooringWrench {
  Eigen::Matrix<double, 6, 1> load = Eigen::Matrix<double, 6, 1>::Zero();       ///< [N, N m]
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();  ///< [N/m, N, N m]
  MooringError error;
};
/// `lines`: solutions in the order of the spread, used as a warm start and updated.
MooringWrench mooring_wrench(const MooringSpread& spread, const HullPlace& hull, std::vector<CatenarySolution>& lines);

/// Message for the error of one line.
std::string line_error_message(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W,
                               CatenaryError error);

}  // namespace overbend
