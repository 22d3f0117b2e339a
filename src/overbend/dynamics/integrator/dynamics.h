/// Options of a dynamic analysis.
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
  double time_scale = 0.125;                                  ///< Basis of kShortStep and kEventStep [s].
  double error_tolerance = 1e-3;  ///< Tolerance of nodal positions per step, with step size control [m].
  /// Initial offset from equilibrium at which a free hull is released, for decay tests: along and about the axes of the
  /// hull in its nominal pose [m, rad].
  Vec6 release = Vec6::Zero();
  std::vector<ControllerUse> controllers;  ///< External controllers of the tensioner or mooring winches.
  /// Factor on the friction anchorage length of laid pipe behind the static line, see with_laid_tail.
  double tail_reach = 1.0;
  StepSettings step;
  ImpactSettings impacts;
};

/// Returns the options of a model's `analysis.dynamic`.
DynamicOptions dynamic_options(const Model& model);

}  // namespace overbend
