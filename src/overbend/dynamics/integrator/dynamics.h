/// What a dynamic analysis is asked for.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/integrator/impact_tracker.h"
#include "dynamics/integrator/time_step.h"
#include "dynamics/machines/controller.h"
#include "statics/solver/statics.h"

namespace overbend {

struct DynamicOptions {
  std::uint64_t seed = 1;
  double duration = 0.0, build_up = 60.0, output_step = 0.5;  ///< [s]
  std::optional<double> fixed_step;                           ///< [s]
  double max_step = 0.125;                                    ///< [s]
  double time_scale = 0.125;                                  ///< See kShortStep and kEventStep [s].
  double error_tolerance = 1e-3;  ///< Of a node's place in one step, where the step is free [m].
  /// From rest, where a free hull is let go: a decay. Along and about the axes of the hull as drawn [m, rad].
  Vec6 release = Vec6::Zero();
  std::vector<ControllerUse> controllers;  ///< That drive tensioner or mooring winches from outside.
  double tail_reach = 1.0;  ///< Laid pipe behind the static line over what friction needs, see with_laid_tail.
  StepSettings step;
  ImpactSettings impacts;
};

/// The options of a model's `analysis.dynamic`.
DynamicOptions dynamic_options(const Model& model);

}  // namespace overbend
