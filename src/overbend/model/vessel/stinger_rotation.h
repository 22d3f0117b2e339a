/// Rotation of stinger sections about their hinges. Frame S; angles are positive when the tip goes down.
#pragma once

#include <vector>

#include "model/vessel/supports.h"

namespace overbend {

/// Rotates a direction of frame S about the Y axis; a positive angle [rad] turns an astern direction downwards.
Vec3 rotated_down(const Vec3& direction_S, double angle);

/// Returns the prescribed section angles [rad]; 0 where the forces determine the angle or none is given.
std::vector<double> prescribed_angles(const SupportsDescription& supports);

/// Returns the sections as drawn.
std::vector<StingerSection> drawn_sections(const SupportsDescription& supports);

/// Rotates each section to its angle about its own hinge [rad], which moves with the section before it; boxes, rows and
/// rollers move with their section. Lengths along the pipe (SupportRow::from_top) stay as drawn.
void rotate_stinger(Supports& supports, const std::vector<double>& angles);

/// Returns the current position of a point fixed in the section and drawn at `drawn` [m]; `y` to starboard.
Vec3 point_on_section(const StingerSectionDescription& described, const StingerSection& section,
                      const StingerPoint& drawn, double y = 0.0);

}  // namespace overbend
