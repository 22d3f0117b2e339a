#include "dynamics/dynamics.h"

namespace overbend {

DynamicOptions dynamic_options(const Model& model) {
  DynamicOptions options;
  const DynamicSettings settings = model.description.dynamics.value_or(DynamicSettings{});
  options.seed = settings.seeds.empty() ? model.description.environment.waves.seed : settings.seeds.front();
  options.duration = settings.duration;
  options.build_up = settings.build_up;
  options.output_step = settings.output_step;
  options.fixed_step = settings.step;
  options.max_step = settings.max_step.value_or(options.max_step);
  options.error_tolerance = settings.step_error;
  options.step.spectral_radius = settings.spectral_radius;
  options.step.tolerance = settings.tolerance;
  options.impacts.captured = settings.impacts == ImpactTreatment::captured;
  options.impacts.steps = settings.impact_steps;
  options.impacts.least_force = settings.impact_force;
  if (const auto& hull = model.description.vessel.coupled) {
    options.release << hull->released_shift, hull->released_turn;
  }
  return options;
}

}  // namespace overbend
