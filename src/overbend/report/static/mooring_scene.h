/// What stands beside the mooring lines in a plan of them.
#pragma once

#include <optional>
#include <vector>

#include "model/description/description.h"
#include "results/static_results.h"

namespace overbend {

struct MooringScene {
  double length = 0.0, beam = 0.0;  ///< Of the hull; 0 where it is not known [m].
  double heading = 0.0;             ///< Of its bow as drawn, clockwise from north [rad].
  std::vector<SeabedObjectDescription> objects;
  std::vector<Vec3> pipe_W;          ///< From the tensioner to a little beyond touchdown [m].
  Vec3 touchdown_W = Vec3::Zero();   ///< Of the pipe, where there is one [m].
  std::optional<double> waves_from;  ///< Clockwise from north [rad].
  std::optional<double> current_to;  ///< At the surface, clockwise from north [rad].
  double water_depth = 0.0;          ///< [m]
};

/// `description` is not there where the model's text cannot be read: the lines are drawn alone then. With the laid pipe
/// of `results`, where there is one.
MooringScene mooring_scene(const std::optional<Description>& description, const StaticResults& results);

}  // namespace overbend
