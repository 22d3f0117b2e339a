/// Surroundings of the mooring lines in a plan.
#pragma once

#include <optional>
#include <vector>

#include "model/description/description.h"
#include "results/static_results.h"

namespace overbend {

struct MooringScene {
  double length = 0.0, beam = 0.0;  ///< Dimensions of the hull; 0 if unknown [m].
  double heading = 0.0;             ///< Nominal azimuth of its bow, clockwise from north [rad].
  std::vector<SeabedObjectDescription> objects;
  std::vector<Vec3> pipe_W;          ///< From the tensioner to shortly behind touchdown [m].
  Vec3 touchdown_W = Vec3::Zero();   ///< Touchdown of the pipe, if there is one [m].
  std::vector<double> waves_from;    ///< Azimuth of each group of waves, clockwise from north [rad].
  std::optional<double> current_to;  ///< At the surface, clockwise from north [rad].
  double water_depth = 0.0;          ///< [m]
};

/// Returns the surroundings, with the laid pipe of `results` if there is one. `description` is missing if the model's
/// text cannot be read: only the lines are drawn then.
MooringScene mooring_scene(const std::optional<Description>& description, const StaticResults& results);

}  // namespace overbend
