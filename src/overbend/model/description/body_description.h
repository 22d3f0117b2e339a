/// Bodies other than the lay vessel to which lines are attached: a tug, a second vessel, a platform.
#pragma once

#include <string>

#include "base/vec.h"
#include "model/description/vessel_description.h"

namespace overbend {

/// Returns a hull with the main dimensions of a harbour tug.
inline VesselDescription tug_hull() {
  VesselDescription hull;
  hull.length = 30.0;
  hull.beam = 11.0;
  hull.depth = 5.0;
  hull.draught = 4.0;
  return hull;
}

struct BodyDescription {
  std::string name;
  Vec3 place = Vec3::Zero();            ///< Origin, midship on the water line, W [m].
  VesselDescription hull = tug_hull();  ///< Heading, heel, trim, dimensions and motion, as for the vessel.
};

}  // namespace overbend
