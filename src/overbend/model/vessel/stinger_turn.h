/// Turning the sections of a stinger about their hinges. Frame S; angles are positive when the tip goes down.
#pragma once

#include <vector>

#include "model/vessel/supports.h"

namespace overbend {

/// Turns a direction of frame S about the axis Y, an astern one downwards by a positive angle [rad].
Vec3 turned_down(const Vec3& direction_S, double angle);

/// Angles at which the sections are set [rad]; 0 where the forces on a section decide or where none is said.
std::vector<double> set_angles(const SupportsDescription& supports);

/// The sections as drawn.
std::vector<StingerSection> drawn_sections(const SupportsDescription& supports);

/// Turns each section to its angle about its own hinge [rad], which goes with the section before it; boxes, rows and
/// rollers go with their section. Lengths along the pipe (SupportRow::from_top) stay as drawn.
void turn_stinger(Supports& supports, const std::vector<double>& angles);

/// Where a point that is fixed in the section and drawn at `drawn` lies now [m]; `y` to starboard.
Vec3 point_on_section(const StingerSectionDescription& described, const StingerSection& now, const StingerPoint& drawn,
                      double y = 0.0);

}  // namespace overbend
