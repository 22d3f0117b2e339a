/// The mooring lines of a vessel in the world: anchors, fairleads, lengths; and what they pull with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/mooring_description.h"
#include "model/site/bed_surface.h"
#include "moorings/catenary.h"

namespace overbend {

/// One line between its fairlead and its anchor.
struct MooredLine {
  std::string name;
  Vec3 fairlead_V = Vec3::Zero();  ///< [m]
  Vec3 anchor_W = Vec3::Zero();    ///< On the bed [m].
  CatenaryLine line;
  std::optional<double> breaking_load;  ///< Least of its segments [N].
  std::optional<double> holding;        ///< Of its anchor [N].
  std::optional<double> drum;           ///< Length that its winch holds [m].
  bool parted = false;
};

struct MooringSpread {
  std::vector<MooredLine> lines;
  BedSurface bed;
};

/// Why there is no answer: one sentence that names the line.
using MooringFault = std::optional<std::string>;

/// Where the hull lies: its reference point midship on the water line, and its axes.
struct HullPlace {
  Vec3 p_W = Vec3::Zero();  ///< [m]
  Mat3 R_WV = Mat3::Identity();
};

/// Lines, anchors and lengths as described, with the hull as drawn at the origin with axes `drawn` (vessel_axes).
/// Lines with a tension get the length of their first segment from it, the hull lying as drawn.
struct SpreadOutcome {
  MooringSpread spread;
  MooringFault fault;
};
SpreadOutcome build_spread(const MooringsDescription& moorings, const BedSurface& bed, const Mat3& drawn);

/// The site of a line whose fairlead is at a place [m].
CatenarySite line_site(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W);

/// Horizontal distance and direction from a fairlead to the anchor.
struct LineDirection {
  double distance = 0.0;             ///< [m]
  Vec3 direction_W = Vec3::UnitX();  ///< Unit, horizontal.
};
LineDirection line_direction(const MooredLine& line, const Vec3& fairlead_W);

/// The force of a line on its fairlead.
struct LinePull {
  CatenarySolution solution;
  Vec3 force_W = Vec3::Zero();    ///< [N]
  Mat3 stiffness = Mat3::Zero();  ///< Minus d(force)/d(place of the fairlead), W [N/m].
};
/// `near`: the solution of a place close by, for speed.
LinePull line_pull(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W,
                   const CatenarySolution* near);

/// Force and moment of all lines about the hull's reference point, axes W, and what they become less by when the hull
/// moves: minus d(force, moment)/d(shift, rotation vector), not symmetric where the moment is not zero.
struct MooringWrench {
  Eigen::Matrix<double, 6, 1> load = Eigen::Matrix<double, 6, 1>::Zero();       ///< [N, N m]
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();  ///< [N/m, N, N m]
  MooringFault fault;
};
/// `lines`: solutions in the order of the spread, used as start and renewed.
MooringWrench mooring_wrench(const MooringSpread& spread, const HullPlace& hull, std::vector<CatenarySolution>& lines);

/// The sentence for a fault of one line.
std::string line_fault(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W,
                       CatenaryFault fault);

}  // namespace overbend
