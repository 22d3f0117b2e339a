/// Which anchor has to be moved before which joint, while a vessel goes along its route.
#pragma once

#include "moorings/spread.h"

namespace overbend {

/// What is useful of a line, and the horizontal pull it is to have there.
struct UsefulLine {
  UsefulRange range;
  double pull = 0.0;  ///< [N]
};

/// A vessel that goes ahead joint by joint from where it is drawn, its heading kept.
struct AnchorRoute {
  Vec3 step_W = Vec3::Zero();  ///< Of one joint [m].
  int joints = 0;
};

/// An anchor that is moved with the vessel before a joint.
struct AnchorShift {
  int joint = 0;  ///< Counted from 1.
  std::size_t line = 0;
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  ///< [m]
  double length = 0.0;                              ///< Of the line at its new place, unstressed [m].
  const char* reason = "";                          ///< Bound of its useful range that it would pass.
};

/// Why a line is of no use with its anchor there and its fairlead at a place: one of its bounds in words; nullptr where
/// it is of use. `length` receives its unstressed length for the pull [m].
const char* useless(const MooringSpread& spread, const MooredLine& line, const UsefulLine& useful, double drawn_azimuth,
                    const Vec3& fairlead_W, double& length);

/// One anchor at a time, as late as its line's useful range and those of the others allow: of lines that would leave
/// their ranges together the first goes earlier. A new place is so far ahead along the route of the drawn one, in whole
/// joints, that the line has just come into its useful range. `useful`: in the order of the lines; a line without range
/// is never moved.
struct AnchorSchedule {
  std::vector<AnchorShift> shifts;
  MooringFault fault;
};
AnchorSchedule plan_anchors(const MooringSpread& spread, const Mat3& drawn, const std::vector<UsefulLine>& useful,
                            const AnchorRoute& route);

}  // namespace overbend
