/// Schedule of anchor moves while a vessel advances along its route: anchor and joint of each move.
#pragma once

#include "moorings/mooring_spread.h"

namespace overbend {

/// Useful range of a line and the horizontal force wanted at its fairlead.
struct LineUsefulRange {
  UsefulRange range;
  double pull = 0.0;  ///< [N]
};

/// Vessel that advances joint by joint from its nominal position at constant heading.
struct AnchorRoute {
  Vec3 step_W = Vec3::Zero();  ///< Displacement per joint [m].
  int joints = 0;
};

/// Anchor moved by the vessel before a joint.
struct AnchorMove {
  int joint = 0;  ///< Counted from 1.
  std::size_t line = 0;
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  ///< [m]
  double length = 0.0;                              ///< Unstressed length of the line with its anchor at the new
                                                    ///< position [m].
  const char* reason = "";                          ///< Bound of the useful range that the line would exceed.
};

/// Returns the bound that a line exceeds with its anchor at its position and its fairlead at `fairlead_W`, as a label;
/// nullptr if the line is within its useful range. `drawn_azimuth`: nominal azimuth of the line [rad]. `length`
/// receives the unstressed length for the wanted force [m].
const char* find_exceeded_bound(const MooringSpread& spread, const MooredLine& line, const LineUsefulRange& useful,
                                double drawn_azimuth, const Vec3& fairlead_W, double& length);

/// Moves one anchor at a time, as late as the useful range of its line and those of the other lines allow; where
/// several lines would leave their ranges together, the first is moved earlier. A new position lies a whole number of
/// joints ahead of the nominal one along the route, so that the line has just entered its useful range. `useful`: in
/// the order of the lines; a line without a range is never moved.
struct AnchorSchedule {
  std::vector<AnchorMove> shifts;
  MooringError error;
};
AnchorSchedule plan_anchors(const MooringSpread& spread, const Mat3& drawn, const std::vector<LineUsefulRange>& useful,
                            const AnchorRoute& route);

}  // namespace overbend
