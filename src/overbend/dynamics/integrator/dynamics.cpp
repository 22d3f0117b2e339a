#include "dynamics/integrator/dynamics.h"

#include "model/site/wave_groups.h"
#include "model/step_scales.h"

namespace overbend {
namespace {

constexpr double kShortElement = 5e3;  ///< Minimum element length over the error tolerance of a step: 5 m.

}  // namespace

DynamicOptions dynamic_options(const Model& model) {
  DynamicOptions options;
  const DynamicSettings settings = model.description.dynamics.value_or(DynamicSettings{});
  options.seed = settings.seeds.empty() ? default_seed(model.description.environment.waves) : settings.seeds.front();
  options.duration = settings.duration;
  options.build_up = settings.build_up;
  options.output_step = settings.output_step;
  options.fixed_step = settings.step;
  const StepScales scales = step_scales(model);
  options.time_scale = scales.time;
  options.max_step = settings.max_step.value_or(scales.time);
  options.error_tolerance = settings.step_error.value_or(scales.length);
  options.step.short_element = kShortElement * scales.length;
  options.step.spectral_radius = settings.spectral_radius;
  options.step.tolerance = settings.tolerance;
  options.impacts.captured = settings.impacts == ImpactTreatment::captured;
  options.impacts.steps = settings.impact_steps;
  options.impacts.min_force = settings.impact_force.value_or(scales.force);
  if (const auto& hull = model.description.vessel.coupled) {
    options.release << hull->release_offset, hull->release_rotation;
  }
  return options;
}

}  // namespace overbend
